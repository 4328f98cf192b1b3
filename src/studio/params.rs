//! From the recipe's words and numbers to the small parameter structures of the stages.

use super::height_field::{HeightFieldParams, LightParams, PlaneParams};
use super::terrain::{DomainParams, TerrainParams};
use crate::domain::Outline;
use crate::field::{Direction, FieldParams, Kind, Rim, Spot};
use crate::heightfield::{Light, ShadeParams, TextureParams};
use crate::material::{ColourParams, Gloss, Material, Pattern, WeatherParams, material_table};
use crate::notice::Notice;
use crate::packing::{Edge, Integrator, PackingParams, Population, Start};
use crate::recipe::{Key, Recipe, Stage};
use crate::solid::{Distribution, SkinParams, StoneKind, StoneParams};
use glam::DVec2;

/// Rounds of Lloyd's relaxation: after these it hardly gets better.
const LLOYD_ROUNDS: u32 = 50;

/// What cells are made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum CellParams {
    /// The dual of the packing's mesh.
    Fitted,
    /// The packed squares as they are.
    Packed,
    /// The Voronoi diagram of as many scattered points, evened out in so many rounds.
    Scattered { rounds: u32, seed: u64 },
}

/// What coats are made by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CoatParams {
    pub colour: ColourParams,
    pub seed: u64,
    /// Of the picture.
    pub side: f64,
}

/// What a recipe asks of each stage.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Params {
    pub terrain: TerrainParams,
    pub packing: PackingParams,
    pub cells: CellParams,
    /// Are the stones skin, whose flow has one sense?
    pub is_skin: bool,
    pub coats: CoatParams,
    pub finish: HeightFieldParams,
}

impl Params {
    /// Of a recipe for this outline ([`outline`]); skin gets `finer` Loop steps more than it needs.
    pub fn new(recipe: &Recipe, outline: &Outline, finer: i32) -> Self {
        Self {
            terrain: terrain(recipe, outline),
            packing: packing(recipe),
            cells: cells(recipe),
            is_skin: recipe.is_skin(),
            coats: CoatParams {
                colour: colour(recipe),
                seed: seed(recipe),
                side: recipe.side(),
            },
            finish: finish(recipe, 1, finer),
        }
    }

    /// The first stage of which others ask something else.
    pub fn first_difference(&self, other: &Params) -> Option<Stage> {
        let differences = [
            (Stage::Domain, self.terrain.domain != other.terrain.domain),
            (Stage::Fields, self.terrain.fields != other.terrain.fields),
            (Stage::Packing, self.packing != other.packing),
            (Stage::Cells, self.cells != other.cells),
            (Stage::Planes, self.is_skin != other.is_skin),
            (Stage::Planes, self.coats != other.coats),
            (Stage::Planes, self.finish.planes != other.finish.planes),
            (Stage::Weather, self.finish.weather != other.finish.weather),
            (Stage::Shading, self.finish.light != other.finish.light),
        ];
        let mut differences = differences.into_iter();
        differences
            .find(|&(_, differs)| differs)
            .map(|(stage, _)| stage)
    }
}

/// Pixels along the picture's side.
pub(super) fn side(recipe: &Recipe) -> usize {
    recipe.number(Key::Size) as usize
}

/// An outline from outside, checked for the recipe's picture, and what was mended.
pub(super) fn checked(
    outline: &Outline,
    recipe: &Recipe,
) -> Result<(Outline, Vec<Notice>), Notice> {
    outline.check(recipe.side())
}

/// The outline to pave: the exact one where there is one, the recipe's constraint lines in either.
pub(super) fn outline(recipe: &Recipe, exact: Option<&Outline>) -> Outline {
    let Some(exact) = exact else {
        return recipe.outline();
    };
    let mut outline = exact.clone();
    outline.lines.extend(recipe.lines());
    outline
}

/// The domain and its fields.
pub(super) fn terrain(recipe: &Recipe, outline: &Outline) -> TerrainParams {
    TerrainParams {
        domain: domain(recipe, outline),
        fields: fields(recipe),
    }
}

/// An outline's rings and lines, or the whole picture as a tile.
fn domain(recipe: &Recipe, outline: &Outline) -> DomainParams {
    if recipe.is_tile() {
        DomainParams::Torus {
            side: recipe.side(),
            lines: outline.lines.clone(),
        }
    } else {
        DomainParams::Plane(outline.clone())
    }
}

/// The aspect ratio that cells of a kind are packed with for one of `ca`. The cells of ellipses are
/// hexagons: by their second moments they are as long as the ellipses, by the box around them 0.87
/// times. This is between.
fn drawn(kind: Kind, ca: f64) -> f64 {
    if kind == Kind::Ellipse {
        1.0 + 1.06 * (ca - 1.0)
    } else {
        ca
    }
}

/// The kind of the cells and their aspect ratio.
pub(super) fn kind(recipe: &Recipe) -> (Kind, f64) {
    let kind = Kind::from_word(recipe.choice(Key::Kind)).unwrap_or_default();
    let ca = recipe.number(Key::Ca);
    (kind, drawn(kind, ca))
}

fn fields(recipe: &Recipe) -> FieldParams {
    let number = |key| recipe.number(key);
    let side = recipe.side();
    let (direction, angle) = match recipe.choice(Key::Dir) {
        "constant" => (Direction::Constant, number(Key::Angle)),
        "strokes" => (Direction::Strokes, number(Key::Angle)),
        "radial" => (Direction::Spiral, 0.0),
        "circular" => (Direction::Spiral, 90.0),
        "spiral" => (Direction::Spiral, number(Key::Fa)),
        "printed" => (Direction::Printed, number(Key::Angle)),
        _ => (Direction::Boundary, number(Key::Angle)),
    };
    let rim = |factor, reach| Rim {
        factor: number(factor),
        reach: side * number(reach),
    };
    let spots = |spots: Vec<[f64; 4]>| {
        let spot = |[x, y, radius, value]: [f64; 4]| Spot {
            centre: DVec2::new(x, y),
            radius,
            value,
        };
        spots.into_iter().map(spot).collect()
    };
    let (kind, aspect) = kind(recipe);
    let mut aspect_spots = recipe.aspect_spots();
    for [.., ratio] in &mut aspect_spots {
        *ratio = drawn(kind, *ratio);
    }
    FieldParams {
        direction,
        angle: angle.to_radians(),
        centre: side * DVec2::new(number(Key::Fx), number(Key::Fy)),
        power: number(Key::Dp) as u32,
        ends: number(Key::Ends),
        strokes: recipe.strokes(),
        reach: side * number(Key::Reach),
        kind,
        part_kinds: part_kinds(recipe, kind),
        aspect,
        aspect_rim: rim(Key::Cb, Key::Cd),
        aspect_spots: spots(aspect_spots),
        size: number(Key::Cs),
        linear: DVec2::new(number(Key::Gx), number(Key::Gy)),
        radial: number(Key::Gr),
        size_rim: rim(Key::Gb, Key::Gd),
        size_spots: spots(recipe.size_spots()),
        side,
    }
}

fn part_kinds(recipe: &Recipe, kind: Kind) -> Vec<(DVec2, Kind)> {
    let seeds = recipe.part_kinds().into_iter();
    let own = |word| Kind::from_word(word).unwrap_or(kind);
    seeds.map(|(place, word)| (place, own(word))).collect()
}

pub(super) fn packing(recipe: &Recipe) -> PackingParams {
    PackingParams {
        edge: match recipe.choice(Key::Edge) {
            "on" => Edge::On,
            _ => Edge::Wall,
        },
        start: match recipe.choice(Key::Start) {
            "quadtree" => Start::Quadtree,
            _ => Start::Stream,
        },
        integrator: match recipe.choice(Key::Move) {
            "rk4" => Integrator::RungeKutta,
            _ => Integrator::SemiImplicit,
        },
        population: match recipe.choice(Key::Pop) {
            "smallest" => Population::Smallest,
            "off" => Population::Off,
            _ => Population::Slots,
        },
        variance: recipe.number(Key::Vs),
        seed: seed(recipe),
    }
}

fn seed(recipe: &Recipe) -> u64 {
    recipe.number(Key::Seed) as u64
}

fn cells(recipe: &Recipe) -> CellParams {
    let scattered = |rounds| CellParams::Scattered {
        rounds,
        seed: seed(recipe),
    };
    match recipe.choice(Key::Cells) {
        "packed" => CellParams::Packed,
        "voronoi" => scattered(0),
        "lloyd" => scattered(LLOYD_ROUNDS),
        _ => CellParams::Fitted,
    }
}

pub(super) fn stone(recipe: &Recipe) -> StoneParams {
    StoneParams {
        kind: match recipe.choice(Key::Stone) {
            "flag" => StoneKind::Flagstone,
            "skin" => StoneKind::Skin,
            _ => StoneKind::Cobble,
        },
        height: recipe.number(Key::Hs),
        scale: recipe.number(Key::Sv),
        distortion: recipe.number(Key::Dr),
        distribution: match recipe.choice(Key::Rand) {
            "normal" => Distribution::Normal,
            _ => Distribution::Uniform,
        },
        bevel_horizontal: recipe.number(Key::Bh),
        bevel_vertical: recipe.number(Key::Bv),
        skin: SkinParams {
            sweep: recipe.number(Key::Sr),
            skew: recipe.number(Key::Sc),
            skew_angle: recipe.number(Key::Sa).to_radians(),
            tilt: recipe.number(Key::Tilt),
            taper: recipe.number(Key::Tc),
            flatness: recipe.number(Key::Flat),
            keel: recipe.number(Key::Keel),
            rings: recipe.number(Key::Rings) as u32,
            dimension: recipe.number(Key::Fd),
            amplitude: recipe.number(Key::Af),
        },
        seed: seed(recipe),
    }
}

/// Planes, weather and light with `pixel_scale` pixels for each of the recipe, along a side.
pub(super) fn finish(recipe: &Recipe, pixel_scale: usize, finer: i32) -> HeightFieldParams {
    let texture = TextureParams {
        pixel_scale,
        ..texture(recipe)
    };
    HeightFieldParams {
        planes: PlaneParams { texture, finer },
        weather: weather(recipe),
        light: LightParams {
            shade: shading(recipe),
            materials: materials(recipe),
        },
    }
}

pub(super) fn texture(recipe: &Recipe) -> TextureParams {
    TextureParams {
        side: side(recipe),
        pixel_scale: 1,
        seed: seed(recipe),
        size: recipe.number(Key::Cs),
        stone: stone(recipe),
        dimension: recipe.number(Key::Fd),
        amplitude: recipe.number(Key::Af),
        palette: recipe.choice(Key::Palette),
        ground: recipe.choice(Key::Ground),
        vary: recipe.number(Key::Vary),
        colour: colour(recipe),
        tile: recipe.is_tile(),
    }
}

fn weather(recipe: &Recipe) -> WeatherParams {
    WeatherParams {
        wear: recipe.number(Key::Wear),
        moss: recipe.number(Key::Moss),
        dirt: recipe.number(Key::Dirt),
        wet: recipe.number(Key::Wet),
    }
}

fn colour(recipe: &Recipe) -> ColourParams {
    ColourParams {
        pattern: Pattern::of_word(recipe.choice(Key::Pattern)),
        scale: recipe.number(Key::Pn) * recipe.side(),
        angle: recipe.number(Key::Pa).to_radians(),
        sharpness: recipe.number(Key::Ps),
        share: recipe.number(Key::Pc),
        amount: recipe.number(Key::Pm),
        rim: recipe.number(Key::Rim),
        belly: recipe.number(Key::Belly),
        belly_angle: recipe.number(Key::Ba).to_radians(),
    }
}

/// The table that the plane of materials indexes.
pub(super) fn materials(recipe: &Recipe) -> Vec<Material> {
    material_table(
        recipe.choice(Key::Palette),
        recipe.choice(Key::Ground),
        Gloss::of_word(recipe.choice(Key::Gloss)),
    )
}

pub(super) fn shading(recipe: &Recipe) -> ShadeParams {
    ShadeParams {
        light: match recipe.choice(Key::Light) {
            "point" => Light::Point {
                x: recipe.number(Key::Lx),
                y: recipe.number(Key::Ly),
                z: recipe.number(Key::Lz),
            },
            _ => Light::Parallel {
                azimuth: recipe.number(Key::Az).to_radians(),
                elevation: recipe.number(Key::El).to_radians(),
            },
        },
        ambient: recipe.number(Key::Amb),
        diffuse: recipe.number(Key::Diff),
        specular: recipe.number(Key::Spec),
        shininess: recipe.number(Key::Shin),
        shadow: recipe.number(Key::Shadow),
        occlusion: recipe.number(Key::Occl),
    }
}
