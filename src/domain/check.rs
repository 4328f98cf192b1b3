//! Is an outline fit to be paved? What can be mended is mended and told; for the rest there is one
//! sentence that names the ring and the place.

use super::crossing::{Contact, first_contact};
use super::nesting::around;
use super::{Outline, signed_area};
use crate::decimal;
use crate::planar::orientation;
use glam::DVec2;
use std::fmt;

/// Most points that the rings of an outline may have together.
pub const MAX_POINTS: usize = 4096;

/// Most points that the constraint lines of an outline may have together.
pub const MAX_LINE_POINTS: usize = 512;

/// The smallest ring has the area of a square of this part of the picture's side (4 px of 512).
const SMALLEST: f64 = 1.0 / 128.0;
/// Points nearer than this part of the picture's side are one.
const SAME: f64 = 1e-7;
/// At most so many things mended are told one by one.
const TOLD: usize = 4;
/// How far outside the picture a point may lie, in sides.
const OUTSIDE: f64 = 0.5;

/// One of the rings of an outline, or of its constraint lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ring {
    /// The first ring.
    Outer,
    /// A hole, by its place behind the first ring, counted from 1.
    Hole(usize),
    /// A further outer ring, counted like a hole.
    Island(usize),
    /// A constraint line, counted from 1.
    Line(usize),
}

impl Ring {
    /// At the beginning of a sentence.
    fn first(self) -> String {
        match self {
            Ring::Outer => "The outer ring".into(),
            Ring::Hole(number) => format!("Hole {number}"),
            Ring::Island(number) => format!("Island {number}"),
            Ring::Line(number) => format!("Line {number}"),
        }
    }
}

impl fmt::Display for Ring {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Ring::Outer => f.write_str("the outer ring"),
            Ring::Hole(number) => write!(f, "hole {number}"),
            Ring::Island(number) => write!(f, "island {number}"),
            Ring::Line(number) => write!(f, "line {number}"),
        }
    }
}

/// Why an outline is refused; `Display` is the sentence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OutlineError {
    /// Too many points in all.
    TooManyPoints(usize),
    /// The ring's point of that number (from 1) has a coordinate that is no finite number.
    NotFinite(Ring, usize),
    /// A point lies farther outside the picture than half of its side.
    FarOutside(Ring, DVec2),
    /// Too many points in all constraint lines.
    TooManyLinePoints(usize),
    /// All points of the constraint line are one.
    NoLength(Ring),
    /// The ring has fewer than three different points, this many.
    TooFewPoints(Ring, usize),
    /// All points of the ring lie on one line.
    OnOneLine(Ring, DVec2),
    /// The ring turns back on itself at a point.
    FoldsBack(Ring, DVec2),
    /// The ring crosses or touches itself.
    CrossesItself(Ring, DVec2),
    /// Two rings cross, touch or overlap.
    RingsCross(Ring, Ring, DVec2),
    /// The ring's area, in square picture units, is below the smallest (the last number).
    TooSmall(Ring, DVec2, f64, f64),
}

/// A place in a sentence: tenths of a picture unit are fine enough to find it.
struct Place(DVec2);

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Far away in the wrong units there are no tenths. Adding 0 makes of -0 a 0.
        let tenth = |x: f64| {
            if x.abs() < 1e6 {
                (x * 10.0).round() / 10.0 + 0.0
            } else {
                x
            }
        };
        let [x, y] = [self.0.x, self.0.y].map(|x| decimal::text(tenth(x)));
        write!(f, "({x}, {y})")
    }
}

fn thousandths(x: f64) -> String {
    decimal::text((x * 1000.0).round() / 1000.0)
}

impl fmt::Display for OutlineError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use OutlineError::*;
        match *self {
            TooManyPoints(n) => write!(
                f,
                "The outline has {n} points; at most {MAX_POINTS} are allowed."
            ),
            TooManyLinePoints(n) => write!(
                f,
                "The lines have {n} points; at most {MAX_LINE_POINTS} are allowed."
            ),
            NoLength(line) => write!(f, "{} needs at least 2 different points.", line.first()),
            NotFinite(ring, number) => write!(
                f,
                "Point {number} of {ring} is not a pair of finite numbers."
            ),
            FarOutside(ring, p) => write!(
                f,
                "{} has a point far outside the picture, at {}; \
                 at most half of the picture's side is allowed.",
                ring.first(),
                Place(p)
            ),
            TooFewPoints(ring, n) => write!(
                f,
                "{} needs at least 3 different points; it has {n}.",
                ring.first()
            ),
            OnOneLine(ring, p) => write!(
                f,
                "All points of {ring} lie on one line through {}.",
                Place(p)
            ),
            FoldsBack(ring, p) => {
                let ring = ring.first();
                write!(f, "{ring} turns back on itself at {}.", Place(p))
            }
            CrossesItself(ring, p) => {
                let ring = ring.first();
                write!(f, "{ring} crosses or touches itself at {}.", Place(p))
            }
            RingsCross(a, b, p) => {
                let a = a.first();
                write!(f, "{a} and {b} cross or touch at {}.", Place(p))
            }
            TooSmall(ring, p, area, least) => write!(
                f,
                "{} at {} is too small: its area is {} square pixels, at least {} is needed.",
                ring.first(),
                Place(p),
                thousandths(area),
                thousandths(least)
            ),
        }
    }
}

impl std::error::Error for OutlineError {}

impl Outline {
    /// Checks the rings for a picture of a side: gives the outline with repeated points dropped and
    /// the orientation of the module's doc, and a sentence for each thing mended.
    ///
    /// # Errors
    /// The first fault that cannot be mended: too many, non-finite or far points, rings that are
    /// degenerate, cross or touch themselves or each other, or are smaller than a square of 1/128 of
    /// the side.
    pub fn check(&self, side: f64) -> Result<(Outline, Vec<String>), OutlineError> {
        let lengths = self.rings.iter().map(Vec::len);
        let count: usize = lengths.clone().sum();
        // Rings without points count, too.
        if count.max(lengths.len()) > MAX_POINTS {
            return Err(OutlineError::TooManyPoints(count.max(lengths.len())));
        }
        if count == 0 {
            return Err(OutlineError::TooFewPoints(Ring::Outer, 0));
        }
        let lines = check_lines(&self.lines, side)?;
        let mut notices = Vec::new();
        let mut rings = Vec::with_capacity(self.rings.len());
        let names = names(&self.rings);
        for (ring, &name) in self.rings.iter().zip(&names) {
            rings.push(check_points(ring, name, side, &mut notices)?);
        }
        match first_contact(&rings) {
            Some(Contact::Within(ring, p)) => {
                return Err(OutlineError::CrossesItself(names[ring], p));
            }
            Some(Contact::Between(a, b, p)) => {
                return Err(OutlineError::RingsCross(names[a], names[b], p));
            }
            None => {}
        }
        let is_outer: Vec<bool> = around(&rings).iter().map(|r| r.len() % 2 == 0).collect();
        for (k, ring) in rings.iter_mut().enumerate() {
            orient(ring, is_outer[k], names[k], side, &mut notices)?;
        }
        // The first ring is an outer one.
        let first = is_outer.iter().position(|&outer| outer).unwrap_or(0);
        rings[..=first].rotate_right(1);
        if notices.len() > TOLD {
            let more = notices.len() - TOLD;
            notices.truncate(TOLD);
            notices.push(format!("{more} more things like these were mended."));
        }
        Ok((Outline { rings, lines }, notices))
    }
}

/// What sentences call the rings.
fn names(rings: &[Vec<DVec2>]) -> Vec<Ring> {
    let name = |(k, around): (usize, Vec<u32>)| match around.len() % 2 {
        _ if k == 0 => Ring::Outer,
        0 if !rings[k].is_empty() => Ring::Island(k),
        _ => Ring::Hole(k),
    };
    around(rings).into_iter().enumerate().map(name).collect()
}

/// The constraint lines without repeated points.
///
/// # Errors
/// A line has too many points in all, a point that is not finite or far outside the picture, or no
/// two different points.
pub fn check_lines(lines: &[Vec<DVec2>], side: f64) -> Result<Vec<Vec<DVec2>>, OutlineError> {
    let count = lines.iter().map(Vec::len).sum();
    if count > MAX_LINE_POINTS {
        return Err(OutlineError::TooManyLinePoints(count));
    }
    let mut checked = Vec::with_capacity(lines.len());
    for (index, line) in lines.iter().enumerate() {
        let which = Ring::Line(index + 1);
        check_places(line, which, side)?;
        let mut points = line.clone();
        points.dedup_by(|a, b| (*a - *b).abs().max_element() <= SAME * side);
        if points.len() < 2 {
            return Err(OutlineError::NoLength(which));
        }
        checked.push(points);
    }
    Ok(checked)
}

/// Refuses points that are not finite or lie far outside the picture.
fn check_places(points: &[DVec2], which: Ring, side: f64) -> Result<(), OutlineError> {
    if let Some(bad) = points.iter().position(|p| !p.is_finite()) {
        return Err(OutlineError::NotFinite(which, bad + 1));
    }
    let far = |p: &&DVec2| (**p / side - 0.5).abs().max_element() > 0.5 + OUTSIDE;
    match points.iter().find(far) {
        Some(&p) => Err(OutlineError::FarOutside(which, p)),
        None => Ok(()),
    }
}

/// The ring without repeated points, if its points are fit for a ring at all.
fn check_points(
    ring: &[DVec2],
    which: Ring,
    side: f64,
    notices: &mut Vec<String>,
) -> Result<Vec<DVec2>, OutlineError> {
    check_places(ring, which, side)?;
    let same = |a: DVec2, b: DVec2| (a - b).abs().max_element() <= SAME * side;
    let mut points: Vec<DVec2> = Vec::with_capacity(ring.len());
    let mut repeated = Vec::new();
    for &p in ring {
        match points.last() {
            Some(&last) if same(p, last) => repeated.push(p),
            _ => points.push(p),
        }
    }
    while points.len() > 1 && same(points[0], points[points.len() - 1]) {
        repeated.extend(points.pop());
    }
    if points.len() < 3 {
        return Err(OutlineError::TooFewPoints(which, points.len()));
    }
    if let Some(&p) = repeated.first() {
        notices.push(match repeated.len() {
            1 => format!(
                "{} repeats a point at {}; dropped.",
                which.first(),
                Place(p)
            ),
            n => format!(
                "{} repeats {n} points, the first at {}; dropped.",
                which.first(),
                Place(p)
            ),
        });
    }
    check_corners(&points, which)?;
    Ok(points)
}

/// Refuses rings on one line and corners that turn back.
fn check_corners(points: &[DVec2], which: Ring) -> Result<(), OutlineError> {
    let n = points.len();
    let mut on_one_line = true;
    let mut fold = None;
    for k in 0..n {
        let (a, b, c) = (points[(k + n - 1) % n], points[k], points[(k + 1) % n]);
        if orientation(a, b, c) != 0.0 {
            on_one_line = false;
        } else if (b - a).dot(c - b) < 0.0 {
            fold = fold.or(Some(b));
        }
    }
    match fold {
        _ if on_one_line => Err(OutlineError::OnOneLine(which, points[0])),
        Some(p) => Err(OutlineError::FoldsBack(which, p)),
        None => Ok(()),
    }
}

/// Turns the ring to the orientation of its kind; refuses those too small.
fn orient(
    ring: &mut [DVec2],
    is_outer: bool,
    which: Ring,
    side: f64,
    notices: &mut Vec<String>,
) -> Result<(), OutlineError> {
    let area = signed_area(ring);
    let least = (SMALLEST * side) * (SMALLEST * side);
    if area.abs() < least {
        return Err(OutlineError::TooSmall(which, ring[0], area.abs(), least));
    }
    if (area > 0.0) != is_outer {
        ring.reverse();
        notices.push(format!(
            "{} ran the wrong way round; turned.",
            which.first()
        ));
    }
    Ok(())
}
