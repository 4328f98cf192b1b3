//! The paper's own search for a body's place (section 4.2.1 to 4.2.3).

use super::settled::Neighbour;
use super::{Body, Shape};
use crate::component::Sphere;
use crate::order::greater;
use glam::DVec3;

/// The cost of a way as long as the range. Our copy of the paper has lost the penalty of eq. (1). This one prefers the
/// shorter of two ways that avoid overlaps equally well.
const WAY: f64 = 0.05;
/// The golden section: the greater part of an interval of length 1.
const SECTION: f64 = 0.618_033_988_749_894_9;

/// Which of the settled bodies the paper's cost, eq. (1), looks at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CostScope {
    /// The one that is nearest to the dart (section 3, step 2).
    Nearest,
    /// All settled bodies that the new one may touch.
    All,
}

impl Neighbour<'_> {
    /// The implicit function of eq. (2) without its offset, in units of R: the depth inside of the nearest sphere,
    /// greater than 0 inside.
    fn depth(&self, p: DVec3) -> f64 {
        let depth = |s: &Sphere| s.radius - p.distance(s.centre);
        self.spheres
            .iter()
            .map(depth)
            .fold(f64::NEG_INFINITY, greater)
            / self.radius
    }
}

/// The search for one body.
pub struct Golden<'a> {
    /// Points of the body's surface in space, while the body is at its dart.
    points: Vec<DVec3>,
    normal: DVec3,
    range: (f64, f64),
    settled: Vec<Neighbour<'a>>,
    /// The number of the settled body that is nearest to the dart.
    nearest: usize,
    offset: f64,
}

impl<'a> Golden<'a> {
    /// The search for a body among settled ones, with the offset T.
    pub fn new(body: &Body, shape: &Shape, settled: Vec<Neighbour<'a>>, offset: f64) -> Self {
        let to_space = |&p: &DVec3| body.at + body.turn * (body.scale * p);
        let away = |k: &usize| settled[*k].place.distance_squared(body.at);
        let nearest = (0..settled.len()).min_by(|a, b| away(a).total_cmp(&away(b)));
        Self {
            points: shape.points.iter().map(to_space).collect(),
            normal: body.normal,
            range: body.range,
            nearest: nearest.unwrap_or(0),
            settled,
            offset,
        }
    }

    /// The place by golden section (section 4.2.2). `None` if a settled body overlaps there by more than `removal`
    /// beyond the offset: eq. (3), over all settled bodies (section 4.2.3).
    pub fn place(&self, iterations: u32, scope: CostScope, removal: f64) -> Option<f64> {
        if self.settled.is_empty() {
            return Some(0.0_f64.clamp(self.range.0, self.range.1));
        }
        let seen = match scope {
            CostScope::Nearest => &self.settled[self.nearest..=self.nearest],
            CostScope::All => &self.settled[..],
        };
        let t = self.minimum(iterations, |t| self.cost(seen, t));
        (self.overlap(&self.settled, t) <= removal).then_some(t)
    }

    /// The greatest value of eq. (2) over all points, when the body has moved by t.
    fn overlap(&self, settled: &[Neighbour], t: f64) -> f64 {
        let way = t * self.normal;
        let deepest = |p: &DVec3| {
            settled
                .iter()
                .map(|s| s.depth(*p + way))
                .fold(f64::NEG_INFINITY, greater)
        };
        self.points
            .iter()
            .map(deepest)
            .fold(f64::NEG_INFINITY, greater)
            - self.offset
    }

    /// The cost of eq. (1): the overlap, and a penalty for the way.
    fn cost(&self, settled: &[Neighbour], t: f64) -> f64 {
        let length = (self.range.1 - self.range.0).max(f64::MIN_POSITIVE);
        self.overlap(settled, t).max(0.0) + WAY * t.abs() / length
    }

    /// The minimum of a function over the range by golden section (Press et al. 1988, Numerical Recipes in C). It may
    /// be only a local minimum.
    fn minimum(&self, iterations: u32, cost: impl Fn(f64) -> f64) -> f64 {
        let (mut lo, mut hi) = self.range;
        let mut inner = [hi - SECTION * (hi - lo), lo + SECTION * (hi - lo)];
        let mut costs = inner.map(&cost);
        for _ in 0..iterations {
            if costs[0] <= costs[1] {
                hi = inner[1];
                inner = [hi - SECTION * (hi - lo), inner[0]];
                costs = [cost(inner[0]), costs[0]];
            } else {
                lo = inner[0];
                inner = [inner[1], lo + SECTION * (hi - lo)];
                costs = [costs[1], cost(inner[1])];
            }
        }
        // The dart itself is a candidate, too: a body without an overlap does not move.
        let found = if costs[0] <= costs[1] {
            inner[0]
        } else {
            inner[1]
        };
        let stay = 0.0_f64.clamp(self.range.0, self.range.1);
        if cost(stay) <= costs[0].min(costs[1]) {
            stay
        } else {
            found
        }
    }
}
