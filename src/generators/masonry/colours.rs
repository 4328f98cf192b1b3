//! Colours and materials of blocks, by their roles.

use crate::masonry::laying::{CellSort, Feature, MasonryCell};
use crate::masonry::tree::PatternGenerator;
use crate::material::{Gloss, Material};
use crate::random::{Purpose, Random};

/// The row of mortar in the table of materials.
pub(super) const MORTAR_ROW: u8 = 0;
/// The row of bricks.
pub(super) const BRICK_ROW: u8 = 1;
/// The row of stones.
pub(super) const STONE_ROW: u8 = 2;
/// The rows of glass, wood and iron, which carry no masonry.
pub(super) const GLASS_ROW: u8 = 3;
pub(super) const WOOD_ROW: u8 = 4;
pub(super) const IRON_ROW: u8 = 5;
/// The row of moss.
pub(super) const MOSS_ROW: u8 = 6;
/// The rows of the ground: blades of grass, and the soil between them.
pub(super) const GRASS_ROW: u8 = 7;
pub(super) const SOIL_ROW: u8 = 8;

/// The names of the rows in mesh files.
pub(super) const MATERIAL_NAMES: [&str; 9] = [
    "mortar", "brick", "stone", "glass", "wood", "iron", "moss", "grass", "ground",
];

/// Fired clay.
const BRICK: Material = Material::new(1.0, 0.94, 0.05, 9.0);

/// The table of materials, by the rows above. The gloss changes bricks and stones only.
pub(super) fn materials(gloss: Gloss) -> Vec<Material> {
    let own = [
        Material::new(1.0, 0.95, 0.0, 4.0),
        BRICK,
        Material::DRY_STONE,
        Material::GLASS,
        Material::OILED,
        Material::STEEL,
        Material::PADS,
        Material::PADS,
        Material::DRY_STONE,
    ];
    let applied = own.iter().enumerate().map(|(row, material)| match row {
        1 | 2 => gloss.applied_to(*material),
        _ => *material,
    });
    applied.collect()
}

/// The recipe's word for the colour of each role.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Colours {
    pub walls: &'static str,
    pub dressing: &'static str,
    pub mortar: &'static str,
    pub roof: &'static str,
}

/// Colours that blocks of one kind have (sRGB), and how much their tones differ.
struct Range {
    bases: &'static [[u8; 3]],
    tone: f64,
    row: u8,
}

const fn range(bases: &'static [[u8; 3]], tone: f64, row: u8) -> Range {
    Range { bases, tone, row }
}

/// The colours that a word means; red bricks if the word is unknown.
#[rustfmt::skip]
fn of_word(word: &str) -> Range {
    match word {
        "yellow" => range(&[[165, 138, 94], [171, 146, 104], [155, 126, 82], [160, 134, 97]], 0.11, BRICK_ROW),
        "dark" => range(&[[77, 59, 54], [67, 52, 49], [87, 64, 55], [62, 50, 50]], 0.14, BRICK_ROW),
        "white" => range(&[[180, 176, 168], [173, 170, 161], [185, 181, 173]], 0.04, BRICK_ROW),
        "honey" => range(&[[166, 144, 106], [158, 134, 96], [175, 155, 118], [153, 133, 101]], 0.10, STONE_ROW),
        "grey" => range(&[[126, 124, 119], [116, 114, 111], [134, 133, 126], [119, 121, 121]], 0.12, STONE_ROW),
        "slate" => range(&[[74, 78, 86], [66, 70, 78], [82, 84, 90], [78, 76, 82]], 0.10, STONE_ROW),
        "tiles" => range(&[[142, 78, 56], [132, 70, 52], [150, 88, 62], [124, 66, 54], [138, 84, 64]], 0.13, BRICK_ROW),
        "brown" => range(&[[104, 76, 60], [94, 68, 56], [112, 84, 64], [88, 66, 58]], 0.12, BRICK_ROW),
        "stone" => range(&[[142, 132, 112], [130, 122, 106], [150, 140, 118], [124, 118, 108]], 0.12, STONE_ROW),
        "pale" => range(&[[168, 159, 140], [160, 152, 135], [173, 166, 149]], 0.06, STONE_ROW),
        _ => range(&[[133, 69, 50], [124, 60, 45], [141, 77, 55], [119, 62, 50], [134, 72, 60]], 0.14, BRICK_ROW),
    }
}

/// The colours of corners, edges and faces in diagrams, as in figure 3 of the paper.
pub(super) const FEATURES: [[u8; 3]; 3] = [[206, 64, 52], [72, 168, 84], [62, 104, 196]];

/// The type of a feature: 0 for a corner, 1 for an edge, 2 for a face.
pub(super) fn type_of(feature: Feature) -> usize {
    match feature {
        Feature::Corner(_) => 0,
        Feature::Edge(_) => 1,
        Feature::Face(_) => 2,
    }
}

impl Colours {
    /// Whether the wall is of stone.
    pub fn are_stone(&self) -> bool {
        of_word(self.walls).row == STONE_ROW
    }

    /// The colour of the mortar.
    pub fn mortar(&self) -> [u8; 3] {
        match self.mortar {
            "grey" => [146, 142, 136],
            "sand" => [178, 160, 128],
            "dark" => [96, 90, 84],
            _ => [188, 182, 170],
        }
    }

    /// A cell's row of materials.
    pub fn material_of(&self, cell: &MasonryCell) -> u8 {
        match self.walls {
            "parts" => BRICK_ROW,
            _ => of_word(self.word_of(cell)).row,
        }
    }

    /// The word for the colours of a cell.
    fn word_of(&self, cell: &MasonryCell) -> &'static str {
        match (cell.sort, is_dressing(cell) && self.dressing != "same") {
            (CellSort::Tile, _) => self.roof,
            (_, true) => self.dressing,
            (_, false) => self.walls,
        }
    }

    /// The colour of a cell, and its row of materials.
    pub fn of_cell(
        &self,
        cell: &MasonryCell,
        (seed, mark): (u64, u64),
        vary: f64,
    ) -> ([u8; 3], u8) {
        if self.walls == "parts" {
            return (FEATURES[type_of(cell.feature)], BRICK_ROW);
        }
        let range = of_word(self.word_of(cell));
        let mut random = Random::new(seed, Purpose::Paint, mark);
        let base = range.bases[random.below(range.bases.len())];
        let tone = 1.0 + vary * range.tone * random.signed();
        (
            base.map(|v| (f64::from(v) * tone).clamp(0.0, 255.0) as u8),
            range.row,
        )
    }
}

/// Whether a cell belongs to a sill, a lintel, an arch or a quoin.
fn is_dressing(cell: &MasonryCell) -> bool {
    use PatternGenerator::{ArchStones, CementStones, Coping, Quoins, WindowBottomBricks};
    let dresses = [ArchStones, CementStones, Coping, Quoins, WindowBottomBricks];
    cell.tag > 0 || cell.sort == CellSort::Sill || dresses.contains(&cell.generator)
}
