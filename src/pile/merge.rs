//! Merging the darts of several types.

use super::{Dart, Kind};
use crate::trimesh::spatial_hash::SurfaceHash;
use glam::DVec3;

/// Whether each dart stays when the types are merged (section 4.1.4, fig. 6). Darts of a smaller type are left out
/// within the distribution radius of a dart of a larger type. The type with the larger diagonal is the larger one.
pub fn merge(darts: &[Dart], kinds: &[Kind]) -> Vec<bool> {
    let mut stays = vec![true; darts.len()];
    for (number, kind) in kinds.iter().enumerate() {
        let is_smaller = |k: &Kind| k.diagonal() < kind.diagonal();
        if !kinds.iter().any(is_smaller) {
            continue;
        }
        let radius = 0.5 * kind.spacing();
        let own: Vec<DVec3> = darts
            .iter()
            .filter(|d| d.kind as usize == number)
            .map(|d| d.at)
            .collect();
        let mut hash = SurfaceHash::around(own.iter().copied(), 2.0 * radius);
        for &at in &own {
            hash.push_at(at);
        }
        let is_inside = |at: DVec3| {
            hash.any_near(at, radius, |k| {
                own[k].distance_squared(at) < radius * radius
            })
        };
        for (stays, dart) in stays.iter_mut().zip(darts) {
            *stays &= !(is_smaller(&kinds[dart.kind as usize]) && is_inside(dart.at));
        }
    }
    stays
}
