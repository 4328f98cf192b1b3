//! Groups of walls that share their courses.

use super::face_grid::is_wall;
use crate::building::{Building, FaceId};

/// For each wall the first wall of its group: the walls that vertical edges connect. Other faces are groups of their
/// own.
pub(super) fn groups(building: &Building) -> Vec<FaceId> {
    let mut firsts: Vec<FaceId> = building.face_ids().collect();
    let root = |firsts: &mut [FaceId], mut id: FaceId| {
        while firsts[id.index()] != id {
            // Path halving makes the next search shorter.
            let above = firsts[id.index()];
            firsts[id.index()] = firsts[above.index()];
            id = firsts[id.index()];
        }
        id
    };
    for edge in building.edges().iter().filter(|edge| edge.is_vertical()) {
        let [Some(a), Some(b)] = edge.faces else {
            continue;
        };
        if is_wall(building.face(a)) && is_wall(building.face(b)) {
            let [a, b] = [a, b].map(|id| root(&mut firsts, id));
            firsts[a.max(b).index()] = a.min(b);
        }
    }
    building
        .face_ids()
        .map(|id| root(&mut firsts, id))
        .collect()
}
