//! How deep cells may reach into the walls.

use super::face_grid::region;
use crate::building::{Building, WallThickness};
use crate::trimesh::MeshFault;
use glam::DVec2;

/// The most places of a face at which its wall is measured.
const MOST: usize = 64;

/// Where it is measured on the way from the middle of a part to a corner.
const WAYS: [f64; 2] = [0.5, 0.94];

/// The least thickness of the wall behind each face, in the order of the building's faces (metres); infinite where the
/// building is open. It is measured at the middles of the face's convex parts, and on the ways from there to their
/// corners.
///
/// # Errors
/// If the building's polygons are no mesh.
pub fn thicknesses(building: &Building) -> Result<Vec<f64>, MeshFault> {
    let thickness = WallThickness::new(building)?;
    let least = building.face_ids().map(|id| {
        let [parts, _] = region(building.face(id)).convex_parts(DVec2::ZERO);
        let places = parts.iter().flat_map(|part| {
            let middle = part.centre();
            let ways = part
                .places()
                .flat_map(move |corner| WAYS.map(|way| middle.lerp(corner, way)));
            [middle].into_iter().chain(ways).collect::<Vec<DVec2>>()
        });
        let found = places
            .take(MOST)
            .filter_map(|place| thickness.behind(id, place.x, place.y));
        found.fold(f64::INFINITY, f64::min)
    });
    Ok(least.collect())
}
