//! What can be taken out of a finished studio: maps, and the mesh of all cells.

use super::{Studio, translate};
use crate::export::{self, Map, MapKind, MeshFile, MeshFormat, maps};
use crate::recipe::Stage;
use crate::solid::Quarry;

/// Said where the picture is still in the making.
const NOT_YET: &str =
    "Maps and meshes are made of the finished picture: save them when it is done.";

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
    quarry: Quarry,
    format: MeshFormat,
    /// State of the work that it is made of.
    stamp: u64,
}

impl Studio {
    /// A map of the finished picture's planes.
    ///
    /// # Errors
    /// A sentence where the picture is not finished.
    pub fn map(&self, kind: MapKind) -> Result<Map, String> {
        let planes = self.made.planes.as_ref().filter(|_| self.done());
        let planes = planes.ok_or(NOT_YET)?;
        let optics = translate::optics(&self.working);
        let shininess = translate::shading(&self.working).shininess;
        Ok(maps::map(kind, planes, &optics, shininess))
    }

    /// The cells last finished as a standalone SVG file of the picture's size; '' before there are any.
    pub fn svg(&self) -> String {
        let made = &self.made;
        match &made.domain {
            Some(domain) if !made.cells.is_empty() => export::svg(
                self.side(),
                domain,
                &self.rings(),
                &made.cells,
                &self.tones(),
            ),
            _ => String::new(),
        }
    }

    /// Works for about `budget` milliseconds by `clock` on the file of all cells' surfaces. Begins
    /// anew where the pavement or the format is another one than the last time.
    ///
    /// # Errors
    /// A sentence where the picture is not finished.
    pub fn mesh_file(
        &mut self,
        format: MeshFormat,
        clock: &mut dyn FnMut() -> f64,
        budget: f64,
    ) -> Result<MeshSlice, String> {
        let stamp = self.changes[..=Stage::Planes as usize].iter().sum();
        let fits = |s: &Saving| (s.format, s.stamp) == (format, stamp);
        let kept = self.saving.take().filter(fits);
        if !self.done() {
            return Err(NOT_YET.to_owned());
        }
        let begun = kept.is_none();
        let params = translate::texture(&self.working);
        let mut saving = kept.unwrap_or_else(|| Saving {
            file: MeshFile::new(format, params, &translate::optics(&self.working)),
            quarry: Quarry::finer(MESH_STEPS),
            format,
            stamp,
        });
        let done = self.add_cells(&mut saving.file, &mut saving.quarry, clock, budget);
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
        quarry: &mut Quarry,
        clock: &mut dyn FnMut() -> f64,
        budget: f64,
    ) -> bool {
        let stone = translate::texture(&self.working).stone;
        let Some(planes) = &self.made.planes else {
            return true;
        };
        let begin = clock();
        while let Some(cell) = self.scales().get(file.cells()) {
            file.add(&quarry.stone(cell, &stone), cell, planes);
            // Not `>=`: a clock that fails must not make this endless.
            let inside = clock() - begin < budget;
            if !inside {
                return false;
            }
        }
        true
    }
}
