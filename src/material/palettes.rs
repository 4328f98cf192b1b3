//! All stones, hides and grounds by their words, and the table of their materials.

use super::grounds::GROUNDS;
use super::hides::HIDES;
use super::palette::{Ground, Palette};
use super::phong::{EARTH, FINISHES, Gloss, Material, POOL, ROWS};
use super::stones::STONES;
use crate::order::greater;

/// All palettes, stones first; the first is the default.
pub const PALETTES: &[Palette] = &{
    let mut all = [STONES[0]; STONES.len() + HIDES.len()];
    let mut k = 0;
    while k < all.len() {
        all[k] = if k < STONES.len() {
            STONES[k]
        } else {
            HIDES[k - STONES.len()]
        };
        k += 1;
    }
    all
};

/// The palette with this name, or the default one.
pub fn palette(name: &str) -> &'static Palette {
    let found = PALETTES.iter().find(|p| p.name == name);
    found.unwrap_or(&PALETTES[0])
}

/// The ground with this name, or the default one. Bare skin has the colour of the palette's flesh.
pub fn ground(name: &str, palette: &Palette) -> Ground {
    let found = GROUNDS.iter().find(|g| g.name == name);
    let mut ground = *found.unwrap_or(&GROUNDS[0]);
    if ground.name == HIDE {
        let light = |factor: f32| palette.flesh.map(|v| (f32::from(v) * factor) as u8);
        ground.colours = [light(1.07), light(0.9)];
    }
    ground
}

/// The word of the ground that is bare skin.
const HIDE: &str = "hide";

/// The table of all materials of a picture: the ground, the palette's finishes, moss and dirt; the same rows
/// damp, and wet; and finally water.
pub fn material_table(palette_name: &str, ground_name: &str, gloss: Gloss) -> Vec<Material> {
    let palette = palette(palette_name);
    let mut table = vec![ground(ground_name, palette).material];
    table.extend(palette.finishes.map(|own| gloss.applied_to(own)));
    table.extend([Material::PADS, EARTH]);
    for wet in [0.45, 1.0] {
        for row in 0..usize::from(ROWS) {
            let dry = table[row];
            // Loose and soft materials absorb water.
            let is_face = (1..=FINISHES).contains(&row);
            let gain = if is_face { 0.34 } else { 0.11 };
            table.push(Material {
                ambient: dry.ambient,
                diffuse: dry.diffuse * (1.0 - 0.06 * wet),
                specular: dry.specular + gain * wet,
                shininess: dry.shininess * (1.0 + wet) + 26.0 * wet,
                mirror: greater(dry.mirror, if is_face { wet } else { 0.5 * wet }),
                ..dry
            });
        }
    }
    table.push(POOL);
    table
}
