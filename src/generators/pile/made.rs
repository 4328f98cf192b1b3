//! The results of the stages so far, finished or not.

use super::darting::Placing;
use super::params::ComponentSource;
use super::schema::FILE;
use super::stages::{BODIES, PileStages, REFINE};
use crate::graph::Wiring;
use crate::pile::{Body, Fate, Kind, Refining};
use glam::DVec3;
use std::sync::Arc;

/// Darts, and the types that they are for.
pub(super) struct Thrown {
    pub kinds: Arc<[Kind]>,
    /// For each dart its type, its place, and the normal.
    pub darts: Vec<(u32, DVec3, DVec3)>,
}

impl PileStages {
    /// The darts so far; none before the first is thrown.
    pub(super) fn darts(&self) -> Thrown {
        let thrown = |placing: &Placing| Thrown {
            kinds: placing.kinds().clone(),
            darts: placing.darts().collect(),
        };
        if let Some(placing) = self.begun(&self.placed) {
            return thrown(placing);
        }
        let placed = self.current(&self.placed);
        placed.map_or(
            Thrown {
                kinds: Arc::from([]),
                darts: Vec::new(),
            },
            |placed| Thrown {
                kinds: placed.kinds.clone(),
                darts: placed
                    .darts
                    .iter()
                    .map(|d| (d.kind, d.at, d.normal))
                    .collect(),
            },
        )
    }

    /// The bodies that are settling, or else the last settled pile; `None` before the first step.
    pub(super) fn refining(&self) -> Option<&Refining> {
        let last = self.settled.made().filter(|_| self.at() != Some(REFINE));
        self.begun(&self.settled).or(last)
    }

    /// Whether the present bodies have settled on the present shape.
    pub(super) fn is_settled(&self) -> bool {
        self.current(&self.settled).is_some() && self.is_fresh(&self.settled)
    }

    /// How many bodies have this fate so far.
    pub(super) fn count(&self, fate: Fate) -> usize {
        let bodies = self.refining().map_or(&[][..], Refining::bodies);
        bodies.iter().filter(|body| body.fate == fate).count()
    }

    /// A body of the present pile, by its id.
    pub(super) fn body(&self, id: u32) -> Option<&Body> {
        let number = (id as usize).checked_sub(1)?;
        self.current(&self.settled)?.bodies().get(number)
    }

    /// The number of finished bodies.
    pub(super) fn finished(&self) -> usize {
        match self.at() {
            Some(at) if at < BODIES => 0,
            _ => self.count(Fate::Kept),
        }
    }

    /// The words of the types' components.
    pub(super) fn words(&self) -> Vec<&'static str> {
        let sources = self.components.params().sources.iter();
        let word = |source: &ComponentSource| match source {
            ComponentSource::Kind(kind) => kind.word(),
            ComponentSource::File { .. } => FILE,
        };
        sources.map(word).collect()
    }
}
