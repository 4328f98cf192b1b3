//! Splits edges until all are short enough.
//!
//! The vertices of a mesh tell cells apart, so an edge may be at most [`SHARE`] of a cell long. Edges are split in
//! rounds, the longest first (after Rivara 1984, Algorithms for refining triangular grids). The excess of an edge is
//! its length over the length that it may have. In each round all edges whose excess is near the greatest get a new
//! vertex in their middle; each triangle with one, two or three of these becomes two, three or four. Whether an edge
//! is split depends on the edge alone. So the mesh stays without gaps, the order of triangles has no influence, and
//! the two sides of a cut are split alike. New vertices lie in the old triangles; nothing is smoothed.

use super::{MeshBuilding, NONE, TriMesh};
use crate::notice::{Code, Notice};
use glam::DVec3;

/// The longest edge, as a part of the size of the cells there.
pub const SHARE: f64 = 0.4;
/// The most triangles that a refined mesh may have.
pub const MOST_REFINED: usize = 1_500_000;
/// A round splits edges with at least this share of the greatest excess.
const NEARLY: f64 = 0.6;
/// A mesh with slivers has more triangles than [`SLIVERS`], [`GROWN`] times more than it began with, and [`NEEDLESS`]
/// times more than its area needs.
const SLIVERS: usize = 1 << 17;
const GROWN: usize = 4;
const NEEDLESS: f64 = 16.0;
/// The area of an equilateral triangle, in squares of its side.
const EQUILATERAL: f64 = 0.4330127018922193;
/// Triangles in a slice.
const SLICE: usize = 1 << 14;

/// A mesh with edges short enough.
#[derive(Clone, Debug, PartialEq)]
pub struct Refined {
    /// The mesh: first the old vertices, then the new ones.
    pub mesh: TriMesh,
    /// For each new vertex, in the order of making, the two vertices that it was put between, which may be new, too.
    pub parents: Vec<[u32; 2]>,
    /// For each triangle, the old one that it lies in.
    pub origin: Vec<u32>,
}

/// A mesh whose edges are being split.
pub struct Refining {
    mesh: TriMesh,
    /// For each vertex, the length that edges may have there.
    targets: Vec<f64>,
    parents: Vec<[u32; 2]>,
    origin: Vec<u32>,
    stage: RefiningPhase,
    at: usize,
    /// The greatest ratio of an edge's squared length to the square of its allowed length.
    excess: f64,
    /// Whether the allowed length is the same everywhere; then the count of triangles can be foretold.
    is_even: bool,
    /// How many triangles there were at first.
    began: usize,
    /// A lower bound of the number of triangles at the end.
    least: f64,
    /// For each edge of each triangle its new vertex, or [`NONE`].
    middles: Vec<[u32; 3]>,
    /// Positions of the next mesh, once edges are marked, and its triangles.
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    origins: Vec<u32>,
    building: Option<MeshBuilding>,
}

#[derive(Clone, Copy, PartialEq)]
enum RefiningPhase {
    Measure,
    Mark,
    Split,
    Join,
}

impl Refining {
    /// Starts with a mesh and the length that edges may have at each of its vertices, greater than 0. See [`SHARE`].
    pub fn new(mesh: TriMesh, targets: Vec<f64>) -> Self {
        Self {
            origin: (0..mesh.triangles().len() as u32).collect(),
            began: mesh.triangles().len(),
            targets,
            mesh,
            parents: Vec::new(),
            stage: RefiningPhase::Measure,
            at: 0,
            excess: 0.0,
            is_even: false,
            least: 0.0,
            middles: Vec::new(),
            positions: Vec::new(),
            triangles: Vec::new(),
            origins: Vec::new(),
            building: None,
        }
    }

    /// Starts with the same length everywhere.
    pub fn evenly(mesh: TriMesh, target: f64) -> Self {
        let targets = vec![target; mesh.positions().len()];
        let mut new = Self::new(mesh, targets);
        new.is_even = true;
        new
    }

    /// Does one more slice. `target` gives the length at a new vertex, from its place and from the mean of the
    /// lengths at the two vertices beside it. Returns the mesh when it is done, or a notice if it would be too large.
    pub fn advance(
        &mut self,
        target: &dyn Fn(DVec3, f64) -> f64,
    ) -> Option<Result<Refined, Notice>> {
        if let RefiningPhase::Join = self.stage {
            self.join();
            return None;
        }
        let count = self.mesh.triangles().len();
        let end = count.min(self.at + SLICE);
        for t in self.at..end {
            match self.stage {
                RefiningPhase::Measure => self.measure(t),
                RefiningPhase::Mark => self.mark(t, target),
                _ => self.split(t),
            }
        }
        self.at = end;
        let made = self.triangles.len();
        if self.least.max(made as f64) > MOST_REFINED as f64 {
            return Some(Err(too_many(self.least.max(made as f64))));
        }
        if end < count {
            return None;
        }
        self.at = 0;
        if self.stage == RefiningPhase::Measure && self.excess <= 1.0 {
            return Some(Ok(self.finish()));
        }
        self.begin_next(count);
        None
    }

    /// Does one more slice of the next mesh.
    fn join(&mut self) {
        let (positions, triangles) = (&mut self.positions, &mut self.triangles);
        let building = self.building.get_or_insert_with(|| {
            MeshBuilding::new(std::mem::take(positions), std::mem::take(triangles))
        });
        // Splitting keeps a mesh valid, so there is no fault.
        if let Some(Ok(mesh)) = building.advance() {
            self.mesh = mesh;
            (self.stage, self.building) = (RefiningPhase::Measure, None);
        }
    }

    /// Begins the phase after the present one, which has seen all triangles.
    fn begin_next(&mut self, count: usize) {
        match self.stage {
            RefiningPhase::Measure => {
                self.middles = vec![[NONE; 3]; count];
                // The old vertices come first.
                self.positions = std::mem::take(&mut self.mesh.positions);
                self.stage = RefiningPhase::Mark;
            }
            RefiningPhase::Mark => {
                self.triangles = Vec::with_capacity(2 * count);
                self.origins = Vec::with_capacity(2 * count);
                self.stage = RefiningPhase::Split;
            }
            _ => {
                self.origin = std::mem::take(&mut self.origins);
                (self.mesh, self.middles) = (TriMesh::none(), Vec::new());
                (self.excess, self.least) = (0.0, 0.0);
                self.stage = RefiningPhase::Join;
            }
        }
    }

    /// Whether slivers are being split again and again. A split of both long edges gives three triangles of half the
    /// length, where two would do, and nearly all triangles of a needle come from that. Known only between two rounds,
    /// and only if the allowed length is the same everywhere; else false.
    pub fn has_slivers(&self) -> bool {
        let count = self.mesh.triangles().len();
        let is_between = self.stage == RefiningPhase::Measure && self.at == 0;
        if !is_between || !self.is_even || count < SLIVERS.max(GROWN * self.began) {
            return false;
        }
        let most = EQUILATERAL * self.targets[0] * self.targets[0];
        count as f64 * most > NEEDLESS * self.mesh.area()
    }

    /// The mesh between two rounds, as far as it is refined.
    pub fn into_mesh(self) -> TriMesh {
        self.mesh
    }

    /// Splits to the end; a new vertex gets the mean length of its two parents.
    ///
    /// # Errors
    /// If the mesh would be too large.
    pub fn finish_all(mut self) -> Result<Refined, Notice> {
        loop {
            if let Some(done) = self.advance(&|_, mean| mean) {
                return done;
            }
        }
    }

    fn finish(&mut self) -> Refined {
        let spent = Self::new(TriMesh::none(), Vec::new());
        let done = std::mem::replace(self, spent);
        Refined {
            mesh: done.mesh,
            parents: done.parents,
            origin: done.origin,
        }
    }

    /// The ratio of an edge's squared length to the square of its allowed length.
    fn ratio(&self, t: usize, k: usize) -> f64 {
        let [a, b] = self.ends(t, k).map(|v| v as usize);
        let positions = match self.stage {
            RefiningPhase::Measure => self.mesh.positions(),
            _ => &self.positions,
        };
        let target = self.targets[a].min(self.targets[b]);
        (positions[a] - positions[b]).length_squared() / (target * target)
    }

    fn ends(&self, t: usize, k: usize) -> [u32; 2] {
        let corners = &self.mesh.triangles()[t];
        [corners[k], corners[(k + 1) % 3]]
    }

    fn measure(&mut self, t: usize) {
        for k in 0..3 {
            self.excess = self.excess.max(self.ratio(t, k));
        }
        if self.is_even {
            // The equilateral triangle has the greatest area for a greatest side.
            let most = EQUILATERAL * self.targets[0] * self.targets[0];
            self.least += (self.mesh.area_of(t as u32) / most).max(1.0);
        }
    }

    fn mark(&mut self, t: usize, target: &dyn Fn(DVec3, f64) -> f64) {
        let limit = (NEARLY * NEARLY * self.excess).max(1.0);
        for k in 0..3 {
            if self.middles[t][k] != NONE || self.ratio(t, k) <= limit {
                continue;
            }
            let middle = self.positions.len() as u32;
            let parents = self.ends(t, k);
            let [a, b] = parents.map(|v| v as usize);
            let place = 0.5 * (self.positions[a] + self.positions[b]);
            let mean = 0.5 * (self.targets[a] + self.targets[b]);
            // A target of 0 would never be met.
            let wanted = target(place, mean);
            let wanted = if wanted > 1e-3 * mean {
                wanted
            } else {
                1e-3 * mean
            };
            self.positions.push(place);
            self.targets.push(wanted);
            self.parents.push(parents);
            self.middles[t][k] = middle;
            if let Some((other, edge)) = self.mesh.across(t as u32, k) {
                self.middles[other as usize][edge] = middle;
            }
        }
    }

    fn split(&mut self, t: usize) {
        let corners = self.mesh.triangles()[t];
        let middles = self.middles[t];
        let marked = middles.iter().filter(|&&m| m != NONE).count();
        // Rotate the triangle so that a single marked edge comes first, or a single unmarked one last.
        let first = match marked {
            1 => (0..3).find(|&k| middles[k] != NONE),
            2 => (0..3).find(|&k| middles[(k + 2) % 3] == NONE),
            _ => None,
        };
        let first = first.unwrap_or(0);
        let [a, b, c] = [0, 1, 2].map(|k| corners[(first + k) % 3]);
        let [ab, bc, ca] = [0, 1, 2].map(|k| middles[(first + k) % 3]);
        match marked {
            0 => self.push(t, [a, b, c]),
            1 => {
                self.push(t, [a, ab, c]);
                self.push(t, [ab, b, c]);
            }
            2 => {
                self.push(t, [ab, b, bc]);
                self.quad(t, [a, ab, bc, c]);
            }
            _ => self.four(t, [a, b, c], [ab, bc, ca]),
        }
    }

    fn push(&mut self, t: usize, triangle: [u32; 3]) {
        self.triangles.push(triangle);
        self.origins.push(self.origin[t]);
    }

    fn between(&self, a: u32, b: u32) -> f64 {
        (self.positions[a as usize] - self.positions[b as usize]).length_squared()
    }

    /// Cuts a quadrilateral along its shorter diagonal; if both are equal, through the vertex with the least number.
    fn quad(&mut self, t: usize, [a, b, c, d]: [u32; 4]) {
        let (one, other) = (self.between(a, c), self.between(b, d));
        let alike = (one - other).abs() <= 1e-12 * one;
        let through_a = if alike {
            a.min(c) < b.min(d)
        } else {
            one < other
        };
        if through_a {
            self.push(t, [a, b, c]);
            self.push(t, [a, c, d]);
        } else {
            self.push(t, [a, b, d]);
            self.push(t, [b, c, d]);
        }
    }

    /// Cuts a triangle into four similar ones. If a corner is obtuse, a line joins it to the middle of the opposite
    /// side instead, which makes the angles less obtuse.
    fn four(&mut self, t: usize, [a, b, c]: [u32; 3], [ab, bc, ca]: [u32; 3]) {
        for (corner, opposite, [x, y], [beside_y, beside_x]) in [
            (c, ab, [a, b], [bc, ca]),
            (a, bc, [b, c], [ca, ab]),
            (b, ca, [c, a], [ab, bc]),
        ] {
            // The median of an obtuse corner is shorter than half of the opposite side.
            let median = self.between(corner, opposite);
            if median < 0.25 * self.between(x, y) * (1.0 - 1e-9) {
                self.push(t, [x, opposite, beside_x]);
                self.push(t, [opposite, y, beside_y]);
                self.push(t, [corner, beside_x, opposite]);
                self.push(t, [corner, opposite, beside_y]);
                return;
            }
        }
        self.push(t, [a, ab, ca]);
        self.push(t, [ab, b, bc]);
        self.push(t, [ca, bc, c]);
        self.push(t, [ab, bc, ca]);
    }
}

fn too_many(count: f64) -> Notice {
    // Round the count to two digits.
    let mut unit = 1000.0;
    while count > 100.0 * unit && unit < 1e15 {
        unit *= 10.0;
    }
    let about = ((count.min(1e15) / unit).ceil() * unit) as u64;
    Notice::new(Code::RefinedTooMany)
        .with("n", about.to_string())
        .with("most", MOST_REFINED)
}

#[cfg(test)]
mod tests;
