//! The words of views.

use crate::generators::scene_picture::view_of;

/// The words of views, in the order of the page.
pub(super) const WORDS: [&str; 8] = [
    "auto",
    "picture",
    "packed",
    "cells",
    "mesh",
    "direction",
    "size",
    "curvature",
];

/// The content of a view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SurfaceView {
    /// The packing as it forms, then the stones.
    Auto,
    /// The stones.
    Picture,
    /// The packed cells.
    Packed,
    /// The cells' polygons.
    Cells,
    /// The cells' mesh.
    Mesh,
    /// The direction with its singular points.
    Direction,
    /// The wanted size.
    Size,
    /// The curvature.
    Curvature,
}

const ALL: [SurfaceView; 8] = [
    SurfaceView::Auto,
    SurfaceView::Picture,
    SurfaceView::Packed,
    SurfaceView::Cells,
    SurfaceView::Mesh,
    SurfaceView::Direction,
    SurfaceView::Size,
    SurfaceView::Curvature,
];

impl SurfaceView {
    /// The view of the first known word among words joined by '+'; else [`SurfaceView::Auto`].
    pub fn of_words(words: &str) -> Self {
        view_of(words, WORDS, ALL)
    }
}
