//! The words of views.

use crate::generators::scene_picture::view_of;

/// The words of views, in the order of the page.
pub(super) const WORDS: [&str; 6] = ["auto", "picture", "mortar", "features", "sizes", "polygons"];

/// The content of a view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MasonryView {
    /// The mortar, then the blocks as they are laid, then the picture's blocks.
    Auto,
    /// The blocks.
    Picture,
    /// The mortar alone: the shrunk building (section 5.4).
    Mortar,
    /// Cells of corners in red, of edges in green, of faces in blue (figure 3).
    Features,
    /// Whole, half and cut bricks, and stones, in plain colours.
    Sizes,
    /// The polygons of the child mesh (figure 2).
    Polygons,
}

const ALL: [MasonryView; 6] = [
    MasonryView::Auto,
    MasonryView::Picture,
    MasonryView::Mortar,
    MasonryView::Features,
    MasonryView::Sizes,
    MasonryView::Polygons,
];

impl MasonryView {
    /// The view of the first known word among words joined by '+'; else [`MasonryView::Auto`].
    pub fn of_words(words: &str) -> Self {
        view_of(words, WORDS, ALL)
    }
}
