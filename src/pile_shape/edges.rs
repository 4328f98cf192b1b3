//! The lengths of edges.

use crate::trimesh::Soup;

/// How often a step is made shorter.
const TRIES: usize = 4;

/// The triangles that `make` gives for a step of about `share` of `edge`, with no edge longer than `edge`: the step
/// follows the longest one.
pub(super) fn within(edge: f64, share: f64, make: impl Fn(f64) -> Soup) -> Soup {
    let mut step = share * edge;
    let mut soup = make(step);
    for _ in 0..TRIES {
        let longest = longest(&soup);
        if longest <= edge {
            break;
        }
        step *= 0.99 * edge / longest;
        soup = make(step);
    }
    soup
}

fn longest(soup: &Soup) -> f64 {
    let lengths = soup.triangles.iter().flat_map(|t| {
        let [a, b, c] = t.map(|v| soup.positions[v as usize]);
        [a.distance(b), b.distance(c), c.distance(a)]
    });
    lengths.fold(0.0, f64::max)
}
