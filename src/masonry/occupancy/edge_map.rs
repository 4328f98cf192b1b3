//! The occupancy map of an edge: exact intervals.

use crate::order;

/// Intervals shorter than this are dropped (metres).
const TOUCH: f64 = 1e-9;

/// The claimed intervals of an edge. It begins empty: an edge has no holes.
#[derive(Clone, Debug, PartialEq)]
pub struct EdgeMap {
    length: f64,
    is_closed: bool,
    /// The claimed intervals with their cells, cut to the edge; sorted by start.
    claims: Vec<([f64; 2], u32)>,
}

impl EdgeMap {
    /// The map of an edge of this length (metres, above 0). The end of a closed edge, such as the rim of a tower, is
    /// its start.
    pub fn new(length: f64, is_closed: bool) -> Self {
        Self {
            length,
            is_closed,
            claims: Vec::new(),
        }
    }

    /// The edge's length, in metres.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Claims the interval from `a` to `b` for a cell, `a <= b` in metres from the edge's start. Parts beyond the ends
    /// of an open edge are left out; on a closed edge they wrap around.
    pub fn claim(&mut self, [a, b]: [f64; 2], cell: u32) {
        for [from, to] in self.within([a, b]) {
            let at = self
                .claims
                .partition_point(|(span, _)| order::rank(span[0]) <= order::rank(from));
            self.claims.insert(at, ([from, to], cell));
        }
    }

    /// The parts of an interval that lie on the edge.
    fn within(&self, [a, b]: [f64; 2]) -> Vec<[f64; 2]> {
        let shifts: &[f64] = if self.is_closed {
            &[-1.0, 0.0, 1.0]
        } else {
            &[0.0]
        };
        let parts = shifts.iter().map(|shift| {
            let by = shift * self.length;
            [(a + by).max(0.0), (b + by).min(self.length)]
        });
        parts.filter(|[from, to]| to - from > TOUCH).collect()
    }

    /// The claimed intervals with their cells, sorted by start.
    pub fn claims(&self) -> &[([f64; 2], u32)] {
        &self.claims
    }

    /// The intervals that nobody has claimed, in order; those of a closed edge are cut at its start.
    pub fn free(&self) -> Vec<[f64; 2]> {
        let mut free = Vec::new();
        let mut reached = 0.0;
        for &([from, to], _) in &self.claims {
            if from - reached > TOUCH {
                free.push([reached, from]);
            }
            reached = to.max(reached);
        }
        if self.length - reached > TOUCH {
            free.push([reached, self.length]);
        }
        free
    }

    /// The free length within an interval, in metres.
    pub fn free_within(&self, span: [f64; 2]) -> f64 {
        let free = self.free();
        let parts = self.within(span).into_iter().flat_map(|[a, b]| {
            let shared = free
                .iter()
                .map(move |[from, to]| (to.min(b) - from.max(a)).max(0.0));
            shared.collect::<Vec<f64>>()
        });
        parts.sum()
    }

    /// Whether a place of the edge is free.
    pub fn is_free(&self, at: f64) -> bool {
        let at = if self.is_closed {
            at.rem_euclid(self.length)
        } else {
            at
        };
        self.free()
            .iter()
            .any(|[from, to]| (*from..=*to).contains(&at))
    }

    /// The length without a claim, in metres.
    pub fn gap(&self) -> f64 {
        self.free().iter().map(|[from, to]| to - from).sum()
    }

    /// The length that is claimed more than once, in metres; each claim after the first counts again.
    pub fn overlap(&self) -> f64 {
        let claimed: f64 = self.claims.iter().map(|([from, to], _)| to - from).sum();
        claimed + self.gap() - self.length
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Purpose, Random};

    #[test]
    fn claims_and_gaps_fill_the_edge() {
        let mut random = Random::new(1, Purpose::Scatter, 0);
        for is_closed in [false, true] {
            let mut map = EdgeMap::new(3.0, is_closed);
            let mut samples = vec![0u32; 3000];
            for cell in 0..6 {
                let from = 4.0 * random.unit() - 0.5;
                let span = [from, from + 0.1 + 0.5 * random.unit()];
                map.claim(span, cell);
                for (k, sample) in samples.iter_mut().enumerate() {
                    let at = 0.001 * (k as f64 + 0.5);
                    let turns = if is_closed { -1..=1 } else { 0..=0 };
                    let places = turns.map(|turn| at + 3.0 * f64::from(turn));
                    *sample += places.filter(|p| (span[0]..span[1]).contains(p)).count() as u32;
                }
            }
            let count = |wanted: fn(u32) -> u32| {
                0.001 * f64::from(samples.iter().map(|&n| wanted(n)).sum::<u32>())
            };
            assert!((map.gap() - count(|n| u32::from(n == 0))).abs() < 0.02);
            assert!((map.overlap() - count(|n| n.saturating_sub(1))).abs() < 0.02);
            let free = (0..3000)
                .filter(|&k| map.is_free(0.001 * (f64::from(k) + 0.5)))
                .count();
            assert!((free as f64 * 0.001 - map.gap()).abs() < 0.02);
            assert!((map.free_within([0.0, 3.0]) - map.gap()).abs() < 1e-12);
        }
    }

    #[test]
    fn a_claim_over_the_seam_lies_at_both_ends() {
        let mut map = EdgeMap::new(2.0, true);
        map.claim([1.75, 2.25], 7);
        assert_eq!(map.claims(), [([0.0, 0.25], 7), ([1.75, 2.0], 7)]);
        assert_eq!(map.free(), [[0.25, 1.75]]);
        assert!(!map.is_free(2.1) && map.is_free(-1.0));
        let mut open = EdgeMap::new(2.0, false);
        open.claim([1.75, 2.25], 7);
        assert_eq!(open.free(), [[0.0, 1.75]]);
        assert!((open.free_within([1.5, 3.0]) - 0.25).abs() < 1e-12);
    }
}
