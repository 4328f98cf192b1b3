//! A plane that cuts away bodies, so that a view shows the bodies behind it.

use super::clip::{ConvexPolygon, between};
use crate::decimal;
use glam::{DVec3, Vec3};

/// How bodies are cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CutHow {
    /// A body whose middle lies beyond the plane is left out as a whole.
    Whole,
    /// The part of a body beyond the plane is cut away; the cut face has the body's mean colour.
    Through,
}

/// A plane beyond which bodies are cut away, also for their shadows. Lines and the floor stay.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// Unit vector to the side that is cut away.
    pub normal: Vec3,
    /// The plane's distance from the origin, along the normal.
    pub at: f32,
    /// How bodies are cut.
    pub how: CutHow,
}

/// How much of a body is left.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Left {
    All,
    Some,
    None,
}

impl Cut {
    /// Both ways to cut, with their words in a text.
    const WORDS: [(CutHow, &'static str); 2] =
        [(CutHow::Whole, "whole"), (CutHow::Through, "through")];

    /// Reads `whole=X,Y,Z,D` or `through=X,Y,Z,D`: a normal of any length, and the distance along it of the plane from
    /// the origin. `None` for any other text.
    pub fn read(word: &str) -> Option<Self> {
        let (how, numbers) = word.split_once('=')?;
        let (how, _) = Self::WORDS.into_iter().find(|(_, word)| *word == how)?;
        let numbers: Option<Vec<f64>> = numbers.split(',').map(decimal::parse).collect();
        let [x, y, z, at] = numbers?.try_into().ok()?;
        let normal = DVec3::new(x, y, z).try_normalize()?.as_vec3();
        let at = at as f32;
        (normal.is_finite() && at.is_finite()).then_some(Self { normal, at, how })
    }

    /// How far a point lies beyond the plane; negative on the side that is kept.
    #[inline(always)]
    fn beyond(&self, p: Vec3) -> f32 {
        self.normal.dot(p) - self.at
    }

    /// How much is left of a body with this bounding ball.
    pub(super) fn left_of(&self, (middle, radius): (Vec3, f32)) -> Left {
        let beyond = self.beyond(middle);
        match self.how {
            CutHow::Whole if beyond > 0.0 => Left::None,
            CutHow::Through if beyond >= radius => Left::None,
            CutHow::Through if beyond > -radius => Left::Some,
            _ => Left::All,
        }
    }

    /// The part of a triangle that is left.
    pub(super) fn rest_of(&self, triangle: [Vec3; 3]) -> ConvexPolygon<4> {
        ConvexPolygon::triangle(triangle).cut(|p| -self.beyond(p), between)
    }

    /// The depth at which a ray from the eye, of depth 1, meets the plane.
    pub(super) fn depth(&self, eye: Vec3, ray: Vec3) -> f32 {
        (self.at - self.normal.dot(eye)) / self.normal.dot(ray)
    }
}
