//! Wavefront OBJ: lines of text.
//!
//! Two readers share this code: the one of surfaces wants triangles ([`Soup`]), the one of buildings wants polygons and
//! groups ([`PolygonModel`]).

use super::text::{next_line, number, words};
use super::{Reader, SLICE, bad_line, too_large};
use crate::notice::Notice;
use crate::trimesh::{MOST_TRIANGLES, Soup, polygon};
use glam::DVec3;

/// The words with which lines may begin.
const WORDS: [&[u8]; 14] = [
    b"v", b"vt", b"vn", b"vp", b"f", b"g", b"o", b"s", b"l", b"p", b"#", b"usemtl", b"mtllib",
    b"#v",
];

/// The longest line that is read, in bytes: a face of half a million corners has about as many.
const LONGEST: usize = 1 << 22;

/// Whether text looks like an OBJ file: it begins with a known word, and has a vertex near its start.
pub(super) fn is_one(start: &[u8]) -> bool {
    let start = start[..start.len().min(1 << 16)].to_ascii_lowercase();
    let (mut at, mut has_vertex) = (0, false);
    while at < start.len() && !has_vertex {
        let line = next_line(&start, &mut at, usize::MAX).unwrap_or_default();
        has_vertex = words(line).next() == Some(b"v");
    }
    let first = words(&start).next().unwrap_or(b"");
    has_vertex && (WORDS.contains(&first) || first.starts_with(b"#"))
}

#[derive(Default)]
pub(super) struct Obj {
    at: usize,
    line: usize,
    corners: Vec<u32>,
}

impl Reader for Obj {
    fn advance(&mut self, bytes: &[u8], soup: &mut Soup) -> Result<bool, Notice> {
        self.slice(bytes, soup)
    }

    fn progress(&self, bytes: &[u8]) -> f64 {
        (self.at as f64 / bytes.len().max(1) as f64).min(1.0)
    }
}

/// Takes the vertices and polygons of a file.
trait Sink {
    /// The vertices so far.
    fn positions(&mut self) -> &mut Vec<DVec3>;
    /// Takes a polygon: its corners' vertices, counted from 0. They may lie beyond the vertices so far.
    fn polygon(&mut self, corners: &[u32]);
    /// Takes the names of the group that the next polygons belong to.
    fn group(&mut self, names: Vec<String>);
}

impl Sink for Soup {
    fn positions(&mut self) -> &mut Vec<DVec3> {
        &mut self.positions
    }

    fn polygon(&mut self, corners: &[u32]) {
        polygon::add(&self.positions, corners, &mut self.triangles);
    }

    fn group(&mut self, _: Vec<String>) {}
}

/// The polygons of a file, not divided into triangles, with their groups.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PolygonModel {
    /// The vertices, in the file's units.
    pub positions: Vec<DVec3>,
    /// The corners of each polygon as vertex indices, and the index of its group.
    pub polygons: Vec<(Vec<u32>, u32)>,
    /// The names of each group. Group 0 has no names; it holds the polygons before the first named group.
    pub groups: Vec<Vec<String>>,
}

impl Sink for PolygonModel {
    fn positions(&mut self) -> &mut Vec<DVec3> {
        &mut self.positions
    }

    fn polygon(&mut self, corners: &[u32]) {
        let group = self.groups.len() as u32 - 1;
        self.polygons.push((corners.to_vec(), group));
    }

    fn group(&mut self, names: Vec<String>) {
        self.groups.push(names);
    }
}

impl PolygonModel {
    /// Reads a whole OBJ file.
    ///
    /// # Errors
    /// A notice of the line that cannot be read, or that the file is too large.
    pub fn read(bytes: &[u8]) -> Result<Self, Notice> {
        let bytes = &bytes[super::text::mark(bytes)..];
        let (mut lines, mut model) = (Obj::default(), Self::default());
        model.groups.push(Vec::new());
        while !lines.slice(bytes, &mut model)? {}
        Ok(model)
    }
}

/// The line without its final backslash; `None` if the line does not continue in the next one.
fn continued(line: &[u8]) -> Option<&[u8]> {
    line.strip_suffix(b"\\")
}

impl Obj {
    /// Reads a slice of lines; true at the end of the file.
    fn slice(&mut self, bytes: &[u8], sink: &mut impl Sink) -> Result<bool, Notice> {
        let end = bytes.len().min(self.at + SLICE);
        while self.at < end {
            self.line += 1;
            let line = self.next(bytes)?;
            let Some(first) = continued(line) else {
                self.read(line, sink)?;
                continue;
            };
            let number = self.line;
            let whole = self.joined(bytes, first)?;
            let last = std::mem::replace(&mut self.line, number);
            self.read(&whole, sink)?;
            self.line = last;
        }
        Ok(self.at >= bytes.len())
    }

    fn next<'a>(&mut self, bytes: &'a [u8]) -> Result<&'a [u8], Notice> {
        let start = self.at;
        let line = next_line(bytes, &mut self.at, LONGEST);
        line.ok_or_else(|| bad_line("OBJ", self.line, &bytes[start..]))
    }

    /// A line joined with the lines that continue it.
    fn joined(&mut self, bytes: &[u8], first: &[u8]) -> Result<Vec<u8>, Notice> {
        let mut whole = first.to_vec();
        while self.at < bytes.len() {
            self.line += 1;
            let line = self.next(bytes)?;
            whole.push(b' ');
            let part = continued(line);
            whole.extend_from_slice(part.unwrap_or(line));
            if whole.len() > LONGEST {
                return Err(bad_line("OBJ", self.line, line));
            }
            if part.is_none() {
                break;
            }
        }
        Ok(whole)
    }

    fn read(&mut self, line: &[u8], sink: &mut impl Sink) -> Result<(), Notice> {
        let bad = || bad_line("OBJ", self.line, line);
        let mut words = words(line);
        match words.next() {
            Some(b"v" | b"V") => {
                let mut next = || words.next().and_then(number).ok_or_else(bad);
                let place = DVec3::new(next()?, next()?, next()?);
                let positions = sink.positions();
                positions.push(place);
                if positions.len() > 9 * MOST_TRIANGLES {
                    return Err(too_large(positions.len() / 3));
                }
            }
            Some(b"f" | b"F") => {
                let vertices = sink.positions().len();
                self.corners.clear();
                for word in words {
                    // The rest of the line is a comment.
                    if word.starts_with(b"#") {
                        break;
                    }
                    self.corners.push(corner(word, vertices).ok_or_else(bad)?);
                }
                if self.corners.len() > MOST_TRIANGLES {
                    return Err(too_large(self.corners.len()));
                }
                sink.polygon(&self.corners);
            }
            Some(b"g" | b"o") => {
                let name = |word: &[u8]| String::from_utf8_lossy(word).into_owned();
                sink.group(words.map(name).collect());
            }
            _ => {}
        }
        Ok(())
    }
}

/// The vertex of a corner `v`, `v/vt`, `v//vn` or `v/vt/vn`. Indices count from 1, or back from the last vertex with
/// -1.
fn corner(word: &[u8], vertices: usize) -> Option<u32> {
    let vertex = word.split(|&b| b == b'/').next()?;
    let at = match vertex.strip_prefix(b"-") {
        Some(back) => vertices.checked_sub(whole(back).filter(|&n| n > 0)?)?,
        None => whole(vertex)?.checked_sub(1)?,
    };
    u32::try_from(at).ok().filter(|&at| at < u32::MAX)
}

fn whole(word: &[u8]) -> Option<usize> {
    super::text::whole(word).and_then(|n| usize::try_from(n).ok())
}
