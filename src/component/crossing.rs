//! Where a mesh crosses itself.

use crate::trimesh::{Search, TriMesh};
use glam::DVec3;
use robust::{Coord3D, orient3d};

/// A slice ends after this many nearby triangles for each unit of its amount. A needle may have all other triangles
/// near it.
const NEAR: usize = 400;

/// The crossings found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Crossings {
    /// Pairs of triangles that cross.
    pub pairs: usize,
    /// A place where the first pair crosses.
    pub at: Option<DVec3>,
}

/// Looks for pairs of triangles that cross, in slices. The tests of sides are exact (Shewchuk 1997, Adaptive Precision
/// Floating-Point Arithmetic and Fast Robust Geometric Predicates). Triangles with a common edge are not compared.
#[derive(Default)]
pub struct CrossingSearch {
    at: usize,
    found: Crossings,
}

impl CrossingSearch {
    /// Compares at most `amount` triangles with those near them, or fewer if many are near. Returns the crossings after
    /// the last triangle.
    pub fn advance(&mut self, mesh: &TriMesh, search: &Search, amount: usize) -> Option<Crossings> {
        let count = mesh.triangles().len();
        let end = count.min(self.at.saturating_add(amount.max(1)));
        let most = amount.saturating_mul(NEAR);
        let mut near = 0;
        while self.at < end && near <= most {
            near += self.compare(mesh, search, self.at as u32);
            self.at += 1;
        }
        (self.at == count).then_some(self.found)
    }

    /// Compares a triangle with those near it that have greater numbers. Returns how many triangles are near.
    fn compare(&mut self, mesh: &TriMesh, search: &Search, t: u32) -> usize {
        let corners = mesh.corners(t);
        let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        let reach = corners.map(|p| p.distance(middle));
        let reach = reach.into_iter().fold(0.0, f64::max);
        let (low, high) = bounds(corners);
        let mut near = 0;
        search.any_within(middle, reach, |other| {
            near += 1;
            if other > t {
                let (l, h) = bounds(mesh.corners(other));
                let is_near = l.cmple(high).all() && low.cmple(h).all();
                if let Some(at) = is_near.then(|| meeting(mesh, t, other)).flatten() {
                    self.found.pairs += 1;
                    self.found.at = self.found.at.or(Some(at));
                }
            }
            false
        });
        near
    }
}

fn bounds([a, b, c]: [DVec3; 3]) -> (DVec3, DVec3) {
    (a.min(b).min(c), a.max(b).max(c))
}

/// A place where two triangles cross.
fn meeting(mesh: &TriMesh, s: u32, t: u32) -> Option<DVec3> {
    let own = [s, t].map(|t| mesh.triangles()[t as usize]);
    let shared = own[0].iter().filter(|v| own[1].contains(v)).count();
    if shared > 1 {
        return None;
    }
    [(0, 1), (1, 0)].into_iter().find_map(|(a, b)| {
        let face = mesh.corners([s, t][b]);
        (0..3).find_map(|k| {
            let ends = [own[a][k], own[a][(k + 1) % 3]];
            let touches = ends.iter().any(|v| own[b].contains(v));
            let [p, q] = ends.map(|v| mesh.positions()[v as usize]);
            (!touches).then(|| piercing([p, q], face)).flatten()
        })
    })
}

/// The place where a segment goes through a triangle; `None` unless its ends lie strictly on different sides.
fn piercing([p, q]: [DVec3; 2], [a, b, c]: [DVec3; 3]) -> Option<DVec3> {
    let [above, below] = [p, q].map(|end| volume(a, b, c, end));
    if above * below >= 0.0 || above == 0.0 || below == 0.0 {
        return None;
    }
    let sides = [(a, b), (b, c), (c, a)].map(|(u, v)| volume(p, q, u, v));
    let is_inside = sides.iter().all(|&x| x >= 0.0) || sides.iter().all(|&x| x <= 0.0);
    is_inside.then(|| p + (q - p) * (above / (above - below)))
}

/// A number with the exact sign of the volume between four points.
fn volume(a: DVec3, b: DVec3, c: DVec3, d: DVec3) -> f64 {
    let [a, b, c, d] = [a, b, c, d].map(|p| Coord3D {
        x: p.x,
        y: p.y,
        z: p.z,
    });
    orient3d(a, b, c, d)
}
