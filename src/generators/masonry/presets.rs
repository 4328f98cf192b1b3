//! Recipes with names: buildings and patterns of Legakis, Dorsey, Gortler (2001), whose text has no numbers, and others.

use crate::generators::Preset;

/// All presets, in the order of the page.
#[rustfmt::skip]
pub const PRESETS: &[Preset] = &[
    Preset::plain(
        ["Buildings", "cottage", "Cottage"],
        "Red brick with pale sills and lintels, in the light of an evening.",
        "v=1&make=masonry&building=gabled&dressing=pale&az=35&el=24",
    ),
];
