//! Recipes from links, and their finished pictures.

// Each test program uses a part of these.
#![allow(dead_code)]

use bubblestone::generators::ALL;
use bubblestone::generators::pavement::{Pavement, PavementRecipe};
use bubblestone::random::Random;
use bubblestone::recipe::{Kind, Recipe};
use bubblestone::studio::Studio;
use glam::DVec2;

/// The recipe of a link without faults.
pub fn recipe(link: &str) -> Recipe {
    let (recipe, notices) = ALL.recipe(link);
    assert!(notices.is_empty(), "{link}: {notices:?}");
    recipe
}

/// The finished picture of a link without faults.
pub fn finished(link: &str) -> Studio {
    finish(Studio::new(ALL, recipe(link)))
}

/// The finished bodies of a link without faults, in space; their picture is not drawn.
pub fn formed(link: &str) -> Studio {
    let mut studio = Studio::new(ALL, recipe(link));
    assert_eq!(studio.form(&mut || 0.0), Ok(()), "{link}");
    studio
}

/// A studio whose packing has ended, or has failed.
pub fn packed(link: &str) -> Studio {
    let mut studio = Studio::new(ALL, recipe(link));
    while ["domain", "fields", "packing"].contains(&studio.stage()) {
        studio.tick(&mut || 0.0, 0.0, u32::MAX);
    }
    studio
}

/// The finished picture of a recipe.
pub fn finished_recipe(recipe: &Recipe) -> Studio {
    finish(Studio::new(ALL, recipe.clone()))
}

/// The finished picture of a pavement's link, whose skin has this many more Loop steps than it needs.
pub fn refined(link: &str, steps: i32) -> Studio {
    let recipe = recipe(link);
    let engine = Pavement::finer(&recipe, steps);
    finish(Studio::with_engine(ALL, recipe, Box::new(engine)))
}

/// A studio run to its end.
fn finish(mut studio: Studio) -> Studio {
    let link = studio.recipe().link();
    assert_eq!(studio.finish(&mut || 0.0), Ok(()), "{link}");
    assert_eq!(studio.stage(), "done", "{link}");
    studio
}

/// A star-shaped polygon around the picture's middle; `radii` are fractions of half the side.
pub fn star(side: f64, radii: &[f64]) -> Vec<DVec2> {
    let n = radii.len() as f64;
    radii
        .iter()
        .enumerate()
        .map(|(k, r)| {
            let angle = std::f64::consts::TAU * k as f64 / n;
            let out = DVec2::new(libm::cos(angle), libm::sin(angle));
            (0.5 + out * r * 0.5) * side
        })
        .collect()
}

/// Asserts that values are within their limits, and words in the schema.
pub fn valid(recipe: &Recipe) {
    for row in recipe.schema().rows {
        let (min, max) = recipe.limits(row);
        let (key, value) = (row.key.0, recipe.number(row.key));
        match row.kind {
            Kind::Number | Kind::Int => assert!((min..=max).contains(&value), "{key} {value}"),
            Kind::Choice => assert!(!recipe.choice(row.key).is_empty(), "{key} {value}"),
            Kind::Text => {}
        }
        if row.kind == Kind::Int {
            assert_eq!(value, value.trunc());
        }
    }
    let (checked, notices) = recipe
        .outline()
        .check(recipe.side())
        .expect("a valid outline");
    assert_eq!(checked, recipe.outline());
    assert!(notices.is_empty(), "{notices:?}");
}

/// A number from the environment, if it is set.
pub fn wished(name: &str, otherwise: u64) -> u64 {
    let text = std::env::var(name).unwrap_or_default();
    text.parse().unwrap_or(otherwise)
}

/// A random value: one end of the range, the other, or any value between.
pub fn number(random: &mut Random, (min, max): (f64, f64)) -> f64 {
    match random.below(3) {
        0 => min,
        1 => max,
        _ => min + (max - min) * random.unit(),
    }
}
