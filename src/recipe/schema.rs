//! The one table of parameters. The link, the controls of the page, clamping and presets all read
//! it: a new parameter is one row.

use super::parameter::{Choice, Parameter, choice, int, number, text};

macro_rules! choices {
    ($($word:ident: $label:literal),* $(,)?) => {
        &[$(Choice { word: stringify!($word), label: $label }),*]
    };
}

/// Makes [`Key`] and [`SCHEMA`] from the same rows, so that `SCHEMA[key as usize]` is the key's row.
macro_rules! parameters {
    ($($key:ident: $help:literal, $row:expr;)*) => {
        /// Names a row of [`SCHEMA`].
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Key { $(#[doc = $help] $key),* }

        impl Key {
            /// All keys in the order of the schema.
            pub const ALL: &[Key] = &[$(Key::$key),*];
        }

        /// All parameters, in the order of the pipeline.
        pub const SCHEMA: &[Parameter] = &[$($row.help($help)),*];
    };
}

parameters! {
    Outline: "The shape of the area to pave.",
        choice("outline", "Outline", choices![
            annulus: "Ring", road_s: "S-curve", road_straight: "Straight road",
            road_spiral: "Spiral", y_fork: "Fork", crossing: "Crossing",
            plaza: "Plaza with holes", road_notch: "Cut-out road", l_shape: "L", star: "Star",
            square: "Square", polygon: "Free polygon",
        ]).group("Outline").only_for(Key::Tile, &["0"]);
    Poly: "The free polygon's points, as compact text; draw it or load it from a file instead.",
        text("poly", "Points").group("Outline").only_for(Key::Outline, &["polygon"]);
    Lines: "Constraint lines inside the outline: cells line up along both sides of them.",
        text("lines", "Lines").group("Outline");
    Tile: "Makes the whole picture a tile that repeats without a seam; the outline does not count.",
        choice("tile", "Area", &[
            Choice { word: "0", label: "Outline" }, Choice { word: "1", label: "Seamless tile" },
        ]).group("Outline");
    Size: "Side of the square picture; the outline grows with it, the stones do not.",
        int("size", "", "Picture side").range(128.0, 2048.0, 64.0, 512.0).unit("px")
            .group("Outline");
    Ow: "Width of the paved way, as a factor of the shape's own.",
        number("ow", "", "Width").range(0.3, 1.7, 0.05, 1.0).group("Outline")
            .only_for(Key::Outline, BUILT_IN);
    On: "Number of bends, turns, arms, holes, notches or points; 0 takes the shape's own.",
        int("on", "", "Number").range(0.0, 12.0, 1.0, 0.0).group("Outline")
            .only_for(Key::Outline, COUNTED);
    Oa: "Turns the shape clockwise; it always fills the picture.",
        number("oa", "", "Turn").range(-180.0, 180.0, 1.0, 0.0).unit("°").group("Outline")
            .only_for(Key::Outline, BUILT_IN);

    Kind: "Shape of the packed cells: squares and rectangles in rows, circles and ellipses like honeycombs.",
        choice("kind", "Kind", choices![
            square: "Square", rectangle: "Rectangle", circle: "Circle", ellipse: "Ellipse",
        ]).group("Cells");
    Parts: "Kinds of the parts that lines cut the outline into.",
        text("parts", "Kinds of parts").group("Cells").only_with(Key::Lines);
    Ca: "Length of a cell along the direction over its width.",
        number("ca", "Ca", "Aspect ratio").range(1.0, 5.0, 0.05, 2.0).group("Cells")
            .only_for(Key::Kind, STRETCHED);
    Cb: "Factor of the aspect ratio on the boundary; inwards it goes over to the plain one.",
        number("cb", "", "Aspect at the boundary").range(0.2, 5.0, 0.05, 1.0).group("Cells")
            .only_for(Key::Kind, STRETCHED);
    Cd: "How far from the boundary the aspect ratio changes, in picture sides.",
        number("cd", "", "Aspect reach").range(0.02, 1.0, 0.01, 0.25).group("Cells")
            .only_with(Key::Cb);
    Stretch: "Soft spots with an aspect ratio of their own.",
        text("stretch", "Aspect spots").group("Cells").only_for(Key::Kind, STRETCHED);
    Cs: "Average side of a cell.",
        number("cs", "Cs", "Cell size").range(2.0, 256.0, 1.0, 23.0).unit("px")
            .group("Size");
    Gx: "Makes cells grow from left to right (or shrink, below 0); on a tile a wave.",
        number("gx", "", "Size gradient x").range(-0.8, 0.8, 0.05, 0.0).group("Size");
    Gy: "Makes cells grow from top to bottom (or shrink, below 0); on a tile a wave.",
        number("gy", "", "Size gradient y").range(-0.8, 0.8, 0.05, 0.0).group("Size");
    Gr: "Makes cells grow from the picture's centre outwards (or shrink, below 0).",
        number("gr", "", "Size gradient radial").range(-0.8, 0.8, 0.05, 0.0).group("Size");
    Gb: "Factor of the size on the boundary; inwards it goes over to the plain one.",
        number("gb", "", "Size at the boundary").range(0.2, 3.0, 0.05, 1.0).group("Size");
    Gd: "How far from the boundary the size changes, in picture sides.",
        number("gd", "", "Size reach").range(0.02, 1.0, 0.01, 0.25).group("Size")
            .only_with(Key::Gb);
    Spots: "Soft spots of larger or smaller cells.",
        text("spots", "Size spots").group("Size");
    Dir: "What the rows of cells follow: the boundary, painted strokes, one angle, a point, or eq. (1) as it is printed.",
        choice("dir", "Direction", choices![
            boundary: "Along the boundary", constant: "One angle", printed: "Eq. (1) as printed",
            radial: "Radial", circular: "Circular", spiral: "Spiral", strokes: "Strokes only",
        ]).group("Direction");
    Angle: "Direction of the rows, clockwise from the x axis.",
        number("angle", "θ", "Angle").range(-90.0, 90.0, 1.0, 0.0).unit("°").group("Direction")
            .only_for(Key::Dir, &["constant", "strokes"]);
    Fx: "The point that rows turn about, from left to right, in picture sides.",
        number("fx", "", "Centre x").range(-1.0, 2.0, 0.01, 0.5).group("Direction")
            .only_for(Key::Dir, ABOUT);
    Fy: "The point that rows turn about, from top to bottom, in picture sides.",
        number("fy", "", "Centre y").range(-1.0, 2.0, 0.01, 0.5).group("Direction")
            .only_for(Key::Dir, ABOUT);
    Fa: "Angle of the spiral to the rays from its point: 0 radial, 90 circular.",
        number("fa", "", "Spiral angle").range(-90.0, 90.0, 1.0, 45.0).unit("°")
            .group("Direction").only_for(Key::Dir, &["spiral"]);
    Dp: "Power of the distance in the direction's weights: the higher, the nearer a wall must be.",
        int("dp", "", "Distance power").range(2.0, 4.0, 1.0, 4.0).group("Direction")
            .only_for(Key::Dir, &["boundary", "strokes"]);
    Ends: "Weight of the outline's short ends in the direction of cells that are not square.",
        number("ends", "", "Weight of ends").range(0.0, 1.0, 0.05, 0.0).group("Direction")
            .only_for(Key::Kind, &["rectangle", "circle", "ellipse"]);
    Strokes: "Painted lines that the rows follow.",
        text("strokes", "Strokes").group("Direction");
    Reach: "Up to where a stroke counts more than one angle or the point, in picture sides.",
        number("reach", "", "Reach of strokes").range(0.02, 1.0, 0.01, 0.15).group("Direction")
            .only_with(Key::Strokes);

    Edge: "What lies on the boundary: the edges of the outermost cells, or their fixed centres.",
        choice("edge", "Boundary", choices![wall: "Edges on it", on: "Centres on it"])
            .group("Packing");
    Start: "Where cells are put at first.",
        choice("start", "Start", choices![stream: "Along the direction", quadtree: "Quadtree"])
            .group("Packing");
    Move: "How the equation of motion is integrated.",
        choice("move", "Integrator", choices![semi: "Semi-implicit", rk4: "Runge-Kutta 4"])
            .group("Packing");
    Pop: "How cells are added and removed on the way.",
        choice("pop", "Population", choices![
            slots: "Empty slots", smallest: "Smallest distance", off: "Off",
        ]).group("Packing");
    Vs: "Random variance of the cells' size.",
        number("vs", "Vs", "Size variance").range(0.0, 0.5, 0.01, 0.0).group("Packing");
    Seed: "Names the random numbers: another seed, another pavement.",
        int("seed", "", "Seed").range(0.0, 4_294_967_295.0, 1.0, 1.0).group("Packing");

    Cells: "Cells fitted to each other without gaps, or as they were packed; to compare, Voronoi cells of as many random points, plain or evened out by Lloyd's relaxation.",
        choice("cells", "Cells", choices![
            fitted: "Fitted", packed: "As packed", voronoi: "Voronoi", lloyd: "Lloyd",
        ]).group("Packing");

    Stone: "What a cell becomes: a round stone, a flat one with bevelled edges, or a cell of skin, a prism that may lean and taper.",
        choice("stone", "Form", choices![cobble: "Cobblestone", flag: "Flagstone", skin: "Skin"])
            .group("Relief");
    Sv: "Scale of the base in its cell; below 1 the joints get wider. Smoothing draws skin together, so it needs more.",
        number("sv", "Sv", "Base scale").range(0.5, 3.0, 0.01, 1.0).for_skin(1.4)
            .group("Relief");
    Hs: "Height of the stones: low ones lie flat, high ones have round heads and deep joints.",
        number("hs", "Hs", "Height").range(1.0, 128.0, 1.0, 18.0).unit("px").group("Relief")
            .only_for(Key::Stone, &["cobble", "flag"]);
    Sr: "Height of skin, in skin sizes: the mean distance of a cell's corners from its middle.",
        number("sr", "Sr", "Sweep").range(0.05, 4.0, 0.05, 1.0).group("Relief")
            .only_for(Key::Stone, SKINS);
    Sc: "How far the top leans along the flow, in skin sizes: scales overlap where it is large.",
        number("sc", "Sc", "Skew").range(0.0, 4.0, 0.05, 0.0).group("Relief")
            .only_for(Key::Stone, SKINS);
    Tilt: "How much the top rises along the flow: scales lie like tiles on a roof.",
        number("tilt", "", "Tilt").range(0.0, 1.0, 0.01, 0.0).group("Relief")
            .only_for(Key::Stone, SKINS);
    Sa: "Where the top leans and rises to, clockwise from the direction of the cells.",
        number("sa", "", "Flow angle").range(-180.0, 180.0, 1.0, 0.0).unit("°")
            .group("Relief").only_for(Key::Stone, SKINS);
    Tc: "How far the top is drawn to the middle: 0 a block, 1 a thorn.",
        number("tc", "Tc", "Taper").range(0.0, 1.0, 0.01, 0.2).group("Relief")
            .only_for(Key::Stone, SKINS);
    Flat: "How much is kept of the prism under the smooth surface: 0 a dome, 1 a plate with edges.",
        number("flat", "", "Flatness").range(0.0, 1.0, 0.01, 0.0).group("Relief")
            .only_for(Key::Stone, SKINS);
    Keel: "Height of a ridge along the flow over the middle of each cell, in cell heights.",
        number("keel", "", "Keel").range(0.0, 1.0, 0.01, 0.0).group("Relief")
            .only_for(Key::Stone, SKINS);
    Rings: "Growth rings on each cell.",
        int("rings", "", "Growth rings").range(0.0, 12.0, 1.0, 0.0).group("Relief")
            .only_for(Key::Stone, SKINS);
    Dr: "Random distortion of the top corners; 0 makes all stones alike.",
        number("dr", "Dr", "Distortion").range(0.0, 1.0, 0.01, 0.3).for_skin(0.05)
            .group("Relief");
    Rand: "Distribution of the distortion: uniform (2000) or normal (2001).",
        choice("rand", "Random numbers", choices![uniform: "Uniform", normal: "Normal"])
            .group("Relief");
    Bh: "How far from a corner the horizontal bevel begins.",
        number("bh", "Bh", "Bevel, horizontal").range(0.0, 1.0, 0.01, 0.2).group("Relief")
            .only_for(Key::Stone, &["flag"]);
    Bv: "How far below the top the vertical bevel begins.",
        number("bv", "Bv", "Bevel, vertical").range(0.0, 1.0, 0.01, 0.2).group("Relief")
            .only_for(Key::Stone, &["flag"]);

    Fd: "Fractal dimension of the faces: near 1 smooth swells, near 2 rough grain.",
        number("fd", "Fd", "Fractal dimension").range(1.05, 1.95, 0.01, 1.5).for_skin(1.1)
            .group("Surface");
    Af: "Amplitude of the fractal noise: in pixels on stones, in skin sizes on skin.",
        number("af", "Af", "Roughness").range(0.0, 8.0, 0.05, 2.0).for_skin(0.1)
            .group("Surface");
    Palette: "Colours and optical attributes.",
        choice("palette", "Palette", choices![
            granite: "Granite", basalt: "Basalt", sandstone: "Sandstone",
            terracotta: "Terracotta", marble: "Marble mix", porphyry: "Porphyry", slate: "Slate",
            mossy: "Mossy granite", limestone: "Limestone",
            crocodile: "Crocodile", lizard: "Lizard", snake: "Snake", coral: "Coral snake",
            fish: "Fish", koi: "Koi", tortoise: "Tortoise", armadillo: "Armadillo",
            pangolin: "Pangolin", desert: "Thorny devil", cone: "Pine cone", dragon: "Dragon",
        ]).group("Surface");
    Vary: "Variation of tone from stone to stone.",
        number("vary", "", "Tone variation").range(0.0, 2.0, 0.05, 1.0).group("Surface");
    Ground: "What lies between the stones.",
        choice("ground", "Ground", choices![
            sand: "Sand", soil: "Soil", mortar: "Mortar", dark: "Dark earth",
            moss: "Moss", gravel: "Gravel", hide: "Bare hide",
        ]).group("Surface");
    Gloss: "How stones or scales shine.",
        choice("gloss", "Gloss", choices![
            own: "As they are", matt: "Matt", glossy: "Glossy", wet: "Wet",
        ]).group("Surface");

    Pattern: "The rule by which cells have the palette's mark colour.",
        choice("pattern", "Pattern", choices![
            none: "None", bands: "Bands", spots: "Spots", rosettes: "Rosettes",
            blotches: "Blotches", turing: "Reaction-diffusion", size: "By size",
            boundary: "Near the boundary", lines: "Near lines", direction: "By direction",
        ]).group("Colour");
    Pn: "From one mark to the next, or how far marks reach, in picture sides.",
        number("pn", "", "Pattern scale").range(0.02, 1.0, 0.01, 0.12).group("Colour")
            .only_for(Key::Pattern, SCALED);
    Pa: "Across bands, or where marked cells point, clockwise from the x axis.",
        number("pa", "", "Pattern angle").range(-180.0, 180.0, 1.0, 0.0).unit("°")
            .group("Colour").only_for(Key::Pattern, &["bands", "direction"]);
    Ps: "Of the border between marked cells and others: 0 soft, 1 sharp.",
        number("ps", "", "Pattern sharpness").range(0.0, 1.0, 0.05, 0.7).group("Colour")
            .only_for(Key::Pattern, PATTERNS);
    Pc: "Share of the cells that are marked.",
        number("pc", "", "Pattern share").range(0.05, 0.95, 0.01, 0.5).group("Colour")
            .only_for(Key::Pattern, PATTERNS);
    Pm: "How much of the mark's colour marked cells have.",
        number("pm", "", "Pattern strength").range(0.0, 1.0, 0.05, 1.0).group("Colour")
            .only_for(Key::Pattern, PATTERNS);
    Rim: "Darkens the rim of each cell; below 0 its middle.",
        number("rim", "", "Dark rims").range(-1.0, 1.0, 0.05, 0.0).group("Colour");
    Belly: "How much of the palette's belly colour there is on one side of the picture.",
        number("belly", "", "Belly").range(0.0, 1.0, 0.05, 0.0).group("Colour");
    Ba: "Where the belly is, clockwise from the x axis.",
        number("ba", "", "Belly angle").range(-180.0, 180.0, 1.0, 90.0).unit("°")
            .group("Colour").only_with(Key::Belly);

    Wear: "Lowers, rounds and polishes what feet tread on, most of all along the middle of the way.",
        number("wear", "", "Wear").range(0.0, 1.0, 0.05, 0.0).group("Weather");
    Moss: "Lets moss grow, in the joints first.",
        number("moss", "", "Moss").range(0.0, 1.0, 0.05, 0.0).group("Weather");
    Dirt: "Brings dust and mud into hollows.",
        number("dirt", "", "Dirt").range(0.0, 1.0, 0.05, 0.0).group("Weather");
    Wet: "Makes all damp, then wet, with puddles in the joints at last.",
        number("wet", "", "Wet").range(0.0, 1.0, 0.05, 0.0).group("Weather");

    Light: "Rays from one side, or from a lamp at a place.",
        choice("light", "Light", choices![parallel: "Parallel", point: "Point"])
            .group("Light");
    Az: "Where the light comes from, clockwise from the right of the picture.",
        number("az", "", "Azimuth").range(0.0, 360.0, 1.0, 225.0).unit("°").group("Light")
            .only_for(Key::Light, &["parallel"]);
    El: "Height of the light above the ground.",
        number("el", "", "Elevation").range(5.0, 90.0, 1.0, 42.0).unit("°").group("Light")
            .only_for(Key::Light, &["parallel"]);
    Lx: "Lamp's place from left to right, in picture sides.",
        number("lx", "", "Lamp x").range(-1.0, 2.0, 0.01, 0.25).group("Light")
            .only_for(Key::Light, &["point"]);
    Ly: "Lamp's place from top to bottom, in picture sides.",
        number("ly", "", "Lamp y").range(-1.0, 2.0, 0.01, 0.2).group("Light")
            .only_for(Key::Light, &["point"]);
    Lz: "Lamp's height above the ground, in picture sides.",
        number("lz", "", "Lamp height").range(0.05, 2.0, 0.01, 0.4).group("Light")
            .only_for(Key::Light, &["point"]);
    Amb: "Factor of the ambient reflection A.",
        number("amb", "A", "Ambient").range(0.0, 2.0, 0.05, 1.0).group("Light");
    Diff: "Factor of the diffuse reflection D.",
        number("diff", "D", "Diffuse").range(0.0, 2.0, 0.05, 1.0).group("Light");
    Spec: "Factor of the specular reflection S.",
        number("spec", "S", "Specular").range(0.0, 2.0, 0.05, 1.0).group("Light");
    Shin: "Factor of the shininess n: the higher, the smaller the highlights.",
        number("shin", "n", "Shininess").range(0.25, 4.0, 0.05, 1.0).group("Light");
    Shadow: "Strength of the shadows that stones cast.",
        number("shadow", "", "Shadows").range(0.0, 1.0, 0.05, 1.0).group("Light");
    Occl: "Strength of ambient occlusion, the darkness of the joints.",
        number("occl", "", "Occlusion").range(0.0, 1.0, 0.05, 1.0).group("Light");
}

/// The kinds with an aspect ratio.
const STRETCHED: &[&str] = &["rectangle", "ellipse"];

/// The word of the stones that are skin.
const SKINS: &[&str] = &["skin"];

/// The patterns, and those that have a scale.
const PATTERNS: &[&str] = &[
    "bands",
    "spots",
    "rosettes",
    "blotches",
    "turing",
    "size",
    "boundary",
    "lines",
    "direction",
];
const SCALED: &[&str] = &[
    "bands", "spots", "rosettes", "blotches", "turing", "boundary", "lines",
];

/// The directions about a point.
const ABOUT: &[&str] = &["radial", "circular", "spiral"];

/// Every outline but the free polygon.
const BUILT_IN: &[&str] = &[
    "annulus",
    "road_s",
    "road_straight",
    "road_spiral",
    "y_fork",
    "crossing",
    "plaza",
    "road_notch",
    "l_shape",
    "star",
    "square",
];

/// The outlines that have a number of something.
const COUNTED: &[&str] = &[
    "road_s",
    "road_spiral",
    "y_fork",
    "crossing",
    "plaza",
    "road_notch",
    "star",
];

impl Key {
    /// The key's row.
    pub fn parameter(self) -> &'static Parameter {
        &SCHEMA[self as usize]
    }

    /// The key of a link's word.
    pub fn from_word(word: &str) -> Option<Key> {
        let at = SCHEMA.iter().position(|row| row.key == word)?;
        Some(Key::ALL[at])
    }
}
