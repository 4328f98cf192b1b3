//! Recipes with names: every row of Table 1 of the papers, and others of the house.

mod gallery;
mod house;
mod kinds;
mod pavements;
mod showpieces;
mod skins;
mod textures;

use super::{Recipe, Stage};

/// A named recipe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Preset {
    /// Short name for scripts, unique.
    pub name: &'static str,
    /// Title on the page.
    pub title: &'static str,
    /// What it stands under on the page.
    pub group: &'static str,
    /// The papers' figures, empty for other presets.
    pub figure: &'static str,
    /// One sentence about it.
    pub note: &'static str,
    /// The fragment without `#`, as [`Recipe::link`] writes it.
    pub link: &'static str,
    /// How long it took in the paper, where that is printed.
    pub timing: Option<Timing>,
}

impl Preset {
    /// The preset's recipe.
    pub fn recipe(&self) -> Recipe {
        Recipe::from_link(self.link).0
    }
}

/// Seconds that a paper prints for one of its figures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timing {
    /// What it was measured on.
    pub machine: &'static str,
    /// The paper divides its work in two.
    pub parts: [Part; 2],
}

/// A part of the work that a paper has measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// In a word.
    pub name: &'static str,
    /// The stages here that do the same.
    pub stages: &'static [Stage],
    /// The paper's seconds.
    pub seconds: f64,
}

/// One without a figure.
const fn free(
    group: &'static str,
    name: &'static str,
    title: &'static str,
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
