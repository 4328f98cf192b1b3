//! Remeshing to triangles of one size (Botsch, Kobbelt 2004, A Remeshing Approach to Multiresolution Modeling). Long
//! edges are split and short ones collapsed. Other edges are flipped until about six meet at each vertex. Vertices
//! slide over the form to the middle of their neighbours.

use super::form::{Form, near};
use super::surgery::{Surgery, next};
use glam::DVec3;
use std::ops::Range;

/// Edges are split above, and collapsed below, this many times the wanted length.
const LONG: f64 = 4.0 / 3.0;
const SHORT: f64 = 0.8;
/// The most edges at a vertex after a collapse.
const MOST_EDGES: usize = 9;
/// The least cosine of the angle by which normals may turn when an edge is collapsed or flipped.
const TURN: f64 = 0.5;

fn normal(a: DVec3, b: DVec3, c: DVec3) -> DVec3 {
    (b - a).cross(c - a).normalize_or_zero()
}

/// Splits edges that are too long.
pub(super) fn split(mesh: &mut Surgery, form: &dyn Form, edge: f64, edges: Range<u32>) {
    let limit = LONG * edge * LONG * edge;
    for h in edges {
        if h < mesh.across(h) && mesh.is_alive(h) && mesh.vector(h).length_squared() > limit {
            let middle = 0.5 * (mesh.at(mesh.start(h)) + mesh.at(mesh.end(h)));
            mesh.split(h, near(form, middle, edge));
        }
    }
}

/// Collapses edges that are too short.
pub(super) fn collapse(mesh: &mut Surgery, form: &dyn Form, edge: f64, edges: Range<u32>) {
    let limit = SHORT * edge * SHORT * edge;
    for h in edges {
        if !mesh.is_alive(h) || h > mesh.across(h) || mesh.vector(h).length_squared() > limit {
            continue;
        }
        if !mesh.can_collapse(h, MOST_EDGES) {
            continue;
        }
        let (a, b) = (mesh.start(h), mesh.end(h));
        let p = 0.5 * (mesh.at(a) + mesh.at(b));
        let fits = [(a, b), (b, a)].iter().all(|&(v, other)| {
            mesh.around(v).all(|e| {
                let (q, r) = (mesh.end(e), mesh.apex(e));
                let is_short = (mesh.at(q) - p).length_squared() <= LONG * LONG * edge * edge;
                let stays = q == other || r == other || {
                    let (q, r) = (mesh.at(q), mesh.at(r));
                    normal(mesh.at(v), q, r).dot(normal(p, q, r)) > TURN
                };
                stays && (q == other || is_short)
            })
        });
        if fits {
            mesh.collapse(h);
            mesh.positions[b as usize] = near(form, p, edge);
        }
    }
}

/// Whether both triangles stay on the surface after a flip.
fn stays_on(mesh: &Surgery, h: u32) -> bool {
    let g = mesh.across(h);
    let [a, b, c, d] = [mesh.start(h), mesh.end(h), mesh.apex(h), mesh.apex(g)].map(|v| mesh.at(v));
    let old = [normal(a, b, c), normal(b, a, d)];
    let mean = (old[0] + old[1]).normalize_or_zero();
    let new = [normal(d, c, a), normal(c, d, b)];
    // A flip must not turn a quadrilateral inside out, nor fold it more sharply.
    new.iter().all(|n| n.dot(mean) > TURN) && new[0].dot(new[1]) > old[0].dot(old[1]) - 0.2
}

/// Flips edges if that brings the numbers of edges at their vertices closer to six.
pub(super) fn even_out(mesh: &mut Surgery, edges: Range<u32>) {
    for h in edges {
        if !mesh.is_alive(h) || h > mesh.across(h) {
            continue;
        }
        let g = mesh.across(h);
        let [a, b, c, d] = [mesh.start(h), mesh.end(h), mesh.apex(h), mesh.apex(g)]
            .map(|v| mesh.valence(v) as i64 - 6);
        let [gain, price] = [[-1, -1, 1, 1], [0; 4]].map(|by: [i64; 4]| {
            let sums = [a + by[0], b + by[1], c + by[2], d + by[3]];
            sums.iter().map(|s| s * s).sum::<i64>()
        });
        if gain < price && mesh.can_flip(h) && stays_on(mesh, h) {
            mesh.flip(h);
        }
    }
}

/// Flips edges whose two opposite angles sum to more than half a turn (Delaunay).
pub(super) fn make_delaunay(mesh: &mut Surgery, edges: Range<u32>) {
    for h in edges {
        if !mesh.is_alive(h) || h > mesh.across(h) {
            continue;
        }
        let cot = |h: u32| {
            let c = mesh.at(mesh.apex(h));
            let (u, v) = (mesh.at(mesh.start(h)) - c, mesh.at(mesh.end(h)) - c);
            u.dot(v) / u.cross(v).length().max(f64::MIN_POSITIVE)
        };
        if cot(h) + cot(mesh.across(h)) < -1e-3 && mesh.can_flip(h) && stays_on(mesh, h) {
            mesh.flip(h);
        }
    }
}

/// The place to which a vertex slides: by `share` of the way to the centroid of its triangles, then onto the form.
pub(super) fn slid(mesh: &Surgery, form: &dyn Form, v: u32, share: f64, edge: f64) -> DVec3 {
    let p = mesh.at(v);
    let (mut sum, mut weight) = (DVec3::ZERO, 0.0);
    let mut across = DVec3::ZERO;
    for h in mesh.around(v) {
        let (q, r) = (mesh.at(mesh.end(h)), mesh.at(mesh.end(next(h))));
        let area = (q - p).cross(r - p);
        let size = area.length();
        sum += (p + q + r) * (size / 3.0);
        weight += size;
        across += area;
    }
    if weight == 0.0 {
        return p;
    }
    let n = across.normalize_or_zero();
    let by = (sum / weight - p) * share;
    near(form, p + by - n * n.dot(by), edge)
}
