//! The kinds of cells.

/// The shape of a packed cell. One engine packs them all: a kind is this word and the metric that
/// size and aspect ratio make of it.
///
/// Itoh, Miyata, Shimada (2003), section 5.1: circles as in the bubble mesh, ellipses by effective
/// distances, squares by four more potentials at the corners, rectangles by both.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// Four corners, as wide as long.
    #[default]
    Square,
    /// Four corners, longer along the direction field than across.
    Rectangle,
    /// Round.
    Circle,
    /// Longer along the direction field than across, without corners.
    Ellipse,
}

impl Kind {
    /// Squares and rectangles: they stand edge to edge, in rows and columns, and their mesh is of
    /// quadrilaterals. The others stand in the gaps of their neighbours' rows, six around each.
    pub const fn has_corners(self) -> bool {
        matches!(self, Kind::Square | Kind::Rectangle)
    }

    /// Rectangles and ellipses: longer along the direction field.
    pub const fn is_stretched(self) -> bool {
        matches!(self, Kind::Rectangle | Kind::Ellipse)
    }

    /// How many turns of a cell in a full circle look alike, as the direction field sees it: a
    /// quarter turn of a square, half a turn of a rectangle or an ellipse. A circle looks alike at
    /// any turn; its rows follow the field as an ellipse's do.
    pub const fn symmetry(self) -> u32 {
        match self {
            Kind::Square => 4,
            _ => 2,
        }
    }

    /// The kind's word in links.
    pub const fn word(self) -> &'static str {
        match self {
            Kind::Square => "square",
            Kind::Rectangle => "rectangle",
            Kind::Circle => "circle",
            Kind::Ellipse => "ellipse",
        }
    }

    /// The kind of a word.
    pub fn from_word(word: &str) -> Option<Self> {
        [Kind::Square, Kind::Rectangle, Kind::Circle, Kind::Ellipse]
            .into_iter()
            .find(|kind| kind.word() == word)
    }
}
