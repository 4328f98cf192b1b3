//! What the stages of a pavement have made, and what they are making.

use super::slices::Packs;
use super::stage::Stage;
use super::stages::Stages;
use crate::cells::Cell;
use crate::domain::Domain;
use crate::generators::height_field::Finish;
use crate::heightfield::Planes;
use crate::material::Coat;
use crate::mesh::Mesh;
use crate::packing::Packing;

/// Where nothing else is said, what was made last, stale or not.
impl Stages {
    /// The packing at work, or the last one.
    pub fn shown_packing(&self) -> Option<&Packing> {
        match self.packing.work() {
            Some(Packs::Moving(packing)) => Some(packing),
            _ => self.packing.made(),
        }
    }

    /// The packing at work, or the last one, and the domain: it keeps what it works out of itself.
    pub fn shown_packing_mut(&mut self) -> Option<(&mut Packing, &Domain)> {
        let is_moving = matches!(self.packing.work(), Some(Packs::Moving(_)));
        let packing = match is_moving {
            true => self.packing.work_mut().and_then(|packs| match packs {
                Packs::Moving(packing) => Some(&mut **packing),
                Packs::Placing(_) => None,
            }),
            false => self.packing.made_mut(),
        };
        packing.zip(self.terrain.domain.made())
    }

    /// Are there cells of the packing at work, or of one that is over and fresh?
    pub fn is_packing(&self) -> bool {
        match self.at() {
            Some(Stage::Packing) => {
                let work = self.packing.work_of(self.terrain.revision());
                matches!(work, Some(Packs::Moving(_)))
            }
            at => at.is_none_or(|stage| stage > Stage::Packing),
        }
    }

    /// Is the pavement forming anew, so that older pictures are of another one?
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

    /// Of the cells.
    pub fn cells_revision(&self) -> u64 {
        self.cells.revision()
    }

    /// The cells that stones are made of: of skin, those in which the axes have one sense.
    pub fn scales(&self) -> &[Cell] {
        let oriented = self.flow.made_of(self.cell_inputs());
        let oriented = oriented.filter(|cells| !cells.is_empty());
        oriented.map_or_else(|| self.cells(), Vec::as_slice)
    }

    /// What the cells wear by rule; none while other cells form.
    pub fn coats(&self) -> &[Coat] {
        let forms = self.at().is_some_and(|stage| stage < Stage::Planes);
        let coats = self.coats.made_of(self.cell_inputs());
        coats.filter(|_| !forms).map_or(&[], Vec::as_slice)
    }

    /// Stones painted by now.
    pub fn stones(&self) -> usize {
        match self.at() {
            Some(stage) if stage <= Stage::Planes => {
                self.finish.stones_coming(self.finish_inputs())
            }
            _ => self.scales().len(),
        }
    }

    /// Is the ground laid that the stones at work come on?
    pub fn is_bedded(&self) -> bool {
        match self.at() {
            Some(stage) if stage <= Stage::Planes => self.finish.is_bedded(self.finish_inputs()),
            _ => true,
        }
    }

    /// The planes last finished.
    pub fn planes(&self) -> Option<&Planes> {
        self.finish.weather.made()
    }

    /// The planes on their way.
    pub fn planes_coming(&self) -> Option<&Planes> {
        let stage = match self.at()? {
            Stage::Planes => Finish::Planes,
            Stage::Weather => Finish::Weather,
            _ => return None,
        };
        self.finish.planes_coming(stage, self.finish_inputs())
    }

    /// The picture last finished, empty before there is one.
    pub fn picture(&self) -> &[u8] {
        self.finish.light.made().map_or(&[], Vec::as_slice)
    }

    /// Grows whenever something else may be seen.
    pub fn slices(&self) -> u64 {
        let packing = self.packing.slices() + self.mesh.slices() + self.cells.slices();
        let before = self.terrain.slices() + packing;
        before + self.flow.slices() + self.coats.slices() + self.finish.slices()
    }

    /// How often each stage has finished, in their order.
    pub fn runs(&self) -> [u64; 8] {
        [
            self.terrain.domain.revision(),
            self.terrain.fields.revision(),
            self.packing.revision(),
            self.mesh.revision(),
            self.cells.revision(),
            self.finish.planes.revision(),
            self.finish.weather.revision(),
            self.finish.light.revision(),
        ]
    }
}
