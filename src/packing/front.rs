//! A front of cells that grows over the inside.

use super::PackingParams;
use super::placement::{Crowd, FRONT_GAP, has_room};
use super::shape::Shape;
use crate::domain::{Domain, Facing};
use crate::field::{Fields, Kind};
use crate::random::{Purpose, Random};
use glam::DVec2;
use std::collections::VecDeque;

/// Where the front has died out, a new one starts at a place this free.
const SEED_GAP: f64 = 0.9;

/// A front that grows from the boundary cells along the direction field, first come first served.
pub(super) fn stream(
    crowd: &mut Crowd,
    domain: &Domain,
    fields: &Fields,
    facing: &Facing,
    params: &PackingParams,
) {
    let islands = domain.islands();
    if islands.len() > 1 {
        // Chance would seldom find a small one among many.
        crowd.settle_all();
    }
    let mut queue: VecDeque<usize> = (0..crowd.cells.len()).collect();
    let mut rows = VecDeque::new();
    // Circles have no direction of their own: one honeycomb, from the middle outwards, has fewer
    // faults than rows along the boundary that meet each other. Each island has its own.
    let honeycombs: Vec<DVec2> = islands.iter().map(|i| along_most(i, fields)).collect();
    let first = crowd.cells.len();
    for p in islands.iter().filter_map(Domain::deepest) {
        if fields.kind(p) == Kind::Circle && crowd.is_free(p, FRONT_GAP) {
            crowd.push(p);
        }
    }
    if crowd.cells.len() > first {
        std::mem::swap(&mut rows, &mut queue);
        queue.extend(first..crowd.cells.len());
    }
    let mut random = Random::new(params.seed, Purpose::Placement, 0);
    let (lo, hi) = domain.bounds();
    let tries = 40 + (4.0 * domain.area() / (fields.params().size * fields.params().size)) as u32;
    let mut left = tries;
    loop {
        while let Some(k) = queue.pop_front() {
            let centre = crowd.cells[k];
            let mut shape = Shape::at(fields, centre);
            if shape.kind() == Kind::Circle {
                shape.turn(honeycombs[domain.island(centre)]);
            }
            for p in slots(centre, shape, fields) {
                let p = domain.wrap(p);
                if crowd.is_free(p, FRONT_GAP)
                    && has_room(p, fields, domain, facing, params.edge)
                    && !domain.is_gap_between(centre, p)
                {
                    queue.push_back(crowd.cells.len());
                    crowd.push(p);
                }
            }
        }
        std::mem::swap(&mut rows, &mut queue);
        if !queue.is_empty() {
            continue;
        }
        // The front has died out: look for places it could not reach.
        let found = loop {
            if left == 0 {
                break None;
            }
            left -= 1;
            let p = lo + (hi - lo) * DVec2::new(random.unit(), random.unit());
            if crowd.is_free(p, SEED_GAP) && has_room(p, fields, domain, facing, params.edge) {
                break Some(p);
            }
        };
        let Some(p) = found else { break };
        queue.push_back(crowd.cells.len());
        crowd.push(p);
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
/// of it look alike, so it is a sixth of the angle of the mean of the six-fold vectors. On a torus,
/// that of the fields, whose sizes fit it.
fn along_most(domain: &Domain, fields: &Fields) -> DVec2 {
    if domain.period().is_some() {
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
