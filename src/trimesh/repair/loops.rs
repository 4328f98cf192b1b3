//! Cuts the borders of a surface into loops, in slices.

use super::super::borders::BorderWalk;
use super::super::sorting::Sorting;
use super::super::{NONE, TriMesh};
use super::slice;
use glam::DVec3;

/// Bits of the key by which corners at one place are found: three rounds of the sort.
const KEY_BITS: u32 = 33;

/// A piece of a border that ends where it began.
#[derive(Default)]
pub(super) struct Loop {
    pub corners: Vec<u32>,
    /// Pairs of vertices at one place, which are merged when the loop is filled.
    pub twins: Vec<[u32; 2]>,
}

/// Cuts all rings of the border at places that a ring passes twice: holes may touch each other or the outer border
/// there.
#[derive(Default)]
pub(super) struct LoopCutting {
    stage: LoopPhase,
    at: usize,
    walk: BorderWalk,
    /// The corners of all rings, each with a key of its place.
    keyed: Vec<(u64, u32)>,
    sorting: Option<Sorting>,
    /// For each corner, the first corner of the same ring at the same place.
    first: Vec<u32>,
    /// The number of the current ring.
    ring: usize,
    /// For each first corner at a place, the index in `open` of the corner there; [`NONE`] if none is open.
    depth: Vec<u32>,
    /// The corners of the current ring that are in no loop yet, each with the pairs of vertices that closed loops have
    /// left at its place.
    open: Vec<(u32, Vec<[u32; 2]>)>,
    made: Vec<Loop>,
}

#[derive(Clone, Copy, Default)]
enum LoopPhase {
    #[default]
    Walk,
    Keys,
    Sort,
    Places,
    Cut,
}

impl LoopCutting {
    /// Does one more slice; returns the loops when all of them are cut.
    pub fn advance(&mut self, mesh: &TriMesh) -> Option<Vec<Loop>> {
        let count = self.walk.corners.len();
        match self.stage {
            LoopPhase::Walk => {
                if self.walk.advance(mesh) {
                    self.stage = LoopPhase::Keys;
                }
            }
            LoopPhase::Keys => {
                for k in slice(&mut self.at, count) {
                    let key = key(place(mesh, self.walk.corners[k]));
                    self.keyed.push((key, k as u32));
                }
                if self.at == count {
                    self.at = 0;
                    self.sorting = Some(Sorting::new(std::mem::take(&mut self.keyed)));
                    self.stage = LoopPhase::Sort;
                }
            }
            LoopPhase::Sort => {
                self.keyed = self.sorting.as_mut()?.advance()?;
                self.sorting = None;
                self.first = (0..count as u32).collect();
                self.stage = LoopPhase::Places;
            }
            LoopPhase::Places => {
                self.find_places(mesh);
                if self.at == count {
                    self.at = 0;
                    self.keyed = Vec::new();
                    self.depth = vec![NONE; count];
                    self.stage = LoopPhase::Cut;
                }
            }
            LoopPhase::Cut => {
                for k in slice(&mut self.at, count) {
                    self.cut(k);
                }
                if self.at == count {
                    return Some(std::mem::take(&mut self.made));
                }
            }
        }
        None
    }

    /// Finds the first corners of the places in a slice of the sorted list. Corners with the same key are always in one
    /// slice.
    fn find_places(&mut self, mesh: &TriMesh) {
        let range = slice(&mut self.at, self.keyed.len());
        while self.at < self.keyed.len() && self.keyed[self.at].0 == self.keyed[self.at - 1].0 {
            self.at += 1;
        }
        let alike = self.keyed[range.start..self.at].chunk_by(|a, b| a.0 == b.0);
        for same in alike.filter(|same| same.len() > 1) {
            let all = same.iter().map(|&(_, k)| {
                let ring = self.walk.ends.partition_point(|&end| end <= k as usize);
                (place(mesh, self.walk.corners[k as usize]), ring, k)
            });
            // Different places may have the same key.
            let mut all: Vec<_> = all.collect();
            all.sort_unstable();
            for same in all.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
                for &(_, _, k) in same {
                    self.first[k as usize] = same[0].2;
                }
            }
        }
    }

    /// Goes on to the next corner of a ring, which may close a loop.
    fn cut(&mut self, k: usize) {
        let corners = &self.walk.corners;
        let place = self.first[k] as usize;
        let mut twins = Vec::new();
        if self.depth[place] != NONE {
            let closed = self.open.split_off(self.depth[place] as usize);
            let pair = [corners[closed[0].0 as usize], corners[k]];
            let inner = closed[1..].iter().flat_map(|(_, twins)| twins);
            self.made.push(Loop {
                corners: closed.iter().map(|&(k, _)| corners[k as usize]).collect(),
                twins: inner.copied().chain([pair]).collect(),
            });
            for &(k, _) in &closed {
                self.depth[self.first[k as usize] as usize] = NONE;
            }
            twins.extend(closed[0].1.iter().copied().chain([pair]));
        }
        self.depth[place] = self.open.len() as u32;
        self.open.push((k as u32, twins));
        if k + 1 == self.walk.ends[self.ring] {
            let open = std::mem::take(&mut self.open);
            self.made.push(Loop {
                corners: open.iter().map(|&(k, _)| corners[k as usize]).collect(),
                twins: open.iter().flat_map(|(_, twins)| twins).copied().collect(),
            });
            self.ring += 1;
        }
    }
}

/// The bits of a vertex' coordinates.
fn place(mesh: &TriMesh, v: u32) -> [u64; 3] {
    // Adding 0 turns -0 into 0.
    let at = mesh.positions()[v as usize] + DVec3::ZERO;
    at.to_array().map(f64::to_bits)
}

/// A key of a place. Different places rarely have the same key.
fn key(place: [u64; 3]) -> u64 {
    let mixed = place.into_iter().fold(0, |mixed: u64, bits| {
        let mixed = (mixed ^ bits).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        mixed ^ mixed >> 32
    });
    mixed.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> (u64::BITS - KEY_BITS)
}
