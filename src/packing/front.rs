//! A front of cells that grows over the inside.

use super::Surroundings;
use super::clearance::has_room;
use super::placed::{FRONT_GAP, Placed};
use super::shape::Shape;
use crate::domain::Domain;
use crate::field::{Fields, Kind};
use crate::random::{Purpose, Random};
use glam::DVec2;
use std::collections::VecDeque;

/// Where the front has died out, a new one starts at a place this free.
const SEED_GAP: f64 = 0.9;

/// A front that grows from the boundary cells along the direction field, first come first served.
pub(super) struct Front {
    queue: VecDeque<usize>,
    /// What begins to grow when the front has died out for the first time.
    rows: VecDeque<usize>,
    /// By island the direction of a honeycomb's rows.
    honeycombs: Vec<DVec2>,
    random: Random,
    /// How often a place is still looked for that the front could not reach.
    tries: u32,
}

impl Front {
    pub fn new(placed: &mut Placed, domain: &Domain, fields: &Fields, seed: u64) -> Self {
        let islands = domain.islands();
        if islands.len() > 1 {
            // Random places would seldom lie in a small one among many.
            placed.fill_empty_islands(domain, fields);
        }
        let mut queue: VecDeque<usize> = (0..placed.cells.len()).collect();
        let mut rows = VecDeque::new();
        // Circles have no direction of their own: one honeycomb, from the middle outwards, has fewer
        // faults than rows along the boundary that meet each other. Each island has its own.
        let honeycombs: Vec<DVec2> = islands.iter().map(|i| along_most(i, fields)).collect();
        let first = placed.cells.len();
        for p in islands.iter().filter_map(Domain::deepest) {
            if fields.kind(p) == Kind::Circle && placed.is_free(domain, fields, p, FRONT_GAP) {
                placed.push(fields, p);
            }
        }
        if placed.cells.len() > first {
            std::mem::swap(&mut rows, &mut queue);
            queue.extend(first..placed.cells.len());
        }
        let size = fields.params().size;
        Self {
            queue,
            rows,
            honeycombs,
            random: Random::new(seed, Purpose::Placement, 0),
            tries: 40 + (4.0 * domain.area() / (size * size)) as u32,
        }
    }

    /// Grows around the next cell, or looks for a place to grow on from; true when that is over.
    pub fn grow(&mut self, placed: &mut Placed, around: Surroundings) -> bool {
        if self.queue.is_empty() {
            std::mem::swap(&mut self.rows, &mut self.queue);
        }
        match self.queue.pop_front() {
            Some(k) => self.grow_around(k, placed, around),
            None if self.tries == 0 => return true,
            None => self.try_anywhere(placed, around),
        }
        false
    }

    fn grow_around(&mut self, k: usize, placed: &mut Placed, around: Surroundings) {
        let Surroundings { domain, fields, .. } = around;
        let centre = placed.cells[k];
        let mut shape = Shape::at(fields, centre);
        if shape.kind() == Kind::Circle {
            shape.turn(self.honeycombs[domain.island(centre)]);
        }
        for p in slots(centre, shape, fields) {
            let p = domain.space().wrap(p);
            if placed.is_free(domain, fields, p, FRONT_GAP)
                && has_room(p, around)
                && !domain.is_gap_between(centre, p)
            {
                self.queue.push_back(placed.cells.len());
                placed.push(fields, p);
            }
        }
    }

    fn try_anywhere(&mut self, placed: &mut Placed, around: Surroundings) {
        let Surroundings { domain, fields, .. } = around;
        self.tries -= 1;
        let (lo, hi) = domain.bounds();
        let p = lo + (hi - lo) * DVec2::new(self.random.unit(), self.random.unit());
        if placed.is_free(domain, fields, p, SEED_GAP) && has_room(p, around) {
            self.queue.push_back(placed.cells.len());
            placed.push(fields, p);
        }
    }
}

/// The places of neighbours that touch a cell.
pub(super) fn slots(centre: DVec2, shape: Shape, fields: &Fields) -> impl Iterator<Item = DVec2> {
    shape.places().map(move |to| {
        let there = centre + shape.size * to;
        centre + 0.5 * (shape.size + fields.size(there)) * to
    })
}

/// The direction in which a honeycomb's rows lie along as much of the boundary as can be: six turns
/// of it look alike, so it is a sixth of the angle of the mean of the six-fold vectors. Without a
/// boundary, that of the fields.
fn along_most(domain: &Domain, fields: &Fields) -> DVec2 {
    if domain.segments().is_empty() {
        return fields.direction(DVec2::ZERO);
    }
    let mut sum = DVec2::ZERO;
    for [a, b] in domain.segments() {
        let (length, angle) = (a.distance(*b), libm::atan2(b.y - a.y, b.x - a.x));
        sum += length * DVec2::new(libm::cos(6.0 * angle), libm::sin(6.0 * angle));
    }
    let angle = libm::atan2(sum.y, sum.x) / 6.0;
    DVec2::new(libm::cos(angle), libm::sin(angle))
}
