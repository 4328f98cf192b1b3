//! The cells as an SVG file, for editing, plotting or cutting.

use super::fixed::{push, push_whole};
use crate::cells::Cell;
use crate::domain::Domain;
use crate::draw::{Colour, DrawnPath, Layer, Pen, Tones, copies, lit, stages};
use glam::DVec2;

/// Decimals of coordinates.
const DECIMALS: u32 = 2;

/// A standalone SVG file of the picture's size: the outline, each cell as a path in its stone's colour with the id
/// `cell-` and its index, and each constraint line with the id `line-` and its index. On a tile, shapes that cross an
/// edge get copies that enter at the opposite edge.
pub fn svg(
    side: usize,
    domain: &Domain,
    rings: &[&[DVec2]],
    cells: &[Cell],
    tones: &Tones,
) -> String {
    let (paper, period) = (&tones.paper, domain.space().period());
    let mut file = File::new(side, period.map_or(paper.surround, |_| paper.bed));
    if period.is_none() {
        file.one(&stages::bed(rings, paper));
    }
    // Joints are thinner than on the screen, and lines as dark as the boundary.
    let joint = 0.06 * stages::mean_size(cells);
    let cells = stages::cells(cells, tones).edged(lit(paper.bed, 0.7), joint, 0.0);
    file.group(&cells, period);
    let lines = stages::lines(domain, side as f64);
    file.group(&lines.inked(lit(paper.line, 0.6)), period);
    file.finish()
}

/// The text of the file, in ASCII: colours are opaque, and corners are not rounded.
struct File(Vec<u8>);

impl File {
    fn new(side: usize, ground: Colour) -> Self {
        let mut file = Self(Vec::new());
        file.number(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=",
            side as f64,
        );
        file.number(" height=", side as f64);
        file.count(" viewBox=\"0 0 ", side);
        file.count(" ", side);
        file.put("\">\n<rect id=\"ground\" width=\"100%\" height=\"100%\"");
        file.colour(" fill=", ground);
        file.put("/>\n");
        file
    }

    fn finish(mut self) -> String {
        self.put("</svg>\n");
        self.0.into_iter().map(char::from).collect()
    }

    /// Writes a layer, with a path for each shape.
    fn one(&mut self, layer: &Layer) {
        for shape in &layer.shapes {
            self.put("<path id=\"");
            self.put(layer.id);
            self.put("\"");
            self.fill(shape);
            self.stroke(layer.pen, "");
            self.put(" fill-rule=\"evenodd\"");
            self.paths(shape, layer.pen);
        }
    }

    /// Writes a layer as a group of paths, each with its copies on a tile of side `period`.
    fn group(&mut self, layer: &Layer, period: Option<f64>) {
        if layer.shapes.is_empty() {
            return;
        }
        self.put("<g id=\"");
        self.put(layer.id);
        self.put("\"");
        let ends = match layer.pen {
            Some(Pen { is_open: true, .. }) => " stroke-linecap=\"round\"",
            _ => " stroke-linejoin=\"round\"",
        };
        self.stroke(layer.pen, ends);
        self.put(">\n");
        for (index, shape) in layer.shapes.iter().enumerate() {
            self.put("<path id=\"");
            self.count(layer.item, index);
            self.put("\"");
            self.fill(shape);
            self.paths(shape, layer.pen);
            let copies = period.map_or_else(Vec::new, |side| copies(&shape.paths.concat(), side));
            for shift in copies {
                self.put("<use href=\"#");
                self.count(layer.item, index);
                self.number("\" x=", shift.x);
                self.number(" y=", shift.y);
                self.put("/>\n");
            }
        }
        self.put("</g>\n");
    }

    fn fill(&mut self, shape: &DrawnPath) {
        if let Some(colour) = shape.fill {
            self.colour(" fill=", colour);
        }
    }

    /// Writes a pen's stroke; `ends` has the attributes for ends and corners.
    fn stroke(&mut self, pen: Option<Pen>, ends: &str) {
        let Some(pen) = pen else {
            return;
        };
        if pen.is_open {
            self.put(" fill=\"none\"");
        }
        self.colour(" stroke=", pen.colour);
        self.put(ends);
        self.number(" stroke-width=", pen.width);
    }

    /// Writes a shape's rings or lines, and ends its path.
    fn paths(&mut self, shape: &DrawnPath, pen: Option<Pen>) {
        self.put(" d=\"");
        for points in &shape.paths {
            for (k, p) in points.iter().enumerate() {
                self.0.push(if k == 0 { b'M' } else { b'L' });
                push(&mut self.0, p.x, DECIMALS);
                self.0.push(b' ');
                push(&mut self.0, p.y, DECIMALS);
            }
            if pen.is_none_or(|pen| !pen.is_open) {
                self.0.push(b'Z');
            }
        }
        self.put("\"/>\n");
    }

    /// Writes an integer after some text.
    fn count(&mut self, before: &str, x: usize) {
        self.put(before);
        push_whole(&mut self.0, x as u64);
    }

    fn put(&mut self, text: &str) {
        self.0.extend_from_slice(text.as_bytes());
    }

    /// Writes an attribute with a number.
    fn number(&mut self, before: &str, x: f64) {
        self.put(before);
        self.put("\"");
        push(&mut self.0, x, DECIMALS);
        self.put("\"");
    }

    /// Writes an attribute with a colour.
    fn colour(&mut self, before: &str, colour: Colour) {
        const DIGITS: &[u8; 16] = b"0123456789abcdef";
        self.put(before);
        self.put("\"#");
        for c in &colour[..3] {
            let byte = usize::from((255.0 * c + 0.5) as u8);
            self.0.extend([DIGITS[byte >> 4], DIGITS[byte & 15]]);
        }
        self.put("\"");
    }
}
