//! Which part of a line is blocked, as a union of intervals.

use crate::order::{greater, lesser};

/// A union of open intervals. Only its part within the range from `lo` to `hi` matters.
///
/// The union does not depend on the order of adding, not even in its last bit.
#[derive(Clone, Debug)]
pub struct Blocked {
    lo: f64,
    hi: f64,
    /// Disjoint, in increasing order.
    intervals: Vec<(f64, f64)>,
}

impl Blocked {
    /// A range from `lo` to `hi` in which nothing is blocked; `lo` is at most `hi`.
    pub fn new(lo: f64, hi: f64) -> Self {
        let intervals = Vec::new();
        Self { lo, hi, intervals }
    }

    /// The blocked intervals within a part of the range.
    pub fn within(&self, (lo, hi): (f64, f64)) -> Self {
        if (lo, hi) == (self.lo, self.hi) {
            return self.clone();
        }
        let mut part = Self::new(lo, hi);
        for &(from, to) in &self.intervals {
            part.add(from, to);
        }
        part
    }

    /// Blocks the interval between `from` and `to`.
    pub fn add(&mut self, mut from: f64, mut to: f64) {
        if to <= self.lo || from >= self.hi || from >= to {
            return;
        }
        let first = self.intervals.iter().take_while(|i| i.1 < from).count();
        let end = self.intervals.iter().take_while(|i| i.0 <= to).count();
        for &(a, b) in &self.intervals[first..end] {
            from = lesser(from, a);
            to = greater(to, b);
        }
        self.intervals.splice(first..end, [(from, to)]);
    }

    /// The free place of the range that is nearest to 0. If two are equally near, it is the greater one. `None` if all
    /// is blocked.
    pub fn nearest_to_zero(&self) -> Option<f64> {
        let wanted = 0.0_f64.clamp(self.lo, self.hi);
        let Some(&(from, to)) = self.intervals.iter().find(|i| i.0 < wanted && wanted < i.1) else {
            return Some(wanted);
        };
        let down = (from >= self.lo).then_some(from);
        let up = (to <= self.hi).then_some(to);
        match (down, up) {
            (Some(down), Some(up)) => Some(if -down < up { down } else { up }),
            (down, up) => down.or(up),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Purpose, Random};

    #[test]
    fn the_nearest_free_place_is_an_end_of_an_interval() {
        let mut blocked = Blocked::new(-2.0, 1.0);
        assert_eq!(blocked.nearest_to_zero(), Some(0.0));
        blocked.add(-0.5, 0.25);
        assert_eq!(blocked.nearest_to_zero(), Some(0.25));
        blocked.add(0.2, 0.75);
        assert_eq!(blocked.nearest_to_zero(), Some(-0.5));
        blocked.add(-3.0, -0.5);
        assert_eq!(blocked.nearest_to_zero(), Some(0.75));
        blocked.add(0.75, 5.0);
        assert_eq!(blocked.nearest_to_zero(), None);
    }

    #[test]
    fn a_range_away_from_zero_begins_at_its_nearer_end() {
        let mut blocked = Blocked::new(0.5, 2.0);
        assert_eq!(blocked.nearest_to_zero(), Some(0.5));
        blocked.add(0.0, 1.5);
        assert_eq!(blocked.nearest_to_zero(), Some(1.5));
    }

    #[test]
    fn the_union_agrees_with_single_tests_in_any_order() {
        for seed in 0..200 {
            let mut random = Random::new(seed, Purpose::Dart, 0);
            let mut draw = |_| {
                let from = random.signed();
                (from, from + 0.2 * random.unit())
            };
            let mut intervals: Vec<(f64, f64)> = (0..12).map(&mut draw).collect();
            let fill = |intervals: &[(f64, f64)]| {
                let mut blocked = Blocked::new(-0.8, 0.8);
                for &(from, to) in intervals {
                    blocked.add(from, to);
                }
                blocked
            };
            let one = fill(&intervals);
            intervals.reverse();
            assert_eq!(one.intervals, fill(&intervals).intervals);
            let is_free = |t: f64| !intervals.iter().any(|i| i.0 < t && t < i.1);
            let best = (-800..=800).map(|k| f64::from(k) / 1000.0);
            let best = best
                .filter(|&t| is_free(t))
                .min_by(|a, b| a.abs().total_cmp(&b.abs()));
            match (one.nearest_to_zero(), best) {
                (Some(t), Some(best)) => assert!(is_free(t) && t.abs() <= best.abs() + 1e-12),
                (None, best) => assert_eq!(best, None),
                (Some(t), None) => assert!(is_free(t)),
            }
        }
    }
}
