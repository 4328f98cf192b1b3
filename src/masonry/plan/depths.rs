//! How deep cells may reach into the walls.

use super::face_grid::region;
use crate::building::{Building, FaceId, WallThickness};
use crate::masonry::footprint::Footprint;
use crate::masonry::region::{PartsWork, Region};
use crate::trimesh::MeshFault;
use glam::DVec2;
use std::sync::Arc;

/// The most places of a face at which its wall is measured.
const MOST: usize = 64;

/// Where a wall is measured on the way from the middle of a convex part (0) to a corner (1).
const WAYS: [f64; 2] = [0.5, 0.94];

/// The number of faces in a slice of the work.
const SLICE: usize = 4;
/// The number of corners, sides and diagonals of convex parts in a slice.
const PARTS: usize = 200;

/// The least thickness of the wall behind each face, in the order of the building's faces (metres); infinite where the
/// building is open. It is measured at the middles of the face's convex parts, and on the ways from there to their
/// corners.
///
/// # Errors
/// If the building's polygons are no mesh.
pub fn thicknesses(building: &Arc<Building>) -> Result<Vec<f64>, MeshFault> {
    let mut work = ThicknessWork::new(building.clone())?;
    loop {
        if let Some(found) = work.advance() {
            return Ok(found);
        }
    }
}

/// As [`thicknesses`], in slices.
pub struct ThicknessWork {
    building: Arc<Building>,
    thickness: WallThickness,
    found: Vec<f64>,
    /// The next face's region, and its convex parts in the making.
    parts: Option<(Region, PartsWork)>,
}

impl ThicknessWork {
    /// Begins with the first face of a building.
    ///
    /// # Errors
    /// If the building's polygons are no mesh.
    pub fn new(building: Arc<Building>) -> Result<Self, MeshFault> {
        Ok(Self {
            thickness: WallThickness::new(building.clone())?,
            building,
            found: Vec::new(),
            parts: None,
        })
    }

    /// Measures some faces. Returns the thicknesses behind all of them at the end.
    pub fn advance(&mut self) -> Option<Vec<f64>> {
        let mut amount = PARTS;
        for id in self.building.face_ids().skip(self.found.len()).take(SLICE) {
            let (region, work) = self.parts.get_or_insert_with(|| {
                let region = region(self.building.face(id));
                let work = PartsWork::new(&region, DVec2::ZERO);
                (region, work)
            });
            let [parts, _] = work.advance(region, &mut amount)?;
            self.parts = None;
            let least = least(&self.thickness, &parts, id);
            self.found.push(least);
        }
        let is_done = self.found.len() == self.building.faces().len();
        is_done.then(|| std::mem::take(&mut self.found))
    }
}

/// The least thickness of the wall behind a face with these convex parts (metres).
fn least(thickness: &WallThickness, parts: &[Footprint], id: FaceId) -> f64 {
    let places = parts.iter().flat_map(|part| {
        let middle = part.centre();
        let ways = part
            .places()
            .flat_map(move |corner| WAYS.map(|way| middle.lerp(corner, way)));
        [middle].into_iter().chain(ways).collect::<Vec<DVec2>>()
    });
    // A place that is not thinner than those before it does not count, so its ray may end early.
    places.take(MOST).fold(f64::INFINITY, |least, place| {
        let found = thickness.behind(id, place.x, place.y, least);
        found.map_or(least, |found| least.min(found))
    })
}
