//! Drawings over a picture: shapes, and light lines with dark rims, each in its own hue, so that several can
//! be distinguished.

use super::shapes::closed;
use super::stages::{around, elements, line_width, mean, mean_size, mesh_width};
use super::{Colour, DrawnPath, Layer, blend};
use crate::cells::Cell;
use crate::domain::Domain;
use crate::field::Fields;
use crate::mesh::Mesh;
use crate::packing::{Particle, Stress};
use glam::DVec2;

const PACKED: Colour = [1.0, 0.97, 0.90, 0.95];
const FREE: Colour = [1.0, 0.97, 0.90, 0.10];
const PRESSED: Colour = [0.92, 0.16, 0.06, 0.62];
const ALONE: Colour = [0.16, 0.50, 0.95, 0.62];
/// Steps between the colours of fillings; even, so that the middle colour, for cells at rest, is one of them.
const STEPS: usize = 10;

const CELL: Colour = [1.0, 0.80, 0.25, 1.0];
const MESH: Colour = [0.45, 0.90, 1.0, 1.0];
const LONE: Colour = [1.0, 0.45, 0.10, 0.50];
/// The colours for an aspect ratio of 1 and for the greatest.
const EVEN: Colour = [0.96, 0.90, 1.0, 0.16];
const STRETCHED: Colour = [0.56, 0.22, 0.85, 0.71];
const RIM: Colour = [0.96, 0.90, 1.0, 1.0];

/// Rings filled with the colours of a scale; rings of one colour form one shape.
pub(super) fn fill_by_scale(rings: &[Vec<DVec2>], shares: &[f32], scale: &[Colour]) -> Layer {
    let top = scale.len().saturating_sub(1);
    let shape = |(step, &colour): (usize, &Colour)| {
        let here = |share: f32| (share.clamp(0.0, 1.0) * top as f32 + 0.5) as usize == step;
        let some = rings.iter().zip(shares).filter(|&(_, &share)| here(share));
        let some = some.map(|(ring, _)| ring.clone()).collect();
        DrawnPath::fill(some, colour, 0.0)
    };
    Layer::shapes(scale.iter().enumerate().map(shape).collect())
}

/// Rings as closed lines.
pub(super) fn lines_of(rings: &[Vec<DVec2>]) -> Vec<Vec<DVec2>> {
    rings.iter().map(|ring| closed(ring)).collect()
}

/// A filled layer with light lines over it.
fn with_lines(filled: Layer, lines: [Layer; 2]) -> Vec<Layer> {
    let [rim, line] = lines;
    vec![filled, rim, line]
}

/// A scale of colours from low through middle to high.
pub(super) fn scale([low, middle, high]: [Colour; 3], steps: usize) -> Vec<Colour> {
    let colour = |step: usize| {
        let t = 2.0 * step as f32 / steps as f32;
        match t < 1.0 {
            true => blend(low, middle, t),
            false => blend(middle, high, t - 1.0),
        }
    };
    (0..=steps).map(colour).collect()
}

/// The shapes of particles, for a board with `scale` pixels along a unit.
pub(super) fn shapes(
    particles: &mut dyn Iterator<Item = &Particle>,
    factor: f64,
    scale: usize,
) -> Vec<Vec<DVec2>> {
    let points = around(scale);
    particles.map(|p| p.ring(factor, points)).collect()
}

/// Packed cells as outlines, red where neighbours overlap them and blue where they are alone. Curves suit a board with
/// `scale` pixels along a unit.
pub fn packed(particles: &[Particle], stress: &[Stress], scale: usize) -> Vec<Layer> {
    let rings = shapes(&mut particles.iter(), 1.0, scale);
    // From 0 for alone to 1 for deep overlap.
    let share = |s: &Stress| 0.5 + 0.5 * (s.pressed - if s.pressed > 0.0 { 0.0 } else { s.alone });
    let shares: Vec<f32> = stress.iter().map(share).collect();
    let filled = fill_by_scale(&rings, &shares, &self::scale([ALONE, FREE, PRESSED], STEPS));
    let width = line_width(mean(particles.iter().map(|p| p.size)));
    with_lines(filled, Layer::cased(lines_of(&rings), PACKED, width))
}

/// The cells' polygons as lines.
pub fn cells(cells: &[Cell]) -> [Layer; 2] {
    let width = line_width(mean_size(cells));
    let lines = cells.iter().map(|c| closed(&c.ring)).collect();
    Layer::cased(lines, CELL, width)
}

/// The mesh as lines; triangles among cells with corners, which found no partner, are filled.
pub fn mesh(mesh: &Mesh, fields: &Fields) -> Vec<Layer> {
    let elements = elements(mesh, fields);
    let lone = elements.iter().filter(|e| e.1).map(|e| e.0.clone());
    let filled = Layer::fill(lone.collect(), LONE, 0.0);
    let lines = elements.iter().map(|e| closed(&e.0)).collect();
    with_lines(filled, Layer::cased(lines, MESH, mesh_width(&elements)))
}

/// The aspect ratio field as shapes of equal area on a grid, deeper in colour the longer they are. Curves suit a board
/// with `scale` pixels along a unit.
pub fn anisotropy(domain: &Domain, fields: &Fields, side: f64, scale: usize) -> Vec<Layer> {
    let step = (side / 20.0).max(14.0);
    let count = (side / step) as usize;
    let margin = (side - step * count as f64) / 2.0;
    let mut shapes = Vec::new();
    for k in 0..count * count {
        let square = DVec2::new((k % count) as f64 + 0.5, (k / count) as f64 + 0.5);
        let p = DVec2::splat(margin) + step * square;
        if domain.nearest(p).distance > 0.2 * step {
            shapes.push(Particle::new(0, p, false, fields));
        }
    }
    let longest = shapes.iter().map(|s| s.aspect).fold(1.0, f64::max);
    let size = 0.80 * step / longest.sqrt().max(1.2);
    shapes.iter_mut().for_each(|shape| shape.size = size);
    let rings = self::shapes(&mut shapes.iter(), 1.0, scale);
    let longer = |s: &Particle| (libm::log2(s.aspect) / libm::log2(5.0)) as f32;
    let longer: Vec<f32> = shapes.iter().map(longer).collect();
    let middle = blend(EVEN, STRETCHED, 0.5);
    let filled = fill_by_scale(
        &rings,
        &longer,
        &self::scale([EVEN, middle, STRETCHED], STEPS),
    );
    let width = (side / 460.0).clamp(0.9, 3.0);
    with_lines(filled, Layer::rimmed(lines_of(&rings), RIM, width))
}
