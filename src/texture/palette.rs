//! What stones and ground are made of: colours, patterns, optical attributes.
//!
//! Miyata, Itoh, Shimada (2000), section 5.4: a table given in advance, from which a random number
//! draws for each stone. Colours are sRGB as one would pick them from a photograph taken in even
//! light; amounts are parts of the colour's own lightness.

/// Phong's optical attributes (section 3.2 of the paper: A, D, S, N).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Optics {
    /// Part of the light of the sky given back, 0..1 (A).
    pub ambient: f32,
    /// Part of the lamp's light scattered, 0..1 (D).
    pub diffuse: f32,
    /// Part of the lamp's light mirrored, 0..1 (S).
    pub specular: f32,
    /// Exponent of the highlight, 1..200 (N).
    pub shininess: f32,
}

/// Finishes a stone may have; each palette has so many optical attributes.
pub const FINISHES: usize = 3;

/// A kind of stone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Palette {
    /// The word of the link.
    pub name: &'static str,
    /// Colours drawn per stone, all equally likely: name one twice to see it twice as often.
    pub bases: &'static [[u8; 3]],
    /// Colour of veins, lichen or moss.
    pub second: [u8; 3],
    /// Deviation of lightness between stones.
    pub tone: f32,
    /// Deviation of warmth between stones.
    pub tint: f32,
    /// Blotches within a stone.
    pub mottle: f32,
    /// Mineral grains within a stone.
    pub speckle: f32,
    /// Bands along the stone, as in sandstone and slate.
    pub bands: f32,
    /// Veins of the second colour, 0..1.
    pub veins: f32,
    /// Patches of the second colour, 0..1: moss, lichen, rust.
    pub patches: f32,
    /// Scale of the relief the recipe asks for: sawn stone is smoother than hewn.
    pub relief: f32,
    /// From rough to smooth.
    pub optics: [Optics; FINISHES],
}

/// What lies between the stones and around the pavement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground {
    /// The word of the link.
    pub name: &'static str,
    /// Its two colours, mixed in patches.
    pub colours: [[u8; 3]; 2],
    /// Lightness of single grains.
    pub speckle: f32,
    /// Height of single grains, in pixels.
    pub grain: f32,
    /// Height of unevenness, part of the joints' depth.
    pub swell: f32,
    /// Share of the places for a pebble that have one.
    pub pebbles: f32,
    /// Colour of pebbles.
    pub pebble: [u8; 3],
    /// How the ground gives back light.
    pub optics: Optics,
}

const fn optics(ambient: f32, diffuse: f32, specular: f32, shininess: f32) -> Optics {
    Optics {
        ambient,
        diffuse,
        specular,
        shininess,
    }
}

/// Hewn faces, worn ones, and ones polished by feet.
const HEWN: [Optics; FINISHES] = [
    optics(1.0, 0.96, 0.03, 6.0),
    optics(1.0, 0.95, 0.06, 10.0),
    optics(1.0, 0.93, 0.10, 16.0),
];

/// Dense stone that takes a sheen.
const DENSE: [Optics; FINISHES] = [
    optics(1.0, 0.95, 0.07, 9.0),
    optics(1.0, 0.93, 0.13, 16.0),
    optics(1.0, 0.92, 0.20, 26.0),
];

/// Sawn and polished.
const POLISHED: [Optics; FINISHES] = [
    optics(1.0, 0.92, 0.14, 22.0),
    optics(1.0, 0.90, 0.22, 34.0),
    optics(1.0, 0.90, 0.28, 48.0),
];

/// Powdery: brick, sandstone.
const DULL: [Optics; FINISHES] = [
    optics(1.0, 1.0, 0.01, 4.0),
    optics(1.0, 0.98, 0.03, 6.0),
    optics(1.0, 0.97, 0.05, 9.0),
];

const PLAIN: Palette = Palette {
    name: "",
    bases: &[],
    second: [0, 0, 0],
    tone: 0.13,
    tint: 0.008,
    mottle: 0.06,
    speckle: 0.05,
    bands: 0.0,
    veins: 0.0,
    patches: 0.0,
    relief: 1.0,
    optics: HEWN,
};

/// All palettes; the first is the default.
pub const PALETTES: &[Palette] = &[
    Palette {
        name: "granite",
        bases: &[
            [146, 143, 139],
            [158, 153, 146],
            [133, 132, 132],
            [164, 152, 140],
            [150, 138, 130],
            [121, 122, 125],
        ],
        tone: 0.12,
        speckle: 0.16,
        mottle: 0.07,
        ..PLAIN
    },
    Palette {
        name: "basalt",
        bases: &[
            [88, 91, 95],
            [99, 100, 102],
            [79, 81, 86],
            [107, 106, 104],
            [92, 89, 88],
        ],
        tone: 0.15,
        speckle: 0.06,
        mottle: 0.07,
        optics: DENSE,
        ..PLAIN
    },
    Palette {
        name: "sandstone",
        bases: &[
            [178, 152, 116],
            [186, 163, 130],
            [166, 138, 105],
            [172, 141, 116],
            [156, 134, 109],
            [188, 170, 142],
        ],
        tone: 0.10,
        speckle: 0.06,
        mottle: 0.08,
        bands: 0.10,
        optics: DULL,
        ..PLAIN
    },
    Palette {
        name: "terracotta",
        bases: &[
            [156, 98, 74],
            [164, 110, 84],
            [144, 88, 70],
            [168, 122, 98],
            [132, 84, 70],
            [152, 106, 88],
        ],
        tone: 0.11,
        speckle: 0.05,
        mottle: 0.08,
        relief: 0.8,
        optics: DULL,
        ..PLAIN
    },
    Palette {
        name: "marble",
        bases: &[
            [196, 191, 183],
            [202, 195, 184],
            [176, 172, 166],
            [186, 172, 160],
            [150, 150, 148],
            [178, 156, 145],
            [124, 130, 125],
        ],
        second: [120, 116, 114],
        tone: 0.06,
        speckle: 0.01,
        mottle: 0.05,
        veins: 0.55,
        relief: 0.6,
        optics: POLISHED,
        ..PLAIN
    },
    Palette {
        name: "porphyry",
        bases: &[
            [126, 98, 96],
            [136, 108, 102],
            [114, 92, 94],
            [142, 118, 110],
            [122, 104, 104],
            [108, 88, 84],
        ],
        tone: 0.12,
        speckle: 0.10,
        mottle: 0.07,
        optics: DENSE,
        ..PLAIN
    },
    Palette {
        name: "slate",
        bases: &[
            [98, 104, 110],
            [88, 95, 102],
            [108, 111, 113],
            [103, 102, 107],
            [95, 101, 98],
            [116, 112, 106],
        ],
        second: [150, 110, 74],
        tone: 0.13,
        speckle: 0.03,
        mottle: 0.06,
        bands: 0.09,
        patches: 0.18,
        relief: 0.8,
        optics: DENSE,
        ..PLAIN
    },
    Palette {
        name: "mossy",
        bases: &[
            [132, 128, 118],
            [120, 118, 112],
            [142, 134, 120],
            [112, 110, 104],
            [128, 118, 104],
        ],
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
            [178, 170, 153],
            [170, 160, 142],
            [184, 178, 164],
            [160, 154, 142],
            [172, 160, 138],
        ],
        second: [160, 144, 118],
        tone: 0.08,
        speckle: 0.04,
        mottle: 0.07,
        patches: 0.2,
        optics: HEWN,
        ..PLAIN
    },
];

/// All grounds; the first is the default.
pub const GROUNDS: &[Ground] = &[
    Ground {
        name: "sand",
        colours: [[152, 138, 115], [112, 98, 79]],
        speckle: 0.10,
        grain: 0.16,
        swell: 0.16,
        pebbles: 0.24,
        pebble: [150, 142, 130],
        optics: EARTH,
    },
    Ground {
        name: "soil",
        colours: [[96, 80, 62], [72, 60, 47]],
        speckle: 0.13,
        grain: 0.28,
        swell: 0.12,
        pebbles: 0.22,
        pebble: [112, 102, 90],
        optics: EARTH,
    },
    Ground {
        name: "mortar",
        colours: [[158, 154, 145], [145, 140, 131]],
        speckle: 0.05,
        grain: 0.10,
        swell: 0.05,
        pebbles: 0.05,
        pebble: [140, 136, 128],
        optics: EARTH,
    },
    Ground {
        name: "dark",
        colours: [[60, 58, 56], [47, 46, 45]],
        speckle: 0.11,
        grain: 0.22,
        swell: 0.08,
        pebbles: 0.30,
        pebble: [78, 76, 74],
        optics: EARTH,
    },
    Ground {
        name: "moss",
        colours: [[88, 98, 48], [62, 74, 36]],
        speckle: 0.20,
        grain: 0.42,
        swell: 0.24,
        pebbles: 0.0,
        pebble: [90, 90, 70],
        optics: EARTH,
    },
    Ground {
        name: "gravel",
        colours: [[134, 128, 120], [112, 107, 100]],
        speckle: 0.12,
        grain: 0.22,
        swell: 0.06,
        pebbles: 0.92,
        pebble: [146, 140, 132],
        optics: EARTH,
    },
];

/// Earth does not shine.
const EARTH: Optics = optics(1.0, 1.0, 0.0, 4.0);

/// The palette of that name, the default where there is none.
pub fn palette(name: &str) -> &'static Palette {
    let found = PALETTES.iter().find(|p| p.name == name);
    found.unwrap_or(&PALETTES[0])
}

/// The ground of that name, the default where there is none.
pub fn ground(name: &str) -> &'static Ground {
    let found = GROUNDS.iter().find(|g| g.name == name);
    found.unwrap_or(&GROUNDS[0])
}

/// The table that [`super::Planes::optics`] indexes: the ground first, then the palette's finishes.
pub fn optics_table(palette_name: &str, ground_name: &str) -> Vec<Optics> {
    let mut table = vec![ground(ground_name).optics];
    table.extend(palette(palette_name).optics);
    table
}
