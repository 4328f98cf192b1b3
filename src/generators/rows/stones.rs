//! Rows shared by generators of stones and scales, and the parameters that their values make: the shape of a cell's
//! stone, and the marking of cells.

use super::lists::lists;
use super::shared::{keys as shared, seed, side};
use crate::heightfield::TextureParams;
use crate::material::{ColourParams, Pattern};
use crate::recipe::Recipe;
use crate::recipe::parameter::{Parameter, choice, int, number};
use crate::recipe::schema::choices;
use crate::solid::{Distribution, SkinParams, StoneKind, StoneParams};

/// The defaults of the libraries, which the rows use.
const STONES: StoneParams = StoneParams::DEFAULT;
const COLOURS: ColourParams = ColourParams::DEFAULT;
const SIDE: f64 = TextureParams::DEFAULT.side as f64;

/// The word for skin among the kinds of stones.
pub const SKIN: &str = "skin";

/// The words of kinds that are skin.
const SKINS: &[&str] = &[SKIN];

/// The words of kinds that are not skin; [`FLAG`] lists the kinds with bevels.
const HARD: &[&str] = &["cobble", "flag"];
const FLAG: &[&str] = &["flag"];

lists! {
    LEAN: "Rows of the form, the height and the lean of stones and scales." {
        stone STONE: "A cell becomes a round stone, a flat one with bevelled edges, or a cell of skin, a prism that may lean and taper." =>
            choice("Form", choices![cobble: "Cobblestone", flag: "Flagstone", skin: "Skin"])
                .group("Relief").main();
        sv SV: "Scale of the base in its cell; below 1 the joints get wider. Smoothing draws skin together, so it needs more." =>
            number("Sv", "Base scale").range(0.5, 3.0, 0.01, STONES.scale).group("Relief").main();
        hs HS: "Height of the stones: low ones lie flat, high ones have round heads and deep joints." =>
            number("Hs", "Height").range(1.0, 128.0, 1.0, STONES.height).group("Relief").main()
                .only_for(keys::STONE, HARD);
        sr SR: "Height of skin, in skin sizes: the mean distance of a cell's corners from its middle." =>
            number("Sr", "Sweep").range(0.05, 4.0, 0.05, STONES.skin.sweep).group("Relief").main()
                .only_for(keys::STONE, SKINS);
        sc SC: "How far the top leans along the flow, in skin sizes: scales overlap where it is large." =>
            number("Sc", "Skew").range(0.0, 4.0, 0.05, STONES.skin.skew).group("Relief")
                .only_for(keys::STONE, SKINS);
        tilt TILT: "How much the top rises along the flow: scales lie like tiles on a roof." =>
            number("", "Tilt").range(0.0, 1.0, 0.01, STONES.skin.tilt).group("Relief")
                .only_for(keys::STONE, SKINS);
        sa SA: "Where the top leans and rises to, clockwise from the direction of the cells." =>
            number("", "Flow angle").range(-180.0, 180.0, 1.0, STONES.skin.skew_angle.to_degrees()).unit("°")
                .group("Relief").only_for(keys::STONE, SKINS);
    }

    TOP: "Rows of the top of stones and scales." {
        tc TC: "How far the top is drawn to the middle: 0 a block, 1 a thorn." =>
            number("Tc", "Taper").range(0.0, 1.0, 0.01, 0.2).group("Relief")
                .only_for(keys::STONE, SKINS);
        flat FLAT: "How much is kept of the prism under the smooth surface: 0 a dome, 1 a plate with edges." =>
            number("", "Flatness").range(0.0, 1.0, 0.01, 0.0).group("Relief")
                .only_for(keys::STONE, SKINS);
        keel KEEL: "Height of a ridge along the flow over the middle of each cell, in cell heights." =>
            number("", "Keel").range(0.0, 1.0, 0.01, 0.0).group("Relief")
                .only_for(keys::STONE, SKINS);
        rings RINGS: "Growth rings on each cell." =>
            int("", "Growth rings").range(0.0, 12.0, 1.0, 0.0).group("Relief")
                .only_for(keys::STONE, SKINS);
        dr DR: "Random distortion of the top corners; 0 makes all stones alike." =>
            number("Dr", "Distortion").range(0.0, 1.0, 0.01, 0.3).group("Relief").main();
        rand RAND: "Distribution of the distortion: uniform (2000) or normal (2001)." =>
            choice("Random numbers", choices![uniform: "Uniform", normal: "Normal"])
                .group("Relief").steady();
        bh BH: "How far from a corner the horizontal bevel begins. Above 0.7 only the corners of a top become wider." =>
            number("Bh", "Bevel, horizontal").range(0.0, 1.0, 0.01, 0.2).group("Relief")
                .only_for(keys::STONE, FLAG);
        bv BV: "How far below the top the vertical bevel begins." =>
            number("Bv", "Bevel, vertical").range(0.0, 1.0, 0.01, 0.2).group("Relief").steady()
                .only_for(keys::STONE, FLAG);
    }

    MARKS: "Rows of the marking of cells." {
        pattern PATTERN: "The rule by which cells have the palette's mark colour." =>
            choice("Pattern", choices![
                none: "None", bands: "Bands", spots: "Spots", rosettes: "Rosettes",
                blotches: "Blotches", turing: "Reaction-diffusion", size: "By size",
                boundary: "Near the boundary", direction: "By direction",
            ]).group("Colour");
        pn PN: "From one mark to the next, or how far marks reach, in picture sides." =>
            number("", "Pattern scale").range(0.02, 1.0, 0.01, COLOURS.scale / SIDE).group("Colour")
                .only_for(keys::PATTERN, SCALED);
        pa PA: "Across bands, or where marked cells point, clockwise from the x axis." =>
            number("", "Pattern angle").range(-180.0, 180.0, 1.0, COLOURS.angle.to_degrees()).unit("°")
                .group("Colour").only_for(keys::PATTERN, &["bands", "direction"]);
        ps PS: "Border between marked cells and others: 0 soft, 1 sharp." =>
            number("", "Pattern sharpness").range(0.0, 1.0, 0.05, COLOURS.sharpness).group("Colour")
                .only_for(keys::PATTERN, PATTERNS);
        pc PC: "Share of the cells that are marked." =>
            number("", "Pattern share").range(0.05, 0.95, 0.01, COLOURS.share).group("Colour")
                .only_for(keys::PATTERN, PATTERNS);
        pm PM: "How much of the mark's colour marked cells have." =>
            number("", "Pattern strength").range(0.0, 1.0, 0.05, COLOURS.amount).group("Colour")
                .only_for(keys::PATTERN, PATTERNS);
        rim RIM: "Darkens the rim of each cell; below 0 its middle." =>
            number("", "Dark rims").range(-1.0, 1.0, 0.05, COLOURS.rim).group("Colour");
        soft SOFT: "How much tones change softly from place to place, as in one bed of stone, instead of from stone to stone." =>
            number("", "Soft tones").range(0.0, 1.0, 0.05, COLOURS.soft).group("Colour");
        belly BELLY: "How much of the palette's belly colour there is on one side of the picture." =>
            number("", "Belly").range(0.0, 1.0, 0.05, COLOURS.belly).group("Colour");
        ba BA: "Where the belly is, clockwise from the x axis." =>
            number("", "Belly angle").range(-180.0, 180.0, 1.0, COLOURS.belly_angle.to_degrees()).unit("°")
                .group("Colour").only_with(keys::BELLY);
    }
}

/// All patterns; [`SCALED`] lists the patterns that have a scale.
const PATTERNS: &[&str] = &[
    "bands",
    "spots",
    "rosettes",
    "blotches",
    "turing",
    "size",
    "boundary",
    "direction",
];
const SCALED: &[&str] = &[
    "bands", "spots", "rosettes", "blotches", "turing", "boundary",
];

/// The parameters of stones; `unit` is the unit of heights, in picture units.
pub(crate) fn stone(recipe: &Recipe, unit: f64) -> StoneParams {
    StoneParams {
        kind: match recipe.choice(keys::STONE) {
            "flag" => StoneKind::Flagstone,
            SKIN => StoneKind::Skin,
            _ => StoneKind::Cobble,
        },
        height: recipe.number(keys::HS) * unit,
        scale: recipe.number(keys::SV),
        distortion: recipe.number(keys::DR),
        distribution: match recipe.choice(keys::RAND) {
            "normal" => Distribution::Normal,
            _ => Distribution::Uniform,
        },
        bevel_horizontal: recipe.number(keys::BH),
        bevel_vertical: recipe.number(keys::BV),
        skin: SkinParams {
            sweep: recipe.number(keys::SR),
            skew: recipe.number(keys::SC),
            skew_angle: recipe.number(keys::SA).to_radians(),
            tilt: recipe.number(keys::TILT),
            taper: recipe.number(keys::TC),
            flatness: recipe.number(keys::FLAT),
            keel: recipe.number(keys::KEEL),
            rings: recipe.number(keys::RINGS) as u32,
            dimension: recipe.number(shared::FD),
            amplitude: recipe.number(shared::AF),
        },
        seed: seed(recipe),
    }
}

/// The parameters of stones or scales in a picture that is no tile. `size` is the mean size of cells in picture units.
/// The last argument has the units of heights and of patterns.
pub(crate) fn texture(recipe: &Recipe, size: f64, [height, pattern]: [f64; 2]) -> TextureParams {
    TextureParams {
        side: side(recipe),
        pixel_scale: 1,
        seed: seed(recipe),
        size,
        stone: stone(recipe, height),
        dimension: recipe.number(shared::FD),
        amplitude: recipe.number(shared::AF),
        palette: recipe.choice(shared::PALETTE),
        ground: recipe.choice(shared::GROUND),
        vary: recipe.number(shared::VARY),
        colour: colour(recipe, pattern),
        tile: false,
    }
}

/// The rule that marks cells; `unit` is the unit of patterns.
pub(crate) fn colour(recipe: &Recipe, unit: f64) -> ColourParams {
    ColourParams {
        pattern: Pattern::of_word(recipe.choice(keys::PATTERN)),
        scale: recipe.number(keys::PN) * unit,
        angle: recipe.number(keys::PA).to_radians(),
        sharpness: recipe.number(keys::PS),
        share: recipe.number(keys::PC),
        amount: recipe.number(keys::PM),
        rim: recipe.number(keys::RIM),
        soft: recipe.number(keys::SOFT),
        belly: recipe.number(keys::BELLY),
        belly_angle: recipe.number(keys::BA).to_radians(),
    }
}
