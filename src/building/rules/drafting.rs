//! Puts drafts together: vertices by place, flat faces with their surfaces, extra meshes.

use crate::building::draft::{Draft, DraftArc, DraftFace, ExtraMesh};
use crate::building::facets;
use crate::building::surface::FaceSurface;
use crate::trimesh::polygon;
use glam::DVec3;

/// Places this close are one vertex (metres).
const SAME: f64 = 1e-6;
/// Normals with a greater vertical part than this are vertical.
const VERTICAL: f64 = 0.99;

/// A draft in the making.
#[derive(Default)]
pub(super) struct Drafting {
    pub draft: Draft,
}

impl Drafting {
    /// The number of the vertex at a place; a new vertex if there is none.
    pub fn vertex(&mut self, p: DVec3) -> u32 {
        let vertices = &mut self.draft.vertices;
        let known = vertices.iter().position(|q| q.distance(p) < SAME);
        known.unwrap_or_else(|| {
            vertices.push(p);
            vertices.len() - 1
        }) as u32
    }

    /// The loops as numbers of vertices.
    fn loops(&mut self, loops: &[Vec<DVec3>]) -> Vec<Vec<u32>> {
        let mut numbers = |ring: &Vec<DVec3>| ring.iter().map(|&p| self.vertex(p)).collect();
        loops.iter().map(&mut numbers).collect()
    }

    /// Declares the side between two places an arc: counter-clockwise about the axis. Both faces of a side may do so;
    /// the first call counts.
    pub fn arc(&mut self, from: DVec3, to: DVec3, centre: DVec3, axis: DVec3) {
        let arc = DraftArc {
            from: self.vertex(from),
            to: self.vertex(to),
            centre,
            axis,
        };
        let pair = |arc: &DraftArc| (arc.from.min(arc.to), arc.from.max(arc.to));
        if self
            .draft
            .arcs
            .iter()
            .all(|known| pair(known) != pair(&arc))
        {
            self.draft.arcs.push(arc);
        }
    }

    /// Adds a face.
    pub fn face(&mut self, labels: &[&str], surface: FaceSurface, loops: &[Vec<DVec3>]) {
        let loops = self.loops(loops);
        self.draft.faces.push(DraftFace {
            labels: labels.iter().map(|&label| label.to_owned()).collect(),
            surface: Some(surface),
            loops,
            thickness: None,
        });
    }

    /// Adds a flat face; its first loop is the outer one, counter-clockwise seen from outside.
    pub fn flat(&mut self, labels: &[&str], loops: &[Vec<DVec3>]) {
        self.face(labels, flat_surface(&loops[0]), loops);
    }

    /// Adds a flat face without holes that looks towards `outward`, whichever way its corners run.
    pub fn panel(&mut self, labels: &[&str], corners: &[DVec3], outward: DVec3) {
        let mut corners = corners.to_vec();
        if polygon::across(&corners).dot(outward) < 0.0 {
            corners.reverse();
        }
        self.flat(labels, &[corners]);
    }

    /// Adds a flat polygon to the extra mesh with this name.
    pub fn pane(&mut self, name: &str, material: &str, corners: &[DVec3]) {
        let Some(triangles) = polygon::cut(corners, |_, _| true) else {
            return;
        };
        let triangles = triangles.iter().map(|t| t.map(|k| k as u32));
        self.extra(name, material, corners, triangles);
    }

    /// Adds a mesh to the extra mesh with this name.
    pub fn extra(
        &mut self,
        name: &str,
        material: &str,
        positions: &[DVec3],
        triangles: impl Iterator<Item = [u32; 3]>,
    ) {
        let extras = &mut self.draft.extras;
        let known = extras.iter().position(|mesh| mesh.name == name);
        let at = known.unwrap_or_else(|| {
            extras.push(ExtraMesh {
                name: name.to_owned(),
                material: material.to_owned(),
                ..ExtraMesh::default()
            });
            extras.len() - 1
        });
        let mesh = &mut extras[at];
        let first = mesh.positions.len() as u32;
        mesh.positions.extend_from_slice(positions);
        mesh.triangles
            .extend(triangles.map(|t| t.map(|v| v + first)));
    }

    /// The finished draft, with the ground at y = 0.
    pub fn on_ground(mut self) -> Draft {
        self.draft.ground = Some(0.0);
        self.draft
    }
}

/// The plane of a loop as a surface. On a vertical plane t is the height; on a sloping one t grows upwards; on a level
/// one s runs along the longest side. s is 0 where it is least on the loop, and so is t unless the plane is vertical.
pub(in crate::building) fn flat_surface(ring: &[DVec3]) -> FaceSurface {
    let normal = polygon::across(ring).normalize_or_zero();
    let up = DVec3::Y - normal * normal.y;
    let t = match normal.y.abs() > VERTICAL {
        true => normal.cross(longest_side(ring)),
        false => up.normalize(),
    };
    let t = t.normalize_or(facets::perpendicular(DVec3::Y));
    let s = t.cross(normal);
    let least = |axis: DVec3| {
        ring.iter()
            .map(|p| p.dot(axis))
            .fold(f64::INFINITY, f64::min)
    };
    let start = if normal.y.abs() < SAME { 0.0 } else { least(t) };
    let origin = s * least(s) + t * start + normal * ring[0].dot(normal);
    FaceSurface::flat(origin, s, t)
}

/// The direction of the longest side. Keep the first of two that are equal within a hundredth of a millimetre.
fn longest_side(ring: &[DVec3]) -> DVec3 {
    let next = ring.iter().cycle().skip(1);
    let sides = ring.iter().zip(next).map(|(a, b)| *b - *a);
    let longer = |best: DVec3, side: DVec3| match side.length() > best.length() + 1e-5 {
        true => side,
        false => best,
    };
    sides.fold(DVec3::ZERO, longer).normalize_or_zero()
}
