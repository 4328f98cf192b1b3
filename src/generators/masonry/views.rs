//! The words of views.

use crate::generators::scene_picture::view_of;

/// The words of views, in the order of the page.
pub(super) const WORDS: [&str; 11] = [
    "auto",
    "picture",
    "mortar",
    "features",
    "sizes",
    "polygons",
    "plan",
    "parity",
    "occupancy",
    "clipping",
    "seams",
];

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
    /// Lines of courses and columns, and lines of openings (section 5.1).
    Plan,
    /// Which way the bricks of upright edges point, and the phases of walls (section 5.2).
    Parity,
    /// The pixels of the faces' occupancy maps (figure 3).
    Occupancy,
    /// Cells that were cut, and the cells in their way (section 5.1).
    Clipping,
    /// A plain texture, whose bricks end at the edges (figure 1).
    Seams,
}

const ALL: [MasonryView; 11] = [
    MasonryView::Auto,
    MasonryView::Picture,
    MasonryView::Mortar,
    MasonryView::Features,
    MasonryView::Sizes,
    MasonryView::Polygons,
    MasonryView::Plan,
    MasonryView::Parity,
    MasonryView::Occupancy,
    MasonryView::Clipping,
    MasonryView::Seams,
];

impl MasonryView {
    /// The view of the first known word among words joined by '+'; else [`MasonryView::Auto`].
    pub fn of_words(words: &str) -> Self {
        view_of(words, WORDS, ALL)
    }
}
