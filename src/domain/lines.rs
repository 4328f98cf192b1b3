//! Constraint lines: cut where they cross, clipped to the inside, and what is asked of them.
//!
//! Itoh, Miyata, Shimada (2003): "boundary edges can be defined at a set of user-specified line
//! segments inside the domain".

use super::candidates::CandidateGrid;
use super::parts::Parts;
use super::squares::Squares;
use super::{Domain, closest_on_segment};
use crate::order;
use crate::planar::{on_grain, orientation};
use glam::DVec2;

/// Points nearer to each other, or to a line or the outline, than this part of the larger side of
/// the box around the outline are one, or lie on it.
const TOUCH: f64 = 1.0 / 2048.0;
/// Parts smaller than the square of this part of that side are joined to a neighbour.
const SMALLEST: f64 = 1.0 / 128.0;
/// No more crossings than this are looked for.
const MOST_NODES: usize = 4096;
/// A piece that runs beside the outline at less than this slope is part of the outline.
const BESIDE: f64 = 0.1;

/// The constraint lines of a domain.
#[derive(Clone, Debug)]
pub(super) struct Network {
    /// What is inside of each line: open polylines, or closed with the first point repeated.
    pub lines: Vec<Vec<DVec2>>,
    /// Their segments.
    pub segments: Vec<[DVec2; 2]>,
    /// The segments, then their other images up to a side away.
    pub images: Vec<[DVec2; 2]>,
    /// Where lines meet the outline: the outline's segment and the place.
    pub touches: Vec<(usize, DVec2)>,
    pub parts: Parts,
    grid: CandidateGrid,
    squares: Squares,
}

impl Network {
    /// Nothing where no piece of a line lies inside.
    pub fn new(domain: &Domain, lines: &[Vec<DVec2>]) -> Option<Self> {
        let (mut lines, touches) = Cutter::new(domain, lines).cut();
        let (lo, hi) = domain.bounds();
        let largest = (hi - lo).max_element();
        let least = (SMALLEST * largest) * (SMALLEST * largest);
        let (segments, parts) = loop {
            let segments: Vec<[DVec2; 2]> = lines
                .iter()
                .flat_map(|line| line.windows(2).map(|w| [w[0], w[1]]))
                .collect();
            if segments.is_empty() {
                return None;
            }
            let parts = Parts::new(domain, &touches, &segments);
            match parts.sliver(domain, least) {
                Some(place) => take_out(domain, &mut lines, place),
                None => break (segments, parts),
            }
        };
        let space = domain.space();
        let images: Vec<[DVec2; 2]> = space.repeated(&segments, 1).collect();
        // The ways that are asked for may leave the picture so far.
        let margin = space.overhang();
        Some(Self {
            parts,
            grid: CandidateGrid::new(&images),
            squares: Squares::new((lo, hi), margin, largest / 64.0, &images, 0.0),
            lines,
            segments,
            images,
            touches,
        })
    }

    /// Does the way from a to b cross a line?
    pub fn crosses(&self, a: DVec2, b: DVec2) -> bool {
        self.squares.any(a, b, |index| {
            let [c, d] = self.images[index];
            crosses(a, b, c, d)
        })
    }

    /// The number among `images` of the segment that the way from a to b crosses first.
    pub fn first_crossed(&self, a: DVec2, b: DVec2) -> Option<usize> {
        let mut best = (f64::INFINITY, None);
        for (index, &[c, d]) in self.images.iter().enumerate() {
            if crosses(a, b, c, d) {
                let (sa, sb) = (orientation(c, d, a), orientation(c, d, b));
                let at = sa / (sa - sb);
                if at < best.0 {
                    best = (at, Some(index));
                }
            }
        }
        best.1
    }

    /// The squared distance, the place and the number among `images` of the nearest segment.
    pub fn nearest(&self, p: DVec2) -> (f64, DVec2, usize) {
        self.grid.nearest(&self.images, p)
    }
}

/// Takes the segment at a place out of the lines.
fn take_out(domain: &Domain, lines: &mut Vec<Vec<DVec2>>, place: DVec2) {
    let mut nearest = (f64::INFINITY, 0, 0);
    for (index, line) in lines.iter().enumerate() {
        for (k, w) in line.windows(2).enumerate() {
            let middle = w[0].midpoint(w[1]);
            let p = middle + domain.space().shortest(place - middle);
            let distance = closest_on_segment(p, w[0], w[1]).distance(p);
            if distance < nearest.0 {
                nearest = (distance, index, k);
            }
        }
    }
    let (_, index, k) = nearest;
    let rest = lines[index].split_off(k + 1);
    lines.insert(index + 1, rest);
    lines.retain(|line| line.len() > 1);
}

/// Do a to b and the segment c to d cross? Not where a or b lies on it; its ends count so that a way
/// through a point that two segments share crosses one of them.
pub(crate) fn crosses(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> bool {
    if a.min(b).cmpgt(c.max(d)).any() || c.min(d).cmpgt(a.max(b)).any() {
        return false;
    }
    let (sa, sb) = (orientation(c, d, a), orientation(c, d, b));
    let apart = (sa > 0.0 && sb < 0.0) || (sa < 0.0 && sb > 0.0);
    apart && (orientation(a, b, c) >= 0.0) != (orientation(a, b, d) >= 0.0)
}

/// Cuts lines.
struct Cutter<'a> {
    domain: &'a Domain,
    near: f64,
    /// All places where anything begins, ends or crosses; none near another.
    nodes: Vec<DVec2>,
    lines: Vec<Vec<DVec2>>,
    touches: Vec<(usize, DVec2)>,
}

/// A segment of a line with the places where it is cut.
struct Piece {
    ends: [DVec2; 2],
    line: usize,
    cuts: Vec<DVec2>,
}

impl Piece {
    fn cut(&mut self, p: DVec2) {
        if !self.ends.contains(&p) {
            self.cuts.push(p);
        }
    }
}

impl<'a> Cutter<'a> {
    /// Points near each other, or near the outline, are drawn together.
    fn new(domain: &'a Domain, lines: &[Vec<DVec2>]) -> Self {
        let (lo, hi) = domain.bounds();
        let mut cutter = Self {
            domain,
            near: TOUCH * (hi - lo).max_element(),
            nodes: Vec::new(),
            lines: Vec::new(),
            touches: Vec::new(),
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

    /// The node at a place, a new one where there is none near: on the outline where that is near, so
    /// that no node is so near to it without lying on it.
    fn node(&mut self, p: DVec2) -> DVec2 {
        let foot = self.domain.nearest(p);
        let on_outline = foot.distance.abs() <= self.near;
        let p = on_grain(if on_outline { foot.point } else { p });
        for &node in &self.nodes {
            // The node's image nearest to the place: exact, as all lies on the grain.
            let by = node - p;
            let image = p + self.domain.space().shortest(by);
            if image.distance(p) <= self.near {
                return image;
            }
        }
        self.nodes.push(p);
        if on_outline {
            self.touches.push((foot.segment, p));
        }
        p
    }

    fn cut(mut self) -> (Vec<Vec<DVec2>>, Vec<(usize, DVec2)>) {
        let mut pieces: Vec<Piece> = Vec::new();
        for (line, points) in self.lines.iter().enumerate() {
            pieces.extend(points.windows(2).map(|w| Piece {
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
        // An image of a line may cross another from two pictures away.
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
        (self.chains(&mut pieces), self.touches)
    }

    /// Cuts a piece and the image of another where they meet.
    fn cut_pair(&mut self, pieces: &mut [Piece], k: usize, j: usize, shift: DVec2) {
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

    /// The node where two segments cross.
    fn crossing(&mut self, [a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> Option<DVec2> {
        if self.nodes.len() >= MOST_NODES || !crosses(a, b, c, d) {
            return None;
        }
        let (sa, sb) = (orientation(c, d, a), orientation(c, d, b));
        Some(self.node(a + (b - a) * (sa / (sa - sb))))
    }

    /// The pieces inside, joined to lines again.
    fn chains(&self, pieces: &mut [Piece]) -> Vec<Vec<DVec2>> {
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

    /// Does a piece between two cuts lie inside, and not along the outline?
    fn is_inside(&self, from: DVec2, to: DVec2) -> bool {
        let depth = self.domain.nearest(from.midpoint(to)).distance;
        depth > self.near.min(BESIDE * from.distance(to))
    }
}
