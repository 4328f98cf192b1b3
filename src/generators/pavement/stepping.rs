//! The packing held at any of its steps, and its numbers there. Views and measures of the packing show the held step,
//! while the stages go on or stay finished.

use super::stages::Stages;
use super::{Pavement, Stage};
use crate::domain::Domain;
use crate::generators::held::{self, Origin};
use crate::generators::packs::PackingProgress;
use crate::generators::{Clock, Engine, JoinedCells, Rewind, Steps};
use crate::graph::Wiring;
use crate::packing::{CellNumbers, EnergyParts, Packing, Placing, PopulationChange};

/// The packing of the present recipe, run again so that it can be held.
pub(super) type Held = held::Held<Placing, Packing>;

fn origin(made: &Stages) -> Origin {
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
        held.packing(&origin(&self.made))
    }

    /// Makes the packing and all stages after it stale. If a packing is held, the stages go on from its step. The
    /// states of the held packing are kept, so that another step can be reached soon.
    pub(super) fn forget_packing(&mut self) {
        let is_held = self.held().is_some();
        let of = origin(&self.made);
        let from = self.held.as_mut().and_then(|held| {
            held.is_shown = false;
            is_held.then(|| held.going_on(&of)).flatten()
        });
        self.made.packing.forget();
        if let Some(packing) = from {
            self.made.packing.go_on(PackingProgress::Moving(packing));
        }
    }

    /// The packing to show and to measure, with its domain.
    pub(super) fn packing_mut(&mut self) -> Option<(&mut Packing, &Domain)> {
        if self.held().is_none() {
            return self.made.shown_packing_mut();
        }
        let packing = self.held.as_mut()?.packing_mut()?;
        Some((packing, self.made.domain.made()?))
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

impl Rewind for Pavement {
    fn hold(&mut self, step: Option<u32>) {
        self.changes += 1;
        Held::ask(&mut self.held, step, origin(&self.made));
    }

    fn reach(&mut self, clock: Clock, budget: f64) -> bool {
        // Outline and fields may still have to be made.
        if self.held.is_some() && !self.can_be_held() {
            return false;
        }
        self.changes += u64::from(self.held.is_some());
        let made = &self.made;
        Held::reach(&mut self.held, made.ground(), origin(made), clock, budget)
    }
}

impl Steps for Pavement {
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
