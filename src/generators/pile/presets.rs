//! Recipes with names.

use crate::generators::Preset;

const fn preset(
    [group, name, title]: [&'static str; 3],
    note: &'static str,
    link: &'static str,
) -> Preset {
    Preset {
        name,
        title,
        group,
        figure: "",
        note,
        link,
        timing: None,
    }
}

/// All presets, in the order of the page.
#[rustfmt::skip]
pub const PRESETS: &[Preset] = &[
    preset(
        ["Showpieces", "rice-ball", "Rice ball"],
        "Damp grains of every length, as if pressed by hand.",
        "v=1&make=pile",
    ),
];
