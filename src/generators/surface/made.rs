//! The results of the stages so far, finished or not.

use super::build::Built;
use super::fields::FieldsWithRemarks;
use super::params::MeshSource;
use super::paving::PavedCells;
use super::stages::{STONES, Stages, stones_params};
use crate::generators::ModelFacts;
use crate::generators::packs::PackingProgress;
use crate::graph::Wiring;
use crate::packing::StepReport;
use crate::scene::Scene;
use crate::surface_cells::SurfaceMesh;
use crate::surface_packing::{PackingMesh, SurfacePacking};
use crate::surface_stones::{Fit, StonesParams};
use std::rc::Rc;

/// Revisions of the results that views show.
#[derive(Clone, Copy, Debug)]
pub(super) struct Revisions {
    pub fields: u64,
    pub mesh: u64,
    pub cells: u64,
}

/// Stones on their cells.
pub(super) struct Standing<'a> {
    pub scene: &'a Rc<Scene>,
    pub params: StonesParams,
    pub paved: &'a PavedCells,
    /// The map from the model to the scene.
    pub fit: Fit,
    /// The revision of the stones.
    pub revision: u64,
}

impl Stages {
    /// The surface, if it was made from the present files; its parameters may be older.
    pub(super) fn built(&self) -> Option<&Built> {
        self.current(&self.built)
    }

    /// The last surface.
    pub(super) fn last_built(&self) -> Option<&Built> {
        self.built.made()
    }

    /// Measures of the surface, if the recipe takes it from a file.
    pub(super) fn model(&self) -> Option<ModelFacts> {
        let built = self.built()?;
        let MeshSource::Model(_) = self.built.params().source else {
            return None;
        };
        let (low, high) = built.whole.bounds();
        Some(ModelFacts {
            cells: ((high - low) / built.size).to_array(),
            is_open: built.is_open,
        })
    }

    /// The last surface that was prepared for packing.
    pub(super) fn site(&self) -> Option<&PackingMesh> {
        self.site.made()
    }

    /// The fields of the present surface.
    pub(super) fn fresh_fields(&self) -> Option<&FieldsWithRemarks> {
        self.current(&self.fields)
    }

    /// The packing in progress on the present fields, or the finished one.
    pub(super) fn live_packing(&self) -> Option<&SurfacePacking> {
        match self.begun(&self.packing) {
            Some(packs) => packs.moving(),
            None => self.current(&self.packing),
        }
    }

    /// The revision of the last surface, and the revisions of the results on it.
    pub(super) fn revisions(&self) -> (u64, Revisions) {
        let revisions = Revisions {
            fields: self.fields.revision(),
            mesh: self.mesh.revision(),
            cells: self.paved.revision(),
        };
        (self.built.revision(), revisions)
    }

    /// The packing in progress, or the last one.
    pub(super) fn packing(&self) -> Option<&SurfacePacking> {
        PackingProgress::shown(&self.packing)
    }

    /// The packing in progress, or the last one; mutable, with the surface that it is on. `None` if there is another
    /// surface by now.
    pub(super) fn packing_mut(&mut self) -> Option<(&mut SurfacePacking, &PackingMesh)> {
        let moving = self.packing.work().and_then(PackingProgress::moving);
        let is_current = match moving {
            Some(_) => self.begun(&self.packing).is_some(),
            None => self.current(&self.packing).is_some(),
        };
        let shown = PackingProgress::shown_mut(&mut self.packing);
        shown.filter(|_| is_current).zip(self.site.made())
    }

    /// The report of the last step.
    pub(super) fn report(&self) -> StepReport {
        self.packing()
            .map(SurfacePacking::report)
            .unwrap_or_default()
    }

    /// The mesh of cells on the present surface.
    pub(super) fn mesh(&self) -> Option<&SurfaceMesh> {
        self.current(&self.mesh)
    }

    /// The cells on the present surface.
    pub(super) fn paved(&self) -> Option<&PavedCells> {
        self.current(&self.paved)
    }

    /// The last scene of stones, and its revision.
    pub(super) fn scene(&self) -> Option<(&Rc<Scene>, u64)> {
        Some((self.shared.scene()?, self.shared.bodies.revision()))
    }

    /// The stones with their cells, if both are those of the present recipe.
    pub(super) fn standing(&self) -> Option<Standing<'_>> {
        Some(Standing {
            scene: &self.current(&self.shared.bodies)?.scene,
            params: stones_params(self.shared.bodies.params(), &self.paved()?.cells),
            paved: self.paved()?,
            fit: Fit::new(&self.last_built()?.whole),
            revision: self.shared.bodies.revision(),
        })
    }

    /// The number of stones made so far.
    pub(super) fn stones(&self) -> usize {
        match (self.begun(&self.shared.bodies), self.paved()) {
            (Some(work), Some(paved)) => {
                (work.progress(&paved.cells) * paved.cells.len() as f64) as usize
            }
            (None, Some(paved)) if self.at().is_none_or(|at| at > STONES) => paved.cells.len(),
            _ => 0,
        }
    }

    /// Grows with every change of the packing that views may show.
    pub(super) fn changes(&self) -> u64 {
        self.packing.slices() + self.packing.revision()
    }
}
