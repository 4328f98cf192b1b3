//! Closes holes that are small compared with a cell, and finds parts of the surface that are.

use super::super::borders::PartSearch;
use super::super::{MeshBuilding, TriMesh, polygon};
use super::loops::{Loop, LoopCutting};
use super::slice;
use crate::notice::{Code, Notice};
use glam::DVec3;
use std::sync::Arc;

/// A hole is closed only if its border is shorter than this many cells' sides.
const HOLE: f64 = 4.0;
/// A hole is closed only if the part of the surface around it has more than this many times the hole's area: the outer
/// border of a small patch is not a hole.
const PART: f64 = 4.0;
/// A part with at least the area of a cell counts as small, too, if its mean width, from border to border, is less than
/// this share of a cell's side. A cell there would be a needle of thousands of corners.
const NARROW: f64 = 1.0 / 32.0;
/// Corners of holes in a slice.
const CORNERS: usize = 256;

/// A surface without small holes.
#[derive(Clone, Debug, PartialEq)]
pub struct Filled {
    /// The surface: its old vertices and triangles come first, in their order. It is the given one if no hole is closed.
    pub mesh: Arc<TriMesh>,
    /// For each triangle, whether its part of the surface is smaller than a cell and therefore has no cells.
    pub bare: Vec<bool>,
    /// Notices of the changes, and of small parts.
    pub notices: Vec<Notice>,
}

/// Closes holes of a surface.
pub struct HoleFilling {
    mesh: Arc<TriMesh>,
    size: f64,
    stage: FillingPhase,
    at: usize,
    parts: PartSearch,
    cutting: LoopCutting,
    loops: Vec<Loop>,
    /// Pairs of vertices to merge.
    welds: Vec<[u32; 2]>,
    part: Vec<u32>,
    areas: Vec<f64>,
    /// The length of the borders of each part.
    lengths: Vec<f64>,
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    filled: usize,
    building: Option<MeshBuilding>,
}

#[derive(Clone, Copy, PartialEq)]
enum FillingPhase {
    Parts,
    Areas,
    Rings,
    Fill,
    Build,
}

impl HoleFilling {
    /// Starts with a surface and the side of a cell of mean size.
    pub fn new(mesh: impl Into<Arc<TriMesh>>, size: f64) -> Self {
        Self {
            mesh: mesh.into(),
            size,
            stage: FillingPhase::Parts,
            at: 0,
            parts: PartSearch::default(),
            cutting: LoopCutting::default(),
            loops: Vec::new(),
            welds: Vec::new(),
            part: Vec::new(),
            areas: Vec::new(),
            lengths: Vec::new(),
            positions: Vec::new(),
            triangles: Vec::new(),
            filled: 0,
            building: None,
        }
    }

    /// Does one more slice. Returns the surface when it is done, or a notice if it is smaller than a cell.
    pub fn advance(&mut self) -> Option<Result<Filled, Notice>> {
        match self.stage {
            FillingPhase::Parts => {
                if self.parts.advance(&self.mesh) {
                    let parts = std::mem::take(&mut self.parts);
                    self.part = parts.part;
                    self.areas = vec![0.0; parts.count];
                    self.lengths = vec![0.0; parts.count];
                    self.stage = FillingPhase::Areas;
                }
            }
            FillingPhase::Areas => {
                let count = self.part.len();
                for t in slice(&mut self.at, count) {
                    self.measure(t);
                }
                if self.at == count {
                    (self.stage, self.at) = (FillingPhase::Rings, 0);
                }
            }
            FillingPhase::Rings => {
                self.loops = self.cutting.advance(&self.mesh)?;
                self.cutting = LoopCutting::default();
                self.stage = FillingPhase::Fill;
            }
            FillingPhase::Fill => {
                let mut corners = 0;
                while self.at < self.loops.len() && corners < CORNERS {
                    let ring = std::mem::take(&mut self.loops[self.at]);
                    corners += ring.corners.len();
                    self.fill(&ring);
                    self.at += 1;
                }
                if self.at == self.loops.len() {
                    if self.filled == 0 {
                        return Some(self.finish());
                    }
                    self.begin_to_build();
                }
            }
            FillingPhase::Build => {
                let mesh = self.building.as_mut()?.advance()?;
                // No edge is added where one exists, so this is a mesh. If it were none, the surface would keep its
                // holes, and no notice would say that some were closed.
                match mesh {
                    Ok(mesh) => self.mesh = Arc::new(mesh),
                    Err(_) => self.filled = 0,
                }
                return Some(self.finish());
            }
        }
        None
    }

    /// Does all the work at once.
    ///
    /// # Errors
    /// If the whole surface is smaller than a cell.
    pub fn fill_all(mesh: TriMesh, size: f64) -> Result<Filled, Notice> {
        let mut filling = Self::new(mesh, size);
        loop {
            if let Some(done) = filling.advance() {
                return done;
            }
        }
    }

    fn measure(&mut self, t: usize) {
        let part = self.part[t] as usize;
        self.areas[part] += self.mesh.area_of(t as u32);
        let corners = self.mesh.corners(t as u32);
        for k in (0..3).filter(|&k| self.mesh.across(t as u32, k).is_none()) {
            self.lengths[part] += corners[k].distance(corners[(k + 1) % 3]);
        }
    }

    /// Whether a part is smaller than a cell, or much narrower.
    fn is_small(&self, part: usize) -> bool {
        let area = self.areas[part];
        area < self.size * self.size || 2.0 * area < NARROW * self.size * self.lengths[part]
    }

    fn fill(&mut self, hole: &Loop) {
        // Seen from the hole, the border runs the other way.
        let ring: Vec<u32> = hole.corners.iter().rev().copied().collect();
        let places = ring.iter().map(|&v| self.mesh.positions()[v as usize]);
        let places: Vec<DVec3> = places.collect();
        let next = |k: usize| (k + 1) % places.len();
        let lengths: Vec<f64> = (0..places.len())
            .map(|k| (places[next(k)] - places[k]).length())
            .collect();
        let length: f64 = lengths.iter().sum();
        // This comes first: the border of a whole part may have as many corners as its file.
        if length >= HOLE * self.size || ring.len() < 3 {
            return;
        }
        let Some((beside, _)) = self.mesh.fan(ring[0]).next() else {
            return;
        };
        let area = 0.5 * polygon::across(&places).length();
        let number = self.part[beside as usize] as usize;
        let part = self.areas[number];
        if part <= PART * area {
            return;
        }
        let may_join = |i: usize, j: usize| !hole.are_joined(&self.mesh, ring[i], ring[j]);
        self.filled += 1;
        self.welds.extend(&hole.twins);
        self.areas[number] += area;
        self.lengths[number] -= length;
        if let Some(cut) = polygon::cut(&places, may_join) {
            self.triangles
                .extend(cut.iter().map(|t| t.map(|k| ring[k])));
            return;
        }
        // A fan around the border's middle.
        let weighted = (0..places.len()).map(|k| 0.5 * (places[k] + places[next(k)]) * lengths[k]);
        let middle = weighted.sum::<DVec3>() / length;
        let centre = (self.mesh.positions().len() + self.positions.len()) as u32;
        self.positions.push(middle);
        self.triangles
            .extend((0..ring.len()).map(|k| [ring[k], ring[next(k)], centre]));
    }

    fn begin_to_build(&mut self) {
        let mut positions = self.mesh.positions().to_vec();
        positions.append(&mut self.positions);
        let mut triangles = self.mesh.triangles().to_vec();
        for t in &self.triangles {
            let (beside, _) = self.mesh.fan(t[0]).next().unwrap_or_default();
            self.part.push(self.part[beside as usize]);
        }
        triangles.append(&mut self.triangles);
        if !self.welds.is_empty() {
            let into = welded(positions.len(), &self.welds);
            for t in &mut triangles {
                *t = t.map(|v| into[v as usize]);
            }
        }
        self.building = Some(MeshBuilding::new(positions, triangles));
        self.stage = FillingPhase::Build;
    }

    fn finish(&mut self) -> Result<Filled, Notice> {
        let is_small: Vec<bool> = (0..self.areas.len()).map(|k| self.is_small(k)).collect();
        let small = is_small.iter().filter(|&&small| small).count();
        if small == self.areas.len() {
            return Err(Code::ModelTooSmall.into());
        }
        let told = [(Code::MendedHoles, self.filled), (Code::ModelBare, small)];
        let told = told.into_iter().filter(|(_, n)| *n > 0);
        Ok(Filled {
            bare: self.part[..self.mesh.triangles().len()]
                .iter()
                .map(|&part| is_small[part as usize])
                .collect(),
            mesh: std::mem::replace(&mut self.mesh, Arc::new(TriMesh::none())),
            notices: told
                .map(|(code, n)| Notice::new(code).with("n", n))
                .collect(),
        })
    }
}

impl Loop {
    /// Whether an edge joins two of the loop's corners or their twins.
    fn are_joined(&self, mesh: &TriMesh, a: u32, b: u32) -> bool {
        let all = |v: u32| {
            let twins = self.twins.iter().filter(move |t| t.contains(&v));
            twins.flatten().copied().chain([v])
        };
        all(a).any(|a| all(b).any(|b| are_joined(mesh, a, b)))
    }
}

/// The vertex that each of `count` vertices becomes: the least of those that are merged.
fn welded(count: usize, welds: &[[u32; 2]]) -> Vec<u32> {
    let mut into: Vec<u32> = (0..count as u32).collect();
    let root = |into: &[u32], mut v: u32| {
        while into[v as usize] != v {
            v = into[v as usize];
        }
        v
    };
    for &[a, b] in welds {
        let (a, b) = (root(&into, a), root(&into, b));
        into[a.max(b) as usize] = a.min(b);
    }
    // Each vertex leads to one with a lower number, whose entry is final by now.
    for v in 0..count {
        into[v] = into[into[v] as usize];
    }
    into
}

/// Whether an edge joins two vertices.
fn are_joined(mesh: &TriMesh, a: u32, b: u32) -> bool {
    mesh.fan(a)
        .any(|(t, _)| mesh.triangles()[t as usize].contains(&b))
}

#[cfg(test)]
mod tests {
    use super::super::MeshRepair;
    use super::*;
    use crate::trimesh::{Soup, testing};

    #[test]
    fn holes_that_touch_are_closed_each_by_itself() {
        let (positions, triangles) = testing::flat(7);
        let mesh = testing::mesh((positions.clone(), triangles.clone()));
        let fan = |v: u32| mesh.fan(v).map(|(t, _)| t).collect::<Vec<_>>();
        let mut tried = [0; 2];
        for middle in 0..positions.len() as u32 {
            // Take out two triangles at a vertex that are not neighbours; at the border, one that has no edge on it.
            let around = fan(middle);
            let is_border = mesh.is_on_border(middle);
            let gone = match (is_border, around.len()) {
                (false, 4..) => vec![around[0], around[2]],
                (true, 3..) => vec![around[1]],
                _ => continue,
            };
            let ends = gone.iter().flat_map(|&t| triangles[t as usize]);
            if ends.filter(|&v| mesh.is_on_border(v)).count() > usize::from(is_border) {
                continue;
            }
            tried[usize::from(is_border)] += 1;
            let kept = (0..triangles.len()).filter(|&t| !gone.contains(&(t as u32)));
            let soup = Soup {
                positions: positions.clone(),
                triangles: kept.map(|t| triangles[t]).collect(),
            };
            let mended = MeshRepair::mend(soup).expect("a surface").mesh;
            let filled = HoleFilling::fill_all(mended, 0.2).expect("a surface").mesh;
            assert_eq!((filled.euler(), filled.borders().len()), (1, 1));
            assert!((filled.area() - 1.0).abs() < 1e-12);
            for t in 0..filled.triangles().len() as u32 {
                assert!(filled.face_normal(t).y > 0.99);
            }
        }
        assert!(tried[0] > 9 && tried[1] > 3, "{tried:?}");
    }
}
