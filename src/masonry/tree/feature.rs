//! A feature of the building, as a pattern tree knows it.

use crate::building::{CornerClass, Heading};

/// The type of a feature.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FeatureKind {
    /// A place where edges meet.
    Corner,
    /// A border of two faces.
    Edge,
    /// A wall, a reveal or a roof.
    Face,
}

/// The part of a window that a feature belongs to (section 5.3, Analyze Window).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WindowPart {
    /// Corners with an edge upwards; edges beside a face that looks up, and such faces.
    Bottom,
    /// Corners with an edge downwards; edges beside a face that looks down, and such faces.
    Top,
    /// All other features.
    Side,
}

/// A feature as a pattern tree sees it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FeatureView<'a> {
    /// Its type.
    pub kind: FeatureKind,
    /// Its labels.
    pub labels: Vec<&'a str>,
    /// The class of a corner; of other features it has no meaning.
    pub corner: CornerClass,
    /// Where an edge runs, or where a face looks: vertical edges are `Up` or `Down`, vertical faces are `Level`.
    pub heading: Heading,
    /// Its place in a window.
    pub window: WindowPart,
}

impl FeatureView<'_> {
    /// A wall without labels.
    pub const FACE: Self = Self {
        kind: FeatureKind::Face,
        labels: Vec::new(),
        corner: CornerClass {
            valence: 0,
            convex: 0,
            concave: 0,
            single_convex: None,
            single_concave: None,
        },
        heading: Heading::Level,
        window: WindowPart::Side,
    };

    /// Whether it is horizontal (section 5.3, Orientation): a level edge, or a face that looks up or down. It has no
    /// meaning for corners.
    pub fn is_horizontal(&self) -> bool {
        match self.kind {
            FeatureKind::Face => self.heading != Heading::Level,
            _ => self.heading == Heading::Level,
        }
    }
}
