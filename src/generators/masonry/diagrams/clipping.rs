//! Clipping: the parts that were cut off cells, and the features in their way (Legakis, Dorsey, Gortler 2001,
//! Feature-based cellular texturing for architectural models, section 5.1).

use super::super::colours::{FEATURES, type_of};
use super::MAP;
use super::kinds::{add_coloured, colour_of};
use super::plates::Plates;
use crate::building::FaceId;
use crate::masonry::footprint::Footprint;
use crate::masonry::free_space::remainder;
use crate::masonry::laying::{Feature, Laying, MasonryCell};
use crate::scene::Scene;
use crate::surface_stones::Fit;
use std::ops::Range;

/// The colour of cells that are whole, and of parts that lie off the face.
const WHOLE: [u8; 3] = [206, 200, 190];
const OUTSIDE: [u8; 3] = [150, 110, 190];
/// How far the parts lie before the face (metres).
const HEIGHT: f64 = 4e-3;
/// Parts smaller than this share of the whole cell's area do not count.
const LEAST: f64 = 0.02;

/// A part that was cut off a cell.
pub(in crate::generators::masonry) struct Clipped {
    /// The face, and the part in its (s, t).
    pub face: FaceId,
    pub part: Footprint,
    /// The number of the cell that claims the part; `None` if the part lies off the face.
    pub by: Option<u32>,
}

impl Clipped {
    /// The colour of the feature in whose way the part was.
    pub fn colour(&self, laying: &Laying) -> [u8; 3] {
        self.by.map_or(OUTSIDE, |by| {
            FEATURES[type_of(laying.cells()[by as usize].feature)]
        })
    }
}

/// The parts that were cut off a cell of a face. `number` is the cell's place in the order of laying.
pub(in crate::generators::masonry) fn clipped(
    laying: &Laying,
    (number, cell): (u32, &MasonryCell),
) -> Vec<Clipped> {
    let (Feature::Face(face), Some(whole)) = (cell.feature, &cell.unclipped) else {
        return Vec::new();
    };
    let own = cell.claims.iter().filter(|(on, _)| *on == face);
    let own: Vec<Footprint> = own.map(|(_, claim)| claim.clone()).collect();
    let claims = laying.face_map(face).claims();
    let near = claims.near(whole.bounds()).into_iter();
    let earlier: Vec<_> = near
        .map(|k| &claims.list()[k as usize])
        .filter(|claim| claim.cell < number)
        .collect();
    let is_large = |part: &Footprint| part.area() > LEAST * whole.area();
    let cut = remainder(whole, &own);
    let taken = cut.iter().flat_map(|part| {
        let shared = earlier
            .iter()
            .map(|claim| (part.intersection(&claim.polygon), Some(claim.cell)));
        shared.filter_map(|(part, by)| Some((part?, by)))
    });
    let polygons: Vec<Footprint> = earlier.iter().map(|claim| claim.polygon.clone()).collect();
    let off = cut
        .iter()
        .flat_map(|part| remainder(part, &polygons))
        .map(|part| (part, None));
    taken
        .chain(off)
        .filter(|(part, _)| is_large(part))
        .map(|(part, by)| Clipped { face, part, by })
        .collect()
}

/// Adds the cells of a range: clipped ones in the colours of their sorts, others pale. The parts that were cut off lie
/// over them in the colour of the feature that is in the way. Ids are the numbers of cells, from 1.
pub(super) fn add(scene: &mut Scene, laying: &Laying, fit: Fit, cells: Range<usize>) {
    add_coloured(scene, laying, (fit, cells.clone()), |cell| {
        match cell.unclipped {
            Some(_) => colour_of(cell.sort),
            None => WHOLE,
        }
    });
    let first = cells.start as u32;
    for (number, cell) in (first..).zip(&laying.cells()[cells]) {
        for cut in clipped(laying, (number, cell)) {
            let mut plates = Plates::new(laying.building().face(cut.face), fit);
            plates.add(&cut.part, HEIGHT, cut.colour(laying));
            plates.finish(scene, (number + 1, MAP));
        }
    }
}
