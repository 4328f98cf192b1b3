//! A level of detail, and its surface for pictures.

use super::{Mark, Part};
use crate::csr::Csr;
use crate::solid::Surface;
use crate::trimesh::TriMesh;
use glam::DVec3;

/// A closed mesh with the marks of its vertices.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// The mesh.
    pub mesh: TriMesh,
    /// The mark of each vertex.
    pub marks: Vec<Mark>,
}

impl Level {
    /// A simpler mesh with the marks of this one: each vertex has a mean of the marks around it. So bands that are
    /// finer than the triangles fade.
    pub(super) fn marked(&self, mesh: TriMesh) -> Self {
        let is_plain = self.marks.iter().all(|mark| *mark == Mark::BODY);
        let reach = 0.25 * mean_square(&mesh);
        let around = |&p: &DVec3| match is_plain {
            true => Mark::BODY,
            false => Mark::mean(self.mesh.positions().iter().zip(&self.marks).map(|(q, m)| {
                let near = reach / (reach + p.distance_squared(*q));
                (m, near * near * near * near)
            })),
        };
        Self {
            marks: mesh.positions().iter().map(around).collect(),
            mesh,
        }
    }

    /// The surface for pictures, which is split along sharp edges: those with a smaller cosine than `crease` between
    /// their triangles. `colour` gives the colour of a mark.
    pub fn surface(&self, crease: f64, colour: impl Fn(&Mark) -> [u8; 3]) -> Surface {
        let mesh = &self.mesh;
        let corners = mesh.triangles().as_flattened();
        let pairs = corners.iter().enumerate();
        let around = Csr::from_pairs(
            mesh.positions().len(),
            pairs.map(|(k, &v)| (v as usize, k as u32)),
        );
        let mut surface = Surface::default();
        let mut numbers = vec![0; corners.len()];
        for (v, &place) in mesh.positions().iter().enumerate() {
            let mut left: Vec<u32> = around.row(v).to_vec();
            while let Some(&first) = left.first() {
                let smooth = self.smooth_with(first, &left, crease);
                left.retain(|corner| !smooth.contains(corner));
                for &corner in &smooth {
                    numbers[corner as usize] = surface.positions.len() as u32;
                }
                surface.positions.push(place.as_vec3());
                surface.normals.push(self.normal(&smooth).as_vec3());
                surface.colours.push(colour(&self.marks[v]));
            }
        }
        surface.triangles = numbers.as_chunks::<3>().0.to_vec();
        surface
    }

    /// The corners of triangles at a vertex that can be reached from `first` over smooth edges, out of those in
    /// `among`.
    fn smooth_with(&self, first: u32, among: &[u32], crease: f64) -> Vec<u32> {
        let mut found = vec![first];
        let mut at = 0;
        while at < found.len() {
            let (t, k) = (found[at] / 3, found[at] as usize % 3);
            at += 1;
            // Both edges at this corner: the one that leaves it, and the one that comes to it.
            for edge in [k, (k + 2) % 3] {
                let Some((other, j)) = self.mesh.across(t, edge) else {
                    continue;
                };
                let corner = 3 * other + if edge == k { (j + 1) % 3 } else { j } as u32;
                let cosine = self.mesh.face_normal(t).dot(self.mesh.face_normal(other));
                let is_smooth = cosine >= crease || self.is_in_thread(t, edge);
                if is_smooth && among.contains(&corner) && !found.contains(&corner) {
                    found.push(corner);
                }
            }
        }
        found
    }

    /// Whether an edge lies in a thread, which is round however coarse it is.
    fn is_in_thread(&self, t: u32, edge: usize) -> bool {
        let corners = self.mesh.triangles()[t as usize];
        let ends = [corners[edge], corners[(edge + 1) % 3]];
        ends.iter()
            .all(|&v| self.marks[v as usize].part == Part::Thread)
    }

    /// The mean normal of corners, weighted by area and angle: so broad flats keep their own.
    fn normal(&self, corners: &[u32]) -> DVec3 {
        let sum = corners.iter().map(|&corner| {
            let (t, k) = (corner / 3, corner as usize % 3);
            let p = self.mesh.corners(t);
            let (a, b) = (p[(k + 1) % 3] - p[k], p[(k + 2) % 3] - p[k]);
            let across = a.cross(b);
            let angle = libm::atan2(across.length(), a.dot(b));
            across * angle
        });
        sum.sum::<DVec3>().try_normalize().unwrap_or(DVec3::Y)
    }
}

/// The mean squared length of the edges.
fn mean_square(mesh: &TriMesh) -> f64 {
    let squares = (0..mesh.triangles().len() as u32).map(|t| {
        let [a, b, c] = mesh.corners(t);
        a.distance_squared(b) + b.distance_squared(c) + c.distance_squared(a)
    });
    squares.sum::<f64>() / (3 * mesh.triangles().len()) as f64
}
