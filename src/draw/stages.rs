//! Drawings of the stages on paper: the outline, packed cells, cells, the mesh, constraint lines.

use super::{Colour, DrawnPath, Layer, Paper, Tones, blend, lit};
use crate::cells::Cell;
use crate::domain::Domain;
use crate::field::Fields;
use crate::mesh::Mesh;
use crate::packing::{Particle, Stress, stress};
use glam::DVec2;

/// The colour of cells with deep overlap, and its greatest share.
const PRESSED: Colour = [0.74, 0.33, 0.20, 1.0];
const MOST_PRESSED: f32 = 0.72;
/// The colour of cells without neighbours, and its greatest share.
const ALONE: Colour = [0.36, 0.56, 0.68, 1.0];
const MOST_ALONE: f32 = 1.0;
/// Lines of cells before there are stones.
const CELL_EDGE: Colour = [0.13, 0.10, 0.07, 0.55];
/// Lightness of cells fixed on the boundary, relative to free cells.
const FIXED: f32 = 0.82;
/// Rounding of corners, relative to a cell's size.
const ROUND: f64 = 0.13;

pub(crate) const FACE: Colour = [0.836, 0.800, 0.735, 1.0];
pub(crate) const LONE: Colour = [0.800, 0.510, 0.350, 1.0];
pub(crate) const INK: Colour = [0.33, 0.27, 0.21, 1.0];

/// The outline's area and boundary. Holes are rings with the opposite orientation.
pub fn bed(rings: &[&[DVec2]], paper: &Paper) -> Layer {
    let rings = rings.iter().map(|ring| ring.to_vec()).collect();
    let bed = Layer::fill(rings, paper.bed, 0.0);
    bed.edged(paper.line, 1.25, 0.0).named("outline", "")
}

/// The packed cells in the tones of their future stones: redder with deeper overlap, cooler with more free
/// sides. Curves suit a board with `scale` pixels along a unit.
pub fn packed(domain: &Domain, particles: &[Particle], tones: &Tones, scale: usize) -> Layer {
    let cells = particles.iter().zip(stress(domain, particles));
    let cells = cells.map(|(particle, stress)| {
        let own = tones.stone(particle.id);
        let own = lit(own, if particle.fixed { FIXED } else { 1.0 });
        let inside = stressed(own, stress);
        let ring = particle.ring(1.0, around(scale));
        DrawnPath::fill(vec![ring], inside, ROUND * particle.size)
    });
    let size = mean(particles.iter().map(|p| p.size));
    Layer::shapes(cells.collect()).edged(CELL_EDGE, line_width(size), ROUND * size)
}

/// The colour of a packed cell under stress.
pub(crate) fn stressed(own: Colour, stress: Stress) -> Colour {
    let inside = blend(own, ALONE, MOST_ALONE * stress.alone * stress.alone.sqrt());
    blend(inside, PRESSED, MOST_PRESSED * stress.pressed)
}

/// Points around a curved cell, on a board with `scale` pixels along a unit.
pub(super) fn around(scale: usize) -> u32 {
    16 * scale as u32
}

/// Lines of small cells are thinner, so that they do not hide the cells.
pub(super) fn line_width(size: f64) -> f64 {
    (size / 15.0).clamp(0.5, 1.6)
}

pub(super) fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len().max(1);
    values.sum::<f64>() / count as f64
}

/// The mean size of cells, in picture units.
pub fn mean_size(cells: &[Cell]) -> f64 {
    mean(cells.iter().map(|c| c.size))
}

/// The cells' polygons in the tones of their future stones, with joints in the colour of the bed.
pub fn cells(cells: &[Cell], tones: &Tones) -> Layer {
    let filled = cells.iter().map(|cell| {
        let round = 0.5 * ROUND * cell.size;
        DrawnPath::fill(vec![cell.ring.clone()], tones.stone(cell.id), round)
    });
    let size = mean_size(cells);
    let joint = lit(tones.paper.bed, 0.86);
    let width = (0.11 * size).clamp(0.7, 5.0);
    let cells = Layer::shapes(filled.collect()).named("cells", "cell-");
    cells.edged(joint, width, 0.5 * ROUND * size)
}

/// The elements of a mesh, and whether each is a triangle among cells with corners.
pub(super) fn elements(mesh: &Mesh, fields: &Fields) -> Vec<(Vec<DVec2>, bool)> {
    let element = |nodes: &[u32]| {
        let place = |&n: &u32| mesh.vertices.get(n as usize).copied();
        let ring: Vec<DVec2> = nodes.iter().filter_map(place).collect();
        let middle = ring.iter().sum::<DVec2>() / ring.len().max(1) as f64;
        let is_lone = ring.len() < 4 && fields.kind(middle).has_corners();
        (ring, is_lone)
    };
    mesh.faces.iter().map(|f| element(f.nodes())).collect()
}

/// The width of the lines of elements.
pub(super) fn mesh_width(elements: &[(Vec<DVec2>, bool)]) -> f64 {
    let first = |r: &[DVec2]| r.first().zip(r.get(1)).map_or(0.0, |(a, b)| a.distance(*b));
    line_width(mean(elements.iter().map(|(ring, _)| first(ring))))
}

/// The mesh. Triangles among cells with corners, which found no partner, are highlighted.
pub fn mesh(mesh: &Mesh, fields: &Fields) -> Layer {
    let elements = elements(mesh, fields);
    let width = mesh_width(&elements);
    let filled = elements.into_iter().map(|(ring, is_lone)| {
        let colour = if is_lone { LONE } else { FACE };
        DrawnPath::fill(vec![ring], colour, 0.0)
    });
    Layer::shapes(filled.collect()).edged(INK, width, 0.0)
}

/// The constraint lines, over the cells along them.
pub fn lines(domain: &Domain, side: f64) -> Layer {
    let lines = domain.lines().iter();
    let lines = lines
        .map(|line| DrawnPath::bare(vec![line.clone()]))
        .collect();
    let lines = Layer::shapes(lines);
    lines
        .drawn(INK, (side / 300.0).max(1.2))
        .named("lines", "line-")
}
