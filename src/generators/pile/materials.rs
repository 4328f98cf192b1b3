//! The table of materials of a pile.

use crate::component::Finish;
use crate::material::{Gloss, Material};

/// The row of the shape where it is seen.
pub(super) const SHAPE_ROW: u8 = 0;
/// The rows of containers of china and of wood.
pub(super) const CHINA_ROW: u8 = 1;
pub(super) const WOOD_ROW: u8 = 2;
/// The first row of the types.
const TYPES: usize = 3;
/// Rows of each type: bodies and their parts, dry and wet.
const EACH: usize = 4;

/// The row of a type's bodies, or of their parts.
pub(super) fn row(kind: usize, is_part: bool, is_wet: bool) -> u8 {
    (TYPES + EACH * kind + 2 * usize::from(is_wet) + usize::from(is_part)) as u8
}

/// The names of the rows in files, for types with these words.
pub(super) fn names_of_rows(words: &[&str]) -> Vec<String> {
    let mut names = ["shape", "china", "wood"].map(str::to_owned).to_vec();
    for word in words {
        names.extend(["", "_part", "_wet", "_part_wet"].map(|end| format!("{word}{end}")));
    }
    names
}

/// The table for types with these finishes.
pub(super) fn materials(finishes: &[&'static Finish], gloss: Gloss) -> Vec<Material> {
    let mut table = vec![
        Material::new(1.0, 1.0, 0.0, 4.0),
        Material {
            mirror: 0.6,
            ..Material::new(1.0, 0.9, 0.3, 70.0)
        },
        Material::new(1.0, 0.95, 0.1, 14.0),
    ];
    for finish in finishes {
        let dry = [finish.body, finish.rest].map(|own| gloss.applied_to(own));
        table.extend(dry);
        table.extend(dry.map(|own| Gloss::Wet.applied_to(own)));
    }
    table
}
