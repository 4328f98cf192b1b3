//! The kinds of cells.

/// The shape of a packed cell. One packer serves all kinds: a kind only decides the metric that size and
/// aspect ratio define.
///
/// Itoh, Miyata, Shimada (2003), section 5.1: circles as in the bubble mesh, ellipses by effective distances,
/// squares by four more potentials at the corners, rectangles by both.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum CellKind {
    /// Four corners, equal sides.
    #[default]
    Square,
    /// Four corners, longer along the direction field than across.
    Rectangle,
    /// Round.
    Circle,
    /// Longer along the direction field than across, without corners.
    Ellipse,
}

impl CellKind {
    /// Squares and rectangles. They stand edge to edge in rows and columns, and their mesh is of
    /// quadrilaterals. Other kinds stand in the gaps of the neighbouring rows, six around each.
    pub const fn has_corners(self) -> bool {
        matches!(self, CellKind::Square | CellKind::Rectangle)
    }

    /// Rectangles and ellipses: longer along the direction field.
    pub const fn is_stretched(self) -> bool {
        matches!(self, CellKind::Rectangle | CellKind::Ellipse)
    }

    /// Symmetry of the direction field: how many turns in a full circle leave a cell unchanged. It is 4 for
    /// squares, and 2 for rectangles and ellipses. Circles look alike at any turn and use 2, so that their
    /// rows follow the field as those of ellipses do.
    pub const fn symmetry(self) -> u32 {
        match self {
            CellKind::Square => 4,
            _ => 2,
        }
    }

    /// The kind's word in links.
    pub const fn word(self) -> &'static str {
        match self {
            CellKind::Square => "square",
            CellKind::Rectangle => "rectangle",
            CellKind::Circle => "circle",
            CellKind::Ellipse => "ellipse",
        }
    }

    /// The kind with this word in links.
    pub fn from_word(word: &str) -> Option<Self> {
        [
            CellKind::Square,
            CellKind::Rectangle,
            CellKind::Circle,
            CellKind::Ellipse,
        ]
        .into_iter()
        .find(|kind| kind.word() == word)
    }
}
