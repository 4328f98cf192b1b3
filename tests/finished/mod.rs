//! Pictures of links, finished.

// Each test program uses a part of these.
#![allow(dead_code)]

use bubblestone::generators::ALL;
use bubblestone::generators::pavement::{self, Pavement};
use bubblestone::studio::Studio;

/// The finished picture of a link that nothing is wrong with.
pub fn finished(link: &str) -> Studio {
    refined(link, 0)
}

/// The same, its skin with so many Loop steps more than it needs.
pub fn refined(link: &str, steps: i32) -> Studio {
    let (recipe, notices) = pavement::recipe(link);
    assert!(notices.is_empty(), "{link}: {notices:?}");
    let engine = Pavement::finer(&recipe, steps);
    let mut studio = Studio::with_engine(ALL, recipe, Box::new(engine));
    assert_eq!(studio.finish(&mut || 0.0), Ok(()), "{link}");
    studio
}
