//! Files of a finished pavement: maps, and the mesh of all cells.

use super::Pavement;
#[cfg(house)]
use crate::export::MeshFile;
use crate::export::{Map, MapKind, MeshOrder, MeshSize, maps};
use crate::generators::bigger::{Bigger, Picture};
use crate::generators::height_field::Bodies;
use crate::generators::lighting::LightParams;
#[cfg(house)]
use crate::generators::until;
use crate::generators::{Clock, Engine, Maps, MeshSlice, Meshes, PictureSlice};
use crate::heightfield::Planes;
use crate::notice::{Code, Notice};
#[cfg(house)]
use crate::solid::Solids;

/// A mesh file that is being made.
#[cfg(house)]
pub(super) struct Saving {
    file: MeshFile,
    solids: Solids,
    order: MeshOrder,
    /// The revision of the picture (planes and materials) that the file is made from.
    revision: u64,
}

impl Maps for Pavement {
    fn map(&self, kind: MapKind) -> Result<Map, Notice> {
        let planes = self.made.planes().filter(|_| self.is_done());
        let planes = planes.ok_or(Code::NotYet)?;
        let light = self.light();
        Ok(maps::map(
            kind,
            planes,
            &light.materials,
            light.shade.shininess,
        ))
    }

    fn picture_file(
        &mut self,
        order: (usize, &[MapKind]),
        clock: Clock,
        budget: f64,
    ) -> Result<PictureSlice, Notice> {
        let mut kept = self.bigger.take();
        let domain = self.made.domain.made();
        let picture = Picture {
            side: self.side(),
            revision: self.is_done().then(|| self.made.finish.light.revision()),
            bodies: domain.map(|domain| Bodies {
                domain,
                cells: self.made.scales(),
                coats: self.made.coats(),
            }),
        };
        let params = || self.made.finish.params(order.0);
        let slice = Bigger::advance(&mut kept, &picture, (order, &params), clock, budget);
        self.bigger = kept;
        slice
    }

    fn stop_picture(&mut self) {
        self.bigger = None;
    }
}

impl Meshes for Pavement {
    #[cfg(house)]
    fn mesh_file(
        &mut self,
        order: &MeshOrder,
        clock: Clock,
        budget: f64,
    ) -> Result<MeshSlice, Notice> {
        let revision = self.made.finish.light.revision();
        let fits = |s: &Saving| s.order == *order && s.revision == revision;
        let kept = self.saving.take().filter(fits);
        if !self.is_done() {
            return Err(Code::NotYet.into());
        }
        let begun = kept.is_none();
        let mut saving = kept.unwrap_or_else(|| self.begin(order, revision));
        let done = self.add_cells(&mut saving, clock, budget);
        let mut parts = saving.file.take();
        if done {
            parts.extend(saving.file.finish());
        } else {
            self.saving = Some(saving);
        }
        Ok(MeshSlice { begun, parts, done })
    }

    /// Only the full module writes mesh files; a first visit needs none.
    #[cfg(not(house))]
    fn mesh_file(&mut self, _: &MeshOrder, _: Clock, _: f64) -> Result<MeshSlice, Notice> {
        Err(Code::NoSuchFile.into())
    }

    fn mesh_size(&self, order: &MeshOrder) -> Option<MeshSize> {
        Some(order.size(self.scales().len(), self.side()))
    }

    fn stop_mesh(&mut self) {
        #[cfg(house)]
        self.saving.take();
    }
}

#[cfg(house)]
impl Pavement {
    fn begin(&self, order: &MeshOrder, revision: u64) -> Saving {
        let (texture, materials) = (*self.texture(), &self.light().materials);
        let file = MeshFile::new(order, texture, materials, self.scales().len());
        Saving {
            solids: file.solids(),
            file,
            order: *order,
            revision,
        }
    }

    /// Adds cells for about `budget` milliseconds, and then the ground; true when the file has them
    /// all.
    fn add_cells(&self, saving: &mut Saving, clock: Clock, budget: f64) -> bool {
        let Saving { file, solids, .. } = saving;
        let stone = self.stone_params();
        let Some(planes) = self.made.planes() else {
            return true;
        };
        let done = until(clock, budget, || {
            let cell = self.scales().get(file.cells());
            if let Some(cell) = cell {
                file.add(&solids.solid(cell, &stone), cell, planes);
            }
            cell.is_none()
        });
        if done {
            file.add_ground(planes);
        }
        done
    }
}

/// A map of planes under this light.
pub(super) fn map_of(kind: MapKind, planes: &Planes, light: &LightParams) -> Map {
    maps::map(kind, planes, &light.materials, light.shade.shininess)
}
