//! GLB: glTF 2.0 in one file, with a JSON head and binary numbers.

use super::accessor::{BufferView, ComponentType};
use super::glb_notices::broken;
use super::json::Parser;
use super::scene::{Draw, Mode, ModelScene};
use super::{Reader, SLICE, add_strip, ends, too_large};
use crate::notice::{Code, Notice};
use crate::trimesh::{MOST_TRIANGLES, Soup};
use glam::DVec3;
use std::ops::Range;

/// The types of chunks.
const JSON: &[u8] = b"JSON";
const BIN: &[u8] = b"BIN\0";

/// The most chunks in a file. Only a JSON chunk and a binary chunk are read; chunks of unknown
/// types may follow.
const MOST_CHUNKS: usize = 1 << 16;
/// Bytes of the head that a slice parses, and steps that a slice walks through the scene.
const HEAD: usize = 1 << 18;
const STEPS: usize = 1 << 12;

#[derive(Default)]
pub(super) struct Glb {
    head: Head,
    /// Where the head lies, and where the binary chunk begins.
    text: Range<usize>,
    start: usize,
    /// The length of the binary chunk.
    length: usize,
    /// Index of the current draw, and how many of its items have been read: first positions, then
    /// corners.
    draw: usize,
    at: usize,
    /// Index in the soup of the current draw's first vertex.
    first: usize,
    corners: Vec<u32>,
}

/// How far the head has been read.
#[derive(Default)]
enum Head {
    #[default]
    Chunks,
    Text(Parser),
    Scene(Box<ModelScene>),
    Read(Vec<Draw>),
}

impl Reader for Glb {
    fn advance(&mut self, bytes: &[u8], soup: &mut Soup) -> Result<bool, Notice> {
        self.head = match std::mem::take(&mut self.head) {
            Head::Chunks => self.find_chunks(bytes)?,
            Head::Text(mut parser) => match parser.advance(&bytes[self.text.clone()], HEAD) {
                None => Head::Text(parser),
                Some(json) => {
                    let json = json.map_err(|_| bad_head())?;
                    Head::Scene(Box::new(ModelScene::new(json, self.length)?))
                }
            },
            Head::Scene(mut scene) => match scene.advance(STEPS) {
                None => Head::Scene(scene),
                Some(draws) => Head::Read(checked(draws?)?),
            },
            Head::Read(draws) => {
                let mut left = SLICE / 4;
                while left > 0 && self.draw < draws.len() {
                    left -= self.read(&draws[self.draw], bytes, left, soup)?;
                }
                Head::Read(draws)
            }
        };
        Ok(matches!(&self.head, Head::Read(draws) if self.draw == draws.len()))
    }

    fn progress(&self, _: &[u8]) -> f64 {
        match &self.head {
            Head::Read(draws) => self.draw as f64 / draws.len().max(1) as f64,
            _ => 0.0,
        }
    }
}

fn bad_head() -> Notice {
    Notice::new(Code::FileHead).with("kind", "GLB".to_owned())
}

/// Checks the totals of triangles and vertices over all draws: a small file may draw the same
/// numbers many times.
fn checked(draws: Vec<Draw>) -> Result<Vec<Draw>, Notice> {
    let count = |draw: &Draw| draw.corners.unwrap_or(draw.places).count as u64;
    let triangles = |draw: &Draw| match draw.mode {
        Mode::Triangles => count(draw) / 3,
        _ => count(draw).saturating_sub(2),
    };
    let all: u64 = draws.iter().map(triangles).sum();
    let vertices: u64 = draws.iter().map(|draw| draw.places.count as u64).sum();
    if all > MOST_TRIANGLES as u64 || vertices > 9 * MOST_TRIANGLES as u64 {
        return Err(too_large(all.max(vertices / 3)));
    }
    Ok(draws)
}

fn u32_at(bytes: &[u8], at: usize) -> Option<u32> {
    let bytes = bytes.get(at..at.checked_add(4)?)?;
    Some(u32::from_le_bytes(bytes.try_into().ok()?))
}

impl Glb {
    /// Finds the first JSON chunk and the first binary chunk.
    fn find_chunks(&mut self, bytes: &[u8]) -> Result<Head, Notice> {
        let version = u32_at(bytes, 4).ok_or_else(|| ends("GLB"))?;
        let length = u32_at(bytes, 8).ok_or_else(|| ends("GLB"))? as usize;
        if version != 2 {
            return Err(bad_head());
        }
        if length > bytes.len() {
            return Err(ends("GLB"));
        }
        let (mut text, mut numbers) = (None, 0..0);
        let (mut at, mut chunks) = (12, 0);
        while let (Some(count), Some(kind)) = (u32_at(bytes, at), bytes.get(at + 4..at + 8)) {
            let start = at + 8;
            let end = start.saturating_add(count as usize);
            if end > bytes.len() {
                return Err(ends("GLB"));
            }
            if kind == JSON && text.is_none() {
                text = Some(start..end);
            } else if kind == BIN && numbers.is_empty() {
                numbers = start..end;
            }
            chunks += 1;
            if chunks > MOST_CHUNKS {
                return Err(bad_head());
            }
            at = end.next_multiple_of(4);
        }
        (self.start, self.length) = (numbers.start, numbers.len());
        self.text = text.ok_or_else(bad_head)?;
        Ok(Head::Text(Parser::new()))
    }

    /// Reads up to `most` positions or corners of a draw; returns how many, at least 1.
    fn read(
        &mut self,
        draw: &Draw,
        bytes: &[u8],
        most: usize,
        soup: &mut Soup,
    ) -> Result<usize, Notice> {
        let places = draw.places.count;
        let corners = draw.corners.map_or(places, |view| view.count);
        if self.at < places {
            let end = places.min(self.at + most);
            for k in self.at..end {
                let component = |j| self.number(bytes, &draw.places, k, j);
                let [x, y, z] = [0, 1, 2].map(component);
                soup.positions.push(draw.frame.place(DVec3::new(x, y, z)));
            }
            return Ok(end - std::mem::replace(&mut self.at, end));
        }
        let end = (places + corners).min(self.at + most);
        for k in self.at - places..end - places {
            let corner = match &draw.corners {
                None => k as u32,
                Some(view) => self.number(bytes, view, k, 0) as u32,
            };
            if corner as usize >= places {
                return Err(broken("primitive", self.draw));
            }
            self.corners.push(self.first as u32 + corner);
        }
        let read = end - std::mem::replace(&mut self.at, end);
        if end == places + corners {
            self.finish(draw, soup);
        }
        Ok(read.max(1))
    }

    /// Adds the triangles of a draw.
    fn finish(&mut self, draw: &Draw, soup: &mut Soup) {
        let corners = std::mem::take(&mut self.corners);
        let first = soup.triangles.len();
        match draw.mode {
            Mode::Triangles => soup.triangles.extend(corners.as_chunks::<3>().0),
            Mode::Strip => add_strip(&corners, &mut soup.triangles),
            Mode::Fan => {
                let fan = corners.iter().skip(1).zip(corners.iter().skip(2));
                soup.triangles
                    .extend(fan.map(|(&b, &c)| [corners[0], b, c]));
            }
        }
        if draw.frame.mirrors() {
            for t in &mut soup.triangles[first..] {
                t.swap(1, 2);
            }
        }
        self.draw += 1;
        self.at = 0;
        self.first = soup.positions.len();
    }

    /// One component of a group. Views have been checked to lie within the binary chunk.
    fn number(&self, bytes: &[u8], view: &BufferView, group: usize, component: usize) -> f64 {
        let size = view.kind.bytes();
        let at = self.start + view.start + view.stride * group + size * component;
        let bytes = bytes.get(at..at + size).unwrap_or(&[]);
        let bits = bytes
            .iter()
            .rev()
            .fold(0u32, |bits, &b| bits << 8 | u32::from(b));
        let (x, most) = match view.kind {
            ComponentType::F32 => return f32::from_bits(bits).into(),
            ComponentType::U32 => return bits.into(),
            ComponentType::I8 => (f64::from(bits as u8 as i8), 127.0),
            ComponentType::U8 => (f64::from(bits), 255.0),
            ComponentType::I16 => (f64::from(bits as u16 as i16), 32767.0),
            ComponentType::U16 => (f64::from(bits), 65535.0),
        };
        if view.is_normalized {
            (x / most).max(-1.0)
        } else {
            x
        }
    }
}
