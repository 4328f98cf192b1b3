//! The one table of masonry's parameters; see [`crate::recipe::Schema`].

use crate::generators::rows::buildings;
use crate::generators::rows::rows;
use crate::generators::rows::shared;
use crate::recipe::parameter::{Parameter, choice, number, text};
use crate::recipe::schema::choices;
use crate::recipe::{Choice, Item};

/// The word for a building of a file.
pub const FILE: &str = "file";

/// The word for walls over a plan.
const PLAN: &str = "plan";

/// The word for a module with sizes of its own.
pub const OWN: &str = "own";

/// The colours of walls.
const WALLS: &[Choice] = choices![
    red: "Red brick", yellow: "Yellow brick", dark: "Dark brick", white: "Whitewashed brick",
    honey: "Honey stone", grey: "Grey stone", pale: "Pale stone", parts: "By feature",
];

/// The colours of dressings: sills, arches, lintels and quoins.
const DRESSINGS: &[Choice] = choices![
    pale: "Pale stone", same: "As the wall", honey: "Honey stone", grey: "Grey stone",
    red: "Red brick", yellow: "Yellow brick", dark: "Dark brick",
];

/// The colours of tiles and slates.
const ROOFS: &[Choice] = choices![
    slate: "Slate", tiles: "Red tiles", brown: "Brown tiles", stone: "Stone slates",
];

/// The grounds on which a building stands.
const GROUNDS: &[Choice] = choices![
    grass: "Grass", gravel: "Gravel", paving: "Paving", none: "Studio floor",
];

const MORTARS: &[Choice] = choices![light: "Light", grey: "Grey", sand: "Sand", dark: "Dark"];

/// The row of a length (millimetres) of a module with sizes of its own.
const fn millimetres(name: &'static str, [least, most, usual]: [f64; 3]) -> Parameter {
    number("", name)
        .range(least, most, 0.1, usual)
        .unit("mm")
        .group("Module")
        .only_for(keys::MODULE, &[OWN])
}

rows! {
    building BUILDING: "The building: one by rule, or that of a file." =>
        choice("Building", choices![
            gabled: "House with gables", lhouse: "L-shaped house", block: "Block", wall: "Wall with openings",
            gate: "Gate", steps: "Steps with columns", tower: "Round tower", ring: "Ring of walls",
            sheet: "Single wall", plan: "Walls over a plan", file: "From a file",
        ]).group("Building").main();
    ..[buildings::NUMBERS];
    plan PLAN: "Corners of the line along which walls stand, as x and y in modules, y to the front. Walls stand to the left of the line. It is closed if the last corner is the first one." =>
        text("Corners of the plan", Item::Plan).group("Building").steady().only_for(keys::BUILDING, &[PLAN]);
    openings OPENINGS: "Openings of the walls: the number of the wall from 1, the distance along it, the height of the sill (0 for a gate), width, height, and head (0 straight, 1 segmental, 2 round). Heights are courses, all else modules." =>
        text("Openings", Item::Opening).group("Building").steady().only_for(keys::BUILDING, &[PLAN]);
    model MODEL: "The digest and the name of the building's file: a link does not hold the file itself." =>
        text("Model", Item::File).group("Building").steady()
            .drawn_for(keys::BUILDING, FILE).only_for(keys::BUILDING, &[FILE]);
    unit UNIT: "The unit of lengths in an OBJ file; a building in JSON has its own." =>
        choice("Unit of the file", choices![m: "Metres", cm: "Centimetres", mm: "Millimetres", ft: "Feet", in: "Inches"])
            .group("Building").steady().only_for(keys::BUILDING, &[FILE]);
    up UP: "Which way is up in an OBJ file; in JSON, y is." =>
        choice("Upright axis", choices![y: "y", z: "z"]).group("Building").steady().only_for(keys::BUILDING, &[FILE]);
    yaw YAW: "Turns the building about its upright axis, under the same light." =>
        shared::YAW.group("Building");
    size SIZE: "Side of the square picture." => shared::SIZE;

    pattern PATTERN: "The tree of patterns that features are passed down." =>
        choice("Pattern", choices![
            quoins: "Bricks with stone quoins", bricks: "Bricks", coped: "Bricks with a coping",
            ashlar: "Random ashlar", rgb: "RGB blocks",
            diagonal: "Steps with diagonal bricks", cement: "Steps with cement stones",
        ]).group("Pattern").main();
    hand HAND: "Which way bricks of corners and edges point: solved for the whole building, or by the bits stored in it, as in the paper." =>
        choice("Corners", choices![solved: "Solved", stored: "By hand"]).group("Pattern");
    flips FLIPS: "Corners (0) and edges (1) whose bricks are turned by hand, each with its number." =>
        text("Turned by hand", Item::Feature).group("Pattern").steady();
    seed SEED: "Names the random numbers." => shared::SEED.group("Pattern");

    module MODULE: "The size of bricks or stones with a joint." =>
        choice("Module", choices![
            nf: "German normal format", us: "Modular, United States", uk: "British", ashlar: "Stones of 125 mm",
            cube: "Cubes of 250 mm", own: "Own sizes",
        ]).group("Module").main();
    w W: "Width of half a brick, with its joint." => millimetres("Half a brick", [40.0, 1000.0, 125.0]);
    h H: "Height of a course, with its joint." => millimetres("Course", [20.0, 1000.0, 83.3]);
    joint JOINT: "Thickness of joints." => millimetres("Joint", [0.0, 40.0, 10.0]);

    recess RECESS: "How far mortar lies behind the wall's surface; behind rough stones 22 mm at least." =>
        number("", "Recess").range(0.0, 40.0, 1.0, 6.0).unit("mm").group("Blocks");
    chamfer CHAMFER: "Width of the blocks' chamfers." =>
        number("", "Chamfer").range(0.0, 30.0, 1.0, 4.0).unit("mm").group("Blocks");
    rough ROUGH: "How rounded and rough stones are; at 0 they are plain." =>
        number("", "Roughness").range(0.0, 1.0, 0.05, 0.0).group("Blocks").main();
    crooked CROOKED: "How far blocks lie out of true." =>
        number("", "Crooked").range(0.0, 3.0, 0.1, 1.0).group("Blocks");

    walls WALLS: "Colours of the wall." => choice("Wall", WALLS).group("Look").main();
    dressing DRESSING: "Colours of sills, lintels, arches and quoins." =>
        choice("Dressings", DRESSINGS).group("Look").main();
    roof ROOF: "Colours of the roof's tiles." => choice("Roof", ROOFS).group("Look").main();
    mortar MORTAR: "Colour of the mortar." => choice("Mortar", MORTARS).group("Look");
    vary VARY: "Variation of tone from block to block." => shared::VARY.group("Look");
    gloss GLOSS: "How blocks shine." => shared::GLOSS.group("Look");

    ground GROUND: "The ground on which the building stands." => choice("Ground", GROUNDS).group("Weather").main();
    moss MOSS: "Lets moss grow low down, on what faces up, and on the north side, but not where people walk." =>
        number("", "Moss").range(0.0, 1.0, 0.05, 0.3).group("Weather").main();
    damp DAMP: "Lets damp rise from the ground, and water run down from sills." =>
        number("", "Damp").range(0.0, 1.0, 0.05, 0.3).group("Weather").main();

    ..[shared::LIGHTING];
    az AZ => shared::AZ.range(0.0, 360.0, 1.0, 62.0);
    el EL => shared::EL.range(5.0, 90.0, 1.0, 30.0);
}
