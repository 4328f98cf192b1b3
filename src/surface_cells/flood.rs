//! Which cell each vertex of the domain belongs to.
//!
//! Labels spread from the cells over the edges, the nearest first, by the distance that a cell itself sees a vertex at,
//! in its own size and stretch: so each cell's region hangs together, and what one meets beyond a rim or through a
//! thin sheet is not taken for near.

use super::divided::Divided;
use crate::order;
use crate::surface_packing::SurfaceParticle;
use crate::trimesh::frame::{apart, way_in};
use crate::trimesh::{Frame, NONE, TriMesh};
use glam::DVec3;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Vertices that are asked for in one slice of the work.
const ASKED: usize = 10_000;

/// A cell as it measures distances.
struct Source {
    frame: Frame,
    at: DVec3,
    /// Of the frame's two axes, over the squared size.
    along: f64,
    across: f64,
    size: f64,
}

impl Source {
    fn new(cell: &SurfaceParticle) -> Self {
        let frame = cell.centre.frame();
        let x = frame.out(cell.axis).normalize_or(frame.x);
        let (size, normal) = (cell.size, frame.normal);
        let y = normal.cross(x);
        Self {
            frame: Frame { x, y, normal },
            at: cell.centre.at,
            along: 1.0 / (cell.aspect * size * size),
            across: cell.aspect / (size * size),
            size,
        }
    }

    /// The squared distance to a place, in its sizes.
    fn far(&self, at: DVec3, normal: DVec3) -> Option<f64> {
        if self.along == self.across {
            return Some(apart(self.at, self.frame.normal, at, normal)? * self.along);
        }
        let to = way_in(&self.frame, self.at, at, normal)?;
        Some(to.x * to.x * self.along + to.y * to.y * self.across)
    }
}

/// Labels that spread.
pub(super) struct Flood {
    /// Of each vertex the cell that it belongs to.
    pub label: Vec<u32>,
    sources: Vec<Source>,
    /// Squared distance, cell and vertex of what is asked for.
    open: BinaryHeap<Reverse<(u64, u64)>>,
    /// The cells that have asked for a vertex last.
    askers: Vec<[u32; 2]>,
}

impl Flood {
    /// From these cells; in the divided domain each has the vertex that it stands on.
    pub fn new(divided: &Divided, cells: &[SurfaceParticle]) -> Self {
        let count = divided.vertices + cells.len();
        let mut flood = Self {
            label: vec![NONE; count],
            sources: cells.iter().map(Source::new).collect(),
            open: BinaryHeap::with_capacity(count),
            askers: vec![[NONE; 2]; count],
        };
        for cell in 0..cells.len() as u32 {
            let own = order::pair(cell, divided.vertices as u32 + cell);
            flood.open.push(Reverse((order::rank(0.0), own)));
        }
        flood
    }

    /// One slice of the work; true with the last one.
    pub fn advance(&mut self, mesh: &TriMesh, divided: &Divided) -> bool {
        let mut left = ASKED;
        while left > 0 {
            let Some(Reverse((rank, what))) = self.open.pop() else {
                return true;
            };
            let (cell, vertex) = ((what >> 32) as u32, what as u32);
            if self.label[vertex as usize] != NONE {
                continue;
            }
            self.label[vertex as usize] = cell;
            left = left.saturating_sub(self.ask(mesh, divided, (cell, vertex), rank));
        }
        false
    }

    /// Asks for the neighbours of a vertex; how many those are.
    fn ask(
        &mut self,
        mesh: &TriMesh,
        divided: &Divided,
        (cell, vertex): (u32, u32),
        rank: u64,
    ) -> usize {
        let source = &self.sources[cell as usize];
        let near = divided.near(vertex);
        for &next in near {
            let v = next as usize;
            if self.label[v] != NONE || self.askers[v].contains(&cell) {
                continue;
            }
            // Another cell's centre is its own.
            if v >= divided.vertices {
                continue;
            }
            self.askers[v] = [cell, self.askers[v][0]];
            let at = mesh.positions()[v];
            let far = source.far(at, mesh.normals()[v]).unwrap_or_else(|| {
                // Beyond its sight: on from the one before.
                let from = match (vertex as usize).checked_sub(divided.vertices) {
                    Some(own) => self.sources[own].at,
                    None => mesh.positions()[vertex as usize],
                };
                let before = f64::from_bits(rank & !(1 << 63)).sqrt();
                let far = before + at.distance(from) / source.size;
                far * far
            });
            let asked = (order::rank(far), order::pair(cell, next));
            self.open.push(Reverse(asked));
        }
        near.len()
    }
}
