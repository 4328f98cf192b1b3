//! The exact polygons that cells have claimed, found by their places.

use crate::masonry::footprint::{Footprint, shared_box};
use glam::DVec2;
use smallvec::SmallVec;

/// The default cell size of the hash grid (metres).
const CELL: f64 = 0.25;

/// Indices in the list of all claims. A list of those beside a brick needs no allocation.
pub type ClaimNumbers = SmallVec<[u32; 32]>;

/// A polygon that a cell has claimed.
#[derive(Clone, Debug, PartialEq)]
pub struct Claim {
    /// The space in the face's (s, t).
    pub polygon: Footprint,
    /// The number of the cell.
    pub cell: u32,
}

/// All claims on a face.
#[derive(Clone, Debug)]
pub struct Claims {
    list: Vec<Claim>,
    /// The bounding boxes of the claims in `list`.
    boxes: Vec<[DVec2; 2]>,
    low: DVec2,
    /// The side of a cell of the grid (metres).
    cell: f64,
    columns: usize,
    /// The numbers of the claims whose bounding boxes meet each cell of the grid. Cells at the border also have all
    /// that lies beyond.
    grid: Vec<Vec<u32>>,
}

impl Claims {
    /// No claims yet, on a face with this bounding box.
    pub fn new(bounds: [DVec2; 2]) -> Self {
        Self::with_cell(bounds, CELL)
    }

    /// As [`Self::new`], with `cell` as the side of the grid's cells (metres, above 0).
    pub(super) fn with_cell([low, high]: [DVec2; 2], cell: f64) -> Self {
        let size = ((high - low) / cell).ceil().max(DVec2::ONE);
        Self {
            list: Vec::new(),
            boxes: Vec::new(),
            low,
            cell,
            columns: size.x as usize,
            grid: vec![Vec::new(); size.x as usize * size.y as usize],
        }
    }

    /// All claims, in the order in which they were made.
    pub fn list(&self) -> &[Claim] {
        &self.list
    }

    /// Adds a claim.
    pub fn add(&mut self, claim: Claim) {
        let number = self.list.len() as u32;
        let around = claim.polygon.bounds();
        for bucket in self.buckets(around) {
            self.grid[bucket].push(number);
        }
        self.boxes.push(around);
        self.list.push(claim);
    }

    fn buckets(&self, [low, high]: [DVec2; 2]) -> impl Iterator<Item = usize> + use<> {
        let last = DVec2::new(self.columns as f64, (self.grid.len() / self.columns) as f64) - 1.0;
        let at = |p: DVec2| {
            ((p - self.low) / self.cell)
                .floor()
                .clamp(DVec2::ZERO, last)
        };
        let (from, to, columns) = (at(low), at(high), self.columns);
        let rows = from.y as usize..=to.y as usize;
        rows.flat_map(move |row| (from.x as usize..=to.x as usize).map(move |c| row * columns + c))
    }

    /// The numbers of the claims whose bounding boxes meet this box, rising.
    pub fn near(&self, [low, high]: [DVec2; 2]) -> ClaimNumbers {
        let mut found = ClaimNumbers::new();
        for bucket in self.buckets([low, high]) {
            let there = self.grid[bucket].iter().copied();
            found.extend(there.filter(|&k| {
                let [from, to] = self.boxes[k as usize];
                !(from.cmpgt(high).any() || to.cmplt(low).any())
            }));
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    /// The polygons of the claims whose bounding boxes share an area with that of another polygon.
    pub fn polygons_near(&self, polygon: &Footprint) -> impl Iterator<Item = &Footprint> {
        let around = polygon.bounds();
        let near = self.near(around).into_iter().map(|k| k as usize);
        let shares = near.filter(move |&k| shared_box(self.boxes[k], around).is_some());
        shares.map(|k| &self.list[k].polygon)
    }

    /// The area that a polygon shares with claims, summed over the claims (square metres). Claims of the cell `except`
    /// do not count.
    pub fn shared_area(&self, polygon: &Footprint, except: Option<u32>) -> f64 {
        let near = self
            .near(polygon.bounds())
            .into_iter()
            .map(|k| &self.list[k as usize]);
        let others = near.filter(|claim| Some(claim.cell) != except);
        others.map(|claim| claim.polygon.shared_area(polygon)).sum()
    }

    /// The area that two claims of different cells share, summed over all pairs (square metres).
    pub fn overlap(&self) -> f64 {
        let pairs = (0u32..).zip(&self.list).map(|(k, claim)| {
            let before = self
                .near(claim.polygon.bounds())
                .into_iter()
                .take_while(|&j| j < k);
            let others = before
                .map(|j| &self.list[j as usize])
                .filter(|other| other.cell != claim.cell);
            others
                .map(|other| other.polygon.shared_area(&claim.polygon))
                .sum::<f64>()
        });
        pairs.sum()
    }
}
