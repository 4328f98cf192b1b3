//! The cells as an SVG file, to be changed, plotted or cut elsewhere.

use super::fixed::{push, push_whole};
use crate::cells::Cell;
use crate::domain::Domain;
use crate::render::overlay::{Tint, lit};
use crate::render::overlay_tones::Tones;
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
    let mut out = Vec::new();
    let mut add = |parts: &[&str]| parts.iter().for_each(|part| out.extend(part.bytes()));
    let number = |x: f64| text(|out| push(out, x as f32, DECIMALS));
    let whole = number(side as f64);
    let paper = &tones.paper;
    let joint = lit(paper.bed, 0.7);
    let size = cells.iter().map(|c| c.size).sum::<f64>() / cells.len().max(1) as f64;
    add(&[
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"",
        &whole,
        "\" height=\"",
        &whole,
        "\" viewBox=\"0 0 ",
        &whole,
        " ",
        &whole,
        "\">\n",
    ]);
    match domain.period() {
        Some(_) => add(&[
            "<rect id=\"bed\" width=\"100%\" height=\"100%\" fill=\"",
            &colour(paper.bed),
            "\"/>\n",
        ]),
        None => {
            let all = rings
                .iter()
                .map(|ring| path(ring, true))
                .collect::<String>();
            add(&[
                "<rect id=\"ground\" width=\"100%\" height=\"100%\" fill=\"",
                &colour(paper.surround),
                "\"/>\n<path id=\"outline\" fill=\"",
                &colour(paper.bed),
                "\" stroke=\"",
                &colour(paper.line),
                "\" stroke-width=\"1.25\" fill-rule=\"evenodd\" d=\"",
                &all,
                "\"/>\n",
            ]);
        }
    }
    add(&[
        "<g id=\"cells\" stroke=\"",
        &colour(joint),
        "\" stroke-width=\"",
        &number(0.06 * size),
        "\" stroke-linejoin=\"round\">\n",
    ]);
    for (index, cell) in cells.iter().enumerate() {
        let name = text(|out| push_whole(out, index as u64));
        add(&[
            "<path id=\"cell-",
            &name,
            "\" fill=\"",
            &colour(tones.stone(cell.id)),
            "\" d=\"",
            &path(&cell.ring, true),
            "\"/>\n",
        ]);
        for shift in copies(domain, &cell.ring) {
            add(&[
                "<use href=\"#cell-",
                &name,
                "\" x=\"",
                &number(shift.x),
                "\" y=\"",
                &number(shift.y),
                "\"/>\n",
            ]);
        }
    }
    add(&["</g>\n"]);
    if !domain.lines().is_empty() {
        add(&[
            "<g id=\"lines\" fill=\"none\" stroke=\"",
            &colour(lit(paper.line, 0.6)),
            "\" stroke-width=\"",
            &number((side as f64 / 300.0).max(1.2)),
            "\" stroke-linecap=\"round\">\n",
        ]);
        for line in domain.lines() {
            add(&["<path d=\"", &path(line, false), "\"/>\n"]);
        }
        add(&["</g>\n"]);
    }
    add(&["</svg>\n"]);
    String::from_utf8(out).unwrap_or_default()
}

fn text(write: impl Fn(&mut Vec<u8>)) -> String {
    let mut out = Vec::new();
    write(&mut out);
    String::from_utf8(out).unwrap_or_default()
}

/// A ring or a line as a path.
fn path(points: &[DVec2], closed: bool) -> String {
    text(|out| {
        for (k, p) in points.iter().enumerate() {
            out.push(if k == 0 { b'M' } else { b'L' });
            push(out, p.x as f32, DECIMALS);
            out.push(b' ');
            push(out, p.y as f32, DECIMALS);
        }
        if closed {
            out.push(b'Z');
        }
    })
}

fn colour([r, g, b, _]: Tint) -> String {
    const DIGITS: &[u8; 16] = b"0123456789abcdef";
    text(|out| {
        out.push(b'#');
        for c in [r, g, b] {
            let byte = usize::from((255.0 * c + 0.5) as u8);
            out.extend([DIGITS[byte >> 4], DIGITS[byte & 15]]);
        }
    })
}

/// Where the images of a ring are that reach into the picture of a tile.
fn copies(domain: &Domain, ring: &[DVec2]) -> Vec<DVec2> {
    let Some(side) = domain.period() else {
        return Vec::new();
    };
    let lo = ring.iter().fold(DVec2::INFINITY, |lo, &p| lo.min(p));
    let hi = ring.iter().fold(DVec2::NEG_INFINITY, |hi, &p| hi.max(p));
    let steps = |lo: f64, hi: f64| {
        let ways = [(0.0, true), (side, lo < 0.0), (-side, hi > side)];
        ways.into_iter().filter(|way| way.1).map(|way| way.0)
    };
    let shifts = steps(lo.y, hi.y).flat_map(|y| steps(lo.x, hi.x).map(move |x| DVec2::new(x, y)));
    shifts.filter(|&shift| shift != DVec2::ZERO).collect()
}
