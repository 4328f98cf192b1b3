//! What can be taken out of a finished studio: maps, and the mesh of all cells.

use super::Studio;
use super::height_field::LightParams;
use crate::export::{self, Map, MapKind, MeshFile, MeshFormat, maps};
use crate::heightfield::Planes;
use crate::notice::{Code, Notice};
use crate::solid::Solids;

/// Loop steps of skin in a file, beyond those of the picture: its triangles are still about a pixel
/// large, and a file is a quarter as long.
const MESH_STEPS: i32 = -1;

/// What one slice of work gave of a mesh file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshSlice {
    /// The file begins with these parts: those of calls before are of another one.
    pub begun: bool,
    /// The next parts of the file, one after the other.
    pub parts: Vec<Vec<u8>>,
    /// The file ends with them.
    pub done: bool,
}

/// A mesh file in the making.
pub(super) struct Saving {
    file: MeshFile,
    solids: Solids,
    format: MeshFormat,
    /// Which of the planes it is made of.
    revision: u64,
}

impl Studio {
    /// A map of the finished picture's planes.
    ///
    /// # Errors
    /// A notice where the picture is not finished.
    pub fn map(&self, kind: MapKind) -> Result<Map, Notice> {
        let planes = self.made.planes().filter(|_| self.done());
        let planes = planes.ok_or(Code::NotYet)?;
        Ok(map_of(kind, planes, &self.working.params.finish.light))
    }

    /// The cells last finished as a standalone SVG file of the picture's size; '' before there are any.
    pub fn svg(&self) -> String {
        let made = &self.made;
        match made.terrain.domain.made() {
            Some(domain) if !made.cells().is_empty() => export::svg(
                self.side(),
                domain,
                &self.rings(),
                made.cells(),
                &self.tones(),
            ),
            _ => String::new(),
        }
    }

    /// Works for about `budget` milliseconds by `clock` on the file of all cells' surfaces. Begins
    /// anew where the pavement or the format is another one than the last time.
    ///
    /// # Errors
    /// A notice where the picture is not finished.
    pub fn mesh_file(
        &mut self,
        format: MeshFormat,
        clock: &mut dyn FnMut() -> f64,
        budget: f64,
    ) -> Result<MeshSlice, Notice> {
        let revision = self.made.finish.weather.revision();
        let fits = |s: &Saving| (s.format, s.revision) == (format, revision);
        let kept = self.saving.take().filter(fits);
        if !self.done() {
            return Err(Code::NotYet.into());
        }
        let begun = kept.is_none();
        let asked = &self.working.params.finish;
        let mut saving = kept.unwrap_or_else(|| Saving {
            file: MeshFile::new(format, asked.planes.texture, &asked.light.materials),
            solids: Solids::for_picture(1, MESH_STEPS),
            format,
            revision,
        });
        let done = self.add_cells(&mut saving.file, &mut saving.solids, clock, budget);
        let mut parts = saving.file.take();
        if done {
            parts.extend(saving.file.finish());
        } else {
            self.saving = Some(saving);
        }
        Ok(MeshSlice { begun, parts, done })
    }

    /// Adds cells for about `budget` milliseconds; true when all are in.
    fn add_cells(
        &self,
        file: &mut MeshFile,
        solids: &mut Solids,
        clock: &mut dyn FnMut() -> f64,
        budget: f64,
    ) -> bool {
        let stone = self.stone_params();
        let Some(planes) = self.made.planes() else {
            return true;
        };
        let begin = clock();
        while let Some(cell) = self.scales().get(file.cells()) {
            file.add(&solids.solid(cell, &stone), cell, planes);
            // Not `>=`: a clock that fails must not make this endless.
            let inside = clock() - begin < budget;
            if !inside {
                return false;
            }
        }
        true
    }
}

/// A map of planes under this light.
pub(super) fn map_of(kind: MapKind, planes: &Planes, light: &LightParams) -> Map {
    maps::map(kind, planes, &light.materials, light.shade.shininess)
}
