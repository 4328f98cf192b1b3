//! One mesh for all bodies of a GLB file: a program then draws each material at once.
//!
//! All vertices are in one list. Each material has one list of triangles, which index that list.

use super::super::bytes::put;
use super::super::frame::ExportSpace;
use super::{BARE, Glb, INDICES, WHITE, fill};
use crate::order::{greater, lesser};
use crate::solid::Surface;
use std::collections::BTreeMap;

/// The text of a mesh before and after its primitives.
const MESH: [&str; 2] = [r#",{"primitives":["#, "]}"];

/// The bodies added so far.
pub(super) struct Joined {
    /// The number of vertices, and their least and greatest coordinates.
    count: usize,
    bounds: [[f32; 3]; 2],
    /// The corners of the triangles of each material, after each other.
    corners: BTreeMap<usize, Vec<u32>>,
}

impl Joined {
    fn new() -> Self {
        Self {
            count: 0,
            bounds: [[f32::MAX; 3], [f32::MIN; 3]],
            corners: BTreeMap::new(),
        }
    }

    /// Adds a body with a material to the file's only mesh.
    fn add(&mut self, glb: &mut Glb, frame: &ExportSpace, surface: &Surface, material: usize) {
        let [low, high] = glb.put_vertices(frame, surface);
        for k in 0..3 {
            self.bounds[0][k] = lesser(self.bounds[0][k], low[k]);
            self.bounds[1][k] = greater(self.bounds[1][k], high[k]);
        }
        let first = self.count as u32;
        let corners = self.corners.entry(material).or_default();
        for &triangle in &surface.triangles {
            corners.extend(frame.turned(triangle).map(|k| first + k));
        }
        self.count += surface.positions.len();
    }

    /// Describes the mesh in the file.
    fn finish(self, glb: &mut Glb) {
        if self.count == 0 {
            return;
        }
        glb.describe(0, self.count, self.bounds);
        for (k, (material, corners)) in self.corners.into_iter().enumerate() {
            glb.put_corners(&corners);
            glb.add_part(k, material);
        }
        glb.end_parts();
    }
}

impl Glb {
    /// The same empty file, for one mesh of all bodies if `joined`.
    pub fn joined(mut self, joined: bool) -> Self {
        self.joined = joined.then(Joined::new);
        self
    }

    /// A file of surfaces in a model's own axes, with places in charts.
    pub fn of_model(roughness: f32, joined: bool) -> Self {
        Self::new(roughness, None, false).joined(joined)
    }

    /// A file of bodies in a scene's axes, without places.
    pub fn of_scene(roughness: f32, joined: bool, is_white: bool) -> Self {
        let layout = if is_white && !joined { &WHITE } else { &BARE };
        Self {
            layout,
            ..Self::of_model(roughness, joined)
        }
    }

    /// Adds a body to the only mesh; false if each body has its own.
    pub fn join(&mut self, frame: &ExportSpace, surface: &Surface, material: usize) -> bool {
        let Some(mut joined) = self.joined.take() else {
            return false;
        };
        joined.add(self, frame, surface, material);
        self.joined = Some(joined);
        true
    }

    /// Whether bodies are joined to one mesh.
    pub fn is_joined(&self) -> bool {
        self.joined.is_some()
    }

    /// Adds the corners of triangles, as indices of all vertices, with their accessor.
    fn put_corners(&mut self, corners: &[u32]) {
        let numbers = [corners.len() as f64, self.indices.len() as f64, 5125.0];
        fill(&mut self.accessors, INDICES, &numbers);
        put(&mut self.indices, corners);
    }

    /// Adds the part of the only mesh that has this material, the `k`-th from 0.
    fn add_part(&mut self, k: usize, material: usize) {
        let each = self.layout.attributes.len();
        let accessors = (0..each).chain([each + k, material]);
        let numbers: Vec<f64> = accessors.map(|n| n as f64).collect();
        let mut mesh = String::new();
        fill(&mut mesh, self.layout.mesh, &numbers);
        // The primitive without the mesh around it.
        let primitive = mesh
            .strip_prefix(MESH[0])
            .and_then(|rest| rest.strip_suffix(MESH[1]));
        self.meshes += if k == 0 { MESH[0] } else { "," };
        self.meshes += primitive.unwrap_or_default();
    }

    /// Ends the only mesh, and adds its node.
    fn end_parts(&mut self) {
        self.meshes += MESH[1];
        self.nodes += r#",{"name":"all","mesh":0}"#;
        self.list_node();
    }

    /// The same file with its only mesh described, if bodies are joined.
    pub(super) fn described(mut self) -> Self {
        if let Some(joined) = self.joined.take() {
            joined.finish(&mut self);
        }
        self
    }
}
