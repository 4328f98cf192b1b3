//! From the recipe's words and numbers to the small parameter structures of the stages.

use crate::cells::ScatterParams;
use crate::domain::Outline;
use crate::field::{Direction, FieldParams, Kind};
use crate::packing::{Edge, Integrator, PackingParams, Population, Start};
use crate::recipe::{Key, Recipe};
use crate::render::{Light, ShadeParams};
use crate::solid::{Spread, StoneKind, StoneParams};
use crate::texture::{Optics, TextureParams, optics_table};
use glam::DVec2;

/// Rounds of Lloyd's relaxation: after these it hardly gets better.
const LLOYD_ROUNDS: u32 = 50;

/// Pixels along the picture's side.
pub(super) fn side(recipe: &Recipe) -> usize {
    recipe.number(Key::Size) as usize
}

/// An outline from outside, checked for the recipe's picture, and what was mended.
pub(super) fn checked(
    outline: &Outline,
    recipe: &Recipe,
) -> Result<(Outline, Vec<String>), String> {
    outline.check(recipe.side()).map_err(|e| e.to_string())
}

pub(super) fn fields(recipe: &Recipe) -> FieldParams {
    FieldParams {
        direction: match recipe.choice(Key::Dir) {
            "constant" => Direction::Constant,
            "printed" => Direction::Printed,
            _ => Direction::Boundary,
        },
        angle: recipe.number(Key::Angle).to_radians(),
        power: recipe.number(Key::Dp) as u32,
        kind: Kind::from_word(recipe.choice(Key::Kind)).unwrap_or_default(),
        aspect: recipe.number(Key::Ca),
        size: recipe.number(Key::Cs),
        linear: DVec2::new(recipe.number(Key::Gx), recipe.number(Key::Gy)),
        radial: recipe.number(Key::Gr),
        side: recipe.side(),
    }
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

/// Are the cells the packed squares as they are?
pub(super) fn as_packed(recipe: &Recipe) -> bool {
    recipe.choice(Key::Cells) == "packed"
}

/// Where the cells are those of scattered points: as many as `count`, and how they are evened out.
pub(super) fn scatter(recipe: &Recipe, count: usize) -> Option<ScatterParams> {
    let rounds = match recipe.choice(Key::Cells) {
        "voronoi" => 0,
        "lloyd" => LLOYD_ROUNDS,
        _ => return None,
    };
    Some(ScatterParams {
        count,
        rounds,
        seed: seed(recipe),
    })
}

fn stone(recipe: &Recipe) -> StoneParams {
    StoneParams {
        kind: match recipe.choice(Key::Stone) {
            "flag" => StoneKind::Flagstone,
            _ => StoneKind::Cobble,
        },
        height: recipe.number(Key::Hs),
        scale: recipe.number(Key::Sv),
        distortion: recipe.number(Key::Dr),
        spread: match recipe.choice(Key::Rand) {
            "normal" => Spread::Normal,
            _ => Spread::Uniform,
        },
        bevel_horizontal: recipe.number(Key::Bh),
        bevel_vertical: recipe.number(Key::Bv),
        seed: seed(recipe),
    }
}

pub(super) fn texture(recipe: &Recipe) -> TextureParams {
    TextureParams {
        side: side(recipe),
        seed: seed(recipe),
        size: recipe.number(Key::Cs),
        stone: stone(recipe),
        dimension: recipe.number(Key::Fd),
        amplitude: recipe.number(Key::Af),
        palette: recipe.choice(Key::Palette),
        ground: recipe.choice(Key::Ground),
        vary: recipe.number(Key::Vary),
    }
}

/// The table that the optics plane indexes.
pub(super) fn optics(recipe: &Recipe) -> Vec<Optics> {
    optics_table(recipe.choice(Key::Palette), recipe.choice(Key::Ground))
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
