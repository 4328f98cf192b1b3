//! A grid of plain squares: the least that a generator is. It stands in builds for tests only, where
//! all that runs generators is tried with it.

mod engine;

use super::bigger::Bigger;
use super::height_field::{Bodies, HeightField, HeightFieldParams, PlaneParams, Revisions};
use super::{Course, Engine, Generator, Preset, Views, common};
use crate::cells::Cell;
use crate::domain::{Domain, Outline};
use crate::field::Kind;
use crate::graph::Node;
use crate::heightfield::{Planes, TextureParams};
use crate::material::{ColourParams, Pattern};
use crate::recipe::parameter::{int, number};
use crate::recipe::schema::{NoRules, rows};
use crate::recipe::{Recipe, Schema, common as shared};
use crate::solid::{Distribution, SkinParams, StoneKind, StoneParams};
use glam::DVec2;

rows! {
    size SIZE => shared::SIZE;
    seed SEED => shared::SEED;
    across ACROSS: "Squares along a side." =>
        int("", "Squares").range(1.0, 32.0, 1.0, 6.0).group("Grid").main();
    gap GAP: "Between squares, in parts of one." =>
        number("", "Gap").range(0.0, 0.9, 0.05, 0.2).group("Grid");
    fd FD => shared::FD;
    af AF => shared::AF;
    palette PALETTE => shared::PALETTE;
    vary VARY => shared::VARY;
    ground GROUND => shared::GROUND;
    gloss GLOSS => shared::GLOSS;
    wear WEAR => shared::WEAR;
    moss MOSS => shared::MOSS;
    dirt DIRT => shared::DIRT;
    wet WET => shared::WET;
    light LIGHT => shared::LIGHT;
    az AZ => shared::AZ;
    el EL => shared::EL;
    lx LX => shared::LX;
    ly LY => shared::LY;
    lz LZ => shared::LZ;
    amb AMB => shared::AMB;
    diff DIFF => shared::DIFF;
    spec SPEC => shared::SPEC;
    shin SHIN => shared::SHIN;
    shadow SHADOW => shared::SHADOW;
    occl OCCL => shared::OCCL;
}

/// The parameters of a specimen.
pub static SCHEMA: Schema = Schema {
    word: "specimen",
    is_named: true,
    rows: ROWS,
    rules: &NoRules,
};

/// The generator.
pub static SPECIMEN: Generator = Generator {
    schema: &SCHEMA,
    title: "Squares",
    presets: &[
        Preset {
            name: "squares",
            title: "Squares",
            group: "Squares",
            figure: "",
            note: "As they are.",
            link: "v=1&make=specimen",
            timing: None,
        },
        Preset {
            name: "few-squares",
            title: "Few squares",
            group: "Squares",
            figure: "",
            note: "Three along a side.",
            link: "v=1&make=specimen&across=3",
            timing: None,
        },
    ],
    stages: &["grid", "planes", "weather", "shading"],
    course: Course::UNKNOWN,
    views: Views {
        bases: &["auto", "picture", "albedo"],
        overlays: &[],
    },
    offers: &["maps"],
    names: &["across"],
    chance: "plane",
    home: "330,40,2.95,28",
    lowest: 5.0,
    engine: |recipe| Box::new(Specimen::new(recipe)),
};

/// The seed that panics, so that tests see what a panic does.
const PANICS: f64 = 4_294_967_295.0;

/// What the squares are made by.
#[derive(Clone, Copy, Debug, PartialEq)]
struct GridParams {
    across: usize,
    gap: f64,
    side: f64,
    panics: bool,
}

/// The squares, and what they lie in.
struct Grid {
    domain: Domain,
    cells: Vec<Cell>,
}

/// The machine.
struct Specimen {
    latest: Recipe,
    working: Recipe,
    grid: Node<GridParams, (), Grid>,
    finish: HeightField,
    bigger: Option<Bigger>,
    frame: Vec<u8>,
}

fn grid(recipe: &Recipe) -> GridParams {
    GridParams {
        across: recipe.number(keys::ACROSS) as usize,
        gap: recipe.number(keys::GAP),
        side: recipe.side(),
        panics: recipe.number(keys::SEED) == PANICS,
    }
}

/// Flagstones with bevelled edges, no two alike.
fn stone(recipe: &Recipe, size: f64) -> StoneParams {
    StoneParams {
        kind: StoneKind::Flagstone,
        height: 0.3 * size,
        scale: 1.0,
        distortion: 0.3,
        distribution: Distribution::Uniform,
        bevel_horizontal: 0.2,
        bevel_vertical: 0.2,
        skin: NO_SKIN,
        seed: common::seed(recipe),
    }
}

/// Flagstones have none.
const NO_SKIN: SkinParams = SkinParams {
    sweep: 0.0,
    skew: 0.0,
    skew_angle: 0.0,
    tilt: 0.0,
    taper: 0.0,
    flatness: 0.0,
    keel: 0.0,
    rings: 0,
    dimension: 0.0,
    amplitude: 0.0,
};

/// The palette's colours without marks, rims and belly.
const PLAIN: ColourParams = ColourParams {
    pattern: Pattern::Plain,
    scale: 1.0,
    angle: 0.0,
    sharpness: 0.0,
    share: 0.0,
    amount: 0.0,
    rim: 0.0,
    belly: 0.0,
    belly_angle: 0.0,
};

fn finish(recipe: &Recipe, pixel_scale: usize) -> HeightFieldParams {
    let size = recipe.side() / recipe.number(keys::ACROSS);
    let texture = TextureParams {
        side: common::side(recipe),
        pixel_scale,
        seed: common::seed(recipe),
        size,
        stone: stone(recipe, size),
        dimension: recipe.number(keys::FD),
        amplitude: recipe.number(keys::AF),
        palette: recipe.choice(keys::PALETTE),
        ground: recipe.choice(keys::GROUND),
        vary: recipe.number(keys::VARY),
        colour: PLAIN,
        tile: false,
    };
    HeightFieldParams {
        planes: PlaneParams { texture, finer: 0 },
        weather: common::weather(recipe),
        light: common::light(recipe),
    }
}

impl Grid {
    fn new(params: &GridParams) -> Self {
        assert!(!params.panics, "a panic that was asked for");
        let GridParams {
            across, gap, side, ..
        } = *params;
        let size = side / across as f64;
        let half = 0.5 * size * (1.0 - gap);
        let cell = |k: usize| {
            let place = DVec2::new((k % across) as f64 + 0.5, (k / across) as f64 + 0.5);
            let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
            let corner = |(x, y)| size * place + half * DVec2::new(x, y);
            Cell {
                id: k as u32,
                centre: size * place,
                kind: Kind::Square,
                size,
                aspect: 1.0,
                axis: DVec2::X,
                ring: corners.map(corner).to_vec(),
            }
        };
        let ring = [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)];
        let outline = Outline {
            rings: vec![ring.map(DVec2::from).to_vec()],
            lines: Vec::new(),
        };
        Self {
            domain: Domain::from_checked(&outline),
            cells: (0..across * across).map(cell).collect(),
        }
    }
}

impl Specimen {
    fn new(recipe: &Recipe) -> Self {
        Self {
            latest: recipe.clone(),
            working: recipe.clone(),
            grid: Node::new(grid(recipe)),
            finish: HeightField::new(finish(recipe, 1)),
            bigger: None,
            frame: Vec::new(),
        }
    }

    fn inputs(&self) -> Revisions {
        Revisions {
            domain: self.grid.revision(),
            cells: self.grid.revision(),
        }
    }

    fn bodies(&self) -> Option<Bodies<'_>> {
        let grid = self.grid.made()?;
        Some(Bodies {
            domain: &grid.domain,
            cells: &grid.cells,
            coats: &[],
        })
    }

    fn planes(&self) -> Option<&Planes> {
        self.finish.weather.made().filter(|_| self.at().is_none())
    }
}
