//! Occupancy: the pixels of each face's map, on the face itself (Legakis, Dorsey, Gortler 2001, Feature-based cellular
//! texturing for architectural models, section 3.3, figure 3).

use super::super::colours::{FEATURES, type_of};
use super::plates::Plates;
use super::{MAP, faces, toned};
use crate::building::FaceId;
use crate::masonry::footprint::Footprint;
use crate::masonry::laying::Laying;
use crate::masonry::occupancy::{Bitmap, PixelRun};
use crate::masonry::plan::region;
use crate::scene::Scene;
use crate::surface_stones::Fit;
use glam::DVec2;
use std::collections::BTreeMap;

/// The colour of free pixels.
const FREE: [u8; 3] = [250, 248, 240];
/// How much tones of cells differ.
const TONE: f64 = 0.2;
/// How far pixels lie before the face (metres).
const HEIGHT: f64 = 1e-3;
/// The part of a pixel that is left free around a run of them.
const LINE: f64 = 0.1;

/// How many pixels are free, and how many cells of corners, edges and faces have claimed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::generators::masonry) struct Claimed {
    pub free: usize,
    /// By the type of the feature: corners, edges, faces.
    pub by: [usize; 3],
}

impl Claimed {
    /// The pixels of all faces.
    pub fn new(laying: &Laying) -> Self {
        let mut counts = Self::default();
        for run in faces(laying).flat_map(|(face, _)| runs(laying, face).1) {
            match run.claim {
                None => counts.free += run.count(),
                Some(cell) => {
                    let feature = laying.cells()[cell as usize].feature;
                    counts.by[type_of(feature)] += run.count();
                }
            }
        }
        counts
    }
}

/// Adds the pixels of all faces. A body has the pixels that one cell has claimed on a face, and the cell's id; free
/// pixels have the id 0.
pub(super) fn add(scene: &mut Scene, laying: &Laying, fit: Fit) {
    for (id, _) in faces(laying) {
        let (pixel, runs) = runs(laying, id);
        let mut bodies: BTreeMap<Option<u32>, Plates> = BTreeMap::new();
        for run in &runs {
            let colour = run.claim.map_or(FREE, |cell| {
                let feature = laying.cells()[cell as usize].feature;
                toned(FEATURES[type_of(feature)], TONE, cell)
            });
            let new = || Plates::new(laying.building().face(id), fit);
            let plates = bodies.entry(run.claim).or_insert_with(new);
            let line = DVec2::splat(LINE * pixel);
            if let Some(place) = Footprint::rectangle(run.low + line, run.high - line) {
                plates.add(&place, HEIGHT, colour);
            }
        }
        for (claim, plates) in bodies {
            plates.finish(scene, (claim.map_or(0, |cell| cell + 1), MAP));
        }
    }
}

/// The runs of pixels of a face, and the side of a pixel (metres).
fn runs(laying: &Laying, id: FaceId) -> (f64, Vec<PixelRun>) {
    let map = laying.face_map(id);
    let face = region(laying.building().face(id));
    let pixel = map.bitmap().pixel();
    (pixel, Bitmap::new(&face, pixel).runs(map.claims()))
}
