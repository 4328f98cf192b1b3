//! Cover of an outline by polygons, with scan lines.
//!
//! Between the heights of all corners the borders are straight, so areas are exact wherever polygons do not
//! cross.

use crate::domain::Domain;
use crate::order;
use crate::planar::Space;
use glam::DVec2;

/// Areas as shares of the outline's area.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cover {
    /// The covered share of the outline, 1 for all.
    pub coverage: f64,
    /// Area covered more than once, counted for each extra cover.
    pub overlap: f64,
    /// Area covered outside the outline.
    pub outside: f64,
}

/// Fewest scan lines. If the heights of the corners give fewer, evenly spaced lines are put between them.
const FEWEST_LINES: f64 = 4096.0;
/// About the most scan lines.
const MOST_LINES: f64 = 16384.0;

/// An edge for the scan lines, from above to below.
struct ScanEdge {
    upper: DVec2,
    lower: DVec2,
    /// Change in the number of polygons that cover a point, from left to right across the edge.
    step: i32,
    /// The change from outside (0) to inside the outline (1), from left to right across the edge.
    domain_step: i32,
}

impl ScanEdge {
    fn new([from, to]: [DVec2; 2], of_domain: bool) -> Option<Self> {
        // The inside is in the direction (-dy, dx): to the left of an edge that goes down.
        let (upper, lower, step) = if from.y < to.y {
            (from, to, -1)
        } else {
            (to, from, 1)
        };
        let domain_step = if of_domain { step } else { 0 };
        (upper.y < lower.y).then_some(Self {
            upper,
            lower,
            step: step - domain_step,
            domain_step,
        })
    }

    /// The crossing with the line at height y: the same bits for the same ends, in either direction.
    fn crossing(&self, y: f64) -> f64 {
        let t = (y - self.upper.y) / (self.lower.y - self.upper.y);
        self.upper.x + t * (self.lower.x - self.upper.x)
    }
}

/// Measures polygons given by all their directed edges, with the inside in the direction (-dy, dx).
///
/// Between two heights where edges end, the lengths on a scan line change linearly with its height unless
/// edges cross. So a line midway between any two such heights gives the exact areas of polygons that do not
/// overlap each other or the outline. If edges cross, or more than 16,384 lines would be needed, the result
/// is an approximation, good to about 1e-5.
pub(super) fn cover(domain: &Domain, polygons: impl Iterator<Item = [DVec2; 2]>) -> Cover {
    let mut edges: Vec<ScanEdge> = polygons.filter_map(|e| ScanEdge::new(e, false)).collect();
    // A torus has no outline: the picture is measured instead, with the parts of polygons and images in it.
    let picture = domain.space().period();
    if let Some(side) = picture {
        edges = unrolled(edges, side);
    }
    let outline = domain.segments().iter();
    edges.extend(outline.filter_map(|&s| ScanEdge::new(s, true)));
    order::sort(&mut edges, |e| (order::rank(e.upper.y), 0));
    let mut waiting = edges.iter().peekable();
    // (crossing, edge), kept in order from line to line.
    let mut active: Vec<(f64, &ScanEdge)> = Vec::new();
    let mut lengths = Lengths::default();
    for (y, height) in lines(&edges) {
        active.retain(|(_, e)| e.lower.y > y);
        while let Some(edge) = waiting.next_if(|e| e.upper.y <= y) {
            if edge.lower.y > y {
                active.push((0.0, edge));
            }
        }
        for (x, edge) in &mut active {
            *x = edge.crossing(y);
        }
        // Insertion sort: hardly any edges change places.
        for k in 1..active.len() {
            let mut at = k;
            while at > 0 && active[at - 1].0 > active[at].0 {
                active.swap(at - 1, at);
                at -= 1;
            }
        }
        lengths.add_line(&active, height, picture.is_some());
    }
    lengths.cover()
}

/// On a torus: the edges in all images that are visible in the picture, and the picture's rim as the outline.
fn unrolled(edges: Vec<ScanEdge>, side: f64) -> Vec<ScanEdge> {
    let mut images = Vec::new();
    for shift in Space::torus(side).shifts(1) {
        let shifted = edges.iter().map(|e| ScanEdge {
            upper: e.upper + shift,
            lower: e.lower + shift,
            ..*e
        });
        images.extend(shifted.filter(|e| e.lower.y > 0.0 && e.upper.y < side));
    }
    let (right, left) = (DVec2::new(side, 0.0), DVec2::new(0.0, side));
    let rim = [[right, DVec2::splat(side)], [left, DVec2::ZERO]];
    images.extend(rim.into_iter().filter_map(|s| ScanEdge::new(s, true)));
    images
}

/// Scan lines as (y, the height they represent): midway between the heights of the edges' ends, and at least
/// [`FEWEST_LINES`].
fn lines(edges: &[ScanEdge]) -> Vec<(f64, f64)> {
    let mut heights: Vec<f64> = edges.iter().flat_map(|e| [e.upper.y, e.lower.y]).collect();
    order::sort(&mut heights, |&y| (order::rank(y), 0));
    let (Some(&first), Some(&last)) = (heights.first(), heights.last()) else {
        return Vec::new();
    };
    let (most, least) = ((last - first) / FEWEST_LINES, (last - first) / MOST_LINES);
    let mut lines = Vec::new();
    let mut from = first;
    for to in heights {
        if to - from > least || (to == last && to > from) {
            let parts = ((to - from) / most).ceil();
            let height = (to - from) / parts;
            lines.extend((0..parts as u32).map(|k| (from + (f64::from(k) + 0.5) * height, height)));
            from = to;
        }
    }
    lines
}

/// Areas so far: of the outline, of all polygons (`sum`), of their union, and of the union within the outline (`both`).
#[derive(Default)]
struct Lengths {
    domain: f64,
    sum: f64,
    union: f64,
    both: f64,
}

impl Lengths {
    /// Adds the lengths on a scan line, times the height it represents; with `cropped`, only those within the outline.
    fn add_line(&mut self, crossings: &[(f64, &ScanEdge)], height: f64, cropped: bool) {
        let (mut cells, mut domain) = (0, 0);
        for w in crossings.windows(2) {
            let [(x, edge), (next, _)] = [w[0], w[1]];
            cells += edge.step;
            domain += edge.domain_step;
            if cropped && domain <= 0 {
                continue;
            }
            let area = (next - x) * height;
            self.sum += f64::from(cells.max(0)) * area;
            if cells > 0 {
                self.union += area;
            }
            if domain > 0 {
                self.domain += area;
            }
            if cells > 0 && domain > 0 {
                self.both += area;
            }
        }
    }

    fn cover(&self) -> Cover {
        Cover {
            coverage: self.both / self.domain,
            overlap: (self.sum - self.union) / self.domain,
            outside: (self.union - self.both) / self.domain,
        }
    }
}
