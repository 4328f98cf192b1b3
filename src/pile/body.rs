//! Bodies of a pile.

use super::{Dart, Kind, Shape};
use crate::component::Sphere;
use glam::{DMat3, DVec3};

/// The fate of a dart's body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// It has not been handled yet.
    Waiting,
    /// It was left out when the types were merged.
    Merged,
    /// It would pass a wall or the ground in every orientation that was tried.
    Walls,
    /// It found no place in its range.
    Removed,
    /// It is a part of the pile.
    Kept,
}

/// The body of a dart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// The number of its dart.
    pub dart: u32,
    /// The number of its type.
    pub kind: u32,
    /// The number of its variant within the type.
    pub shape: u32,
    /// The number of its layer: 0 on the surface, and then inwards.
    pub layer: u32,
    /// The place of its dart.
    pub at: DVec3,
    /// The unit normal along which it slides.
    pub normal: DVec3,
    /// The rotation from its own frame to space.
    pub turn: DMat3,
    /// Its size, as a factor of its component.
    pub scale: f64,
    /// How far it has slid along the normal, outwards if above 0.
    pub t: f64,
    /// The least and greatest t.
    pub range: (f64, f64),
    /// Whether it was kept, and else why not.
    pub fate: Fate,
}

impl Body {
    /// A body that waits to settle, or that is merged if its dart does not stay.
    pub(super) fn waiting(number: u32, dart: &Dart, stays: bool) -> Self {
        Self {
            dart: number,
            kind: dart.kind,
            shape: 0,
            layer: dart.layer,
            at: dart.at,
            normal: dart.normal,
            turn: DMat3::IDENTITY,
            scale: 0.0,
            t: 0.0,
            range: (0.0, 0.0),
            fate: if stays { Fate::Waiting } else { Fate::Merged },
        }
    }

    /// Its origin in space.
    pub fn place(&self) -> DVec3 {
        self.at + self.t * self.normal
    }

    /// The data of its variant.
    pub fn shape<'a>(&self, kinds: &'a [Kind]) -> &'a Shape {
        &kinds[self.kind as usize].shapes[self.shape as usize]
    }

    /// R, the radius of its largest inner sphere.
    pub fn radius(&self, kinds: &[Kind]) -> f64 {
        self.shape(kinds).radius * self.scale
    }

    /// Its inner spheres in space.
    pub fn spheres<'a>(&self, kinds: &'a [Kind]) -> impl Iterator<Item = Sphere> + use<'a> {
        let (turn, scale, place) = (self.turn, self.scale, self.place());
        self.shape(kinds).spheres.iter().map(move |s| Sphere {
            centre: place + turn * (scale * s.centre),
            radius: scale * s.radius,
        })
    }
}
