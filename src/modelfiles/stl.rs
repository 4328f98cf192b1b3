//! STL: text and binary.

use super::text::{next_word, number, trimmed};
use super::{Reader, SLICE, bad_line, ends, too_large};
use crate::notice::Notice;
use crate::trimesh::{MOST_TRIANGLES, Soup};
use glam::DVec3;

/// Bytes of the head with the count of triangles, and of a triangle.
const HEAD: usize = 84;
const TRIANGLE: usize = 50;

/// The reader, if this is such a file. Both kinds may begin with `solid`; a binary file has exactly the length that
/// its head gives.
pub(super) fn of(bytes: &[u8], is_named_so: bool) -> Option<Box<dyn Reader>> {
    let length = count(bytes).map(|n| HEAD as u64 + TRIANGLE as u64 * u64::from(n));
    if length == Some(bytes.len() as u64) {
        return Some(Box::<Numbers>::default());
    }
    let start = trimmed(bytes);
    let start = &start[..start.len().min(4096)];
    let has = |word: &[u8]| start.windows(word.len()).any(|w| w == word);
    if start.starts_with(b"solid") && (has(b"facet") || has(b"endsolid")) {
        return Some(Box::<Text>::default());
    }
    (is_named_so && length.is_some()).then(|| Box::<Numbers>::default() as Box<dyn Reader>)
}

/// The count of triangles in the head of a binary file.
fn count(bytes: &[u8]) -> Option<u32> {
    let count = bytes.get(HEAD - 4..HEAD)?;
    Some(u32::from_le_bytes(count.try_into().ok()?))
}

#[derive(Default)]
struct Numbers {
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
            // The length has been checked, so this is no more than the file has bytes.
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

#[derive(Default)]
struct Text {
    at: usize,
}

impl Reader for Text {
    fn advance(&mut self, bytes: &[u8], soup: &mut Soup) -> Result<bool, Notice> {
        let end = bytes.len().min(self.at + SLICE);
        while self.at < end {
            let Some(word) = next_word(bytes, &mut self.at) else {
                self.at = bytes.len();
                break;
            };
            if word.eq_ignore_ascii_case(b"vertex") {
                self.vertex(bytes, soup)?;
            }
        }
        if self.at < bytes.len() {
            return Ok(false);
        }
        match soup.positions.len() % 3 {
            0 => Ok(true),
            _ => Err(ends("STL")),
        }
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
            let line = || 1 + bytes[..self.at].iter().filter(|&&b| b == b'\n').count();
            *x = number(word).ok_or_else(|| bad_line("STL", line(), word))?;
        }
        soup.positions.push(place.into());
        let n = soup.positions.len();
        if n.is_multiple_of(3) {
            soup.triangles.push([n - 3, n - 2, n - 1].map(|v| v as u32));
        }
        if n > 3 * MOST_TRIANGLES + 3 {
            return Err(too_large(n / 3));
        }
        Ok(())
    }
}
