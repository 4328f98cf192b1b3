//! Checks outlines before anything is packed into them. A fault is repaired, with a notice, or reported in
//! one notice that names the ring and the place.

use super::crossing::{Contact, first_contact};
use super::nesting::around;
use super::{Outline, signed_area};
use crate::decimal;
use crate::notice::{Code, Notice};
use crate::planar::orientation;
use glam::DVec2;

/// Most points that the rings of an outline may have together.
pub const MAX_POINTS: usize = 4096;

/// Most points that the constraint lines of an outline may have together.
pub const MAX_LINE_POINTS: usize = 512;

/// The smallest ring has the area of a square with this share of the picture's side (4 px of 512).
const SMALLEST: f64 = 1.0 / 128.0;
/// Points nearer than this share of the picture's side are merged.
const SAME: f64 = 1e-7;
/// The most repairs with a notice of their own. Further repairs are only counted, in one more notice.
const TOLD: usize = 4;
/// How far outside the picture a point may lie, in sides of the picture.
const OUTSIDE: f64 = 0.5;

/// A ring of an outline, or a constraint line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ring {
    /// The first ring.
    Outer,
    /// A hole, by its index among all rings, from 1.
    Hole(usize),
    /// A further outer ring, by its index among all rings, from 1.
    Island(usize),
    /// A constraint line, counted from 1.
    Line(usize),
}

impl Ring {
    /// The ring's name in a sentence.
    fn said(self) -> Notice {
        let (code, number) = match self {
            Ring::Outer => return Code::OuterRing.into(),
            Ring::Hole(number) => (Code::Hole, number),
            Ring::Island(number) => (Code::Island, number),
            Ring::Line(number) => (Code::Line, number),
        };
        Notice::new(code).with("n", number)
    }
}

/// A notice about a ring or a line.
fn of(code: Code, ring: Ring) -> Notice {
    Notice::new(code).with("ring", ring.said())
}

/// A notice about a place on a ring or a line.
fn at(code: Code, ring: Ring, place: DVec2) -> Notice {
    of(code, ring).with("place", said(place))
}

/// The text of a place, in tenths of a picture unit, which are fine enough to find it.
fn said(place: DVec2) -> String {
    // Very large coordinates, as in wrong units, are not rounded.
    let [x, y] = place.to_array().map(|x| match x.abs() < 1e6 {
        true => decimal::text_to(1, x),
        false => decimal::text(x),
    });
    format!("({x}, {y})")
}

fn thousandths(x: f64) -> String {
    decimal::text_to(3, x)
}

/// The notice for too many points.
fn too_many(code: Code, count: usize, most: usize) -> Notice {
    Notice::new(code).with("n", count).with("most", most)
}

impl Outline {
    /// Checks the rings for a picture with this side. Gives the outline without repeated points, oriented as
    /// the module's doc says, and a notice for each repair.
    ///
    /// # Errors
    /// The first fault that cannot be repaired: too many, non-finite or far points; rings that are
    /// degenerate, cross or touch themselves or each other, or are smaller than a square of 1/128 of the
    /// side.
    pub fn check(&self, side: f64) -> Result<(Outline, Vec<Notice>), Notice> {
        let lengths = self.rings.iter().map(Vec::len);
        let count: usize = lengths.clone().sum();
        // Rings without points count as well.
        if count.max(lengths.len()) > MAX_POINTS {
            let count = count.max(lengths.len());
            return Err(too_many(Code::OutlinePoints, count, MAX_POINTS));
        }
        if count == 0 {
            return Err(of(Code::TooFewPoints, Ring::Outer).with("n", 0));
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
                return Err(at(Code::CrossesItself, names[ring], p));
            }
            Some(Contact::Between(a, b, p)) => {
                let rings = Notice::new(Code::RingsCross);
                let rings = rings.with("a", names[a].said()).with("b", names[b].said());
                return Err(rings.with("place", said(p)));
            }
            None => {}
        }
        let is_outer: Vec<bool> = around(&rings).iter().map(|r| r.len() % 2 == 0).collect();
        for (k, ring) in rings.iter_mut().enumerate() {
            orient(ring, is_outer[k], names[k], side, &mut notices)?;
        }
        // The outline starts with an outer ring.
        let first = is_outer.iter().position(|&outer| outer).unwrap_or(0);
        rings[..=first].rotate_right(1);
        if notices.len() > TOLD {
            let more = notices.len() - TOLD;
            notices.truncate(TOLD);
            notices.push(Notice::new(Code::MoreMended).with("n", more));
        }
        Ok((Outline { rings, lines }, notices))
    }
}

/// The names of the rings in sentences.
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
/// The lines have too many points together, a point is not finite or far outside the picture, or a line has
/// fewer than two different points.
pub fn check_lines(lines: &[Vec<DVec2>], side: f64) -> Result<Vec<Vec<DVec2>>, Notice> {
    let count = lines.iter().map(Vec::len).sum();
    if count > MAX_LINE_POINTS {
        return Err(too_many(Code::LinePoints, count, MAX_LINE_POINTS));
    }
    let mut checked = Vec::with_capacity(lines.len());
    for (index, line) in lines.iter().enumerate() {
        let which = Ring::Line(index + 1);
        check_places(line, which, side)?;
        let mut points = line.clone();
        points.dedup_by(|a, b| (*a - *b).abs().max_element() <= SAME * side);
        if points.len() < 2 {
            return Err(of(Code::LineShort, which));
        }
        checked.push(points);
    }
    Ok(checked)
}

/// Refuses points that are not finite or lie far outside the picture.
fn check_places(points: &[DVec2], which: Ring, side: f64) -> Result<(), Notice> {
    if let Some(bad) = points.iter().position(|p| !p.is_finite()) {
        return Err(of(Code::NotFinite, which).with("n", bad + 1));
    }
    let far = |p: &&DVec2| (**p / side - 0.5).abs().max_element() > 0.5 + OUTSIDE;
    match points.iter().find(far) {
        Some(&p) => Err(at(Code::FarOutside, which, p)),
        None => Ok(()),
    }
}

/// The ring without repeated points; an error if it has too few points or lies on one line.
fn check_points(
    ring: &[DVec2],
    which: Ring,
    side: f64,
    notices: &mut Vec<Notice>,
) -> Result<Vec<DVec2>, Notice> {
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
        return Err(of(Code::TooFewPoints, which).with("n", points.len()));
    }
    if let Some(&p) = repeated.first() {
        notices.push(match repeated.len() {
            1 => at(Code::RepeatsPoint, which, p),
            n => at(Code::RepeatsPoints, which, p).with("n", n),
        });
    }
    check_corners(&points, which)?;
    Ok(points)
}

/// Refuses rings on one line and corners that turn back.
fn check_corners(points: &[DVec2], which: Ring) -> Result<(), Notice> {
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
        _ if on_one_line => Err(at(Code::OnOneLine, which, points[0])),
        Some(p) => Err(at(Code::FoldsBack, which, p)),
        None => Ok(()),
    }
}

/// Gives the ring the orientation of its kind; refuses a ring that is too small.
fn orient(
    ring: &mut [DVec2],
    is_outer: bool,
    which: Ring,
    side: f64,
    notices: &mut Vec<Notice>,
) -> Result<(), Notice> {
    let area = signed_area(ring);
    let least = (SMALLEST * side) * (SMALLEST * side);
    if area.abs() < least {
        let small = at(Code::TooSmall, which, ring[0]);
        let small = small.with("area", thousandths(area.abs()));
        return Err(small.with("least", thousandths(least)));
    }
    if (area > 0.0) != is_outer {
        ring.reverse();
        notices.push(of(Code::WrongWay, which));
    }
    Ok(())
}
