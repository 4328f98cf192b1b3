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
    /// The figure of a paper that the preset follows, such as "15 (a)"; empty for other presets.
    pub figure: &'static str,
    /// One sentence about it.
    pub note: &'static str,
    /// The fragment without `#`, as [`crate::recipe::Recipe::link`] writes it.
    pub link: &'static str,
    /// The words of its view, as a link of the page has them, such as `view=seams&camera=20,10`; empty for the usual
    /// view.
    pub view: &'static str,
    /// The times in the paper, if they are printed.
    pub timing: Option<Timing>,
}

impl Preset {
    /// A preset that follows no figure.
    pub const fn plain(
        [group, name, title]: [&'static str; 3],
        note: &'static str,
        link: &'static str,
    ) -> Self {
        Self {
            name,
            title,
            group,
            figure: "",
            note,
            link,
            view: "",
            timing: None,
        }
    }

    /// A preset that follows a figure.
    #[cfg(house)]
    pub const fn drawn(
        [group, name, title, figure]: [&'static str; 4],
        note: &'static str,
        link: &'static str,
    ) -> Self {
        Self {
            figure,
            ..Self::plain([group, name, title], note, link)
        }
    }
}

/// The seconds that a paper prints for one of its figures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timing {
    /// The machine on which the paper's authors measured.
    pub machine: &'static str,
    /// The first part into which the paper divides the work, or all of it.
    pub first: MeasuredPart,
    /// The second part, if the paper divides the work.
    pub second: Option<MeasuredPart>,
    /// The number of bodies in the paper's figure, if it is printed.
    pub bodies: Option<u32>,
}

impl Timing {
    /// The parts of the work, one or two.
    pub fn parts(&self) -> impl Iterator<Item = &MeasuredPart> {
        std::iter::once(&self.first).chain(&self.second)
    }
}

/// A part of the work, with the paper's time for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredPart {
    /// The name, in a word.
    pub name: &'static str,
    /// The words of our stages that do the same work.
    pub stages: &'static [&'static str],
    /// The paper's seconds.
    pub seconds: f64,
}
