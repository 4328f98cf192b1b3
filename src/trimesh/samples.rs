//! Meshes for tests.

use super::TriMesh;
use glam::DVec3;
use std::f64::consts::TAU;

/// Joins rows of points by triangles: row `v`, place `u` is point `v * nu + u`. Rows or columns are closed where
/// `around` is true.
pub(crate) fn grid(
    nu: u32,
    nv: u32,
    (around_u, around_v): (bool, bool),
    at: impl Fn(f64, f64) -> DVec3,
) -> TriMesh {
    let (du, dv) = (nu - u32::from(!around_u), nv - u32::from(!around_v));
    let points = (0..nv).flat_map(|v| (0..nu).map(move |u| (u, v)));
    let positions =
        points.map(|(u, v)| at(f64::from(u) / f64::from(du), f64::from(v) / f64::from(dv)));
    let mut triangles = Vec::new();
    for v in 0..dv {
        for u in 0..du {
            let [a, b] = [u, (u + 1) % nu].map(|u| v * nu + u);
            let [d, c] = [u, (u + 1) % nu].map(|u| ((v + 1) % nv) * nu + u);
            // Diagonals alternate, so that no direction is preferred.
            if (u + v) % 2 == 0 {
                triangles.extend([[a, b, c], [a, c, d]]);
            } else {
                triangles.extend([[a, b, d], [b, c, d]]);
            }
        }
    }
    TriMesh::new(positions.collect(), triangles).expect("a mesh")
}

/// A torus of radii 1 and 0.4 about the y axis.
pub(crate) fn torus(nu: u32, nv: u32) -> TriMesh {
    grid(nu, nv, (true, true), |u, v| {
        let (a, b) = (TAU * u, TAU * v);
        let r = 1.0 + 0.4 * libm::cos(b);
        DVec3::new(r * libm::cos(a), -0.4 * libm::sin(b), r * libm::sin(a))
    })
}

/// A flat square of side 1 with a hill on it, open.
pub(crate) fn hill(n: u32) -> TriMesh {
    grid(n + 1, n + 1, (false, false), |u, v| {
        let (x, z) = (u - 0.5, v - 0.5);
        DVec3::new(x, 0.25 * libm::exp(-12.0 * (x * x + z * z)), -z)
    })
}

/// The plane square of side 1.
pub(crate) fn flat(n: u32) -> TriMesh {
    grid(n + 1, n + 1, (false, false), |u, v| DVec3::new(u, 0.0, -v))
}

/// A cylinder of radius 0.3 along y, open at both ends, of length 1.
pub(crate) fn cylinder(nu: u32, nv: u32) -> TriMesh {
    grid(nu, nv, (true, false), |u, v| {
        let a = TAU * u;
        DVec3::new(0.3 * libm::cos(a), v - 0.5, -0.3 * libm::sin(a))
    })
}

/// A tube of radius 0.25 around a trefoil knot.
pub(crate) fn knot(nu: u32, nv: u32) -> TriMesh {
    let way = |t: f64| {
        let (a, b) = (2.0 * TAU * t, 3.0 * TAU * t);
        let r = 1.0 + 0.45 * libm::cos(b);
        DVec3::new(r * libm::cos(a), 0.6 * libm::sin(b), r * libm::sin(a))
    };
    grid(nu, nv, (true, true), |u, v| {
        let at = way(u);
        let along = (way(u + 1e-4) - way(u - 1e-4)).normalize();
        let out = DVec3::new(at.x, 0.0, at.z).normalize();
        let side = along.cross(out).normalize();
        let out = side.cross(along);
        at + 0.25 * (libm::cos(TAU * v) * out - libm::sin(TAU * v) * side)
    })
}

/// The unit ball: an icosahedron whose triangles are cut in four, `times` times.
pub(crate) fn ball(times: u32) -> TriMesh {
    let g = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let mut positions = Vec::new();
    for [a, b] in [[-1.0, g], [1.0, g], [-1.0, -g], [1.0, -g]] {
        positions.push(DVec3::new(a, b, 0.0));
    }
    for [a, b] in [[-1.0, g], [1.0, g], [-1.0, -g], [1.0, -g]] {
        positions.push(DVec3::new(0.0, a, b));
    }
    for [a, b] in [[g, -1.0], [g, 1.0], [-g, -1.0], [-g, 1.0]] {
        positions.push(DVec3::new(a, 0.0, b));
    }
    let mut positions: Vec<DVec3> = positions.into_iter().map(DVec3::normalize).collect();
    let sides = "0b5 051 017 07a 0ab 159 5b4 ba2 a76 718 394 342 326 368 389 495 24b 62a 867 981";
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    for side in sides.split(' ') {
        let c: Vec<u32> = side
            .chars()
            .map(|c| c.to_digit(16).expect("a number"))
            .collect();
        triangles.push([c[0], c[1], c[2]]);
    }
    for _ in 0..times {
        let mut middles = std::collections::BTreeMap::new();
        let mut finer = Vec::new();
        for [a, b, c] in triangles {
            let [d, e, f] = [(a, b), (b, c), (c, a)].map(|(p, q)| {
                *middles.entry((p.min(q), p.max(q))).or_insert_with(|| {
                    positions.push((positions[p as usize] + positions[q as usize]).normalize());
                    positions.len() as u32 - 1
                })
            });
            finer.extend([[a, d, f], [d, b, e], [f, e, c], [d, e, f]]);
        }
        triangles = finer;
    }
    TriMesh::new(positions, triangles).expect("a ball")
}

/// A ball with bumps.
pub(crate) fn blob(times: u32) -> TriMesh {
    moved(&ball(times), |_, p| {
        let s = libm::sin(3.0 * p.x + 0.4) + libm::sin(4.0 * p.y + 1.0) + libm::sin(3.5 * p.z);
        p * (1.0 + 0.13 * s)
    })
}

/// The same mesh with moved vertices.
pub(crate) fn moved(mesh: &TriMesh, to: impl Fn(usize, DVec3) -> DVec3) -> TriMesh {
    let each = mesh.positions().iter().enumerate();
    let positions = each.map(|(k, &p)| to(k, p)).collect();
    TriMesh::new(positions, mesh.triangles().to_vec()).expect("a mesh")
}

/// The same mesh with each coordinate moved at random by at most `by`.
pub(crate) fn noisy(mesh: &TriMesh, by: f64) -> TriMesh {
    moved(mesh, |k, p| {
        let r = |m: u64| {
            let h = (k as u64 * 3 + m + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
            let h = (h ^ (h >> 29)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            (h >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        };
        p + by * DVec3::new(r(0), r(1), r(2))
    })
}

/// A plate of genus 2 with two square holes through it and sharp corners; `n` squares to a unit.
pub(crate) fn double_ring(n: i64) -> TriMesh {
    let full = |x: i64, y: i64, z: i64| {
        let inside = (0..7 * n).contains(&x) && (0..n).contains(&y) && (0..3 * n).contains(&z);
        let hole = |a: i64| (a * n..(a + 1) * n).contains(&x) && (n..2 * n).contains(&z);
        inside && !hole(1) && !hole(5)
    };
    let mut ids = std::collections::BTreeMap::new();
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for x in 0..7 * n {
        for y in 0..n {
            for z in (0..3 * n).filter(|&z| full(x, y, z)) {
                for (axis, sign) in [(0, -1), (0, 1), (1, -1), (1, 1), (2, -1), (2, 1)] {
                    let mut next = [x, y, z];
                    next[axis] += sign;
                    if full(next[0], next[1], next[2]) {
                        continue;
                    }
                    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
                    let mut quad = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(a, b)| {
                        let mut c = [x, y, z];
                        c[axis] += i64::from(sign > 0);
                        c[u] += a;
                        c[v] += b;
                        *ids.entry(c).or_insert_with(|| {
                            let [x, y, z] = c.map(|c| c as f64 / n as f64);
                            positions.push(DVec3::new(x, y, z));
                            positions.len() as u32 - 1
                        })
                    });
                    if sign < 0 {
                        quad.reverse();
                    }
                    let [a, b, c, d] = quad;
                    triangles.extend([[a, b, c], [a, c, d]]);
                }
            }
        }
    }
    TriMesh::new(positions, triangles).expect("two rings")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_are_what_they_are_called() {
        let wanted = [
            (ball(2), 2),
            (blob(3), 2),
            (torus(24, 10), 0),
            (knot(120, 12), 0),
            (double_ring(2), -2),
            (hill(8), 1),
            (cylinder(16, 8), 0),
        ];
        for (mesh, euler) in wanted {
            assert_eq!(mesh.euler(), euler);
            let (_, count) = mesh.parts();
            assert_eq!(count, 1);
            assert!(
                mesh.closed().is_none_or(|body| body.volume() > 0.0),
                "{euler}"
            );
        }
    }
}
