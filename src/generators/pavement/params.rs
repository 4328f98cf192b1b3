//! Turns the recipe's words and numbers into the small parameter structures of the stages.

use super::outline::PavementRecipe;
use super::schema::keys;
use crate::cells::Cell;
use crate::domain::Outline;
use crate::field::{CellKind, Direction, FieldParams, Grading, SoftSpot};
use crate::generators::height_field::{HeightFieldParams, PlaneParams};
use crate::generators::rows::{shared, stones};
use crate::heightfield::TextureParams;
use crate::material::ColourParams;
use crate::packing::{
    BoundaryCondition, CornerBubbles, GivenCell, Integrator, PackingParams, Physics, Population,
    Start,
};
use crate::recipe::{Key, Recipe, points};
use glam::DVec2;

/// Where the domain comes from.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum DomainParams {
    /// A checked outline with its constraint lines.
    Plane(Outline),
    /// The whole picture as a tile, with constraint lines. The outline is ignored.
    Tile { side: f64, lines: Vec<Vec<DVec2>> },
}

/// The kind of cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum CellParams {
    /// The dual of the packing's mesh.
    Fitted,
    /// The packed cells as they are.
    Packed,
    /// The Voronoi cells of as many scattered points as there are packed cells, after `rounds` rounds of Lloyd's
    /// relaxation.
    Scattered { rounds: u32, seed: u64 },
}

/// The parameters of coats.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CoatParams {
    pub colour: ColourParams,
    pub seed: u64,
    /// The side of the picture, in picture units.
    pub side: f64,
}

/// The parameters of each stage.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Params {
    /// The rings of the outline: the outer ring, then the holes.
    pub rings: Vec<Vec<DVec2>>,
    pub domain: DomainParams,
    pub fields: FieldParams,
    pub packing: PackingParams,
    pub cells: CellParams,
    /// The flow that makes axes agree; `None` for stones that are not skin.
    pub flow: Option<FlowParams>,
    pub coats: CoatParams,
    pub finish: HeightFieldParams,
}

/// The flow: the direction in which scales lean as a whole.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct FlowParams {
    /// 1 along the strokes, -1 against them, 0 without strokes.
    sense: f64,
    /// The strokes that the flow follows; if empty, the flow at a cell is the cell's own axis.
    strokes: Vec<Vec<DVec2>>,
}

impl FlowParams {
    /// The direction of the flow at a cell, as a vector of any length.
    pub fn at(&self, cell: &Cell) -> DVec2 {
        if self.strokes.is_empty() {
            return cell.axis;
        }
        let mut sum = DVec2::ZERO;
        for ends in self.strokes.iter().flat_map(|stroke| stroke.windows(2)) {
            let by = ends[1] - ends[0];
            let from = cell.centre - ends[0];
            let along = (from.dot(by) / by.length_squared()).clamp(0.0, 1.0);
            // Inverse fourth powers: the nearest stroke counts most by far.
            let far = (from - by * along).length_squared() + cell.size * cell.size;
            sum += by / (far * far);
        }
        sum * self.sense
    }
}

impl Params {
    /// The parameters of a recipe, or of an exact outline with the recipe's constraint lines. Skin gets `finer` Loop
    /// steps more than a picture needs.
    pub fn new(recipe: &Recipe, exact: Option<&Outline>, finer: i32) -> Self {
        let outline = outline(recipe, exact);
        Self {
            rings: outline.rings.clone(),
            domain: match recipe.is_tile() {
                false => DomainParams::Plane(outline),
                true => DomainParams::Tile {
                    side: recipe.side(),
                    lines: outline.lines,
                },
            },
            fields: fields(recipe),
            packing: packing(recipe),
            cells: cells(recipe),
            flow: recipe.is_skin().then(|| flow(recipe)),
            coats: CoatParams {
                colour: stones::colour(recipe, recipe.side()),
                seed: shared::seed(recipe),
                side: recipe.side(),
            },
            finish: HeightFieldParams {
                planes: PlaneParams {
                    texture: texture(recipe),
                    finer,
                },
                weather: shared::weather(recipe),
                light: shared::light(recipe),
            },
        }
    }
}

/// The outline to pave.
fn outline(recipe: &Recipe, exact: Option<&Outline>) -> Outline {
    let Some(exact) = exact else {
        return recipe.outline();
    };
    let mut outline = exact.clone();
    outline.lines.extend(recipe.lines());
    outline
}

/// The aspect ratio with which cells of a kind are packed, so that finished cells have about the ratio `ca`. Packed
/// ellipses become hexagons. By second moments, a hexagon is as long as its ellipse; by bounding boxes, 0.87 times as
/// long. The factor here is between the two.
fn drawn(kind: CellKind, ca: f64) -> f64 {
    if kind == CellKind::Ellipse {
        1.0 + 1.06 * (ca - 1.0)
    } else {
        ca
    }
}

/// The kind of the cells, and the aspect ratio with which they are packed.
pub(super) fn kind(recipe: &Recipe) -> (CellKind, f64) {
    let kind = CellKind::from_word(recipe.choice(keys::KIND)).unwrap_or_default();
    let ca = recipe.number(keys::CA);
    (kind, drawn(kind, ca))
}

pub(super) fn fields(recipe: &Recipe) -> FieldParams {
    let number = |key| recipe.number(key);
    let side = recipe.side();
    let (direction, angle) = match recipe.choice(keys::DIR) {
        "constant" => (Direction::Constant, number(keys::ANGLE)),
        "strokes" => (Direction::Strokes, number(keys::ANGLE)),
        "radial" => (Direction::Spiral, 0.0),
        "circular" => (Direction::Spiral, 90.0),
        "spiral" => (Direction::Spiral, number(keys::FA)),
        "printed" => (Direction::Printed, number(keys::ANGLE)),
        _ => (Direction::Boundary, number(keys::ANGLE)),
    };
    let grading = |factor, reach| Grading {
        factor: number(factor),
        reach: side * number(reach),
    };
    let spots = |spots: Vec<[f64; 4]>| {
        let spot = |[x, y, radius, value]: [f64; 4]| SoftSpot {
            centre: DVec2::new(x, y),
            radius,
            value,
        };
        spots.into_iter().map(spot).collect()
    };
    let (kind, aspect) = kind(recipe);
    let mut aspect_spots = recipe.spots(keys::STRETCH);
    for [.., ratio] in &mut aspect_spots {
        *ratio = drawn(kind, *ratio);
    }
    FieldParams {
        direction,
        angle: angle.to_radians(),
        centre: side * DVec2::new(number(keys::FX), number(keys::FY)),
        power: number(keys::DP) as u32,
        ends: number(keys::ENDS),
        strokes: recipe.polylines(keys::STROKES),
        reach: side * number(keys::REACH),
        kind,
        part_kinds: part_kinds(recipe, kind),
        aspect,
        aspect_grading: grading(keys::CB, keys::CD),
        aspect_spots: spots(aspect_spots),
        size: number(keys::CS),
        linear: DVec2::new(number(keys::GX), number(keys::GY)),
        radial: number(keys::GR),
        size_grading: grading(keys::GB, keys::GD),
        size_spots: spots(recipe.spots(keys::SPOTS)),
        side,
    }
}

fn part_kinds(recipe: &Recipe, kind: CellKind) -> Vec<(DVec2, CellKind)> {
    let seeds = recipe.seeds(keys::PARTS).into_iter();
    let own = |word| CellKind::from_word(word).unwrap_or(kind);
    seeds.map(|(place, word)| (place, own(word))).collect()
}

pub(super) fn packing(recipe: &Recipe) -> PackingParams {
    PackingParams {
        boundary: match recipe.choice(keys::EDGE) {
            "on" => BoundaryCondition::On,
            "open" => BoundaryCondition::Open,
            _ => BoundaryCondition::Wall,
        },
        start: match recipe.choice(keys::START) {
            "quadtree" => Start::Quadtree,
            "random" => Start::Random,
            _ => Start::Stream,
        },
        count: recipe.number(keys::COUNT) as u32,
        given: given(recipe),
        jolt: recipe.number(keys::JOLT),
        integrator: match recipe.choice(keys::MOVE) {
            "rk4" => Integrator::RungeKutta,
            "euler" => Integrator::Euler,
            _ => Integrator::SemiImplicit,
        },
        population: match recipe.choice(keys::POP) {
            "smallest" => Population::Smallest,
            "opposite" => Population::Opposite,
            "off" => Population::Off,
            _ => Population::Slots,
        },
        variance: recipe.number(keys::VS),
        seed: shared::seed(recipe),
        physics: physics(recipe),
    }
}

/// The cells that start at given places, in picture units.
fn given(recipe: &Recipe) -> Vec<GivenCell> {
    let cell = |row: &Vec<i64>| GivenCell {
        centre: points(&row[..2], recipe.side())[0],
        is_held: row[2] == 1,
    };
    recipe.rows(keys::GIVEN).iter().map(cell).collect()
}

/// The constants of the packing. For an optional constant, the row's default stands for `None`: the packing then
/// chooses.
fn physics(recipe: &Recipe) -> Physics {
    let number = |key| recipe.number(key);
    let own = |key: Key| {
        let row = recipe.schema().row(key.0)?;
        Some(number(key)).filter(|value| *value != recipe.default_of(row))
    };
    let mut corners = CornerBubbles::PAPERS;
    corners.weight = own(keys::CW).unwrap_or(corners.weight);
    if let Some(radius) = own(keys::CR) {
        corners = CornerBubbles::new(corners.weight, radius);
    }
    Physics {
        damping: own(keys::DAMP),
        mass: number(keys::MASS),
        stiffness: number(keys::STIFF),
        time_step: own(keys::DT),
        corners,
        crowded: own(keys::CROWD),
        roomy: own(keys::ROOM),
        force_end: number(keys::FEND),
        move_end: number(keys::MEND),
        most_steps: number(keys::MOST) as u32,
        cooling: own(keys::COOL),
    }
}

fn flow(recipe: &Recipe) -> FlowParams {
    let sense = match recipe.choice(keys::FLOW) {
        "strokes" => 1.0,
        "against" => -1.0,
        _ => 0.0,
    };
    FlowParams {
        sense,
        strokes: match sense {
            0.0 => Vec::new(),
            _ => recipe.polylines(keys::STROKES),
        },
    }
}

fn cells(recipe: &Recipe) -> CellParams {
    let scattered = |rounds| CellParams::Scattered {
        rounds,
        seed: shared::seed(recipe),
    };
    match recipe.choice(keys::CELLS) {
        "packed" => CellParams::Packed,
        "voronoi" => scattered(0),
        "lloyd" => scattered(recipe.number(keys::ROUNDS) as u32),
        _ => CellParams::Fitted,
    }
}

pub(super) fn texture(recipe: &Recipe) -> TextureParams {
    TextureParams {
        tile: recipe.is_tile(),
        ..stones::texture(recipe, recipe.number(keys::CS), [1.0, recipe.side()])
    }
}
