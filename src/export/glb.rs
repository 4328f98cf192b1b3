//! Surfaces as a GLB file: glTF 2.0 in one binary (Khronos Group, ISO/IEC 12113:2022).
//!
//! The file has a node with a mesh for each stone, named by its id, and one for the ground. Bodies of a scene share
//! meshes, and meshes share surfaces. On request, all bodies are joined to one mesh. There are three kinds of files:
//!
//! - *Plain*: a vertex has position, normal, colour and place in the maps. The colour is linear red, green, blue and
//!   full alpha, with 16 bits each, as 8 bits are too few for dark colours.
//! - *For a scene*: the same without a place.
//! - *With images* of colour, normals, and occlusion, roughness and metal: a vertex has position and place in the
//!   maps. All normals point up and all tangents to the right of the picture. The map of normals has complete
//!   normals, not differences from those of a mesh: with the mesh's own normals they would tilt twice.
//!
//! Places in maps begin at the upper left corner of the picture. Those of a model are places in charts.

#[cfg(house)]
mod bodies;
#[cfg(house)]
mod joined;
mod layout;
mod template;

use super::bytes::{put, put_floats};
use super::frame::ExportSpace;
use super::maps::id_colour;
use crate::light::decoded;
use crate::order::{greater, lesser};
use crate::solid::Surface;
#[cfg(house)]
use crate::surface_stones::Fit;
#[cfg(house)]
use joined::Joined;
#[cfg(house)]
use layout::{BARE, WHITE};
use layout::{BUFFERS, HEAD, IMAGE, INDICES, LISTS, Layout, PLACED, PLAIN, SHARED};
use template::{fill, fill_up};

/// The normal and tangent that all vertices share in a file with images.
const UPRIGHT: [&[f32]; 2] = [&[0.0, 1.0, 0.0], &[1.0, 0.0, 0.0, 1.0]];

/// The magic numbers of the format and of its two chunks.
const GLTF: u32 = u32::from_le_bytes(*b"glTF");
const JSON: u32 = u32::from_le_bytes(*b"JSON");
const BIN: u32 = u32::from_le_bytes(*b"BIN\0");

/// A material of bodies.
#[cfg(house)]
pub(super) struct FileMaterial {
    pub name: Option<String>,
    /// The colour (sRGB).
    pub tint: [u8; 3],
    /// How opaque it is, 0..1.
    pub alpha: f32,
    /// How metallic it is, 0..1.
    pub metal: f32,
    pub roughness: f32,
}

/// A GLB file that is being made.
pub(super) struct Glb {
    roughness: f32,
    /// The bytes of each image that follows the file's last part.
    images: Option<[u32; 3]>,
    /// Whether maps repeat.
    tile: bool,
    layout: &'static Layout,
    vertices: Vec<u8>,
    indices: Vec<u8>,
    /// The most vertices of a mesh.
    most: usize,
    /// The number of surfaces written.
    surfaces_made: usize,
    /// The number of meshes made of these surfaces.
    meshes_made: usize,
    /// The number of nodes that have one of these meshes.
    nodes_made: usize,
    /// Lists of the JSON, with a comma before each item.
    children: String,
    nodes: String,
    /// Materials after the first one.
    #[cfg(house)]
    materials: String,
    #[cfg(house)]
    materials_made: usize,
    /// The map from the file to the coordinates of its surfaces.
    #[cfg(house)]
    fit: Fit,
    meshes: String,
    accessors: String,
    linear: [u32; 256],
    /// The only mesh, if bodies are joined.
    #[cfg(house)]
    joined: Option<Joined>,
}

impl Glb {
    /// A file of surfaces with this roughness, 0..1. `images` are the sizes of images in bytes: the caller has to
    /// append these, each padded to a multiple of four bytes.
    pub fn new(roughness: f32, images: Option<[u32; 3]>, tile: bool) -> Self {
        let linear = |v| (decoded(v as f64 / 255.0) * 65535.0 + 0.5) as u32;
        Self {
            roughness,
            images,
            tile,
            layout: if images.is_some() { &PLACED } else { &PLAIN },
            vertices: Vec::new(),
            indices: Vec::new(),
            most: 0,
            surfaces_made: 0,
            meshes_made: 0,
            nodes_made: 0,
            children: String::new(),
            nodes: String::new(),
            #[cfg(house)]
            materials: String::new(),
            #[cfg(house)]
            materials_made: 0,
            #[cfg(house)]
            fit: Fit::default(),
            meshes: String::new(),
            accessors: String::new(),
            linear: std::array::from_fn(linear),
            #[cfg(house)]
            joined: None,
        }
    }

    /// Adds the surface of the stone with this id, or of the ground for 0.
    pub fn add(&mut self, frame: &ExportSpace, surface: &Surface, id: u32) {
        #[cfg(house)]
        if self.join(frame, surface, 0) {
            return;
        }
        let surface = self.add_surface(frame, surface);
        let mesh = self.add_mesh(surface, 0);
        self.add_stone(mesh, id);
    }

    /// Adds a surface, for meshes to use; returns its number.
    pub(super) fn add_surface(&mut self, frame: &ExportSpace, surface: &Surface) -> usize {
        let (first, count) = (self.vertices.len(), surface.positions.len());
        let bounds = self.put_vertices(frame, surface);
        self.describe(first, count, bounds);
        self.index(frame, &surface.triangles, count);
        self.surfaces_made += 1;
        self.surfaces_made - 1
    }

    /// Adds the vertices of a surface; returns their least and greatest coordinates.
    fn put_vertices(&mut self, frame: &ExportSpace, surface: &Surface) -> [[f32; 3]; 2] {
        let (mut low, mut high) = ([f32::MAX; 3], [f32::MIN; 3]);
        for (k, &p) in surface.positions.iter().enumerate() {
            let at = frame.place(p);
            for (k, &v) in at.iter().enumerate() {
                low[k] = lesser(low[k], v);
                high[k] = greater(high[k], v);
            }
            put_floats(&mut self.vertices, &at);
            if self.images.is_none() {
                put_floats(&mut self.vertices, &frame.direction(surface.normals[k]));
            }
            if self.layout.has_colours {
                let [r, g, b] = surface.colours[k].map(|c| self.linear[usize::from(c)]);
                put(&mut self.vertices, &[g << 16 | r, 0xFFFF_0000 | b]);
            }
            if let Some(at) = frame.place_in_maps(p) {
                put_floats(&mut self.vertices, &at);
            }
        }
        [low, high]
    }

    /// Adds a mesh with a surface and a material; returns its number.
    pub(super) fn add_mesh(&mut self, surface: usize, material: usize) -> usize {
        let each = self.layout.attributes.len() + 1;
        let accessors = (0..each).map(|k| each * surface + k);
        let numbers: Vec<f64> = accessors.chain([material]).map(|n| n as f64).collect();
        fill(&mut self.meshes, self.layout.mesh, &numbers);
        self.meshes_made += 1;
        self.meshes_made - 1
    }

    /// Adds the accessors of the vertices that begin at byte `first`.
    fn describe(&mut self, first: usize, count: usize, [low, high]: [[f32; 3]; 2]) {
        self.most = self.most.max(count);
        for &(offset, accessor) in self.layout.attributes {
            let ([a, b, c], [d, e, f]) = (low.map(f64::from), high.map(f64::from));
            let numbers = [count as f64, (first + offset) as f64, a, b, c, d, e, f];
            fill(&mut self.accessors, accessor, &numbers);
        }
    }

    fn index(&mut self, frame: &ExportSpace, triangles: &[[u32; 3]], vertices: usize) {
        let (kind, bytes) = if vertices < 65_535 {
            (5123.0, 2)
        } else {
            (5125.0, 4)
        };
        let numbers = [
            3.0 * triangles.len() as f64,
            self.indices.len() as f64,
            kind,
        ];
        fill(&mut self.accessors, INDICES, &numbers);
        for &triangle in triangles {
            for k in frame.turned(triangle) {
                self.indices.extend_from_slice(&k.to_le_bytes()[..bytes]);
            }
        }
        fill_up(&mut self.indices, 0);
    }

    fn add_stone(&mut self, mesh: usize, id: u32) {
        let [r, g, b] = id_colour(id).map(f64::from);
        let (mesh, id) = (mesh as f64, f64::from(id));
        let (name, numbers) = match id {
            0.0 => (r#",{"name":"ground","mesh":@}"#, [mesh, 0.0, 0.0, 0.0, 0.0]),
            _ => (
                r#",{"name":"stone_@","mesh":@,"extras":{"id_map":[@,@,@]}}"#,
                [id, mesh, r, g, b],
            ),
        };
        fill(&mut self.nodes, name, &numbers);
        self.list_node();
    }

    /// Lists the last node among the children of the first one.
    fn list_node(&mut self) {
        self.nodes_made += 1;
        fill(&mut self.children, ",@", &[self.nodes_made as f64]);
    }

    /// The file in parts, without the images.
    pub fn finish(self) -> Vec<Vec<u8>> {
        #[cfg(house)]
        let this = self.described();
        #[cfg(not(house))]
        let this = self;
        this.written()
    }

    fn written(self) -> Vec<Vec<u8>> {
        let mut shared = Vec::new();
        for vector in UPRIGHT.into_iter().filter(|_| self.images.is_some()) {
            (0..self.most).for_each(|_| put_floats(&mut shared, vector));
        }
        let images = self.images.unwrap_or_default().map(filled);
        let own = self.vertices.len() + self.indices.len() + shared.len();
        let binary = own + images.iter().sum::<usize>();
        let mut json = self.json(own, binary).into_bytes();
        fill_up(&mut json, b' ');
        let total = 12 + 8 + json.len() + 8 + binary;
        let mut head = Vec::new();
        put(&mut head, &[GLTF, 2, total as u32, json.len() as u32, JSON]);
        head.append(&mut json);
        put(&mut head, &[binary as u32, BIN]);
        vec![head, self.vertices, self.indices, shared]
    }

    /// The JSON. `own` is the length of the binary chunk without images, `all` that with them.
    fn json(&self, own: usize, all: usize) -> String {
        let mut json = HEAD.to_owned();
        let wrap = if self.tile { 10_497.0 } else { 33_071.0 };
        let numbers = match self.images {
            None => [self.roughness.into(), 0.0],
            Some(_) => [wrap, wrap],
        };
        fill(&mut json, self.layout.material, &numbers);
        #[cfg(house)]
        if !self.materials.is_empty() {
            // The list continues after its first material.
            json.pop();
            json += &self.materials;
            json.push(']');
        }
        let [vertices, indices] = [&self.vertices, &self.indices].map(|part| part.len() as f64);
        let stride = self.layout.stride as f64;
        let numbers = [all as f64, vertices, stride, vertices, indices];
        fill(&mut json, BUFFERS, &numbers);
        if let Some(images) = self.images {
            let (begin, most) = (vertices + indices, self.most as f64);
            let views = [begin, 12.0 * most, begin + 12.0 * most, 16.0 * most];
            fill(&mut json, SHARED, &views);
            let mut at = own;
            for length in images {
                fill(&mut json, IMAGE, &[at as f64, length.into()]);
                at += filled(length);
            }
        }
        let parts = [&self.children, &self.nodes, &self.meshes, &self.accessors];
        for (k, before) in LISTS.into_iter().enumerate() {
            #[cfg(house)]
            let before = if k == 1 {
                self.root_end()
            } else {
                before.to_owned()
            };
            #[cfg(house)]
            let before = before.as_str();
            json += before;
            // The second list continues after a first node.
            let from = usize::from(k != 1);
            json += parts.get(k).and_then(|part| part.get(from..)).unwrap_or("");
        }
        json
    }
}

/// The length of an image with its padding.
fn filled(length: u32) -> usize {
    (length as usize).next_multiple_of(4)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn images_are_told_of_but_come_later() {
        let square = Surface {
            positions: vec![glam::Vec3::ZERO, glam::Vec3::X, glam::Vec3::Y],
            triangles: vec![[0, 1, 2]],
            ..Surface::default()
        };
        let mut glb = Glb::new(0.5, Some([5, 8, 1]), true);
        glb.add(&ExportSpace::Picture { unit: 1.0 }, &square, 7);
        let glb = glb.finish().concat();
        let told = u32::from_le_bytes([glb[8], glb[9], glb[10], glb[11]]);
        assert_eq!(told as usize, glb.len() + 8 + 8 + 4);
        assert_eq!(glb.len() % 4, 0);
        let text = String::from_utf8_lossy(&glb);
        assert!(text.contains(r#""name":"stone_7""#) && text.contains("\"wrapS\":10497"));
    }
}
