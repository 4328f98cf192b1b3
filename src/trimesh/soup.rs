//! Triangles as they stand in files.

use glam::DVec3;

/// Vertices and triangles between them; nothing about them is checked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Soup {
    /// The vertices, in the file's units.
    pub positions: Vec<DVec3>,
    /// The three vertices of each triangle.
    pub triangles: Vec<[u32; 3]>,
}

/// The most triangles of a model.
pub const MOST_TRIANGLES: usize = 2_000_000;
