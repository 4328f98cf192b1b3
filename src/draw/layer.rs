//! Drawings as data: a list of layers of shapes, each over those before it.
//!
//! A drawing is described in picture units, y down. A sink renders it: a [`crate::draw::Board`] paints layers
//! to pixels, [`crate::export::svg`] writes them to a file.

use super::colour::Colour;
use super::shapes::round;
use glam::DVec2;

/// Shapes that are filled one by one, followed by the lines of all of them.
#[derive(Clone, Debug, Default)]
pub struct Layer {
    /// Its id in files.
    pub id: &'static str,
    /// Prefix of its shapes' ids in files, followed by their index. Empty if the layer is one object.
    pub item: &'static str,
    /// Its shapes.
    pub shapes: Vec<DrawnPath>,
    /// The pen for the shapes' lines; `None` if there are no lines.
    pub pen: Option<Pen>,
}

/// Rings or lines that belong together.
#[derive(Clone, Debug, Default)]
pub struct DrawnPath {
    /// Rings, or with an open pen lines through these points.
    pub paths: Vec<Vec<DVec2>>,
    /// Fills the area inside the rings by the non-zero rule: an overlap of two rings with the same
    /// orientation is filled once, with opposite orientation it is left out.
    pub fill: Option<Colour>,
    /// Corners of the filled area are rounded by up to this much on a board; in files they stay sharp.
    pub round: f64,
}

/// Draws all lines of a layer at once, so that they are not darker where they meet or cross.
#[derive(Clone, Copy, Debug)]
pub struct Pen {
    /// The lines' colour.
    pub colour: Colour,
    /// The lines' width.
    pub width: f64,
    /// Corners of rings are rounded by up to this much on a board; in files they stay sharp.
    pub round: f64,
    /// Whether lines are open: they do not close from the last point to the first.
    pub is_open: bool,
}

/// The dark rim of lines over pictures.
pub(super) const CASING: Colour = [0.08, 0.06, 0.05, 0.50];
/// The dark rim of thin lines over pictures.
const RIM: Colour = [0.06, 0.04, 0.07, 0.82];

impl Layer {
    /// Filled shapes.
    pub fn shapes(shapes: Vec<DrawnPath>) -> Self {
        Self {
            shapes,
            ..Self::default()
        }
    }

    /// The area inside rings.
    pub fn fill(rings: Vec<Vec<DVec2>>, colour: Colour, round: f64) -> Self {
        Self::shapes(vec![DrawnPath::fill(rings, colour, round)])
    }

    /// Lines through points.
    pub fn lines(lines: Vec<Vec<DVec2>>, colour: Colour, width: f64) -> Self {
        let shape = DrawnPath::bare(lines);
        Self::shapes(vec![shape]).drawn(colour, width)
    }

    /// The lines of rings.
    pub fn edges(rings: Vec<Vec<DVec2>>, colour: Colour, width: f64) -> Self {
        let shape = DrawnPath::bare(rings);
        Self::shapes(vec![shape]).edged(colour, width, 0.0)
    }

    /// Lines that contrast with any background: light, with a dark rim.
    pub fn cased(lines: Vec<Vec<DVec2>>, colour: Colour, width: f64) -> [Self; 2] {
        let rim = Self::lines(lines.clone(), CASING, 2.0 * width + 0.6);
        [rim, Self::lines(lines, colour, width)]
    }

    /// Like [`Layer::cased`], for a few thin lines: the rim is as wide as the line on each side and nearly black, so
    /// that the lines stay visible on pale stones.
    pub fn rimmed(lines: Vec<Vec<DVec2>>, colour: Colour, width: f64) -> [Self; 2] {
        let rim = Self::lines(lines.clone(), RIM, 3.0 * width + 0.4);
        [rim, Self::lines(lines, colour, width)]
    }

    /// The same layer with lines through its points.
    pub fn drawn(mut self, colour: Colour, width: f64) -> Self {
        self.pen = Some(Pen {
            colour,
            width,
            round: 0.0,
            is_open: true,
        });
        self
    }

    /// The same layer with the lines of its rings.
    pub fn edged(mut self, colour: Colour, width: f64, round: f64) -> Self {
        self.pen = Some(Pen {
            colour,
            width,
            round,
            is_open: false,
        });
        self
    }

    /// The same layer with lines of another colour.
    pub fn inked(mut self, colour: Colour) -> Self {
        self.pen = self.pen.map(|pen| Pen { colour, ..pen });
        self
    }

    /// The same layer with ids in files.
    pub fn named(mut self, id: &'static str, item: &'static str) -> Self {
        (self.id, self.item) = (id, item);
        self
    }
}

impl DrawnPath {
    /// Paths without a filling, to be drawn by a pen.
    pub fn bare(paths: Vec<Vec<DVec2>>) -> Self {
        Self {
            paths,
            ..Self::default()
        }
    }

    /// The area inside rings.
    pub fn fill(rings: Vec<Vec<DVec2>>, colour: Colour, round: f64) -> Self {
        Self {
            paths: rings,
            fill: Some(colour),
            round,
        }
    }

    /// A filled disc.
    pub fn dot(centre: DVec2, radius: f64, colour: Colour) -> Self {
        Self::fill(vec![round(centre, radius)], colour, 0.0)
    }
}
