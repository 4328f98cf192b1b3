//! Medial balls of a closed mesh: the largest balls inside it at many places.

use crate::random::{Purpose, Random};
use crate::trimesh::search::{NearestWalk, nearest_in};
use crate::trimesh::{Search, SurfacePoint, TriMesh};
use glam::DVec3;

/// A ball inside a component.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its centre, in the component's units.
    pub centre: DVec3,
    /// Its radius.
    pub radius: f64,
}

/// A sample of the surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct SurfaceSample {
    pub at: DVec3,
    /// The outward unit normal.
    pub normal: DVec3,
}

/// The most steps by which a ball shrinks.
const STEPS: usize = 30;
/// A ball is done when nothing is nearer to its centre than this share of its radius.
const TOUCHES: f64 = 0.99;
/// Radii are less than the exact distance by this factor, so balls lie strictly inside.
const INSIDE: f64 = 1.0 - 1e-9;
/// Searches reach farther by this factor, so that rounding errors lose nothing.
pub(super) const WIDER: f64 = 1.0 + 1e-6;
/// A smooth normal is used if its cosine with the triangle's normal is above this; else the triangle's normal is.
const SMOOTH: f64 = 0.9;
/// Two directions with at least this cosine count as the same.
const STRAIGHT: f64 = 1.0 - 1e-12;

/// A closed mesh with its search tree.
#[derive(Clone, Copy)]
pub(super) struct Inside<'a> {
    pub mesh: &'a TriMesh,
    pub search: &'a Search,
    /// The least radius of a ball: smaller ones fill nothing.
    pub least: f64,
}

impl Inside<'_> {
    /// Whether a ball around a point can be larger than the least one. Each triangle that is looked at takes one off
    /// `amount`.
    pub fn has_room(&self, centre: DVec3, amount: &mut usize) -> bool {
        let is_near = |t: u32| {
            *amount = amount.saturating_sub(1);
            let at = nearest_in(self.mesh.corners(t), centre);
            at.distance(centre) * INSIDE <= self.least
        };
        !self.search.any_within(centre, self.least * WIDER, is_near)
    }

    fn ball_at(&self, centre: DVec3, nearest: SurfacePoint) -> Option<Sphere> {
        let radius = nearest.at.distance(centre) * INSIDE;
        if radius <= self.least {
            return None;
        }
        self.holds(centre, &nearest)?
            .then_some(Sphere { centre, radius })
    }

    /// Whether a point lies inside of the mesh. If the nearest place lies straight above or below its triangle, the
    /// side of that triangle decides. Near an edge or a vertex, the first triangle on a ray from the point decides, as
    /// the surface is closed and does not cross itself.
    fn holds(&self, centre: DVec3, nearest: &SurfacePoint) -> Option<bool> {
        let outward = |triangle: u32, way: DVec3| self.mesh.face_normal(triangle).dot(way);
        let way = nearest.at - centre;
        let out = outward(nearest.triangle, way);
        if out.abs() >= STRAIGHT * way.length() {
            return Some(out > 0.0);
        }
        let [a, b, c] = self.mesh.corners(nearest.triangle);
        let along = (a + b + c) / 3.0 - centre;
        let hit = self.search.ray(self.mesh, centre, along, |_| true)?;
        Some(outward(hit.point.triangle, along) > 0.0)
    }
}

/// The search for one ball, which can be cut into slices: in the middle of a round body, each step looks at all
/// triangles.
pub(super) struct BallSearch {
    centre: DVec3,
    /// The sample that a medial ball touches, and the ball's radius.
    touched: Option<(SurfaceSample, f64)>,
    /// How often the ball may still shrink.
    steps: usize,
    walk: NearestWalk,
}

impl BallSearch {
    /// Starts the search for the largest ball around a point.
    pub fn around(centre: DVec3) -> Self {
        Self {
            centre,
            touched: None,
            steps: 0,
            walk: NearestWalk::new(centre, f64::INFINITY),
        }
    }

    /// Starts the search for the medial ball that touches the surface at a sample (Ma, Bae, Choi 2012, 3D Medial Axis
    /// Point Approximation Using Nearest Neighbors and the Normal Field): a ball there shrinks until nothing is inside.
    /// `largest` is the radius to begin with.
    pub fn medial(sample: SurfaceSample, largest: f64) -> Self {
        let centre = sample.at - largest * sample.normal;
        Self {
            centre,
            touched: Some((sample, largest)),
            steps: STEPS,
            walk: NearestWalk::new(centre, TOUCHES * largest),
        }
    }

    /// Goes on until `amount` is used up, see [`NearestWalk::advance`]. Returns the ball in the end; `Some(None)` if it
    /// is too small or outside.
    pub fn advance(&mut self, inside: &Inside, amount: &mut usize) -> Option<Option<Sphere>> {
        while self.walk.advance(inside.search, inside.mesh, amount) {
            let nearest = self.walk.found(inside.mesh);
            if self.steps == 0 {
                return Some(nearest.and_then(|nearest| inside.ball_at(self.centre, nearest)));
            }
            self.shrink(nearest);
        }
        None
    }

    /// Shrinks the ball until it touches the place nearest to its centre; ends the search if that makes it no smaller.
    fn shrink(&mut self, nearest: Option<SurfacePoint>) {
        let Some((sample, radius)) = &mut self.touched else {
            return;
        };
        let smaller = nearest.and_then(|nearest| {
            let off = sample.at - nearest.at;
            let depth = off.dot(sample.normal);
            let next = off.length_squared() / (2.0 * depth);
            (depth > 0.0 && next < *radius).then_some(next)
        });
        match smaller {
            Some(next) => (*radius, self.steps) = (next, self.steps - 1),
            None => self.steps = 0,
        }
        self.centre = sample.at - *radius * sample.normal;
        // The last walk must find at least the sample itself, which is one radius away.
        let factor = if self.steps == 0 { WIDER } else { TOUCHES };
        self.walk = NearestWalk::new(self.centre, factor * *radius);
    }
}

/// Samples of a surface, one in each of equal parts of its area.
pub(super) struct Sampling {
    random: Random,
    count: usize,
    triangle: usize,
    /// The area of the triangles before this one.
    before: f64,
    pub samples: Vec<SurfaceSample>,
}

impl Sampling {
    pub fn new(count: usize) -> Self {
        Self {
            random: Random::new(crate::random::SEED, Purpose::Scatter, count as u64),
            count,
            triangle: 0,
            before: 0.0,
            samples: Vec::with_capacity(count),
        }
    }

    /// Works on at most `amount` triangles and samples; true after the last sample.
    pub fn advance(&mut self, mesh: &TriMesh, amount: usize) -> bool {
        let last = mesh.triangles().len() - 1;
        for _ in 0..amount {
            if self.samples.len() == self.count {
                break;
            }
            let share = (self.samples.len() as f64 + 0.5) / self.count as f64;
            let area = mesh.area_of(self.triangle as u32);
            if self.triangle < last && self.before + area < share * mesh.area() {
                self.before += area;
                self.triangle += 1;
            } else {
                let [u, v] = [0; 2].map(|_| self.random.unit());
                self.samples.push(sample(mesh, self.triangle as u32, u, v));
            }
        }
        self.samples.len() == self.count
    }
}

/// The sample of a triangle for two numbers, uniform in 0 to 1.
fn sample(mesh: &TriMesh, triangle: u32, u: f64, v: f64) -> SurfaceSample {
    let root = u.sqrt();
    let weights = DVec3::new(1.0 - root, root * (1.0 - v), root * v);
    let [a, b, c] = mesh.corners(triangle);
    let (face, smooth) = (
        mesh.face_normal(triangle),
        mesh.normal_at(triangle, weights),
    );
    SurfaceSample {
        at: a * weights.x + b * weights.y + c * weights.z,
        normal: if face.dot(smooth) > SMOOTH {
            smooth
        } else {
            face
        },
    }
}
