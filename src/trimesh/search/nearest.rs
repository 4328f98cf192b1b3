//! The point of a mesh that is nearest to a point in space.

use super::super::{NONE, SurfacePoint, TriMesh};
use super::tree::{OpenNodes, SLACK, Search};
use glam::DVec3;

/// The rounding error of a squared distance to a plane is less than this share of the squared distance to a corner on
/// it.
const ROUNDING: f64 = 1e-14;

/// A point moves to triangles that face the other way only if those that face its own way are more than this many times
/// as far away.
const BACK: f64 = 4.0;

/// The nearest place so far.
#[derive(Clone, Copy)]
struct Found {
    square: f64,
    /// The index of the triangle; [`NONE`] if nothing is found.
    triangle: u32,
    weights: DVec3,
}

impl Found {
    const NONE: Self = Self {
        square: f64::INFINITY,
        triangle: NONE,
        weights: DVec3::X,
    };

    fn point(&self, mesh: &TriMesh) -> SurfacePoint {
        let triangle = if self.triangle == NONE {
            0
        } else {
            self.triangle
        };
        SurfacePoint::new(mesh, triangle, self.weights)
    }
}

/// A search for the place nearest to a point, which can be cut into slices.
pub(crate) struct NearestWalk {
    p: DVec3,
    open: OpenNodes,
    best: Found,
}

impl NearestWalk {
    /// Starts at a point. Only places nearer than `radius` count.
    pub fn new(p: DVec3, radius: f64) -> Self {
        let limit = Found {
            square: radius * radius,
            ..Found::NONE
        };
        Self::below(p, limit)
    }

    fn below(p: DVec3, best: Found) -> Self {
        let open = OpenNodes::new();
        Self { p, open, best }
    }

    /// Goes on among all triangles; true at the end. Each box and triangle that is looked at takes one off `amount`, and
    /// the search pauses when nothing is left of it.
    pub fn advance(&mut self, search: &Search, mesh: &TriMesh, amount: &mut usize) -> bool {
        self.pass(search, mesh, amount, |_| true)
    }

    /// The nearest place, once the search is at its end; `None` if there is none within the radius.
    pub fn found(&self, mesh: &TriMesh) -> Option<SurfacePoint> {
        (self.best.triangle != NONE).then(|| self.best.point(mesh))
    }

    /// Does as [`Self::advance`], but among the triangles for which `wanted` is true.
    fn pass(
        &mut self,
        search: &Search,
        mesh: &TriMesh,
        amount: &mut usize,
        wanted: impl Fn(u32) -> bool,
    ) -> bool {
        let (p, best) = (self.p, &mut self.best);
        let leaves = search.leaf_count();
        while *amount > 0 {
            let Some((near, node)) = self.open.pop() else {
                return true;
            };
            *amount -= 1;
            if near > best.square * SLACK {
                continue;
            }
            if node < leaves {
                self.open.split(node, |child| search.square(child, p));
                continue;
            }
            let leaf = search.leaf(node - leaves);
            *amount = amount.saturating_sub(leaf.len());
            for &t in leaf.iter().filter(|&&t| wanted(t)) {
                let corners = mesh.corners(t);
                // A triangle is no nearer than its plane.
                let off = p - corners[0];
                let height = mesh.face_normal(t).dot(off);
                if height * height > best.square * SLACK + ROUNDING * off.length_squared() {
                    continue;
                }
                let weights = nearest_weights(corners, p);
                let at = corners[0] * weights.x + corners[1] * weights.y + corners[2] * weights.z;
                let square = at.distance_squared(p);
                if square < best.square || (square == best.square && t < best.triangle) {
                    *best = Found {
                        square,
                        triangle: t,
                        weights,
                    };
                }
            }
        }
        self.open.is_empty()
    }
}

impl Search {
    /// The point of the mesh nearest to `p`. Among equally near ones, that of the triangle with the least number.
    pub fn closest(&self, mesh: &TriMesh, p: DVec3) -> SurfacePoint {
        self.nearest(mesh, p, Found::NONE, |_| true).point(mesh)
    }

    /// The nearest place among triangles that face the same side as `normal`, unless all of them are much farther
    /// away. So a point stays on its side of a thin sheet. A zero normal allows all triangles.
    pub fn closest_facing(&self, mesh: &TriMesh, p: DVec3, normal: DVec3) -> SurfacePoint {
        let faces = |t: u32| mesh.face_normal(t).dot(normal) >= 0.0;
        let any = self.nearest(mesh, p, Found::NONE, |_| true);
        if any.triangle == NONE || faces(any.triangle) {
            return any.point(mesh);
        }
        let limit = Found {
            square: any.square * (BACK * BACK * SLACK),
            ..Found::NONE
        };
        let front = self.nearest(mesh, p, limit, faces);
        let is_far = front.triangle == NONE || any.square.sqrt() * BACK < front.square.sqrt();
        if is_far { any } else { front }.point(mesh)
    }

    /// The nearest place on the triangles for which `wanted` is true, if it is nearer than `best`; else `best`.
    fn nearest(
        &self,
        mesh: &TriMesh,
        p: DVec3,
        best: Found,
        wanted: impl Fn(u32) -> bool,
    ) -> Found {
        let mut walk = NearestWalk::below(p, best);
        walk.pass(self, mesh, &mut { usize::MAX }, wanted);
        walk.best
    }
}

/// The place in a triangle nearest to a point.
pub(crate) fn nearest_in(corners: [DVec3; 3], p: DVec3) -> DVec3 {
    let weights = nearest_weights(corners, p);
    corners[0] * weights.x + corners[1] * weights.y + corners[2] * weights.z
}

/// The weights of the place in a triangle nearest to a point (Ericson 2005, Real-Time Collision Detection, 5.1.5).
pub(super) fn nearest_weights([a, b, c]: [DVec3; 3], p: DVec3) -> DVec3 {
    let (ab, ac) = (b - a, c - a);
    let (d1, d2) = (ab.dot(p - a), ac.dot(p - a));
    if d1 <= 0.0 && d2 <= 0.0 {
        return DVec3::X;
    }
    let (d3, d4) = (ab.dot(p - b), ac.dot(p - b));
    if d3 >= 0.0 && d4 <= d3 {
        return DVec3::Y;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let v = d1 / (d1 - d3);
        return DVec3::new(1.0 - v, v, 0.0);
    }
    let (d5, d6) = (ab.dot(p - c), ac.dot(p - c));
    if d6 >= 0.0 && d5 <= d6 {
        return DVec3::Z;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        let w = d2 / (d2 - d6);
        return DVec3::new(1.0 - w, 0.0, w);
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        let w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return DVec3::new(0.0, 1.0 - w, w);
    }
    let sum = va + vb + vc;
    DVec3::new(va, vb, vc) / sum
}
