//! Meshes, places on them, and properties that hold for any cells.

use super::super::*;
use crate::field::CellKind;
use crate::random::{Purpose, Random};
use crate::surface_cells::metrics::SurfaceMetrics;
use crate::trimesh::{TangentFrame, TriMesh};
use glam::DVec3;

/// A patch of `nu` by `nv` squares, each of two triangles, closed in either direction or both.
pub fn patch(
    [nu, nv]: [u32; 2],
    [round_u, round_v]: [bool; 2],
    place: impl Fn(f64, f64) -> DVec3,
) -> TriMesh {
    let [cu, cv] = [nu + u32::from(!round_u), nv + u32::from(!round_v)];
    let at = |i: u32, j: u32| (j % cv) * cu + i % cu;
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for j in 0..cv {
        for i in 0..cu {
            positions.push(place(
                f64::from(i) / f64::from(nu),
                f64::from(j) / f64::from(nv),
            ));
        }
    }
    for j in 0..nv {
        for i in 0..nu {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            if (i + j) % 2 == 0 {
                triangles.extend([[a, b, c], [a, c, d]]);
            } else {
                triangles.extend([[a, b, d], [b, c, d]]);
            }
        }
    }
    TriMesh::new(positions, triangles).unwrap()
}

/// A box with `n` squares along each of its sides, corners shared.
pub fn boxed(n: [u32; 3], size: DVec3) -> TriMesh {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    let mut number = std::collections::BTreeMap::new();
    let mut vertex = |p: [u32; 3]| {
        *number.entry(p).or_insert_with(|| {
            let [x, y, z] = [0, 1, 2].map(|k| f64::from(p[k]) / f64::from(n[k]));
            positions.push(DVec3::new(x, y, z) * size);
            positions.len() as u32 - 1
        })
    };
    for axis in 0..3 {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        for (end, out) in [(0, false), (n[axis], true)] {
            for i in 0..n[u] {
                for j in 0..n[v] {
                    let mut at = |i: u32, j: u32| {
                        let mut p = [0; 3];
                        (p[axis], p[u], p[v]) = (end, i, j);
                        vertex(p)
                    };
                    let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                    let both = [[a, b, c], [a, c, d]];
                    triangles.extend(both.map(|[a, b, c]| if out { [a, b, c] } else { [a, c, b] }));
                }
            }
        }
    }
    TriMesh::new(positions, triangles).unwrap()
}

pub fn ball(n: u32) -> TriMesh {
    let cube = boxed([n; 3], DVec3::splat(2.0));
    let round = |p: &DVec3| (*p - DVec3::ONE).normalize();
    TriMesh::new(
        cube.positions().iter().map(round).collect(),
        cube.triangles().to_vec(),
    )
    .unwrap()
}

pub fn torus(nu: u32, nv: u32) -> TriMesh {
    patch([nu, nv], [true; 2], on_torus)
}

pub fn on_torus(u: f64, v: f64) -> DVec3 {
    let [u, v] = [u, v].map(|t| t * std::f64::consts::TAU);
    let r = 3.0 + libm::cos(v);
    DVec3::new(r * libm::cos(u), r * libm::sin(u), libm::sin(v))
}

/// The point of a mesh nearest to a place, among the triangles that the place lies above or below.
pub fn nearest(mesh: &TriMesh, p: DVec3) -> SurfacePoint {
    let mut best = (f64::INFINITY, 0, DVec3::ZERO);
    for t in 0..mesh.triangles().len() as u32 {
        let corners = mesh.corners(t);
        if corners.iter().all(|c| c.distance(p) > best.0 + 1.0) {
            continue;
        }
        let weights = mesh.weights(t, p).max(DVec3::ZERO);
        let weights = weights / (weights.x + weights.y + weights.z);
        let foot = corners[0] * weights.x + corners[1] * weights.y + corners[2] * weights.z;
        if foot.distance(p) < best.0 {
            best = (foot.distance(p), t, weights);
        }
    }
    SurfacePoint::new(mesh, best.1, best.2)
}

/// A cell whose axis is as near as possible to a vector in space.
pub fn cell(
    id: u32,
    centre: SurfacePoint,
    along: DVec3,
    kind: CellKind,
    size: f64,
    aspect: f64,
) -> SurfaceParticle {
    SurfaceParticle {
        id,
        fixed: false,
        kind,
        size,
        aspect,
        axis: TangentFrame::of(centre.normal)
            .within(along)
            .normalize_or_zero(),
        centre,
    }
}

/// Cells of a kind at places, with an axis in space.
pub fn cells(
    mesh: &TriMesh,
    places: &[(DVec3, DVec3)],
    kind: CellKind,
    size: f64,
    aspect: f64,
) -> Vec<SurfaceParticle> {
    let each = places.iter().enumerate();
    each.map(|(k, &(p, along))| cell(k as u32, nearest(mesh, p), along, kind, size, aspect))
        .collect()
}

/// Even places on a ball, each moved a little.
pub fn on_ball(count: u32, off: f64) -> Vec<(DVec3, DVec3)> {
    let mut random = Random::new(7, Purpose::Placement, 0);
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    (0..count)
        .map(|k| {
            let z = 1.0 - (2.0 * f64::from(k) + 1.0) / f64::from(count);
            let (r, t) = ((1.0 - z * z).sqrt(), golden * f64::from(k));
            let p = DVec3::new(r * libm::cos(t), r * libm::sin(t), z);
            let by = DVec3::new(random.signed(), random.signed(), random.signed());
            ((p + by * off).normalize(), DVec3::Z)
        })
        .collect()
}

/// Checks properties that hold for any cells on any mesh.
pub fn check(name: &str, mesh: &TriMesh, made: &SurfaceMesh) -> SurfaceMetrics {
    let figures = SurfaceMetrics::new(mesh, made);
    println!("{name}: {figures:?}");
    assert_eq!(figures.doubled, 0, "{name}: doubled sides");
    // Each side of a polygon that is not on the border is a side of another polygon, reversed.
    let mut sides = std::collections::BTreeSet::new();
    for ring in &made.rings {
        for k in 0..ring.len() {
            let side = [ring[k], ring[(k + 1) % ring.len()]];
            assert!(sides.insert(side), "{name}: {side:?} twice");
        }
    }
    if figures.rings == figures.cells {
        for &[a, b] in &sides {
            let on_border = made.is_on_border(a) && made.is_on_border(b);
            assert!(on_border || sides.contains(&[b, a]), "{name}: a gap");
        }
    }
    figures
}

pub fn build(mesh: &TriMesh, cells: Vec<SurfaceParticle>) -> SurfaceMesh {
    SurfaceMesh::build(mesh, cells, Polish::default())
}
