//! The words of views.

use crate::generators::scene_picture::view_of;

/// The words of views, in the order of the page.
pub(super) const WORDS: [&str; 9] = [
    "auto", "picture", "darts", "spheres", "depth", "overlap", "types", "layers", "fates",
];

/// The content of a view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PileView {
    /// The darts, then the bodies as they settle, then the picture's bodies.
    Auto,
    /// The bodies.
    Picture,
    /// The darts, each with the disk that no other dart of its type lies in (figures 4 and 5).
    Darts,
    /// The inner spheres.
    Spheres,
    /// The depth of each body's surface in its inner spheres (figure 7).
    Depth,
    /// How deep bodies overlap.
    Overlap,
    /// The types in plain colours.
    Types,
    /// The layers in plain colours.
    Layers,
    /// The darts of bodies that are not there, and why.
    Fates,
}

const ALL: [PileView; 9] = [
    PileView::Auto,
    PileView::Picture,
    PileView::Darts,
    PileView::Spheres,
    PileView::Depth,
    PileView::Overlap,
    PileView::Types,
    PileView::Layers,
    PileView::Fates,
];

impl PileView {
    /// The view of the first known word among words joined by '+'; else [`PileView::Auto`].
    pub fn of_words(words: &str) -> Self {
        view_of(words, WORDS, ALL)
    }
}
