//! Drafts: while the user drags a point, the cells follow it. A draft of the packing continues with the present
//! particles, in the outline and the fields of the latest recipe. When the point is released, the packing is made from
//! its usual start, and replaces the draft.
//!
//! During the drag the stages stand still and are not changed by the draft. The draft is shown until the new packing
//! has ended.

use super::stages::Stages;
use super::{Pavement, Stage};
use crate::domain::Domain;
use crate::draw::Tones;
use crate::field::Fields;
use crate::generators::{Budget, Clock, Engine};
use crate::graph::Wiring;
use crate::packing::Packing;
use glam::DVec2;

/// The most steps that a draft makes in one call; with more, the cells would seem to rush.
const STEPS: u32 = 4;

/// A packing that follows the latest recipe, with stages of its own for its domain and its fields.
pub(super) struct Draft {
    pub(super) stages: Stages,
    pub packing: Packing,
    pub tones: Tones,
}

impl Pavement {
    /// The draft, while it is shown.
    pub(super) fn draft(&self) -> Option<&Draft> {
        let is_failed = self.made.failure().is_some();
        let packs = self.made.at().is_some_and(|stage| stage <= Stage::Packing) && !is_failed;
        self.draft.as_ref().filter(|_| packs || self.is_drafting())
    }

    /// The draft, while it is active.
    pub(super) fn flowing(&self) -> Option<&Draft> {
        self.draft.as_ref().filter(|_| self.is_drafting())
    }

    /// Works on the draft; true if it may look different.
    pub(super) fn flow(&mut self, clock: Clock, budget: f64) -> bool {
        let budget = Budget::new(clock, budget);
        let is_old = |draft: &mut Draft| draft.stages.stale().is_some();
        let stale = self.draft.take_if(is_old);
        let mut worked = stale.is_some() || self.draft.is_none();
        if worked {
            self.draft = self.drafted(stale);
        }
        if let Some(draft) = &mut self.draft {
            let mut steps = 0;
            budget.until(clock, || {
                let is_over = draft.packing.done() || steps == STEPS;
                if !is_over {
                    draft.step();
                    steps += 1;
                }
                is_over
            });
            worked |= steps > 0;
        }
        self.changes += u64::from(worked);
        worked
    }

    /// A draft for the latest recipe with the particles of the last draft, or of the last packing; `None` if no cell
    /// fits.
    fn drafted(&self, last: Option<Draft>) -> Option<Draft> {
        let (mut stages, packing, tones) = match last {
            Some(last) => (last.stages, Some(last.packing), last.tones),
            None => (
                Stages::new(self.made.latest()),
                self.made.shown_packing().cloned(),
                self.tones(),
            ),
        };
        stages.take_up();
        while stages.at().is_some_and(|stage| stage < Stage::Packing) {
            stages.advance();
        }
        let (domain, fields) = stages.ground()?;
        let params = stages.packing.params().clone();
        // Cells with given places start there, so they cannot continue from the last packing.
        let carried = packing.filter(|_| params.given.is_empty());
        let carried = carried.map(|mut packing| {
            packing.warm_start(domain, fields, params.clone());
            packing
        });
        let packing = match carried.filter(|packing| packing.report().cells > 0) {
            Some(packing) => packing,
            None => Packing::new(domain, fields, params).ok()?,
        };
        Some(Draft {
            stages,
            packing,
            tones,
        })
    }

    /// The outline, domain, fields and packing to show: those of the draft while it is shown.
    pub(super) fn shown(&self) -> DraftView<'_> {
        let (stages, packing) = match self.draft() {
            Some(draft) => (&draft.stages, Some(&draft.packing)),
            None => (&self.made, self.held().or(self.made.shown_packing())),
        };
        let rings = stages.rings().iter();
        DraftView {
            rings: rings.map(Vec::as_slice).collect(),
            domain: stages.domain.made(),
            fields: stages.fields.made(),
            packing,
        }
    }
}

impl Draft {
    /// Makes one step of the packing.
    fn step(&mut self) {
        if let Some((domain, fields)) = self.stages.ground() {
            self.packing.step(domain, fields);
        }
    }

    /// The packing's potential energy, in units of the mean cell's spring constant k0.
    pub fn energy(&mut self) -> f64 {
        let domain = self.stages.domain.made();
        domain.map_or(0.0, |domain| self.packing.energy(domain))
    }
}

/// The outline, domain, fields and packing to show, from the draft or from the stages.
pub(super) struct DraftView<'a> {
    pub rings: Vec<&'a [DVec2]>,
    pub domain: Option<&'a Domain>,
    pub fields: Option<&'a Fields>,
    pub packing: Option<&'a Packing>,
}
