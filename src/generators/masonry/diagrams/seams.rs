//! Seams: a plain texture of bricks in running bond, laid in each face's own (s, t). Edges cut its bricks, as they cut
//! the texture of an image. For comparison, the cells stand beside it (Legakis, Dorsey, Gortler 2001, Feature-based
//! cellular texturing for architectural models, figure 1).

use super::super::blocks::plain;
use super::super::parts::add_plain;
use super::plates::{Plates, Sheet};
use super::{MAP, SATIN, faces, id_of, toned};
use crate::building::{FaceId, Module};
use crate::masonry::footprint::Footprint;
use crate::masonry::laying::Laying;
use crate::order::lesser;
use crate::scene::Scene;
use crate::surface_stones::Fit;
use glam::{DVec2, Vec2, Vec3, Vec3Swizzles};
use std::ops::Range;

/// The colour of bricks, and how much their tones differ.
const BRICK: [u8; 3] = [164, 88, 66];
const TONE: f64 = 0.16;
/// The colour of bricks that end at the border of their face.
const BROKEN: [u8; 3] = [224, 178, 84];
/// Bricks with a larger share on the face are whole.
const WHOLE: f64 = 0.97;
/// How far the texture lies before the face (metres).
const HEIGHT: f64 = 1e-3;
/// The greatest width of the building and its copy together, in units of the scene.
const WIDE: f32 = 1.2;
/// The gap between the building and its copy: shares of the building's width and of its depth, added up.
const GAP: Vec2 = Vec2::new(0.08, 0.25);
/// The numbers of bricks grow by this from row to row, so that bricks of different rows have different tones.
const ROW: u32 = 4099;

/// The number of bricks in the texture, and of those that end at the border of a face before they are whole.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::generators::masonry) struct Texture {
    pub bricks: usize,
    pub broken: usize,
}

impl Texture {
    /// Counts the bricks of all faces.
    pub fn new(laying: &Laying) -> Self {
        let mut counts = Self::default();
        for (id, _) in faces(laying) {
            for brick in texture(laying, id) {
                counts.bricks += 1;
                counts.broken += usize::from(brick.is_broken);
            }
        }
        counts
    }
}

/// A brick of the texture on a face.
struct TextureBrick {
    parts: Vec<Footprint>,
    /// Whether the edge of the face cuts it.
    is_broken: bool,
    /// The number that selects the brick's tone.
    number: u32,
}

/// Adds the texture of all faces; the id of a body is that of its face.
pub(super) fn add(scene: &mut Scene, laying: &Laying, fit: Fit) {
    for (id, number) in faces(laying) {
        let mut plates = Plates::new(laying.building().face(id), fit);
        for brick in texture(laying, id) {
            let base = if brick.is_broken { BROKEN } else { BRICK };
            let colour = toned(base, TONE, brick.number);
            for part in &brick.parts {
                plates.add(part, HEIGHT, colour);
            }
        }
        plates.finish(scene, (number, MAP));
    }
}

/// Adds the cells of a range in the colour of bricks; the id of a body is that of its feature.
pub(super) fn add_cells(scene: &mut Scene, laying: &Laying, (fit, cells): (Fit, Range<usize>)) {
    let first = cells.start as u32;
    for (number, cell) in (first..).zip(&laying.cells()[cells]) {
        if let Some(body) = cell.body.shrunk() {
            let colour = toned(BRICK, TONE, number);
            let id = id_of(laying, cell.feature);
            add_plain(scene, plain(&body, |p| fit.place(p)), (id, colour, SATIN));
        }
    }
}

/// Moves the instances from the index `first` on to the right, and those before it to the left. Both become smaller, so
/// that they fit side by side.
pub(super) fn set_apart(scene: &mut Scene, laying: &Laying, first: usize, fit: Fit) {
    let places = laying.building().vertices().iter();
    let start = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    let (low, high) = places.fold(start, |(low, high), vertex| {
        let p = fit.place(vertex.position);
        (low.min(p), high.max(p))
    });
    let sides = (high - low).xz();
    let apart = sides.x + GAP.dot(sides);
    let scale = lesser(1.0, WIDE / (apart + sides.x));
    let shift = 0.5 * apart * scale;
    for (number, instance) in scene.instances.iter_mut().enumerate() {
        let place = &mut instance.place;
        place.axes = place.axes.map(|axis| axis * scale);
        place.origin *= scale;
        place.origin.x += if number < first { -shift } else { shift };
    }
    scene.reach *= scale;
}

/// The bricks of the texture on a face.
fn texture(laying: &Laying, id: FaceId) -> Vec<TextureBrick> {
    let face = laying.building().face(id);
    let sheet = Sheet::new(face);
    let bricks = bricks(face.bounds(), laying.plan().module).into_iter();
    let found = bricks.map(|(brick, number)| {
        let parts = sheet.within(&brick);
        let area: f64 = parts.iter().map(Footprint::area).sum();
        TextureBrick {
            parts,
            is_broken: area < WHOLE * brick.area(),
            number,
        }
    });
    found.filter(|brick| !brick.parts.is_empty()).collect()
}

/// The bricks of the texture that meet a box, each with a number. Bricks begin at s = 0 in even rows, and half a brick
/// later in odd ones.
fn bricks([low, high]: [DVec2; 2], module: Module) -> Vec<(Footprint, u32)> {
    let size = DVec2::new(2.0 * module.half, module.course);
    let joint = DVec2::splat(0.5 * module.joint);
    let (first, last) = ((low / size).floor(), (high / size).ceil());
    let rows = 0..=(last.y - first.y) as u32;
    let found = rows.flat_map(|row| {
        let t = first.y + f64::from(row);
        let shift = 0.5 * t.rem_euclid(2.0);
        let columns = 0..=(last.x - first.x) as u32 + 1;
        columns.filter_map(move |column| {
            let s = first.x - 1.0 + f64::from(column) + shift;
            let corner = DVec2::new(s, t) * size;
            let brick = Footprint::rectangle(corner + joint, corner + size - joint)?;
            Some((brick, ROW * row + column))
        })
    });
    found.collect()
}
