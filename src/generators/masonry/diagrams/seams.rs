//! Seams: a plain texture of bricks in running bond, which only knows each face's own s and t. Its bricks end at the
//! edges, as textures of images do (Legakis, Dorsey, Gortler 2001, Feature-based cellular texturing for architectural
//! models, figure 1).

use super::plates::{Plates, Sheet};
use super::{MAP, faces, toned};
use crate::building::Module;
use crate::masonry::footprint::Footprint;
use crate::masonry::laying::Laying;
use crate::scene::Scene;
use crate::surface_stones::Fit;
use glam::DVec2;

/// The colour of bricks, and how much their tones differ.
const BRICK: [u8; 3] = [164, 88, 66];
const TONE: f64 = 0.16;
/// How far the texture lies before the face (metres).
const HEIGHT: f64 = 1e-3;
/// Numbers of bricks in a row lie this far apart at least, so that tones of rows differ.
const ROW: u32 = 4099;

/// Adds the texture of all faces; the id of a body is that of its face.
pub(super) fn add(scene: &mut Scene, laying: &Laying, fit: Fit) {
    for (id, number) in faces(laying) {
        let face = laying.building().face(id);
        let sheet = Sheet::new(face);
        let mut plates = Plates::new(face, fit);
        for (brick, tone) in bricks(face.bounds(), laying.plan().module) {
            for part in sheet.within(&brick) {
                plates.add(&part, HEIGHT, toned(BRICK, TONE, tone));
            }
        }
        plates.finish(scene, (number, MAP));
    }
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
