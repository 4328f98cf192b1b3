//! Clips constraint lines to the inside of the outline and cuts them where they cross.
//!
//! Each domain does this once, so that all later stages see the same pieces.

use super::Domain;
use crate::order;
use crate::planar::{closest_on_segment, crosses, on_grain, orientation};
use glam::DVec2;

/// Points are near if their distance is at most this share of the longer side of the bounding box. Points near each
/// other are merged, points near the outline are moved onto it, and a line near a point is cut there.
const TOUCH: f64 = 1.0 / 2048.0;
/// With this many nodes, no further crossings are cut.
const MOST_NODES: usize = 4096;
/// A piece runs along the outline, and is dropped, if its midpoint is near the outline and nearer than this share of
/// the piece's length.
const BESIDE: f64 = 0.1;

/// Polylines.
pub(super) type Lines = Vec<Vec<DVec2>>;

/// The parts of lines inside the outline, cut wherever lines meet, and the places where they meet the
/// outline, each with the number of the outline's segment.
pub(super) fn clip(domain: &Domain, lines: &[Vec<DVec2>]) -> (Lines, Vec<(usize, DVec2)>) {
    Cutter::new(domain, lines).cut()
}

/// Cuts lines at nodes.
struct Cutter<'a> {
    domain: &'a Domain,
    near: f64,
    /// All places where a line begins, ends or crosses; no two are near each other.
    nodes: Vec<DVec2>,
    lines: Vec<Vec<DVec2>>,
    junctions: Vec<(usize, DVec2)>,
}

/// A segment of a line with the places where it is cut.
struct CutSegment {
    ends: [DVec2; 2],
    line: usize,
    cuts: Vec<DVec2>,
}

impl CutSegment {
    fn cut(&mut self, p: DVec2) {
        if !self.ends.contains(&p) {
            self.cuts.push(p);
        }
    }
}

impl<'a> Cutter<'a> {
    /// Merges points near each other, and moves points near the outline onto it.
    fn new(domain: &'a Domain, lines: &[Vec<DVec2>]) -> Self {
        let (lo, hi) = domain.bounds();
        let mut cutter = Self {
            domain,
            near: TOUCH * (hi - lo).max_element(),
            nodes: Vec::new(),
            lines: Vec::new(),
            junctions: Vec::new(),
        };
        for line in lines {
            let mut points: Vec<DVec2> = Vec::with_capacity(line.len());
            for &p in line {
                let p = cutter.node(p);
                if points.last() != Some(&p) {
                    points.push(p);
                }
            }
            cutter.lines.push(points);
        }
        cutter
    }

    /// The node at a place; creates one if none is near. A new node near the outline is put on it, so a node
    /// is either on the outline or well away from it.
    fn node(&mut self, p: DVec2) -> DVec2 {
        let wall = self.domain.nearest(p);
        let on_outline = wall.distance.abs() <= self.near;
        let p = on_grain(if on_outline { wall.point } else { p });
        for &node in &self.nodes {
            // The node's image nearest to the place. This is exact because both lie on the grain.
            let by = node - p;
            let image = p + self.domain.space().shortest(by);
            if image.distance(p) <= self.near {
                return image;
            }
        }
        self.nodes.push(p);
        if on_outline {
            self.junctions.push((wall.segment, p));
        }
        p
    }

    fn cut(mut self) -> (Vec<Vec<DVec2>>, Vec<(usize, DVec2)>) {
        let mut pieces: Vec<CutSegment> = Vec::new();
        for (line, points) in self.lines.iter().enumerate() {
            pieces.extend(points.windows(2).map(|w| CutSegment {
                ends: [w[0], w[1]],
                line,
                cuts: Vec::new(),
            }));
        }
        let domain = self.domain;
        for piece in &mut pieces {
            for &outline in domain.segments() {
                if let Some(p) = self.crossing(piece.ends, outline) {
                    piece.cut(p);
                }
            }
        }
        // An image of a line may cross another line from two pictures away.
        let shifts: Vec<DVec2> = domain.space().shifts(2).collect();
        for k in 0..pieces.len() {
            for j in 0..=k {
                for &shift in &shifts {
                    if j != k || shift != DVec2::ZERO {
                        self.cut_pair(&mut pieces, k, j, shift);
                    }
                }
            }
        }
        (self.chains(&mut pieces), self.junctions)
    }

    /// Cuts a piece and an image of another piece where they meet.
    fn cut_pair(&mut self, pieces: &mut [CutSegment], k: usize, j: usize, shift: DVec2) {
        let [a, b] = pieces[k].ends;
        let [c, d] = pieces[j].ends.map(|p| p + shift);
        let near = DVec2::splat(self.near);
        if (a.min(b) - near).cmpgt(c.max(d)).any() || (c.min(d) - near).cmpgt(a.max(b)).any() {
            return;
        }
        let on = |p: DVec2, [a, b]: [DVec2; 2]| {
            p != a && p != b && closest_on_segment(p, a, b).distance(p) <= self.near
        };
        for p in [c, d].into_iter().filter(|&p| on(p, [a, b])) {
            pieces[k].cut(p);
        }
        for p in [a, b].into_iter().filter(|&p| on(p, [c, d])) {
            pieces[j].cut(p - shift);
        }
        if let Some(p) = self.crossing([a, b], [c, d]) {
            if p != c && p != d {
                pieces[k].cut(p);
            }
            if p != a && p != b {
                pieces[j].cut(p - shift);
            }
        }
    }

    /// The node at the crossing of two segments.
    fn crossing(&mut self, [a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> Option<DVec2> {
        if self.nodes.len() >= MOST_NODES || !crosses(a, b, c, d) {
            return None;
        }
        let (sa, sb) = (orientation(c, d, a), orientation(c, d, b));
        Some(self.node(a + (b - a) * (sa / (sa - sb))))
    }

    /// Joins the pieces inside the outline to polylines again.
    fn chains(&self, pieces: &mut [CutSegment]) -> Vec<Vec<DVec2>> {
        let mut chains: Vec<Vec<DVec2>> = Vec::new();
        let mut known: Vec<[DVec2; 2]> = Vec::new();
        let mut last = None;
        for piece in pieces {
            let [a, b] = piece.ends;
            order::sort(&mut piece.cuts, |p| (order::rank(p.distance_squared(a)), 0));
            let mut from = a;
            for to in piece.cuts.iter().copied().chain([b]) {
                if from == to {
                    continue;
                }
                let ends = [from, to];
                let twice = known.contains(&ends) || known.contains(&[to, from]);
                if !twice && self.is_inside(from, to) {
                    known.push(ends);
                    match chains.last_mut() {
                        Some(chain) if last == Some((piece.line, from)) => chain.push(to),
                        _ => chains.push(vec![from, to]),
                    }
                    last = Some((piece.line, to));
                }
                from = to;
            }
        }
        chains
    }

    /// Whether a piece between two cuts lies inside and not along the outline.
    fn is_inside(&self, from: DVec2, to: DVec2) -> bool {
        let depth = self.domain.nearest(from.midpoint(to)).distance;
        depth > self.near.min(BESIDE * from.distance(to))
    }
}
