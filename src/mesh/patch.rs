//! The search for patches of elements that are worth dividing anew: its state, and its steps, which grow a patch,
//! compute the gain of a new division, and replace the patch's elements.

use super::division::{Division, MOST, TRIANGLE};
use super::quads::{Faces, score};
use super::triangles::NONE;
use super::{Face, Nodes};
use std::ops::Range;

/// Cost of an inner node for each side more or less than four.
const IRREGULAR: f64 = 0.12;
/// A division that costs this much more than the patch is dropped: regular nodes cannot make up for more.
const SLACK: f64 = 0.5;

/// A patch: a polygon of adjacent elements.
#[derive(Clone)]
pub(super) struct Patch {
    pub corners: Vec<u32>,
    /// The element across each side, from each corner to the next.
    pub outside: Vec<u32>,
    /// The elements of the patch.
    pub members: Vec<u32>,
    /// The cost of its elements.
    pub cost: f64,
}

/// Context of the search: the nodes and the sides to keep.
pub(crate) struct SearchInputs<'a, N: ?Sized, K> {
    pub nodes: &'a N,
    /// Predicate of sides that must not be dissolved.
    pub keep: K,
}

/// The goal of the search.
#[derive(Clone, Copy)]
pub(crate) struct Goal {
    /// Least score of quadrilaterals.
    pub worst: f64,
    /// The search ends with at most this many triangles.
    pub few: usize,
    /// Fewest sides at each inner node.
    pub least: i32,
}

impl Goal {
    pub fn new(worst: f64, few: usize) -> Self {
        Self {
            worst,
            few,
            least: 0,
        }
    }
}

/// The search for patches whose cost falls if they are divided anew.
pub(crate) struct PatchSearch {
    pub(super) faces: Faces,
    pub(super) goal: Goal,
    /// The number of lone triangles.
    pub(super) triangles: usize,
    /// The number of sides at each node.
    pub(super) valence: Vec<i32>,
    /// Whether each node is on the border of the mesh.
    pub(super) border: Vec<bool>,
    /// Elements whose surroundings have changed since they were tried.
    pub(super) fresh: Vec<bool>,
    /// For the elements in `reached`, the number of steps from the first of them, from element to element.
    pub(super) depth: Vec<u8>,
    pub(super) reached: Vec<u32>,
    pub(super) division: Box<Division>,
    /// Work done so far: the sum of the squared numbers of corners of the patches tried.
    pub(super) work: usize,
    /// The current round; `next` is the next element to try in it, `again` whether a patch has gained in it.
    pub(super) round: usize,
    pub(super) next: usize,
    pub(super) again: bool,
}

impl PatchSearch {
    pub(super) fn cost<N: Nodes + ?Sized, K>(&self, on: &SearchInputs<N, K>, face: &Face) -> f64 {
        match *face.nodes() {
            [a, b, c, d] => 1.0 - score(on.nodes, [a, b, c, d]),
            _ => TRIANGLE,
        }
    }

    /// The patch extended by an element adjacent to its last member; `None` if a node would lie inside, or
    /// the side between them must be kept.
    pub(super) fn grow<N: Nodes + ?Sized, K: Fn([u32; 2]) -> bool>(
        &self,
        on: &SearchInputs<N, K>,
        patch: &Patch,
        next: u32,
    ) -> Option<Patch> {
        let [at, k] = self.joint(patch, next)?;
        let face = self.faces.faces[next as usize];
        let (corners, adjacent) = (face.nodes(), self.faces.adjacent[next as usize]);
        let m = corners.len();
        let (b, a) = (corners[at], corners[(at + 1) % m]);
        if (on.keep)([a.min(b), a.max(b)]) {
            return None;
        }
        let nodes = (2..m).map(|j| corners[(at + j) % m]);
        if nodes.clone().any(|node| patch.corners.contains(&node)) {
            return None;
        }
        let beyond = (1..m).map(|j| adjacent[(at + j) % m]);
        let mut members = patch.members.clone();
        members.push(next);
        Some(Patch {
            corners: spliced(&patch.corners, k + 1..k + 1, nodes),
            outside: spliced(&patch.outside, k..k + 1, beyond),
            members,
            cost: patch.cost + self.cost(on, &face),
        })
    }

    /// The side that an element shares with the last member of a patch: its positions in the element and in the patch.
    fn joint(&self, patch: &Patch, next: u32) -> Option<[usize; 2]> {
        let last = *patch.members.last()?;
        if next == NONE {
            return None;
        }
        let corners = self.faces.faces[next as usize].nodes();
        let (n, m) = (patch.corners.len(), corners.len());
        let at = (0..m).find(|&j| self.faces.adjacent[next as usize][j] == last)?;
        // The side runs the other way round in the patch.
        let side = [corners[(at + 1) % m], corners[at]];
        let k = (0..n).find(|&k| [patch.corners[k], patch.corners[(k + 1) % n]] == side)?;
        Some([at, k])
    }

    /// The cost saved by dividing a patch anew, irregular nodes included; 0 if the division leaves too few sides at a
    /// node or costs far too much.
    pub(super) fn gain<N: Nodes + ?Sized, K>(
        &mut self,
        on: &SearchInputs<N, K>,
        patch: &Patch,
    ) -> f64 {
        let n = patch.corners.len();
        self.work += n * n;
        let cost = self.division.of(on.nodes, &patch.corners, self.goal.worst);
        if cost >= patch.cost + SLACK {
            return 0.0;
        }
        // The sides within the patch at each corner, before and after.
        let mut change = [0; MOST];
        let before = |node: u32| {
            let uses = patch
                .members
                .iter()
                .filter(|&&f| self.faces.faces[f as usize].nodes().contains(&node));
            uses.count() as i32
        };
        for (k, &node) in patch.corners.iter().enumerate() {
            change[k] = 1 - before(node);
        }
        self.division.pieces(n, |piece| {
            for &k in piece {
                change[k as usize] += 1;
            }
        });
        let mut regular = 0;
        for (k, &node) in patch.corners.iter().enumerate() {
            let now = self.valence[node as usize];
            // `change` is 1 too many: a corner in one element has no side within the patch.
            let then = now + change[k] - 1;
            if !self.border[node as usize] {
                if then < self.goal.least {
                    return 0.0;
                }
                regular += (now - 4).abs() - (then - 4).abs();
            }
        }
        patch.cost - cost + IRREGULAR * f64::from(regular)
    }

    /// Replaces the patch's elements with the division found last.
    pub(super) fn apply(&mut self, patch: &Patch) {
        self.take_out(patch);
        let (faces, valence) = (&mut self.faces, &mut self.valence);
        let mut slots = patch.members.iter();
        let mut inner = Vec::new();
        self.division.pieces(patch.corners.len(), |piece| {
            let Some(&slot) = slots.next() else { return };
            let face = patch.face(piece);
            for &node in face.nodes() {
                valence[node as usize] += 1;
            }
            faces.faces[slot as usize] = face;
            faces.link(patch, piece, slot, &mut inner);
        });
        for &slot in slots {
            self.faces.faces[slot as usize].sides = 0;
        }
    }

    /// Takes the sides of a patch's elements out of the counts; these elements and those around them are tried again.
    fn take_out(&mut self, patch: &Patch) {
        for &f in &patch.members {
            for &node in self.faces.faces[f as usize].nodes() {
                self.valence[node as usize] -= 1;
            }
        }
        for &f in patch.members.iter().chain(&patch.outside) {
            if f != NONE {
                self.fresh[f as usize] = true;
            }
        }
    }
}

impl Patch {
    /// The element with these corners of the patch.
    fn face(&self, piece: &[u8]) -> Face {
        let node = |k: usize| self.corners[piece[k] as usize];
        match piece.len() {
            4 => Face::quad([node(0), node(1), node(2), node(3)]),
            _ => Face::triangle([node(0), node(1), node(2)]),
        }
    }
}

/// A side of a new element: from a corner of the patch to another, the element, and the position in it.
struct PieceSide {
    corners: [u8; 2],
    slot: u32,
    place: usize,
}

impl Faces {
    /// Links a new element of a patch with the elements around the patch, and with those linked before.
    fn link(&mut self, patch: &Patch, piece: &[u8], slot: u32, inner: &mut Vec<PieceSide>) {
        self.adjacent[slot as usize] = [NONE; 4];
        for place in 0..piece.len() {
            let corners = [piece[place], piece[(place + 1) % piece.len()]];
            let [from, to] = corners.map(usize::from);
            let side = PieceSide {
                corners,
                slot,
                place,
            };
            if to == (from + 1) % patch.corners.len() {
                self.link_outside(patch, &side);
            } else {
                self.link_inside(side, inner);
            }
        }
    }

    fn link_outside(&mut self, patch: &Patch, side: &PieceSide) {
        let [from, to] = side.corners.map(usize::from);
        let outer = patch.outside[from];
        self.adjacent[side.slot as usize][side.place] = outer;
        if outer != NONE {
            self.put_across(outer, [patch.corners[to], patch.corners[from]], side.slot);
        }
    }

    /// Links a side within the patch with its twin, if that is among those before.
    fn link_inside(&mut self, side: PieceSide, inner: &mut Vec<PieceSide>) {
        let [from, to] = side.corners;
        for twin in inner.iter().filter(|other| other.corners == [to, from]) {
            self.adjacent[side.slot as usize][side.place] = twin.slot;
            self.adjacent[twin.slot as usize][twin.place] = side.slot;
        }
        inner.push(side);
    }
}

/// The list with other items in the place of a range.
fn spliced(list: &[u32], range: Range<usize>, items: impl Iterator<Item = u32>) -> Vec<u32> {
    let mut all = Vec::with_capacity(list.len() + 2);
    all.extend(&list[..range.start]);
    all.extend(items);
    all.extend(&list[range.end..]);
    all
}
