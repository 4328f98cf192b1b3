//! A triangle mesh whose edges join two triangles, or end one.

use crate::order;
use glam::DVec3;

/// No triangle: what is across an edge of the border.
pub const NONE: u32 = u32::MAX;

/// Why triangles are no mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshFault {
    /// There are none.
    Empty,
    /// A corner is none of the vertices, or two corners of a triangle are the same.
    BadTriangle,
    /// A coordinate is no number.
    NotFinite,
    /// An edge of more than two triangles, or of two that run along it in the same direction.
    BadEdge,
}

/// An oriented triangle mesh: each directed edge is there once.
///
/// Vertices where the border touches itself are there once for each of the corners around them that hang together
/// (see [`TriMesh::fan`]); whoever makes a mesh sees to that.
#[derive(Clone, Debug, PartialEq)]
pub struct TriMesh {
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    across: Vec<[u32; 3]>,
    normals: Vec<DVec3>,
    /// Of each vertex one corner, `3 * triangle + corner`; where it is on the border, the first one counter-clockwise.
    first: Vec<u32>,
    area: f64,
}

impl TriMesh {
    /// Of vertices and triangles, counter-clockwise seen from outside.
    ///
    /// # Errors
    /// What is wrong with them.
    pub fn new(positions: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Result<Self, MeshFault> {
        if triangles.is_empty() {
            return Err(MeshFault::Empty);
        }
        if !positions.iter().all(|p| p.is_finite()) {
            return Err(MeshFault::NotFinite);
        }
        let count = positions.len() as u32;
        let is_bad = |t: &[u32; 3]| {
            t.iter().any(|&v| v >= count) || t[0] == t[1] || t[1] == t[2] || t[2] == t[0]
        };
        if triangles.iter().any(is_bad) {
            return Err(MeshFault::BadTriangle);
        }
        let across = across(&triangles)?;
        let mut mesh = Self {
            first: vec![NONE; positions.len()],
            normals: Vec::new(),
            area: 0.0,
            positions,
            triangles,
            across,
        };
        mesh.find_firsts();
        mesh.find_normals();
        mesh.area = (0..mesh.triangles.len() as u32)
            .map(|t| mesh.area_of(t))
            .sum();
        Ok(mesh)
    }

    fn find_firsts(&mut self) {
        for t in 0..self.triangles.len() {
            for k in 0..3 {
                let v = self.triangles[t][k] as usize;
                // Going round counter-clockwise begins where there is nothing before.
                let is_start = self.across[t][k] == NONE;
                if self.first[v] == NONE || is_start {
                    self.first[v] = (3 * t + k) as u32;
                }
            }
        }
    }

    /// Weighted with the angles at the vertex (Thurmer, Wuthrich 1998, Computing Vertex Normals from Polygonal Facets).
    fn find_normals(&mut self) {
        let mut normals = vec![DVec3::ZERO; self.positions.len()];
        for t in 0..self.triangles.len() as u32 {
            let corners = self.corners(t);
            let normal = self.face_normal(t);
            for k in 0..3 {
                let e = (corners[(k + 1) % 3] - corners[k]).normalize_or_zero();
                let f = (corners[(k + 2) % 3] - corners[k]).normalize_or_zero();
                let angle = libm::acos(e.dot(f).clamp(-1.0, 1.0));
                normals[self.triangles[t as usize][k] as usize] += angle * normal;
            }
        }
        self.normals = normals
            .into_iter()
            .map(|n| n.normalize_or(DVec3::Y))
            .collect();
    }

    /// The vertices, in the mesh's units.
    pub fn positions(&self) -> &[DVec3] {
        &self.positions
    }

    /// The triangles' corners, counter-clockwise seen from outside.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The unit normals of the vertices.
    pub fn normals(&self) -> &[DVec3] {
        &self.normals
    }

    /// The area of all triangles.
    pub fn area(&self) -> f64 {
        self.area
    }

    /// Where the corners of a triangle are.
    #[inline]
    pub fn corners(&self, triangle: u32) -> [DVec3; 3] {
        self.triangles[triangle as usize].map(|v| self.positions[v as usize])
    }

    /// The triangle beyond the edge from corner `k` to the next one, and the number of that edge there; nothing at the
    /// border.
    #[inline]
    pub fn across(&self, triangle: u32, k: usize) -> Option<(u32, usize)> {
        let other = self.across[triangle as usize][k];
        if other == NONE {
            return None;
        }
        let end = self.triangles[triangle as usize][(k + 1) % 3];
        let corners = &self.triangles[other as usize];
        let edge = (0..3).find(|&j| {
            corners[j] == end && corners[(j + 1) % 3] == self.triangles[triangle as usize][k]
        })?;
        Some((other, edge))
    }

    /// The unit normal of a triangle's plane; zero where it has no area.
    pub fn face_normal(&self, triangle: u32) -> DVec3 {
        let [a, b, c] = self.corners(triangle);
        (b - a).cross(c - a).normalize_or_zero()
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

    /// The barycentric weights of a point in the plane of a triangle.
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

    /// The corners around a vertex, `(triangle, corner)`, counter-clockwise seen from outside; on the border from one end
    /// to the other.
    pub fn fan(&self, vertex: u32) -> impl Iterator<Item = (u32, usize)> + '_ {
        let first = self.first[vertex as usize];
        let mut next = (first != NONE).then_some((first / 3, (first % 3) as usize));
        let start = next;
        std::iter::from_fn(move || {
            let (t, k) = next?;
            // Over the edge that comes to the vertex.
            next = self.across(t, (k + 2) % 3).filter(|&to| Some(to) != start);
            Some((t, k))
        })
    }

    /// Does the border go through a vertex?
    pub fn is_on_border(&self, vertex: u32) -> bool {
        let first = self.first[vertex as usize];
        first != NONE && self.across[(first / 3) as usize][(first % 3) as usize] == NONE
    }

    /// The border as closed rings of vertices, the surface on their left seen from outside.
    pub fn borders(&self) -> Vec<Vec<u32>> {
        let mut next: Vec<u32> = vec![NONE; self.positions.len()];
        for (t, triangle) in self.triangles.iter().enumerate() {
            for k in 0..3 {
                if self.across[t][k] == NONE {
                    next[triangle[k] as usize] = triangle[(k + 1) % 3];
                }
            }
        }
        let mut rings = Vec::new();
        for start in 0..next.len() as u32 {
            let mut ring = Vec::new();
            let mut at = start;
            while next[at as usize] != NONE {
                ring.push(at);
                at = std::mem::replace(&mut next[at as usize], NONE);
            }
            if !ring.is_empty() {
                rings.push(ring);
            }
        }
        rings
    }

    /// Of each triangle the number of the part that it hangs together with, over edges, and how many parts there are.
    pub fn parts(&self) -> (Vec<u32>, usize) {
        let mut part = vec![NONE; self.triangles.len()];
        let mut count = 0;
        for start in 0..part.len() {
            if part[start] != NONE {
                continue;
            }
            let mut open = vec![start as u32];
            part[start] = count;
            while let Some(t) = open.pop() {
                for &other in &self.across[t as usize] {
                    if other != NONE && part[other as usize] == NONE {
                        part[other as usize] = count;
                        open.push(other);
                    }
                }
            }
            count += 1;
        }
        (part, count as usize)
    }

    /// The Euler characteristic: vertices in use, less edges, plus triangles.
    pub fn euler(&self) -> i64 {
        let vertices = self.first.iter().filter(|&&first| first != NONE).count() as i64;
        let borders = self.across.iter().flatten().filter(|&&t| t == NONE).count() as i64;
        let faces = self.triangles.len() as i64;
        vertices - (3 * faces + borders) / 2 + faces
    }

    /// The corners of the box around it.
    pub fn bounds(&self) -> (DVec3, DVec3) {
        let first = self.positions[0];
        let each = self.positions.iter();
        each.fold((first, first), |(lo, hi), &p| (lo.min(p), hi.max(p)))
    }

    /// The diagonal of the box around it.
    pub fn diagonal(&self) -> f64 {
        let (lo, hi) = self.bounds();
        (hi - lo).length()
    }
}

/// For each edge of each triangle the triangle on its other side.
fn across(triangles: &[[u32; 3]]) -> Result<Vec<[u32; 3]>, MeshFault> {
    // Edges with the lesser vertex first, and which edge of which triangle it is.
    let mut edges: Vec<(u64, u32)> = Vec::with_capacity(3 * triangles.len());
    for (t, corners) in triangles.iter().enumerate() {
        for k in 0..3 {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            edges.push((order::pair(a.min(b), a.max(b)), (3 * t + k) as u32));
        }
    }
    edges.sort_unstable();
    let mut across = vec![[NONE; 3]; triangles.len()];
    let mut at = 0;
    while at < edges.len() {
        let same = edges[at..]
            .iter()
            .take_while(|e| e.0 == edges[at].0)
            .count();
        if same > 2 {
            return Err(MeshFault::BadEdge);
        }
        if same == 2 {
            let [a, b] =
                [edges[at].1, edges[at + 1].1].map(|c| ((c / 3) as usize, (c % 3) as usize));
            if triangles[a.0][a.1] == triangles[b.0][b.1] {
                return Err(MeshFault::BadEdge);
            }
            across[a.0][a.1] = b.0 as u32;
            across[b.0][b.1] = a.0 as u32;
        }
        at += same;
    }
    Ok(across)
}
