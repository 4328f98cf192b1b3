//! Surfaces as a GLB file: glTF 2.0 in one binary (Khronos Group, ISO/IEC 12113:2022).
//!
//! One mesh of one primitive. A vertex is its position and normal, three floats each, and its colour:
//! linear red, green, blue and a full alpha of 16 bits each, as 8 bits are too few for dark colours.

use super::surface::Frame;
use crate::decimal;
use crate::render::decoded;
use crate::texture::Surface;

/// Bytes of a vertex.
const STRIDE: usize = 32;
/// Where its normal and its colour begin.
const NORMAL: usize = 12;
const COLOUR: usize = 24;

/// A GLB file in the making.
pub(super) struct Glb {
    roughness: f32,
    vertices: Vec<u8>,
    indices: Vec<u8>,
    low: [f32; 3],
    high: [f32; 3],
    linear: [u16; 256],
}

impl Glb {
    /// A file of a surface that is rough by so much, 0..1.
    pub fn new(roughness: f32) -> Self {
        let linear = |v| (decoded(v as f64 / 255.0) * 65535.0 + 0.5) as u16;
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
                self.low[k] = crate::order::lesser(self.low[k], v);
                self.high[k] = crate::order::greater(self.high[k], v);
            }
            let [r, g, b] = surface.colours[k].map(|c| self.linear[usize::from(c)]);
            let floats = [at, frame.direction(surface.normals[k])];
            for v in floats.as_flattened() {
                self.vertices.extend_from_slice(&v.to_le_bytes());
            }
            for v in [r, g, b, u16::MAX] {
                self.vertices.extend_from_slice(&v.to_le_bytes());
            }
        }
        for &triangle in &surface.triangles {
            for k in frame.turned(triangle) {
                self.indices.extend_from_slice(&(first + k).to_le_bytes());
            }
        }
    }

    /// The file, part after part.
    pub fn finish(self) -> Vec<Vec<u8>> {
        let mut json = self.json().into_bytes();
        while json.len() % 4 > 0 {
            json.push(b' ');
        }
        let binary = self.vertices.len() + self.indices.len();
        let mut head = Vec::new();
        let mut words = |words: &[u32]| {
            words
                .iter()
                .for_each(|w| head.extend_from_slice(&w.to_le_bytes()));
        };
        let chunks = if binary > 0 { 8 + binary } else { 0 };
        words(&[0x4654_6C67, 2, (12 + 8 + json.len() + chunks) as u32]);
        words(&[json.len() as u32, 0x4E4F_534A]);
        head.append(&mut json);
        if binary > 0 {
            let words = [binary as u32, 0x004E_4942];
            words
                .iter()
                .for_each(|w| head.extend_from_slice(&w.to_le_bytes()));
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
