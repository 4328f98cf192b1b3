//! A shape that is made: its surface, its walls and its vessel.

use crate::pile::Wall;
use crate::solid::Surface;
use crate::trimesh::Soup;
use glam::{DVec3, Vec3};

/// A shape to heap bodies on. Lengths are shares of its largest side, until it is scaled.
#[derive(Clone, Debug, PartialEq)]
pub struct PiledShape {
    /// Darts are thrown on these triangles. Their normals point away from the solid; those of an open surface, upwards.
    pub surface: Soup,
    /// The inside of a bowl or a box, or the ground under an open surface.
    pub walls: Vec<Wall>,
    /// The container that is seen.
    pub vessel: Option<Vessel>,
}

/// A container that is seen.
#[derive(Clone, Debug, PartialEq)]
pub struct Vessel {
    /// Its triangles in the units of the shape, y up, counter-clockwise seen from outside. They are white until
    /// [`Self::coloured`].
    pub surface: Surface,
    /// The part to which each vertex belongs: the number of a board. A bowl is one part.
    pub parts: Vec<u32>,
    /// The word for its material: `ceramic` or `wood`.
    pub material: &'static str,
}

impl PiledShape {
    /// A closed shape, which needs no wall.
    pub(super) fn free(surface: Soup) -> Self {
        Self {
            surface,
            walls: Vec::new(),
            vessel: None,
        }
    }

    /// An open surface on the ground.
    pub(super) fn grounded(surface: Soup) -> Self {
        let ground = Wall::Plane {
            normal: DVec3::NEG_Y,
            offset: 0.0,
        };
        Self {
            walls: vec![ground],
            ..Self::free(surface)
        }
    }

    /// The shape `by` times as large; `by` is above 0.
    pub fn scaled(mut self, by: f64) -> Self {
        self.surface.positions.iter_mut().for_each(|p| *p *= by);
        for wall in &mut self.walls {
            match wall {
                Wall::Plane { offset, .. } => *offset *= by,
                Wall::Bowl { lowest, curve } => {
                    *lowest *= by;
                    *curve /= by;
                }
            }
        }
        if let Some(vessel) = &mut self.vessel {
            let places = &mut vessel.surface.positions;
            places.iter_mut().for_each(|p| *p *= by as f32);
        }
        self
    }
}

impl Vessel {
    pub(super) fn new(material: &'static str) -> Self {
        Self {
            surface: Surface::default(),
            parts: Vec::new(),
            material,
        }
    }

    /// Adds a part: its vertices, their unit normals, and its triangles, which are turned to agree with these normals.
    pub(super) fn add(&mut self, soup: &Soup, normals: &[DVec3]) {
        let surface = &mut self.surface;
        let first = surface.positions.len() as u32;
        let part = self.parts.last().map_or(0, |last| last + 1);
        let triangles = soup.triangles.iter().map(|t| {
            let [a, b, c] = t.map(|v| soup.positions[v as usize]);
            let mean: DVec3 = t.iter().map(|&v| normals[v as usize]).sum();
            let agrees = (b - a).cross(c - a).dot(mean) > 0.0;
            let [a, b, c] = t.map(|v| v + first);
            if agrees { [a, b, c] } else { [a, c, b] }
        });
        surface.triangles.extend(triangles);
        let places = soup.positions.iter().map(|p| p.as_vec3());
        surface.positions.extend(places);
        surface.normals.extend(normals.iter().map(|n| n.as_vec3()));
        let count = surface.positions.len();
        surface.colours.resize(count, [255; 3]);
        self.parts.resize(count, part);
    }

    /// The vessel with colours (sRGB, before lighting). `colour` gets the part and the place of each vertex.
    pub fn coloured(mut self, colour: impl Fn(u32, Vec3) -> [u8; 3]) -> Self {
        let vertices = self.parts.iter().zip(&self.surface.positions);
        self.surface.colours = vertices.map(|(&part, &p)| colour(part, p)).collect();
        self
    }
}
