//! A search for the step with which a mesh has no edge that is too long.

use crate::trimesh::Soup;

/// How often a step is made shorter, at most.
const TRIES: usize = 4;

/// Looks for the step with which no edge is longer than wanted. Each try scales the step by the longest edge found.
pub(super) struct StepSearch {
    /// The step to try.
    pub step: f64,
    edge: f64,
    left: usize,
}

impl StepSearch {
    /// Starts with a step of this share of the longest edge that is allowed.
    pub fn new(edge: f64, share: f64) -> Self {
        Self {
            step: share * edge,
            edge,
            left: TRIES,
        }
    }

    /// Whether the triangles of this step are taken. If not, the step becomes shorter.
    pub fn takes(&mut self, soup: &Soup) -> bool {
        let longest = longest(soup);
        if longest <= self.edge || self.left == 0 {
            return true;
        }
        self.step *= 0.99 * self.edge / longest;
        self.left -= 1;
        false
    }
}

/// The triangles that `make` gives for a step of about `share` of `edge`, with no edge longer than `edge`.
pub(super) fn within(edge: f64, share: f64, make: impl Fn(f64) -> Soup) -> Soup {
    let mut search = StepSearch::new(edge, share);
    loop {
        let soup = make(search.step);
        if search.takes(&soup) {
            return soup;
        }
    }
}

fn longest(soup: &Soup) -> f64 {
    let lengths = soup.triangles.iter().flat_map(|t| {
        let [a, b, c] = t.map(|v| soup.positions[v as usize]);
        [a.distance(b), b.distance(c), c.distance(a)]
    });
    lengths.fold(0.0, f64::max)
}
