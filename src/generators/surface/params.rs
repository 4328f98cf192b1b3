//! Turns a recipe into the parameters of each stage.

use super::SURFACE;
use super::schema::{FILE, keys};
use crate::field::CellKind;
use crate::generators::rows::numbered::numbers_of;
use crate::generators::rows::{shared, stones};
use crate::generators::scene_picture::{AskedFile, StillParams};
use crate::heightfield::TextureParams;
use crate::material::{ColourParams, WeatherParams};
use crate::packing::PackingParams;
use crate::recipe::Recipe;
use crate::shapes::{Ends, Shape};
use crate::surface_field::{Along, ByCurvature, Taper};
use crate::surface_stones::Open;
use crate::trimesh::Sides;
use glam::DVec3;

/// Picture units along a cell of mean size: stones have the detail of a picture with such cells.
pub(super) const UNIT: f64 = 24.0;

/// The parameters of the stages.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Params {
    pub surface: SurfaceParams,
    pub fields: FieldParams,
    pub packing: PackingParams,
    pub cells: CellParams,
    pub stones: StoneLook,
    pub still: StillParams,
}

/// The mesh on which cells are packed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PackingTarget {
    /// The surface itself, or a simpler one if the surface is far finer than cells need.
    Fit,
    /// The surface itself.
    Whole,
    /// A simpler surface; cells are then carried to the surface itself.
    Simple,
}

/// The source of a surface.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum MeshSource {
    /// A shape by rule, with its ends and its numbers.
    Shape(Shape, Ends, Vec<f64>),
    /// The surface in a file.
    Model(AskedFile),
}

/// The parameters of the surface.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SurfaceParams {
    pub source: MeshSource,
    /// Which side is the outside of a file's open parts.
    pub sides: Sides,
    /// The mesh on which cells are packed.
    pub on: PackingTarget,
    /// Creases with at least this angle (in radians) are cut; `None` cuts no crease.
    pub cut: Option<f64>,
    pub sizes: Sizes,
}

/// The sizes of cells.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sizes {
    pub kind: CellKind,
    /// The wanted number of cells; the packing meets it approximately.
    pub count: f64,
    pub taper: Option<Taper>,
    pub curvature: Option<ByCurvature>,
    /// Rows of [`crate::recipe::Item::Patch`].
    pub spots: Vec<[f64; 5]>,
}

/// The source of directions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Follow {
    Bones,
    Axis,
    Curvature,
    Border,
    Strokes,
    Free,
}

/// The parameters of the fields.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct FieldParams {
    pub sizes: Sizes,
    pub aspect: f64,
    pub aspect_by_curvature: bool,
    pub aspect_spots: Vec<[f64; 5]>,
    pub follow: Follow,
    pub flow: Follow,
    pub towards: DVec3,
    pub angle: f64,
    /// The least angle of a crease, in radians. Creases that are not cut guide the rows.
    pub crease: f64,
    /// Rows of [`crate::recipe::Item::Trace`].
    pub strokes: Vec<Vec<i64>>,
    pub lines: Vec<Vec<i64>>,
    /// The width of strokes, in longest sides of the model's bounding box.
    pub reach: f64,
}

/// The coats of cells, and the sense in which scales lean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CellParams {
    pub colour: ColourParams,
    /// Whether bands run around a body with bones, by the length along its bones; else bands run across the pattern's
    /// angle.
    pub is_around: bool,
    pub seed: u64,
    /// Whether the flow is reversed.
    pub flip: bool,
}

/// The parameters of stones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct StoneLook {
    pub texture: TextureParams,
    pub weather: WeatherParams,
    pub open: Open,
}

impl Params {
    pub fn new(recipe: &Recipe) -> Self {
        let sizes = sizes(recipe);
        Self {
            surface: surface(recipe, &sizes),
            fields: fields(recipe, sizes),
            packing: packing(recipe),
            cells: CellParams {
                colour: stones::colour(recipe, 1.0),
                is_around: recipe.choice(keys::PT) == "body",
                seed: shared::seed(recipe),
                flip: recipe.choice(keys::FLIP) == "1",
            },
            stones: StoneLook {
                texture: stones::texture(recipe, UNIT, [UNIT, 1.0]),
                weather: shared::weather(recipe),
                open: open(recipe),
            },
            still: StillParams::new(recipe, SURFACE.camera(), shared::light(recipe)),
        }
    }
}

/// The shape by rule that a recipe names; `None` for a surface from a file.
pub(super) fn shape(recipe: &Recipe) -> Option<Shape> {
    Shape::of_word(recipe.choice(keys::FORM))
}

fn open(recipe: &Recipe) -> Open {
    match (recipe.choice(keys::OPEN), shape(recipe)) {
        ("shell", _) => Open::Shell,
        ("capped", _) => Open::Capped,
        ("block", _) | (_, Some(Shape::Terrain | Shape::Slope | Shape::Stairs)) => Open::Block,
        _ => Open::Shell,
    }
}

fn surface(recipe: &Recipe, sizes: &Sizes) -> SurfaceParams {
    let is_file = recipe.choice(keys::FORM) == FILE;
    SurfaceParams {
        source: match shape(recipe).filter(|_| !is_file) {
            Some(shape) => MeshSource::Shape(
                shape,
                ends(recipe),
                numbers_of(recipe, keys::FORM, shape.word()),
            ),
            None => {
                let is_z_up = recipe.choice(keys::UP) == "z";
                MeshSource::Model(AskedFile::new(recipe, keys::MODEL, is_z_up))
            }
        },
        sides: match recipe.choice(keys::SIDE) {
            "guess" => Sides::Guessed,
            "other" => Sides::Other,
            _ => Sides::Given,
        },
        on: match recipe.choice(keys::ON) {
            "simple" if is_file => PackingTarget::Simple,
            "fit" if is_file => PackingTarget::Fit,
            _ => PackingTarget::Whole,
        },
        cut: (recipe.choice(keys::CREASE) == "cut").then(|| recipe.number(keys::FOLD).to_radians()),
        sizes: sizes.clone(),
    }
}

fn ends(recipe: &Recipe) -> Ends {
    match recipe.choice(keys::ENDS) {
        "cut" => Ends::Cut,
        _ => Ends::Round,
    }
}

fn towards(word: &str) -> DVec3 {
    match word {
        "right" => DVec3::X,
        "front" => DVec3::Z,
        _ => DVec3::Y,
    }
}

fn sizes(recipe: &Recipe) -> Sizes {
    let (taper, angle) = (recipe.number(keys::TAPER), recipe.number(keys::CC));
    Sizes {
        kind: CellKind::from_word(recipe.choice(keys::KIND)).unwrap_or_default(),
        count: recipe.number(keys::CN),
        taper: (taper != 1.0).then(|| Taper {
            along: match recipe.choice(keys::ALONG) {
                // A model from a file has no bones: its main axis is upright.
                "bones" if recipe.choice(keys::FORM) != FILE => Along::Bones,
                word => Along::Axis(towards(word)),
            },
            first: 1.0 / taper.sqrt(),
            last: taper.sqrt(),
        }),
        curvature: (angle > 0.0).then(|| ByCurvature {
            angle: angle.to_radians(),
            factors: (recipe.number(keys::CL), recipe.number(keys::CH)),
        }),
        spots: patches(recipe, keys::SPOTS),
    }
}

fn patches(recipe: &Recipe, key: crate::recipe::Key) -> Vec<[f64; 5]> {
    let five = |row: Vec<f64>| <[f64; 5]>::try_from(row).ok();
    recipe.list(key).into_iter().filter_map(five).collect()
}

fn fields(recipe: &Recipe, sizes: Sizes) -> FieldParams {
    let is_stretched = sizes.kind.is_stretched();
    let follow = |word: &str| match word {
        "bones" => Follow::Bones,
        "axis" => Follow::Axis,
        "curvature" => Follow::Curvature,
        "border" => Follow::Border,
        "strokes" => Follow::Strokes,
        _ => Follow::Free,
    };
    FieldParams {
        aspect: match is_stretched {
            true => recipe.number(keys::CA),
            false => 1.0,
        },
        aspect_by_curvature: is_stretched && recipe.choice(keys::BENT) == "curvature",
        aspect_spots: match is_stretched {
            true => patches(recipe, keys::STRETCH),
            false => Vec::new(),
        },
        follow: follow(recipe.choice(keys::DIR)),
        flow: follow(recipe.choice(keys::FLOW)),
        towards: towards(recipe.choice(keys::AXIS)),
        angle: recipe.number(keys::ANGLE).to_radians(),
        crease: recipe.number(keys::FOLD).to_radians(),
        strokes: recipe.rows(keys::STROKES).to_vec(),
        lines: recipe.rows(keys::LINES).to_vec(),
        reach: recipe.number(keys::REACH),
        sizes,
    }
}

fn packing(recipe: &Recipe) -> PackingParams {
    PackingParams {
        variance: recipe.number(keys::VS),
        seed: shared::seed(recipe),
        ..PackingParams::DEFAULT
    }
}
