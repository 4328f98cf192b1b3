//! The components by rule, and their constants.

use super::shell::Shell;
use super::variant::Vary;
use super::{fruit, grain, hardware, leaf, round};

/// A component by rule. Half of its length is about 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ComponentKind {
    /// A ball with a painted band.
    Ball,
    /// A pebble of a river, still a little angular.
    Pebble,
    /// A pebble of a beach.
    SmoothPebble,
    /// A grain of rice with the notch of its germ.
    Rice,
    /// A chestnut with its pale base and its tip.
    Chestnut,
    /// A hexagonal nut with a threaded bore.
    Nut,
    /// A hexagonal bolt with its thread.
    Bolt,
    /// A ring.
    Torus,
    /// A block with rounded edges.
    Box,
    /// A kidney bean with its scar.
    Bean,
    /// A curled cashew.
    Cashew,
    /// A serrated leaf with veins and a stalk.
    Leaf,
    /// An orange with a dimpled stalk end.
    Orange,
    /// An apple with its stalk.
    Apple,
    /// A furrowed almond.
    Almond,
    /// A walnut in its shell.
    Walnut,
    /// A gear with a bore.
    Gear,
}

/// The constants of a kind.
pub(super) struct Traits {
    pub word: &'static str,
    /// An edge is sharp if the cosine between the normals of its triangles is below this.
    pub crease: f64,
    /// The most inner spheres.
    pub spheres: usize,
    /// The strength of its variants.
    pub vary: Vary,
}

/// The cosine of the angle of a sharp edge of hardware.
const SHARP: f64 = 0.85;
/// No edge is sharp.
const ROUND: f64 = -1.0;

impl ComponentKind {
    /// All kinds.
    pub const ALL: [Self; 17] = [
        Self::Ball,
        Self::Pebble,
        Self::SmoothPebble,
        Self::Rice,
        Self::Chestnut,
        Self::Nut,
        Self::Bolt,
        Self::Torus,
        Self::Box,
        Self::Bean,
        Self::Cashew,
        Self::Leaf,
        Self::Orange,
        Self::Apple,
        Self::Almond,
        Self::Walnut,
        Self::Gear,
    ];

    /// The word of the kind in links.
    pub fn word(self) -> &'static str {
        self.traits().word
    }

    /// The kind with this word.
    pub fn of_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.word() == word)
    }

    pub(super) fn traits(self) -> Traits {
        let traits = |word, crease, spheres, vary| Traits {
            word,
            crease,
            spheres,
            vary,
        };
        match self {
            Self::Ball => traits("ball", ROUND, 8, Vary::TOY),
            Self::Pebble => traits("pebble", ROUND, 24, Vary::STONE),
            Self::SmoothPebble => traits("smooth", ROUND, 24, Vary::STONE),
            Self::Rice => traits("rice", ROUND, 24, Vary::GRAIN),
            Self::Chestnut => traits("chestnut", ROUND, 24, Vary::FRUIT),
            Self::Nut => traits("nut", SHARP, 48, Vary::METAL),
            Self::Bolt => traits("bolt", SHARP, 48, Vary::METAL),
            Self::Torus => traits("torus", ROUND, 24, Vary::TOY),
            Self::Box => traits("box", ROUND, 48, Vary::TOY),
            Self::Bean => traits("bean", ROUND, 32, Vary::GRAIN),
            Self::Cashew => traits("cashew", ROUND, 32, Vary::GRAIN),
            Self::Leaf => traits("leaf", ROUND, 80, Vary::LEAF),
            Self::Orange => traits("orange", ROUND, 8, Vary::FRUIT),
            Self::Apple => traits("apple", 0.3, 24, Vary::FRUIT),
            Self::Almond => traits("almond", ROUND, 24, Vary::GRAIN),
            Self::Walnut => traits("walnut", ROUND, 16, Vary::FRUIT),
            Self::Gear => traits("gear", SHARP, 64, Vary::METAL),
        }
    }

    /// The surface by rule for a level of detail, 0 to 2. Many kinds have one surface, which is then simplified.
    pub(super) fn shell(self, level: usize) -> Shell {
        match self {
            Self::Ball => round::ball(level),
            Self::Pebble => round::pebble(),
            Self::SmoothPebble => round::smooth_pebble(),
            Self::Rice => grain::rice(),
            Self::Chestnut => fruit::chestnut(),
            Self::Nut => hardware::nut(level == 0),
            Self::Bolt => hardware::bolt(level == 0),
            Self::Torus => round::torus(),
            Self::Box => round::block(),
            Self::Bean => grain::bean(),
            Self::Cashew => grain::cashew(),
            Self::Leaf => leaf::leaf(level),
            Self::Orange => fruit::orange(),
            Self::Apple => fruit::apple(),
            Self::Almond => grain::almond(),
            Self::Walnut => fruit::walnut(),
            Self::Gear => hardware::gear(),
        }
    }
}
