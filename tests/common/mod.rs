//! What the tests of recipes and links share.

use bubblestone::generators::pavement::PavementRecipe;
use bubblestone::recipe::{Kind, Recipe};
use glam::DVec2;

/// A star-shaped polygon around the picture's middle: `radii` in parts of half of the side.
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

/// What every recipe keeps: values within their limits and words of the schema.
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
