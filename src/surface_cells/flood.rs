//! Assigns each vertex of the domain to a cell: a geodesic Voronoi diagram by flooding.
//!
//! Labels spread from the cells over the edges, the nearest first. A distance is measured from the cell to the vertex,
//! in the metric of the cell's size and stretch. So each cell's region is connected, and a vertex beyond a rim or a
//! thin sheet does not count as near.

use super::divided::Divided;
use crate::order;
use crate::surface_packing::SurfaceParticle;
use crate::trimesh::frame::{apart, log_in};
use crate::trimesh::{NONE, TangentFrame, TriMesh};
use glam::DVec3;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Vertices to visit in a slice.
const ASKED: usize = 10_000;

/// A cell with its metric.
struct FloodSource {
    frame: TangentFrame,
    at: DVec3,
    /// Weights of the squares along the frame's two axes: stretch over squared size.
    along: f64,
    across: f64,
    size: f64,
}

impl FloodSource {
    fn new(cell: &SurfaceParticle) -> Self {
        let frame = cell.centre.frame();
        let x = frame.out(cell.axis).normalize_or(frame.x);
        let (size, normal) = (cell.size, frame.normal);
        let y = normal.cross(x);
        Self {
            frame: TangentFrame { x, y, normal },
            at: cell.centre.at,
            along: 1.0 / (cell.aspect * size * size),
            across: cell.aspect / (size * size),
            size,
        }
    }

    /// The squared distance to a place in the cell's metric. Nothing if the place cannot be seen from the cell, see
    /// [`crate::trimesh::log`].
    fn far(&self, at: DVec3, normal: DVec3) -> Option<f64> {
        if self.along == self.across {
            return Some(apart(self.at, self.frame.normal, at, normal)? * self.along);
        }
        let to = log_in(&self.frame, self.at, at, normal)?;
        Some(to.x * to.x * self.along + to.y * to.y * self.across)
    }
}

/// Labels that are spreading.
pub(super) struct Flood {
    /// For each vertex the cell that it belongs to.
    pub label: Vec<u32>,
    sources: Vec<FloodSource>,
    /// Candidates, the nearest first: squared distance, cell and vertex.
    open: BinaryHeap<Reverse<(u64, u64)>>,
    /// For each vertex the last two cells that are candidates for it.
    askers: Vec<[u32; 2]>,
}

impl Flood {
    /// Starts at the vertices of the cells' centres in the divided domain.
    pub fn new(divided: &Divided, cells: &[SurfaceParticle]) -> Self {
        let count = divided.vertices + cells.len();
        let mut flood = Self {
            label: vec![NONE; count],
            sources: cells.iter().map(FloodSource::new).collect(),
            open: BinaryHeap::with_capacity(count),
            askers: vec![[NONE; 2]; count],
        };
        for cell in 0..cells.len() as u32 {
            let own = order::pair(cell, divided.vertices as u32 + cell);
            flood.open.push(Reverse((order::rank(0.0), own)));
        }
        flood
    }

    /// Does one more slice; true when done.
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

    /// Adds the neighbours of a vertex as candidates; returns how many neighbours it has.
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
            // The centre of another cell belongs to that cell.
            if v >= divided.vertices {
                continue;
            }
            self.askers[v] = [cell, self.askers[v][0]];
            let at = mesh.positions()[v];
            let far = source.far(at, mesh.normals()[v]).unwrap_or_else(|| {
                // The vertex is out of sight: take the distance of the last vertex plus the step from there.
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
