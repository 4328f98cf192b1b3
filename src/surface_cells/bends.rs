//! Corners where the rim of a thin sheet turns between two cells.
//!
//! Cells on the two sides of a sheet meet along its rim. Around a corner of the rim, one cell has the other along two
//! of its sides: there the line between the two needs a corner that is not the middle of an element.

use super::middles::foot;
use crate::mesh::quads::Faces;
use crate::order;
use crate::surface_packing::SurfaceParticle;
use crate::trimesh::{NONE, SurfacePoint, TriMesh};

/// Cells are on different sides of a sheet if the dot product of their normals is less than this.
const OTHER_SIDE: f64 = -0.5;
/// The rim turns if the dot product of its directions at two places is less than this ...
const TURNS: f64 = 0.8;
/// ... and at least this: it does not turn right back.
const BACK: f64 = -0.9;

/// Corners in the table, by the pair of elements that they lie between; sorted.
#[derive(Default)]
pub(super) struct Bends(Vec<(u64, u32)>);

impl Bends {
    /// Finds the bends between neighbouring elements; their corners are appended to the table.
    pub fn new(
        mesh: &TriMesh,
        cells: &[SurfaceParticle],
        faces: &Faces,
        table: &mut Vec<SurfacePoint>,
    ) -> Self {
        let mut all = Vec::new();
        for (f, (face, adjacent)) in faces.faces.iter().zip(&faces.adjacent).enumerate() {
            let nodes = face.nodes();
            for k in 0..nodes.len() {
                let [a, b] = [nodes[k], nodes[(k + 1) % nodes.len()]].map(|c| &cells[c as usize]);
                let g = adjacent[k];
                let is_rim = a.centre.normal.dot(b.centre.normal) < OTHER_SIDE;
                if g == NONE || g <= f as u32 || !is_rim {
                    continue;
                }
                let ends = [f, g as usize].map(|f| table[f]);
                if let Some(place) = bend(mesh, [a, b], ends) {
                    all.push((order::pair(f as u32, g), table.len() as u32));
                    table.push(place);
                }
            }
        }
        all.sort_unstable();
        Self(all)
    }

    /// The corner in the table between two elements.
    pub fn between(&self, f: u32, g: u32) -> Option<u32> {
        let key = order::pair(f.min(g), f.max(g));
        let place = self.0.binary_search_by_key(&key, |b| b.0).ok()?;
        Some(self.0[place].1)
    }
}

/// The point where the straight lines through two places of a rim meet, brought onto the surface.
fn bend(
    mesh: &TriMesh,
    [a, b]: [&SurfaceParticle; 2],
    [p, q]: [SurfacePoint; 2],
) -> Option<SurfacePoint> {
    let across = a.centre.normal - b.centre.normal;
    let out = |n: &SurfacePoint| n.normal.reject_from(across).try_normalize();
    let (u, v) = (out(&p)?, out(&q)?);
    let cos = u.dot(v);
    if !(BACK..TURNS).contains(&cos) {
        return None;
    }
    let middle = p.at.midpoint(q.at);
    let (r, s) = (u.dot(p.at - middle), v.dot(q.at - middle));
    let sine = 1.0 - cos * cos;
    let to = middle + u * ((r - cos * s) / sine) + v * ((s - cos * r) / sine);
    Some(foot(mesh, p, to, (u + v).normalize(), a.size))
}
