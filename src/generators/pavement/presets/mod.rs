//! Recipes with names: every row of Table 1 of the papers, and others of our own.
//!
//! Where a paper prints seconds, a preset has them, with the stages here that do the same work ([`Timing`]). The file
//! of each group is a list, and all lists are joined when the crate is compiled.

mod gallery;
mod house;
mod kinds;
mod pavements;
mod showpieces;
mod skins;
mod textures;

use crate::generators::{MeasuredPart, Preset, Timing};

const LISTS: [&[Preset]; 7] = [
    showpieces::PRESETS,
    house::PRESETS,
    textures::PRESETS,
    gallery::PRESETS,
    kinds::PRESETS,
    pavements::PRESETS,
    skins::PRESETS,
];

const COUNT: usize = {
    let (mut count, mut list) = (0, 0);
    while list < LISTS.len() {
        count += LISTS[list].len();
        list += 1;
    }
    count
};

/// All presets, in the order of the page.
pub const PRESETS: &[Preset] = &{
    let mut all = [showpieces::PRESETS[0]; COUNT];
    let (mut at, mut list) = (0, 0);
    while list < LISTS.len() {
        let mut k = 0;
        while k < LISTS[list].len() {
            all[at] = LISTS[list][k];
            at += 1;
            k += 1;
        }
        list += 1;
    }
    all
};
