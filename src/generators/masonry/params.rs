//! Turns a recipe into the parameters of each stage.

use super::MASONRY;
use super::colours::{Colours, materials};
use super::schema::keys;
use super::units::unit_of_word;
use crate::building::obj::FileSpace;
use crate::building::{Building, CornerId, DrawnPlan, EdgeId, Module, Rule};
use crate::generators::lighting::LightParams;
use crate::generators::rows::numbered::numbers_of;
use crate::generators::rows::shared;
use crate::generators::scene_picture::{AskedFile, StillParams};
use crate::masonry::laying::LayingParams;
use crate::masonry::module::{ASHLAR, BLOCK, UK_BRICK, US_BRICK};
use crate::masonry::tree::{PRESETS, TreePreset};
use crate::material::{Gloss, WeatherParams};
use crate::recipe::Recipe;

/// Metres in a millimetre.
const MILLI: f64 = 1e-3;

/// The parameters of the stages.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct MasonryParams {
    pub files: Vec<AskedFile>,
    pub building: BuildingParams,
    pub cells: PatternParams,
    pub blocks: BlockParams,
    pub look: LookParams,
    pub still: StillParams,
}

/// The parameters of the building.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct BuildingParams {
    /// The rule and its numbers; `None` for a file.
    pub rule: Option<(Rule, Vec<f64>)>,
    /// The unit and the upright axis of an OBJ file.
    pub space: FileSpace,
    /// The plan and the openings of [`Rule::Plan`].
    pub plan: DrawnPlan,
    pub module: Module,
}

/// The parameters of the pattern and of its cells.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PatternParams {
    /// The pattern tree.
    pub tree: &'static TreePreset,
    pub laying: LayingParams,
    pub flips: Flips,
}

/// Corners and edges whose bricks are turned by hand.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Flips {
    pub corners: Vec<CornerId>,
    pub edges: Vec<EdgeId>,
}

impl Flips {
    /// Reads rows of two numbers: 0 for a corner or 1 for an edge, and its index.
    fn new(rows: &[Vec<i64>]) -> Self {
        let numbers = |kind: i64| {
            let own = rows.iter().filter(move |row| row[0] == kind);
            own.map(|row| row[1] as u32)
        };
        Self {
            corners: numbers(0).map(CornerId).collect(),
            edges: numbers(1).map(EdgeId).collect(),
        }
    }

    /// The number of flips whose corner or edge a building does not have.
    pub fn gone(&self, building: &Building) -> usize {
        let corners = self.corners.iter().map(|id| id.index());
        let edges = self.edges.iter().map(|id| id.index());
        let (of_corners, of_edges) = (building.corners().len(), building.edges().len());
        corners.filter(|&k| k >= of_corners).count() + edges.filter(|&k| k >= of_edges).count()
    }
}

/// The geometry and the colours of blocks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct BlockParams {
    /// How far mortar lies behind the surface (metres).
    pub recess: f64,
    /// The length of a whole block (metres).
    pub length: f64,
    /// Width of chamfers (metres).
    pub chamfer: f64,
    /// Roughness of stones, from 0 (plain) to 1.
    pub rough: f64,
    /// Factor of the random turns and shifts of blocks.
    pub crooked: f64,
    pub colours: Colours,
    pub vary: f64,
    pub seed: u64,
}

/// The ground around the blocks, and the weather on them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LookParams {
    pub weather: WeatherParams,
    /// The word of the ground.
    pub ground: &'static str,
    pub seed: u64,
}

/// The parameters of the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct GroundParams {
    /// The word of the ground.
    pub word: &'static str,
    pub seed: u64,
}

impl LookParams {
    /// The parameters on which the ground's shape depends.
    pub(super) fn ground(&self) -> GroundParams {
        GroundParams {
            word: self.ground,
            seed: self.seed,
        }
    }
}

impl MasonryParams {
    pub fn new(recipe: &Recipe) -> Self {
        let module = module(recipe);
        let rule = Rule::of_word(recipe.choice(keys::BUILDING));
        let light = LightParams {
            shade: shared::shading(recipe),
            materials: materials(Gloss::of_word(recipe.choice(keys::GLOSS))),
        };
        let building = building(recipe, rule, module);
        Self {
            files: match rule {
                Some(_) => Vec::new(),
                None => vec![AskedFile::new(recipe, keys::MODEL, building.space.is_z_up)],
            },
            building,
            cells: PatternParams {
                tree: TreePreset::of_word(recipe.choice(keys::PATTERN)).unwrap_or(&PRESETS[0]),
                laying: LayingParams {
                    module,
                    is_by_hand: recipe.choice(keys::HAND) == "stored",
                    seed: shared::seed(recipe),
                },
                flips: Flips::new(recipe.rows(keys::FLIPS)),
            },
            blocks: blocks(recipe, module),
            look: look(recipe),
            still: StillParams::new(recipe, MASONRY.camera(), light),
        }
    }
}

fn building(recipe: &Recipe, rule: Option<Rule>, module: Module) -> BuildingParams {
    BuildingParams {
        rule: rule.map(|rule| (rule, numbers_of(recipe, keys::BUILDING, rule.word()))),
        space: match rule {
            Some(_) => FileSpace::METRES,
            None => file_space(recipe),
        },
        plan: match rule {
            Some(Rule::Plan) => {
                DrawnPlan::of_rows(recipe.rows(keys::PLAN), recipe.rows(keys::OPENINGS))
            }
            _ => DrawnPlan::default(),
        },
        module,
    }
}

/// The unit and the upright axis of a building's file.
fn file_space(recipe: &Recipe) -> FileSpace {
    FileSpace {
        unit: unit_of_word(recipe.choice(keys::UNIT)),
        is_z_up: recipe.choice(keys::UP) == "z",
    }
}

fn blocks(recipe: &Recipe, module: Module) -> BlockParams {
    BlockParams {
        recess: MILLI * recipe.number(keys::RECESS),
        length: 2.0 * module.half,
        chamfer: MILLI * recipe.number(keys::CHAMFER),
        rough: recipe.number(keys::ROUGH),
        crooked: recipe.number(keys::CROOKED),
        colours: Colours {
            walls: recipe.choice(keys::WALLS),
            dressing: recipe.choice(keys::DRESSING),
            mortar: recipe.choice(keys::MORTAR),
            roof: recipe.choice(keys::ROOF),
        },
        vary: recipe.number(keys::VARY),
        seed: shared::seed(recipe),
    }
}

fn look(recipe: &Recipe) -> LookParams {
    LookParams {
        weather: WeatherParams {
            moss: recipe.number(keys::MOSS),
            wet: recipe.number(keys::DAMP),
            ..WeatherParams::default()
        },
        ground: recipe.choice(keys::GROUND),
        seed: shared::seed(recipe),
    }
}

fn module(recipe: &Recipe) -> Module {
    match recipe.choice(keys::MODULE) {
        "us" => US_BRICK,
        "uk" => UK_BRICK,
        "ashlar" => ASHLAR,
        "cube" => BLOCK,
        "own" => Module {
            half: MILLI * recipe.number(keys::W),
            course: MILLI * recipe.number(keys::H),
            joint: MILLI * recipe.number(keys::JOINT),
        },
        _ => Module::NORMAL,
    }
}
