//! Files of bodies, written in slices.

use crate::export::{MeshOrder, PartFile};
use crate::generators::{Clock, MeshSlice, until};

/// An unfinished mesh file.
pub(crate) struct Saving<F> {
    file: F,
    order: MeshOrder,
    /// The revision of its bodies.
    revision: u64,
}

impl<F: PartFile> Saving<F> {
    /// Works for about `budget` milliseconds on the file of an order. `advance` adds a part, and is true after the
    /// last one. If the order or the revision of the bodies has changed, `new` starts a new file.
    pub fn slice(
        kept: &mut Option<Self>,
        (order, revision): (&MeshOrder, u64),
        new: impl FnOnce() -> F,
        (clock, budget): (Clock, f64),
        mut advance: impl FnMut(&mut F) -> bool,
    ) -> MeshSlice {
        let fits = |saving: &Self| saving.order == *order && saving.revision == revision;
        let going_on = kept.take().filter(fits);
        let begun = going_on.is_none();
        let mut saving = going_on.unwrap_or_else(|| Self {
            file: new(),
            order: *order,
            revision,
        });
        let done = until(clock, budget, || advance(&mut saving.file));
        let mut parts = saving.file.take();
        if done {
            parts.extend(saving.file.finish());
        } else {
            *kept = Some(saving);
        }
        MeshSlice { begun, parts, done }
    }
}
