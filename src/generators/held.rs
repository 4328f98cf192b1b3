//! A packing that is run again, so that it can be held at any of its steps.

use super::Clock;
use super::packs::PackingGround;
use super::until;
use crate::packing::{History, Kept, PackingParams};

/// The parameters of a packing, and the revisions of its domain and its fields.
pub(super) type Origin = (PackingParams, [u64; 2]);

/// The packing of the present recipe, run again: first `L` places its cells, then `M` moves them.
pub(super) struct Held<L, M> {
    of: Origin,
    asked: u32,
    /// Whether views show it; else only its states are kept.
    pub is_shown: bool,
    /// `None` until there is a ground.
    progress: Option<HeldProgress<L, M>>,
}

/// The progress of a held packing.
enum HeldProgress<L, M> {
    Placing(Option<Box<L>>),
    Stepping(Box<History<M>>),
}

impl<L, M: Kept> Held<L, M> {
    /// Requests a step; `None` drops the held packing.
    pub fn ask(slot: &mut Option<Self>, step: Option<u32>, of: Origin) {
        let kept = slot.take();
        *slot = step.map(|asked| {
            let (of, progress) = kept.map_or((of, None), |held| (held.of, held.progress));
            Self {
                of,
                asked,
                is_shown: true,
                progress,
            }
        });
    }

    /// Works for about `budget` milliseconds towards the requested step; true when the step is reached. It is also true
    /// if no step can be reached: without a ground, or if no cells can be placed. A packing of another origin starts
    /// again.
    pub fn reach(
        slot: &mut Option<Self>,
        ground: Option<impl PackingGround<Placing = L, Packing = M>>,
        of: Origin,
        clock: Clock,
        budget: f64,
    ) -> bool {
        let (Some(held), Some(ground)) = (slot.as_mut(), ground) else {
            return true;
        };
        if held.of != of {
            (held.of, held.progress) = (of, None);
        }
        until(clock, budget, || held.advance(ground))
    }

    /// Does one slice of work; true when the step is reached.
    fn advance(&mut self, ground: impl PackingGround<Placing = L, Packing = M>) -> bool {
        match &mut self.progress {
            None => {
                let placing = ground.begin(self.of.0.clone()).ok().map(Box::new);
                self.progress = placing.map(|placing| HeldProgress::Placing(Some(placing)));
                self.progress.is_none()
            }
            Some(HeldProgress::Stepping(history)) => {
                history.ask(self.asked);
                history.advance(|packing| {
                    ground.advance(packing);
                })
            }
            Some(HeldProgress::Placing(placing)) => {
                let is_full = |placing: &mut Box<L>| ground.place(placing);
                if let Some(placing) = placing.take_if(is_full) {
                    let (first, _) = ground.finish(*placing);
                    let history = Box::new(History::new(first));
                    self.progress = Some(HeldProgress::Stepping(history));
                }
                false
            }
        }
    }

    /// The packing at the step that it has reached; `None` before its first cells are placed, or if its origin is not
    /// `of`.
    pub fn packing(&self, of: &Origin) -> Option<&M> {
        match &self.progress {
            Some(HeldProgress::Stepping(history)) if self.of == *of => Some(history.packing()),
            _ => None,
        }
    }

    /// The same packing, mutable, whatever its origin is.
    pub fn packing_mut(&mut self) -> Option<&mut M> {
        match &mut self.progress {
            Some(HeldProgress::Stepping(history)) => Some(history.packing_mut()),
            _ => None,
        }
    }

    /// A copy of the packing, from which the run can go on; `None` if the run ends at this step.
    pub fn going_on(&self, of: &Origin) -> Option<Box<M>> {
        let packing = self.packing(of)?;
        (!packing.is_over()).then(|| Box::new(packing.clone()))
    }
}
