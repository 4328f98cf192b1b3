//! Merges vertices that are at one place.
//!
//! A grid of cubes whose diagonal counts as zero: all vertices in one cube are at one place, and so are close
//! vertices in neighbouring cubes. Cubes are sorted by row, so one pass over each of the neighbouring rows is enough.

use super::super::sorting::Sorting;
use super::{MeshInRepair, NONE, RepairStep, slice};
use crate::notice::{Code, Notice};
use crate::order::rank;
use glam::DVec3;

/// Bits of a cube's coordinate along an axis.
const BITS: u32 = 21;
/// Vertices that are close lie at most this many cubes apart along an axis.
const REACH: i64 = 2;
/// The rows of neighbouring cubes and a cube's own row, as offsets along z and y.
const ROWS: [[i64; 2]; 13] = [
    [0, 0],
    [0, 1],
    [0, 2],
    [1, -2],
    [1, -1],
    [1, 0],
    [1, 1],
    [1, 2],
    [2, -2],
    [2, -1],
    [2, 0],
    [2, 1],
    [2, 2],
];

#[derive(Default)]
pub(super) struct Welding {
    stage: WeldingPhase,
    at: usize,
    keys: Vec<(u64, u32)>,
    sorting: Option<Sorting>,
    /// Occupied cubes, sorted, each with its first vertex (the least along x, y, z).
    cubes: Vec<(u64, u32)>,
    /// For each vertex its cube.
    cube_of: Vec<u32>,
    /// For each cube, a cube at the same place with a lesser number, or itself if it is the root of such a chain.
    joined: Vec<u32>,
    /// How far the pass has come in each of the rows.
    rows: [usize; ROWS.len()],
    /// For the root of each chain, the number of the vertex that is kept.
    number: Vec<u32>,
    kept: Vec<DVec3>,
    /// How many triangles are kept.
    triangles: usize,
}

#[derive(Clone, Copy, Default)]
enum WeldingPhase {
    #[default]
    Keys,
    Sort,
    Cubes,
    Join,
    Choose,
    Number,
    Rename,
}

impl RepairStep for Welding {
    fn advance(&mut self, work: &mut MeshInRepair) -> Result<bool, Notice> {
        let vertices = work.positions.len();
        let count = match self.stage {
            WeldingPhase::Keys | WeldingPhase::Cubes | WeldingPhase::Number => vertices,
            WeldingPhase::Join | WeldingPhase::Choose => self.cubes.len(),
            WeldingPhase::Sort => 0,
            WeldingPhase::Rename => work.triangles.len(),
        };
        let range = slice(&mut self.at, count);
        match self.stage {
            WeldingPhase::Keys => self.keys.extend(range.map(|v| (key(work, v), v as u32))),
            WeldingPhase::Sort => {
                let sorting = self.sorting.as_mut().map(Sorting::advance);
                match sorting {
                    Some(None) => return Ok(false),
                    sorted => self.keys = sorted.flatten().unwrap_or_default(),
                }
            }
            WeldingPhase::Cubes => range.for_each(|k| self.cube(work, k)),
            WeldingPhase::Join => range.for_each(|cube| self.join(work, cube)),
            WeldingPhase::Choose => range.for_each(|cube| self.choose(work, cube)),
            WeldingPhase::Number => range.for_each(|v| self.count(work, v)),
            WeldingPhase::Rename => range.for_each(|t| self.rename(work, t)),
        }
        if self.at < count {
            return Ok(false);
        }
        self.at = 0;
        let Some(next) = self.next_phase(vertices) else {
            self.finish(work);
            return Ok(true);
        };
        self.stage = next;
        Ok(false)
    }
}

impl Welding {
    /// The phase after the present one, which is over; `None` after the last one.
    fn next_phase(&mut self, vertices: usize) -> Option<WeldingPhase> {
        Some(match self.stage {
            WeldingPhase::Keys => {
                self.sorting = Some(Sorting::new(std::mem::take(&mut self.keys)));
                WeldingPhase::Sort
            }
            WeldingPhase::Sort => {
                self.sorting = None;
                self.cube_of = vec![0; vertices];
                WeldingPhase::Cubes
            }
            WeldingPhase::Cubes => {
                self.keys = Vec::new();
                self.joined = (0..self.cubes.len() as u32).collect();
                WeldingPhase::Join
            }
            WeldingPhase::Join => WeldingPhase::Choose,
            WeldingPhase::Choose => {
                self.number = vec![NONE; self.cubes.len()];
                WeldingPhase::Number
            }
            WeldingPhase::Number => WeldingPhase::Rename,
            WeldingPhase::Rename => return None,
        })
    }
}

/// The key of the cube that a vertex is in; cubes of a row along x have consecutive keys.
fn key(work: &MeshInRepair, v: usize) -> u64 {
    let side = work.near() / 3f64.sqrt();
    let [x, y, z] = ((work.positions[v] - work.low) / side)
        .to_array()
        .map(|c| c as u64);
    z << (2 * BITS) | y << BITS | x
}

impl Welding {
    fn cube(&mut self, work: &MeshInRepair, k: usize) {
        let (key, v) = self.keys[k];
        let place = |v: u32| work.positions[v as usize].to_array().map(rank);
        match self.cubes.last_mut() {
            Some((last, first)) if *last == key => {
                if place(v) < place(*first) {
                    *first = v;
                }
            }
            _ => self.cubes.push((key, v)),
        }
        self.cube_of[v as usize] = self.cubes.len() as u32 - 1;
    }

    fn root(&mut self, mut cube: u32) -> u32 {
        while self.joined[cube as usize] != cube {
            let next = self.joined[cube as usize];
            self.joined[cube as usize] = self.joined[next as usize];
            cube = self.joined[cube as usize];
        }
        cube
    }

    fn join(&mut self, work: &MeshInRepair, cube: usize) {
        let (key, first) = self.cubes[cube];
        let (p, near) = (work.positions[first as usize], work.near());
        for (row, [z, y]) in ROWS.into_iter().enumerate() {
            let middle = key as i64 + (z << (2 * BITS)) + (y << BITS);
            let from = if row == 0 { middle + 1 } else { middle - REACH };
            let pointer = &mut self.rows[row];
            while self
                .cubes
                .get(*pointer)
                .is_some_and(|c| (c.0 as i64) < from)
            {
                *pointer += 1;
            }
            let mut other = *pointer;
            while let Some(&(key, v)) = self.cubes.get(other)
                && key as i64 <= middle + REACH
            {
                if (work.positions[v as usize] - p).length_squared() <= near * near {
                    let [a, b] = [cube, other].map(|c| self.root(c as u32));
                    self.joined[a.max(b) as usize] = a.min(b);
                }
                other += 1;
            }
        }
    }

    /// Keeps the least vertex of all cubes at a place.
    fn choose(&mut self, work: &MeshInRepair, cube: usize) {
        let root = self.root(cube as u32) as usize;
        let place = |v: u32| work.positions[v as usize].to_array().map(rank);
        let (own, kept) = (self.cubes[cube].1, self.cubes[root].1);
        if place(own) < place(kept) {
            self.cubes[root].1 = own;
        }
    }

    /// Numbers the places in the order of the vertices.
    fn count(&mut self, work: &MeshInRepair, v: usize) {
        let root = self.root(self.cube_of[v]) as usize;
        if self.number[root] == NONE {
            self.number[root] = self.kept.len() as u32;
            self.kept.push(work.positions[self.cubes[root].1 as usize]);
        }
        self.cube_of[v] = self.number[root];
    }

    /// Renumbers the corners of a triangle; the triangle is kept if they differ.
    fn rename(&mut self, work: &mut MeshInRepair, t: usize) {
        let [a, b, c] = work.triangles[t].map(|v| self.cube_of[v as usize]);
        if a != b && b != c && c != a {
            work.triangles[self.triangles] = [a, b, c];
            self.triangles += 1;
        }
    }

    fn finish(&mut self, work: &mut MeshInRepair) {
        let (vertices, triangles) = (work.positions.len(), work.triangles.len());
        work.positions = std::mem::take(&mut self.kept);
        work.triangles.truncate(self.triangles);
        work.tell(Code::MendedWelded, vertices - work.positions.len());
        work.tell(Code::MendedThin, triangles - self.triangles);
    }
}
