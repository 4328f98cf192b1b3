//! The first stage: the building, and how thick its walls are.

use super::disc::Disc;
use super::params::BuildingParams;
use super::units::other_unit;
use super::{MASONRY, keys, plan_sentences, sentences};
use crate::building::obj::FileSpace;
use crate::building::{
    Building, BuildingFault, BuildingMaking, Draft, Face, Rule, Stance, json, obj,
};
use crate::domain::signed_area;
use crate::masonry::plan::ThicknessWork;
use crate::notice::{Code, Notice};
use crate::recipe::Key;
use crate::surface_stones::{Fit, Rim};
use glam::DVec3;
use serde_json::Value;
use std::sync::Arc;

/// The first byte of a JSON text, after blanks.
const JSON: u8 = b'{';
/// The most blocks of a building.
pub(super) const MOST_BLOCKS: f64 = 60_000.0;
/// A wall of two half bricks may be this much thinner (metres), for rounded numbers.
const NARROWER: f64 = 1e-6;
/// The parts of the half picture that the building and the rim of its ground may take.
const SHARE: f64 = 0.82;
const RIM_SHARE: f64 = 0.94;

/// A building that can be laid.
pub(super) struct BuildingSite {
    pub building: Arc<Building>,
    /// The draft of the building, for files.
    pub draft: Draft,
    /// Whether a file or a visitor's plan gave it.
    pub is_given: bool,
    /// The sentences about faults of the plan.
    pub remarks: Vec<Notice>,
    /// The least thickness of the wall behind each face (metres).
    pub thickness: Vec<f64>,
    /// Maps the building (metres) to the scene.
    pub fit: Fit,
}

/// A site in the making.
pub(crate) struct SiteBuild {
    step: SiteStep,
    /// The unit and the upright axis of an OBJ file; `None` for other buildings.
    space: Option<FileSpace>,
    remarks: Vec<Notice>,
}

/// The progress of the work on a site.
enum SiteStep {
    /// A file in JSON has been parsed.
    Parsed(Value),
    /// A draft has been read.
    Read(Draft),
    /// The parent and the child mesh are being made of this draft, whose faces are sorted.
    Meshes {
        draft: Draft,
        /// The draft with its faces in the order of the file; `None` for a building by rule.
        given: Option<Draft>,
        making: BuildingMaking,
    },
    /// The sorted draft has this fault. Sentences number faces as the file does, so the draft of the file is searched
    /// for its fault.
    Fault {
        draft: Draft,
        fault: BuildingFault,
        making: BuildingMaking,
    },
    /// The thickness of walls is being measured.
    Walls {
        building: Arc<Building>,
        draft: Draft,
        work: ThicknessWork,
    },
}

impl SiteBuild {
    /// Begins with a building by rule, or that of a file.
    ///
    /// # Errors
    /// If there is no file, or if it cannot be read.
    pub(super) fn new(params: &BuildingParams, file: Option<&[u8]>) -> Result<Self, Notice> {
        let (mut remarks, mut space) = (Vec::new(), None);
        let step = match (&params.rule, file) {
            (Some((Rule::Plan, numbers)), _) => {
                let (draft, faults) = params.plan.draft(&params.module, numbers);
                remarks = plan_sentences::remarks(&faults);
                SiteStep::meshes(draft, None, params)
            }
            (Some((rule, numbers)), _) => {
                SiteStep::meshes(rule.draft(&params.module, numbers), None, params)
            }
            (None, Some(bytes)) => {
                let step = SiteStep::read(bytes, &params.space, &mut remarks);
                let step = step.map_err(|fault| unreadable(&fault, &params.space))?;
                space = matches!(step, SiteStep::Read(_)).then_some(params.space);
                step
            }
            (None, None) => return Err(Code::ModelFirst.into()),
        };
        Ok(Self {
            step,
            space,
            remarks,
        })
    }

    /// Does a slice of the work; returns the site at the end.
    ///
    /// # Errors
    /// If the file has no building, or if there would be too many blocks.
    pub(super) fn advance(
        params: &BuildingParams,
        work: &mut Option<Self>,
        file: Option<&[u8]>,
    ) -> Result<Option<BuildingSite>, Notice> {
        let Some(Self {
            step,
            space,
            remarks,
        }) = work.take()
        else {
            *work = Some(Self::new(params, file)?);
            return Ok(None);
        };
        let step = match step {
            SiteStep::Walls {
                building,
                draft,
                work: mut walls,
            } => match walls.advance() {
                Some(thickness) => {
                    let made = (draft, thickness, remarks);
                    return Ok(Some(BuildingSite::new(building, made, params)));
                }
                None => SiteStep::Walls {
                    building,
                    draft,
                    work: walls,
                },
            },
            meshes => meshes.make(params, space.as_ref())?,
        };
        *work = Some(Self {
            step,
            space,
            remarks,
        });
        Ok(None)
    }
}

impl SiteStep {
    /// Reads an OBJ file, or parses a JSON file. Some programs put a byte order mark first.
    fn read(
        bytes: &[u8],
        space: &FileSpace,
        remarks: &mut Vec<Notice>,
    ) -> Result<Self, BuildingFault> {
        let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
        let first = bytes.iter().find(|byte| !byte.is_ascii_whitespace());
        match first {
            Some(&JSON) => json::parse(&String::from_utf8_lossy(bytes)).map(Self::Parsed),
            _ => {
                let recognised = obj::read(bytes, space)?;
                remarks.extend(recognised.moved.map(sentences::moved));
                Ok(Self::Read(recognised.draft))
            }
        }
    }

    /// Begins with the meshes of a draft, in which walls of single polygons are solids if their ends have room for two
    /// half bricks. A draft with a fault stays as it is, and its meshes tell the fault.
    fn meshes(draft: Draft, given: Option<Draft>, params: &BuildingParams) -> Self {
        let least = 2.0 * params.module.half - params.module.joint - NARROWER;
        Self::Meshes {
            draft: draft.thickened(least).unwrap_or(draft).sorted(),
            given,
            making: BuildingMaking::default(),
        }
    }

    /// Makes more of the meshes, or looks for the draft's fault.
    fn make(self, params: &BuildingParams, space: Option<&FileSpace>) -> Result<Self, Notice> {
        match self {
            Self::Parsed(value) => json::draft(&value)
                .map(Self::Read)
                .map_err(|fault| sentences::unread(&fault)),
            Self::Read(draft) => Ok(Self::meshes(draft.clone(), Some(draft), params)),
            Self::Meshes {
                draft,
                given,
                mut making,
            } => match (making.advance(&draft), given) {
                (Ok(Some(building)), _) => {
                    check_number(&building, params, space)?;
                    Self::walls(building, draft)
                }
                (Ok(None), given) => Ok(Self::Meshes {
                    draft,
                    given,
                    making,
                }),
                (Err(fault), Some(draft)) => Ok(Self::Fault {
                    draft,
                    fault,
                    making: BuildingMaking::default(),
                }),
                (Err(fault), None) => Err(sentences::unread(&fault)),
            },
            Self::Fault {
                draft,
                fault,
                mut making,
            } => match making.advance(&draft) {
                Ok(None) => Ok(Self::Fault {
                    draft,
                    fault,
                    making,
                }),
                Ok(Some(_)) => Err(sentences::unread(&fault)),
                Err(first) => Err(sentences::unread(&first)),
            },
            walls @ Self::Walls { .. } => Ok(walls),
        }
    }

    /// Begins to measure walls.
    fn walls(building: Building, draft: Draft) -> Result<Self, Notice> {
        let building = Arc::new(building);
        let work = ThicknessWork::new(building.clone());
        Ok(Self::Walls {
            building,
            draft,
            work: work.map_err(|_| Notice::new(Code::ModelNoArea))?,
        })
    }
}

impl BuildingSite {
    fn new(
        building: Arc<Building>,
        (draft, thickness, remarks): (Draft, Vec<f64>, Vec<Notice>),
        params: &BuildingParams,
    ) -> Self {
        Self {
            fit: fit(&building),
            building,
            thickness,
            draft,
            is_given: !matches!(params.rule, Some((rule, _)) if rule != Rule::Plan),
            remarks,
        }
    }
}

/// Why a file is refused, if it is read with this unit.
fn unreadable(fault: &BuildingFault, space: &FileSpace) -> Notice {
    let maybe = match fault {
        BuildingFault::Far { size, .. } => other_unit(*size, space),
        _ => None,
    };
    maybe.unwrap_or_else(|| sentences::unread(fault))
}

/// Refuses a module that is so small that there would be too many blocks. If no module fits, an OBJ file may be in another
/// unit than the one of its `space`.
fn check_number(
    building: &Building,
    params: &BuildingParams,
    space: Option<&FileSpace>,
) -> Result<(), Notice> {
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
    let beyond = |key: Key, length: f64| {
        let row = super::SCHEMA.row(key.0);
        row.is_some_and(|row| fits(length) as f64 > row.max)
    };
    if beyond(keys::W, module.half) || beyond(keys::H, module.course) {
        let (low, high) = bounds(building);
        let size = (high - low).to_array();
        let maybe = space.and_then(|space| other_unit(size, space));
        return Err(maybe.unwrap_or_else(|| {
            sentences::sized(Code::MasonryHuge, size)
                .with("n", blocks as usize)
                .with("most", MOST_BLOCKS as usize)
        }));
    }
    Err(Notice::new(Code::MasonryMany)
        .with("n", blocks as usize)
        .with("most", MOST_BLOCKS as usize)
        .with("fits", fits(module.half))
        .with("course", fits(module.course)))
}

/// The area of a face (square metres) in its (s, t).
fn area(face: &Face) -> f64 {
    face.rings.iter().map(|ring| signed_area(ring)).sum()
}

/// The map from the building to the scene. The whole building is in sight while it turns, and so is the rim of its
/// ground.
fn fit(building: &Building) -> Fit {
    let (low, high) = bounds(building);
    let axis = low.midpoint(high);
    let [x, z] = [axis.x, axis.z];
    let all: Vec<DVec3> = places(building).copied().collect();
    let mut rims = Rim::around([x, z], &all, SHARE);
    let disc = Disc::new(building);
    rims.push(Rim {
        radius: disc.radius + libm::hypot(disc.middle.x - x, disc.middle.z - z),
        height: disc.foot(),
        share: RIM_SHARE,
    });
    Fit::turning([x, z], &rims, &MASONRY.camera())
}

/// The box around all vertices and extra meshes (metres).
fn bounds(building: &Building) -> (DVec3, DVec3) {
    let start = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    places(building).fold(start, |(lo, hi), &p| (lo.min(p), hi.max(p)))
}

/// All vertices of the building and of its extra meshes (metres).
fn places(building: &Building) -> impl Iterator<Item = &DVec3> {
    let extras = building.extras().iter().flat_map(|extra| &extra.positions);
    let vertices = building.vertices().iter();
    vertices.map(|vertex| &vertex.position).chain(extras)
}
