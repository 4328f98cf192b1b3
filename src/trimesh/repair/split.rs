//! Gives each connected fan of corners a vertex of its own.

use super::{MeshInRepair, NONE, RepairStep, slice};
use crate::notice::{Code, Notice};
use glam::DVec3;

/// Visits all vertices. A vertex is split if one walk round it does not reach all of its corners.
pub(super) struct Splitter {
    at: usize,
    /// Marks corners that have been visited.
    seen: Vec<[bool; 3]>,
    /// Marks vertices that have a fan already.
    taken: Vec<bool>,
    /// For each new vertex, the old one that it was split from.
    pub origin: Vec<u32>,
}

impl Splitter {
    pub fn new(vertices: usize, triangles: usize) -> Self {
        Self {
            at: 0,
            seen: vec![[false; 3]; triangles],
            taken: vec![false; vertices],
            origin: Vec::new(),
        }
    }

    /// Does one more slice, given the neighbour over each edge (`3 * triangle + edge`); true when it is done.
    pub fn advance(
        &mut self,
        positions: &mut Vec<DVec3>,
        triangles: &mut [[u32; 3]],
        across: &[[u32; 3]],
    ) -> bool {
        for t in slice(&mut self.at, triangles.len()) {
            for k in 0..3 {
                if !self.seen[t][k] {
                    self.go_round(positions, triangles, across, (t, k));
                }
            }
        }
        self.at == triangles.len()
    }

    fn go_round(
        &mut self,
        positions: &mut Vec<DVec3>,
        triangles: &mut [[u32; 3]],
        across: &[[u32; 3]],
        first: (usize, usize),
    ) {
        let old = triangles[first.0][first.1];
        let vertex = if self.taken[old as usize] {
            positions.push(positions[old as usize]);
            self.origin.push(old);
            positions.len() as u32 - 1
        } else {
            self.taken[old as usize] = true;
            old
        };
        // Go counter-clockwise; where that ends at a border, go the other way from the first corner.
        for step in [2, 0] {
            let (mut t, mut corner) = first;
            loop {
                self.seen[t][corner] = true;
                triangles[t][corner] = vertex;
                let edge = across[t][(corner + step) % 3];
                if edge == NONE {
                    break;
                }
                let on = if step == 2 { 0 } else { 1 };
                (t, corner) = (edge as usize / 3, (edge as usize + on) % 3);
                if self.seen[t][corner] {
                    break;
                }
            }
        }
    }
}

#[derive(Default)]
pub(super) struct Splitting {
    splitter: Option<Splitter>,
}

impl RepairStep for Splitting {
    fn advance(&mut self, work: &mut MeshInRepair) -> Result<bool, Notice> {
        let (vertices, triangles) = (work.positions.len(), work.triangles.len());
        let splitter = self
            .splitter
            .get_or_insert_with(|| Splitter::new(vertices, triangles));
        if !splitter.advance(&mut work.positions, &mut work.triangles, &work.across) {
            return Ok(false);
        }
        let count = splitter.origin.len();
        work.tell(Code::MendedVertices, count);
        Ok(true)
    }
}
