//! The generators that a pattern tree may name, and their parameters.

use super::feature::FeatureKind::{self, Corner, Edge, Face};

/// A pattern generator that lays cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum PatternGenerator {
    /// One block for each cell of a face's grid, in one colour for each type of feature (Legakis, Dorsey, Gortler
    /// 2001, section 5.1).
    RgbBlocks,
    /// Running bond (section 5.2, Bricks).
    Bricks,
    /// A row of headers along the bottom of a window (section 5.2, Window Bottom Bricks).
    WindowBottomBricks,
    /// Rows of stones along arches, lintels and jambs (section 5.2, Arch Stones).
    ArchStones,
    /// Rings of bricks along arches (section 5.2, Arch Bricks).
    ArchBricks,
    /// Rectangles of random size on a fine grid (section 5.2, Random Ashlar).
    RandomAshlar,
    /// An inset of herringbone bond or basket weave (section 5.5, fig. 8e).
    Panel,
    /// Three bricks at the top corners of steps, two of them diagonal (section 5.5, fig. 8c).
    StepCorners,
    /// Rough cast stones on steps (section 5.5, fig. 8b).
    CementStones,
    /// Courses of roof tiles that overlap.
    Tiles,
    /// Bricks along the slope of a gable.
    Raking,
    /// Large stones at corners and vertical edges.
    Quoins,
    /// Flat stones along the top of a free-standing wall.
    Coping,
}

/// A numeric parameter of a generator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// Its key in JSON.
    pub key: &'static str,
    /// The least and the greatest value.
    pub range: [f64; 2],
    /// The value where JSON has none.
    pub default: f64,
    /// Whether it must be a whole number.
    pub is_whole: bool,
}

const fn real(key: &'static str, range: [f64; 2], default: f64) -> Parameter {
    Parameter {
        key,
        range,
        default,
        is_whole: false,
    }
}

const fn whole(key: &'static str, range: [f64; 2], default: f64) -> Parameter {
    Parameter {
        key,
        range,
        default,
        is_whole: true,
    }
}

/// The number that cells keep, for their colours.
const TAG: Parameter = whole("tag", [0.0, 15.0], 0.0);
/// How deep cells reach into the wall, in metres; 0 leaves it to the generator.
const DEPTH: Parameter = real("depth", [0.0, 2.0], 0.0);
/// How far cells stand out, in metres.
const EXTRUDE: Parameter = real("extrude", [0.0, 0.2], 0.04);

impl PatternGenerator {
    /// All generators, with their words in JSON.
    pub const ALL: [(Self, &'static str); 13] = [
        (Self::RgbBlocks, "RGBBlocks"),
        (Self::Bricks, "Bricks"),
        (Self::WindowBottomBricks, "WindowBottomBricks"),
        (Self::ArchStones, "ArchStones"),
        (Self::ArchBricks, "ArchBricks"),
        (Self::RandomAshlar, "RandomAshlar"),
        (Self::Panel, "Panel"),
        (Self::StepCorners, "StepCorners"),
        (Self::CementStones, "CementStones"),
        (Self::Tiles, "Tiles"),
        (Self::Raking, "Raking"),
        (Self::Quoins, "Quoins"),
        (Self::Coping, "Coping"),
    ];

    /// The generator with this word.
    pub fn of_word(word: &str) -> Option<Self> {
        let found = Self::ALL.iter().find(|(_, known)| *known == word);
        found.map(|&(generator, _)| generator)
    }

    /// Its word in JSON.
    pub fn word(self) -> &'static str {
        let found = Self::ALL.iter().find(|(generator, _)| *generator == self);
        found.expect("the list has all generators").1
    }

    /// Its numeric parameters.
    pub fn parameters(self) -> &'static [Parameter] {
        match self {
            Self::RgbBlocks => const { &[TAG] },
            Self::Bricks => const { &[TAG, DEPTH] },
            Self::WindowBottomBricks => const { &[EXTRUDE, TAG] },
            // `keystone` is how far the keystone stands over its row (metres); 0 makes none. Jamb stones are `quoin`
            // courses high.
            Self::ArchStones => {
                const {
                    &[
                        real("keystone", [0.0, 1.0], 0.0),
                        whole("quoin", [1.0, 12.0], 3.0),
                        DEPTH,
                        TAG,
                    ]
                }
            }
            Self::ArchBricks => const { &[whole("rings", [1.0, 6.0], 2.0), TAG] },
            Self::RandomAshlar => {
                const {
                    &[
                        whole("most_width", [1.0, 12.0], 4.0),
                        whole("most_height", [1.0, 12.0], 3.0),
                        TAG,
                    ]
                }
            }
            // `width` and `height` are the greatest size, and `margin` is the least distance from the ends of the face,
            // in columns and rows. Bond 0 is herringbone, bond 1 basket weave.
            Self::Panel => {
                const {
                    &[
                        whole("width", [2.0, 200.0], 6.0),
                        whole("height", [2.0, 200.0], 12.0),
                        whole("margin", [1.0, 200.0], 2.0),
                        whole("bond", [0.0, 1.0], 0.0),
                        TAG,
                    ]
                }
            }
            Self::StepCorners => const { &[TAG] },
            // The stones of level edges are about `length` modules long.
            Self::CementStones => {
                const {
                    &[
                        EXTRUDE,
                        whole("length", [1.0, 24.0], 4.0),
                        real("roughness", [0.0, 0.05], 0.006),
                        TAG,
                    ]
                }
            }
            Self::Tiles | Self::Raking | Self::Coping | Self::Quoins => self.added_parameters(),
        }
    }

    /// The parameters of the generators that the paper does not have.
    fn added_parameters(self) -> &'static [Parameter] {
        match self {
            // Each tile covers the share `lap` of the length of the tile below.
            Self::Tiles => {
                const {
                    &[
                        real("length", [0.05, 2.0], 0.3),
                        real("width", [0.05, 2.0], 0.2),
                        real("thickness", [0.002, 0.2], 0.014),
                        real("lap", [0.0, 0.9], 0.5),
                        TAG,
                    ]
                }
            }
            Self::Raking => const { &[EXTRUDE, TAG] },
            // Stones stand over both sides of the wall by `over` (metres).
            Self::Coping => {
                const {
                    &[
                        real("length", [0.05, 3.0], 0.5),
                        real("thickness", [0.01, 0.5], 0.06),
                        real("over", [0.0, 0.2], 0.03),
                        TAG,
                    ]
                }
            }
            Self::Quoins => {
                const {
                    &[
                        whole("courses", [1.0, 12.0], 3.0),
                        whole("long", [1.0, 12.0], 3.0),
                        whole("short", [1.0, 12.0], 2.0),
                        EXTRUDE,
                        TAG,
                    ]
                }
            }
            Self::RgbBlocks
            | Self::Bricks
            | Self::WindowBottomBricks
            | Self::ArchStones
            | Self::ArchBricks
            | Self::RandomAshlar
            | Self::Panel
            | Self::StepCorners
            | Self::CementStones => &[],
        }
    }

    /// Whether it has rows of stones.
    pub fn has_rows(self) -> bool {
        self == Self::ArchStones
    }

    /// The types of features on which it lays cells; others are an error of the tree.
    pub fn expects(self) -> &'static [FeatureKind] {
        match self {
            Self::RgbBlocks | Self::Bricks | Self::RandomAshlar => &[Corner, Edge, Face],
            Self::WindowBottomBricks | Self::CementStones | Self::Quoins => &[Corner, Edge],
            Self::ArchStones | Self::ArchBricks | Self::Raking | Self::Coping => &[Edge],
            Self::Panel => &[Face],
            Self::StepCorners => &[Corner],
            Self::Tiles => &[Edge, Face],
        }
    }
}

/// A row of stones around an arch, from the edge outwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StoneRow {
    /// The size of the row across the edge (metres).
    pub length: f64,
    /// The wanted width of a stone along the edge (metres).
    pub width: f64,
    /// How far the row stands out of the wall (metres).
    pub extrude: f64,
}

impl StoneRow {
    /// The ranges of length, width and extrusion in JSON.
    pub const RANGES: [[f64; 2]; 3] = [[0.01, 3.0], [0.01, 3.0], [0.0, 0.5]];
    /// The most rows of a node.
    pub const MOST: usize = 8;
}

/// A generator with the values of its parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct GeneratorNode {
    /// The generator.
    pub generator: PatternGenerator,
    /// The values of its parameters, in the order of [`PatternGenerator::parameters`].
    pub numbers: Vec<f64>,
    /// Its rows, if it has rows.
    pub rows: Vec<StoneRow>,
}

impl GeneratorNode {
    /// A generator with the default of each number, and with one row of stones if it has rows.
    pub fn new(generator: PatternGenerator) -> Self {
        let row = StoneRow {
            length: 0.25,
            width: 0.125,
            extrude: 0.0,
        };
        Self {
            generator,
            numbers: generator
                .parameters()
                .iter()
                .map(|parameter| parameter.default)
                .collect(),
            rows: generator.has_rows().then_some(row).into_iter().collect(),
        }
    }

    /// A number by its key.
    ///
    /// # Panics
    /// If the generator has no such number.
    pub fn number(&self, key: &str) -> f64 {
        let at = self
            .generator
            .parameters()
            .iter()
            .position(|parameter| parameter.key == key);
        self.numbers[at.expect("a key of the generator")]
    }

    /// A whole number by its key, as [`GeneratorNode::number`].
    pub fn count(&self, key: &str) -> usize {
        self.number(key) as usize
    }
}
