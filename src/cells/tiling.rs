//! The dual of a torus, whose cells close over the seams.

use super::Cell;
use super::dual::{Anchor, Dual, node, split_fixed};
use super::rings::is_tangled;
use crate::domain::Domain;
use crate::mesh::seams::{Strategy, closes, with_images};
use crate::mesh::{Mesh, Node};
use crate::order;
use crate::packing::Particle;
use crate::planar::on_grain;
use glam::DVec2;

/// Corners that are as near to each other as this (picture units) are one: a place where a side
/// crosses a line is rounded here and at its image, each on its own.
const SAME: f64 = 4.0 / 65536.0;

/// The nodes of these particles and their images, and their sizes.
pub(super) fn nodes(
    side: f64,
    particles: &[Particle],
    strategy: Strategy,
    is_voronoi: bool,
) -> (Vec<Node>, Vec<f64>) {
    let (all, _) = with_images(side, particles, strategy);
    let nodes = all.iter().map(|p| strategy.node(node(p, is_voronoi)));
    (nodes.collect(), all.iter().map(|p| p.size).collect())
}

/// Cells and images of cells, and their nodes, to be cut by constraint lines.
pub(super) struct Lined {
    cells: Vec<Particle>,
    fixed: usize,
}

impl Lined {
    /// With the nodes to be joined.
    pub fn new(side: f64, particles: &[Particle], strategy: Strategy) -> (Self, Vec<Node>) {
        let (all, of) = with_images(side, particles, strategy);
        // The same images, but where they really are.
        let placed = all.iter().zip(&of).map(|(p, &k)| {
            let (real, near) = (&particles[k as usize], &all[k as usize]);
            let centre = real.centre + (p.centre - near.centre);
            Particle { centre, ..*p }
        });
        // Of two in one region the first by its id has it, here as at the images.
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

    /// The cells of a torus with constraint lines, where they agree over the seams: all images are cut
    /// by the lines, then those in the picture are taken.
    pub fn cells(self, domain: &Domain, mesh: &Mesh) -> Option<Vec<Cell>> {
        let sizes = self.cells.iter().map(|p| p.size).collect();
        let mut dual = Dual::of(self.cells, sizes, mesh, false);
        dual.place_vertices(domain, mesh, self.fixed);
        dual.divide(domain, mesh);
        let mut cells = dual.cells(domain);
        cells.retain(|cell| domain.space().wrap(cell.centre) == cell.centre);
        // Places where sides cross lines agree with their images but for rounding.
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
    /// On the torus, of the mesh of [`nodes`], where the cells close over the seams or are those of
    /// Delaunay's triangles.
    pub fn over_seams(
        domain: &Domain,
        mesh: &Mesh,
        (particles, sizes): (&[Particle], Vec<f64>),
        (strategy, is_voronoi): (Strategy, bool),
    ) -> Option<Self> {
        let mut dual = Self::of(Vec::new(), sizes, mesh, is_voronoi);
        for face in &mesh.faces {
            dual.push(dual.vertex(mesh, face), false, Anchor::Free);
        }
        let rings: Vec<Vec<DVec2>> = (0..particles.len()).map(|k| dual.ring(k)).collect();
        dual.particles = particles.to_vec();
        let whole = || closes(domain, &rings) && !rings.iter().any(|ring| is_tangled(ring));
        (strategy == Strategy::Delaunay || whole()).then_some(dual)
    }
}

/// Makes one corner of those that nearly coincide, over the seams, too.
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

/// Takes repeated points out of a ring, and ways to a point and straight back.
fn without_spikes(ring: &mut Vec<DVec2>) {
    let mut k = 0;
    while k < ring.len() && ring.len() >= 3 {
        let n = ring.len();
        let (next, after) = ((k + 1) % n, (k + 2) % n);
        if ring[k] == ring[next] || ring[k] == ring[after] {
            ring.remove(next);
            // What is now beside it may be the same.
            k = 0;
        } else {
            k += 1;
        }
    }
}
