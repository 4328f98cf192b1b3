//! Access to the pavement inside a studio, for tests.
#![allow(dead_code)] // Each test file uses a part of it.

use bubblestone::generators::ALL;
use bubblestone::generators::pavement::{self, Pavement};
use bubblestone::recipe::{Key, Parameter};
use bubblestone::studio::Studio;

/// A studio with the recipe of a pavement's link.
pub fn studio(link: &str) -> Studio {
    Studio::new(ALL, pavement::recipe(link).0)
}

/// The schema's row of a pavement's parameter.
pub fn row(key: Key) -> &'static Parameter {
    pavement::SCHEMA.row(key.0).expect(key.0)
}

/// The engine of a studio, as a pavement.
pub trait OfPavement {
    /// The pavement at work.
    fn pavement(&self) -> &Pavement;
    /// The same, mutable, for results that are computed on request.
    fn pavement_mut(&mut self) -> &mut Pavement;
}

impl OfPavement for Studio {
    fn pavement(&self) -> &Pavement {
        self.engine_as().expect("a pavement")
    }

    fn pavement_mut(&mut self) -> &mut Pavement {
        self.engine_as_mut().expect("a pavement")
    }
}
