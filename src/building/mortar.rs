//! The mortar between the cells: the building's surface, shrunk (Legakis, Dorsey, Gortler 2001, section 5.4).

use super::ids::{FaceId, VertexId};
use super::labels::GLASS;
use super::surface::FaceSurface;
use super::whole::Building;
use glam::DVec3;

/// Normals with a greater cosine between them count as equal.
const SAME: f64 = 1.0 - 1e-9;

/// The shrunk surface of a building, in triangles.
#[derive(Clone, Debug, PartialEq)]
pub struct Mortar {
    /// The vertices of the child mesh in their order, moved inwards (metres).
    pub positions: Vec<DVec3>,
    /// The triangles, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// The face that each triangle is part of.
    pub faces: Vec<FaceId>,
}

impl Mortar {
    /// Moves the surface inwards by `recess` (metres). Each vertex moves by the shortest vector x with x.n = -recess
    /// for the normals n of all its faces; where more than three planes meet, by the least-squares solution. Faces of
    /// glass stay where they are. Where a wall bulges, the middle of a straight block lies behind the surface; mortar
    /// there moves in by that much more. `widest` gives the length of the widest block on each face (metres).
    pub fn new(building: &Building, recess: f64, widest: impl Fn(FaceId) -> f64) -> Self {
        let mut planes: Vec<Vec<(DVec3, f64)>> = vec![Vec::new(); building.vertices().len()];
        let (mut triangles, mut faces) = (Vec::new(), Vec::new());
        for polygon in building.polygons() {
            let face = building.face(polygon.face);
            let depth = match face.has_label(GLASS) {
                true => 0.0,
                false => recess,
            };
            for &v in &polygon.vertices {
                let place = face.surface.project(building.vertex(v).position);
                let normal = face.surface.frame(place.x, place.y).normal;
                let bulge = match depth > 0.0 {
                    true => bulge(&face.surface, place, widest(polygon.face)),
                    false => 0.0,
                };
                add_plane(&mut planes[v.index()], normal, depth + bulge);
            }
            let fan = polygon.vertices.windows(2).skip(1);
            for pair in fan {
                triangles.push([polygon.vertices[0], pair[0], pair[1]].map(|v: VertexId| v.0));
                faces.push(polygon.face);
            }
        }
        let vertices = building.vertices().iter().zip(&planes);
        Self {
            positions: vertices
                .map(|(v, planes)| v.position + inwards(planes))
                .collect(),
            triangles,
            faces,
        }
    }
}

/// How far the middle of a straight block lies behind the surface at a place, if both of its ends lie on the surface
/// (metres); 0 where the surface is flat or hollow.
fn bulge(surface: &FaceSurface, place: DVec3, block: f64) -> f64 {
    let middle = surface.frame(place.x, place.y);
    let ends = [-0.5, 0.5].map(|way| surface.frame(place.x + way * block, place.y).origin);
    let behind = ends.map(|end| (middle.origin - end).dot(middle.normal));
    behind[0].min(behind[1]).max(0.0)
}

/// Adds a plane unless it is there already.
fn add_plane(planes: &mut Vec<(DVec3, f64)>, normal: DVec3, depth: f64) {
    if planes.iter().all(|known| known.0.dot(normal) < SAME) {
        planes.push((normal, depth));
    }
}

/// The shortest x for which the sum of (x.n + depth)^2 over all planes is least.
///
/// Conjugate gradients on the normal equations from x = 0 (Hestenes, Stiefel 1952, Methods of conjugate gradients for
/// solving linear systems): three steps solve them in space, and x stays in the span of the normals.
fn inwards(planes: &[(DVec3, f64)]) -> DVec3 {
    let times = |v: DVec3| planes.iter().map(|(n, _)| *n * n.dot(v)).sum::<DVec3>();
    let mut x = DVec3::ZERO;
    let mut residual: DVec3 = planes.iter().map(|(n, depth)| *n * -depth).sum();
    let mut way = residual;
    for _ in 0..4 {
        let (square, image) = (residual.length_squared(), times(way));
        let curve = way.dot(image);
        if curve <= 1e-24 {
            break;
        }
        let step = square / curve;
        x += way * step;
        residual -= image * step;
        way = residual + way * (residual.length_squared() / square);
    }
    x
}

#[cfg(test)]
mod tests {
    use super::super::tests::all;
    use super::*;

    #[test]
    fn every_face_moves_in_by_the_recess() {
        for (name, _, building) in all() {
            let mortar = Mortar::new(building, 0.006, |_| 0.0);
            assert!(
                mortar.triangles.len() >= building.polygons().len(),
                "{name}"
            );
            // More than three planes can meet in one vertex. At a gable one move satisfies all of them. In the inner
            // corner of an L the two roofs may have different pitches, so the limit is looser there.
            let limit = match name.contains("lhouse") {
                true => 1e-3,
                false => 1e-6,
            };
            for (triangle, &id) in mortar.triangles.iter().zip(&mortar.faces) {
                let face = building.face(id);
                let wanted = match face.has_label(GLASS) {
                    true => 0.0,
                    false => -0.006,
                };
                for &v in triangle {
                    let was = building.vertices()[v as usize].position;
                    let moved = mortar.positions[v as usize] - was;
                    let place = face.surface.project(was);
                    let normal = face.surface.frame(place.x, place.y).normal;
                    assert!(
                        (moved.dot(normal) - wanted).abs() < limit,
                        "{name} {moved} {normal}"
                    );
                }
            }
        }
    }

    #[test]
    fn the_shortest_move_is_taken() {
        let one = inwards(&[(DVec3::X, 0.1)]);
        assert!(one.distance(DVec3::X * -0.1) < 1e-15);
        let slanted = DVec3::new(0.6, 0.8, 0.0);
        let two = inwards(&[(DVec3::X, 0.1), (slanted, 0.1)]);
        assert!(two.z == 0.0 && (two.dot(slanted) + 0.1).abs() < 1e-12);
        assert_eq!(inwards(&[]), DVec3::ZERO);
    }

    #[test]
    fn mortar_of_a_bulging_wall_lies_behind_the_middle_of_straight_blocks() {
        let [recess, block] = [0.006, 0.25];
        let towers = all().iter().filter(|(name, ..)| name.contains("tower"));
        assert!(towers.clone().count() > 0);
        for (name, _, building) in towers {
            let [flush, sunk] = [0.0, block].map(|block| Mortar::new(building, recess, |_| block));
            let moved = flush.positions.iter().zip(&sunk.positions);
            let most = moved.map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
            let face = building.faces().iter().find(|face| !face.surface.is_flat());
            let radius =
                face.and_then(|face| face.surface.period()).unwrap() / std::f64::consts::TAU;
            let sagitta = radius - (radius * radius - 0.25 * block * block).sqrt();
            assert!(
                (most - sagitta).abs() < 0.05 * sagitta,
                "{name} {most} {sagitta}"
            );
        }
    }
}
