//! Labels of features (Legakis, Dorsey, Gortler 2001, section 3.1): strings, any number on one feature.
//!
//! Any string is a label. These are the ones that rules give and that patterns usually ask for. Faces have the labels of
//! the draft. An edge or a corner has its own labels if the draft gives it any. Otherwise it takes those of its faces:
//! [`GLASS`] alone if a face has that label; else all labels, each once, in alphabetical order. So labels do not depend
//! on the order of faces.

use std::collections::BTreeSet;

/// A pane, which carries no masonry.
pub const GLASS: &str = "Glass";
/// The reveal of a window.
pub const WINDOW: &str = "Window";
/// The bottom of a window's reveal.
pub const SILL: &str = "Sill";
/// The reveal of a door.
pub const DOOR: &str = "Door";
/// The curved part of a reveal.
pub const ARCH: &str = "Arch";
/// A roof's slab.
pub const ROOF: &str = "Roof";
/// A step of a stair.
pub const STEP: &str = "Step";
/// A column.
pub const COLUMN: &str = "Column";
/// The cap of a column.
pub const CAP: &str = "Cap";

/// The labels that a feature takes from its faces, if it has none of its own.
pub fn taken<'a>(faces: impl Iterator<Item = &'a [String]>) -> Vec<String> {
    let all: BTreeSet<&String> = faces.flatten().collect();
    if all.iter().any(|label| *label == GLASS) {
        return vec![GLASS.to_owned()];
    }
    all.into_iter().cloned().collect()
}
