//! Images of cells that cross the edges of a periodic picture, and of their corners.

use super::Cell;
use crate::domain::Domain;
use crate::order;
use crate::planar::Space;
use glam::DVec2;

/// The images of cells that cross the edges of the picture. With them every corner in the picture has all its
/// cells around it.
pub(super) fn images(domain: &Domain, cells: &[Cell]) -> Vec<Cell> {
    let mut images = Vec::new();
    for cell in cells {
        let first = cell.ring[0];
        let (lo, hi) = cell
            .ring
            .iter()
            .fold((first, first), |(lo, hi), &p| (lo.min(p), hi.max(p)));
        let ways = domain.space().shifts_home([lo, hi]);
        for by in ways.filter(|&by| by != DVec2::ZERO) {
            let mut image = cell.clone();
            image.centre += by;
            for p in &mut image.ring {
                *p += by;
            }
            images.push(image);
        }
    }
    images
}

/// Pairs of points that are images of each other, sorted: (index of the point in the picture, index of its image,
/// offset from the first to the second).
pub(super) fn twins(domain: &Domain, points: &[DVec2]) -> Vec<(u32, u32, DVec2)> {
    let space = domain.space();
    // The plane has no images; skip the sorting.
    if space == Space::PLANE {
        return Vec::new();
    }
    let key = |k: u32| {
        let p = space.wrap(points[k as usize]);
        (order::rank(p.x), order::rank(p.y))
    };
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order::sort(&mut order, |&k| key(k));
    let mut twins = Vec::new();
    for same in order.chunk_by(|&a, &b| key(a) == key(b)) {
        let at_home = |&&k: &&u32| points[k as usize] == space.wrap(points[k as usize]);
        let home = same.iter().find(at_home).copied().unwrap_or(same[0]);
        for &k in same.iter().filter(|&&k| k != home) {
            twins.push((home, k, points[k as usize] - points[home as usize]));
        }
    }
    order::sort(&mut twins, |t| (order::pair(t.0, t.1), 0));
    twins
}
