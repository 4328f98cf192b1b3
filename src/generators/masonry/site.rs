//! The first stage: the building, and how thick its walls are.

use super::params::BuildingParams;
use crate::building::{Building, BuildingFault, Draft, Face, json, obj};
use crate::domain::signed_area;
use crate::masonry::plan::thicknesses;
use crate::notice::{Code, Notice};
use crate::surface_stones::Fit;
use glam::DVec3;
use std::f64::consts::PI;
use std::sync::Arc;

/// The first bytes of a text in JSON, after blanks.
const JSON: u8 = b'{';
/// The most blocks of a building.
pub(super) const MOST_BLOCKS: f64 = 60_000.0;

/// A building that can be laid.
pub(super) struct BuildingSite {
    pub building: Arc<Building>,
    /// The least thickness of the wall behind each face (metres).
    pub thickness: Vec<f64>,
    /// How it lies in the scene.
    pub fit: Fit,
    /// How far round walls bulge between the ends of a flat brick (metres).
    pub bulge: f64,
}

impl BuildingSite {
    /// Makes the building by rule, or that of a file.
    ///
    /// # Errors
    /// If the file has no building, or if there would be too many blocks.
    pub fn new(params: &BuildingParams, file: Option<&[u8]>) -> Result<Self, Notice> {
        let draft = match (&params.rule, file) {
            (Some((rule, numbers)), _) => rule.draft(&params.module, numbers),
            (None, Some(bytes)) => read(bytes).map_err(|fault| unread(&fault))?,
            (None, None) => return Err(Code::ModelFirst.into()),
        };
        let building = Building::new(&draft).map_err(|fault| unread(&fault))?;
        let thickness = thicknesses(&building).map_err(|_| Notice::new(Code::BuildingShape))?;
        check_number(&building, params)?;
        Ok(Self {
            fit: fit(&building),
            bulge: bulge(&building, 2.0 * params.module.half),
            building: Arc::new(building),
            thickness,
        })
    }
}

fn read(bytes: &[u8]) -> Result<Draft, BuildingFault> {
    let first = bytes.iter().find(|byte| !byte.is_ascii_whitespace());
    match first {
        Some(&JSON) => json::read(&String::from_utf8_lossy(bytes)),
        _ => obj::read(bytes).map(|recognised| recognised.draft),
    }
}

/// Why a building's file or its shape is refused.
fn unread(fault: &BuildingFault) -> Notice {
    use BuildingFault::{Field, NotJson, NotObj, Number, Unit, Version};
    match fault {
        NotJson { .. }
        | NotObj(..)
        | Version { .. }
        | Unit { .. }
        | Field { .. }
        | Number { .. } => Notice::new(Code::BuildingText),
        _ => Notice::new(Code::BuildingShape),
    }
}

/// Refuses a module that is so small that there would be too many blocks.
fn check_number(building: &Building, params: &BuildingParams) -> Result<(), Notice> {
    let area: f64 = building.faces().iter().map(area).sum();
    let module = params.module;
    let blocks = area / (2.0 * module.half * module.course);
    if blocks <= MOST_BLOCKS {
        return Ok(());
    }
    let fits = 1e3 * module.half * (blocks / MOST_BLOCKS).sqrt();
    Err(Notice::new(Code::MasonryMany)
        .with("n", blocks as usize)
        .with("most", MOST_BLOCKS as usize)
        .with("fits", fits.ceil() as usize))
}

/// The greatest distance between whole cylinders and their chords of this length.
fn bulge(building: &Building, chord: f64) -> f64 {
    let periods = building
        .faces()
        .iter()
        .filter_map(|face| face.surface.period());
    let bulges = periods.map(|period| 0.25 * PI * chord * chord / period);
    bulges.fold(0.0, f64::max)
}

/// The area of a face (square metres), flattened.
fn area(face: &Face) -> f64 {
    face.rings.iter().map(|ring| signed_area(ring)).sum()
}

/// The building in the scene: its longest side is 1.
fn fit(building: &Building) -> Fit {
    let extras = building.extras().iter().flat_map(|extra| &extra.positions);
    let all = building
        .vertices()
        .iter()
        .map(|v| &v.position)
        .chain(extras);
    let start = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let (low, high) = all.fold(start, |(lo, hi), &p| (lo.min(p), hi.max(p)));
    Fit::of_box(low, high)
}
