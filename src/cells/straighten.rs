//! Straightens the fitted cells: four-cornered ones towards rectangles along the direction field.
//!
//! The dual's corners are means of centres: where rows end or bend they wander. Each four-cornered
//! cell asks for the rectangle that fits it best, turned along its axis; each corner moves to the
//! mean of what its cells ask for; those on the boundary slide along it. This goes beyond the papers; it
//! changes no connection, and never turns a corner inside out.

use super::{Cell, images};
use crate::domain::{Domain, cross};
use crate::order;
use crate::planar::on_grain;
use glam::DVec2;

/// Rounds of asking and moving.
const ROUNDS: u32 = 12;
/// How much of the way a corner goes in a round.
const PACE: f64 = 0.6;
/// How strongly a cell asks for the mean area: 0 not at all, 1 at once.
const EVEN_AREA: f64 = 0.7;
/// A turn of the boundary sharper than this (cosine of 30 degrees) is a corner of the cell.
const CORNER: f64 = 0.866;
/// Two pieces of the boundary are one straight line up to this (cosine of 1 degree).
const STRAIGHT: f64 = 0.9998;
/// The ends of a piece lie on the grain: a shorter one (picture units) tells the way only roughly.
const ROUGH: f64 = 1.0 / 64.0;
/// What is farther from the boundary (picture units) does not lie on it.
const OFF: f64 = 1.0 / 4096.0;
/// Corners whose sine is smaller are straight: only rounding decides their sign.
const FLAT: f64 = 1e-6;
/// A vertex slides at most this share of the way to the next one on the boundary.
const ROOM: f64 = 0.4;
/// A cell may not be asked to be thinner than this share of its size.
const THINNEST: f64 = 0.2;

/// Where a vertex may go.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Freedom {
    /// Nowhere: a corner of the outline, or a point of it that only one cell has.
    Fixed,
    /// Along the boundary or a constraint line: two cells meet on a straight piece of it. Holds its
    /// unit vector.
    Slides(DVec2),
    /// Anywhere.
    Free,
}

/// The cells' rings as shared vertices.
struct Rings {
    points: Vec<DVec2>,
    free: Vec<Freedom>,
    /// The point lies on a constraint line.
    on_line: Vec<bool>,
    /// For each cell the indices of its ring.
    rings: Vec<Vec<u32>>,
    /// For each cell with exactly four corners, these.
    quads: Vec<Option<[u32; 4]>>,
    /// (vertex, cell, place in the ring), by vertex.
    uses: Vec<[u32; 3]>,
    start: Vec<u32>,
    /// See [`images::twins`].
    twins: Vec<(u32, u32, DVec2)>,
}

/// The straightening of cells, in rounds.
pub(super) struct Straightening {
    rings: Rings,
    /// The mean area of the cells, of what their sizes ask for.
    share: f64,
    next: Next,
}

/// What the next slice of the work does.
enum Next {
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
            next: Next::Freedom,
        }
    }

    /// One slice of the work on the cells it was begun with; true with the last one.
    pub fn advance(&mut self, domain: &Domain, cells: &[Cell]) -> bool {
        self.next = match self.next {
            Next::Freedom => {
                self.rings.find_free(domain);
                Next::Corners
            }
            Next::Corners => {
                self.rings.find_corners();
                Next::Round(1)
            }
            Next::Round(number) => {
                self.rings.round(cells, self.share);
                if number == ROUNDS {
                    self.rings.settle(domain);
                }
                Next::Round(number + 1)
            }
        };
        matches!(self.next, Next::Round(number) if number > ROUNDS)
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
    fn new(domain: &Domain, cells: &[Cell]) -> Self {
        let mut all: Vec<(u64, u64, u32, u32)> = Vec::new();
        for (cell, c) in cells.iter().enumerate() {
            for (place, p) in c.ring.iter().enumerate() {
                all.push((p.x.to_bits(), p.y.to_bits(), cell as u32, place as u32));
            }
        }
        order::sort(&mut all, |a| (a.0, a.1));
        let mut rings: Vec<Vec<u32>> = cells.iter().map(|c| vec![0; c.ring.len()]).collect();
        let (mut points, mut uses, mut start) = (Vec::new(), Vec::new(), Vec::new());
        let mut last = None;
        for (x, y, cell, place) in all {
            if last != Some((x, y)) {
                last = Some((x, y));
                start.push(uses.len() as u32);
                points.push(DVec2::new(f64::from_bits(x), f64::from_bits(y)));
            }
            let vertex = points.len() as u32 - 1;
            rings[cell as usize][place as usize] = vertex;
            uses.push([vertex, cell, place]);
        }
        start.push(uses.len() as u32);
        Self {
            twins: images::twins(domain, &points),
            free: vec![Freedom::Fixed; points.len()],
            on_line: vec![false; points.len()],
            points,
            rings,
            quads: Vec::new(),
            uses,
            start,
        }
    }

    fn uses_of(&self, vertex: usize) -> &[[u32; 3]] {
        &self.uses[self.start[vertex] as usize..self.start[vertex + 1] as usize]
    }

    fn neighbour(&self, [_, cell, place]: [u32; 3], ahead: bool) -> u32 {
        let ring = &self.rings[cell as usize];
        let step = if ahead { 1 } else { ring.len() - 1 };
        ring[(place as usize + step) % ring.len()]
    }

    /// The edges of rings that no other ring runs back along, as (from, to).
    fn lone_edges(&self) -> impl Iterator<Item = [u32; 2]> {
        let edges = self.rings.iter().flat_map(|ring| {
            let next = ring.iter().cycle().skip(1);
            ring.iter().zip(next).map(|(&a, &b)| [a, b])
        });
        edges.filter(|&[a, b]| {
            let mut uses = self.uses_of(b as usize).iter();
            uses.all(|&u| self.neighbour(u, true) != a)
        })
    }

    /// A vertex is free where cells close a full turn around it, and slides where just one lone
    /// edge arrives and one leaves, on a straight piece of the boundary. Lone edges elsewhere (where
    /// one ring has a vertex on a side of another) hold their ends.
    fn find_free(&mut self, domain: &Domain) {
        let mut arriving: Vec<Vec<u32>> = vec![Vec::new(); self.points.len()];
        let mut leaving = arriving.clone();
        for [a, b] in self.lone_edges() {
            leaving[a as usize].push(b);
            arriving[b as usize].push(a);
        }
        for vertex in 0..self.points.len() {
            let p = self.points[vertex];
            let on_boundary = |q: DVec2| domain.nearest(q).distance.abs() < 0.01;
            let line = domain.nearest_line(p).filter(|near| near.distance < 0.01);
            self.on_line[vertex] = line.is_some();
            self.free[vertex] = match (&arriving[vertex][..], &leaving[vertex][..]) {
                ([], []) if on_boundary(p) => Freedom::Fixed,
                ([], []) => line.map_or(Freedom::Free, |near| {
                    self.along_line(domain, vertex, near.tangent)
                }),
                (&[a], &[b]) if line.is_none() && self.uses_of(vertex).len() > 1 => {
                    let (a, b) = (self.points[a as usize], self.points[b as usize]);
                    let (here, ahead) = ((p - a).normalize(), (b - p).normalize());
                    let straight = here.dot(ahead) > STRAIGHT;
                    if straight && on_boundary(p.midpoint(a)) && on_boundary(p.midpoint(b)) {
                        let is_rough = p.distance(b) < ROUGH.min(p.distance(a));
                        Freedom::Slides(if is_rough { here } else { ahead })
                    } else {
                        Freedom::Fixed
                    }
                }
                _ => Freedom::Fixed,
            };
        }
        for &(_, image, _) in &self.twins {
            self.free[image as usize] = Freedom::Fixed;
        }
    }

    /// A vertex on a constraint line slides where the line is straight and no other line meets it.
    fn along_line(&self, domain: &Domain, vertex: usize, along: DVec2) -> Freedom {
        let p = self.points[vertex];
        let (mut ahead, mut behind) = (false, false);
        for &u in self.uses_of(vertex) {
            for side in [true, false] {
                let q = self.points[self.neighbour(u, side) as usize];
                let middle = domain.nearest_line(p.midpoint(q));
                if middle.is_some_and(|near| near.distance < 0.01) {
                    let cosine = along.dot(q - p) / p.distance(q);
                    if cosine.abs() < STRAIGHT {
                        return Freedom::Fixed;
                    }
                    ahead |= cosine > 0.0;
                    behind |= cosine < 0.0;
                }
            }
        }
        if ahead && behind {
            Freedom::Slides(along)
        } else {
            Freedom::Fixed
        }
    }

    /// How far along the boundary a vertex may slide: not up to the next one on either side.
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
            order::within(wanted, least, most)
        } else {
            0.0
        }
    }

    fn find_corners(&mut self) {
        let cells = 0..self.rings.len();
        self.quads = cells.map(|cell| self.four_corners(cell)).collect();
    }

    /// The four corners of a cell: where three cells meet, where a side meets the boundary, or
    /// where the boundary itself turns.
    fn four_corners(&self, cell: usize) -> Option<[u32; 4]> {
        let ring = &self.rings[cell];
        let n = ring.len();
        let mut corners = Vec::new();
        for (k, &vertex) in ring.iter().enumerate() {
            let count = self.uses_of(vertex as usize).len();
            let free = self.free[vertex as usize] == Freedom::Free;
            let [a, b, c] =
                [ring[(k + n - 1) % n], vertex, ring[(k + 1) % n]].map(|v| self.points[v as usize]);
            let turn = (b - a).normalize().dot((c - b).normalize());
            // A corner of cells beyond a constraint line is none of this one.
            let beyond = self.on_line[vertex as usize] && turn > STRAIGHT;
            let meets = count >= if free { 3 } else { 2 } && !beyond;
            let turns = turn < CORNER;
            if meets || turns {
                corners.push(vertex);
            }
        }
        corners.try_into().ok()
    }

    fn round(&mut self, cells: &[Cell], mean_area: f64) {
        let mut asked = vec![(DVec2::ZERO, 0u32); self.points.len()];
        for (cell, corners) in cells.iter().zip(&self.quads) {
            let Some(corners) = corners else { continue };
            let places = corners.map(|k| self.points[k as usize]);
            let Some(targets) = rectangle(places, cell, mean_area) else {
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
            if !self.is_sound(vertex, old) {
                self.points[vertex] = old;
            }
            self.follow(vertex);
        }
    }

    /// Puts back onto the boundary what has left it: pieces that hardly turn passed for one straight line.
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

    /// Moves the images of a vertex after it.
    fn follow(&mut self, vertex: usize) {
        let first = self.twins.partition_point(|t| (t.0 as usize) < vertex);
        for &(home, image, by) in &self.twins[first..] {
            if home as usize != vertex {
                break;
            }
            self.points[image as usize] = self.points[vertex] + by;
        }
    }

    /// Has the vertex, come from `old`, turned no corner and no cell inside out?
    fn is_sound(&self, vertex: usize, old: DVec2) -> bool {
        let at = |k: u32| self.points[k as usize];
        let before = |k: u32| if k as usize == vertex { old } else { at(k) };
        self.uses_of(vertex).iter().all(|&[_, cell, place]| {
            let ring = &self.rings[cell as usize];
            let n = ring.len();
            let inside = |q: DVec2, t: [DVec2; 3]| {
                let turn = |k: usize| cross(t[k], t[(k + 1) % 3], q);
                let turns = [turn(0), turn(1), turn(2)];
                turns.iter().all(|&t| t > 0.0) || turns.iter().all(|&t| t < 0.0)
            };
            // Neither of its sides may have gone over a corner that stays.
            let swept = |&k: &u32| {
                let held = self.free[k as usize] == Freedom::Fixed;
                let past = |to: u32| to != k && inside(at(k), [old, at(vertex as u32), at(to)]);
                let ends = [n - 1, 1].map(|shift| ring[(place as usize + shift) % n]);
                held && k as usize != vertex && ends.into_iter().any(past)
            };
            // Twice the area, seen from the vertex.
            let own = at(vertex as u32);
            let spans = (1..n - 1).map(|k| [k, k + 1].map(|k| ring[(place as usize + k) % n]));
            let area: f64 = spans.map(|[a, b]| cross(own, at(a), at(b))).sum();
            if area <= 0.0 || ring.iter().any(swept) {
                return false;
            }
            // The turns at the vertex and at its two neighbours.
            [n - 1, 0, 1].into_iter().all(|shift| {
                let k = place as usize + shift;
                let three = [ring[(k + n - 1) % n], ring[k % n], ring[(k + 1) % n]];
                let [a, b, c] = three.map(at);
                let [d, e, f] = three.map(before);
                let (now, then) = (cross(a, b, c), cross(d, e, f));
                now > 0.0 || now >= then || then.abs() < FLAT * a.distance(b) * b.distance(c)
            })
        })
    }
}

/// The corners of the rectangle along the cell's axis that fits four corners best, its area drawn
/// towards `mean_area` (in squared sizes).
fn rectangle(corners: [DVec2; 4], cell: &Cell, mean_area: f64) -> Option<[DVec2; 4]> {
    let middle = corners.iter().sum::<DVec2>() / 4.0;
    let e = cell.axis;
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
    let shift = (0..4).max_by(|&a, &b| {
        let total = |s| fit(s).element_sum();
        total(a).total_cmp(&total(b)).then(b.cmp(&a))
    })?;
    let mut half = fit(shift);
    let least = 0.5 * THINNEST * cell.size;
    if e == DVec2::ZERO || !half.cmpgt(DVec2::splat(least)).all() {
        return None;
    }
    let ratio = mean_area * cell.size * cell.size / (4.0 * half.x * half.y);
    half *= 1.0 + EVEN_AREA * (ratio.clamp(0.25, 4.0).sqrt() - 1.0);
    let mut k = 0;
    Some(corners.map(|_| {
        let q = SIGNS[(k + shift) % 4] * half;
        k += 1;
        middle + e * q.x + e.perp() * q.y
    }))
}
