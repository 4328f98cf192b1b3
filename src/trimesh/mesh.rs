//! An oriented triangle mesh: each edge joins two triangles or lies on the border.

use crate::csr::NONE;
use glam::DVec3;

/// Why triangles do not make a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshFault {
    /// There are no triangles.
    Empty,
    /// A corner is not the number of a vertex, or two corners of a triangle are the same.
    BadTriangle,
    /// A coordinate is not finite.
    NotFinite,
    /// An edge has more than two triangles, or two that run along it in the same direction.
    BadEdge,
}

/// An oriented triangle mesh: each directed edge occurs once.
///
/// Where the border touches itself at a place, that place has a vertex for each connected fan of corners (see
/// [`TriMesh::fan`]). Whoever makes a mesh has to split such vertices.
#[derive(Clone, Debug, PartialEq)]
pub struct TriMesh {
    pub(super) positions: Vec<DVec3>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// For each edge of each triangle, the same edge in the triangle beyond it, as `3 * triangle + edge`, or
    /// [`NONE`].
    pub(super) across: Vec<[u32; 3]>,
    pub(super) normals: Vec<DVec3>,
    /// The unit normals of the triangles.
    pub(super) faces: Vec<DVec3>,
    /// One corner of each vertex, `3 * triangle + corner`. On the border it is the first one counter-clockwise.
    pub(super) first: Vec<u32>,
    pub(super) area: f64,
}

impl TriMesh {
    /// The vertices, in the mesh's units.
    pub fn positions(&self) -> &[DVec3] {
        &self.positions
    }

    /// The mesh at another place: all vertices are moved by the same vector.
    pub fn moved_by(mut self, by: DVec3) -> Self {
        self.positions.iter_mut().for_each(|p| *p += by);
        self
    }

    /// The triangles' corners, counter-clockwise seen from outside.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The unit normals of the vertices.
    pub fn normals(&self) -> &[DVec3] {
        &self.normals
    }

    /// The area of all triangles together.
    pub fn area(&self) -> f64 {
        self.area
    }

    /// The positions of a triangle's corners.
    #[inline]
    pub fn corners(&self, triangle: u32) -> [DVec3; 3] {
        self.triangles[triangle as usize].map(|v| self.positions[v as usize])
    }

    /// The triangle beyond the edge from corner `k` to the next one, and the number of that edge there. `None` at the
    /// border.
    #[inline]
    pub fn across(&self, triangle: u32, k: usize) -> Option<(u32, usize)> {
        let other = self.across[triangle as usize][k];
        (other != NONE).then_some((other / 3, (other % 3) as usize))
    }

    /// The unit normal of a triangle's plane; zero if the triangle has no area.
    #[inline]
    pub fn face_normal(&self, triangle: u32) -> DVec3 {
        self.faces[triangle as usize]
    }

    /// The area of a triangle.
    pub fn area_of(&self, triangle: u32) -> f64 {
        let [a, b, c] = self.corners(triangle);
        0.5 * (b - a).cross(c - a).length()
    }

    /// The unit normal at a point of a triangle with these barycentric weights.
    pub fn normal_at(&self, triangle: u32, weights: DVec3) -> DVec3 {
        let [a, b, c] = self.triangles[triangle as usize].map(|v| self.normals[v as usize]);
        let sum = a * weights.x + b * weights.y + c * weights.z;
        sum.try_normalize()
            .unwrap_or_else(|| self.face_normal(triangle))
    }

    /// The barycentric weights of a point in the plane of a triangle; they sum to 1.
    pub fn weights(&self, triangle: u32, p: DVec3) -> DVec3 {
        let [a, b, c] = self.corners(triangle);
        let normal = (b - a).cross(c - a);
        let square = normal.length_squared();
        if square == 0.0 {
            return DVec3::splat(1.0 / 3.0);
        }
        let of = |p: DVec3, q: DVec3, r: DVec3| (q - p).cross(r - p).dot(normal) / square;
        DVec3::new(of(p, b, c), of(p, c, a), of(p, a, b))
    }

    /// The corners around a vertex, as `(triangle, corner)`, counter-clockwise seen from outside. On the border they
    /// run from one end of the fan to the other.
    pub fn fan(&self, vertex: u32) -> impl Iterator<Item = (u32, usize)> + '_ {
        let first = self.first[vertex as usize];
        let mut next = (first != NONE).then_some((first / 3, (first % 3) as usize));
        let start = next;
        std::iter::from_fn(move || {
            let (t, k) = next?;
            // Go on over the edge that ends at the vertex.
            next = self.across(t, (k + 2) % 3).filter(|&to| Some(to) != start);
            Some((t, k))
        })
    }

    /// Whether the vertex lies on the border.
    pub fn is_on_border(&self, vertex: u32) -> bool {
        let first = self.first[vertex as usize];
        first != NONE && self.across[(first / 3) as usize][(first % 3) as usize] == NONE
    }

    /// The Euler characteristic: vertices in use, minus edges, plus triangles.
    pub fn euler(&self) -> i64 {
        let vertices = self.first.iter().filter(|&&first| first != NONE).count() as i64;
        let borders = self.across.iter().flatten().filter(|&&t| t == NONE).count() as i64;
        let faces = self.triangles.len() as i64;
        vertices - (3 * faces + borders) / 2 + faces
    }

    /// The least and greatest corner of the bounding box.
    pub fn bounds(&self) -> (DVec3, DVec3) {
        let first = self.positions[0];
        let each = self.positions.iter();
        each.fold((first, first), |(lo, hi), &p| (lo.min(p), hi.max(p)))
    }

    /// The cube that has the least corner and the longest side of the bounding box: this corner and this side, above 0.
    pub(crate) fn bounding_cube(&self) -> (DVec3, f64) {
        let (lo, hi) = self.bounds();
        (lo, (hi - lo).max_element().max(f64::MIN_POSITIVE))
    }

    /// The diagonal of the bounding box.
    pub fn diagonal(&self) -> f64 {
        let (lo, hi) = self.bounds();
        (hi - lo).length()
    }
}

#[cfg(test)]
mod tests;
