//! The table of finishes, and the one that each kind has by default.

use super::paint::{Finish, PartColour, Texture};
use super::{ComponentKind, Part};
use crate::material::Material;

/// The finish of toys, whose band and edges are white.
const TOY: Finish = Finish {
    word: "",
    label: "",
    bases: &[],
    tone: 0.03,
    tint: 0.02,
    parts: &[(Part::Cap, [246, 242, 230])],
    dark: [0.86, 0.86, 0.86],
    light: [1.06, 1.06, 1.06],
    body: Material::WAXED,
    rest: Material::WAXED,
    texture: Texture::None,
};

/// The finish of stones, which may have a vein of quartz.
const STONE: Finish = Finish {
    tone: 0.16,
    tint: 0.02,
    parts: &[(Part::Vein, [226, 220, 208]), (Part::Cap, [206, 200, 188])],
    dark: [0.70, 0.67, 0.63],
    light: [1.22, 1.20, 1.16],
    body: Material::DRY_STONE,
    rest: Material::DRY_STONE,
    texture: Texture::Grains {
        speckle: 0.10,
        height: 0.3,
    },
    ..TOY
};

/// The finish of metals. Grooves of a thread are dark, edges are worn bright.
const METAL: Finish = Finish {
    tone: 0.05,
    tint: 0.015,
    parts: &[],
    dark: [0.30, 0.28, 0.27],
    light: [1.25, 1.25, 1.25],
    body: Material::TURNED,
    rest: Material::TURNED,
    texture: Texture::Brushed,
    ..TOY
};

/// The finish of kernels, fruit and leaves.
const GROWN: Finish = Finish {
    tone: 0.08,
    tint: 0.03,
    parts: &[],
    dark: [0.66, 0.60, 0.52],
    light: [1.16, 1.14, 1.10],
    body: Material::OILED,
    rest: Material::OILED,
    texture: Texture::None,
    ..TOY
};

/// Glass that sand and sea have ground: its skin is dull, and light goes through.
const FROSTED: Material = Material {
    mirror: 0.35,
    thin: 0.5,
    ..Material::new(1.12, 0.72, 0.2, 14.0)
};

/// The colour of the button and the stalk of apples.
const WOODY: [u8; 3] = [104, 76, 46];
const ORANGE_PARTS: &[PartColour] = &[
    (Part::Stalk, [112, 122, 52]),
    (Part::Tip, [236, 148, 40]),
    (Part::Vein, [250, 232, 200]),
];

/// All finishes.
#[rustfmt::skip]
pub const FINISHES: &[Finish] = &[
    Finish {
        word: "rice",
        label: "Rice",
        bases: &[[218, 207, 180], [224, 215, 192], [212, 199, 170]],
        tone: 0.03,
        tint: 0.01,
        parts: &[(Part::Tip, [184, 154, 106])],
        dark: [0.80, 0.75, 0.66],
        light: [1.05, 1.05, 1.05],
        body: Material::DAMP_RICE,
        rest: Material::DAMP_RICE,
        texture: Texture::Fibres,
    },
    Finish {
        word: "chestnut",
        label: "Chestnut",
        bases: &[[98, 45, 23], [110, 54, 27], [86, 38, 20], [92, 40, 25]],
        tone: 0.10,
        parts: &[(Part::Cap, [206, 174, 128]), (Part::Tip, [190, 156, 112])],
        dark: [0.52, 0.46, 0.42],
        light: [1.30, 1.22, 1.14],
        body: Material::LACQUER,
        rest: Material::DRY_STONE,
        texture: Texture::Fibres,
        ..GROWN
    },
    Finish {
        word: "river",
        label: "River pebbles",
        bases: &[
            [142, 134, 122], [120, 116, 110], [156, 144, 124], [128, 112, 96], [108, 112, 112],
            [150, 132, 112], [134, 135, 132],
        ],
        tone: 0.14,
        body: Material::WET_STONE,
        rest: Material::WET_STONE,
        ..STONE
    },
    Finish {
        word: "basalt",
        label: "Basalt",
        bases: &[[72, 74, 78], [60, 62, 66], [84, 84, 84], [70, 68, 66]],
        dark: [0.82, 0.82, 0.82],
        light: [1.20, 1.20, 1.20],
        ..STONE
    },
    Finish {
        word: "quartz",
        label: "Quartz pebbles",
        bases: &[[206, 198, 182], [196, 188, 176], [212, 204, 192], [204, 180, 158], [188, 186, 182]],
        tone: 0.06,
        parts: &[(Part::Vein, [196, 160, 124])],
        dark: [0.88, 0.84, 0.78],
        light: [1.05, 1.05, 1.05],
        body: Material { thin: 0.1, ..Material::WET_STONE },
        rest: Material::WET_STONE,
        ..STONE
    },
    Finish {
        word: "brass",
        label: "Brass",
        bases: &[[206, 160, 76], [196, 150, 68]],
        parts: &[(Part::Edge, [234, 196, 116])],
        body: Material::BRASS,
        rest: Material::BRASS,
        ..METAL
    },
    Finish {
        word: "steel",
        label: "Steel",
        bases: &[[164, 168, 174], [154, 158, 165], [172, 172, 173]],
        parts: &[(Part::Edge, [196, 200, 206])],
        ..METAL
    },
    Finish {
        word: "copper",
        label: "Copper",
        bases: &[[176, 94, 62], [168, 88, 56], [160, 84, 60]],
        parts: &[(Part::Edge, [208, 130, 94])],
        ..METAL
    },
    Finish {
        word: "wood",
        label: "Wood",
        bases: &[[206, 160, 104], [214, 170, 116], [194, 146, 92], [200, 150, 100]],
        tone: 0.07,
        parts: &[(Part::Edge, [222, 180, 126]), (Part::Cap, [166, 58, 44])],
        dark: [0.84, 0.78, 0.70],
        light: [1.05, 1.05, 1.04],
        texture: Texture::Wood,
        ..GROWN
    },
    Finish {
        word: "walnut",
        label: "Dark wood",
        bases: &[[104, 68, 44], [94, 60, 38], [114, 77, 50], [98, 64, 44]],
        tone: 0.07,
        parts: &[(Part::Edge, [124, 84, 56]), (Part::Cap, [206, 160, 104])],
        dark: [0.74, 0.68, 0.62],
        light: [1.12, 1.10, 1.08],
        texture: Texture::Wood,
        ..GROWN
    },
    Finish {
        word: "nutshell",
        label: "Walnut shells",
        bases: &[[164, 126, 88], [154, 116, 79], [172, 136, 98], [148, 110, 76]],
        parts: &[(Part::Edge, [182, 146, 106])],
        dark: [0.56, 0.50, 0.44],
        light: [1.14, 1.13, 1.10],
        texture: Texture::Fibres,
        ..GROWN
    },
    Finish {
        word: "bean",
        label: "Kidney beans",
        bases: &[[92, 20, 22], [80, 17, 22], [106, 26, 25], [86, 22, 19]],
        parts: &[(Part::Vein, [232, 218, 196]), (Part::Edge, [40, 8, 11])],
        dark: [0.84, 0.80, 0.80],
        light: [1.14, 1.14, 1.14],
        body: Material::LACQUER,
        ..GROWN
    },
    Finish {
        word: "blackbean",
        label: "Black beans",
        bases: &[[44, 40, 46], [52, 44, 48], [38, 38, 44]],
        parts: &[(Part::Vein, [226, 220, 208]), (Part::Edge, [18, 16, 20])],
        body: Material::LACQUER,
        ..GROWN
    },
    Finish {
        word: "cashew",
        label: "Cashews",
        bases: &[[226, 192, 140], [232, 204, 156], [216, 178, 124], [222, 184, 130]],
        tone: 0.05,
        parts: &[(Part::Tip, [204, 156, 98])],
        dark: [0.76, 0.68, 0.56],
        light: [1.07, 1.07, 1.07],
        ..GROWN
    },
    Finish {
        word: "almond",
        label: "Almonds",
        bases: &[[144, 90, 52], [134, 82, 46], [154, 100, 60], [126, 77, 44]],
        parts: &[(Part::Tip, [88, 52, 29])],
        dark: [0.66, 0.58, 0.50],
        light: [1.22, 1.20, 1.16],
        texture: Texture::Fibres,
        ..GROWN
    },
    Finish {
        word: "leaf",
        label: "Autumn leaves",
        bases: &[
            [222, 172, 44], [206, 112, 30], [142, 34, 24], [190, 168, 52], [196, 80, 28],
            [176, 116, 44], [170, 50, 28], [214, 148, 36],
        ],
        tint: 0.06,
        parts: &[(Part::Vein, [228, 188, 94]), (Part::Stalk, [176, 118, 56])],
        dark: [0.72, 0.60, 0.52],
        light: [1.10, 1.16, 1.10],
        body: Material::LEAF,
        rest: Material::LEAF,
        texture: Texture::Fibres,
        ..GROWN
    },
    Finish {
        word: "greenleaf",
        label: "Green leaves",
        bases: &[[84, 132, 48], [98, 146, 56], [72, 118, 46], [112, 150, 60]],
        tint: 0.05,
        parts: &[(Part::Vein, [176, 200, 118]), (Part::Stalk, [146, 150, 78])],
        dark: [0.76, 0.78, 0.70],
        light: [1.14, 1.12, 1.06],
        body: Material::LEAF,
        rest: Material::LEAF,
        texture: Texture::Fibres,
        ..GROWN
    },
    Finish {
        word: "orange",
        label: "Orange",
        bases: &[[238, 134, 26], [242, 144, 34], [232, 122, 20]],
        tone: 0.04,
        tint: 0.02,
        parts: ORANGE_PARTS,
        dark: [0.90, 0.80, 0.70],
        light: [1.04, 1.08, 1.16],
        body: Material::WAXED,
        texture: Texture::Pores,
        ..GROWN
    },
    Finish {
        word: "apple",
        label: "Red apples",
        bases: &[[150, 24, 29], [164, 34, 32], [138, 20, 29], [172, 48, 36]],
        tone: 0.06,
        parts: &[(Part::Tip, [222, 184, 74]), (Part::Stalk, WOODY)],
        dark: [0.74, 0.62, 0.62],
        light: [1.14, 1.50, 1.20],
        body: Material::WAXED,
        ..GROWN
    },
    Finish {
        word: "greenapple",
        label: "Green apples",
        bases: &[[148, 178, 62], [160, 188, 70], [138, 168, 56]],
        tone: 0.05,
        parts: &[(Part::Tip, [196, 196, 100]), (Part::Stalk, WOODY)],
        dark: [0.90, 0.92, 0.86],
        light: [1.08, 1.06, 1.10],
        body: Material::WAXED,
        ..GROWN
    },
    Finish {
        word: "red",
        label: "Red paint",
        bases: &[[196, 44, 38]],
        ..TOY
    },
    Finish {
        word: "blue",
        label: "Blue paint",
        bases: &[[44, 98, 172]],
        ..TOY
    },
    Finish {
        word: "yellow",
        label: "Yellow paint",
        bases: &[[238, 190, 50]],
        parts: &[(Part::Cap, [196, 44, 38])],
        ..TOY
    },
    Finish {
        word: "white",
        label: "White paint",
        bases: &[[236, 234, 228]],
        parts: &[(Part::Cap, [44, 98, 172])],
        ..TOY
    },
    Finish {
        word: "toys",
        label: "Paints of many colours",
        bases: &[[196, 44, 38], [44, 98, 172], [234, 184, 46], [58, 138, 70], [226, 112, 36], [112, 66, 138]],
        ..TOY
    },
    Finish {
        word: "ivory",
        label: "Ivory",
        bases: &[[234, 222, 192], [238, 228, 202], [226, 212, 180]],
        parts: &[(Part::Vein, [186, 158, 116]), (Part::Cap, [124, 46, 36]), (Part::Edge, [206, 186, 148])],
        dark: [0.92, 0.88, 0.82],
        light: [1.03, 1.03, 1.03],
        body: Material { thin: 0.1, ..Material::WAXED },
        ..TOY
    },
    Finish {
        word: "clay",
        label: "Terracotta",
        bases: &[[186, 104, 72], [178, 96, 66], [194, 114, 82]],
        tone: 0.07,
        parts: &[(Part::Cap, [226, 202, 168]), (Part::Vein, [214, 176, 138])],
        dark: [0.80, 0.76, 0.74],
        light: [1.10, 1.10, 1.10],
        ..STONE
    },
    Finish {
        word: "glass",
        label: "Glass",
        bases: &[[116, 186, 158], [138, 190, 208], [190, 134, 72], [218, 226, 220], [76, 116, 186]],
        parts: &[(Part::Cap, [240, 240, 236])],
        dark: [0.94, 0.94, 0.94],
        light: [1.05, 1.05, 1.05],
        body: FROSTED,
        rest: FROSTED,
        ..TOY
    },
];

impl Finish {
    /// The finish with this word.
    pub fn of_word(word: &str) -> Option<&'static Self> {
        FINISHES.iter().find(|finish| finish.word == word)
    }
}

impl ComponentKind {
    /// The finish that bodies of this kind have by default.
    pub fn finish(self) -> &'static Finish {
        let word = match self {
            Self::Ball => "red",
            Self::Pebble => "river",
            Self::SmoothPebble => "quartz",
            Self::Rice => "rice",
            Self::Chestnut => "chestnut",
            Self::Nut => "brass",
            Self::Bolt | Self::Gear => "steel",
            Self::Torus => "blue",
            Self::Box => "wood",
            Self::Bean => "bean",
            Self::Cashew => "cashew",
            Self::Leaf => "leaf",
            Self::Orange => "orange",
            Self::Apple => "apple",
            Self::Almond => "almond",
            Self::Walnut => "nutshell",
        };
        Finish::of_word(word).unwrap_or(&FINISHES[0])
    }
}
