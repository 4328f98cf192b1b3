//! Pictures of links, finished.

// Each test program uses a part of these.
#![allow(dead_code)]

use bubblestone::recipe::Recipe;
use bubblestone::studio::Studio;

/// The finished picture of a link that nothing is wrong with.
pub fn finished(link: &str) -> Studio {
    refined(link, 0)
}

/// The same, its skin with so many Loop steps more than it needs.
pub fn refined(link: &str, steps: i32) -> Studio {
    let (recipe, notices) = Recipe::from_link(link);
    assert!(notices.is_empty(), "{link}: {notices:?}");
    let mut studio = Studio::new(recipe);
    studio.refine(steps);
    assert_eq!(studio.finish(&mut || 0.0), Ok(()), "{link}");
    studio
}
