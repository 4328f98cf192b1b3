//! The dual of the mesh of the packed centres, and the position of its vertices at the boundary.
//!
//! Itoh, Miyata, Shimada (2003), section 5.2: a node's cell joins the centres of the mesh elements around it;
//! on the boundary and on constraint lines it ends at the midpoints of their sides.

use super::tessellation::Tessellation;
use super::visibility::{self, Visibility};
use super::voronoi::circumcentre;
use crate::csr::Csr;
use crate::domain::Domain;
use crate::mesh::{Face, Mesh, Node};
use crate::order;
use crate::packing::Particle;
use crate::planar::on_grain;
use glam::DVec2;

/// The vertex of an element between inside and outside moves onto a wall that is nearer than this, in sizes.
const SNAP: f64 = 0.35;

/// The place of one of the dual's vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    /// Not moved onto a wall.
    Free,
    /// On this segment of the outline.
    Outline(usize),
    /// On this segment of the constraint lines.
    Line(usize),
}

/// The mesh of cells and ghosts, with the centres of its elements.
pub(super) struct Dual {
    pub particles: Vec<Particle>,
    /// The sizes of the mesh's first vertices, the cells.
    sizes: Vec<f64>,
    fans: Csr<u32>,
    /// The dual's vertices: one for each element, and more for elements that a constraint line divides.
    pub vertices: Vec<DVec2>,
    /// Whether the element has a ghost among its nodes, or a constraint line divides it.
    pub mixed: Vec<bool>,
    pub anchors: Vec<Anchor>,
    /// (element, node, the vertex for this node), for divided elements.
    own_vertices: Vec<[u32; 3]>,
    pub mesh_vertices: usize,
    pub tessellation: Tessellation,
}

impl Dual {
    /// The nodes of the mesh within an outline in the plane: the free cells, the fixed cells, and ghosts outside. Also
    /// gives the free cells, and the number of fixed cells.
    pub fn nodes(
        domain: &Domain,
        particles: Vec<Particle>,
        tessellation: Tessellation,
    ) -> (Vec<Node>, Vec<Particle>, usize) {
        let (cells, fixed) = tessellation.split(particles);
        let own = cells.iter().chain(&fixed).map(|p| tessellation.node(p));
        let ghosts = tessellation.ghosts(domain, &cells, &fixed);
        let nodes = own.chain(ghosts).collect();
        (nodes, cells, fixed.len())
    }

    /// The dual of the mesh of [`Dual::nodes`].
    pub fn within(
        domain: &Domain,
        mesh: &Mesh,
        (cells, fixed): (Vec<Particle>, usize),
        tessellation: Tessellation,
    ) -> Self {
        let sizes = cells.iter().map(|p| p.size).collect();
        let mut dual = Self::of(cells, sizes, mesh, tessellation);
        dual.place_vertices(domain, mesh, fixed);
        if tessellation.has_lines(domain) {
            dual.divide(domain, mesh);
        }
        dual
    }

    /// A dual without vertices; they are placed later.
    pub fn of(
        particles: Vec<Particle>,
        sizes: Vec<f64>,
        mesh: &Mesh,
        tessellation: Tessellation,
    ) -> Self {
        let count = mesh.faces.len();
        Self {
            particles,
            sizes,
            fans: mesh.fans(),
            vertices: Vec::with_capacity(count),
            mixed: Vec::with_capacity(count),
            anchors: Vec::with_capacity(count),
            own_vertices: Vec::new(),
            mesh_vertices: mesh.vertices.len(),
            tessellation,
        }
    }

    /// The vertex of an element, before walls move it.
    pub fn vertex(&self, mesh: &Mesh, face: &Face) -> DVec2 {
        match (self.tessellation, face.nodes()) {
            (Tessellation::Voronoi, &[a, b, c]) => {
                circumcentre([a, b, c].map(|k| mesh.vertices[k as usize]))
            }
            (_, nodes) => {
                let meeting = self.meeting(mesh, nodes);
                meeting.unwrap_or_else(|| face.centroid(&mesh.vertices))
            }
        }
    }

    /// The point at which the cells of an element's corners meet: the mean of their centres, weighted by 1 / size.
    /// `None` if a corner is not a cell.
    fn meeting(&self, mesh: &Mesh, nodes: &[u32]) -> Option<DVec2> {
        let corner = |&k: &u32| Some((mesh.vertices[k as usize], *self.sizes.get(k as usize)?));
        let mut corners: Vec<(DVec2, f64)> = nodes.iter().map(corner).collect::<Option<_>>()?;
        // Sorted by offsets that are exact on the grain, so that an element's image on a torus gets exactly
        // the vertex's image.
        order::sort(&mut corners, |c| (order::rank(c.0.x), order::rank(c.0.y)));
        let first = corners[0].0;
        let (mut way, mut total) = (DVec2::ZERO, 0.0);
        for (p, size) in corners {
            way += (p - first) / size;
            total += 1.0 / size;
        }
        Some(first + on_grain(way / total))
    }

    /// Places the vertices of all elements. In the mesh, the nodes of the fixed cells, `fixed` in number, follow those
    /// of the free cells.
    pub fn place_vertices(&mut self, domain: &Domain, mesh: &Mesh, fixed: usize) {
        let real = self.particles.len();
        for face in &mesh.faces {
            let mut middle = self.vertex(mesh, face);
            let corners = face.nodes().iter().map(|&k| k as usize);
            let sizes = corners.clone().filter(|&k| k < real);
            let sizes: Vec<f64> = sizes.map(|k| self.particles[k].size).collect();
            let mut on = Anchor::Free;
            let borders = !sizes.is_empty() && sizes.len() < face.nodes().len();
            if borders && self.tessellation.moves_to_walls() {
                let size = sizes.iter().sum::<f64>() / sizes.len() as f64;
                // Goes round the element, starting from a cell.
                let first = corners.clone().position(|k| k < real).unwrap_or(0);
                let round = corners.cycle().skip(first).take(face.nodes().len());
                let on_fixed = round.filter(|k| (real..real + fixed).contains(k));
                let on_fixed: Vec<DVec2> = on_fixed.map(|k| mesh.vertices[k]).collect();
                (middle, on) = self.at_wall(domain, middle, &on_fixed, size);
            }
            self.push(middle, sizes.len() < face.nodes().len(), on);
        }
    }

    /// The vertex of an element with ghosts or fixed cells among its nodes: at its only fixed cell, midway between two,
    /// at the middle one of three, and without any at `middle`. Then it moves onto a near wall.
    fn at_wall(
        &self,
        domain: &Domain,
        middle: DVec2,
        on_fixed: &[DVec2],
        size: f64,
    ) -> (DVec2, Anchor) {
        let middle = match *on_fixed {
            [] => middle,
            [a] => a,
            [a, b] => a.midpoint(b),
            [_, b, ..] => b,
        };
        let near = domain.nearest(middle);
        if let Some(line) = domain.nearest_line(middle)
            && !on_fixed.is_empty()
            && line.distance < near.distance.min(SNAP * size)
        {
            return (line.point, Anchor::Line(line.segment));
        }
        if near.distance.abs() < SNAP * size {
            return (near.point, Anchor::Outline(near.segment));
        }
        (middle, Anchor::Free)
    }

    pub fn push(&mut self, middle: DVec2, mixed: bool, on: Anchor) {
        self.vertices.push(on_grain(middle));
        self.mixed.push(mixed);
        self.anchors.push(on);
    }

    /// Gives an element that constraint lines divide a vertex on each side.
    pub fn divide(&mut self, domain: &Domain, mesh: &Mesh) {
        let real = self.particles.len() as u32;
        for (index, face) in mesh.faces.iter().enumerate() {
            let nodes: Vec<u32> = face.nodes().iter().copied().filter(|&k| k < real).collect();
            let corners: Vec<DVec2> = nodes.iter().map(|&k| mesh.vertices[k as usize]).collect();
            if nodes.len() < 2 {
                continue;
            }
            let sizes = nodes.iter().map(|&k| self.particles[k as usize].size);
            let size = sizes.sum::<f64>() / nodes.len() as f64;
            let view = visibility::visibility(domain, &corners);
            let middle = face.centroid(&mesh.vertices);
            let shared = match view {
                Visibility::Whole => continue,
                _ if self.mixed[index] => {
                    visibility::junction(domain, middle, size).map(|(k, p)| (p, Anchor::Outline(k)))
                }
                Visibility::Around => {
                    visibility::end(domain, middle, size).map(|(k, p)| (p, Anchor::Line(k)))
                }
                Visibility::Divided(_) => None,
            };
            if let Some((place, on)) = shared {
                (self.vertices[index], self.anchors[index]) = (on_grain(place), on);
                continue;
            }
            let (Visibility::Divided(group), false) = (view, self.mixed[index]) else {
                continue;
            };
            let first = self.own_vertices.len();
            for (k, &node) in nodes.iter().enumerate() {
                if let Some(like) = (0..k).find(|&j| group[j] == group[k]) {
                    let [.., seen] = self.own_vertices[first + like];
                    self.own_vertices.push([index as u32, node, seen]);
                    continue;
                }
                let mean = |same: bool| {
                    let which = (0..nodes.len()).filter(|&j| (group[j] == group[k]) == same);
                    which.clone().map(|j| corners[j]).sum::<DVec2>() / which.count() as f64
                };
                let foot = visibility::foot(domain, mean(true), mean(false), size);
                self.own_vertices
                    .push([index as u32, node, self.vertices.len() as u32]);
                match foot {
                    Some((segment, place)) => self.push(place, true, Anchor::Line(segment)),
                    None => self.push(middle, true, Anchor::Free),
                }
            }
        }
        order::sort(&mut self.own_vertices, |o| (order::pair(o[0], o[1]), 0));
    }

    /// The vertex of an element, as seen from a node.
    fn seen(&self, element: u32, node: u32) -> u32 {
        let place = self
            .own_vertices
            .partition_point(|o| (o[0], o[1]) < (element, node));
        match self.own_vertices.get(place) {
            Some(&[e, n, vertex]) if (e, n) == (element, node) => vertex,
            _ => element,
        }
    }

    /// The vertices around a cell or a ghost, clockwise on screen; empty if they do not close.
    pub fn around(&self, vertex: usize) -> Vec<u32> {
        let around = self.fans.row(vertex);
        if self.own_vertices.is_empty() {
            return around.to_vec();
        }
        let seen = around.iter().map(|&f| self.seen(f, vertex as u32));
        seen.collect()
    }

    /// The corners of a cell's polygon.
    pub fn ring(&self, vertex: usize) -> Vec<DVec2> {
        let around = self.around(vertex);
        let mut ring: Vec<DVec2> = around.iter().map(|&f| self.vertices[f as usize]).collect();
        // Equal circumcircles give equal vertices.
        ring.dedup();
        if ring.len() > 1 && ring.first() == ring.last() {
            ring.pop();
        }
        ring
    }
}
