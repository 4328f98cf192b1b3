//! The first cells: along the boundary, then inside.

use super::grid::Grid;
use super::{Edge, PackingParams, Start};
use crate::domain::{Domain, Facing};
use crate::field::Fields;
use crate::random::{Purpose, Random};
use glam::DVec2;
use std::collections::VecDeque;

/// The ring is cut into pieces where it turns by more than this (cosine of 25 degrees).
const CORNER: f64 = 0.906;
/// Boundary cells nearer to each other than this (in sizes) are dropped ...
const BOUNDARY_GAP: f64 = 0.6;
/// ... as are those nearer to the boundary than this share of their way in, where a bend is
/// tighter than a cell.
const BOUNDARY_CLEARANCE: f64 = 0.8;
/// How far in the first row stands, in sizes: half a cell, or less where the outline is narrow.
const DEPTHS: [f64; 4] = [0.5, 0.4, 0.3, 0.22];
/// The front takes a place whose nearest cell is at least this far, in stable distances.
const FRONT_GAP: f64 = 0.75;
/// Where the front has died out, a new one starts at a place this free.
const SEED_GAP: f64 = 0.9;
/// The fewest sizes from the boundary at which a cell is placed inside.
const INSIDE_CLEARANCE: f64 = 0.35;

/// The cells of the start: centre, and whether it is fixed on the boundary.
pub(super) fn place(
    domain: &Domain,
    fields: &Fields,
    facing: &Facing,
    params: &PackingParams,
) -> Vec<(DVec2, bool)> {
    let mut crowd = Crowd::new(domain, fields);
    let fixed = params.edge == Edge::On;
    for ring in domain.rings() {
        for piece in pieces(ring) {
            boundary_cells(&mut crowd, &piece, fields, domain, fixed);
        }
    }
    let on_boundary = crowd.cells.len();
    match params.start {
        Start::Stream => stream(&mut crowd, domain, fields, facing, params),
        Start::Quadtree => quadtree(&mut crowd, domain, fields, facing, params.edge),
    }
    let cells = crowd.cells.into_iter().enumerate();
    cells
        .map(|(k, centre)| (centre, fixed && k < on_boundary))
        .collect()
}

/// Cells so far, with the grid to find them.
struct Crowd<'a> {
    cells: Vec<DVec2>,
    sizes: Vec<f64>,
    grid: Grid,
    largest: f64,
    fields: &'a Fields,
}

impl<'a> Crowd<'a> {
    fn new(domain: &Domain, fields: &'a Fields) -> Self {
        let (lo, hi) = domain.bounds();
        Self {
            cells: Vec::new(),
            sizes: Vec::new(),
            grid: Grid::new(lo, hi, fields.params().size),
            largest: 0.0,
            fields,
        }
    }

    fn push(&mut self, p: DVec2) {
        let size = self.fields.size(p);
        self.cells.push(p);
        self.sizes.push(size);
        self.grid.push(p);
        self.largest = self.largest.max(size);
    }

    /// The distance to the nearest cell in stable distances, or `enough` where none is nearer.
    fn gap(&self, p: DVec2, enough: f64) -> f64 {
        let size = self.fields.size(p);
        let mut least = enough;
        self.grid
            .near(p, enough * 0.5 * (size + self.largest), |k| {
                let w = self.cells[k].distance(p) / (0.5 * (size + self.sizes[k]));
                least = least.min(w);
            });
        least
    }
}

/// A ring's pieces between corners, each a run of points; a smooth ring is one closed piece.
struct Piece {
    points: Vec<DVec2>,
    /// The directions with which the neighbouring pieces meet it at its ends.
    before: Option<DVec2>,
    after: Option<DVec2>,
}

fn pieces(ring: &[DVec2]) -> Vec<Piece> {
    let n = ring.len();
    let along = |k: usize| (ring[(k + 1) % n] - ring[k % n]).normalize();
    let corners: Vec<usize> = (0..n)
        .filter(|&k| along(k + n - 1).dot(along(k)) < CORNER)
        .collect();
    if corners.is_empty() {
        let mut points = ring.to_vec();
        points.push(ring[0]);
        return vec![Piece {
            points,
            before: None,
            after: None,
        }];
    }
    let ends = corners.iter().skip(1).copied().chain([corners[0] + n]);
    let runs = corners.iter().copied().zip(ends);
    runs.map(|(from, to)| Piece {
        points: (from..=to).map(|k| ring[k % n]).collect(),
        before: Some(along(from + n - 1)),
        after: Some(along(to)),
    })
    .collect()
}

/// Evenly spaced cells along a piece: on it, or half a cell inside with mitred ends.
fn boundary_cells(crowd: &mut Crowd, piece: &Piece, fields: &Fields, domain: &Domain, fixed: bool) {
    // Narrow: with a row half a cell in, most of it would not be clear of the other side.
    let is_wide = |depth: &&f64| {
        let line = offset_line(piece, fields, **depth);
        let clear = |p: &&DVec2| {
            domain.nearest(**p).distance >= BOUNDARY_CLEARANCE * **depth * fields.size(**p)
        };
        2 * line.iter().filter(clear).count() >= line.len()
    };
    let depth = *DEPTHS.iter().find(is_wide).unwrap_or(&DEPTHS[0]);
    let line = if fixed {
        piece.points.clone()
    } else {
        offset_line(piece, fields, depth)
    };
    // Lengths in cells: a step is shorter where cells are smaller.
    let mut reached = vec![0.0];
    for w in line.windows(2) {
        let cells = w[0].distance(w[1]) / fields.size(w[0].midpoint(w[1]));
        reached.push(reached[reached.len() - 1] + cells);
    }
    let total = reached[reached.len() - 1];
    let closed = piece.before.is_none();
    let count = (total.round() as usize).max(1);
    let places = if closed { count } else { count + 1 };
    let mut k = 0;
    for place in 0..places {
        let at = total * place as f64 / count as f64;
        while k + 2 < line.len() && reached[k + 1] < at {
            k += 1;
        }
        let span = reached[k + 1] - reached[k];
        let t = if span > 0.0 {
            ((at - reached[k]) / span).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let p = line[k].lerp(line[k + 1], t);
        let clear = || domain.nearest(p).distance >= BOUNDARY_CLEARANCE * depth * fields.size(p);
        if (fixed || clear()) && crowd.gap(p, BOUNDARY_GAP) >= BOUNDARY_GAP {
            crowd.push(p);
        }
    }
}

/// The piece moved inwards by `depth` cells. At its ends it meets the neighbouring pieces' lines.
fn offset_line(piece: &Piece, fields: &Fields, depth: f64) -> Vec<DVec2> {
    let points = &piece.points;
    let last = points.len() - 1;
    let along = |k: usize| (points[k + 1] - points[k]).normalize();
    let closing = (piece.before.is_none()).then(|| (along(last - 1), along(0)));
    (0..=last)
        .map(|k| {
            let earlier = match (k, piece.before, closing) {
                (0, Some(before), _) => before,
                (0, None, Some((end, _))) => end,
                _ => along(k.max(1) - 1),
            };
            let later = match (k == last, piece.after, closing) {
                (true, Some(after), _) => after,
                (true, None, Some((_, start))) => start,
                _ => along(k.min(last - 1)),
            };
            points[k] + mitre(earlier, later) * depth * fields.size(points[k])
        })
        .collect()
}

/// Where the inward offsets by 1 of two lines meet, seen from their common point; at tips sharper
/// than about 40 degrees not quite so far in.
fn mitre(earlier: DVec2, later: DVec2) -> DVec2 {
    let normal = (earlier.perp() + later.perp()).normalize_or(later.perp());
    normal / normal.dot(later.perp()).max(0.35)
}

/// A front that grows from the boundary cells along the direction field, first come first served.
fn stream(
    crowd: &mut Crowd,
    domain: &Domain,
    fields: &Fields,
    facing: &Facing,
    params: &PackingParams,
) {
    let mut queue: VecDeque<usize> = (0..crowd.cells.len()).collect();
    let mut random = Random::new(params.seed, Purpose::Placement, 0);
    let (lo, hi) = domain.bounds();
    let tries = 40 + (4.0 * domain.area() / (fields.params().size * fields.params().size)) as u32;
    let mut left = tries;
    loop {
        while let Some(k) = queue.pop_front() {
            for p in slots(crowd.cells[k], crowd.sizes[k], fields) {
                if crowd.gap(p, FRONT_GAP) >= FRONT_GAP
                    && has_room(p, fields, domain, facing, params.edge)
                {
                    queue.push_back(crowd.cells.len());
                    crowd.push(p);
                }
            }
        }
        // The front has died out: look for places it could not reach.
        let found = loop {
            if left == 0 {
                break None;
            }
            left -= 1;
            let p = lo + (hi - lo) * DVec2::new(random.unit(), random.unit());
            if crowd.gap(p, SEED_GAP) >= SEED_GAP
                && has_room(p, fields, domain, facing, params.edge)
            {
                break Some(p);
            }
        };
        let Some(p) = found else { break };
        queue.push_back(crowd.cells.len());
        crowd.push(p);
    }
    if crowd.cells.is_empty()
        && let Some(p) = deepest(domain)
    {
        crowd.push(p);
    }
}

/// The four places edge to edge with a cell.
pub(super) fn slots(centre: DVec2, size: f64, fields: &Fields) -> [DVec2; 4] {
    let e = fields.direction(centre).normalize_or(DVec2::X);
    [e, e.perp(), -e, -e.perp()].map(|to| {
        let there = centre + size * to;
        centre + 0.5 * (size + fields.size(there)) * to
    })
}

/// Is there room for a cell between the walls at this place?
pub(super) fn has_room(
    p: DVec2,
    fields: &Fields,
    domain: &Domain,
    facing: &Facing,
    edge: Edge,
) -> bool {
    let (lo, hi) = domain.bounds();
    if !(p.cmpgt(lo).all() && p.cmplt(hi).all()) {
        return false;
    }
    if !facing.is_near(p) {
        return domain.contains(p);
    }
    let clearance = match edge {
        Edge::Wall => INSIDE_CLEARANCE,
        // The first row inside keeps off the cells on the boundary by itself.
        Edge::On => FRONT_GAP * 0.8,
    };
    domain.nearest(p).distance >= clearance * fields.size(p)
}

/// The innermost point of a coarse sample: where the only cell of a narrow outline goes.
fn deepest(domain: &Domain) -> Option<DVec2> {
    let (lo, hi) = domain.bounds();
    let mut best = (0.0, None);
    for row in 0..64 {
        for column in 0..64 {
            let t = DVec2::new(f64::from(column) + 0.5, f64::from(row) + 0.5) / 64.0;
            let p = lo + (hi - lo) * t;
            let depth = domain.nearest(p).distance;
            if depth > best.0 {
                best = (depth, Some(p));
            }
        }
    }
    best.1
}

/// One cell in the middle of every leaf; a square is divided while it is larger than the size
/// field asks for at its middle. For a constant size the leaves have just that size.
fn quadtree(crowd: &mut Crowd, domain: &Domain, fields: &Fields, facing: &Facing, edge: Edge) {
    let (lo, hi) = domain.bounds();
    let mut side = fields.params().size;
    while side < (hi - lo).max_element() {
        side *= 2.0;
    }
    let corner = lo.midpoint(hi) - DVec2::splat(side / 2.0);
    let mut open = vec![(corner, side)];
    while let Some((corner, side)) = open.pop() {
        let middle = corner + DVec2::splat(side / 2.0);
        if side > 1.414 * fields.size(middle) {
            let half = side / 2.0;
            for (x, y) in [(half, half), (0.0, half), (half, 0.0), (0.0, 0.0)] {
                open.push((corner + DVec2::new(x, y), half));
            }
        } else if crowd.gap(middle, BOUNDARY_GAP) >= BOUNDARY_GAP
            && has_room(middle, fields, domain, facing, edge)
        {
            crowd.push(middle);
        }
    }
    if crowd.cells.is_empty()
        && let Some(p) = deepest(domain)
    {
        crowd.push(p);
    }
}
