//! Triangles as files have them.

use glam::DVec3;

/// Places, and triangles between them; nothing about them is promised.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Soup {
    /// Where vertices are, in the file's units.
    pub positions: Vec<DVec3>,
    /// The vertices of each triangle.
    pub triangles: Vec<[u32; 3]>,
}

/// No model may have more triangles.
pub const MOST_TRIANGLES: usize = 2_000_000;
