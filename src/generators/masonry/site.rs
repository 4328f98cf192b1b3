//! The first stage: the building, and how thick its walls are.

use super::params::BuildingParams;
use super::{plan_sentences, sentences};
use crate::building::{Building, BuildingFault, Draft, Face, Rule, Stance, json, obj};
use crate::domain::signed_area;
use crate::masonry::plan::thicknesses;
use crate::notice::{Code, Notice};
use crate::surface_stones::Fit;
use glam::DVec3;
use std::sync::Arc;

/// The first bytes of a text in JSON, after blanks.
const JSON: u8 = b'{';
/// The most blocks of a building.
pub(super) const MOST_BLOCKS: f64 = 60_000.0;

/// A building that can be laid.
pub(super) struct BuildingSite {
    pub building: Arc<Building>,
    /// The building as a file would have it: native programs write it.
    #[cfg(not(target_arch = "wasm32"))]
    pub draft: Draft,
    /// Whether a file or a visitor's plan gave it.
    pub is_given: bool,
    /// The sentences about faults of the plan.
    pub remarks: Vec<Notice>,
    /// The least thickness of the wall behind each face (metres).
    pub thickness: Vec<f64>,
    /// How it lies in the scene.
    pub fit: Fit,
}

impl BuildingSite {
    /// Makes the building by rule, or that of a file.
    ///
    /// # Errors
    /// If the file has no building, or if there would be too many blocks.
    pub fn new(params: &BuildingParams, file: Option<&[u8]>) -> Result<Self, Notice> {
        let mut remarks = Vec::new();
        let draft = match (&params.rule, file) {
            (Some((Rule::Plan, numbers)), _) => {
                let (draft, faults) = params.plan.draft(&params.module, numbers);
                remarks = plan_sentences::remarks(&faults);
                draft
            }
            (Some((rule, numbers)), _) => rule.draft(&params.module, numbers),
            (None, Some(bytes)) => given(bytes).map_err(|fault| sentences::unread(&fault))?,
            (None, None) => return Err(Code::ModelFirst.into()),
        };
        let draft = draft.sorted();
        let building = Building::new(&draft).map_err(|fault| sentences::unread(&fault))?;
        let thickness = thicknesses(&building).map_err(|_| Notice::new(Code::ModelNoArea))?;
        check_number(&building, params)?;
        Ok(Self {
            fit: fit(&building),
            building: Arc::new(building),
            thickness,
            #[cfg(not(target_arch = "wasm32"))]
            draft,
            is_given: !matches!(params.rule, Some((rule, _)) if rule != Rule::Plan),
            remarks,
        })
    }
}

/// The building of a file. It is tested before its faces are sorted, so that faults name them as the file does.
fn given(bytes: &[u8]) -> Result<Draft, BuildingFault> {
    let draft = read(bytes)?;
    Building::new(&draft).map(|_| draft)
}

fn read(bytes: &[u8]) -> Result<Draft, BuildingFault> {
    let first = bytes.iter().find(|byte| !byte.is_ascii_whitespace());
    match first {
        Some(&JSON) => json::read(&String::from_utf8_lossy(bytes)),
        _ => obj::read(bytes).map(|recognised| recognised.draft),
    }
}

/// Refuses a module that is so small that there would be too many blocks.
fn check_number(building: &Building, params: &BuildingParams) -> Result<(), Notice> {
    let module = params.module;
    let blocks = building.faces().iter().map(|face| {
        let height = match face.stance() {
            Stance::Level => module.half,
            Stance::Upright | Stance::Through => module.course,
        };
        area(face) / (2.0 * module.half * height)
    });
    let blocks: f64 = blocks.sum();
    if blocks <= MOST_BLOCKS {
        return Ok(());
    }
    let scale = (blocks / MOST_BLOCKS).sqrt();
    let fits = |length: f64| (1e3 * length * scale).ceil() as usize;
    Err(Notice::new(Code::MasonryMany)
        .with("n", blocks as usize)
        .with("most", MOST_BLOCKS as usize)
        .with("fits", fits(module.half))
        .with("course", fits(module.course)))
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
