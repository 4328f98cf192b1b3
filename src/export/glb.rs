//! Surfaces as a GLB file: glTF 2.0 in one binary (Khronos Group, ISO/IEC 12113:2022).
//!
//! One mesh of one primitive. A vertex is its position and normal, three floats each, and its colour:
//! linear red, green, blue and a full alpha of 16 bits each, as 8 bits are too few for dark colours.

use super::frame::Frame;
use crate::decimal;
use crate::heightfield::{Surface, decoded};
use crate::order::{greater, lesser};

/// Bytes of a vertex.
const STRIDE: usize = 32;
/// Where its normal and its colour begin.
const NORMAL: f64 = 12.0;
const COLOUR: f64 = 24.0;

/// What describes the binary; numbers come in the place of each @.
const TEMPLATE: &str = concat!(
    r#"{"asset":{"version":"2.0","generator":"Bubblestone"},"scene":0,"scenes":[{"nodes":[0]}],"#,
    r#""nodes":[{"mesh":0,"name":"Bubblestone"}],"meshes":[{"primitives":[{"attributes":"#,
    r#"{"POSITION":0,"NORMAL":1,"COLOR_0":2},"indices":3,"material":0}]}],"materials":"#,
    r#"[{"pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":@}}],"#,
    r#""buffers":[{"byteLength":@}],"bufferViews":["#,
    r#"{"buffer":0,"byteLength":@,"byteStride":@,"target":34962},"#,
    r#"{"buffer":0,"byteOffset":@,"byteLength":@,"target":34963}],"accessors":["#,
    r#"{"bufferView":0,"componentType":5126,"type":"VEC3","count":@,"min":[@,@,@],"max":[@,@,@]},"#,
    r#"{"bufferView":0,"byteOffset":@,"componentType":5126,"type":"VEC3","count":@},"#,
    r#"{"bufferView":0,"byteOffset":@,"componentType":5123,"normalized":true,"type":"VEC4","count":@},"#,
    r#"{"bufferView":1,"componentType":5125,"type":"SCALAR","count":@}]}"#,
);
/// Where there is no cell.
const EMPTY: &str = r#"{"asset":{"version":"2.0","generator":"Bubblestone"}}"#;

/// The signs of the format and of its two chunks.
const GLTF: u32 = u32::from_le_bytes(*b"glTF");
const JSON: u32 = u32::from_le_bytes(*b"JSON");
const BIN: u32 = u32::from_le_bytes(*b"BIN\0");

/// A GLB file in the making.
pub(super) struct Glb {
    roughness: f32,
    vertices: Vec<u8>,
    indices: Vec<u8>,
    low: [f32; 3],
    high: [f32; 3],
    linear: [u32; 256],
}

impl Glb {
    /// A file of a surface that is rough by so much, 0..1.
    pub fn new(roughness: f32) -> Self {
        let linear = |v| (decoded(v as f64 / 255.0) * 65535.0 + 0.5) as u32;
        Self {
            roughness,
            vertices: Vec::new(),
            indices: Vec::new(),
            low: [f32::MAX; 3],
            high: [f32::MIN; 3],
            linear: std::array::from_fn(linear),
        }
    }

    fn count(&self) -> u32 {
        (self.vertices.len() / STRIDE) as u32
    }

    /// Adds a cell's surface.
    pub fn add(&mut self, frame: &Frame, surface: &Surface) {
        let first = self.count();
        for (k, &p) in surface.positions.iter().enumerate() {
            let at = frame.place(p);
            for (k, &v) in at.iter().enumerate() {
                self.low[k] = lesser(self.low[k], v);
                self.high[k] = greater(self.high[k], v);
            }
            let [x, y, z] = at.map(f32::to_bits);
            let [u, v, w] = frame.direction(surface.normals[k]).map(f32::to_bits);
            let [r, g, b] = surface.colours[k].map(|c| self.linear[usize::from(c)]);
            let (red_green, blue_alpha) = (g << 16 | r, 0xFFFF_0000 | b);
            put(
                &mut self.vertices,
                &[x, y, z, u, v, w, red_green, blue_alpha],
            );
        }
        for &triangle in &surface.triangles {
            put(
                &mut self.indices,
                &frame.turned(triangle).map(|k| first + k),
            );
        }
    }

    /// The file, part after part.
    pub fn finish(self) -> Vec<Vec<u8>> {
        let mut json = self.json().into_bytes();
        while !json.len().is_multiple_of(4) {
            json.push(b' ');
        }
        let binary = self.vertices.len() + self.indices.len();
        let chunks = if binary > 0 { 8 + binary } else { 0 };
        let total = 12 + 8 + json.len() + chunks;
        let mut head = Vec::new();
        put(&mut head, &[GLTF, 2, total as u32, json.len() as u32, JSON]);
        head.append(&mut json);
        if binary > 0 {
            put(&mut head, &[binary as u32, BIN]);
        }
        vec![head, self.vertices, self.indices]
    }

    fn json(&self) -> String {
        if self.vertices.is_empty() {
            return EMPTY.to_owned();
        }
        let [vertices, indices] = [&self.vertices, &self.indices].map(|part| part.len() as f64);
        let count = f64::from(self.count());
        let [low, high] = [self.low, self.high].map(|corner| corner.map(f64::from));
        let numbers = [
            &[f64::from(self.roughness), vertices + indices],
            &[vertices, STRIDE as f64, vertices, indices, count][..],
            &low,
            &high,
            &[NORMAL, count, COLOUR, count, indices / 4.0],
        ];
        let mut numbers = numbers.concat().into_iter();
        let mut json = String::new();
        for piece in TEMPLATE.split('@') {
            json += piece;
            json += &numbers.next().map_or(String::new(), number);
        }
        json
    }
}

/// Counts without an exponent: not all readers take 2e7 for a whole number.
fn number(x: f64) -> String {
    let whole = x as u64;
    if whole as f64 == x {
        whole.to_string()
    } else {
        decimal::text(x)
    }
}

/// Adds words, the lowest byte first.
fn put(out: &mut Vec<u8>, words: &[u32]) {
    for word in words {
        out.extend_from_slice(&word.to_le_bytes());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_written_as_such() {
        for (x, wanted) in [
            (0.0, "0"),
            (12e6, "12000000"),
            (-0.5, "-0.5"),
            (1e-9, "1e-9"),
        ] {
            assert_eq!(number(x), wanted);
        }
    }

    #[test]
    fn without_cells_there_is_a_file() {
        let glb = Glb::new(0.5).finish().concat();
        assert_eq!(
            u32::from_le_bytes([glb[8], glb[9], glb[10], glb[11]]),
            glb.len() as u32
        );
        assert_eq!(glb.len() % 4, 0);
    }
}
