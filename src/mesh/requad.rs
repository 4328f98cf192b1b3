//! Local re-quadrangulation: patches of a few neighbouring elements are divided anew.
//!
//! Pairing by score leaves lone triangles without a partner, where another choice nearby would have given them one. Two
//! lone triangles and the quadrilaterals on a path between them form a polygon with an even number of sides, which
//! quadrilaterals alone can fill. This is like an augmenting path of a matching, but with free choice of all diagonals.
//! A lone triangle and a quadrilateral, or two quadrilaterals, can exchange their common side for another one. A patch
//! changes only if its cost falls, so the search ends.
//!
//! It runs only in meshes whose border is the boundary (`edge=on`), as they are made for display. There,
//! nodes near faults leave the packed centres.

use super::division::{Division, MOST};
use super::patch::{Goal, Patch, PatchSearch, SearchInputs};
use super::quads::{Faces, is_lone};
use super::triangles::NONE;
use super::{Face, Nodes};

/// The most elements of a patch.
const LONGEST: usize = (MOST - 2) / 2;
/// Least scores of quadrilaterals that replace lone triangles, tried one after another.
pub(crate) const STANDARDS: [f64; 6] = [0.5, 0.4, 0.3, 0.2, 0.2, 0.15];
/// Smaller gains do not count.
const LEAST_GAIN: f64 = 1e-3;
/// A quadrilateral with a lower cost, among regular nodes, is left unchanged.
const FINE: f64 = 0.15;
/// Most rounds over all patches.
const ROUNDS: usize = 6;

/// Divides patches anew until none gains, or until at most `few` triangles are left. New quadrilaterals score
/// at least `worst`. Sides for which `keep` holds are not dissolved.
pub(super) fn requadrangulate<N: Nodes + ?Sized>(
    nodes: &N,
    faces: &mut Faces,
    worst: f64,
    few: usize,
    keep: impl Fn([u32; 2]) -> bool,
) {
    let on = SearchInputs { nodes, keep };
    let mut search = PatchSearch::new(&on, std::mem::take(faces), Goal::new(worst, few));
    while !search.advance(&on, usize::MAX) {}
    *faces = search.finish();
}

impl PatchSearch {
    pub fn new<N: Nodes + ?Sized, K>(on: &SearchInputs<N, K>, faces: Faces, goal: Goal) -> Self {
        let mut valence = vec![0; on.nodes.count()];
        let mut border = vec![false; on.nodes.count()];
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
        let lone = faces.faces.iter().filter(|f| is_lone(on.nodes, f));
        Self {
            triangles: lone.count(),
            goal,
            valence,
            border,
            fresh: vec![true; faces.faces.len()],
            depth: vec![u8::MAX; faces.faces.len()],
            reached: Vec::new(),
            faces,
            division: Box::new(Division::new()),
            work: 0,
            round: 0,
            next: 0,
            again: false,
        }
    }

    /// Tries elements until about `count` divisions were sought; true when the search has ended.
    pub fn advance<N: Nodes + ?Sized, K: Fn([u32; 2]) -> bool>(
        &mut self,
        on: &SearchInputs<N, K>,
        count: usize,
    ) -> bool {
        let until = self.work.saturating_add(count);
        while self.round < ROUNDS {
            while self.next < self.faces.faces.len() {
                if self.triangles <= self.goal.few {
                    return true;
                }
                if self.work >= until {
                    return false;
                }
                self.next += 1;
                self.again |= self.try_from(on, self.next as u32 - 1);
            }
            if !self.again {
                return true;
            }
            (self.round, self.next, self.again) = (self.round + 1, 0, false);
        }
        true
    }

    /// The present elements; elements without sides are empty slots.
    pub fn finish(self) -> Faces {
        self.faces
    }

    /// Tries the patches that begin with this element and applies the one with the largest gain.
    fn try_from<N: Nodes + ?Sized, K: Fn([u32; 2]) -> bool>(
        &mut self,
        on: &SearchInputs<N, K>,
        first: u32,
    ) -> bool {
        let face = self.faces.faces[first as usize];
        let tried = !std::mem::replace(&mut self.fresh[first as usize], false);
        if face.sides == 0
            || tried
            || (face.sides == 3 && !is_lone(on.nodes, &face))
            || (face.sides == 4 && self.is_fine(on, &face))
        {
            return false;
        }
        let start = Patch {
            corners: face.nodes().to_vec(),
            outside: self.faces.adjacent[first as usize][..face.nodes().len()].to_vec(),
            members: vec![first],
            cost: self.cost(on, &face),
        };
        let mut best = None;
        let mut gain = LEAST_GAIN;
        for next in start.outside.clone() {
            let grown = self.grow(on, &start, next);
            self.consider(on, grown, &mut gain, &mut best);
        }
        if face.sides == 3 {
            self.paths(on, &start, &mut gain, &mut best);
        }
        let Some(best) = best else { return false };
        self.triangles -= (self.triangles_in(&best, on.nodes) / 2) * 2;
        self.division.of(on.nodes, &best.corners, self.goal.worst);
        self.apply(&best);
        true
    }

    /// Whether this is a good quadrilateral among regular nodes.
    fn is_fine<N: Nodes + ?Sized, K>(&self, on: &SearchInputs<N, K>, face: &Face) -> bool {
        let regular = |&k: &u32| self.border[k as usize] || self.valence[k as usize] == 4;
        face.nodes().iter().all(regular) && self.cost(on, face) < FINE
    }

    /// The number of lone triangles in a patch.
    fn triangles_in<N: Nodes + ?Sized>(&self, patch: &Patch, nodes: &N) -> usize {
        let members = patch.members.iter();
        members
            .filter(|&&f| is_lone(nodes, &self.faces.faces[f as usize]))
            .count()
    }

    fn consider<N: Nodes + ?Sized, K>(
        &mut self,
        on: &SearchInputs<N, K>,
        patch: Option<Patch>,
        gain: &mut f64,
        best: &mut Option<Patch>,
    ) {
        if let Some(patch) = patch {
            let now = self.gain(on, &patch);
            if now > *gain {
                *gain = now;
                *best = Some(patch);
            }
        }
    }

    /// Considers the shortest paths to other triangles nearby.
    fn paths<N: Nodes + ?Sized, K: Fn([u32; 2]) -> bool>(
        &mut self,
        on: &SearchInputs<N, K>,
        start: &Patch,
        gain: &mut f64,
        best: &mut Option<Patch>,
    ) {
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
                self.trace(on, &mut path, start, gain, best);
            }
        }
        for &face in &reached {
            self.depth[face as usize] = u8::MAX;
        }
        self.reached = reached;
        self.reached.clear();
    }

    /// Follows all shortest paths from the last element of `path` back to the first element, and considers the patch of
    /// each path.
    fn trace<N: Nodes + ?Sized, K: Fn([u32; 2]) -> bool>(
        &mut self,
        on: &SearchInputs<N, K>,
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
                patch = patch.and_then(|patch| self.grow(on, &patch, next));
            }
            return self.consider(on, patch, gain, best);
        }
        for next in self.faces.adjacent[last as usize] {
            if next != NONE && self.depth[next as usize] == depth - 1 {
                path.push(next);
                self.trace(on, path, start, gain, best);
                path.pop();
            }
        }
    }
}
