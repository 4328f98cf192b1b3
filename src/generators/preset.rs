//! Recipes with names.

/// A named recipe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Preset {
    /// Short name for scripts, unique.
    pub name: &'static str,
    /// Title on the page.
    pub title: &'static str,
    /// The heading of its group on the page.
    pub group: &'static str,
    /// The figure of a paper that it is made after, such as "15 (a)"; empty for other presets.
    pub figure: &'static str,
    /// One sentence about it.
    pub note: &'static str,
    /// The fragment without `#`, as [`crate::recipe::Recipe::link`] writes it.
    pub link: &'static str,
    /// How long it took in the paper, where that is printed.
    pub timing: Option<Timing>,
}

/// Seconds that a paper prints for one of its figures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timing {
    /// The machine that the paper's seconds were measured on.
    pub machine: &'static str,
    /// The two parts that the paper divides its work in.
    pub parts: [Part; 2],
}

/// A part of the work that a paper has measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// Its name, in a word.
    pub name: &'static str,
    /// The words of the stages here that do the same.
    pub stages: &'static [&'static str],
    /// The paper's seconds.
    pub seconds: f64,
}
