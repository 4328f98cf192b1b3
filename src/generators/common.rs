//! Turns the rows that generators share into parameters of stones, their colours, weather and light.

use super::lighting::LightParams;
use crate::generators::rows::shared::keys;
use crate::generators::rows::stones::{SKIN, keys as stones};
use crate::light::{Light, ShadeParams};
use crate::material::{ColourParams, Gloss, Pattern, WeatherParams, material_table};
use crate::recipe::Recipe;
#[cfg(house)]
use crate::recipe::{Key, Kind, Parameter};
use crate::solid::{Distribution, SkinParams, StoneKind, StoneParams};

/// Pixels along the picture's side.
pub(super) fn side(recipe: &Recipe) -> usize {
    recipe.number(keys::SIZE) as usize
}

/// The numbers that are shown for one word of a choice alone, in the order of the table.
#[cfg(house)]
pub(super) fn numbers_of(recipe: &Recipe, choice: Key, word: &str) -> Vec<f64> {
    let is_own = |row: &&Parameter| {
        let of = row.shown_for.filter(|of| of.0 == choice);
        row.kind != Kind::Text && of.is_some_and(|(_, words)| words == [word])
    };
    let rows = recipe.schema().rows.iter().filter(is_own);
    rows.map(|row| recipe.number(row.key)).collect()
}

/// The seed of all random numbers.
pub(super) fn seed(recipe: &Recipe) -> u64 {
    recipe.number(keys::SEED) as u64
}

/// The strength of years and weather, each 0..1.
pub(super) fn weather(recipe: &Recipe) -> WeatherParams {
    WeatherParams {
        wear: recipe.number(keys::WEAR),
        moss: recipe.number(keys::MOSS),
        dirt: recipe.number(keys::DIRT),
        wet: recipe.number(keys::WET),
    }
}

/// The light, and the materials of palette, ground and gloss.
pub(super) fn light(recipe: &Recipe) -> LightParams {
    LightParams {
        shade: shading(recipe),
        materials: material_table(
            recipe.choice(keys::PALETTE),
            recipe.choice(keys::GROUND),
            Gloss::of_word(recipe.choice(keys::GLOSS)),
        ),
    }
}

/// The light.
pub(super) fn shading(recipe: &Recipe) -> ShadeParams {
    ShadeParams {
        light: match recipe.choice(keys::LIGHT) {
            "point" => Light::Point {
                x: recipe.number(keys::LX),
                y: recipe.number(keys::LY),
                z: recipe.number(keys::LZ),
            },
            _ => Light::Parallel {
                azimuth: recipe.number(keys::AZ).to_radians(),
                elevation: recipe.number(keys::EL).to_radians(),
            },
        },
        ambient: recipe.number(keys::AMB),
        diffuse: recipe.number(keys::DIFF),
        specular: recipe.number(keys::SPEC),
        shininess: recipe.number(keys::SHIN),
        shadow: recipe.number(keys::SHADOW),
        occlusion: recipe.number(keys::OCCL),
    }
}

/// The parameters of stones; `unit` is the unit of heights.
pub(super) fn stone(recipe: &Recipe, unit: f64) -> StoneParams {
    StoneParams {
        kind: match recipe.choice(stones::STONE) {
            "flag" => StoneKind::Flagstone,
            SKIN => StoneKind::Skin,
            _ => StoneKind::Cobble,
        },
        height: recipe.number(stones::HS) * unit,
        scale: recipe.number(stones::SV),
        distortion: recipe.number(stones::DR),
        distribution: match recipe.choice(stones::RAND) {
            "normal" => Distribution::Normal,
            _ => Distribution::Uniform,
        },
        bevel_horizontal: recipe.number(stones::BH),
        bevel_vertical: recipe.number(stones::BV),
        skin: SkinParams {
            sweep: recipe.number(stones::SR),
            skew: recipe.number(stones::SC),
            skew_angle: recipe.number(stones::SA).to_radians(),
            tilt: recipe.number(stones::TILT),
            taper: recipe.number(stones::TC),
            flatness: recipe.number(stones::FLAT),
            keel: recipe.number(stones::KEEL),
            rings: recipe.number(stones::RINGS) as u32,
            dimension: recipe.number(keys::FD),
            amplitude: recipe.number(keys::AF),
        },
        seed: seed(recipe),
    }
}

/// The rule that marks cells; `unit` is the unit of patterns.
pub(super) fn colour(recipe: &Recipe, unit: f64) -> ColourParams {
    ColourParams {
        pattern: Pattern::of_word(recipe.choice(stones::PATTERN)),
        scale: recipe.number(stones::PN) * unit,
        angle: recipe.number(stones::PA).to_radians(),
        sharpness: recipe.number(stones::PS),
        share: recipe.number(stones::PC),
        amount: recipe.number(stones::PM),
        rim: recipe.number(stones::RIM),
        soft: recipe.number(stones::SOFT),
        belly: recipe.number(stones::BELLY),
        belly_angle: recipe.number(stones::BA).to_radians(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generators::ALL;

    /// Access to a row that does not exist panics.
    #[test]
    fn who_uses_the_height_field_has_its_rows() {
        let finisher = ["planes", "weather", "shading"];
        let users = ALL.iter().filter(|one| one.stages.ends_with(&finisher));
        for generator in users {
            for word in ["parallel", "point"] {
                let mut recipe = Recipe::new(generator.schema);
                assert_eq!(recipe.set(keys::LIGHT.0, word), Ok(vec![]));
                assert_eq!((side(&recipe), seed(&recipe)), (512, 1));
                assert_eq!(weather(&recipe), WeatherParams::default());
                assert_eq!(light(&recipe).shade.occlusion, 1.0);
            }
        }
    }
}
