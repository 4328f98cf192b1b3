//! The palettes of stones.

use super::palette::Palette;
use super::phong::{DENSE, DULL, HEWN, POLISHED};

/// The values that most palettes share.
pub(super) const PLAIN: Palette = Palette {
    name: "",
    bases: &[],
    second: [0, 0, 0],
    mark: [74, 70, 66],
    belly: [198, 190, 176],
    flesh: [126, 110, 92],
    tone: 0.13,
    tint: 0.008,
    mottle: 0.06,
    speckle: 0.05,
    bands: 0.0,
    veins: 0.0,
    patches: 0.0,
    relief: 1.0,
    finishes: HEWN,
};

/// Stones; the first is the default palette.
#[rustfmt::skip]
pub(super) const STONES: &[Palette] = &[
    Palette {
        name: "granite",
        bases: &[
            [146, 143, 139], [158, 153, 146], [133, 132, 132], [164, 152, 140], [150, 138, 130],
            [121, 122, 125],
        ],
        tone: 0.12,
        speckle: 0.16,
        mottle: 0.07,
        ..PLAIN
    },
    Palette {
        name: "basalt",
        bases: &[[88, 91, 95], [99, 100, 102], [79, 81, 86], [107, 106, 104], [92, 89, 88]],
        mark: [152, 148, 140],
        belly: [124, 124, 122],
        flesh: [84, 76, 68],
        tone: 0.15,
        speckle: 0.06,
        mottle: 0.07,
        finishes: DENSE,
        ..PLAIN
    },
    Palette {
        name: "sandstone",
        bases: &[
            [178, 152, 116], [186, 163, 130], [166, 138, 105], [172, 141, 116], [156, 134, 109],
            [188, 170, 142],
        ],
        mark: [136, 88, 66],
        belly: [206, 192, 166],
        flesh: [140, 116, 88],
        tone: 0.10,
        speckle: 0.06,
        mottle: 0.08,
        bands: 0.10,
        finishes: DULL,
        ..PLAIN
    },
    Palette {
        name: "terracotta",
        bases: &[
            [156, 98, 74], [164, 110, 84], [144, 88, 70], [168, 122, 98], [132, 84, 70],
            [152, 106, 88],
        ],
        mark: [88, 58, 48],
        belly: [196, 164, 136],
        flesh: [120, 88, 70],
        tone: 0.11,
        speckle: 0.05,
        mottle: 0.08,
        relief: 0.8,
        finishes: DULL,
        ..PLAIN
    },
    Palette {
        name: "marble",
        bases: &[
            [196, 191, 183], [202, 195, 184], [176, 172, 166], [186, 172, 160], [150, 150, 148],
            [178, 156, 145], [124, 130, 125],
        ],
        mark: [98, 96, 96],
        belly: [214, 208, 198],
        flesh: [146, 130, 114],
        second: [120, 116, 114],
        tone: 0.06,
        speckle: 0.01,
        mottle: 0.05,
        veins: 0.55,
        relief: 0.6,
        finishes: POLISHED,
        ..PLAIN
    },
    Palette {
        name: "porphyry",
        bases: &[
            [126, 98, 96], [136, 108, 102], [114, 92, 94], [142, 118, 110], [122, 104, 104],
            [108, 88, 84],
        ],
        mark: [172, 158, 148],
        belly: [166, 140, 130],
        flesh: [104, 86, 78],
        tone: 0.12,
        speckle: 0.10,
        mottle: 0.07,
        finishes: DENSE,
        ..PLAIN
    },
    Palette {
        name: "slate",
        bases: &[
            [98, 104, 110], [88, 95, 102], [108, 111, 113], [103, 102, 107], [95, 101, 98],
            [116, 112, 106],
        ],
        mark: [140, 112, 84],
        belly: [150, 152, 150],
        flesh: [84, 80, 74],
        second: [150, 110, 74],
        tone: 0.13,
        speckle: 0.03,
        mottle: 0.06,
        bands: 0.09,
        patches: 0.18,
        relief: 0.8,
        finishes: DENSE,
        ..PLAIN
    },
    Palette {
        name: "mossy",
        bases: &[
            [132, 128, 118], [120, 118, 112], [142, 134, 120], [112, 110, 104], [128, 118, 104],
        ],
        mark: [70, 80, 42],
        belly: [168, 164, 148],
        flesh: [92, 86, 66],
        second: [94, 104, 52],
        tone: 0.13,
        speckle: 0.10,
        mottle: 0.10,
        patches: 0.62,
        ..PLAIN
    },
    Palette {
        name: "limestone",
        bases: &[
            [178, 170, 153], [170, 160, 142], [184, 178, 164], [160, 154, 142], [172, 160, 138],
        ],
        mark: [122, 98, 74],
        belly: [206, 200, 184],
        flesh: [142, 126, 104],
        second: [160, 144, 118],
        tone: 0.08,
        speckle: 0.04,
        mottle: 0.07,
        patches: 0.2,
        finishes: HEWN,
        ..PLAIN
    },
];
