//! Occupancy: the pixels of each face's map, on the face itself (Legakis, Dorsey, Gortler 2001, Feature-based cellular
//! texturing for architectural models, section 3.3, figure 3).

use super::super::colours::{FEATURES, type_of};
use super::plates::Plates;
use super::{MAP, toned};
use crate::building::FaceId;
use crate::masonry::footprint::Footprint;
use crate::masonry::laying::Laying;
use crate::masonry::occupancy::{Bitmap, Claims, PixelRun};
use crate::masonry::plan::region;
use crate::scene::Scene;
use crate::surface_stones::Fit;
use glam::DVec2;

/// The colour of free pixels.
pub(super) const FREE: [u8; 3] = [250, 248, 240];
/// The most by which a cell's tone differs from the colour of its feature, as a share.
pub(super) const TONE: f64 = 0.2;
/// How far pixels lie before the face (metres).
const HEIGHT: f64 = 1e-3;
/// The margin around a run of pixels, as a share of a pixel.
const LINE: f64 = 0.1;

/// The number of free pixels, and of pixels that cells of corners, edges and faces have claimed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Claimed {
    pub free: usize,
    /// Claimed pixels, by the type of the feature: corners, edges, faces.
    pub by: [usize; 3],
}

/// Adds the pixels of a face to a scene and to the counts; the id of the body is that of the face.
pub(super) fn add(
    (scene, counts): (&mut Scene, &mut Claimed),
    laying: &Laying,
    (id, number): (FaceId, u32),
    fit: Fit,
) {
    let (pixel, runs) = runs(laying, id, laying.face_map(id).claims());
    let mut plates = Plates::new(laying.building().face(id), fit);
    for run in &runs {
        let claimed = run
            .claim
            .map(|cell| (cell, type_of(laying.cells()[cell as usize].feature)));
        let colour = match claimed {
            None => {
                counts.free += run.count();
                FREE
            }
            Some((cell, of)) => {
                counts.by[of] += run.count();
                toned(FEATURES[of], TONE, cell)
            }
        };
        let line = DVec2::splat(LINE * pixel);
        if let Some(place) = Footprint::rectangle(run.low + line, run.high - line) {
            plates.add(&place, HEIGHT, colour);
        }
    }
    plates.finish(scene, (number, MAP));
}

/// The side of a pixel (metres), and the runs of a face's pixels under some claims.
pub(super) fn runs(laying: &Laying, id: FaceId, claims: &Claims) -> (f64, Vec<PixelRun>) {
    let face = region(laying.building().face(id));
    let pixel = laying.face_map(id).bitmap().pixel();
    (pixel, Bitmap::new(&face, pixel).runs(claims))
}
