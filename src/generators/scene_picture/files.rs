//! Files of bodies, written in slices.

use super::engine::SceneStages;
use crate::export::{MeshOrder, PartFile, SceneFile, SceneTerms};
use crate::generators::{Clock, MeshSlice, until};
use crate::notice::{Code, Notice};
use crate::scene::{Instance, Scene};
use std::rc::Rc;

/// An unfinished mesh file.
pub(crate) struct Saving<F> {
    file: F,
    order: MeshOrder,
    /// The revision of the bodies in the file.
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

impl Saving<SceneFile> {
    /// Works for about `budget` milliseconds on the file of a finished scene. `name` names the bodies by their numbers,
    /// from 0; `ground` names all else, as ground, shapes and vessels, by the row of its material.
    ///
    /// # Errors
    /// If the picture is not finished.
    pub fn of_scene(
        kept: &mut Option<Self>,
        (stages, scene): (&impl SceneStages, Option<Rc<Scene>>),
        (order, terms): (&MeshOrder, SceneTerms),
        time: (Clock, f64),
        (ground, name): (
            impl Fn(u8) -> &'static str,
            impl Fn(usize) -> Option<String>,
        ),
    ) -> Result<MeshSlice, Notice> {
        let scene = scene
            .filter(|_| stages.at().is_none())
            .ok_or(Code::NotYet)?;
        let shared = stages.shared();
        let materials = &shared.still.params().light.materials;
        let name = |instance: &Instance| {
            let number = (instance.id as usize).checked_sub(1);
            let row = instance.paint.map_or(0, |paint| paint.material);
            let body = number.and_then(&name);
            body.unwrap_or_else(|| ground(row).to_owned())
        };
        Ok(Self::slice(
            kept,
            (order, shared.bodies.revision()),
            || SceneFile::new(order, (materials, terms), &scene),
            time,
            |file| file.advance(&scene, name),
        ))
    }
}
