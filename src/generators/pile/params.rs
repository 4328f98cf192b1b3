//! Turns a recipe into the parameters of each stage.

use super::PILE;
use super::materials::materials;
use super::schema::{NONE, TYPE_KEYS, TypeKeys, keys};
use crate::component::{ComponentKind, FINISHES, Finish};
use crate::generators::lighting::LightParams;
use crate::generators::rows::numbered::numbers_of;
use crate::generators::rows::shared;
use crate::generators::scene_picture::{AskedFile, StillParams};
use crate::material::Gloss;
use crate::pile::{CostScope, Method, RefineParams, SettlingOrder, Turn};
use crate::pile_shape::PileShape;
use crate::recipe::{Key, Recipe};
use crate::shapes::Shape;
use glam::DVec3;

/// The finish of a file's component.
const PLAIN: &str = "clay";

/// The parameters of the stages.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PileParams {
    pub files: Vec<AskedFile>,
    pub components: ComponentParams,
    pub dress: DressParams,
    pub site: SiteParams,
    pub room: RoomParams,
    pub darts: DartParams,
    pub refine: RefineParams,
    pub bodies: BodyParams,
    pub still: StillParams,
}

/// The source of a component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ComponentSource {
    /// A component by rule.
    Kind(ComponentKind),
    /// From a file.
    File {
        /// Its number among all files of the recipe.
        number: usize,
        /// Its digest; 0 if the recipe names no file.
        digest: u64,
        /// Whether z is up in it.
        is_z_up: bool,
    },
}

/// The components of all types.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ComponentParams {
    pub sources: Vec<ComponentSource>,
    /// Variants of each component.
    pub variants: u64,
    pub seed: u64,
}

/// The colours of all types.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct DressParams {
    pub finishes: Vec<&'static Finish>,
}

/// The source of the shape.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum SiteSource {
    /// A shape made for piles, with its numbers.
    Pile(PileShape, Vec<f64>),
    /// A shape of surfaces, with its numbers.
    Shape(Shape, Vec<f64>),
    /// The shape of a file, by its number among all files of the recipe.
    File(usize),
}

/// The parameters of the shape.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SiteParams {
    pub source: SiteSource,
    /// Half of the shape's longest side.
    pub half: f64,
}

/// How one type is heaped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TypeParams {
    pub scale: f64,
    /// Least distance of two darts, in R (the radius of the largest inner sphere). `None` follows from the component.
    pub density: Option<f64>,
    /// The key of the density's row, for the sentence on too many darts.
    pub density_key: Key,
    pub turn: Turn,
    /// The range along the normal, in diagonals. `None` follows from the component.
    pub range: Option<f64>,
}

/// The room that bodies take around the shape.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct RoomParams {
    /// For each type its scale, its density and its range.
    pub types: Vec<(f64, Option<f64>, Option<f64>)>,
    /// The share of the range that lies inside of the shape.
    pub inward: f64,
}

/// How darts are thrown, and how bodies are heaped on them.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct DartParams {
    pub types: Vec<TypeParams>,
    pub jitter: f64,
    /// The share of the range that lies inside of the shape.
    pub inward: f64,
    pub layers: u32,
    pub is_merged: bool,
    pub in_scan_order: bool,
    pub seed: u64,
}

/// Whether the shape itself is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CoreShown {
    /// Seen if it is ground.
    Suits,
    Seen,
    Hidden,
}

/// How bodies look.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BodyParams {
    pub vary: f64,
    pub gloss: Gloss,
    /// The share of the height that is wet.
    pub wet: f32,
    pub core: CoreShown,
    pub seed: u64,
}

impl PileParams {
    pub fn new(recipe: &Recipe) -> Self {
        let mut files = Vec::new();
        let types: Vec<&TypeKeys> = TYPE_KEYS
            .iter()
            .filter(|own| recipe.choice(own.component) != NONE)
            .collect();
        let sources = types.iter().map(|own| source(recipe, own, &mut files));
        let components = ComponentParams {
            sources: sources.collect(),
            variants: recipe.number(keys::VARIANTS) as u64,
            seed: shared::seed(recipe),
        };
        let darts = darts(recipe, &types);
        let each = darts.types.iter();
        let dress = DressParams {
            finishes: types.iter().map(|own| finish(recipe, own)).collect(),
        };
        let bodies = bodies(recipe);
        let light = LightParams {
            shade: shared::shading(recipe),
            materials: materials(&dress.finishes, bodies.gloss),
        };
        Self {
            components,
            room: RoomParams {
                types: each.map(|t| (t.scale, t.density, t.range)).collect(),
                inward: darts.inward,
            },
            site: site(recipe, &mut files),
            still: StillParams::new(recipe, PILE.camera(), light),
            dress,
            darts,
            refine: refine(recipe),
            bodies,
            files,
        }
    }
}

/// A component's source. A file is added to the list of files.
fn source(recipe: &Recipe, own: &TypeKeys, files: &mut Vec<AskedFile>) -> ComponentSource {
    match ComponentKind::of_word(recipe.choice(own.component)) {
        Some(kind) => ComponentSource::Kind(kind),
        None => {
            let asked = asked(recipe, own.file, own.up);
            let digest = asked.file.as_ref().map_or(0, |file| file.digest);
            let is_z_up = asked.is_z_up;
            files.push(asked);
            ComponentSource::File {
                number: files.len() - 1,
                digest,
                is_z_up,
            }
        }
    }
}

fn asked(recipe: &Recipe, file: Key, up: Key) -> AskedFile {
    AskedFile::new(recipe, file, recipe.choice(up) == "z")
}

fn site(recipe: &Recipe, files: &mut Vec<AskedFile>) -> SiteParams {
    let word = recipe.choice(keys::FORM);
    let source = match (PileShape::of_word(word), Shape::of_word(word)) {
        (Some(shape), _) => SiteSource::Pile(shape, numbers_of(recipe, keys::FORM, word)),
        (_, Some(shape)) => SiteSource::Shape(shape, numbers_of(recipe, keys::FORM, word)),
        _ => {
            files.push(asked(recipe, keys::MODEL, keys::UP));
            SiteSource::File(files.len() - 1)
        }
    };
    SiteParams {
        source,
        half: recipe.number(keys::PS),
    }
}

/// The finish of a type: the given one, else that of its component. A file's component is of fired clay, which hides
/// nothing of its form.
fn finish(recipe: &Recipe, own: &TypeKeys) -> &'static Finish {
    let of_component = || match ComponentKind::of_word(recipe.choice(own.component)) {
        Some(kind) => Some(kind.finish()),
        None => Finish::of_word(PLAIN),
    };
    let given = Finish::of_word(recipe.choice(own.finish));
    given.or_else(of_component).unwrap_or(&FINISHES[0])
}

fn darts(recipe: &Recipe, types: &[&TypeKeys]) -> DartParams {
    let is_global = recipe.choice(keys::FRAME) == "global";
    let is_natural = recipe.choice(keys::REACH) == "natural";
    let of = |own: &&TypeKeys| {
        let density = recipe.number(own.density);
        let [u, v, w] = own.turns.map(|key| recipe.number(key).to_radians());
        TypeParams {
            scale: recipe.number(own.scale),
            density: (density > 0.0).then_some(density),
            density_key: own.density,
            turn: Turn {
                ranges: DVec3::new(u, v, w),
                is_global,
            },
            range: (!is_natural).then_some(recipe.number(own.range)),
        }
    };
    DartParams {
        types: types.iter().map(of).collect(),
        jitter: recipe.number(keys::JITTER),
        inward: recipe.number(keys::ALPHA),
        layers: recipe.number(keys::LAYERS) as u32,
        is_merged: recipe.choice(keys::MERGE) == "merged",
        in_scan_order: recipe.choice(keys::DARTS) == "scan",
        seed: shared::seed(recipe),
    }
}

fn refine(recipe: &Recipe) -> RefineParams {
    RefineParams {
        offset: recipe.number(keys::OFFSET),
        removal: recipe.number(keys::REMOVAL),
        order: match recipe.choice(keys::ORDER) {
            "scan" => SettlingOrder::Scan,
            _ => SettlingOrder::Random,
        },
        is_large_first: recipe.choice(keys::FIRST) == "large",
        retries: recipe.number(keys::RETRIES) as u32,
        method: match recipe.choice(keys::REFINE) {
            "golden" => Method::Golden {
                iterations: recipe.number(keys::ITERATIONS) as u32,
                scope: match recipe.choice(keys::READING) {
                    "all" => CostScope::All,
                    _ => CostScope::Nearest,
                },
            },
            _ => Method::Exact,
        },
        seed: shared::seed(recipe),
    }
}

fn bodies(recipe: &Recipe) -> BodyParams {
    BodyParams {
        vary: recipe.number(keys::VARY),
        gloss: Gloss::of_word(recipe.choice(keys::GLOSS)),
        wet: recipe.number(keys::WET) as f32,
        core: match recipe.choice(keys::CORE) {
            "seen" => CoreShown::Seen,
            "hidden" => CoreShown::Hidden,
            _ => CoreShown::Suits,
        },
        seed: shared::seed(recipe),
    }
}
