//! Drawings as data: layers of shapes, each over those before it.
//!
//! Whoever draws says what is to be seen, in picture units, y down. A sink makes pixels or a file of it: a
//! [`crate::draw::Board`] paints layers, [`crate::export::svg`] writes them.

use super::colour::Colour;
use super::shapes::round;
use glam::DVec2;

/// Shapes that are filled one after the other, and then the lines of all of them.
#[derive(Clone, Debug, Default)]
pub struct Layer {
    /// Its id in files.
    pub id: &'static str,
    /// What the ids of its shapes in files begin with; their places in the list follow. Empty where the layer is
    /// one thing.
    pub item: &'static str,
    /// Its shapes.
    pub shapes: Vec<Shape>,
    /// What their lines are drawn with.
    pub pen: Option<Pen>,
}

/// Rings or lines that belong together.
#[derive(Clone, Debug, Default)]
pub struct Shape {
    /// Rings, or with an open pen lines through these points.
    pub paths: Vec<Vec<DVec2>>,
    /// Fills the area that the rings run around: what two rings of the same sense share is filled once,
    /// what they share against each other is left out.
    pub fill: Option<Colour>,
    /// Corners of the filled area are rounded by up to so much on the screen.
    pub round: f64,
}

/// Draws all lines of a layer at once: where they meet or cross they are not darker.
#[derive(Clone, Copy, Debug)]
pub struct Pen {
    /// The lines' colour.
    pub colour: Colour,
    /// The lines' width.
    pub width: f64,
    /// Corners of rings are rounded by up to so much on the screen.
    pub round: f64,
    /// Lines do not go on from their last point to their first.
    pub is_open: bool,
}

/// The rim of lines over pictures.
pub(super) const CASING: Colour = [0.08, 0.06, 0.05, 0.50];
/// The rim of thin lines over pictures.
const RIM: Colour = [0.06, 0.04, 0.07, 0.82];

impl Layer {
    /// Filled shapes.
    pub fn shapes(shapes: Vec<Shape>) -> Self {
        Self {
            shapes,
            ..Self::default()
        }
    }

    /// The area that rings run around.
    pub fn fill(rings: Vec<Vec<DVec2>>, colour: Colour, round: f64) -> Self {
        Self::shapes(vec![Shape::fill(rings, colour, round)])
    }

    /// Lines through points.
    pub fn lines(lines: Vec<Vec<DVec2>>, colour: Colour, width: f64) -> Self {
        let shape = Shape::bare(lines);
        Self::shapes(vec![shape]).drawn(colour, width)
    }

    /// The lines of rings.
    pub fn edges(rings: Vec<Vec<DVec2>>, colour: Colour, width: f64) -> Self {
        let shape = Shape::bare(rings);
        Self::shapes(vec![shape]).edged(colour, width, 0.0)
    }

    /// Lines that stand out from whatever is below: light, with a dark rim.
    pub fn cased(lines: Vec<Vec<DVec2>>, colour: Colour, width: f64) -> [Self; 2] {
        let rim = Self::lines(lines.clone(), CASING, 2.0 * width + 0.6);
        [rim, Self::lines(lines, colour, width)]
    }

    /// The same for few thin lines: the rim is as wide as the line on each side, and nearly black, so that
    /// pale stones do not swallow it.
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

impl Shape {
    /// Nothing but paths for a pen.
    pub fn bare(paths: Vec<Vec<DVec2>>) -> Self {
        Self {
            paths,
            ..Self::default()
        }
    }

    /// The area that rings run around.
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
