//! The domain's triangles, divided at the centres of cells.
//!
//! Each cell's centre is a vertex here. So every cell has at least this vertex, however coarse the domain is.

use crate::surface_packing::SurfaceParticle;
use crate::trimesh::{NONE, SurfacePoint, TriMesh};
use glam::DVec3;

/// Triangles to copy in a slice.
const TRIANGLES: usize = 100_000;
/// Cells to insert in a slice.
const CELLS: usize = 20_000;

/// The divided triangles. The domain's vertices come first, then the cells' centres, in the order of the cells.
pub(super) struct Divided {
    pub triangles: Vec<[u32; 3]>,
    /// For each triangle, the neighbours over the edges from each corner to the next.
    pub across: Vec<[u32; 3]>,
    /// How many vertices the domain has.
    pub vertices: usize,
    /// How many triangles the domain has.
    whole: usize,
    /// For each triangle after the domain's, the triangle of the domain that it is a piece of.
    home: Vec<u32>,
    /// Cells sorted by the triangle that they lie in.
    order: Vec<u32>,
    put: usize,
    /// The pieces of the triangle that is being divided.
    pieces: Vec<u32>,
    /// The neighbours of all vertices, one list after the other.
    start: Vec<u32>,
    near: Vec<u32>,
    next: DividedPhase,
}

/// The next slice of work.
enum DividedPhase {
    Copy,
    Put,
    Count,
    Fill(usize),
    Nothing,
}

impl Divided {
    /// Starts with a domain and the cells on it.
    pub fn new(mesh: &TriMesh, cells: &[SurfaceParticle]) -> Self {
        let mut order: Vec<u32> = (0..cells.len() as u32).collect();
        order.sort_unstable_by_key(|&c| (cells[c as usize].centre.triangle, c));
        let count = mesh.triangles().len() + 2 * cells.len();
        Self {
            triangles: Vec::with_capacity(count),
            across: Vec::with_capacity(count),
            vertices: mesh.positions().len(),
            whole: mesh.triangles().len(),
            home: Vec::new(),
            order,
            put: 0,
            pieces: Vec::new(),
            start: Vec::new(),
            near: Vec::new(),
            next: DividedPhase::Copy,
        }
    }

    /// Does one more slice; true when done.
    pub fn advance(&mut self, mesh: &TriMesh, cells: &[SurfaceParticle]) -> bool {
        self.next = match self.next {
            DividedPhase::Copy => {
                let all = mesh.triangles();
                let from = self.triangles.len();
                let to = all.len().min(from + TRIANGLES);
                self.triangles.extend_from_slice(&all[from..to]);
                let across = |t: usize| [0, 1, 2].map(|k| beyond(mesh, t as u32, k));
                self.across.extend((from..to).map(across));
                if to < all.len() {
                    DividedPhase::Copy
                } else {
                    DividedPhase::Put
                }
            }
            DividedPhase::Put => {
                let end = self.order.len().min(self.put + CELLS);
                while self.put < end {
                    self.put_next(mesh, cells);
                }
                if end < self.order.len() {
                    DividedPhase::Put
                } else {
                    DividedPhase::Count
                }
            }
            DividedPhase::Count => {
                self.count(self.vertices + cells.len());
                DividedPhase::Fill(0)
            }
            DividedPhase::Fill(from) => {
                let to = self.triangles.len().min(from + TRIANGLES);
                self.fill(from, to);
                if to < self.triangles.len() {
                    DividedPhase::Fill(to)
                } else {
                    // Filling has moved each start to its end: move them back by one place.
                    self.start.rotate_right(1);
                    self.start[0] = 0;
                    DividedPhase::Nothing
                }
            }
            DividedPhase::Nothing => DividedPhase::Nothing,
        };
        matches!(self.next, DividedPhase::Nothing)
    }

    /// The vertices joined with this one by an edge.
    pub fn near(&self, vertex: u32) -> &[u32] {
        let v = vertex as usize;
        &self.near[self.start[v] as usize..self.start[v + 1] as usize]
    }

    /// The number of the edge of `u` that goes from `a` to `b`.
    pub fn edge(&self, u: u32, a: u32, b: u32) -> usize {
        let corners = &self.triangles[u as usize];
        (0..3)
            .find(|&j| corners[j] == a && corners[(j + 1) % 3] == b)
            .unwrap_or(0)
    }

    /// Divides the triangle in which the next cell lies into three.
    fn put_next(&mut self, mesh: &TriMesh, cells: &[SurfaceParticle]) {
        let cell = self.order[self.put];
        let home = cells[cell as usize].centre.triangle;
        let last = self.put.checked_sub(1).map(|k| self.order[k]);
        if last.map(|c| cells[c as usize].centre.triangle) != Some(home) {
            self.pieces.clear();
            self.pieces.push(home);
        }
        self.put += 1;
        let t = self.piece_at(mesh, cells, cells[cell as usize].centre.at);
        let p = self.vertices as u32 + cell;
        let [a, b, c] = self.triangles[t as usize];
        let [ab, bc, ca] = self.across[t as usize];
        let (u, v) = (self.triangles.len() as u32, self.triangles.len() as u32 + 1);
        self.triangles[t as usize] = [a, b, p];
        self.across[t as usize] = [ab, u, v];
        self.triangles.extend([[b, c, p], [c, a, p]]);
        self.across.extend([[bc, v, t], [ca, t, u]]);
        for (outer, from, to, new) in [(bc, b, c, u), (ca, c, a, v)] {
            if outer != NONE {
                let k = self.edge(outer, to, from);
                self.across[outer as usize][k] = new;
            }
        }
        self.home.extend([home, home]);
        self.pieces.extend([u, v]);
    }

    /// The middle of a triangle.
    pub fn middle(&self, mesh: &TriMesh, cells: &[SurfaceParticle], t: u32) -> SurfacePoint {
        let corners = self.corners(mesh, cells, t);
        let home = match (t as usize).checked_sub(self.whole) {
            Some(piece) => self.home[piece],
            None => t,
        };
        let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        let weights = mesh.weights(home, middle).max(DVec3::ZERO);
        SurfacePoint::new(mesh, home, weights / (weights.x + weights.y + weights.z))
    }

    fn corners(&self, mesh: &TriMesh, cells: &[SurfaceParticle], t: u32) -> [DVec3; 3] {
        self.triangles[t as usize].map(|v| match (v as usize).checked_sub(self.vertices) {
            Some(cell) => cells[cell].centre.at,
            None => mesh.positions()[v as usize],
        })
    }

    /// The piece of the current triangle in which a point lies.
    fn piece_at(&self, mesh: &TriMesh, cells: &[SurfaceParticle], p: DVec3) -> u32 {
        let mut best = (self.pieces[0], f64::NEG_INFINITY);
        if self.pieces.len() == 1 {
            return best.0;
        }
        for &t in &self.pieces {
            let [a, b, c] = self.corners(mesh, cells, t);
            let normal = (b - a).cross(c - a);
            let square = normal.length_squared();
            let of = |q: DVec3, r: DVec3| (q - p).cross(r - p).dot(normal) / square;
            let least = of(b, c).min(of(c, a)).min(of(a, b));
            if square > 0.0 && least > best.1 {
                best = (t, least);
            }
        }
        best.0
    }

    /// Calls `each` with the pairs (vertex, neighbour) of a triangle's edges. Each edge is given in one direction, as
    /// the triangle across it gives the other direction; an edge on the border is given in both.
    fn each_near(&self, t: usize, mut each: impl FnMut(u32, u32)) {
        let corners = self.triangles[t];
        for k in 0..3 {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            each(a, b);
            if self.across[t][k] == NONE {
                each(b, a);
            }
        }
    }

    fn count(&mut self, vertices: usize) {
        let mut start = vec![0; vertices + 1];
        for t in 0..self.triangles.len() {
            self.each_near(t, |a, _| start[a as usize] += 1);
        }
        let mut sum = 0;
        for count in &mut start {
            sum += std::mem::replace(count, sum);
        }
        self.near = vec![0; sum as usize];
        self.start = start;
    }

    fn fill(&mut self, from: usize, to: usize) {
        let (mut start, mut near) = (
            std::mem::take(&mut self.start),
            std::mem::take(&mut self.near),
        );
        for t in from..to {
            self.each_near(t, |a, b| {
                near[start[a as usize] as usize] = b;
                start[a as usize] += 1;
            });
        }
        (self.start, self.near) = (start, near);
    }
}

fn beyond(mesh: &TriMesh, t: u32, k: usize) -> u32 {
    mesh.across(t, k).map_or(NONE, |(other, _)| other)
}
