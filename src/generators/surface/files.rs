//! What can be taken out of a finished surface.

use super::Surface;
use super::stages::stones_params;
use crate::export::{MeshOrder, ModelFile};
use crate::generators::{Clock, Engine, MeshSlice, until};
use crate::notice::{Code, Notice};

/// A mesh file in the making.
pub(super) struct Saving {
    file: ModelFile,
    order: MeshOrder,
    /// Of which stones it is.
    revision: u64,
}

impl Surface {
    pub(super) fn mesh_slice(
        &mut self,
        order: &MeshOrder,
        clock: Clock,
        budget: f64,
    ) -> Result<MeshSlice, Notice> {
        let done = self.at().is_none();
        let (Some((_, revision)), Some(built), Some(paved)) = (
            self.made.scene().filter(|_| done),
            self.made.built(),
            self.made.paved(),
        ) else {
            return Err(Code::NotYet.into());
        };
        let fits = |s: &Saving| s.order == *order && s.revision == revision;
        let kept = self.saving.take().filter(fits);
        let begun = kept.is_none();
        let params = &self.working.params;
        let mut saving = kept.unwrap_or_else(|| Saving {
            file: ModelFile::new(
                order,
                stones_params(&params.stones, &paved.cells),
                &params.light.materials,
                &paved.cells,
            ),
            order: *order,
            revision,
        });
        let done = until(clock, budget, || {
            saving.file.advance(&built.whole, paved.paving())
        });
        let mut parts = saving.file.take();
        if done {
            parts.extend(saving.file.finish());
        } else {
            self.saving = Some(saving);
        }
        Ok(MeshSlice { begun, parts, done })
    }
}
