//! Closed triangle surfaces from grids of places.

use super::Mark;
use crate::field::smoothstep;
use crate::trimesh::{TriMesh, box_triangles};
use glam::DVec3;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// A vertex: its place and its mark.
pub(super) type Spot = (DVec3, Mark);

/// A closed surface in progress.
#[derive(Clone, Debug, Default)]
pub(super) struct Shell {
    pub positions: Vec<DVec3>,
    pub marks: Vec<Mark>,
    pub triangles: Vec<[u32; 3]>,
}

impl Shell {
    fn push(&mut self, (place, mark): Spot) -> u32 {
        self.positions.push(place);
        self.marks.push(mark);
        self.positions.len() as u32 - 1
    }

    fn quad(&mut self, [a, b, c, d]: [u32; 4]) {
        self.triangles.extend([[a, b, c], [a, c, d]]);
    }

    /// A tube with poles: `rings` rings of `around` vertices, of which the first and the last shrink to a vertex.
    /// `place` gets the number of the ring and the angle, 0 to 2 pi.
    pub fn tube(rings: usize, around: usize, place: impl Fn(usize, f64) -> Spot) -> Self {
        let mut shell = Self::default();
        let first = shell.push(place(0, 0.0));
        for ring in 1..rings - 1 {
            for k in 0..around {
                shell.push(place(ring, angle(k, around)));
            }
        }
        let last = shell.push(place(rings - 1, 0.0));
        let at = |ring: usize, k: usize| 1 + ((ring - 1) * around + k % around) as u32;
        for k in 0..around {
            shell.triangles.push([first, at(1, k), at(1, k + 1)]);
            let end = rings - 2;
            shell.triangles.push([last, at(end, k + 1), at(end, k)]);
            for ring in 1..end {
                let next = ring + 1;
                shell.quad([at(ring, k), at(next, k), at(next, k + 1), at(ring, k + 1)]);
            }
        }
        shell.outwards()
    }

    /// A tube that closes on itself, like a torus; see [`Self::tube`].
    pub fn ring(rings: usize, around: usize, place: impl Fn(usize, f64) -> Spot) -> Self {
        let mut shell = Self::default();
        for ring in 0..rings {
            for k in 0..around {
                shell.push(place(ring, angle(k, around)));
            }
        }
        let at = |ring: usize, k: usize| (ring % rings * around + k % around) as u32;
        for ring in 0..rings {
            for k in 0..around {
                let next = ring + 1;
                shell.quad([at(ring, k), at(next, k), at(next, k + 1), at(ring, k + 1)]);
            }
        }
        shell.outwards()
    }

    /// A sheet with two sides: a grid of `rows` times `columns` places on each side, which share those of the border.
    /// `place` gets the side (1 or -1), the row and the column.
    pub fn sheet(rows: usize, columns: usize, place: impl Fn(f64, usize, usize) -> Spot) -> Self {
        let mut shell = Self::default();
        let is_rim = |r: usize, c: usize| r == 0 || c == 0 || r == rows - 1 || c == columns - 1;
        let mut numbers = [vec![0; rows * columns], vec![0; rows * columns]];
        for r in 0..rows {
            for c in 0..columns {
                let top = shell.push(place(1.0, r, c));
                numbers[0][r * columns + c] = top;
                numbers[1][r * columns + c] = match is_rim(r, c) {
                    true => top,
                    false => shell.push(place(-1.0, r, c)),
                };
            }
        }
        for (side, numbers) in numbers.iter().enumerate() {
            for r in 0..rows - 1 {
                for c in 0..columns - 1 {
                    let k = r * columns + c;
                    let mut quad = [k, k + 1, k + columns + 1, k + columns].map(|k| numbers[k]);
                    // Diagonals start at the sheet's corners: others would cut off the same triangle on both sides.
                    if (r < rows / 2) != (c < columns / 2) {
                        quad.rotate_left(1);
                    }
                    if side == 1 {
                        quad.swap(1, 3);
                    }
                    shell.quad(quad);
                }
            }
        }
        shell.outwards()
    }

    /// The ball as an icosahedron whose edges are cut into `cuts` pieces; `place` maps unit vectors.
    pub fn ball(cuts: u32, place: impl Fn(DVec3) -> Spot) -> Self {
        let (corners, faces) = icosahedron();
        let mut shell = Self::default();
        let mut numbers: BTreeMap<Vec<(u32, u32)>, u32> = BTreeMap::new();
        for face in faces {
            let mut number = |i: u32, j: u32| {
                let parts = [cuts - i - j, i, j];
                let mut key: Vec<(u32, u32)> = face.into_iter().zip(parts).collect();
                key.retain(|&(_, part)| part > 0);
                key.sort_unstable();
                let sum = key.iter().map(|&(v, n)| corners[v as usize] * f64::from(n));
                let at = sum.sum::<DVec3>().normalize();
                *numbers.entry(key).or_insert_with(|| shell.push(place(at)))
            };
            let mut found = Vec::new();
            for i in 0..cuts {
                for j in 0..cuts - i {
                    found.push([number(i, j), number(i + 1, j), number(i, j + 1)]);
                    if i + j + 1 < cuts {
                        let far = number(i + 1, j + 1);
                        found.push([number(i + 1, j), far, number(i, j + 1)]);
                    }
                }
            }
            shell.triangles.extend(found);
        }
        shell.outwards()
    }

    /// The surface of a cube whose sides are cut at `cuts`, increasing from -1 to 1; `place` maps its points.
    pub fn cube(cuts: &[f64], place: impl Fn(DVec3) -> Spot) -> Self {
        let mut shell = Self::default();
        shell.triangles = box_triangles([cuts.len() - 1; 3], |at| {
            shell.push(place(DVec3::from(at.map(|k| cuts[k]))))
        });
        shell.outwards()
    }

    /// Turns all triangles round if the volume is negative, so that they face outwards.
    fn outwards(mut self) -> Self {
        let six = self.triangles.iter().map(|t| {
            let [a, b, c] = t.map(|v| self.positions[v as usize]);
            a.dot(b.cross(c))
        });
        if six.sum::<f64>() < 0.0 {
            self.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        }
        self
    }

    /// The mesh with the marks of its vertices.
    pub fn into_mesh(self) -> (TriMesh, Vec<Mark>) {
        let mesh = TriMesh::new(self.positions, self.triangles);
        (mesh.expect("a closed surface"), self.marks)
    }
}

fn angle(k: usize, around: usize) -> f64 {
    TAU * k as f64 / around as f64
}

/// The corners and the faces of the icosahedron.
fn icosahedron() -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let (a, b) = (1.0, 0.5 * (1.0 + 5f64.sqrt()));
    let mut corners = Vec::new();
    for (p, q) in [(a, b), (-a, b), (a, -b), (-a, -b)] {
        corners.extend([
            DVec3::new(0.0, p, q),
            DVec3::new(p, q, 0.0),
            DVec3::new(q, 0.0, p),
        ]);
    }
    let corners: Vec<DVec3> = corners.into_iter().map(DVec3::normalize).collect();
    let near = |i: usize, j: usize| corners[i].dot(corners[j]) > 0.4;
    let mut faces = Vec::new();
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                if near(i, j) && near(j, k) && near(i, k) {
                    let out = corners[i].dot(corners[j].cross(corners[k])) > 0.0;
                    let face = if out { [i, j, k] } else { [i, k, j] };
                    faces.push(face.map(|v| v as u32));
                }
            }
        }
    }
    (corners, faces)
}

/// The cosine and the sine.
pub(super) fn turned(angle: f64) -> (f64, f64) {
    (libm::cos(angle), libm::sin(angle))
}

/// A bell curve: 1 at 0, and about 0 beyond 2.
pub(super) fn bell(x: f64) -> f64 {
    libm::exp(-x * x)
}

/// Rises smoothly from 0 at `from` to 1 at `to`.
pub(super) fn step(from: f64, to: f64, x: f64) -> f64 {
    smoothstep((x - from) / (to - from))
}

/// A point of the smooth curve through these points (Catmull, Rom 1974, A Class of Local Interpolating Splines); `at`
/// is 0 at the first point, 1 at the second, and so on.
pub(super) fn curve<const N: usize>(points: &[[f64; N]], at: f64) -> [f64; N] {
    let last = points.len() - 1;
    let k = (at as usize).min(last - 1);
    let t = at - k as f64;
    let point = |k: isize| points[k.clamp(0, last as isize) as usize];
    let [p, q, r, s] = [-1, 0, 1, 2].map(|d| point(k as isize + d));
    std::array::from_fn(|n| {
        let (out, into) = (0.5 * (r[n] - p[n]), 0.5 * (s[n] - q[n]));
        let (t2, t3) = (t * t, t * t * t);
        q[n] * (2.0 * t3 - 3.0 * t2 + 1.0)
            + r[n] * (3.0 * t2 - 2.0 * t3)
            + out * (t3 - 2.0 * t2 + t)
            + into * (t3 - t2)
    })
}
