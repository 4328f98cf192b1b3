//! First triangles of a form: marching tetrahedra (Doi, Koide 1991, An Efficient Method of Triangulating Equi-valued
//! Surfaces by Using Tetrahedral Cells), one layer of cubes at a time.
//!
//! Each cube is cut into six tetrahedra around its diagonal, in the same way in all cubes, so the triangles always
//! close.

use super::form::Form;
use super::jet::JetPoint;
use crate::trimesh::NONE;
use glam::DVec3;

/// The tetrahedra of a cube, with corners as bits of x, y and z. The bool tells whether the order of the corners is
/// right-handed; the second three are mirrored.
const TETRAHEDRA: [([usize; 4], bool); 6] = [
    ([0, 1, 3, 7], true),
    ([0, 2, 6, 7], true),
    ([0, 4, 5, 7], true),
    ([0, 1, 5, 7], false),
    ([0, 2, 3, 7], false),
    ([0, 4, 6, 7], false),
];
/// Cubes along the side of a block. A block is tested as a whole first.
const BLOCK: usize = 4;
/// Vertices keep this part of an edge away from its ends, so that no triangle is without an area.
const AWAY: f64 = 0.08;
/// The margin around the form's bounding box, in cubes.
const MARGIN: f64 = 2.5;
/// The least margin, as a share of the box's diagonal, because boxes are not exact.
const ROOM: f64 = 0.02;

/// The steps of the work on a layer.
#[derive(Clone, Copy)]
enum MarchPhase {
    /// Marks the blocks that may contain the surface.
    Open,
    /// Computes the function at the nodes below and above.
    Below,
    Above,
    /// Makes the triangles.
    Cubes,
}

pub(super) struct March {
    origin: DVec3,
    step: f64,
    /// The number of cubes along each axis, whole blocks.
    cubes: [usize; 3],
    layer: usize,
    /// The next step in the layer.
    part: MarchPhase,
    /// Whether all blocks are computed, without any test.
    whole: bool,
    /// The function at two layers of nodes. Only nodes of open blocks are computed; others keep old values.
    values: [Vec<f64>; 2],
    /// For each node of these layers, the vertices on the seven edges that begin there; [`NONE`] before they are made.
    edges: [Vec<u32>; 2],
    /// For each block of the current layer of blocks, whether it may contain the surface.
    open: Vec<bool>,
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
}

impl March {
    pub fn new(form: &dyn Form, step: f64, whole: bool) -> Self {
        let (lo, hi) = form.bounds();
        let margin = MARGIN.max(ROOM * (hi - lo).length() / step);
        let cubes = ((hi - lo) / step + 2.0 * margin).to_array();
        let cubes = cubes.map(|n| (n / BLOCK as f64).ceil().max(1.0) as usize * BLOCK);
        let size = DVec3::from_array(cubes.map(|n| n as f64 * step));
        let nodes = (cubes[0] + 1) * (cubes[1] + 1);
        Self {
            origin: 0.5 * (lo + hi - size),
            step,
            cubes,
            layer: 0,
            part: MarchPhase::Open,
            whole,
            values: std::array::from_fn(|_| vec![1.0; nodes]),
            edges: std::array::from_fn(|_| vec![NONE; 7 * nodes]),
            open: Vec::new(),
            positions: Vec::new(),
            triangles: Vec::new(),
        }
    }

    fn node(&self, x: usize, y: usize, z: usize) -> DVec3 {
        self.origin + DVec3::new(x as f64, y as f64, z as f64) * self.step
    }

    /// Does one step of a layer; true when all layers are done.
    pub fn advance(&mut self, form: &dyn Form) -> bool {
        let is_first = self.layer.is_multiple_of(BLOCK);
        self.part = match self.part {
            MarchPhase::Open => {
                if is_first {
                    self.open_blocks(form);
                }
                MarchPhase::Below
            }
            MarchPhase::Below => {
                if is_first {
                    // The layer of blocks before may have skipped nodes that this one needs.
                    self.fill(form, 0, self.layer);
                }
                MarchPhase::Above
            }
            MarchPhase::Above => {
                self.fill(form, 1, self.layer + 1);
                MarchPhase::Cubes
            }
            MarchPhase::Cubes => {
                self.cubes();
                MarchPhase::Open
            }
        };
        self.layer == self.cubes[2]
    }

    /// Makes the triangles of the layer.
    fn cubes(&mut self) {
        let [nx, ny, _] = self.cubes;
        for y in 0..ny {
            for x in 0..nx {
                if self.open[x / BLOCK + y / BLOCK * (nx / BLOCK)] {
                    self.cube(x, y);
                }
            }
        }
        self.values.swap(0, 1);
        self.edges.swap(0, 1);
        self.edges[1].fill(NONE);
        self.layer += 1;
    }

    pub fn is_whole(&self) -> bool {
        self.whole
    }

    /// Takes the vertices and triangles.
    pub fn take(&mut self) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        (
            std::mem::take(&mut self.positions),
            std::mem::take(&mut self.triangles),
        )
    }

    fn open_blocks(&mut self, form: &dyn Form) {
        let half = 0.5 * BLOCK as f64;
        let reach = form.steepest() * half * self.step * 3.0_f64.sqrt();
        let [bx, by] = [self.cubes[0] / BLOCK, self.cubes[1] / BLOCK];
        self.open.clear();
        for y in 0..by {
            for x in 0..bx {
                let corner = self.node(x * BLOCK, y * BLOCK, self.layer);
                let middle = corner + DVec3::splat(half * self.step);
                self.open
                    .push(self.whole || form.at(JetPoint::new(middle)).value.abs() <= reach);
            }
        }
    }

    /// Computes the function at the nodes of a layer that belong to an open block.
    fn fill(&mut self, form: &dyn Form, side: usize, z: usize) {
        let [nx, ny, _] = self.cubes;
        let [bx, by] = [nx / BLOCK, ny / BLOCK];
        for y in 0..=ny {
            for x in 0..=nx {
                let near = |k: usize, last: usize| {
                    let after = (k / BLOCK).min(last - 1);
                    let before = if k.is_multiple_of(BLOCK) {
                        after.min((k / BLOCK).saturating_sub(1))
                    } else {
                        after
                    };
                    before..=after
                };
                let wanted = near(y, by).any(|j| near(x, bx).any(|i| self.open[i + j * bx]));
                if wanted {
                    let value = form.at(JetPoint::new(self.node(x, y, z))).value;
                    self.values[side][x + y * (nx + 1)] = value;
                }
            }
        }
    }

    fn cube(&mut self, x: usize, y: usize) {
        let row = self.cubes[0] + 1;
        let at = |corner: usize| x + (corner & 1) + (y + (corner >> 1 & 1)) * row;
        let values: [f64; 8] = std::array::from_fn(|c| self.values[c >> 2][at(c)]);
        let inside = values.map(|v| v < 0.0);
        if inside.iter().all(|&v| v) || inside.iter().all(|&v| !v) {
            return;
        }
        for (corners, right) in TETRAHEDRA {
            // Sort inner corners first. Each exchange mirrors the tetrahedron.
            let mut order = corners;
            let mut right = right;
            let mut count = 0;
            for k in 0..4 {
                if inside[order[k]] {
                    // One exchange for every corner that it passes.
                    for j in (count..k).rev() {
                        order.swap(j, j + 1);
                        right = !right;
                    }
                    count += 1;
                }
            }
            let [a, b, c, d] = order;
            let mut vertex = |from: usize, to: usize| self.vertex([x, y], &values, from, to);
            let found = match count {
                1 => vec![[vertex(a, b), vertex(a, c), vertex(a, d)]],
                2 => {
                    let [p, q, r, s] = [vertex(a, c), vertex(a, d), vertex(b, d), vertex(b, c)];
                    vec![[p, q, r], [r, s, p]]
                }
                3 => vec![[vertex(a, d), vertex(b, d), vertex(c, d)]],
                _ => continue,
            };
            for [a, b, c] in found {
                self.triangles
                    .push(if right { [a, b, c] } else { [a, c, b] });
            }
        }
    }

    /// The vertex on an edge of a cube of the layer; made when it is first needed.
    fn vertex(&mut self, at: [usize; 2], values: &[f64; 8], from: usize, to: usize) -> u32 {
        let (low, high) = (from & to, from | to);
        let [x, y] = [at[0] + (low & 1), at[1] + (low >> 1 & 1)];
        let key = (x + y * (self.cubes[0] + 1)) * 7 + (high - low) - 1;
        let known = self.edges[low >> 2][key];
        if known != NONE {
            return known;
        }
        let place = |c: usize| {
            let [x, y, z] = [at[0] + (c & 1), at[1] + (c >> 1 & 1), self.layer + (c >> 2)];
            self.node(x, y, z)
        };
        let (a, b) = (values[low], values[high]);
        let share = (a / (a - b)).clamp(AWAY, 1.0 - AWAY);
        let p = place(low);
        let made = self.positions.len() as u32;
        let q = p + (place(high) - p) * share;
        self.positions.push(q);
        self.edges[low >> 2][key] = made;
        made
    }
}
