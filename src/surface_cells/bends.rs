//! Where the rim of a thin sheet turns between two cells.
//!
//! Cells on the two sides of a sheet meet along its rim. Around a corner of the rim one of them has the other along both of
//! its sides: there the line between the two needs a corner that is no middle of an element.

use super::middles::foot;
use crate::mesh::quads::Faces;
use crate::order;
use crate::surface_packing::SurfaceParticle;
use crate::trimesh::{NONE, SurfacePoint, TriMesh};

/// Cells whose normals are this far apart (their dot product) are on different sides of a sheet.
const OTHER_SIDE: f64 = -0.5;
/// The rim turns where it faces this far apart at two places (their dot product) ...
const TURNS: f64 = 0.8;
/// ... and not right back.
const BACK: f64 = -0.9;

/// Corners of the table, by the two elements between which they are.
#[derive(Default)]
pub(super) struct Bends(Vec<(u64, u32)>);

impl Bends {
    /// Of these elements; the corners go behind those in the table.
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

    /// The corner between two elements.
    pub fn between(&self, f: u32, g: u32) -> Option<u32> {
        let key = order::pair(f.min(g), f.max(g));
        let place = self.0.binary_search_by_key(&key, |b| b.0).ok()?;
        Some(self.0[place].1)
    }
}

/// Where what is straight about two places of a rim meets.
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
