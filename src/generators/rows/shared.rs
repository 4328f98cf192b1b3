//! Rows shared by generators. A generator's table may contain whole lists of them, and single ones with another help
//! text, range or group.

use super::lists::lists;
use crate::heightfield::TextureParams;
use crate::light::{Light, ShadeParams};
use crate::random::SEED as SEED_BY_DEFAULT;
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
        ground GROUND: "What lies between the stones." =>
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
