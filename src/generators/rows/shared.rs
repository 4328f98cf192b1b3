//! Rows shared by generators, and the parameters of stages that their values make. A generator's table may contain
//! whole lists of these rows, and single rows with another help text, range or group.

use super::lists::lists;
use crate::generators::lighting::LightParams;
use crate::heightfield::TextureParams;
use crate::light::{Light, ShadeParams};
use crate::material::{Gloss, WeatherParams, material_table};
use crate::random::SEED as SEED_BY_DEFAULT;
use crate::recipe::Recipe;
use crate::recipe::parameter::{Parameter, choice, int, number};
use crate::recipe::schema::choices;

/// The defaults of the libraries, which the rows use.
const TEXTURE: TextureParams = TextureParams::DEFAULT;
const SHADE: ShadeParams = ShadeParams::DEFAULT;

lists! {
    PICTURE: "Rows of the picture as a whole." {
        size SIZE: "Side of the square picture." =>
            int("", "Picture side").range(128.0, 2048.0, 64.0, TEXTURE.side as f64).unit("px")
                .group("Picture").steady();
        yaw YAW: "Turns the bodies about an upright axis, under the same light." =>
            number("", "Turn").range(-180.0, 180.0, 1.0, 0.0).unit("°").group("Picture");
        seed SEED: "Names the random numbers." =>
            int("", "Seed").range(0.0, 4_294_967_295.0, 1.0, SEED_BY_DEFAULT as f64).group("Picture").steady();
    }

    FACES: "Rows of the faces of stones, and of what lies between them." {
        fd FD: "Fractal dimension of the faces: near 1 smooth swells, near 2 rough grain." =>
            number("Fd", "Fractal dimension").range(1.05, 1.95, 0.01, TEXTURE.dimension)
                .group("Surface");
        af AF: "Amplitude of the fractal noise: in pixels on stones, in skin sizes on skin. On stones it grows no more once the relief is a fifth of the joints' depth." =>
            number("Af", "Roughness").range(0.0, 8.0, 0.05, TEXTURE.amplitude)
                .group("Surface");
        palette PALETTE: "Colours and optical attributes." =>
            choice("Palette", choices![
                granite: "Granite", basalt: "Basalt", sandstone: "Sandstone",
                terracotta: "Terracotta", marble: "Marble mix", porphyry: "Porphyry", slate: "Slate",
                mossy: "Mossy granite", limestone: "Limestone",
                crocodile: "Crocodile", lizard: "Lizard", snake: "Snake", coral: "Coral snake",
                fish: "Fish", koi: "Koi", tortoise: "Tortoise", armadillo: "Armadillo",
                pangolin: "Pangolin", desert: "Thorny devil", cone: "Pine cone", dragon: "Dragon",
            ]).group("Surface").main();
        vary VARY: "Variation of tone from stone to stone." =>
            number("", "Tone variation").range(0.0, 2.0, 0.05, TEXTURE.vary).group("Surface");
        ground GROUND: "Fills the joints between the stones." =>
            choice("Ground", choices![
                sand: "Sand", soil: "Soil", mortar: "Mortar", dark: "Dark earth",
                moss: "Moss", gravel: "Gravel", hide: "Bare hide",
            ]).group("Surface");
        gloss GLOSS: "How stones or scales shine." =>
            choice("Gloss", choices![
                own: "As they are", matt: "Matt", glossy: "Glossy", wet: "Wet",
            ]).group("Surface");
    }

    WEATHERING: "Rows of years and weather." {
        wear WEAR: "Lowers, rounds and polishes what feet tread on, most of all along the middle of the way." =>
            number("", "Wear").range(0.0, 1.0, 0.05, 0.0).group("Weather").main();
        moss MOSS: "Lets moss grow, in the joints first." =>
            number("", "Moss").range(0.0, 1.0, 0.05, 0.0).group("Weather").main();
        dirt DIRT: "Brings dust and mud into hollows." =>
            number("", "Dirt").range(0.0, 1.0, 0.05, 0.0).group("Weather");
        wet WET: "Makes all damp, then wet, with puddles in the joints at last." =>
            number("", "Wet").range(0.0, 1.0, 0.05, 0.0).group("Weather").main();
    }

    LIGHTING: "Rows of the light." {
        light LIGHT: "Rays from one side, or from a lamp at a place." =>
            choice("Light", choices![parallel: "Parallel", point: "Point"])
                .group("Light");
        az AZ: "Where the light comes from, clockwise from the right of the picture." =>
            number("", "Azimuth").range(0.0, 360.0, 1.0, Light::AZIMUTH).unit("°").group("Light").main()
                .only_for(keys::LIGHT, &["parallel"]);
        el EL: "Height of the light above the ground." =>
            number("", "Elevation").range(5.0, 90.0, 1.0, Light::ELEVATION).unit("°").group("Light").main()
                .only_for(keys::LIGHT, &["parallel"]);
        lx LX: "Lamp's place from left to right, in picture sides." =>
            number("", "Lamp x").range(-1.0, 2.0, 0.01, 0.25).group("Light").main()
                .only_for(keys::LIGHT, &["point"]);
        ly LY: "Lamp's place from top to bottom, in picture sides." =>
            number("", "Lamp y").range(-1.0, 2.0, 0.01, 0.2).group("Light").main()
                .only_for(keys::LIGHT, &["point"]);
        lz LZ: "Lamp's height above the ground, in picture sides." =>
            number("", "Lamp height").range(0.05, 2.0, 0.01, 0.4).group("Light")
                .only_for(keys::LIGHT, &["point"]);
        amb AMB: "Factor of the ambient reflection A." =>
            number("A", "Ambient").range(0.0, 2.0, 0.05, SHADE.ambient).group("Light");
        diff DIFF: "Factor of the diffuse reflection D." =>
            number("D", "Diffuse").range(0.0, 2.0, 0.05, SHADE.diffuse).group("Light");
        spec SPEC: "Factor of the specular reflection S." =>
            number("S", "Specular").range(0.0, 2.0, 0.05, SHADE.specular).group("Light");
        shin SHIN: "Factor of the shininess n: the higher, the smaller the highlights." =>
            number("n", "Shininess").range(0.25, 4.0, 0.05, SHADE.shininess).group("Light");
        shadow SHADOW: "Strength of the shadows that stones cast." =>
            number("", "Shadows").range(0.0, 1.0, 0.05, SHADE.shadow).group("Light");
        occl OCCL: "Strength of ambient occlusion, the darkness of the joints." =>
            number("", "Occlusion").range(0.0, 1.0, 0.05, SHADE.occlusion).group("Light");
    }
}

/// Pixels along the picture's side.
pub(crate) fn side(recipe: &Recipe) -> usize {
    recipe.number(keys::SIZE) as usize
}

/// The seed of all random numbers.
pub(crate) fn seed(recipe: &Recipe) -> u64 {
    recipe.number(keys::SEED) as u64
}

/// The strength of years and weather, each 0..1.
pub(crate) fn weather(recipe: &Recipe) -> WeatherParams {
    WeatherParams {
        wear: recipe.number(keys::WEAR),
        moss: recipe.number(keys::MOSS),
        dirt: recipe.number(keys::DIRT),
        wet: recipe.number(keys::WET),
    }
}

/// The light, and the materials of palette, ground and gloss.
pub(crate) fn light(recipe: &Recipe) -> LightParams {
    LightParams {
        shade: shading(recipe),
        materials: material_table(
            recipe.choice(keys::PALETTE),
            recipe.choice(keys::GROUND),
            Gloss::of_word(recipe.choice(keys::GLOSS)),
        ),
    }
}

/// The lamp, and the factors of the shading.
pub(crate) fn shading(recipe: &Recipe) -> ShadeParams {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generators::ALL;

    /// Every generator with this finisher has the rows that the finisher reads; reading a missing row would panic.
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
