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
    loops: Vec<Loop>,
    /// Vertices that become one.
    welds: Vec<[u32; 2]>,
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
            loops: Vec::new(),
            welds: Vec::new(),
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
                let rings = self.mesh.borders();
                self.loops = rings.iter().flat_map(|r| loops(&self.mesh, r)).collect();
                self.stage = Stage::Fill;
            }
            Stage::Fill => {
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
        let Some((beside, _)) = self.mesh.fan(ring[0]).next() else {
            return;
        };
        let area = 0.5 * polygon::across(&places).length();
        let number = self.part[beside as usize] as usize;
        let part = self.areas[number];
        if !(length < HOLE * self.size && part > PART * area) || ring.len() < 3 {
            return;
        }
        let may_join = |i: usize, j: usize| !hole.are_joined(&self.mesh, ring[i], ring[j]);
        self.filled += 1;
        self.welds.extend(&hole.twins);
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
        if !self.welds.is_empty() {
            let into = welded(positions.len(), &self.welds);
            for t in &mut triangles {
                *t = t.map(|v| into[v as usize]);
            }
        }
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

/// A piece of a border that comes back to where it began.
#[derive(Default)]
struct Loop {
    corners: Vec<u32>,
    /// Vertices at one place, which are one once it is filled.
    twins: Vec<[u32; 2]>,
}

impl Loop {
    /// Is there an edge between two of its corners, or between twins of these?
    fn are_joined(&self, mesh: &TriMesh, a: u32, b: u32) -> bool {
        let all = |v: u32| {
            let twins = self.twins.iter().filter(move |t| t.contains(&v));
            twins.flatten().copied().chain([v])
        };
        all(a).any(|a| all(b).any(|b| are_joined(mesh, a, b)))
    }
}

/// Cuts a ring of the border where it is at one place twice: holes that touch there, each other or the outer border.
fn loops(mesh: &TriMesh, ring: &[u32]) -> Vec<Loop> {
    // Without the sign of 0.
    let place = |k: &usize| {
        let at = mesh.positions()[ring[*k] as usize] + DVec3::ZERO;
        at.to_array().map(f64::to_bits)
    };
    let mut order: Vec<usize> = (0..ring.len()).collect();
    order.sort_unstable_by_key(|k| (place(k), *k));
    // Of each corner the first one at its place, and where that is among the open ones.
    let mut first = vec![0; ring.len()];
    for same in order.chunk_by(|a, b| place(a) == place(b)) {
        same.iter().for_each(|&k| first[k] = same[0]);
    }
    let mut depth = vec![None; ring.len()];
    let mut open: Vec<(usize, Vec<[u32; 2]>)> = Vec::new();
    let mut made = Vec::new();
    for k in 0..ring.len() {
        let mut twins = Vec::new();
        if let Some(from) = depth[first[k]] {
            let closed = open.split_off(from);
            let pair = [ring[closed[0].0], ring[k]];
            let inner = closed[1..].iter().flat_map(|(_, twins)| twins);
            made.push(Loop {
                corners: closed.iter().map(|&(k, _)| ring[k]).collect(),
                twins: inner.copied().chain([pair]).collect(),
            });
            closed.iter().for_each(|&(k, _)| depth[first[k]] = None);
            twins.extend(closed[0].1.iter().copied().chain([pair]));
        }
        depth[first[k]] = Some(open.len());
        open.push((k, twins));
    }
    made.push(Loop {
        corners: open.iter().map(|&(k, _)| ring[k]).collect(),
        twins: open.iter().flat_map(|(_, twins)| twins).copied().collect(),
    });
    made
}

/// Of each of so many vertices the one that it becomes: the least of those that are one.
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
    (0..count as u32).map(|v| root(&into, v)).collect()
}

/// Is there an edge between two vertices?
fn are_joined(mesh: &TriMesh, a: u32, b: u32) -> bool {
    mesh.fan(a)
        .any(|(t, _)| mesh.triangles()[t as usize].contains(&b))
}

#[cfg(test)]
mod tests {
    use super::super::Mending;
    use super::*;
    use crate::trimesh::{Soup, testing};

    #[test]
    fn holes_that_touch_are_closed_each_by_itself() {
        let (positions, triangles) = testing::flat(7);
        let mesh = testing::mesh((positions.clone(), triangles.clone()));
        let fan = |v: u32| mesh.fan(v).map(|(t, _)| t).collect::<Vec<_>>();
        let mut tried = [0; 2];
        for middle in 0..positions.len() as u32 {
            // Two triangles at a vertex that do not lie beside each other; at the border one that has none of it.
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
            let mended = Mending::mend(soup).expect("a surface").mesh;
            let filled = Filling::fill_all(mended, 0.2).expect("a surface").mesh;
            assert_eq!((filled.euler(), filled.borders().len()), (1, 1));
            assert!((filled.area() - 1.0).abs() < 1e-12);
            for t in 0..filled.triangles().len() as u32 {
                assert!(filled.face_normal(t).y > 0.99);
            }
        }
        assert!(tried[0] > 9 && tried[1] > 3, "{tried:?}");
    }
}
