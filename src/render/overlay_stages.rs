//! What is drawn of each stage: packed squares, cells, mesh, direction field.

use super::overlay::{Board, Tint, blend, lit};
use super::overlay_stress::{along, stress};
use super::overlay_tones::Tones;
use crate::cells::Cell;
use crate::domain::Domain;
use crate::field::Fields;
use crate::mesh::Mesh;
use crate::packing::Particle;
use glam::DVec2;

/// A cell that others are pressed into, and how far it goes there at most.
const PRESSED: Tint = [0.74, 0.33, 0.20, 1.0];
const MOST_PRESSED: f32 = 0.72;
/// A cell that has nobody around it, and how far it goes there at most.
const ALONE: Tint = [0.36, 0.56, 0.68, 1.0];
const MOST_ALONE: f32 = 1.0;
/// Lines of cells before there are stones.
const CELL_EDGE: Tint = [0.13, 0.10, 0.07, 0.55];
/// How much darker a cell held on the boundary is.
const FIXED: f32 = 0.82;
/// Rounding of corners, of a cell's size.
const ROUND: f64 = 0.13;

const QUAD: Tint = [0.836, 0.800, 0.735, 1.0];
const TRIANGLE: Tint = [0.800, 0.510, 0.350, 1.0];
const INK: Tint = [0.33, 0.27, 0.21, 1.0];
const CROSS: Tint = [0.54, 0.29, 0.16, 1.0];
const NO_DIRECTION: Tint = [0.20, 0.42, 0.54, 1.0];

/// Draws the packed squares in the tones of the stones to come: warmer and redder the deeper their
/// neighbours stand in them, cooler the more of their sides are free.
pub fn packed(board: &mut Board, domain: &Domain, particles: &[Particle], tones: &Tones) {
    let rings: Vec<[DVec2; 4]> = particles.iter().map(square).collect();
    for ((particle, ring), lot) in particles.iter().zip(&rings).zip(stress(domain, particles)) {
        let own = tones.stone(particle.id);
        let own = lit(own, if particle.fixed { FIXED } else { 1.0 });
        let inside = blend(own, ALONE, MOST_ALONE * lot.alone * lot.alone.sqrt());
        let inside = blend(inside, PRESSED, MOST_PRESSED * lot.pressed);
        board.fill(&[ring], inside, ROUND * particle.size);
    }
    let size = mean(particles.iter().map(|p| p.size));
    let rings: Vec<&[DVec2]> = rings.iter().map(|r| r.as_slice()).collect();
    board.edges(&rings, CELL_EDGE, line_width(size), ROUND * size);
}

/// The corners of a particle's square, clockwise on screen.
fn square(particle: &Particle) -> [DVec2; 4] {
    let u = along(particle) * (particle.size / 2.0);
    let v = u.perp();
    let c = particle.centre;
    [c - u - v, c + u - v, c + u + v, c - u + v]
}

/// Lines of small cells are drawn thinner, so that they do not swallow the cells.
fn line_width(size: f64) -> f64 {
    (size / 15.0).clamp(0.5, 1.6)
}

fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len().max(1);
    values.sum::<f64>() / count as f64
}

/// Draws the cells' polygons in the tones of the stones to come, with joints in the bed's.
pub fn cells(board: &mut Board, cells: &[Cell], tones: &Tones) {
    for cell in cells {
        let round = 0.5 * ROUND * cell.size;
        board.fill(&[&cell.ring], tones.stone(cell.id), round);
    }
    let rings: Vec<&[DVec2]> = cells.iter().map(|c| c.ring.as_slice()).collect();
    let size = mean(cells.iter().map(|c| c.size));
    let joint = lit(tones.paper.bed, 0.86);
    board.edges(
        &rings,
        joint,
        (0.11 * size).clamp(0.7, 5.0),
        0.5 * ROUND * size,
    );
}

/// Draws the mesh, quadrilaterals and triangles in different tints.
pub fn mesh(board: &mut Board, mesh: &Mesh) {
    let ring = |nodes: &[u32]| -> Vec<DVec2> {
        let place = |&n: &u32| mesh.vertices.get(n as usize).copied();
        nodes.iter().filter_map(place).collect()
    };
    let rings: Vec<Vec<DVec2>> = mesh.faces.iter().map(|f| ring(f.nodes())).collect();
    for ring in &rings {
        let inside = if ring.len() == 4 { QUAD } else { TRIANGLE };
        board.fill(&[ring], inside, 0.0);
    }
    let first = |r: &Vec<DVec2>| r.first().zip(r.get(1)).map_or(0.0, |(a, b)| a.distance(*b));
    let width = line_width(mean(rings.iter().map(first)));
    let rings: Vec<&[DVec2]> = rings.iter().map(Vec::as_slice).collect();
    board.edges(&rings, INK, width, 0.0);
}

/// Draws the direction field as crosses on a grid, as long as the cells wanted there as far as the
/// grid has room; a dot where there is no direction.
pub fn direction(board: &mut Board, domain: &Domain, fields: &Fields, side: f64) {
    let step = (side / 30.0).max(9.0);
    let count = (side / step) as usize;
    let margin = (side - step * count as f64) / 2.0;
    let mut lines = Vec::new();
    for k in 0..count * count {
        let square = DVec2::new((k % count) as f64 + 0.5, (k / count) as f64 + 0.5);
        let p = DVec2::splat(margin) + step * square;
        let room = domain.nearest(p).distance;
        if room <= 0.0 {
            continue;
        }
        let axis = fields.direction(p);
        if axis == DVec2::ZERO {
            board.dot(p, step / 8.0, NO_DIRECTION);
            continue;
        }
        // Inside the outline, too.
        let arm = (0.46 * fields.size(p)).min(0.40 * step).min(room);
        for along in [axis * arm, axis.perp() * arm] {
            lines.push([p - along, p + along]);
        }
    }
    board.strokes(&lines, CROSS, (side / 360.0).clamp(1.0, 3.0));
}
