//! Makes the corners of the parent mesh: the edges around each, in order.

use super::ids::{CornerId, EdgeId, FaceId};
use super::making_parent::Chains;
use super::parent::EdgeEnd;
use super::sides::{Side, SideTable, key};
use std::collections::BTreeMap;

/// The edges and faces at a corner, counter-clockwise seen from outside.
#[derive(Clone, Debug, Default)]
pub(super) struct CornerFan {
    pub vertex: u32,
    pub edges: Vec<EdgeEnd>,
    /// The face counter-clockwise of each edge; `None` after the last edge at a border.
    pub faces: Vec<Option<FaceId>>,
    /// The number of fans of faces: more than one if the corner is pinched.
    pub fans: usize,
}

/// The edges and faces at each corner.
pub(super) fn around(sides: &SideTable, chains: &Chains) -> Vec<CornerFan> {
    let all = &sides.sides;
    let mut around = vec![CornerFan::default(); chains.corners];
    let mut leaving: Vec<Vec<usize>> = vec![Vec::new(); chains.corners];
    for (k, side) in all.iter().enumerate() {
        if let Some(corner) = chains.corner[side.from as usize] {
            leaving[corner.index()].push(k);
            around[corner.index()].vertex = side.from;
        }
    }
    for (corner, mut open) in leaving.into_iter().enumerate() {
        // A fan at a border starts with the side that has no face to its right.
        open.sort_by_key(|&k| (all[k].twin.is_some(), k));
        let mut used = Vec::new();
        for first in open {
            if !used.contains(&first) {
                fan(all, chains, first, &mut around[corner], &mut used);
            }
        }
    }
    around
}

/// Adds the edges and faces of a fan, from its first side on.
fn fan(sides: &[Side], chains: &Chains, first: usize, to: &mut CornerFan, used: &mut Vec<usize>) {
    to.fans += 1;
    let mut k = first;
    loop {
        used.push(k);
        to.edges.push(end(chains, k, true));
        to.faces.push(Some(sides[k].face));
        let arriving = sides[k].previous;
        match sides[arriving].twin {
            Some(next) if next == first => return,
            Some(next) => k = next,
            None => {
                to.edges.push(end(chains, arriving, false));
                to.faces.push(None);
                return;
            }
        }
    }
}

/// The end of the edge that a side belongs to: the one towards the side's start if `at_start`, else
/// towards its end.
fn end(chains: &Chains, side: usize, at_start: bool) -> EdgeEnd {
    let (edge, forward) = chains.of_side[side];
    EdgeEnd {
        edge,
        end: usize::from(forward != at_start),
    }
}

/// Finds edges and corners by numbers of the draft's vertices.
pub(super) struct Names<'a> {
    sides: &'a SideTable,
    chains: &'a Chains,
    between: BTreeMap<(u32, u32), EdgeId>,
}

impl<'a> Names<'a> {
    pub fn new(sides: &'a SideTable, chains: &'a Chains) -> Self {
        let each = sides.sides.iter().zip(&chains.of_side);
        let between = each.map(|(side, of)| (key(side.from, side.to), of.0));
        Self {
            sides,
            chains,
            between: between.collect(),
        }
    }

    /// The edge that the side between two vertices is part of.
    pub fn edge(&self, vertices: [u32; 2]) -> Option<EdgeId> {
        let [a, b] = vertices.map(|v| self.sides.welded.get(v as usize).copied());
        self.between.get(&key(a?, b?)).copied()
    }

    /// The corner at a vertex.
    pub fn corner(&self, vertex: u32) -> Option<CornerId> {
        let welded = *self.sides.welded.get(vertex as usize)?;
        self.chains.corner[welded as usize]
    }
}
