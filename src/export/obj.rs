//! Surfaces as an OBJ file: text, one object for each cell.

use super::fixed::{push, push_whole};
use super::frame::Frame;
use crate::heightfield::Surface;

/// Bytes after which another part of the file begins.
const PART: usize = 1 << 20;

const HEAD: &[u8] = b"# Made by Bubblestone.\n\
    # Right-handed, y up: x to the right of the picture, z down it. One unit is the picture's side.\n\
    # Each object is the closed surface of a cell; vertices have colours (sRGB, 0 to 1).\n";

/// An OBJ file in the making.
pub(super) struct Obj {
    parts: Vec<Vec<u8>>,
    part: Vec<u8>,
    /// Vertices written; the file counts from 1.
    vertices: u64,
}

impl Obj {
    pub fn new() -> Self {
        Self {
            parts: Vec::new(),
            part: HEAD.to_vec(),
            vertices: 0,
        }
    }

    /// Adds the surface of the cell `index`.
    pub fn add(&mut self, frame: &Frame, surface: &Surface, index: usize) {
        let out = &mut self.part;
        out.extend_from_slice(b"o cell_");
        push_whole(out, index as u64);
        out.push(b'\n');
        for (&p, &colour) in surface.positions.iter().zip(&surface.colours) {
            let [x, y, z] = frame.place(p);
            let [r, g, b] = colour.map(|c| f32::from(c) / 255.0);
            line(out, b"v", &[x, y, z], 7);
            line(out, b"", &[r, g, b], 3);
            out.push(b'\n');
        }
        for &n in &surface.normals {
            line(out, b"vn", &frame.direction(n), 4);
            out.push(b'\n');
        }
        for &triangle in &surface.triangles {
            out.push(b'f');
            for k in frame.turned(triangle) {
                let at = self.vertices + u64::from(k) + 1;
                out.push(b' ');
                push_whole(out, at);
                out.extend_from_slice(b"//");
                push_whole(out, at);
            }
            out.push(b'\n');
        }
        self.vertices += surface.positions.len() as u64;
        if out.len() > PART {
            self.parts.push(std::mem::take(out));
        }
    }

    /// The parts finished since the last call.
    pub fn take(&mut self) -> Vec<Vec<u8>> {
        std::mem::take(&mut self.parts)
    }

    /// The rest of the file, part after part.
    pub fn finish(mut self) -> Vec<Vec<u8>> {
        self.parts.push(self.part);
        self.parts
    }
}

fn line(out: &mut Vec<u8>, word: &[u8], numbers: &[f32; 3], decimals: u32) {
    out.extend_from_slice(word);
    for &x in numbers {
        out.push(b' ');
        push(out, x, decimals);
    }
}
