//! Fills the inside with a front of cells that grows.

use super::cell_fields::CellFields;
use super::packing_domain::{HashOf, MetricSpace, PackingDomain};
use super::placed::{FRONT_GAP, Placed};
use super::shape::CellShape;
use crate::field::CellKind;
use crate::random::{Purpose, Random};
use glam::DVec2;
use std::collections::VecDeque;

/// If the front has died out, a new one starts at a place whose nearest cell is at least this far, in stable distances.
const SEED_GAP: f64 = 0.9;

/// If paths are expensive, a place is rejected before its path is traced if a cell is nearer to it than this, in stable
/// distances.
const TAKEN: f64 = 0.4;

/// A front that grows from the boundary cells along the direction field, first come first served.
pub(crate) struct Front {
    queue: VecDeque<usize>,
    /// Cells that start growing when the front has died out for the first time.
    rows: VecDeque<usize>,
    /// The row direction of each honeycomb, by the honeycomb's number.
    honeycombs: Vec<DVec2>,
    random: Random,
    /// Remaining random tries for places that the front could not reach.
    tries: u32,
}

impl Front {
    pub fn new<G: PackingDomain>(
        placed: &mut Placed<G::Place, HashOf<G>>,
        ground: G,
        seed: u64,
    ) -> Self {
        if ground.has_parts() {
            // Random places would seldom hit a small part.
            placed.fill_empty_parts(ground);
        }
        let mut queue: VecDeque<usize> = (0..placed.cells.len()).collect();
        let mut rows = VecDeque::new();
        // Circles have no direction of their own. One honeycomb from the centre outwards has fewer faults than rows
        // along the boundary that meet each other. Each island has its own honeycomb.
        let honeycombs = ground.honeycombs();
        let first = placed.cells.len();
        for p in ground.seeds() {
            if ground.fields().kind(p) == CellKind::Circle && placed.is_free(ground, p, FRONT_GAP) {
                placed.push(ground.fields(), p);
            }
        }
        if placed.cells.len() > first {
            std::mem::swap(&mut rows, &mut queue);
            queue.extend(first..placed.cells.len());
        }
        let size = ground.fields().mean_size();
        Self {
            queue,
            rows,
            honeycombs,
            random: Random::new(seed, Purpose::Placement, 0),
            tries: 40 + (4.0 * ground.metric().area() / (size * size)) as u32,
        }
    }

    /// Grows around the next cell, or looks for a new place to start from; true when finished.
    pub fn grow<G: PackingDomain>(
        &mut self,
        placed: &mut Placed<G::Place, HashOf<G>>,
        ground: G,
    ) -> bool {
        if self.queue.is_empty() {
            std::mem::swap(&mut self.rows, &mut self.queue);
        }
        match self.queue.pop_front() {
            Some(k) => self.grow_around(k, placed, ground),
            None if self.tries == 0 => return true,
            None => self.try_anywhere(placed, ground),
        }
        false
    }

    fn grow_around<G: PackingDomain>(
        &mut self,
        k: usize,
        placed: &mut Placed<G::Place, HashOf<G>>,
        ground: G,
    ) {
        let centre = placed.cells[k];
        let mut shape = CellShape::at(ground.fields(), centre);
        if shape.kind() == CellKind::Circle
            && let Some(own) = ground.honeycomb(centre)
        {
            shape.turn(self.honeycombs[own]);
        }
        let beside = match G::Metric::WALKS {
            true => placed.beside(ground, centre, &shape, 1.0 + TAKEN),
            false => Vec::new(),
        };
        for p in slots(centre, shape, ground, |to| !is_taken(&shape, to, &beside)) {
            let p = ground.metric().wrap(p);
            if placed.is_free(ground, p, FRONT_GAP)
                && ground.has_room(p)
                && !ground.metric().is_gap_between(centre, p)
            {
                self.queue.push_back(placed.cells.len());
                placed.push(ground.fields(), p);
            }
        }
    }

    fn try_anywhere<G: PackingDomain>(
        &mut self,
        placed: &mut Placed<G::Place, HashOf<G>>,
        ground: G,
    ) {
        self.tries -= 1;
        let p = ground.anywhere(&mut self.random);
        if placed.is_free(ground, p, SEED_GAP) && ground.has_room(p) {
            self.queue.push_back(placed.cells.len());
            placed.push(ground.fields(), p);
        }
    }
}

/// Whether one of the cells `beside`, given by offset and shape, stands where a neighbour would touch, at `to` (in
/// sizes).
pub(super) fn is_taken(shape: &CellShape, to: DVec2, beside: &[(DVec2, CellShape)]) -> bool {
    let slot = shape.size * to;
    let mut each = beside.iter();
    each.any(|(r, other)| shape.normalised_distance(other, *r - slot) < TAKEN)
}

/// The places of neighbours that would touch a cell; only those whose offset, in sizes, passes `is_wanted`.
pub(super) fn slots<G: PackingDomain>(
    centre: G::Place,
    shape: CellShape,
    ground: G,
    is_wanted: impl Fn(DVec2) -> bool,
) -> impl Iterator<Item = G::Place> {
    let wanted = shape.places().filter(move |&to| is_wanted(to));
    wanted.map(move |to| {
        let (there, _) = ground.metric().exp(centre, shape.size * to);
        let far = 0.5 * (shape.size + ground.fields().size(there));
        if far == shape.size {
            return there;
        }
        ground.metric().exp(centre, far * to).0
    })
}
