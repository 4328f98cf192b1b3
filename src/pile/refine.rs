//! The refinement: bodies settle one after the other along the surface's normal (section 4.2).

use super::darts::scan_key;
use super::golden::{CostScope, Golden};
use super::settled::Settled;
use super::sliding::Sliding;
use super::sliding_line::SlidingLine;
use super::{Body, Dart, Fate, Kind, Wall};
use crate::component::Sphere;
use crate::order::{greater, rank};
use crate::random::{Purpose, Random};
use crate::trimesh::{Search, TriMesh};
use glam::DVec3;
use std::rc::Rc;
use std::sync::Arc;

/// Orientations that are tried at a dart until the body passes no wall.
const WALL_TRIES: usize = 12;
/// How far a body may pass a wall, in R.
const WALL_SLACK: f64 = 0.04;
/// The longest refinement range of inner layers, in units of d. It lies inwards only.
const LAYER_RANGE: f64 = 0.6;
/// The farthest that walls may push a body from its dart, in diagonals of the body. Farther away it would float.
const PUSHED: f64 = 0.5;
/// A ray along the normal starts this far from the surface, in R.
const SKIN: f64 = 1e-3;

/// Which body settles next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SettlingOrder {
    /// A random order, so that no period shows (section 4.2).
    Random,
    /// Row by row, which shows as rows.
    Scan,
}

/// How a body's place is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// The place nearest to the dart at which no spheres overlap by more than the offset, by intervals.
    Exact,
    /// The paper's search: golden section over the cost of eq. (1), then the test of eq. (3) over all settled bodies.
    Golden {
        /// The number of iterations; the paper finds 15 enough.
        iterations: u32,
        /// The bodies that the cost looks at.
        scope: CostScope,
    },
}

/// The parameters of the refinement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RefineParams {
    /// T, the overlap that counts as touching, in R of the smaller body (eq. 2); 0 to below 1.
    pub offset: f64,
    /// D, the overlap beyond T at which a body is removed, in R of the smaller body (eq. 3); at least 0.
    pub removal: f64,
    /// The order within a type.
    pub order: SettlingOrder,
    /// Whether the types settle one after the other, the largest first. If not, all types are mixed.
    pub is_large_first: bool,
    /// New orientations that are tried before a body is removed. The paper has none.
    pub retries: u32,
    /// How the place is found.
    pub method: Method,
    /// Seeds the order, sizes, variants and orientations of bodies.
    pub seed: u64,
}

/// Bodies that settle one by one.
pub struct Refining {
    kinds: Arc<[Kind]>,
    walls: Vec<Wall>,
    params: RefineParams,
    bodies: Vec<Body>,
    /// The bodies in the order in which they settle.
    order: Vec<u32>,
    next: usize,
    settled: Settled,
    /// All bodies as a finished run has left them, if they are settled again.
    known: Option<Rc<[Body]>>,
}

impl Refining {
    /// Begins with one body for each dart; `stays` tells which darts are left after merging.
    pub fn new(
        mesh: &TriMesh,
        darts: &[Dart],
        stays: &[bool],
        kinds: Arc<[Kind]>,
        walls: Vec<Wall>,
        params: RefineParams,
    ) -> Self {
        let bodies: Vec<Body> = (0u32..)
            .zip(darts)
            .map(|(k, dart)| Body::waiting(k, dart, stays[k as usize]))
            .collect();
        let order = order(&bodies, &kinds, &params);
        let settled = Settled::new(mesh, &kinds);
        Self {
            kinds,
            walls,
            params,
            bodies,
            order,
            next: 0,
            settled,
            known: None,
        }
    }

    /// Settles the bodies as a finished run with the same mesh, darts, kinds, walls and parameters did, without any
    /// search. `known` has its [`Refining::bodies`].
    pub fn recalling(self, known: Option<Rc<[Body]>>) -> Self {
        Self { known, ..self }
    }

    /// All bodies, in the order of their darts.
    pub fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// The numbers of all bodies handled so far, in order.
    pub fn history(&self) -> &[u32] {
        &self.order[..self.next]
    }

    /// Lets at most `amount` bodies settle. Returns whether no body is left.
    pub fn advance(&mut self, mesh: &TriMesh, search: &Search, amount: usize) -> bool {
        let end = self.order.len().min(self.next + amount.max(1));
        for k in self.next..end {
            let number = self.order[k] as usize;
            let settled = match &self.known {
                Some(known) => known[number],
                None => self.settle(mesh, search, self.bodies[number]),
            };
            if settled.fate == Fate::Kept {
                self.settled.add(&settled, &self.kinds);
            }
            self.bodies[number] = settled;
        }
        self.next = end;
        end == self.order.len()
    }

    fn settle(&self, mesh: &TriMesh, search: &Search, mut body: Body) -> Body {
        let kind = &self.kinds[body.kind as usize];
        let mut random = Random::new(self.params.seed, Purpose::Turn, u64::from(body.dart));
        body.shape = random.below(kind.shapes.len()) as u32;
        body.scale = kind.scale * (1.0 + kind.jitter * random.signed());
        let whole = range(mesh, search, &body, kind);
        body.fate = Fate::Walls;
        let mut fits = 0;
        let mut line = None;
        for _ in 0..WALL_TRIES + self.params.retries as usize {
            body.turn = kind.turn.draw(body.normal, &mut random);
            let Some(range) = self.before_walls(&body, whole) else {
                continue;
            };
            body.range = range;
            body.fate = Fate::Removed;
            if let Some(t) = self.place(&body, whole, &mut line) {
                body.t = t;
                body.fate = Fate::Kept;
                break;
            }
            fits += 1;
            if fits > self.params.retries {
                break;
            }
        }
        body
    }

    /// The part of the range in which the body passes no wall; `None` if it is empty or too far from the dart.
    fn before_walls(&self, body: &Body, mut range: (f64, f64)) -> Option<(f64, f64)> {
        if self.walls.is_empty() {
            return Some(range);
        }
        let shape = body.shape(&self.kinds);
        let slack = WALL_SLACK * body.radius(&self.kinds);
        let ball = (body.at, shape.bound * body.scale);
        let is_free = |wall: &Wall| wall.is_free(ball, body.normal, range);
        let walls: Vec<&Wall> = self.walls.iter().filter(|wall| !is_free(wall)).collect();
        if walls.is_empty() {
            return Some(range);
        }
        for &point in &shape.points {
            let at = body.at + body.turn * (body.scale * point);
            for wall in &walls {
                range = wall.narrowed((at, body.normal), slack, range);
            }
            if range.0 > range.1 {
                return None;
            }
        }
        let pushed = 0.0_f64.clamp(range.0, range.1).abs();
        (pushed <= PUSHED * shape.diagonal * body.scale).then_some(range)
    }

    /// The place t of a body in its range, if there is one. `line` is kept for the next orientation.
    fn place(&self, body: &Body, whole: (f64, f64), line: &mut Option<SlidingLine>) -> Option<f64> {
        match self.params.method {
            Method::Exact => {
                let line = line.get_or_insert_with(|| self.line(body, whole));
                self.exact_place(body, line)
            }
            Method::Golden { iterations, scope } => {
                let shape = body.shape(&self.kinds);
                let near = self
                    .settled
                    .near(body, shape.bound * body.scale, body.range);
                let golden = Golden::new(body, shape, near, self.params.offset);
                golden.place(iterations, scope, self.params.removal)
            }
        }
    }

    fn line(&self, body: &Body, whole: (f64, f64)) -> SlidingLine {
        let shape = body.shape(&self.kinds);
        let bound = shape.bound * body.scale;
        let core = shape.spheres.first().filter(|s| s.centre == DVec3::ZERO);
        let core = core.map_or(0.0, |s| body.scale * s.radius);
        let reach = |s: &Sphere| s.centre.length() + s.radius;
        let reach = shape.spheres.iter().map(reach).fold(0.0, greater);
        let size = (body.radius(&self.kinds), core, body.scale * reach);
        SlidingLine::new(body, whole, size, &self.settled.near(body, bound, whole))
    }

    /// The place nearest to the dart at which spheres overlap by at most T, or else by at most T + D.
    fn exact_place(&self, body: &Body, line: &SlidingLine) -> Option<f64> {
        let RefineParams {
            offset, removal, ..
        } = self.params;
        let deeper = offset + removal;
        let may_touch = line.blocked(body.range, offset, 0);
        let may_overlap = || line.blocked(body.range, deeper, 1);
        if may_touch.nearest_to_zero().is_none() && may_overlap().nearest_to_zero().is_none() {
            return None;
        }
        let mut sliding = Sliding::new(line, body, &body.shape(&self.kinds).spheres);
        let touching = sliding.free_place(offset, may_touch);
        let mut overlapping = || sliding.free_place(deeper, may_overlap());
        touching.or_else(|| if removal > 0.0 { overlapping() } else { None })
    }
}

/// The bodies that wait, in the order in which they settle: layers from the outer one, types from the largest one,
/// then by chance or in scan order.
fn order(bodies: &[Body], kinds: &[Kind], params: &RefineParams) -> Vec<u32> {
    let size = |body: &Body| match params.is_large_first {
        true => rank(-kinds[body.kind as usize].diagonal()),
        false => 0,
    };
    let widest = kinds.iter().map(Kind::spacing).fold(0.0, f64::max);
    let place = |body: &Body| match params.order {
        SettlingOrder::Random => (
            Random::new(params.seed, Purpose::Order, u64::from(body.dart)).bits(),
            0,
        ),
        SettlingOrder::Scan => scan_key(body.at, widest),
    };
    let waiting = bodies.iter().filter(|b| b.fate == Fate::Waiting);
    let mut order: Vec<u32> = waiting.map(|b| b.dart).collect();
    order.sort_by_cached_key(|&k| {
        let body = &bodies[k as usize];
        (body.layer, size(body), place(body), k)
    });
    order
}

/// The refinement range of a body: l d long, with the share α inside, and not beyond the middle of the way to the next
/// surface, so that bodies do not cross the shape (section 4.2.2).
fn range(mesh: &TriMesh, search: &Search, body: &Body, kind: &Kind) -> (f64, f64) {
    let (length, inward) = match body.layer {
        0 => (kind.range, kind.inward),
        _ => (kind.range.min(LAYER_RANGE), 1.0),
    };
    let length = length * kind.diagonal();
    let room = |along: DVec3, wanted: f64| {
        let from = body.at + SKIN * kind.radius() * along;
        // A surface that is farther than twice the wanted way does not matter.
        let hit = search.ray_within(mesh, (from, along), 2.0 * wanted, |_| true);
        hit.map_or(wanted, |hit| wanted.min(0.5 * hit.along))
    };
    let inside = if inward > 0.0 {
        room(-body.normal, inward * length)
    } else {
        0.0
    };
    let outside = if inward < 1.0 {
        room(body.normal, (1.0 - inward) * length)
    } else {
        0.0
    };
    (-inside, outside)
}
