//! The results of a pavement's stages, finished or in progress.

use super::stage::Stage;
use super::stages::Stages;
use crate::cells::Cell;
use crate::domain::Domain;
use crate::field::Fields;
use crate::generators::height_field::Painting;
use crate::generators::packs::PackingProgress;
use crate::graph::Wiring;
use crate::heightfield::Planes;
use crate::material::Coat;
use crate::mesh::Mesh;
use crate::packing::Packing;

/// Values are those made last, stale or not, unless a comment says otherwise.
impl Stages {
    /// The domain and the fields, once both exist.
    pub fn ground(&self) -> Option<(&Domain, &Fields)> {
        self.domain.made().zip(self.fields.made())
    }

    /// The packing in progress, or the last one.
    pub fn shown_packing(&self) -> Option<&Packing> {
        PackingProgress::shown(&self.packing)
    }

    /// The packing in progress, or the last one; mutable, with the domain.
    pub fn shown_packing_mut(&mut self) -> Option<(&mut Packing, &Domain)> {
        PackingProgress::shown_mut(&mut self.packing).zip(self.domain.made())
    }

    /// Whether cells of the present packing can be shown: they are moving, or the packing is finished and fresh.
    pub fn is_packing(&self) -> bool {
        match self.at() {
            Some(Stage::Packing) => {
                let work = self.begun(&self.packing);
                work.is_some_and(|packs| packs.moving().is_some())
            }
            at => at.is_none_or(|stage| stage > Stage::Packing),
        }
    }

    /// Whether cells are forming again, so that the last picture shows an older pavement.
    pub fn is_forming(&self) -> bool {
        let packs = self.at().is_some_and(|stage| stage <= Stage::Packing);
        packs || self.pictured != self.packing.revision()
    }

    /// The mesh of the last packing that ended.
    pub fn mesh(&self) -> Option<&Mesh> {
        self.mesh.made()
    }

    /// The cells of the last packing that ended.
    pub fn cells(&self) -> &[Cell] {
        self.cells.made().map_or(&[], Vec::as_slice)
    }

    /// The revision of the cells.
    pub fn cells_revision(&self) -> u64 {
        self.cells.revision()
    }

    /// The cells of the stones. For skin, these are cells whose axes agree in sense.
    pub fn scales(&self) -> &[Cell] {
        let oriented = self.current(&self.flow);
        let oriented = oriented.filter(|cells| !cells.is_empty());
        oriented.map_or_else(|| self.cells(), Vec::as_slice)
    }

    /// The coats of the cells, made by the rule of colours; empty while new cells form.
    pub fn coats(&self) -> &[Coat] {
        let forms = self.at().is_some_and(|stage| stage < Stage::Planes);
        let coats = self.current(&self.coats);
        coats.filter(|_| !forms).map_or(&[], Vec::as_slice)
    }

    /// The painting in progress.
    fn painting(&self) -> Option<&Painting> {
        self.begun(&self.finish.planes)
    }

    /// The number of stones painted so far.
    pub fn stones(&self) -> usize {
        match self.at() {
            Some(stage) if stage <= Stage::Planes => self.painting().map_or(0, Painting::stones),
            _ => self.scales().len(),
        }
    }

    /// Whether the ground under the stones is finished.
    pub fn is_bedded(&self) -> bool {
        match self.at() {
            Some(stage) if stage <= Stage::Planes => {
                self.painting().is_some_and(Painting::is_bedded)
            }
            _ => true,
        }
    }

    /// The last finished planes.
    pub fn planes(&self) -> Option<&Planes> {
        self.finish.weather.made()
    }

    /// The unfinished planes, while stones are painted or weathered.
    pub fn planes_coming(&self) -> Option<&Planes> {
        match self.at()? {
            Stage::Planes => self.painting().map(Painting::planes),
            Stage::Weather => match self.begun(&self.finish.weather) {
                Some(weathering) => Some(weathering.planes()),
                None => Some(&self.finish.planes.made()?.planes),
            },
            _ => None,
        }
    }

    /// The last finished picture; empty before there is one.
    pub fn picture(&self) -> &[u8] {
        self.finish.light.made().map_or(&[], Vec::as_slice)
    }
}
