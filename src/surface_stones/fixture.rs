//! For tests: rows of cells on surfaces that are functions of two numbers.

use crate::field::CellKind;
use crate::surface_cells::SurfaceCell;
use crate::trimesh::{SurfacePoint, TangentFrame, TriMesh};
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// A surface as a function of two numbers from 0 to 1. The derivative by the first number, cross the derivative by the
/// second, points outwards.
pub type Patch<'a> = &'a dyn Fn(DVec2) -> DVec3;

/// Cells in rows: how many along and across, whether every other row is shifted by half a cell, and whether the
/// surface closes in each direction.
pub struct Rows {
    pub count: [usize; 2],
    pub is_staggered: bool,
    pub closes: [bool; 2],
    /// Edges of the mesh along one side of a cell.
    pub finer: usize,
    pub kind: CellKind,
}

/// Squares in rows that are not staggered.
pub fn rows(count: [usize; 2], closes: [bool; 2]) -> Rows {
    Rows {
        count,
        is_staggered: false,
        closes,
        finer: 2,
        kind: CellKind::Square,
    }
}

pub fn normal(patch: Patch, at: DVec2) -> DVec3 {
    let step = 1e-5;
    let along = |d: DVec2| patch(at + d) - patch(at - d);
    let [u, v] = [DVec2::X, DVec2::Y].map(|d| along(d * step));
    u.cross(v).normalize_or(DVec3::Y)
}

impl Rows {
    pub fn cells(&self, patch: Patch) -> Vec<SurfaceCell> {
        let [n, m] = self.count;
        let turned = |x: f64, closes: bool| if closes { x.rem_euclid(1.0) } else { x };
        let wrap = |p: DVec2| {
            // Rounded, so that both sides of a seam have the same bits.
            let near = |x: f64, n: usize| (x * 2.0 * n as f64).round() / (2.0 * n as f64);
            let p = DVec2::new(near(p.x, n), near(p.y, m));
            DVec2::new(turned(p.x, self.closes[0]), turned(p.y, self.closes[1]))
        };
        let mut cells = Vec::new();
        for j in 0..m {
            for i in 0..n {
                let off = if self.is_staggered && j % 2 == 1 {
                    0.5
                } else {
                    0.0
                };
                let place = |u: f64, v: f64| {
                    DVec2::new((i as f64 + off + u) / n as f64, (j as f64 + v) / m as f64)
                };
                let mut ring = vec![place(0.0, 0.0), place(1.0, 0.0)];
                if self.is_staggered {
                    ring.insert(1, place(0.5, 0.0));
                    ring.push(place(1.0, 1.0));
                    ring.push(place(0.5, 1.0));
                } else {
                    ring.push(place(1.0, 1.0));
                }
                ring.push(place(0.0, 1.0));
                let ring: Vec<DVec2> = ring.into_iter().map(wrap).collect();
                let middle = place(0.5, 0.5);
                let normal_there = normal(patch, middle);
                let along = patch(place(0.51, 0.5)) - patch(place(0.49, 0.5));
                let side = |a: DVec2, b: DVec2| (patch(a) - patch(b)).length();
                let width = side(place(0.0, 0.5), place(1.0, 0.5));
                let height = side(place(0.5, 0.0), place(0.5, 1.0));
                cells.push(SurfaceCell {
                    id: cells.len() as u32,
                    kind: self.kind,
                    centre: SurfacePoint {
                        triangle: 0,
                        at: patch(middle),
                        normal: normal_there,
                    },
                    axis: TangentFrame::of(normal_there)
                        .within(along)
                        .normalize_or_zero(),
                    size: (width * height).sqrt(),
                    aspect: width / height,
                    ring: ring.iter().map(|&p| patch(p)).collect(),
                    normals: ring.iter().map(|&p| normal(patch, p)).collect(),
                    on_border: (!self.closes[1] && (j == 0 || j + 1 == m))
                        || (!self.closes[0] && (i == 0 || i + 1 == n)),
                });
            }
        }
        cells
    }

    pub fn mesh(&self, patch: Patch) -> TriMesh {
        let [n, m] = self.count.map(|c| c * self.finer);
        let [w, h] = [0, 1].map(|k| [n, m][k] + usize::from(!self.closes[k]));
        let at = |i: usize, j: usize| (j % h * w + i % w) as u32;
        let place = |k: usize| DVec2::new((k % w) as f64 / n as f64, (k / w) as f64 / m as f64);
        let positions = (0..w * h).map(|k| patch(place(k))).collect();
        let mut triangles = Vec::new();
        for j in 0..m {
            for i in 0..n {
                let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)];
                triangles.extend([[a, b, d], [a, d, c]]);
            }
        }
        TriMesh::new(positions, triangles).expect("a mesh")
    }
}

/// A torus about the y axis: a tube of this radius around a ring of radius 1.
pub fn torus(radius: f64) -> impl Fn(DVec2) -> DVec3 {
    move |p| {
        let (a, b) = (-TAU * p.x, TAU * p.y);
        let far = 1.0 + radius * libm::cos(b);
        DVec3::new(
            far * libm::cos(a),
            radius * libm::sin(b),
            far * libm::sin(a),
        )
    }
}

/// A tube about the y axis, of this radius and of height 1.
pub fn tube(radius: f64) -> impl Fn(DVec2) -> DVec3 {
    move |p| {
        let a = -TAU * p.x;
        DVec3::new(radius * libm::cos(a), p.y, radius * libm::sin(a))
    }
}

/// A ball without its poles.
pub fn ball(p: DVec2) -> DVec3 {
    let (a, b) = (-TAU * p.x, TAU * (0.4 * p.y - 0.2));
    DVec3::new(
        libm::cos(b) * libm::cos(a),
        libm::sin(b),
        libm::cos(b) * libm::sin(a),
    )
}

/// A bowl: the inside of a part of a ball.
pub fn bowl(p: DVec2) -> DVec3 {
    let (a, b) = (TAU * p.x, TAU * (0.17 * p.y - 0.24));
    DVec3::new(
        libm::cos(b) * libm::cos(a),
        libm::sin(b),
        libm::cos(b) * libm::sin(a),
    )
}

pub fn saddle(p: DVec2) -> DVec3 {
    let (x, z) = (p.y - 0.5, p.x - 0.5);
    DVec3::new(x, 0.7 * (x * x - z * z), z)
}

pub fn flat(p: DVec2) -> DVec3 {
    DVec3::new(p.y, 0.0, p.x)
}

/// A bent horn that gets thinner.
pub fn horn(p: DVec2) -> DVec3 {
    let (a, t) = (-TAU * p.x, p.y);
    let turn = 2.2 * t;
    let radius = 0.27 * (1.0 - 0.85 * t);
    let out = DVec3::new(libm::cos(turn), -libm::sin(turn), 0.0);
    let middle = DVec3::new(1.0 - libm::cos(turn), libm::sin(turn), 0.0) * 0.8;
    middle + radius * (out * libm::cos(a) + DVec3::Z * libm::sin(a))
}
