//! A budget of time for work in slices, and the loop that keeps to it.

/// A clock, in milliseconds from any start. It may stand still: no result depends on it.
pub type Clock<'a> = &'a mut dyn FnMut() -> f64;

/// A time in milliseconds from `begin` on, read from a clock.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Budget {
    begin: f64,
    milliseconds: f64,
}

impl Budget {
    /// A budget that begins now.
    pub fn new(clock: Clock, milliseconds: f64) -> Self {
        Self::from(clock(), milliseconds)
    }

    /// A budget that began at the time `begin`.
    pub fn from(begin: f64, milliseconds: f64) -> Self {
        Self {
            begin,
            milliseconds,
        }
    }

    /// True when the budget has passed at the time `now`.
    pub fn is_spent(self, now: f64) -> bool {
        // Not `>=`: a clock that fails returns NaN, and must not make the work endless.
        let inside = now - self.begin < self.milliseconds;
        !inside
    }

    /// The milliseconds that are left; negative when they have passed.
    #[cfg(house)]
    pub fn left(self, clock: Clock) -> f64 {
        self.milliseconds - (clock() - self.begin)
    }

    /// Calls `slice` at least once, and again until it returns true (all is done) or the budget has passed. Returns
    /// true when all is done.
    pub fn until(self, clock: Clock, mut slice: impl FnMut() -> bool) -> bool {
        loop {
            if slice() {
                return true;
            }
            if self.is_spent(clock()) {
                return false;
            }
        }
    }
}

/// Works for about `budget` milliseconds from now on; see [`Budget::until`].
pub(crate) fn until(clock: Clock, budget: f64, slice: impl FnMut() -> bool) -> bool {
    Budget::new(clock, budget).until(clock, slice)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The slices done of `wanted` within `budget`, by a clock that returns these times and then the last one again.
    fn slices(times: &[f64], budget: f64, wanted: u32) -> (u32, bool) {
        let mut later = times.iter().copied();
        let mut now = 0.0;
        let mut clock = || {
            now = later.next().unwrap_or(now);
            now
        };
        let mut count = 0;
        let done = until(&mut clock, budget, || {
            count += 1;
            count == wanted
        });
        (count, done)
    }

    #[test]
    fn work_ends_with_the_time_or_with_the_work() {
        let times = [10.0, 11.0, 12.0, 13.0, 14.0];
        assert_eq!(slices(&times, 3.0, 9), (3, false));
        assert_eq!(slices(&times, 3.0, 2), (2, true));
        assert_eq!(slices(&times, 0.0, 9), (1, false));
        assert_eq!(slices(&times, -5.0, 9), (1, false));
        assert_eq!(slices(&times, f64::INFINITY, 99), (99, true));
    }

    #[test]
    fn a_clock_that_fails_allows_one_slice() {
        assert_eq!(slices(&[f64::NAN], 5.0, 9), (1, false));
        assert_eq!(slices(&[0.0, f64::NAN], 5.0, 9), (1, false));
    }

    #[test]
    fn what_was_done_before_counts() {
        let mut now = 0.0;
        let mut clock = || {
            now += 1.0;
            now
        };
        let budget = Budget::new(&mut clock, 3.0);
        clock();
        let mut count = 0;
        budget.until(&mut clock, || {
            count += 1;
            false
        });
        assert_eq!(count, 2);
        #[cfg(house)]
        assert_eq!(budget.left(&mut clock), -1.0);
    }
}
