//! The constraint lines of a domain, and queries about them.
//!
//! Itoh, Miyata, Shimada (2003): "boundary edges can be defined at a set of user-specified line
//! segments inside the domain".

use super::candidates::CandidateGrid;
use super::clip::clip;
use super::parts::Parts;
use super::segment_grid::SegmentGrid;
use super::{Domain, Nearest};
use crate::planar::{closest_on_segment, crosses, orientation};
use glam::DVec2;

/// Parts smaller than a square of this side are joined to a neighbour; the side is in longer sides of the bounding box.
const SMALLEST: f64 = 1.0 / 128.0;

/// The constraint lines of a domain.
#[derive(Clone, Debug)]
pub(super) struct Network {
    /// The parts of the lines inside the outline. Each is a polyline, closed if its first point is repeated at the end.
    pub lines: Vec<Vec<DVec2>>,
    /// The segments of `lines`, line after line.
    pub segments: Vec<[DVec2; 2]>,
    /// The segments; on a torus, then their images up to one side away.
    pub images: Vec<[DVec2; 2]>,
    /// Junctions of lines and outline: the number of the outline's segment and the place.
    pub junctions: Vec<(usize, DVec2)>,
    pub parts: Parts,
    /// Finds the image nearest to a place; `passing` finds the images near a path.
    candidates: CandidateGrid,
    passing: SegmentGrid,
}

impl Network {
    /// `None` if no piece of a line lies inside.
    pub fn new(domain: &Domain, lines: &[Vec<DVec2>]) -> Option<Self> {
        let (mut lines, junctions) = clip(domain, lines);
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
            let parts = Parts::new(domain, &junctions, &segments);
            match parts.sliver(domain, least) {
                Some(place) => take_out(domain, &mut lines, place),
                None => break (segments, parts),
            }
        };
        let space = domain.space();
        let images: Vec<[DVec2; 2]> = space.repeated(&segments, 1).collect();
        // Queried paths may leave the picture by this much.
        let margin = space.overhang();
        Some(Self {
            parts,
            candidates: CandidateGrid::new(&images),
            passing: SegmentGrid::new((lo, hi), margin, largest / 64.0, &images, 0.0),
            lines,
            segments,
            images,
            junctions,
        })
    }

    /// Whether the path from a to b crosses a line.
    pub fn crosses(&self, a: DVec2, b: DVec2) -> bool {
        self.passing.any(a, b, |index| {
            let [c, d] = self.images[index];
            crosses(a, b, c, d)
        })
    }

    /// The index in `images` of the first segment that the path from a to b crosses.
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

    /// The squared distance, the closest point and the index in `images` of the nearest segment.
    pub fn nearest(&self, p: DVec2) -> (f64, DVec2, usize) {
        self.candidates.nearest(&self.images, p)
    }
}

/// Removes the segment nearest to a place from the lines, and divides its line there.
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

impl Domain {
    /// The parts of the constraint lines inside the outline. Each is a polyline, closed if the first point is
    /// repeated at the end. Lines meet each other and the outline only at their points.
    pub fn lines(&self) -> &[Vec<DVec2>] {
        self.network.as_ref().map_or(&[], |n| &n.lines)
    }

    /// The segments of [`Domain::lines`], line after line.
    pub fn line_segments(&self) -> &[[DVec2; 2]] {
        self.network.as_ref().map_or(&[], |n| &n.segments)
    }

    /// The junctions of constraint lines and outline: the number of the outline's segment, and the place.
    pub fn junctions(&self) -> &[(usize, DVec2)] {
        self.network.as_ref().map_or(&[], |n| &n.junctions)
    }

    /// The closest point on a constraint line; `None` without lines. `distance` is positive on both sides,
    /// `inward` points away from the line, and `segment` counts [`Domain::line_segments`].
    pub fn nearest_line(&self, p: DVec2) -> Option<Nearest> {
        let network = self.network.as_ref()?;
        let wrapped = self.space.wrap(p);
        let (square, point, segment) = network.nearest(wrapped);
        let [a, b] = network.images[segment];
        let (distance, tangent) = (square.sqrt(), (b - a).normalize());
        let inward = if distance > 1e-9 {
            (wrapped - point) / distance
        } else {
            tangent.perp()
        };
        Some(Nearest {
            distance,
            point: point + (p - wrapped),
            inward,
            tangent,
            segment: segment % network.segments.len(),
        })
    }

    /// Whether the straight path from a to b crosses a constraint line. On a torus b has to be the image nearest to a
    /// ([`super::Space::shortest`]), at most half a side away.
    #[inline]
    pub fn crosses_line(&self, a: DVec2, b: DVec2) -> bool {
        let Some(network) = &self.network else {
            return false;
        };
        let from = self.space.wrap(a);
        network.crosses(from, b - (a - from))
    }

    /// The first segment of a constraint line that the straight path from a to b crosses.
    pub(crate) fn line_between(&self, a: DVec2, b: DVec2) -> Option<[DVec2; 2]> {
        let network = self.network.as_ref()?;
        let from = self.space.wrap(a);
        let shift = a - from;
        let index = network.first_crossed(from, b - shift)?;
        Some(network.images[index].map(|p| p + shift))
    }

    /// Appends the constraint lines' segments, with their images on a torus, to a list of walls; for each,
    /// tells which of its ends lie on the outline.
    pub(super) fn line_walls(&self, walls: &mut Vec<[DVec2; 2]>) -> Vec<[bool; 2]> {
        let Some(network) = &self.network else {
            return Vec::new();
        };
        walls.extend(&network.images);
        let on_outline = |p: DVec2| network.junctions.iter().any(|&(_, at)| at == p);
        let ends = network.images.iter().map(|s| s.map(on_outline));
        ends.collect()
    }

    /// The number of parts: islands, divided further by constraint lines.
    pub fn parts(&self) -> usize {
        let network = self.network.as_ref();
        network.map_or(self.islands().len(), |n| n.parts.count().max(1))
    }

    /// The part that contains a point. Parts are numbered from 0 by their topmost points, from the left at
    /// equal heights. A point on a line belongs to the lowest-numbered part there, a point outside to the
    /// nearest part.
    pub fn part(&self, p: DVec2) -> usize {
        let Some(network) = &self.network else {
            return self.island(p);
        };
        let p = self.space.wrap(p);
        if let Some(part) = network.parts.at(p) {
            return part;
        }
        let near = self.nearest(p);
        let inside = [1e-3, 1e-2, 0.1].map(|step| near.point + step * near.inward);
        inside
            .into_iter()
            .find_map(|q| network.parts.at(q))
            .unwrap_or(0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn on_a_torus_lines_part_what_the_way_to_an_image_crosses() {
        let p = |x: f64, y: f64| DVec2::new(x, y);
        let torus = Domain::torus(100.0, &[vec![p(50.0, 5.0), p(50.0, 95.0)]]);
        assert!(torus.crosses_line(p(45.0, 20.0), p(55.0, 20.0)));
        assert!(torus.crosses_line(p(145.0, 20.0), p(155.0, 20.0)));
        let (a, b) = (p(4.0, 20.0), p(96.0, 20.0));
        assert!(!torus.crosses_line(a, a + torus.space().shortest(b - a)));
        assert_eq!(torus.line_between(a, p(-4.0, 20.0)), None);
        let [a, b] = torus.line_between(p(145.0, 20.0), p(155.0, 20.0)).unwrap();
        assert_eq!((a.x, b.x), (150.0, 150.0));
    }
}
