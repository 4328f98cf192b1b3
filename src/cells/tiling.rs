//! The dual on a torus, whose cells close over the seams.

use super::Cell;
use super::dual::{Anchor, Dual};
use super::rings::is_tangled;
use super::tessellation::{Tessellation, split_fixed};
use crate::domain::Domain;
use crate::mesh::seams::{Strategy, closes, with_images};
use crate::mesh::{Mesh, Node};
use crate::order;
use crate::packing::Particle;
use crate::planar::on_grain;
use glam::DVec2;

/// Corners at most this far apart (picture units) are merged. The crossing of a side and a line is rounded
/// separately in the picture and in each image.
const SAME: f64 = 4.0 / 65536.0;

/// The nodes of these particles and of their images, and their sizes.
pub(super) fn nodes(
    side: f64,
    particles: &[Particle],
    strategy: Strategy,
    tessellation: Tessellation,
) -> (Vec<Node>, Vec<f64>) {
    let (all, _) = with_images(side, particles, strategy);
    let nodes = all.iter().map(|p| strategy.node(tessellation.node(p)));
    (nodes.collect(), all.iter().map(|p| p.size).collect())
}

/// Cells and images of cells, with their nodes, to be cut by constraint lines.
pub(super) struct Lined {
    cells: Vec<Particle>,
    fixed: usize,
}

impl Lined {
    /// The cells with their images, and the nodes of their mesh.
    pub fn new(side: f64, particles: &[Particle], strategy: Strategy) -> (Self, Vec<Node>) {
        let (all, of) = with_images(side, particles, strategy);
        // The cells and their images at their unrounded places.
        let placed = all.iter().zip(&of).map(|(p, &k)| {
            let (real, near) = (&particles[k as usize], &all[k as usize]);
            let centre = real.centre + (p.centre - near.centre);
            Particle { centre, ..*p }
        });
        // If two centres are in one region, the first by id owns it, in the picture and in all images.
        let in_order = |mut particles: Vec<Particle>| {
            order::sort(&mut particles, |p| (p.id.into(), 0));
            split_fixed(particles)
        };
        let (cells, fixed) = in_order(placed.collect());
        let (first, last) = in_order(all);
        let nodes = first.iter().chain(&last).map(Node::of);
        let nodes = nodes.map(|node| strategy.node(node)).collect();
        let fixed = fixed.len();
        (Self { cells, fixed }, nodes)
    }

    /// The cells of a torus with constraint lines, if they agree over the seams. The lines cut all images;
    /// then the cells in the picture are taken.
    pub fn cells(self, domain: &Domain, mesh: &Mesh) -> Option<Vec<Cell>> {
        let sizes = self.cells.iter().map(|p| p.size).collect();
        let mut dual = Dual::of(self.cells, sizes, mesh, Tessellation::PseudoVoronoi);
        dual.place_vertices(domain, mesh, self.fixed);
        dual.divide(domain, mesh);
        let mut cells = dual.cells(domain);
        cells.retain(|cell| domain.space().wrap(cell.centre) == cell.centre);
        // Crossings of sides and lines agree with their images up to rounding.
        for cell in &mut cells {
            cell.ring.iter_mut().for_each(|p| *p = on_grain(*p));
        }
        weld(domain, &mut cells);
        for cell in &mut cells {
            without_spikes(&mut cell.ring);
        }
        cells.retain(|cell| cell.ring.len() >= 3);
        let rings: Vec<Vec<DVec2>> = cells.iter().map(|cell| cell.ring.clone()).collect();
        closes(domain, &rings).then_some(cells)
    }
}

impl Dual {
    /// The dual on the torus for the mesh of [`nodes`], if the cells close over the seams or the mesh is
    /// plain Delaunay.
    pub fn over_seams(
        domain: &Domain,
        mesh: &Mesh,
        (particles, sizes): (&[Particle], Vec<f64>),
        (strategy, tessellation): (Strategy, Tessellation),
    ) -> Option<Self> {
        let mut dual = Self::of(Vec::new(), sizes, mesh, tessellation);
        for face in &mesh.faces {
            dual.push(dual.vertex(mesh, face), false, Anchor::Free);
        }
        let rings: Vec<Vec<DVec2>> = (0..particles.len()).map(|k| dual.ring(k)).collect();
        dual.particles = particles.to_vec();
        let whole = || closes(domain, &rings) && !rings.iter().any(|ring| is_tangled(ring));
        (strategy == Strategy::Delaunay || whole()).then_some(dual)
    }
}

/// Merges corners that nearly coincide, also over the seams.
fn weld(domain: &Domain, cells: &mut [Cell]) {
    let mut corners: Vec<(DVec2, u32, u32)> = Vec::new();
    for (index, cell) in cells.iter().enumerate() {
        for (place, &p) in cell.ring.iter().enumerate() {
            corners.push((domain.space().wrap(p), index as u32, place as u32));
        }
    }
    order::sort(&mut corners, |c| (order::rank(c.0.x), order::rank(c.0.y)));
    let mut first = 0;
    for k in 0..corners.len() {
        let (p, index, place) = corners[k];
        while p.x - corners[first].0.x > SAME {
            first += 1;
        }
        let near = |c: &&(DVec2, u32, u32)| (c.0.y - p.y).abs() <= SAME;
        if let Some(&(q, ..)) = corners[first..k].iter().find(near) {
            corners[k].0 = q;
            cells[index as usize].ring[place as usize] += q - p;
        }
    }
}

/// Removes repeated points from a ring, and spikes to a point and straight back.
fn without_spikes(ring: &mut Vec<DVec2>) {
    let mut k = 0;
    while k < ring.len() && ring.len() >= 3 {
        let n = ring.len();
        let (next, after) = ((k + 1) % n, (k + 2) % n);
        if ring[k] == ring[next] || ring[k] == ring[after] {
            ring.remove(next);
            // The points on both sides of the removed one may coincide, too.
            k = 0;
        } else {
            k += 1;
        }
    }
}
