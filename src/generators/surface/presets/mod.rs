//! Recipes with names.

use crate::generators::Preset;

/// All presets, in the order of the page.
pub const PRESETS: &[Preset] = &[
    Preset {
        name: "cobbled-hill",
        title: "Cobbled hill",
        group: "Surfaces",
        figure: "",
        note: "A lane between hills, cobbled all over.",
        link: "v=1&make=surface",
        timing: None,
    },
    Preset {
        name: "saurian-leg",
        title: "Saurian leg",
        group: "Surfaces",
        figure: "18",
        note: "Scales from the thigh to the toes, smaller towards the claws.",
        link: "v=1&make=surface&form=leg&kind=rectangle&ca=1.3&cn=2860&taper=0.55&stone=skin&palette=crocodile",
        timing: None,
    },
];
