//! Surfaces as a GLB file: glTF 2.0 in one binary (Khronos Group, ISO/IEC 12113:2022).
//!
//! One mesh of one primitive. A vertex is its position and normal, three floats each, and its colour:
//! linear red, green, blue and a full alpha of 16 bits each, as 8 bits are too few for dark colours.

use super::surface::Frame;
use crate::decimal;
use crate::order::{greater, lesser};
use crate::render::decoded;
use crate::texture::Surface;

/// Bytes of a vertex.
const STRIDE: usize = 32;
/// Where its normal and its colour begin.
const NORMAL: usize = 12;
const COLOUR: usize = 24;

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
        while json.len() % 4 > 0 {
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
        const HEAD: &str = r#"{"asset":{"version":"2.0","generator":"Bubblestone"},"scene":0"#;
        if self.vertices.is_empty() {
            return [HEAD, r#","scenes":[{"name":"empty"}]}"#].concat();
        }
        let number = |x: f32| decimal::text(f64::from(x));
        let triple =
            |[x, y, z]: [f32; 3]| ["[", &number(x), ",", &number(y), ",", &number(z), "]"].concat();
        let vertices = self.vertices.len().to_string();
        let indices = self.indices.len().to_string();
        let binary = (self.vertices.len() + self.indices.len()).to_string();
        let (count, corners) = (
            self.count().to_string(),
            (self.indices.len() / 4).to_string(),
        );
        [
            HEAD,
            r#","scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"name":"Bubblestone"}],"#,
            r#""meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"COLOR_0":2},"indices":3,"material":0}]}],"#,
            r#""materials":[{"pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":"#,
            &number(self.roughness),
            r#"}}],"buffers":[{"byteLength":"#,
            &binary,
            r#"}],"bufferViews":[{"buffer":0,"byteLength":"#,
            &vertices,
            r#","byteStride":"#,
            &STRIDE.to_string(),
            r#","target":34962},{"buffer":0,"byteOffset":"#,
            &vertices,
            r#","byteLength":"#,
            &indices,
            r#","target":34963}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":"#,
            &count,
            r#","min":"#,
            &triple(self.low),
            r#","max":"#,
            &triple(self.high),
            r#"},{"bufferView":0,"byteOffset":"#,
            &NORMAL.to_string(),
            r#","componentType":5126,"type":"VEC3","count":"#,
            &count,
            r#"},{"bufferView":0,"byteOffset":"#,
            &COLOUR.to_string(),
            r#","componentType":5123,"normalized":true,"type":"VEC4","count":"#,
            &count,
            r#"},{"bufferView":1,"componentType":5125,"type":"SCALAR","count":"#,
            &corners,
            "}]}",
        ]
        .concat()
    }
}

/// Adds words, the lowest byte first.
fn put(out: &mut Vec<u8>, words: &[u32]) {
    for word in words {
        out.extend_from_slice(&word.to_le_bytes());
    }
}
