//! What the stages have made so far, finished or not.

use super::build::Built;
use super::fields::Fielded;
use super::paving::Paved;
use super::stages::{PACKING, STONES, Stages};
use crate::generators::packs::Packs;
use crate::graph::Wiring;
use crate::packing::StepReport;
use crate::scene::Scene;
use crate::surface_cells::SurfaceMesh;
use crate::surface_packing::{Site, SurfacePacking};
use std::rc::Rc;

/// How often some of it was made.
#[derive(Clone, Copy, Debug)]
pub(super) struct Revisions {
    pub fields: u64,
    pub mesh: u64,
    pub cells: u64,
}

impl Stages {
    /// The surface, if it is of the parameters at work.
    pub fn built(&self) -> Option<&Built> {
        self.current(&self.built)
    }

    /// The surface last made.
    pub fn last_built(&self) -> Option<&Built> {
        self.built.made()
    }

    /// The site last made.
    pub fn site(&self) -> Option<&Site> {
        self.site.made()
    }

    /// The fields of the surface that is there.
    pub fn fresh_fields(&self) -> Option<&Fielded> {
        self.current(&self.fields)
    }

    /// The packing at work on the fields that are there, or the one that came of it.
    pub fn live_packing(&self) -> Option<&SurfacePacking> {
        match self.begun(&self.packing) {
            Some(packs) => packs.moving(),
            None => self.current(&self.packing),
        }
    }

    /// The number of the surface last made, and of what was made on it.
    pub fn revisions(&self) -> (u64, Revisions) {
        let revisions = Revisions {
            fields: self.fields.revision(),
            mesh: self.mesh.revision(),
            cells: self.paved.revision(),
        };
        (self.built.revision(), revisions)
    }

    /// The packing at work, or the last one.
    pub fn packing(&self) -> Option<&SurfacePacking> {
        let moving = self.packing.work().and_then(Packs::moving);
        moving.or(self.packing.made())
    }

    /// The packing at work, and its site. The packing keeps the answers to some questions.
    pub fn packing_mut(&mut self) -> Option<(&mut SurfacePacking, &Site)> {
        let moving = self.packing.work_mut().and_then(Packs::moving_mut);
        moving.zip(self.site.made())
    }

    /// Do cells move?
    pub fn is_moving(&self) -> bool {
        let moving = self.begun(&self.packing).and_then(Packs::moving);
        self.at() == Some(PACKING) && moving.is_some_and(|packing| !packing.is_in_a_step())
    }

    /// What the last step did.
    pub fn report(&self) -> StepReport {
        self.packing()
            .map(SurfacePacking::report)
            .unwrap_or_default()
    }

    /// The cells' mesh last made.
    pub fn mesh(&self) -> Option<&SurfaceMesh> {
        self.mesh.made()
    }

    /// The cells last made.
    pub fn paved(&self) -> Option<&Paved> {
        self.paved.made()
    }

    /// The scene of stones last made, and its number.
    pub fn scene(&self) -> Option<(&Rc<Scene>, u64)> {
        Some((&self.stones.made()?.scene, self.stones.revision()))
    }

    /// Are there stones of the packing that is there, though others may be asked for?
    pub fn has_stones(&self) -> bool {
        let is_packed = self.is_fresh(&self.packing);
        let bodies = self.stones.made().filter(|_| is_packed);
        bodies.is_some_and(|bodies| bodies.packing == self.packing.revision())
    }

    /// Its digest; empty before there is one.
    pub fn digest(&self) -> String {
        let bodies = self.stones.made();
        bodies.map_or(String::new(), |bodies| bodies.digest.clone())
    }

    /// How much of the stones is done.
    pub fn stones(&self) -> usize {
        match (self.stones.work(), self.paved.made()) {
            (Some(work), Some(paved)) => {
                (work.progress(&paved.cells) * paved.cells.len() as f64) as usize
            }
            (None, Some(paved)) if self.at().is_none_or(|at| at > STONES) => paved.cells.len(),
            _ => 0,
        }
    }

    /// The picture last made.
    pub fn picture(&self) -> &[u8] {
        self.still.made().map_or(&[], Vec::as_slice)
    }

    /// Grows with all that views may show of the packing.
    pub fn changes(&self) -> u64 {
        self.packing.slices() + self.packing.revision()
    }
}
