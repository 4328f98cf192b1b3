//! Points outside the outline that make the dual mesh end at the boundary.
//!
//! A cell beside a wall has its mirror image behind the wall. Their dual cells meet midway, on the wall
//! itself. Beside two walls that meet in a corner there is also the image through both.

use crate::domain::{Domain, Projection, Walls};
use crate::mesh::Node;
use crate::packing::Particle;
use glam::DVec2;

/// Cells at most this far from a wall (in sizes) are mirrored: the first row, not the second.
const MIRRORED: f64 = 0.9;
/// Images nearer to each other than this (in sizes) are merged.
const SAME: f64 = 0.45;
/// Two walls form a corner if their directions differ by more than this (cosine of 45 degrees).
const CORNER: f64 = 0.707;
/// A fixed cell at most this far from the boundary (in sizes) stands on it.
const ON_BOUNDARY: f64 = 0.05;
/// Distance of the frame of far points, in sides of the bounding box.
const FRAME: f64 = 2.0;

/// The images of all cells near a wall, and a frame of far points around everything.
pub(super) fn ghosts(domain: &Domain, particles: &[Particle]) -> Vec<Node> {
    let largest = particles.iter().fold(0.0_f64, |m, p| m.max(p.size));
    let walls = Walls::new(domain, MIRRORED * largest);
    let mut images: Vec<Image> = Vec::new();
    let mut near_walls = Vec::new();
    for p in particles.iter().filter(|p| walls.is_near(p.centre)) {
        if p.fixed {
            let near = domain.nearest(p.centre);
            // A cell fixed on a constraint line has neighbours on both sides.
            if near.distance.abs() > ON_BOUNDARY * p.size {
                continue;
            }
            let outward = outward_of_boundary_cell(domain, p, near.tangent);
            images.push(image(p, outward * p.size));
            continue;
        }
        walls.project(p.centre, MIRRORED * p.size, &mut near_walls);
        near_walls.retain(|wall| !wall.on_line);
        mirror(p, &near_walls, &mut images);
    }
    let mut kept = thin_out(domain, images, largest);
    kept.extend(frame(domain).into_iter().map(Node::plain));
    kept
}

/// A ghost and the size of the cell that it mirrors.
type Image = (Node, f64);

/// A cell's ghost, at an offset from its centre.
fn image(p: &Particle, by: DVec2) -> Image {
    let mut node = Node::of(p);
    node.at += by;
    (node, p.size)
}

/// Mirrors a cell through each wall, and through each pair of walls that form a corner.
fn mirror(p: &Particle, walls: &[Projection], images: &mut Vec<Image>) {
    for (k, wall) in walls.iter().enumerate() {
        let step = -2.0 * wall.distance * wall.inward;
        images.push(image(p, step));
        for other in &walls[..k] {
            let along = wall.inward.dot(other.inward);
            if along.abs() < CORNER {
                let second = -2.0 * other.distance * other.inward;
                images.push(image(p, step + second));
            }
        }
    }
}

/// The outward direction at a cell on the boundary.
fn outward_of_boundary_cell(domain: &Domain, p: &Particle, tangent: DVec2) -> DVec2 {
    // At a corner, tries the normals of both sides: the one that leads farther outside wins.
    let normal = tangent.perp();
    let candidates = [-normal, p.axis, -p.axis, p.axis.perp(), -p.axis.perp()];
    let depth = |d: &DVec2| domain.nearest(p.centre + 0.5 * p.size * *d).distance;
    candidates
        .into_iter()
        .filter(|d| *d != DVec2::ZERO)
        .min_by(|a, b| depth(a).total_cmp(&depth(b)))
        .unwrap_or(-normal)
}

/// Drops images that lie inside the outline or nearly on an image kept before.
fn thin_out(domain: &Domain, images: Vec<Image>, largest: f64) -> Vec<Node> {
    let (lo, hi) = domain.bounds();
    let mut grid = crate::packing::Grid::new(lo, hi, largest);
    let mut kept: Vec<Node> = Vec::new();
    for (node, size) in images {
        let p = node.at;
        if domain.contains(p) {
            continue;
        }
        let mut free = true;
        grid.near(p, SAME * size, |k| {
            free &= kept[k].at.distance(p) >= SAME * size;
        });
        if free {
            grid.push(p);
            kept.push(node);
        }
    }
    kept
}

/// Points far around the outline, so that the fans of all nodes inside close.
pub(super) fn frame(domain: &Domain) -> Vec<DVec2> {
    let (lo, hi) = domain.bounds();
    let (middle, half) = (lo.midpoint(hi), FRAME * (hi - lo).max_element());
    // Not on a circle, so that the frame's own triangulation is unique.
    let mut points = Vec::with_capacity(16);
    let mut spoke = DVec2::splat(-half);
    for k in 1..=16 {
        points.push(middle + spoke);
        spoke = spoke.perp();
        if k % 4 == 0 {
            spoke.x += 0.5 * half;
        }
    }
    points
}
