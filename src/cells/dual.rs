//! The dual of the mesh of the packed centres, and where its vertices are put at the boundary.
//!
//! Itoh, Miyata, Shimada (2003), section 5.2: a node's cell joins the middles of the mesh elements
//! around it; on the boundary and on constraint lines it ends at the middles of their sides.

use super::voronoi::circumcentre;
use super::{across, ghosts};
use crate::domain::Domain;
use crate::mesh::{Face, Fans, Mesh, Node};
use crate::order;
use crate::packing::Particle;
use crate::planar::on_grain;
use glam::DVec2;

/// Middles of elements between inside and outside go onto the boundary where it is this near.
const SNAP: f64 = 0.35;

/// The cells, and those fixed on the rim (the outline and constraint lines), which get no polygon
/// (Itoh, Miyata, Shimada 2003, section 5.2): the others end there. Where all are fixed, all are cells.
pub(super) fn without_rim(particles: Vec<Particle>) -> (Vec<Particle>, Vec<Particle>) {
    let (rim, cells): (Vec<Particle>, Vec<Particle>) = particles.iter().partition(|p| p.fixed);
    if cells.is_empty() {
        (rim, cells)
    } else {
        (cells, rim)
    }
}

/// A cell to be joined into the mesh; Voronoi polygons know no stretch.
pub(super) fn node(p: &Particle, plain: bool) -> Node {
    if plain {
        Node::plain(p.centre)
    } else {
        Node::of(p)
    }
}

/// Where one of the dual's vertices has been put.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum On {
    /// Where it was.
    Nothing,
    /// On the outline's segment of that number.
    Outline(usize),
    /// On the segment of that number of the constraint lines.
    Line(usize),
}

/// The mesh of cells and ghosts with the middles of its elements.
pub(super) struct Dual {
    pub particles: Vec<Particle>,
    /// The sizes of the mesh's first vertices, which are cells.
    sizes: Vec<f64>,
    fans: Fans,
    /// The dual's vertices: one per element, and more where a constraint line divides elements.
    pub middles: Vec<DVec2>,
    /// The element has a ghost among its nodes, or a constraint line divides it.
    pub mixed: Vec<bool>,
    pub on: Vec<On>,
    /// (element, node, the vertex this node sees), for divided elements.
    own: Vec<[u32; 3]>,
    pub vertices: usize,
    /// The Voronoi diagram as it is: middles are those of the circles around Delaunay's triangles,
    /// no cell is too small, no corner straightened.
    pub plain: bool,
}

impl Dual {
    /// What is joined into a mesh within a plain outline: the cells, those fixed on the rim, and
    /// what lies outside. With the cells, and how many stand on the rim.
    pub fn nodes(
        domain: &Domain,
        particles: Vec<Particle>,
        plain: bool,
    ) -> (Vec<Node>, Vec<Particle>, usize) {
        let (cells, rim) = if plain {
            (particles, Vec::new())
        } else {
            without_rim(particles)
        };
        let mut nodes: Vec<Node> = cells.iter().chain(&rim).map(|p| node(p, plain)).collect();
        nodes.extend(if plain || !rim.is_empty() {
            ghosts::frame(domain).into_iter().map(Node::plain).collect()
        } else {
            ghosts::ghosts(domain, &cells)
        });
        (nodes, cells, rim.len())
    }

    /// Of the mesh of these.
    pub fn within(
        domain: &Domain,
        mesh: &Mesh,
        (cells, rim): (Vec<Particle>, usize),
        plain: bool,
    ) -> Self {
        let sizes = cells.iter().map(|p| p.size).collect();
        let mut dual = Self::of(cells, sizes, mesh, plain);
        dual.put_middles(domain, mesh, rim);
        if !plain && !domain.lines().is_empty() {
            dual.divide(domain, mesh);
        }
        dual
    }

    /// Without vertices yet.
    pub fn of(particles: Vec<Particle>, sizes: Vec<f64>, mesh: &Mesh, plain: bool) -> Self {
        let count = mesh.faces.len();
        Self {
            particles,
            sizes,
            fans: mesh.fans(),
            middles: Vec::with_capacity(count),
            mixed: Vec::with_capacity(count),
            on: Vec::with_capacity(count),
            own: Vec::new(),
            vertices: mesh.vertices.len(),
            plain,
        }
    }

    /// Where an element's vertex belongs.
    pub fn middle(&self, mesh: &Mesh, face: &Face) -> DVec2 {
        match *face.nodes() {
            [a, b, c] if self.plain => circumcentre([a, b, c].map(|k| mesh.vertices[k as usize])),
            ref nodes => {
                let meeting = self.meeting(mesh, nodes);
                meeting.unwrap_or_else(|| face.centroid(&mesh.vertices))
            }
        }
    }

    /// Where the corners' cells meet: the larger a cell, the farther from it; nothing where one of
    /// them is no cell.
    fn meeting(&self, mesh: &Mesh, nodes: &[u32]) -> Option<DVec2> {
        let corner = |&k: &u32| Some((mesh.vertices[k as usize], *self.sizes.get(k as usize)?));
        let mut corners: Vec<(DVec2, f64)> = nodes.iter().map(corner).collect::<Option<_>>()?;
        // In one order, by ways that are exact on the grain: an element's image on a torus has the
        // vertex's image.
        order::sort(&mut corners, |c| (order::rank(c.0.x), order::rank(c.0.y)));
        let first = corners[0].0;
        let (mut way, mut total) = (DVec2::ZERO, 0.0);
        for (p, size) in corners {
            way += (p - first) / size;
            total += 1.0 / size;
        }
        Some(first + on_grain(way / total))
    }

    /// The vertices of all elements; `rim` cells fixed on the rim come next to the cells.
    pub fn put_middles(&mut self, domain: &Domain, mesh: &Mesh, rim: usize) {
        let real = self.particles.len();
        for face in &mesh.faces {
            let mut middle = self.middle(mesh, face);
            let corners = face.nodes().iter().map(|&k| k as usize);
            let sizes = corners.clone().filter(|&k| k < real);
            let sizes: Vec<f64> = sizes.map(|k| self.particles[k].size).collect();
            let mut on = On::Nothing;
            if !self.plain && !sizes.is_empty() && sizes.len() < face.nodes().len() {
                let size = sizes.iter().sum::<f64>() / sizes.len() as f64;
                // Round the element, from a cell on.
                let first = corners.clone().position(|k| k < real).unwrap_or(0);
                let round = corners.cycle().skip(first).take(face.nodes().len());
                let on_rim = round.filter(|k| (real..real + rim).contains(k));
                let on_rim: Vec<DVec2> = on_rim.map(|k| mesh.vertices[k]).collect();
                (middle, on) = self.at_wall(domain, middle, &on_rim, size);
            }
            self.push(middle, sizes.len() < face.nodes().len(), on);
        }
    }

    /// Where an element ends whose other nodes are ghosts, or cells fixed on the rim: there at the one
    /// or in the middle of the two; of three the one between the others.
    fn at_wall(&self, domain: &Domain, middle: DVec2, on_rim: &[DVec2], size: f64) -> (DVec2, On) {
        let middle = match *on_rim {
            [] => middle,
            [a] => a,
            [a, b] => a.midpoint(b),
            [_, b, ..] => b,
        };
        let near = domain.nearest(middle);
        if let Some(line) = domain.nearest_line(middle)
            && !on_rim.is_empty()
            && line.distance < near.distance.min(SNAP * size)
        {
            return (line.point, On::Line(line.segment));
        }
        if near.distance.abs() < SNAP * size {
            return (near.point, On::Outline(near.segment));
        }
        (middle, On::Nothing)
    }

    pub fn push(&mut self, middle: DVec2, mixed: bool, on: On) {
        self.middles.push(on_grain(middle));
        self.mixed.push(mixed);
        self.on.push(on);
    }

    /// Looks at elements that constraint lines divide from each side.
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
            let view = across::view(domain, &corners);
            let middle = face.centroid(&mesh.vertices);
            let shared = match view {
                across::View::Whole => continue,
                _ if self.mixed[index] => {
                    across::junction(domain, middle, size).map(|(k, p)| (p, On::Outline(k)))
                }
                across::View::Around => {
                    across::end(domain, middle, size).map(|(k, p)| (p, On::Line(k)))
                }
                across::View::Divided(_) => None,
            };
            if let Some((place, on)) = shared {
                (self.middles[index], self.on[index]) = (on_grain(place), on);
                continue;
            }
            let (across::View::Divided(group), false) = (view, self.mixed[index]) else {
                continue;
            };
            let first = self.own.len();
            for (k, &node) in nodes.iter().enumerate() {
                if let Some(like) = (0..k).find(|&j| group[j] == group[k]) {
                    let [.., seen] = self.own[first + like];
                    self.own.push([index as u32, node, seen]);
                    continue;
                }
                let mean = |same: bool| {
                    let which = (0..nodes.len()).filter(|&j| (group[j] == group[k]) == same);
                    which.clone().map(|j| corners[j]).sum::<DVec2>() / which.count() as f64
                };
                let foot = across::foot(domain, mean(true), mean(false), size);
                self.own
                    .push([index as u32, node, self.middles.len() as u32]);
                match foot {
                    Some((segment, place)) => self.push(place, true, On::Line(segment)),
                    None => self.push(middle, true, On::Nothing),
                }
            }
        }
        order::sort(&mut self.own, |o| (order::pair(o[0], o[1]), 0));
    }

    /// The vertex that a node sees of an element.
    fn seen(&self, element: u32, node: u32) -> u32 {
        let place = self.own.partition_point(|o| (o[0], o[1]) < (element, node));
        match self.own.get(place) {
            Some(&[e, n, vertex]) if (e, n) == (element, node) => vertex,
            _ => element,
        }
    }

    /// The vertices around a cell or a ghost, clockwise on screen; none where they do not close.
    pub fn around(&self, vertex: usize) -> Vec<u32> {
        let around = self.fans.around(vertex);
        if self.own.is_empty() {
            return around.to_vec();
        }
        let seen = around.iter().map(|&f| self.seen(f, vertex as u32));
        seen.collect()
    }

    /// The corners of a cell's polygon.
    pub fn ring(&self, vertex: usize) -> Vec<DVec2> {
        let around = self.around(vertex);
        let mut ring: Vec<DVec2> = around.iter().map(|&f| self.middles[f as usize]).collect();
        // Circles through the same four points have the same middle.
        ring.dedup();
        if ring.len() > 1 && ring.first() == ring.last() {
            ring.pop();
        }
        ring
    }
}
