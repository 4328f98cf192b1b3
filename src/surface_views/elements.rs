//! The view of the cells' mesh: elements with lines along their sides, and irregular nodes.

use super::domes::ball;
use super::ground::push;
use super::paint::Edged;
use super::{BareSurface, INSIDE, MAP, SATIN, bytes, standing};
use crate::draw::field::{AGAINST, WITH};
use crate::draw::stages::{FACE, INK, LONE};
use crate::draw::{Colour, blend};
use crate::order::pair;
use crate::scene::{Body, Scene};
use crate::solid::Surface;
use crate::surface_cells::SurfaceMesh;
use crate::surface_stones::Fit;
use crate::trimesh::SurfacePoint;
use glam::Vec3;

/// The colour of triangles among quadrilaterals.
const TRIANGLE: Colour = [0.62, 0.70, 0.74, 1.0];
/// Half the width of lines, in sizes of cells.
const LINE: f64 = 0.022;
/// The radius of a node's ball, in sizes of its cell.
const BALL: f64 = 0.15;
/// Elements in a slice.
const ELEMENTS: usize = 400;

/// The view of a mesh, while it is made.
pub struct MeshView {
    scene: Scene,
    edged: Edged,
    next: usize,
    has_inside: bool,
    is_done: bool,
}

impl MeshView {
    /// Starts the view.
    pub fn new() -> Self {
        Self {
            scene: Scene::default(),
            edged: Edged::new(bytes(INK)),
            next: 0,
            has_inside: false,
            is_done: false,
        }
    }

    /// Does one more slice; true when done. Ground and mesh must be the same each time.
    pub fn advance(&mut self, ground: &BareSurface, mesh: &SurfaceMesh) -> bool {
        let fit = ground.fit();
        if self.next < mesh.elements.len() {
            self.has_inside = ground.has_inside();
            let to = mesh.elements.len().min(self.next + ELEMENTS);
            for k in self.next..to {
                self.element(mesh, k, &fit);
            }
            self.next = to;
        } else if !self.is_done {
            self.mark(mesh, &fit);
            self.is_done = true;
        }
        self.is_done
    }

    /// Does all the work at once.
    pub fn build(ground: &BareSurface, mesh: &SurfaceMesh) -> Scene {
        let mut view = Self::new();
        while !view.advance(ground, mesh) {}
        view.finish()
    }

    /// The finished scene.
    pub fn finish(self) -> Scene {
        Scene {
            detail: Some(Box::new(self.edged)),
            ..self.scene
        }
    }

    fn element(&mut self, mesh: &SurfaceMesh, k: usize, fit: &Fit) {
        let nodes = mesh.elements[k].nodes();
        let points: Vec<&SurfacePoint> = nodes.iter().map(|&n| &mesh.nodes[n as usize]).collect();
        let cells = || nodes.iter().map(|&n| &mesh.cells[n as usize]);
        let size = cells().map(|c| c.size).sum::<f64>() / nodes.len() as f64;
        let colour = match nodes.len() {
            4.. => FACE,
            _ if cells().all(|c| c.kind.has_corners()) => LONE,
            _ => TRIANGLE,
        };
        let half = (LINE * size * fit.scale) as f32;
        let id = self
            .edged
            .push(points.iter().map(|p| fit.place(p.at)), half);
        push(
            &mut self.scene,
            face(&points, bytes(colour), fit, self.has_inside),
            id,
        );
    }

    /// Adds balls at irregular nodes inside the mesh.
    fn mark(&mut self, mesh: &SurfaceMesh, fit: &Fit) {
        let body = self.scene.bodies.len() as u32;
        let sizes = mesh.cells.iter().map(|c| c.size).sum::<f64>();
        self.scene.reach = (0.5 * sizes / mesh.cells.len().max(1) as f64 * fit.scale) as f32;
        let first = self.edged.half.len() as u32;
        for (node, more) in irregular(mesh) {
            let (at, size) = (&mesh.nodes[node], mesh.cells[node].size);
            let colour = if more < 0 { WITH } else { AGAINST };
            // The farther from regular, the darker.
            let deep = (more.abs() - 1).clamp(0, 2) as f32;
            let [r, g, b, _] = blend(colour, [0.0, 0.0, 0.0, 1.0], 0.25 * deep);
            self.edged.tints.push([r, g, b]);
            let id = first + self.edged.tints.len() as u32;
            let frame = at.frame();
            let axes = [frame.x, frame.normal];
            let scale = BALL * size * fit.scale;
            let instance = standing(body, id, fit.place(at.at), axes, scale);
            self.scene.instances.push(instance);
        }
        if !self.edged.tints.is_empty() {
            self.scene.bodies.push(ball(1.0, SATIN));
        }
    }
}

impl Default for MeshView {
    fn default() -> Self {
        Self::new()
    }
}

/// Irregular inner nodes: those with more or fewer neighbours than the regular number, four among cells with corners
/// and six among others. Returns the node and the difference.
pub(super) fn irregular(mesh: &SurfaceMesh) -> Vec<(usize, i32)> {
    let (mut around, mut sides) = (vec![0; mesh.nodes.len()], Vec::new());
    for element in &mesh.elements {
        let nodes = element.nodes();
        for (k, &a) in nodes.iter().enumerate() {
            around[a as usize] += 1;
            sides.push(pair(a, nodes[(k + 1) % nodes.len()]));
        }
    }
    sides.sort_unstable();
    let mut is_inside: Vec<bool> = around.iter().map(|&n| n > 0).collect();
    for &side in &sides {
        let [a, b] = [(side >> 32) as u32, side as u32];
        if sides.binary_search(&pair(b, a)).is_err() {
            is_inside[a as usize] = false;
            is_inside[b as usize] = false;
        }
    }
    let more = |node: usize| {
        let wanted = if mesh.cells[node].kind.has_corners() {
            4
        } else {
            6
        };
        (node, around[node] - wanted)
    };
    let inside = (0..mesh.nodes.len()).filter(|&node| is_inside[node]);
    inside.map(more).filter(|&(_, more)| more != 0).collect()
}

/// A flat element; a quadrilateral folds along its shorter diagonal.
fn face(points: &[&SurfacePoint], colour: [u8; 3], fit: &Fit, has_inside: bool) -> Body {
    let places: Vec<Vec3> = points.iter().map(|p| fit.place(p.at)).collect();
    let triangles = match places.len() {
        4 if places[0].distance_squared(places[2]) > places[1].distance_squared(places[3]) => {
            vec![[0, 1, 3], [1, 2, 3]]
        }
        count => (2..count as u32)
            .map(|k| [0, k - 1, k])
            .collect::<Vec<[u32; 3]>>(),
    };
    let mut sum = Vec3::ZERO;
    for &[a, b, c] in &triangles {
        let [a, b, c] = [a, b, c].map(|k: u32| places[k as usize]);
        sum += (b - a).cross(c - a);
    }
    let flat = sum.normalize_or_zero();
    // Mix in some of the surface's normals, so that rows of elements look continuous.
    let normals: Vec<Vec3> = points
        .iter()
        .map(|p| (flat + p.normal.as_vec3() * 0.6).normalize_or(flat))
        .collect();
    let mut surface = Surface {
        colours: vec![colour; places.len()],
        positions: places,
        normals,
        triangles,
    };
    if has_inside {
        add_inside(&mut surface);
    }
    Body::new(vec![surface], MAP)
}

/// Adds a copy of the surface for its other side.
pub(super) fn add_inside(surface: &mut Surface) {
    let count = surface.positions.len() as u32;
    surface.positions.extend_from_within(..);
    let inwards: Vec<Vec3> = surface.normals.iter().map(|&n| -n).collect();
    surface.normals.extend(inwards);
    let dark = |colour: &[u8; 3]| colour.map(|v| (f32::from(v) * INSIDE) as u8);
    let dark: Vec<[u8; 3]> = surface.colours.iter().map(dark).collect();
    surface.colours.extend(dark);
    let turned = |&[a, b, c]: &[u32; 3]| [a, c, b].map(|v| v + count);
    let turned: Vec<[u32; 3]> = surface.triangles.iter().map(turned).collect();
    surface.triangles.extend(turned);
}
