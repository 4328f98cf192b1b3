//! Thin coloured plates on a face.

use super::super::parts::add_plain;
use crate::building::{Face, FaceSurface};
use crate::masonry::footprint::{Footprint, HalfPlane};
use crate::masonry::plan::region;
use crate::scene::Scene;
use crate::solid::Surface;
use crate::surface_stones::Fit;
use glam::DVec2;

/// Plates on a curved face are cut into flat strips of this width (metres).
const CHORD: f64 = 0.06;
/// The tint of plates: white, since their vertices have the colours.
const OWN: [u8; 3] = [255; 3];

/// The area of a face, to which plates are clipped.
pub(super) struct Sheet<'a> {
    face: &'a Face,
    /// Convex parts of the face in (s, t).
    inside: Vec<Footprint>,
    /// The bounding boxes of these parts.
    boxes: Vec<[DVec2; 2]>,
}

impl<'a> Sheet<'a> {
    pub fn new(face: &'a Face) -> Self {
        let [inside, _] = region(face).convex_parts(DVec2::ZERO);
        let boxes = inside.iter().map(Footprint::bounds).collect();
        Self {
            face,
            inside,
            boxes,
        }
    }

    /// The convex parts of the face.
    pub fn parts(&self) -> &[Footprint] {
        &self.inside
    }

    /// The parts of a polygon that lie on the face. On a whole cylinder, the polygon is also tried one period to either
    /// side.
    pub fn within(&self, polygon: &Footprint) -> Vec<Footprint> {
        let period = self.face.surface.period();
        let shifts = match period {
            None => vec![0.0],
            Some(period) => vec![0.0, -period, period],
        };
        let images = shifts
            .into_iter()
            .map(|shift| polygon.clone().moved(DVec2::new(shift, 0.0)));
        images
            .flat_map(|image| {
                let [low, high] = image.bounds();
                let near = self.inside.iter().zip(&self.boxes);
                let near = near
                    .filter(move |(_, [from, to])| from.cmplt(high).all() && low.cmplt(*to).all());
                near.filter_map(|(part, _)| image.intersection(part))
                    .collect::<Vec<_>>()
            })
            .collect()
    }
}

/// Plates on one face, which become one body.
pub(super) struct Plates<'a> {
    face: &'a FaceSurface,
    fit: Fit,
    surface: Surface,
}

impl<'a> Plates<'a> {
    pub fn new(face: &'a Face, fit: Fit) -> Self {
        Self {
            face: &face.surface,
            fit,
            surface: Surface::default(),
        }
    }

    /// Adds a polygon of (s, t), `z` metres before the face.
    pub fn add(&mut self, polygon: &Footprint, z: f64, colour: [u8; 3]) {
        let is_plane = self.face.is_flat() && matches!(self.face, FaceSurface::Sweep(_));
        if is_plane {
            return self.add_flat(polygon, z, colour);
        }
        let [low, high] = polygon.bounds();
        let (from, to) = ((low.x / CHORD).floor(), (high.x / CHORD).ceil());
        for strip in 0..(to - from) as usize {
            let start = (from + strip as f64) * CHORD;
            let half = |normal: DVec2, offset: f64| HalfPlane { normal, offset };
            let part = polygon
                .clip(half(DVec2::X, start), 0.0)
                .and_then(|part| part.clip(half(DVec2::NEG_X, -start - CHORD), 0.0));
            if let Some(part) = part {
                self.add_flat(&part, z, colour);
            }
        }
    }

    fn add_flat(&mut self, polygon: &Footprint, z: f64, colour: [u8; 3]) {
        let surface = &mut self.surface;
        let first = surface.positions.len() as u32;
        for p in polygon.places() {
            let frame = self.face.map(p.x, p.y, z);
            surface.positions.push(self.fit.place(frame.origin));
            surface.normals.push(frame.normal.as_vec3());
            surface.colours.push(colour);
        }
        let count = surface.positions.len() as u32 - first;
        let fan = (2..count).map(|k| [first, first + k - 1, first + k]);
        surface.triangles.extend(fan);
    }

    /// Adds the plates to a scene as one body with an id, in a material.
    pub fn finish(self, scene: &mut Scene, (id, material): (u32, u8)) {
        if !self.surface.triangles.is_empty() {
            add_plain(scene, self.surface, (id, OWN, material));
        }
    }
}
