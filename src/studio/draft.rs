//! While a point is dragged the cells flow after it: a draft of the packing goes on with the
//! particles that are there, in the outline and the fields of the latest recipe. When the point is
//! let go the packing is made from its own start, as ever, and takes the place of the draft.

use super::{Position, Studio, translate};
use crate::domain::{Domain, Outline};
use crate::field::{FieldBuilder, Fields};
use crate::packing::Packing;
use crate::recipe::{Recipe, Stage};
use crate::render::overlay_tones::Tones;
use glam::DVec2;

/// Steps that a draft makes in one tick at most: more would look hasty.
const STEPS: u32 = 4;

/// A packing that flows, and what it lies in.
pub(super) struct Draft {
    pub recipe: Recipe,
    pub outline: Outline,
    pub domain: Domain,
    pub fields: Fields,
    pub packing: Packing,
    pub tones: Tones,
}

impl Studio {
    /// While live, a recipe that changes the outline, the fields or the packing makes the cells flow
    /// from where they are instead of starting the work again, and nothing else is worked on. What
    /// was made for the last recipe before stays until live ends; then all goes on as if the latest
    /// recipe had just been set, but the flowing cells are shown until the new packing has ended.
    pub fn set_live(&mut self, on: bool) {
        let ends = self.live && !on;
        self.live = on;
        if ends {
            if !self.lets_finish() {
                self.take_up();
            }
            self.drop_draft();
        }
    }

    /// Is the packing a draft now?
    pub(super) fn flows(&self) -> bool {
        let stale = || self.recipe.stale_from(&self.working);
        self.live
            && self.recipe.side() == self.working.side()
            && stale().is_some_and(|stage| stage <= Stage::Packing)
    }

    /// The draft, while it is to be seen.
    pub(super) fn draft(&self) -> Option<&Draft> {
        let packs = matches!(self.at, Position::At(stage) if stage <= Stage::Packing);
        self.draft.as_ref().filter(|_| packs || self.flows())
    }

    /// The draft, while it is at work.
    pub(super) fn flowing(&self) -> Option<&Draft> {
        self.draft.as_ref().filter(|_| self.flows())
    }

    /// Drops a draft that is not needed any more.
    pub(super) fn drop_draft(&mut self) {
        if !self.live && self.draft().is_none() {
            self.draft = None;
        }
    }

    /// Works on the draft; true when it may look different.
    pub(super) fn flow(&mut self, clock: &mut dyn FnMut() -> f64, budget: f64) -> bool {
        let begin = clock();
        let stale = self.draft.take_if(|draft| draft.recipe != self.recipe);
        let mut worked = stale.is_some() || self.draft.is_none();
        if worked {
            self.draft = self.drafted(stale);
        }
        if let Some(draft) = &mut self.draft {
            for _ in 0..STEPS {
                if draft.packing.done() {
                    break;
                }
                draft.packing.step(&draft.domain, &draft.fields);
                worked = true;
                // Not `>=`: a clock that fails must not make this slower than it is.
                let inside = clock() - begin < budget;
                if !inside {
                    break;
                }
            }
        }
        self.changes[Stage::Packing as usize] += u64::from(worked);
        worked
    }

    /// A draft for the latest recipe with the particles of the last one, or of the last packing;
    /// nothing where no cell fits.
    fn drafted(&self, last: Option<Draft>) -> Option<Draft> {
        let recipe = self.recipe.clone();
        let outline = translate::outline(&recipe, self.exact.as_ref());
        let domain = translate::domain(&recipe, &outline);
        let fields = FieldBuilder::build(&domain, translate::fields(&recipe, &domain));
        let params = translate::packing(&recipe);
        let (packing, tones) = match last {
            Some(last) => (Some(last.packing), last.tones),
            None => (self.made.packing.clone(), self.tones()),
        };
        let carried = packing.map(|mut packing| {
            packing.carry(&domain, &fields, params);
            packing
        });
        let packing = match carried.filter(|packing| packing.report().cells > 0) {
            Some(packing) => packing,
            None => Packing::new(&domain, &fields, params).ok()?,
        };
        Some(Draft {
            recipe,
            outline,
            domain,
            fields,
            packing,
            tones,
        })
    }

    /// The recipe, domain, fields and packing to look at: those of the draft while it is to be seen.
    pub(super) fn shown(&self) -> Shown<'_> {
        let made = &self.made;
        match self.draft() {
            Some(draft) => Shown {
                rings: rings(&draft.outline),
                domain: Some(&draft.domain),
                fields: Some(&draft.fields),
                packing: Some(&draft.packing),
            },
            None => Shown {
                rings: rings(&made.outline),
                domain: made.domain.as_ref(),
                fields: made.fields.as_ref(),
                packing: made.packing.as_ref(),
            },
        }
    }
}

/// What is shown of the stages that a draft has.
pub(super) struct Shown<'a> {
    pub rings: Vec<&'a [DVec2]>,
    pub domain: Option<&'a Domain>,
    pub fields: Option<&'a Fields>,
    pub packing: Option<&'a Packing>,
}

fn rings(outline: &Outline) -> Vec<&[DVec2]> {
    outline.rings.iter().map(Vec::as_slice).collect()
}
