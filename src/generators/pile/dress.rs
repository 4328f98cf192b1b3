//! The bodies' meshes for pictures: each variant in the colours of its type.

use super::components::Components;
use super::materials::row;
use super::params::DressParams;
use crate::component::{Component, Level};
use crate::notice::Notice;
use crate::scene::Body;
use crate::solid::Surface;
use std::rc::Rc;

/// The most triangles of a level that is drawn. Bodies of a pile are small in the picture.
const MOST: usize = 6_000;

/// The meshes of all types, variant by variant.
pub(super) struct Dressed {
    pub bodies: Vec<Body>,
    /// The number of the first body of each type; the last entry is the number of all bodies.
    pub first: Vec<u32>,
}

/// Meshes in progress.
#[derive(Default)]
pub(super) struct Dressing {
    dressed: Dressed,
    /// The number of the type, and of its variant.
    at: (usize, usize),
    levels: Vec<Surface>,
}

impl Default for Dressed {
    fn default() -> Self {
        Self {
            bodies: Vec::new(),
            first: vec![0],
        }
    }
}

impl Dressing {
    /// Does one slice: one level of one variant.
    pub fn advance(
        params: &DressParams,
        work: &mut Option<Dressing>,
        components: &Components,
    ) -> Result<Option<Rc<Dressed>>, Notice> {
        let dressing = work.get_or_insert_default();
        let (kind, variant) = dressing.at;
        let Some(variants) = components.get(kind) else {
            return Ok(work.take().map(|dressing| Rc::new(dressing.dressed)));
        };
        let component = &variants.all[variant];
        let finish = params.finishes[kind];
        let mut levels = drawn(component).skip(dressing.levels.len());
        if let Some(level) = levels.next() {
            let surface = level.surface(component.crease, |mark| {
                finish.variant_colour(mark, variant as u64)
            });
            dressing.levels.push(surface);
            return Ok(None);
        }
        let levels = std::mem::take(&mut dressing.levels);
        let bodies = &mut dressing.dressed.bodies;
        bodies.push(Body::new(levels, row(kind, false, false)));
        dressing.at = match variant + 1 < variants.all.len() {
            true => (kind, variant + 1),
            false => {
                dressing.dressed.first.push(bodies.len() as u32);
                (kind + 1, 0)
            }
        };
        Ok(None)
    }
}

/// The levels of a component that are drawn: those with few enough triangles, and always the last
/// one.
fn drawn(component: &Component) -> impl Iterator<Item = &Level> {
    let last = component.levels.len() - 1;
    let levels = component.levels.iter().enumerate();
    let fits =
        move |(k, level): &(usize, &Level)| *k == last || level.mesh.triangles().len() <= MOST;
    levels.filter(fits).map(|(_, level)| level)
}
