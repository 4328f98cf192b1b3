//! The free polygon as compact text.
//!
//! Points lie on a grid of 1/32768 of the picture's side, so a polygon scales with the picture
//! without any rounding. A ring is the sequence of its points' differences (the first point's from
//! the ring before it, or the origin), x and y in turn, each mapped to 0, -1, 1, -2, 2 ... = 0, 1, 2,
//! 3, 4 ... and written in groups of five bits, lowest first, 32 added to all but the last group, as
//! characters of the base64url alphabet. A dot divides rings; the first ring is the outer one.

use crate::domain::{MAX_POINTS, Outline};
use glam::DVec2;

/// Grid steps along the picture's side; a power of two, so that the scaling is exact.
const STEPS: f64 = 32768.0;

const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

fn map(outline: &Outline, f: impl Fn(DVec2) -> DVec2) -> Outline {
    let ring = |ring: &Vec<DVec2>| ring.iter().map(|&p| f(p)).collect();
    Outline {
        outer: ring(&outline.outer),
        holes: outline.holes.iter().map(ring).collect(),
        lines: outline.lines.iter().map(ring).collect(),
    }
}

/// Moves every point to the nearest point of the grid.
pub fn snap(outline: &Outline, side: f64) -> Outline {
    map(outline, |p| (p * STEPS / side).round() * side / STEPS)
}

/// The same polygon in a picture of another side; exact for points of the grid.
pub fn resize(outline: &Outline, from: f64, to: f64) -> Outline {
    map(outline, |p| (p * STEPS / from).round() * to / STEPS)
}

/// The text of a polygon whose points lie on the grid.
pub fn encode(outline: &Outline, side: f64) -> String {
    let mut text = String::new();
    let mut last = DVec2::ZERO;
    for (index, ring) in outline_rings(outline).enumerate() {
        if index > 0 {
            text.push('.');
        }
        for &p in ring {
            let at = (p * STEPS / side).round();
            push(&mut text, (at.x - last.x) as i64);
            push(&mut text, (at.y - last.y) as i64);
            last = at;
        }
    }
    text
}

fn outline_rings(outline: &Outline) -> impl Iterator<Item = &Vec<DVec2>> {
    std::iter::once(&outline.outer).chain(&outline.holes)
}

fn push(text: &mut String, value: i64) {
    let mut rest = ((value << 1) ^ (value >> 63)) as u64;
    loop {
        let group = (rest & 31) as usize;
        rest >>= 5;
        let more = rest > 0;
        text.push(ALPHABET[group + if more { 32 } else { 0 }] as char);
        if !more {
            return;
        }
    }
}

/// Reads what [`encode`] writes.
///
/// # Errors
/// Half a sentence that says why the text is no polygon.
pub fn decode(text: &str, side: f64) -> Result<Outline, String> {
    let mut rings = Vec::new();
    let mut last = [0i64; 2];
    let mut points = 0;
    for part in text.split('.') {
        let numbers = numbers(part)?;
        points += numbers.len() / 2;
        if points > MAX_POINTS {
            return Err(format!("it has more than {MAX_POINTS} points"));
        }
        if numbers.len() % 2 == 1 {
            return Err("a point has lost its y".to_owned());
        }
        let mut ring = Vec::with_capacity(numbers.len() / 2);
        for pair in numbers.chunks_exact(2) {
            last = [last[0] + pair[0], last[1] + pair[1]];
            ring.push(DVec2::new(last[0] as f64, last[1] as f64) * side / STEPS);
        }
        rings.push(ring);
    }
    let mut rings = rings.into_iter();
    Ok(Outline {
        outer: rings.next().unwrap_or_default(),
        holes: rings.collect(),
        ..Outline::default()
    })
}

/// The numbers of one ring's text.
fn numbers(text: &str) -> Result<Vec<i64>, String> {
    let mut numbers = Vec::new();
    let (mut value, mut shift) = (0u64, 0);
    for c in text.chars() {
        let Some(code) = ALPHABET.iter().position(|&a| a as char == c) else {
            return Err(format!("it has the character {c:?}"));
        };
        // Six groups reach far beyond any picture, and sums of 4,096 of them stay exact.
        if shift > 25 {
            return Err("a number is too large".to_owned());
        }
        value |= (code as u64 & 31) << shift;
        shift += 5;
        if code < 32 {
            numbers.push((value >> 1) as i64 ^ -((value & 1) as i64));
            (value, shift) = (0, 0);
        }
    }
    if shift > 0 {
        return Err("its end is missing".to_owned());
    }
    Ok(numbers)
}
