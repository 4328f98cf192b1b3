//! Holes and parts that are small beside the cells.

use super::super::{MeshBuilding, TriMesh, polygon};
use super::slice;
use crate::notice::{Code, Notice};
use glam::DVec3;

/// Holes whose border is shorter than so many cells are closed.
const HOLE: f64 = 4.0;
/// A border closes a hole only in a part of at least so many times the hole's area: a lone patch has an outer border.
const PART: f64 = 4.0;
/// Corners of holes of a slice.
const CORNERS: usize = 256;

/// A surface without small holes.
#[derive(Clone, Debug, PartialEq)]
pub struct Filled {
    /// The surface: its old vertices and triangles come first, in their order.
    pub mesh: TriMesh,
    /// Of each triangle, whether it is of a part smaller than a cell, where there is to be none.
    pub bare: Vec<bool>,
    /// What was done, or is to be said.
    pub notices: Vec<Notice>,
}

/// Closes holes of a surface.
pub struct Filling {
    mesh: TriMesh,
    size: f64,
    stage: Stage,
    at: usize,
    rings: Vec<Vec<u32>>,
    part: Vec<u32>,
    areas: Vec<f64>,
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    filled: usize,
    building: Option<MeshBuilding>,
}

#[derive(Clone, Copy, PartialEq)]
enum Stage {
    Parts,
    Areas,
    Rings,
    Fill,
    Build,
}

impl Filling {
    /// Of a surface, and the side of a cell of mean size.
    pub fn new(mesh: TriMesh, size: f64) -> Self {
        Self {
            mesh,
            size,
            stage: Stage::Parts,
            at: 0,
            rings: Vec::new(),
            part: Vec::new(),
            areas: Vec::new(),
            positions: Vec::new(),
            triangles: Vec::new(),
            filled: 0,
            building: None,
        }
    }

    /// Works on some more. The surface when it is done, or a sentence where it is smaller than a cell.
    pub fn advance(&mut self) -> Option<Result<Filled, Notice>> {
        match self.stage {
            Stage::Parts => {
                let (part, count) = self.mesh.parts();
                (self.part, self.areas) = (part, vec![0.0; count]);
                self.stage = Stage::Areas;
            }
            Stage::Areas => {
                let count = self.part.len();
                for t in slice(&mut self.at, count) {
                    self.areas[self.part[t] as usize] += self.mesh.area_of(t as u32);
                }
                if self.at == count {
                    (self.stage, self.at) = (Stage::Rings, 0);
                }
            }
            Stage::Rings => {
                self.rings = self.mesh.borders();
                self.stage = Stage::Fill;
            }
            Stage::Fill => {
                let mut corners = 0;
                while self.at < self.rings.len() && corners < CORNERS {
                    let ring = std::mem::take(&mut self.rings[self.at]);
                    corners += ring.len();
                    self.fill(&ring);
                    self.at += 1;
                }
                if self.at == self.rings.len() {
                    if self.filled == 0 {
                        return Some(self.finish());
                    }
                    self.begin_to_build();
                }
            }
            Stage::Build => {
                let mesh = self.building.as_mut()?.advance()?;
                // Without new edges where there is one already, it is a mesh as before.
                match mesh {
                    Ok(mesh) => self.mesh = mesh,
                    Err(_) => self.filled = 0,
                }
                return Some(self.finish());
            }
        }
        None
    }

    /// All of it at once.
    ///
    /// # Errors
    /// Where the whole surface is smaller than a cell.
    pub fn fill_all(mesh: TriMesh, size: f64) -> Result<Filled, Notice> {
        let mut filling = Self::new(mesh, size);
        loop {
            if let Some(done) = filling.advance() {
                return done;
            }
        }
    }

    fn fill(&mut self, ring: &[u32]) {
        // Seen from the hole, the border runs the other way.
        let ring: Vec<u32> = ring.iter().rev().copied().collect();
        let places = ring.iter().map(|&v| self.mesh.positions()[v as usize]);
        let places: Vec<DVec3> = places.collect();
        let next = |k: usize| (k + 1) % places.len();
        let lengths: Vec<f64> = (0..places.len())
            .map(|k| (places[next(k)] - places[k]).length())
            .collect();
        let length: f64 = lengths.iter().sum();
        let Some((beside, _)) = self.mesh.fan(ring[0]).next() else {
            return;
        };
        let area = 0.5 * polygon::across(&places).length();
        let number = self.part[beside as usize] as usize;
        let part = self.areas[number];
        if !(length < HOLE * self.size && part > PART * area) || ring.len() < 3 {
            return;
        }
        let may_join = |i: usize, j: usize| !are_joined(&self.mesh, ring[i], ring[j]);
        self.filled += 1;
        self.areas[number] += area;
        if let Some(cut) = polygon::cut(&places, may_join) {
            self.triangles
                .extend(cut.iter().map(|t| t.map(|k| ring[k])));
            return;
        }
        // Around the border's middle.
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
        self.building = Some(MeshBuilding::new(positions, triangles));
        self.stage = Stage::Build;
    }

    fn finish(&mut self) -> Result<Filled, Notice> {
        let cell = self.size * self.size;
        let is_bare = |part: &u32| self.areas[*part as usize] < cell;
        let small = self.areas.iter().filter(|&&area| area < cell).count();
        if small == self.areas.len() {
            return Err(Code::ModelTooSmall.into());
        }
        let told = [(Code::MendedHoles, self.filled), (Code::ModelBare, small)];
        let told = told.into_iter().filter(|(_, n)| *n > 0);
        Ok(Filled {
            bare: self.part[..self.mesh.triangles().len()]
                .iter()
                .map(is_bare)
                .collect(),
            mesh: std::mem::replace(&mut self.mesh, TriMesh::none()),
            notices: told
                .map(|(code, n)| Notice::new(code).with("n", n))
                .collect(),
        })
    }
}

/// Is there an edge between two vertices?
fn are_joined(mesh: &TriMesh, a: u32, b: u32) -> bool {
    mesh.fan(a)
        .any(|(t, _)| mesh.triangles()[t as usize].contains(&b))
}
