//! Measures of the cells.

use super::Laying;
use super::cell::{CellSort, Feature, MasonryCell};
use crate::building::{Bend, EdgeId, FaceId};
use crate::masonry::plan::is_wall;
use glam::{DVec2, DVec3};

/// The cell size of the hash grid that finds overlaps (metres).
const CELL: f64 = 0.5;
/// Head joints of neighbouring rows nearer than this are one straight joint (metres).
const STRAIGHT: f64 = 5e-3;

/// How good the cells of a building are. Shares are from 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measures {
    /// The number of cells.
    pub cells: usize,
    /// The number of edges at which bricks do not alternate.
    pub conflicts: usize,
    /// The share of the textured faces' area under no claim.
    pub gap: f64,
    /// The share of the textured faces' area under two claims.
    pub overlap: f64,
    /// The volume that pairs of cells share, over the volume of all cells.
    pub shared_volume: f64,
    /// The share of cells that are whole bricks.
    pub whole: f64,
    /// The share of cells that are half bricks.
    pub half: f64,
    /// The share of cells that are cut, but not along slopes.
    pub cut: f64,
    /// The share of bricks of special shapes: those at the borders of panels, and diagonal ones.
    pub special: f64,
    /// The share of cells that are cut along slopes.
    pub raked: f64,
    /// The share of head joints on faces that meet one of the next row.
    pub straight: f64,
    /// The share of bed joints beside convex upright edges that go on around the edge within 5 mm.
    pub course: f64,
}

impl Measures {
    /// Measures what is laid so far.
    pub fn new(laying: &Laying) -> Self {
        let cells = laying.cells();
        let of = |sort: CellSort| {
            let count = cells.iter().filter(|cell| cell.sort == sort).count();
            count as f64 / cells.len().max(1) as f64
        };
        let maps: Vec<_> = laying
            .textured_faces()
            .map(|face| laying.face_map(face))
            .collect();
        let area: f64 = maps.iter().map(|map| map.area()).sum();
        let area = if area > 0.0 { area } else { 1.0 };
        Self {
            cells: cells.len(),
            conflicts: laying.plan().conflicts.len(),
            gap: maps.iter().map(|map| map.gap()).sum::<f64>() / area,
            overlap: maps.iter().map(|map| map.overlap()).sum::<f64>() / area,
            shared_volume: shared_volume(cells),
            whole: of(CellSort::Whole),
            half: of(CellSort::Half),
            cut: of(CellSort::Cut),
            special: of(CellSort::Special),
            raked: of(CellSort::Raked),
            straight: straight(laying),
            course: course(laying),
        }
    }
}

/// The pairs of cells whose bounding boxes meet, found by a hash grid.
pub(super) fn pairs(cells: &[MasonryCell]) -> Vec<[u32; 2]> {
    let mut grid: std::collections::BTreeMap<[i32; 3], Vec<u32>> =
        std::collections::BTreeMap::new();
    let key = |p: DVec3| (p / CELL).floor().to_array().map(|v| v as i32);
    let mut found = Vec::new();
    let bounds: Vec<[DVec3; 2]> = cells.iter().map(|cell| cell.claimed.bounds()).collect();
    for (k, &[low, high]) in (0u32..).zip(&bounds) {
        let ([x, y, z], [to_x, to_y, to_z]) = (key(low), key(high));
        for place in (x..=to_x)
            .flat_map(|x| (y..=to_y).flat_map(move |y| (z..=to_z).map(move |z| [x, y, z])))
        {
            let bucket = grid.entry(place).or_default();
            let near = bucket.iter().filter(|&&j| {
                let [from, to] = bounds[j as usize];
                low.cmplt(to).all() && from.cmplt(high).all()
            });
            found.extend(near.map(|&j| [j, k]));
            bucket.push(k);
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}

fn shared_volume(cells: &[MasonryCell]) -> f64 {
    let whole: f64 = cells.iter().map(|cell| cell.claimed.volume()).sum();
    let shared = pairs(cells).into_iter().map(|pair| {
        let [a, b] = pair.map(|k| &cells[k as usize].claimed);
        a.shared_volume(b)
    });
    let shared: f64 = shared.sum();
    if whole > 0.0 { shared / whole } else { 0.0 }
}

/// The share of head joints between cells of a face that go on in the next row: four cells meet at their upper end. Ends of
/// rows are no joints.
fn straight(laying: &Laying) -> f64 {
    let (mut all, mut straight) = (0usize, 0usize);
    for face in laying.textured_faces() {
        let is_own = |cell: u32| {
            let cell = laying.cells().get(cell as usize);
            cell.is_some_and(|cell| cell.feature == Feature::Face(face))
        };
        let claims = laying.face_map(face).claims().list().iter();
        let own = claims.filter(|c| is_own(c.cell) && c.polygon.corners().len() == 4);
        let bounds: Vec<[DVec2; 2]> = own.map(|claim| claim.polygon.bounds()).collect();
        let upper_left = Places::new(bounds.iter().map(|b| DVec2::new(b[0].x, b[1].y)));
        let lower_left = Places::new(bounds.iter().map(|b| b[0]));
        let lower_right = Places::new(bounds.iter().map(|b| DVec2::new(b[1].x, b[0].y)));
        for upper_right in bounds.iter().map(|b| b[1]) {
            if upper_left.has(upper_right) {
                all += 1;
                let goes_on = lower_left.has(upper_right) && lower_right.has(upper_right);
                straight += usize::from(goes_on);
            }
        }
    }
    straight as f64 / all.max(1) as f64
}

/// Places on a face, sorted by their height.
struct Places(Vec<DVec2>);

impl Places {
    fn new(places: impl Iterator<Item = DVec2>) -> Self {
        let mut places: Vec<DVec2> = places.collect();
        places.sort_by(|a, b| a.y.total_cmp(&b.y));
        Self(places)
    }

    /// Whether one of the places is within [`STRAIGHT`] of this one, along both axes.
    fn has(&self, place: DVec2) -> bool {
        let from = self.0.partition_point(|p| p.y < place.y - STRAIGHT);
        let row = self.0[from..]
            .iter()
            .take_while(|p| p.y < place.y + STRAIGHT);
        row.into_iter().any(|p| (p.x - place.x).abs() < STRAIGHT)
    }
}

/// How far from an edge bed joints are looked for (metres).
const BESIDE: f64 = 0.03;

/// The share of bed joints beside convex upright edges between walls that have a joint at the same height on the other
/// wall.
fn course(laying: &Laying) -> f64 {
    let (mut all, mut same) = (0usize, 0usize);
    let building = laying.building();
    for id in building.edge_ids() {
        let edge = building.edge(id);
        let [Some(a), Some(b)] = edge.faces else {
            continue;
        };
        let are_walls = [a, b].iter().all(|&face| is_wall(building.face(face)));
        if !(edge.is_vertical() && edge.bend == Bend::Convex && are_walls) {
            continue;
        }
        let [left, right] = [a, b].map(|face| bed_joints(laying, id, face));
        let near = |y: &&f64| right.iter().any(|other| (*y - other).abs() < STRAIGHT);
        all += left.len();
        same += left.iter().filter(near).count();
    }
    if all == 0 {
        1.0
    } else {
        same as f64 / all as f64
    }
}

/// The heights of bed joints on a face beside an edge.
fn bed_joints(laying: &Laying, id: EdgeId, face: FaceId) -> Vec<f64> {
    let building = laying.building();
    let edge = building.edge(id);
    let frame = building.edge_frame(id, 0.5 * edge.length());
    let Some(inward) = edge.side(face).and_then(|side| frame.inward[side]) else {
        return Vec::new();
    };
    let surface = &building.face(face).surface;
    let [low, high] = [0.0, edge.length()].map(|at| edge.path.point(at).y);
    let (low, high) = (low.min(high), low.max(high));
    let s = surface.project(frame.origin + inward * BESIDE).x;
    let claims = laying.face_map(face).claims().list().iter();
    let beside = claims.filter(|claim| {
        let [from, to] = claim.polygon.bounds();
        (from.x..to.x).contains(&s)
    });
    let tops = beside.map(|claim| surface.map(s, claim.polygon.bounds()[1].y, 0.0).origin.y);
    tops.filter(|y| (low + STRAIGHT..high - STRAIGHT).contains(y))
        .collect()
}
