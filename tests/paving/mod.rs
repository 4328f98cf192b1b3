//! Access to the pavement inside a studio, for tests.
#![allow(dead_code)] // Each test file uses a part of it.

use bubblestone::generators::pavement;
use bubblestone::generators::{ALL, Inspect, Products};
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
    /// The results of the stages of the present pavement.
    fn pavement(&self) -> Products<'_>;
    /// The capability to measure cells of the present pavement.
    fn inspect(&mut self) -> &mut dyn Inspect;
}

impl OfPavement for Studio {
    fn pavement(&self) -> Products<'_> {
        self.engine().products().expect("a pavement")
    }

    fn inspect(&mut self) -> &mut dyn Inspect {
        self.engine_mut().inspect().expect("a pavement")
    }
}
