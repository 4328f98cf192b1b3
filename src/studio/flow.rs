//! Which stage works next, and for how long.

use super::{Position, Studio, translate};
use crate::domain::Outline;
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
        self.recipe = recipe;
        if !self.live || self.recipe.side() != self.working.side() {
            self.draft = None;
        }
        if !self.flows() && !self.lets_finish() {
            self.take_up();
        }
    }

    /// Paves exactly this outline from now on, whatever outline the recipe names.
    ///
    /// # Errors
    /// The sentence that says what is wrong with the outline; the last good one stays.
    pub fn set_exact_outline(&mut self, outline: &Outline) -> Result<Vec<String>, String> {
        let (outline, notices) = translate::checked(outline, &self.recipe)?;
        self.exact = Some(outline);
        self.restart();
        Ok(notices)
    }

    /// Runs all stages again, from the same recipe.
    pub fn restart(&mut self) {
        self.working = self.recipe.clone();
        self.draft = None;
        self.begin(Stage::Domain);
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
        while let Position::At(stage) = self.at {
            if stage == Stage::Packing && self.made.packing_begun {
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
        let shading = self.at == Position::At(Stage::Shading) && !self.made.forming;
        shading && self.last_shading <= ONE_FRAME
    }

    /// Makes exactly one step of the packing, after what must come before it; nothing once the
    /// packing is over or while cells flow.
    pub fn step(&mut self, clock: &mut dyn FnMut() -> f64) {
        if self.flows() {
            return;
        }
        self.draft = None;
        while let Position::At(stage) = self.at {
            if stage > Stage::Packing {
                return;
            }
            let stepping = stage == Stage::Packing && self.made.packing_begun;
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
    /// The sentence that says why no pavement can be made.
    pub fn finish(&mut self, clock: &mut dyn FnMut() -> f64) -> Result<(), String> {
        self.set_live(false);
        while matches!(self.at, Position::At(_)) {
            self.tick(clock, f64::INFINITY, u32::MAX);
        }
        match &self.at {
            Position::Failed(_, sentence) => Err(sentence.clone()),
            _ => Ok(()),
        }
    }

    /// One slice of a stage, begun at `before`, and on to the next stage when it was the last one.
    /// Answers with the time after it.
    fn timed_slice(&mut self, stage: Stage, before: f64, clock: &mut dyn FnMut() -> f64) -> f64 {
        self.changes[stage as usize] += 1;
        let result = self.made.slice(stage, &self.working);
        let after = clock();
        self.spent[stage as usize] += (after - before).max(0.0);
        match result {
            Ok(false) => {}
            Ok(true) => self.after(stage),
            Err(sentence) => self.at = Position::Failed(stage, sentence),
        }
        after
    }

    fn after(&mut self, stage: Stage) {
        if stage == Stage::Shading {
            self.last_shading = self.spent[stage as usize];
        }
        self.at = match Stage::ALL.get(stage as usize + 1) {
            Some(&next) => Position::At(next),
            None => Position::Done,
        };
        if self.at == Position::Done && self.recipe.stale_from(&self.working).is_some() {
            self.take_up();
        }
    }

    /// Is the work so near its end that it should finish before the new recipe begins?
    pub(super) fn lets_finish(&self) -> bool {
        let Position::At(at) = self.at else {
            return false;
        };
        let Some(stale) = self.recipe.stale_from(&self.working) else {
            return false;
        };
        let late = at >= Stage::Solids && stale >= Stage::Solids;
        let pass: f64 = self.spent[Stage::Solids as usize..].iter().sum();
        late && (at == Stage::Shading || pass < SHORT_PASS)
    }

    /// Makes the latest recipe the one at work.
    pub(super) fn take_up(&mut self) {
        let stale = self.recipe.stale_from(&self.working);
        self.working = self.recipe.clone();
        let failed = match &self.at {
            Position::Failed(stage, _) => Some(*stage),
            _ => None,
        };
        let Some(stale) = earlier(stale, failed) else {
            return;
        };
        // Stones are cut and painted in one go.
        let stale = if stale == Stage::Planes {
            Stage::Solids
        } else {
            stale
        };
        match self.at {
            Position::At(at) if at < stale => {}
            _ => self.begin(stale),
        }
    }

    fn begin(&mut self, stage: Stage) {
        if stage == Stage::Domain {
            self.made.outline = translate::outline(&self.working, self.exact.as_ref());
        }
        self.at = Position::At(stage);
        self.made.forget_work(stage);
        for k in stage as usize..Stage::ALL.len() {
            self.spent[k] = 0.0;
            self.changes[k] += 1;
        }
    }
}

fn earlier(a: Option<Stage>, b: Option<Stage>) -> Option<Stage> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.min(b)),
        (a, b) => a.or(b),
    }
}
