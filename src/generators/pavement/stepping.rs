//! The packing held at any of its steps, and its numbers there. The stages go on, or stay finished, meanwhile; views
//! and measures of the packing show the held step.

use super::stages::Stages;
use super::{Pavement, Stage};
use crate::domain::Domain;
use crate::generators::packs::PackingProgress;
use crate::generators::{Clock, Engine, JoinedCells, Steps, until};
use crate::graph::Wiring;
use crate::packing::{
    CellNumbers, EnergyParts, History, Packing, PackingParams, Placing, PopulationChange,
};

/// The packing of the present recipe, run again so that it can be held.
pub(super) struct Held {
    /// The parameters that it was made with, and the revisions of its domain and its fields.
    of: (PackingParams, [u64; 2]),
    asked: u32,
    /// Whether views show it; else only its states are kept.
    is_shown: bool,
    progress: HeldProgress,
}

/// The states of a held packing.
enum HeldProgress {
    Placing(Option<Box<Placing>>),
    Stepping(Box<History>),
}

impl Held {
    /// `None` before there is an outline with fields.
    fn new(made: &Stages, asked: u32) -> Option<Self> {
        let ((domain, fields), of) = (made.ground()?, made_of(made));
        let placing = Placing::new(domain, fields, of.0.clone()).ok()?;
        Some(Self {
            of,
            asked,
            is_shown: true,
            progress: HeldProgress::Placing(Some(Box::new(placing))),
        })
    }

    /// Does one slice of work; true when the step is reached.
    fn advance(&mut self, made: &Stages) -> bool {
        let Some((domain, fields)) = made.ground() else {
            return true;
        };
        match &mut self.progress {
            HeldProgress::Stepping(history) => {
                history.ask(self.asked);
                history.advance(domain, fields)
            }
            HeldProgress::Placing(placing) => {
                let is_full = |placing: &mut Box<Placing>| placing.advance(domain, fields);
                if let Some(placing) = placing.take_if(is_full) {
                    let first = placing.finish(domain, fields);
                    self.progress = HeldProgress::Stepping(Box::new(History::new(first)));
                }
                false
            }
        }
    }

    fn history(&self) -> Option<&History> {
        match &self.progress {
            HeldProgress::Stepping(history) => Some(history),
            HeldProgress::Placing(_) => None,
        }
    }
}

fn made_of(made: &Stages) -> (PackingParams, [u64; 2]) {
    let revisions = [made.domain.revision(), made.fields.revision()];
    (made.packing.params().clone(), revisions)
}

impl Pavement {
    /// The held packing of the present recipe, once its first cells are placed.
    pub(super) fn held(&self) -> Option<&Packing> {
        let held = self.held.as_ref()?;
        if !held.is_shown || !self.can_be_held() {
            return None;
        }
        let history = held.history()?;
        (held.of == made_of(&self.made)).then(|| history.packing())
    }

    /// Makes the packing and all stages after it stale. A held packing goes on from its step; its states are kept, so
    /// that another step can be held soon.
    pub(super) fn forget_packing(&mut self) {
        let from = self.held().filter(|held| !held.done()).cloned();
        if let Some(held) = &mut self.held {
            held.is_shown = false;
        }
        self.made.packing.forget();
        if let Some(packing) = from {
            let moving = PackingProgress::Moving(Box::new(packing));
            self.made.packing.go_on(moving);
        }
    }

    /// The packing to show and to measure, with its domain.
    pub(super) fn packing_mut(&mut self) -> Option<(&mut Packing, &Domain)> {
        if self.held().is_none() {
            return self.made.shown_packing_mut();
        }
        match &mut self.held.as_mut()?.progress {
            HeldProgress::Stepping(history) => {
                Some((history.packing_mut(), self.made.domain.made()?))
            }
            HeldProgress::Placing(_) => None,
        }
    }

    /// Whether there are packed cells to show.
    pub(super) fn packs(&self) -> bool {
        self.held().is_some() || self.made.is_packing()
    }

    /// Whether outline and fields are those of the recipe.
    fn can_be_held(&self) -> bool {
        !self.is_drafting() && self.made.at().is_none_or(|stage| stage >= Stage::Packing)
    }
}

impl Steps for Pavement {
    fn hold(&mut self, step: Option<u32>) {
        self.changes += 1;
        match (&mut self.held, step) {
            (Some(held), Some(step)) => (held.asked, held.is_shown) = (step, true),
            (_, None) => self.held = None,
            (None, Some(step)) => self.held = Held::new(&self.made, step),
        }
    }

    fn reach(&mut self, clock: Clock, budget: f64) -> bool {
        // Outline and fields may still have to be made.
        if self.held.is_some() && !self.can_be_held() {
            return false;
        }
        let Some(held) = self.held.take() else {
            return true;
        };
        let asked = held.asked;
        let is_same = held.of == made_of(&self.made);
        let held = Some(held).filter(|_| is_same);
        self.held = held.or_else(|| Held::new(&self.made, asked));
        self.changes += 1;
        let (held, made) = (&mut self.held, &self.made);
        until(clock, budget, || {
            held.as_mut().is_none_or(|held| held.advance(made))
        })
    }

    fn join(&mut self, clock: Clock, budget: f64) -> bool {
        self.join_shown(clock, budget)
    }

    fn joined(&self) -> Option<&JoinedCells> {
        self.joining.as_ref()?.made.as_ref()
    }

    fn numbers(&mut self) -> Vec<CellNumbers> {
        let packing = self.packing_mut();
        packing.map_or(Vec::new(), |(packing, domain)| packing.numbers(domain))
    }

    fn energy_parts(&mut self) -> EnergyParts {
        let packing = self.packing_mut();
        packing.map_or(EnergyParts::default(), |(packing, domain)| {
            packing.energy_parts(domain)
        })
    }

    fn population_changes(&self) -> &[PopulationChange] {
        let packing = self.held().or(self.made.shown_packing());
        packing.map_or(&[], Packing::changes)
    }

    fn state_hash(&self) -> String {
        let packing = self.held().or(self.made.shown_packing());
        packing.map_or(String::new(), Packing::hash)
    }
}
