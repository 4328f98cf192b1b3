//! STL: text and binary.

use super::text::{LineCount, next_word, number};
use super::{Reader, SLICE, bad_line, ends, too_large};
use crate::notice::Notice;
use crate::trimesh::{MOST_TRIANGLES, Soup, polygon};
use glam::DVec3;

/// Bytes of the head, which ends with the count of triangles, and bytes of one triangle.
const HEAD: usize = 84;
const TRIANGLE: usize = 50;

/// Whether a file is binary: it has exactly the length that its head gives. Such a file may begin with `solid`, too.
pub(super) fn has_numbers(bytes: &[u8]) -> bool {
    let length = count(bytes).map(|n| HEAD as u64 + TRIANGLE as u64 * u64::from(n));
    length == Some(bytes.len() as u64)
}

/// Whether a file is long enough for the head of a binary one.
pub(super) fn has_head(bytes: &[u8]) -> bool {
    count(bytes).is_some()
}

/// Whether text looks like an STL file in text form. Some programs write its words in capitals.
pub(super) fn is_text(start: &[u8]) -> bool {
    let start = start[..start.len().min(4096)].to_ascii_lowercase();
    let has = |word: &[u8]| start.windows(word.len()).any(|w| w == word);
    start.starts_with(b"solid") && (has(b"facet") || has(b"endsolid"))
}

/// The count of triangles in the head of a binary file.
fn count(bytes: &[u8]) -> Option<u32> {
    let count = bytes.get(HEAD - 4..HEAD)?;
    Some(u32::from_le_bytes(count.try_into().ok()?))
}

/// Reads a binary file.
#[derive(Default)]
pub(super) struct Numbers {
    at: usize,
}

impl Reader for Numbers {
    fn advance(&mut self, bytes: &[u8], soup: &mut Soup) -> Result<bool, Notice> {
        let count = count(bytes).unwrap_or(0) as usize;
        if (bytes.len() - HEAD) / TRIANGLE < count {
            return Err(ends("STL"));
        }
        if count > MOST_TRIANGLES {
            return Err(too_large(count));
        }
        if self.at == 0 {
            // The file's length has been checked, so this cannot reserve more than a few times the file's size.
            soup.positions.reserve_exact(3 * count);
            soup.triangles.reserve_exact(count);
        }
        let end = count.min(self.at + SLICE / 16);
        for t in self.at..end {
            // The corners follow the normal.
            let at = HEAD + TRIANGLE * t + 12;
            let Some(corners) = bytes.get(at..at + 36) else {
                return Err(ends("STL"));
            };
            let (numbers, _) = corners.as_chunks::<4>();
            let corner = |k: usize| {
                let [x, y, z] = [0, 1, 2].map(|j| f32::from_le_bytes(numbers[3 * k + j]));
                DVec3::new(x.into(), y.into(), z.into())
            };
            soup.positions.extend([0, 1, 2].map(corner));
            soup.triangles.push([0, 1, 2].map(|k| (3 * t + k) as u32));
        }
        self.at = end;
        Ok(end == count)
    }

    fn progress(&self, bytes: &[u8]) -> f64 {
        self.at as f64 / f64::from(count(bytes).unwrap_or(1).max(1))
    }
}

/// Reads a file in text form.
#[derive(Default)]
pub(super) struct Text {
    at: usize,
    lines: LineCount,
    /// The corners of the current facet.
    facet: Vec<u32>,
}

impl Reader for Text {
    fn advance(&mut self, bytes: &[u8], soup: &mut Soup) -> Result<bool, Notice> {
        let end = bytes.len().min(self.at + SLICE);
        while self.at < end {
            let Some(word) = next_word(bytes, &mut self.at) else {
                self.at = bytes.len();
                break;
            };
            let is = |other: &[u8]| word.eq_ignore_ascii_case(other);
            if is(b"vertex") {
                self.vertex(bytes, soup)?;
            } else if is(b"loop") || is(b"endloop") || is(b"facet") || is(b"endfacet") {
                self.end_facet(soup);
            }
        }
        self.lines.reach(bytes, self.at);
        if self.at < bytes.len() {
            return Ok(false);
        }
        if matches!(self.facet.len(), 1 | 2) {
            return Err(ends("STL"));
        }
        self.end_facet(soup);
        Ok(true)
    }

    fn progress(&self, bytes: &[u8]) -> f64 {
        self.at as f64 / bytes.len().max(1) as f64
    }
}

impl Text {
    fn vertex(&mut self, bytes: &[u8], soup: &mut Soup) -> Result<(), Notice> {
        let mut place = [0.0; 3];
        for x in &mut place {
            let Some(word) = next_word(bytes, &mut self.at) else {
                return Err(ends("STL"));
            };
            let mut line = || self.lines.reach(bytes, self.at);
            *x = number(word).ok_or_else(|| bad_line("STL", line(), word))?;
        }
        let n = soup.positions.len();
        if n > 3 * MOST_TRIANGLES {
            return Err(too_large(n / 3));
        }
        self.facet.push(n as u32);
        soup.positions.push(place.into());
        Ok(())
    }

    /// Adds the triangles of the current facet. A few programs write facets of more than three vertices.
    fn end_facet(&mut self, soup: &mut Soup) {
        polygon::add(&soup.positions, &self.facet, &mut soup.triangles);
        self.facet.clear();
    }
}
