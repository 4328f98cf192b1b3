//! Straightens the fitted cells: cells with four corners become more like rectangles along the direction field.
//!
//! The dual's corners are means of centres and wander where rows end or bend. Each four-cornered cell
//! proposes the rectangle that fits it best along its axis, and each corner moves to the mean of its cells'
//! proposals; corners on the boundary slide along it. This goes beyond the papers. It changes no connection
//! and never turns a corner inside out.

use super::Cell;
use super::vertices::{Freedom, Rings, STRAIGHT};
use crate::domain::{Domain, cross};
use crate::planar::on_grain;
use glam::DVec2;

/// Rounds of proposing and moving.
pub(crate) const ROUNDS: u32 = 12;
/// Share of the way that a corner moves in a round.
pub(crate) const PACE: f64 = 0.6;
/// Pull towards the mean area: 0 none, 1 all at once.
const EVEN_AREA: f64 = 0.7;
/// A point farther from the boundary (picture units) does not lie on it.
const OFF: f64 = 1.0 / 4096.0;
/// A turn with a smaller sine than this is straight: rounding alone decides its sign.
const FLAT: f64 = 1e-6;
/// Largest share of the distance to the next boundary vertex that a vertex may slide.
pub(crate) const ROOM: f64 = 0.4;
/// No proposed rectangle is thinner than this share of its cell's size.
const THINNEST: f64 = 0.2;

/// The straightening of cells, in rounds.
pub(super) struct Straightening {
    rings: Rings,
    /// The sum of the cells' areas over the sum of their squared sizes.
    share: f64,
    next: StraighteningPhase,
}

/// The next slice of the work.
enum StraighteningPhase {
    Freedom,
    Corners,
    Round(u32),
}

impl Straightening {
    pub fn new(domain: &Domain, cells: &[Cell]) -> Self {
        let area: f64 = cells
            .iter()
            .map(|c| crate::domain::signed_area(&c.ring))
            .sum();
        let asked: f64 = cells.iter().map(|c| c.size * c.size).sum();
        Self {
            rings: Rings::new(domain, cells),
            share: area / asked,
            next: StraighteningPhase::Freedom,
        }
    }

    /// Does one slice of the work; true with the last one. All calls must give the same cells.
    pub fn advance(&mut self, domain: &Domain, cells: &[Cell]) -> bool {
        self.next = match self.next {
            StraighteningPhase::Freedom => {
                self.rings.find_free(domain);
                StraighteningPhase::Corners
            }
            StraighteningPhase::Corners => {
                self.rings.find_corners();
                StraighteningPhase::Round(1)
            }
            StraighteningPhase::Round(number) => {
                self.rings.round(cells, self.share);
                if number == ROUNDS {
                    self.rings.settle(domain);
                }
                StraighteningPhase::Round(number + 1)
            }
        };
        matches!(self.next, StraighteningPhase::Round(number) if number > ROUNDS)
    }

    /// Gives the cells their straightened rings.
    pub fn finish(self, cells: &mut [Cell]) {
        for (cell, ring) in cells.iter_mut().zip(&self.rings.rings) {
            let points = ring.iter().map(|&k| self.rings.points[k as usize]);
            cell.ring = points.collect();
        }
    }
}

impl Rings {
    /// The distance by which a vertex slides along the boundary: `wanted`, clamped to end short of the next vertex on
    /// either side.
    fn slide(&self, vertex: usize, along: DVec2, wanted: f64) -> f64 {
        let p = self.points[vertex];
        let (mut least, mut most) = (-f64::INFINITY, f64::INFINITY);
        for &u in self.uses_of(vertex) {
            for ahead in [true, false] {
                let to = self.points[self.neighbour(u, ahead) as usize] - p;
                let t = along.dot(to);
                if t.abs() > STRAIGHT * to.length() {
                    if t > 0.0 {
                        most = most.min(t * ROOM);
                    } else {
                        least = least.max(t * ROOM);
                    }
                }
            }
        }
        if least < most {
            wanted.clamp(least, most)
        } else {
            0.0
        }
    }

    fn round(&mut self, cells: &[Cell], mean_area: f64) {
        let mut asked = vec![(DVec2::ZERO, 0u32); self.points.len()];
        for (cell, corners) in cells.iter().zip(&self.quads) {
            let Some(corners) = corners else { continue };
            let places = corners.map(|k| self.points[k as usize]);
            let Some(targets) = rectangle(places, cell.axis, cell.size, mean_area) else {
                continue;
            };
            for (&k, target) in corners.iter().zip(targets) {
                asked[k as usize].0 += target;
                asked[k as usize].1 += 1;
            }
        }
        for (vertex, (sum, count)) in asked.into_iter().enumerate() {
            let old = self.points[vertex];
            let by = PACE * (sum / f64::from(count.max(1)) - old);
            self.points[vertex] = match self.free[vertex] {
                _ if count == 0 => old,
                Freedom::Fixed => old,
                Freedom::Free => old + by,
                Freedom::Slides(along) => old + along * self.slide(vertex, along, along.dot(by)),
            };
            if !self.twins.is_empty() && self.free[vertex] != Freedom::Fixed {
                self.points[vertex] = on_grain(self.points[vertex]);
            }
            if self.points[vertex] != old && !self.is_sound(vertex, old) {
                self.points[vertex] = old;
            }
            self.follow(vertex);
        }
    }

    /// Puts sliding vertices back onto the boundary. They may have left it, because slightly bent pieces count as
    /// straight.
    fn settle(&mut self, domain: &Domain) {
        for vertex in 0..self.points.len() {
            let old = self.points[vertex];
            if !matches!(self.free[vertex], Freedom::Slides(_)) || self.on_line[vertex] {
                continue;
            }
            let near = domain.nearest(old);
            if near.distance.abs() > OFF {
                self.points[vertex] = near.point;
                if !self.is_sound(vertex, old) {
                    self.points[vertex] = old;
                }
            }
        }
    }

    /// Moves the images of a vertex with it.
    fn follow(&mut self, vertex: usize) {
        let first = self.twins.partition_point(|t| (t.0 as usize) < vertex);
        for &(home, image, by) in &self.twins[first..] {
            if home as usize != vertex {
                break;
            }
            self.points[image as usize] = self.points[vertex] + by;
        }
    }

    /// Whether the move of a vertex from `old` has turned no corner and no cell inside out.
    fn is_sound(&self, vertex: usize, old: DVec2) -> bool {
        let mut uses = self.uses_of(vertex).iter();
        uses.all(|&[_, cell, place]| {
            let ring = &self.rings[cell as usize];
            let (before, after) = ring.split_at(place as usize);
            let mut around = after[1..].iter().chain(before);
            let own = self.points[vertex];
            let at = |&k: &u32| self.points[k as usize];
            let (Some(first), Some(second)) = (around.next().map(at), around.next().map(at)) else {
                return false;
            };
            // Twice the area, as a fan from the vertex.
            let mut area = cross(own, first, second);
            let (mut earlier, mut last) = (first, second);
            for next in around.map(at) {
                area += cross(own, last, next);
                (earlier, last) = (last, next);
            }
            // The turns at the vertex and at its two neighbours.
            let turns = [
                cross(last, own, first),
                cross(earlier, last, own),
                cross(own, first, second),
            ];
            !(area <= 0.0 || self.sweeps((vertex, old), ring, [last, first]))
                && (turns.iter().all(|&turn| turn > 0.0)
                    || self.keeps_turns((vertex, old), ring, place as usize))
        })
    }

    /// Whether one of the sides between a moved vertex and its neighbours in a ring has swept over a fixed corner.
    fn sweeps(&self, (vertex, old): (usize, DVec2), ring: &[u32], ends: [DVec2; 2]) -> bool {
        let own = self.points[vertex];
        let inside = |q: DVec2, t: [DVec2; 3]| {
            let turn = |k: usize| cross(t[k], t[(k + 1) % 3], q);
            let turns = [turn(0), turn(1), turn(2)];
            turns.iter().all(|&t| t > 0.0) || turns.iter().all(|&t| t < 0.0)
        };
        let is_held =
            |&&k: &&u32| matches!(self.free[k as usize], Freedom::Fixed) && k as usize != vertex;
        ring.iter().filter(is_held).any(|&k| {
            let corner = self.points[k as usize];
            let past = |end: DVec2| end != corner && inside(corner, [old, own, end]);
            ends.into_iter().any(past)
        })
    }

    /// Whether each turn at a moved vertex and at its two neighbours in a ring is convex, or no worse than before the
    /// move, or was straight before.
    fn keeps_turns(&self, (vertex, old): (usize, DVec2), ring: &[u32], place: usize) -> bool {
        let n = ring.len();
        let at = |k: u32| self.points[k as usize];
        let before = |k: u32| if k as usize == vertex { old } else { at(k) };
        [n - 1, 0, 1].into_iter().all(|shift| {
            let k = place + shift;
            let three = [ring[(k + n - 1) % n], ring[k % n], ring[(k + 1) % n]];
            let [a, b, c] = three.map(at);
            let [d, e, f] = three.map(before);
            let (now, then) = (cross(a, b, c), cross(d, e, f));
            now > 0.0 || now >= then || then.abs() < FLAT * a.distance(b) * b.distance(c)
        })
    }
}

/// The corners of the rectangle along a cell's axis that fits four corners best, with its area drawn towards
/// `mean_area` (in squared sizes). `None` without an axis, or if the rectangle is too thin.
pub(crate) fn rectangle(
    corners: [DVec2; 4],
    axis: DVec2,
    size: f64,
    mean_area: f64,
) -> Option<[DVec2; 4]> {
    let middle = corners.iter().sum::<DVec2>() / 4.0;
    let e = axis;
    let local = corners.map(|p| DVec2::new(e.dot(p - middle), e.perp_dot(p - middle)));
    const SIGNS: [DVec2; 4] = [
        DVec2::new(-1.0, -1.0),
        DVec2::new(1.0, -1.0),
        DVec2::new(1.0, 1.0),
        DVec2::new(-1.0, 1.0),
    ];
    let fit = |shift: usize| {
        let mut sum = DVec2::ZERO;
        for (k, &q) in local.iter().enumerate() {
            sum += SIGNS[(k + shift) % 4] * q;
        }
        sum / 4.0
    };
    let fits = [0, 1, 2, 3].map(fit);
    let total = |shift: usize| fits[shift].element_sum();
    let shift = (0..4).max_by(|&a, &b| total(a).total_cmp(&total(b)).then(b.cmp(&a)))?;
    let mut half = fits[shift];
    let least = 0.5 * THINNEST * size;
    if e == DVec2::ZERO || !half.cmpgt(DVec2::splat(least)).all() {
        return None;
    }
    let ratio = mean_area * size * size / (4.0 * half.x * half.y);
    half *= 1.0 + EVEN_AREA * (ratio.clamp(0.25, 4.0).sqrt() - 1.0);
    let mut k = 0;
    Some(corners.map(|_| {
        let q = SIGNS[(k + shift) % 4] * half;
        k += 1;
        middle + e * q.x + e.perp() * q.y
    }))
}
