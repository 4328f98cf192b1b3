//! The search for patches of elements that are worth dividing anew: its state, and its steps, which grow a patch,
//! compute the gain of a new division, and replace the patch's elements.

use super::division::{Division, MOST, TRIANGLE};
use super::quads::{Faces, score};
use super::triangles::NONE;
use super::{Face, Nodes};

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
        let n = patch.corners.len();
        let last = *patch.members.last()?;
        if next == NONE {
            return None;
        }
        let face = self.faces.faces[next as usize];
        let corners = face.nodes();
        let m = corners.len();
        let at = (0..m).find(|&j| self.faces.adjacent[next as usize][j] == last)?;
        let (b, a) = (corners[at], corners[(at + 1) % m]);
        if (on.keep)([a.min(b), a.max(b)]) {
            return None;
        }
        let k = (0..n).find(|&k| patch.corners[k] == a && patch.corners[(k + 1) % n] == b)?;
        let mut grown = Patch {
            corners: Vec::with_capacity(n + 2),
            outside: Vec::with_capacity(n + 2),
            members: patch.members.clone(),
            cost: patch.cost + self.cost(on, &face),
        };
        grown.members.push(next);
        for s in 0..n {
            grown.corners.push(patch.corners[s]);
            if s != k {
                grown.outside.push(patch.outside[s]);
                continue;
            }
            for j in 1..m {
                let place = (at + j) % m;
                grown
                    .outside
                    .push(self.faces.adjacent[next as usize][place]);
                if j + 1 < m {
                    let node = corners[(place + 1) % m];
                    if patch.corners.contains(&node) {
                        return None;
                    }
                    grown.corners.push(node);
                }
            }
        }
        Some(grown)
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
        let n = patch.corners.len();
        for &f in &patch.members {
            for &node in self.faces.faces[f as usize].nodes() {
                self.valence[node as usize] -= 1;
            }
        }
        let mut slots = patch.members.iter();
        // Half-edges within the patch (from, to, element, position), to be matched with their twins.
        let mut sides: Vec<(u8, u8, u32, usize)> = Vec::new();
        for &f in patch.members.iter().chain(&patch.outside) {
            if f != NONE {
                self.fresh[f as usize] = true;
            }
        }
        let faces = &mut self.faces;
        let valence = &mut self.valence;
        self.division.pieces(n, |piece| {
            let Some(&slot) = slots.next() else { return };
            let node = |k: usize| patch.corners[piece[k] as usize];
            faces.faces[slot as usize] = match piece.len() {
                4 => Face::quad([node(0), node(1), node(2), node(3)]),
                _ => Face::triangle([node(0), node(1), node(2)]),
            };
            faces.adjacent[slot as usize] = [NONE; 4];
            for k in 0..piece.len() {
                valence[node(k) as usize] += 1;
                let (from, to) = (piece[k], piece[(k + 1) % piece.len()]);
                if usize::from(to) == (usize::from(from) + 1) % n {
                    let outer = patch.outside[usize::from(from)];
                    faces.adjacent[slot as usize][k] = outer;
                    if outer != NONE {
                        let [a, b] = [from, to].map(|k| patch.corners[usize::from(k)]);
                        faces.put_across(outer, [b, a], slot);
                    }
                    continue;
                }
                for &(f, t, other, place) in &sides {
                    if (f, t) == (to, from) {
                        faces.adjacent[slot as usize][k] = other;
                        faces.adjacent[other as usize][place] = slot;
                    }
                }
                sides.push((from, to, slot, k));
            }
        });
        for &slot in slots {
            self.faces.faces[slot as usize].sides = 0;
        }
    }
}
