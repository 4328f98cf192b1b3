//! Which stage works next, and for how long.

use super::{Studio, Wish, params};
use crate::domain::Outline;
use crate::notice::Notice;
use crate::recipe::{Recipe, Stage};

/// A pass over the stones shorter than this many milliseconds is let finish before a newer recipe
/// begins, so that the picture follows a slider while it is dragged.
const SHORT_PASS: f64 = 400.0;
/// Shading that took at most this many milliseconds the last time is done in one tick, beyond the
/// budget, so that each frame shows the light where it is now.
const ONE_FRAME: f64 = 33.0;

impl Studio {
    /// Takes a new recipe; the stages it makes stale run again in the ticks to come. The latest
    /// recipe wins over one still at work.
    pub fn set_recipe(&mut self, recipe: Recipe) {
        self.ask(recipe);
        if !self.live || !self.keeps_side() {
            self.draft = None;
        }
        if !self.flows() && !self.lets_finish() {
            self.take_up();
        }
    }

    /// Paves exactly this outline from now on, whatever outline the recipe names.
    ///
    /// # Errors
    /// What is wrong with the outline; the last good one stays.
    pub fn set_exact_outline(&mut self, outline: &Outline) -> Result<Vec<Notice>, Notice> {
        let (outline, notices) = params::checked(outline, self.recipe())?;
        self.exact = Some(outline);
        self.ask(self.latest.recipe.clone());
        self.restart();
        Ok(notices)
    }

    /// Runs all stages again, from the same recipe.
    pub fn restart(&mut self) {
        self.draft = None;
        self.take_up();
        self.made.forget();
        self.begin(Stage::Domain);
    }

    /// From now on this recipe is the latest.
    pub(super) fn ask(&mut self, recipe: Recipe) {
        self.latest = Wish::new(recipe, self.exact.as_ref(), self.finer);
        self.stale = self.latest.params.first_difference(&self.working.params);
    }

    /// Is the latest picture as large as the one at work?
    pub(super) fn keeps_side(&self) -> bool {
        self.latest.recipe.side() == self.working.recipe.side()
    }

    /// Works for about `budget` milliseconds by `clock`, at least one slice, and makes at most
    /// `max_steps` steps of the packing (0 holds the packing still, the other stages go on). True
    /// when what is shown may have changed.
    ///
    /// While cells flow ([`Studio::set_live`]) it works on them only, whatever `max_steps` says. The
    /// packing that takes their place is made at full pace, or shown from its start with 0 steps.
    pub fn tick(&mut self, clock: &mut dyn FnMut() -> f64, budget: f64, max_steps: u32) -> bool {
        if self.flows() {
            return self.flow(clock, budget);
        }
        if max_steps == 0 {
            self.draft = None;
        }
        let max_steps = if self.draft().is_some() {
            u32::MAX
        } else {
            max_steps
        };
        let begin = clock();
        let (mut now, mut steps, mut worked) = (begin, 0, false);
        while let Some(stage) = self.at_work() {
            if stage == Stage::Packing && self.made.is_packing() {
                if steps >= max_steps {
                    break;
                }
                steps += 1;
            }
            worked = true;
            now = self.timed_slice(stage, now, clock);
            let inside = now - begin < budget;
            // Not `>=`: a clock that fails must not make the tick endless.
            if !inside && !self.shades_in_one() {
                break;
            }
        }
        self.drop_draft();
        worked
    }

    /// Is a finished pavement being lit anew, and can that be done in a frame?
    fn shades_in_one(&self) -> bool {
        let shading = self.at_work() == Some(Stage::Shading) && !self.made.is_forming();
        shading && self.last_shading <= ONE_FRAME
    }

    /// Makes exactly one step of the packing, after what must come before it; nothing once the
    /// packing is over or while cells flow.
    pub fn step(&mut self, clock: &mut dyn FnMut() -> f64) {
        if self.flows() {
            return;
        }
        self.draft = None;
        while let Some(stage) = self.at_work() {
            if stage > Stage::Packing {
                return;
            }
            let stepping = stage == Stage::Packing && self.made.is_packing();
            let before = clock();
            self.timed_slice(stage, before, clock);
            if stepping {
                return;
            }
        }
    }

    /// Works until the picture is finished or cannot be made.
    ///
    /// # Errors
    /// Why no pavement can be made.
    pub fn finish(&mut self, clock: &mut dyn FnMut() -> f64) -> Result<(), Notice> {
        self.set_live(false);
        while self.at_work().is_some() {
            self.tick(clock, f64::INFINITY, u32::MAX);
        }
        self.made.failure().map_or(Ok(()), |why| Err(why.clone()))
    }

    /// The stage that has work to do.
    pub(super) fn at_work(&self) -> Option<Stage> {
        self.made.at().filter(|_| self.made.failure().is_none())
    }

    /// One slice of a stage, begun at `before`. Answers with the time after it.
    fn timed_slice(&mut self, stage: Stage, before: f64, clock: &mut dyn FnMut() -> f64) -> f64 {
        self.made.advance();
        let after = clock();
        self.spent[stage as usize] += (after - before).max(0.0);
        if self.made.at().is_none() {
            self.last_shading = self.spent[Stage::Shading as usize];
            if self.stale.is_some() {
                self.take_up();
            }
        }
        after
    }

    /// Is the work so near its end that it should finish before the new recipe begins?
    pub(super) fn lets_finish(&self) -> bool {
        let (Some(at), Some(stale)) = (self.at_work(), self.stale) else {
            return false;
        };
        let late = at >= Stage::Planes && stale >= Stage::Planes;
        let pass: f64 = self.spent[Stage::Planes as usize..].iter().sum();
        late && (at == Stage::Shading || pass < SHORT_PASS)
    }

    /// Makes the latest recipe the one at work.
    pub(super) fn take_up(&mut self) {
        self.working = self.latest.clone();
        let Some(stale) = self.stale.take() else {
            return;
        };
        self.made.want(self.working.params.clone());
        self.begin(stale);
    }

    /// A stage has got something else to do, if there is work at all.
    fn begin(&mut self, stage: Stage) {
        self.changes += 1;
        if let Some(at) = self.made.at() {
            self.spent[at.max(stage) as usize..].fill(0.0);
        }
    }
}
