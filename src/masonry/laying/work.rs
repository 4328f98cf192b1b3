//! Work on a site in small parts, so that a page can answer between them.

use super::site::Site;
use crate::masonry::region::PartsWork;

/// Work that is done part by part. Its results do not depend on how many parts are done at a time.
pub(super) trait SiteWork {
    /// Does a part of the work, about a row of bricks. True if nothing is left.
    fn advance(&mut self, site: &mut Site) -> bool;
}

/// Corners, sides and diagonals of a face's convex parts in a slice. The corners of a disc come one by one, and each of
/// them flips nearly all diagonals.
const PARTS: usize = 200;

/// Makes the occupancy maps of all faces, one after the other.
#[derive(Default)]
pub(super) struct MapWork {
    /// The convex parts of the next face.
    parts: Option<PartsWork>,
}

impl SiteWork for MapWork {
    fn advance(&mut self, site: &mut Site) -> bool {
        let parts = self.parts.get_or_insert_with(|| site.next_parts());
        let region = &site.regions[site.faces.len()];
        if let Some(parts) = parts.advance(region, &mut { PARTS }) {
            self.parts = None;
            site.add_map(parts);
        }
        site.has_all_maps()
    }
}

#[cfg(test)]
mod tests {
    use super::super::site::PIXELS;
    use super::*;
    use crate::building::{Building, Module, obj};
    use crate::masonry::plan::{Plan, ThicknessWork};
    use std::f64::consts::TAU;
    use std::sync::Arc;

    /// A wall round a star with this many corners.
    fn star(corners: usize) -> Arc<Building> {
        let place = |k: usize| {
            let (sin, cos) = libm::sincos(TAU * k as f64 / corners as f64);
            let r = [5.0, 4.0][k % 2];
            [r * cos, -r * sin]
        };
        let mut text = String::new();
        for y in [0, 3] {
            for [x, z] in (0..corners).map(place) {
                text += &format!("v {x} {y} {z}\n");
            }
        }
        for k in 0..corners {
            let next = (k + 1) % corners;
            let [a, b, c, d] = [k, next, next + corners, k + corners].map(|k| k + 1);
            text += &format!("f {a} {b} {c} {d}\n");
        }
        let list = |numbers: &mut dyn Iterator<Item = usize>| {
            let each: Vec<String> = numbers.map(|k| k.to_string()).collect();
            format!("f {}\n", each.join(" "))
        };
        text += &list(&mut (1..=corners).rev());
        text += &list(&mut (corners + 1..=2 * corners));
        let draft = obj::read(text.as_bytes(), &obj::FileSpace::METRES)
            .expect("a file")
            .draft;
        Arc::new(Building::new(&draft).expect("a building"))
    }

    /// Two faces of a star have many corners, and are triangulated in several slices.
    #[test]
    fn faces_with_many_corners_take_several_slices() {
        let building = star(240);
        let faces = building.faces().len();
        assert_eq!(faces, 242);
        // Each corner and each side of both faces takes a part of the work. Up to two diagonals for each corner may add
        // to this.
        let more = 2 * 2 * 240 / PARTS;
        let mut work = ThicknessWork::new(building.clone()).expect("a mesh");
        let mut slices = 1;
        while work.advance().is_none() {
            slices += 1;
        }
        assert!(slices >= faces.div_ceil(4) + more, "{slices}");
        let plan = Plan::new(&building, Module::NORMAL, |_| 0.2).expect("a plan");
        let mut site = Site::new(building, plan, PIXELS);
        let (mut work, mut slices) = (MapWork::default(), 1);
        while !work.advance(&mut site) {
            slices += 1;
        }
        assert!(slices >= faces + more, "{slices}");
    }
}
