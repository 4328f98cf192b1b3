//! The view of the cells' polygons: a colour each, with thin joints.

use super::ground::push;
use super::paint::Edged;
use super::{BARE, BareSurface, MAP};
use crate::draw::{Tones, planes::id_colour};
use crate::scene::{Body, Scene};
use crate::solid::Surface;
use crate::surface_cells::SurfaceCell;
use crate::surface_stones::Fit;
use glam::{DVec3, Vec3};

/// Half the width of a joint, in sizes of its cell.
const JOINT: f64 = 0.034;
/// The colour of joints, and of the surface that no cell covers.
const DARK: [u8; 3] = [52, 46, 40];
/// How far the surface that no cell covers is sunk, in mean sizes of cells.
const SUNK: f64 = 0.12;
/// How many parts a side is divided into, at each level of detail.
const DEGREES: [usize; 3] = [4, 2, 1];
/// Cells in a slice.
const CELLS: usize = 150;

/// The view of cells, while it is made.
pub struct CellsView {
    scene: Scene,
    edged: Edged,
    next: usize,
    /// The tones of the stones to come; without them each cell differs from its neighbours in colour.
    tones: Option<Tones>,
}

impl CellsView {
    /// Starts the view. With `tones` cells have the colours of the stones to come; else each differs in colour from
    /// its neighbours.
    pub fn new(tones: Option<&Tones>) -> Self {
        Self {
            scene: Scene::default(),
            edged: Edged::new(DARK),
            next: 0,
            tones: tones.cloned(),
        }
    }

    /// Does one more slice; true when done. Ground and cells must be the same each time. The id of a cell in frames
    /// is its index plus 1.
    pub fn advance(&mut self, ground: &BareSurface, cells: &[SurfaceCell]) -> bool {
        let fit = ground.fit();
        if self.next < cells.len() {
            let to = cells.len().min(self.next + CELLS);
            for cell in &cells[self.next..to] {
                self.add(cell, &fit);
            }
            self.next = to;
            return false;
        }
        if self.scene.reach == 0.0 {
            let sizes = cells.iter().map(|c| c.size).sum::<f64>();
            let mean = (sizes / cells.len().max(1) as f64 * fit.scale) as f32;
            self.scene.reach = 0.5 * mean.max(1e-3);
            ground.add_to(&mut self.scene, BARE, SUNK as f32 * mean, DARK);
        }
        true
    }

    /// Does all the work at once.
    pub fn build(ground: &BareSurface, cells: &[SurfaceCell], tones: Option<&Tones>) -> Scene {
        let mut view = Self::new(tones);
        while !view.advance(ground, cells) {}
        view.finish()
    }

    /// The finished scene.
    pub fn finish(self) -> Scene {
        Scene {
            detail: Some(Box::new(self.edged)),
            ..self.scene
        }
    }

    fn add(&mut self, cell: &SurfaceCell, fit: &Fit) {
        let colour = match &self.tones {
            Some(tones) => super::bytes(tones.stone(cell.id)),
            None => id_colour(cell.id + 1),
        };
        let half = (JOINT * cell.size * fit.scale) as f32;
        let id = self
            .edged
            .push(cell.ring.iter().map(|&p| fit.place(p)), half);
        if cell.ring.len() < 3 {
            return;
        }
        let levels = DEGREES.map(|parts| patch(cell, parts, colour, fit));
        push(&mut self.scene, Body::new(levels.to_vec(), MAP), id);
    }
}

/// The triangles from a cell's centre to its sides, each divided and bent like the surface.
fn patch(cell: &SurfaceCell, parts: usize, colour: [u8; 3], fit: &Fit) -> Surface {
    let mut surface = Surface::default();
    let count = cell.ring.len();
    for k in 0..count {
        let next = (k + 1) % count;
        let places = [cell.centre.at, cell.ring[k], cell.ring[next]];
        let normals = [cell.centre.normal, cell.normals[k], cell.normals[next]];
        let first = surface.positions.len() as u32;
        // Rows from the centre to the side.
        for row in 0..=parts {
            for along in 0..=row {
                let [out, right] = [row, along].map(|v| v as f64 / parts as f64);
                let (place, normal) = bent(&places, &normals, [1.0 - out, out - right, right]);
                surface.positions.push(fit.place(place));
                surface.normals.push(normal);
            }
        }
        let at = |row: usize, along: usize| first + (row * (row + 1) / 2 + along) as u32;
        for row in 0..parts {
            for along in 0..=row {
                let [below, beside] = [at(row + 1, along), at(row + 1, along + 1)];
                surface.triangles.push([at(row, along), below, beside]);
                if along < row {
                    surface
                        .triangles
                        .push([at(row, along), beside, at(row, along + 1)]);
                }
            }
        }
    }
    surface.colours = vec![colour; surface.positions.len()];
    surface
}

/// A point of a triangle, moved towards the surface that the normals at its corners describe (Boubekeur, Alexa 2008,
/// Phong Tessellation). With the factor one half, sides become the arcs that have these normals.
fn bent(places: &[DVec3; 3], normals: &[DVec3; 3], weights: [f64; 3]) -> (DVec3, Vec3) {
    let (mut flat, mut normal) = (DVec3::ZERO, DVec3::ZERO);
    for k in 0..3 {
        flat += places[k] * weights[k];
        normal += normals[k] * weights[k];
    }
    let mut lift = DVec3::ZERO;
    for k in 0..3 {
        lift -= normals[k] * ((flat - places[k]).dot(normals[k]) * weights[k]);
    }
    let normal = normal.normalize_or(normals[0]);
    (flat + lift * 0.5, normal.as_vec3())
}
