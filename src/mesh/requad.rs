//! Local re-quadrangulation: patches of a few neighbouring elements are divided anew.
//!
//! Pairs taken in the order of their scores leave lone triangles that have no partner, where another
//! choice nearby would have had one. Two lone triangles and the quadrilaterals on a path between them
//! make a polygon with an even number of sides, which quadrilaterals alone can fill: the augmenting
//! path of matching, but free to choose all diagonals. A lone triangle and a quadrilateral can
//! change their common side, two quadrilaterals likewise. A patch changes only where its cost falls,
//! so the search ends.
//!
//! This is done only in meshes whose border is the boundary (`edge=on`), as they are made for their own
//! sake. There, nodes near faults are no longer the packed centres.

use super::division::{Division, MOST, TRIANGLE};
use super::quads::{Faces, is_lone, score};
use super::triangles::NONE;
use super::{Face, Node};

/// The most elements of a patch.
const LONGEST: usize = (MOST - 2) / 2;
/// What an inner node costs for each side that it has more or less than four.
const IRREGULAR: f64 = 0.12;
/// A smaller gain does not count.
const LEAST_GAIN: f64 = 1e-3;
/// A quadrilateral that costs less, among regular nodes, is left alone.
const FINE: f64 = 0.15;
/// Regular nodes make up for no more than this cost.
const SLACK: f64 = 0.5;
/// The most times all patches are tried.
const ROUNDS: usize = 6;

/// Divides patches anew until none gains, or until triangles are at most `few`. The new
/// quadrilaterals score at least `worst`. Sides for which `keep` holds are not dissolved.
pub(super) fn requadrangulate(
    nodes: &[Node],
    faces: &mut Faces,
    worst: f64,
    few: usize,
    keep: impl Fn([u32; 2]) -> bool,
) {
    let mut search = Search::new(nodes, faces, worst, keep);
    for _ in 0..ROUNDS {
        let mut again = false;
        for first in 0..search.faces.faces.len() {
            if search.triangles <= few {
                return;
            }
            again |= search.try_from(first as u32);
        }
        if !again {
            break;
        }
    }
}

struct Search<'a, K> {
    nodes: &'a [Node],
    faces: &'a mut Faces,
    keep: K,
    /// Quadrilaterals have at least this score.
    worst: f64,
    /// How many lone triangles there are.
    triangles: usize,
    /// Sides at each node.
    valence: Vec<i32>,
    /// Nodes on the border of the mesh.
    border: Vec<bool>,
    /// Elements whose surroundings have changed since they were tried.
    fresh: Vec<bool>,
    /// How many elements away from the first one, for those in `reached`.
    depth: Vec<u8>,
    reached: Vec<u32>,
    division: Division,
}

/// A patch: a polygon of elements.
#[derive(Clone)]
struct Patch {
    corners: Vec<u32>,
    /// The element outside, across the side from each corner to the next.
    outside: Vec<u32>,
    /// The elements of the patch.
    members: Vec<u32>,
    /// What its elements cost.
    cost: f64,
}

impl<'a, K: Fn([u32; 2]) -> bool> Search<'a, K> {
    fn new(nodes: &'a [Node], faces: &'a mut Faces, worst: f64, keep: K) -> Self {
        let mut valence = vec![0; nodes.len()];
        let mut border = vec![false; nodes.len()];
        for (face, adjacent) in faces.faces.iter().zip(&faces.adjacent) {
            let corners = face.nodes();
            for k in 0..corners.len() {
                let (a, b) = (
                    corners[k] as usize,
                    corners[(k + 1) % corners.len()] as usize,
                );
                valence[a] += 1;
                if adjacent[k] == NONE {
                    border[a] = true;
                    border[b] = true;
                }
            }
        }
        Self {
            nodes,
            keep,
            worst,
            triangles: faces.faces.iter().filter(|f| is_lone(nodes, f)).count(),
            valence,
            border,
            fresh: vec![true; faces.faces.len()],
            depth: vec![u8::MAX; faces.faces.len()],
            reached: Vec::new(),
            faces,
            division: Division::new(),
        }
    }

    /// Tries the patches that begin with this element, and takes the one that gains most.
    fn try_from(&mut self, first: u32) -> bool {
        let face = self.faces.faces[first as usize];
        let tried = !std::mem::replace(&mut self.fresh[first as usize], false);
        if face.sides == 0
            || tried
            || (face.sides == 3 && !is_lone(self.nodes, &face))
            || (face.sides == 4 && self.is_fine(&face))
        {
            return false;
        }
        let start = Patch {
            corners: face.nodes().to_vec(),
            outside: self.faces.adjacent[first as usize][..face.nodes().len()].to_vec(),
            members: vec![first],
            cost: self.cost(&face),
        };
        let mut best = None;
        let mut gain = LEAST_GAIN;
        for next in start.outside.clone() {
            self.consider(self.grow(&start, next), &mut gain, &mut best);
        }
        if face.sides == 3 {
            self.paths(&start, &mut gain, &mut best);
        }
        let Some(best) = best else { return false };
        self.triangles -= (self.triangles_in(&best) / 2) * 2;
        self.division.of(self.nodes, &best.corners, self.worst);
        self.apply(&best);
        true
    }

    /// A good quadrilateral among regular nodes is left alone.
    fn is_fine(&self, face: &Face) -> bool {
        let regular = |&k: &u32| self.border[k as usize] || self.valence[k as usize] == 4;
        face.nodes().iter().all(regular) && self.cost(face) < FINE
    }

    fn triangles_in(&self, patch: &Patch) -> usize {
        let members = patch.members.iter();
        members
            .filter(|&&f| self.faces.faces[f as usize].sides == 3)
            .count()
    }

    fn consider(&mut self, patch: Option<Patch>, gain: &mut f64, best: &mut Option<Patch>) {
        if let Some(patch) = patch {
            let now = self.gain(&patch);
            if now > *gain {
                *gain = now;
                *best = Some(patch);
            }
        }
    }

    /// Considers the shortest paths to other triangles nearby.
    fn paths(&mut self, start: &Patch, gain: &mut f64, best: &mut Option<Patch>) {
        let first = start.members[0];
        self.reached.push(first);
        self.depth[first as usize] = 0;
        let mut at = 0;
        while at < self.reached.len() {
            let face = self.reached[at];
            at += 1;
            let depth = self.depth[face as usize] + 1;
            if usize::from(depth) >= LONGEST
                || (depth > 1 && self.faces.faces[face as usize].sides == 3)
            {
                continue;
            }
            for next in self.faces.adjacent[face as usize] {
                if next != NONE && self.depth[next as usize] == u8::MAX {
                    self.depth[next as usize] = depth;
                    self.reached.push(next);
                }
            }
        }
        let reached = std::mem::take(&mut self.reached);
        for &end in &reached[1..] {
            if self.faces.faces[end as usize].sides == 3 {
                let mut path = vec![end];
                self.trace(&mut path, start, gain, best);
            }
        }
        for &face in &reached {
            self.depth[face as usize] = u8::MAX;
        }
        self.reached = reached;
        self.reached.clear();
    }

    /// Goes on with a path from its far end back to the first element.
    fn trace(
        &mut self,
        path: &mut Vec<u32>,
        start: &Patch,
        gain: &mut f64,
        best: &mut Option<Patch>,
    ) {
        let last = path[path.len() - 1];
        let depth = self.depth[last as usize];
        if depth == 0 {
            let mut patch = Some(start.clone());
            for &next in path.iter().rev().skip(1) {
                patch = patch.and_then(|patch| self.grow(&patch, next));
            }
            return self.consider(patch, gain, best);
        }
        for next in self.faces.adjacent[last as usize] {
            if next != NONE && self.depth[next as usize] == depth - 1 {
                path.push(next);
                self.trace(path, start, gain, best);
                path.pop();
            }
        }
    }

    fn cost(&self, face: &Face) -> f64 {
        match *face.nodes() {
            [a, b, c, d] => 1.0 - score(self.nodes, [a, b, c, d]),
            _ => TRIANGLE,
        }
    }

    /// The patch with an element added that is adjacent to its last member; none where a node would lie
    /// inside, or the side between them is to be kept.
    fn grow(&self, patch: &Patch, next: u32) -> Option<Patch> {
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
        if (self.keep)([a.min(b), a.max(b)]) {
            return None;
        }
        let k = (0..n).find(|&k| patch.corners[k] == a && patch.corners[(k + 1) % n] == b)?;
        let mut grown = Patch {
            corners: Vec::with_capacity(n + 2),
            outside: Vec::with_capacity(n + 2),
            members: patch.members.clone(),
            cost: patch.cost + self.cost(&face),
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

    /// The cost that dividing a patch anew would save.
    fn gain(&mut self, patch: &Patch) -> f64 {
        let n = patch.corners.len();
        let cost = self.division.of(self.nodes, &patch.corners, self.worst);
        if cost >= patch.cost + SLACK {
            return 0.0;
        }
        // Sides at each corner before and after, those within the patch.
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
                regular += (now - 4).abs() - (then - 4).abs();
            }
        }
        patch.cost - cost + IRREGULAR * f64::from(regular)
    }

    /// Puts the division that was found in place of the patch's elements.
    fn apply(&mut self, patch: &Patch) {
        let n = patch.corners.len();
        for &f in &patch.members {
            for &node in self.faces.faces[f as usize].nodes() {
                self.valence[node as usize] -= 1;
            }
        }
        let mut slots = patch.members.iter();
        // Sides within: (from, to, element, place), to be matched with their other half.
        let mut sides: Vec<(u8, u8, u32, usize)> = Vec::new();
        for &f in patch.members.iter().chain(&patch.outside) {
            if f != NONE {
                self.fresh[f as usize] = true;
            }
        }
        let faces = &mut *self.faces;
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
                        let corners = faces.faces[outer as usize];
                        let corners = corners.nodes();
                        let m = corners.len();
                        for j in 0..m {
                            if corners[j] == b && corners[(j + 1) % m] == a {
                                faces.adjacent[outer as usize][j] = slot;
                            }
                        }
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
