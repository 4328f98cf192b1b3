//! The work of a studio: slices within a frame's budget, single steps, or all to the end.

use super::Studio;
use crate::generators::{Budget, Clock};
use crate::notice::Notice;
#[cfg(house)]
use crate::{generators::TurnOrder, notice::Code, scene::Frame};

/// If the last shading took at most this many milliseconds, shading is done in one tick, beyond the budget, so
/// that each frame shows the present light.
const ONE_FRAME: f64 = 33.0;

impl Studio {
    /// Works for about `budget` milliseconds by `clock`, at least one slice, and makes at most `max_steps`
    /// steps (with 0 the stage that makes steps pauses, the other stages go on). True if the picture may have
    /// changed.
    ///
    /// While a draft is at work ([`Studio::set_live`]), it works on the draft only, whatever `max_steps` is.
    /// The result that replaces the draft is made at full speed, or shown from its start with 0 steps.
    pub fn tick(&mut self, clock: Clock, budget: f64, max_steps: u32) -> bool {
        if self.engine.is_drafting() {
            let drafts = self.engine.drafts();
            return drafts.is_some_and(|drafts| drafts.advance_draft(clock, budget));
        }
        if max_steps == 0 {
            self.drop_draft(true);
        }
        let max_steps = match self.engine.drafts() {
            Some(drafts) if drafts.shows_draft() => u32::MAX,
            _ => max_steps,
        };
        let mut now = clock();
        let budget = Budget::from(now, budget);
        let (mut steps, mut worked) = (0, false);
        while let Some(stage) = self.at_work() {
            if self.engine.is_step() {
                if steps >= max_steps {
                    break;
                }
                steps += 1;
            }
            worked = true;
            now = self.timed_slice(stage, now, clock);
            if budget.is_spent(now) && !self.shades_in_one() {
                break;
            }
        }
        self.drop_draft(false);
        worked
    }

    /// Whether a finished picture is being shaded again, and that fits into a frame.
    fn shades_in_one(&self) -> bool {
        let shades = self.at_work() == Some(self.last_stage());
        shades && !self.engine.is_forming() && self.last_shading <= ONE_FRAME
    }

    /// Makes exactly one step, after the work that must come before it. Does nothing once the steps are over or
    /// while a draft is at work.
    pub fn step(&mut self, clock: Clock) {
        if self.engine.is_drafting() {
            return;
        }
        self.drop_draft(true);
        let stepping = self.place_of(self.generator.course.stepping);
        let mut begun = false;
        while let Some(stage) = self.at_work() {
            // A step may take several slices: it is complete where the next one would begin.
            if Some(stage) > stepping || (begun && self.engine.is_step()) {
                return;
            }
            begun |= self.engine.is_step();
            let before = clock();
            self.timed_slice(stage, before, clock);
        }
    }

    /// Works until the picture is finished or fails.
    ///
    /// # Errors
    ///
    /// The reason why it cannot be made.
    pub fn finish(&mut self, clock: Clock) -> Result<(), Notice> {
        self.work_before(self.generator.stages.len(), clock)
    }

    /// Works until the planes or bodies are made, or fails: their picture is not drawn.
    ///
    /// # Errors
    ///
    /// The reason why they cannot be made.
    pub fn form(&mut self, clock: Clock) -> Result<(), Notice> {
        self.work_before(self.last_stage(), clock)
    }

    /// Does the work of all stages before this one.
    fn work_before(&mut self, end: usize, clock: Clock) -> Result<(), Notice> {
        self.set_live(false);
        while self.at_work().is_some_and(|stage| stage < end) {
            // One slice at a time, so that none of a later stage begins.
            self.tick(clock, 0.0, u32::MAX);
        }
        let failure = self.engine.failure();
        failure.map_or(Ok(()), |why| Err(why.clone()))
    }

    /// Finishes the picture, and then a frame of its bodies.
    ///
    /// # Errors
    ///
    /// The reason why there is none.
    #[cfg(house)]
    pub fn finish_frame(&mut self, order: &TurnOrder, clock: Clock) -> Result<&Frame, Notice> {
        self.finish(clock)?;
        let frames = self.frames()?;
        while !frames.turn(order, clock, f64::INFINITY)?.done {}
        frames.frame().ok_or(Code::NotYet.into())
    }

    /// Runs one slice of a stage, begun at `before`. Returns the time after it.
    fn timed_slice(&mut self, stage: usize, before: f64, clock: Clock) -> f64 {
        self.engine.advance();
        let after = clock();
        if self.last.replace(stage) != Some(stage) {
            self.spent[stage] = 0.0;
        }
        self.spent[stage] += (after - before).max(0.0);
        if self.engine.at().is_none() {
            self.last_shading = self.spent[self.last_stage()];
            if self.engine.stale().is_some() {
                self.take_up();
            }
        }
        after
    }
}
