//! The cells as an SVG file, to be changed, plotted or cut elsewhere.

use super::fixed::{push, push_whole};
use crate::cells::Cell;
use crate::domain::Domain;
use crate::draw::{Tint, Tones, copies, lit};
use glam::DVec2;

/// Coordinates have so many decimals.
const DECIMALS: u32 = 2;

/// A standalone SVG file of the picture's size: the outline, each cell as a path in its stone's colour
/// whose id is `cell-` and its place in the list, and the constraint lines. Of a tile, what reaches
/// over an edge comes in again at the opposite one, as copies of the paths.
pub fn svg(
    side: usize,
    domain: &Domain,
    rings: &[&[DVec2]],
    cells: &[Cell],
    tones: &Tones,
) -> String {
    let mut file = File(Vec::new());
    let paper = &tones.paper;
    let size = cells.iter().map(|c| c.size).sum::<f64>() / cells.len().max(1) as f64;
    let whole = side as f64;
    file.number("<svg xmlns=\"http://www.w3.org/2000/svg\" width=", whole);
    file.number(" height=", whole);
    file.put(" viewBox=\"0 0 ");
    push_whole(&mut file.0, side as u64);
    file.put(" ");
    push_whole(&mut file.0, side as u64);
    file.put("\">\n<rect id=\"ground\" width=\"100%\" height=\"100%\"");
    if domain.period().is_some() {
        file.colour(" fill=", paper.bed);
    } else {
        file.colour(" fill=", paper.surround);
        file.colour("/>\n<path id=\"outline\" fill=", paper.bed);
        file.colour(" stroke=", paper.line);
        file.put(" stroke-width=\"1.25\" fill-rule=\"evenodd\"");
        file.path(rings, true);
    }
    file.colour("/>\n<g id=\"cells\" stroke=", lit(paper.bed, 0.7));
    file.number(" stroke-linejoin=\"round\" stroke-width=", 0.06 * size);
    for (index, cell) in cells.iter().enumerate() {
        file.put(">\n<path id=\"cell-");
        push_whole(&mut file.0, index as u64);
        file.colour("\" fill=", tones.stone(cell.id));
        file.path(&[&cell.ring], true);
        let copies = domain
            .period()
            .map_or_else(Vec::new, |side| copies(&cell.ring, side));
        for shift in copies {
            file.put("/>\n<use href=\"#cell-");
            push_whole(&mut file.0, index as u64);
            file.number("\" x=", shift.x);
            file.number(" y=", shift.y);
        }
        file.put("/");
    }
    file.put(">\n</g>\n");
    if !domain.lines().is_empty() {
        file.colour(
            "<g id=\"lines\" fill=\"none\" stroke=",
            lit(paper.line, 0.6),
        );
        file.number(
            " stroke-linecap=\"round\" stroke-width=",
            (whole / 300.0).max(1.2),
        );
        let lines: Vec<&[DVec2]> = domain.lines().iter().map(Vec::as_slice).collect();
        file.put("><path");
        file.path(&lines, false);
        file.put("/></g>\n");
    }
    file.put("</svg>\n");
    file.0.into_iter().map(char::from).collect()
}

/// A file in the making, ASCII. Its few calls take less room in WebAssembly than pieces of text.
struct File(Vec<u8>);

impl File {
    #[inline(never)]
    fn put(&mut self, text: &str) {
        self.0.extend_from_slice(text.as_bytes());
    }

    /// An attribute whose value is a number.
    #[inline(never)]
    fn number(&mut self, before: &str, x: f64) {
        self.put(before);
        self.put("\"");
        push(&mut self.0, x as f32, DECIMALS);
        self.put("\"");
    }

    /// An attribute whose value is a colour.
    #[inline(never)]
    fn colour(&mut self, before: &str, tint: Tint) {
        const DIGITS: &[u8; 16] = b"0123456789abcdef";
        self.put(before);
        self.put("\"#");
        for c in &tint[..3] {
            let byte = usize::from((255.0 * c + 0.5) as u8);
            self.0.extend([DIGITS[byte >> 4], DIGITS[byte & 15]]);
        }
        self.put("\"");
    }

    /// Rings or lines as the attribute of a path.
    #[inline(never)]
    fn path(&mut self, runs: &[&[DVec2]], closed: bool) {
        self.put(" d=\"");
        for points in runs {
            for (k, p) in points.iter().enumerate() {
                self.0.push(if k == 0 { b'M' } else { b'L' });
                push(&mut self.0, p.x as f32, DECIMALS);
                self.0.push(b' ');
                push(&mut self.0, p.y as f32, DECIMALS);
            }
            if closed {
                self.0.push(b'Z');
            }
        }
        self.put("\"");
    }
}
