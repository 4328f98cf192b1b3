//! Parametric surfaces: fifteen shapes with three to five numbers each.
//!
//! Closed ones are solid `form`s: functions that are negative inside. Their first triangles come from `march` on a
//! coarse grid, and `remesh` makes them even. Then they are divided and moved onto the form until their edges are as
//! short as wanted, so the cost is proportional to the triangles. Ground, stairs and cylinders are laid out row by
//! row.
//!
//! y is up. A shape stands on y = 0, with its middle over the origin, and its largest side is about 1. Directions
//! follow its bones ([`Bone`]), from head to tail.

mod bone;
mod canal;
mod curled;
mod drum;
mod fish;
mod flight;
mod form;
mod glyphs;
mod jet;
mod leg;
mod letter;
mod making;
mod march;
pub(crate) mod numbers;
mod remesh;
mod round;
mod surgery;
mod terrain;
#[cfg(test)]
mod tests;
mod turtle;
mod vase;

pub use bone::{Bone, OnBone};
pub use form::{Cut, Ends};
pub use making::ShapeMaking;
pub use numbers::ShapeNumber;

use crate::trimesh::Soup;
use form::Form;
use glam::DVec3;

/// A parametric surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Hills, with a lane between them.
    Terrain,
    /// Level ground, a slope, and level ground again.
    Slope,
    /// Steps up to a landing.
    Stairs,
    /// A round wall, with or without caps.
    Cylinder,
    /// A ball, an ellipsoid, or a rounded cube.
    Sphere,
    /// A torus, plain or with waves.
    Torus,
    /// A torus knot.
    Knot,
    /// A spiral horn of growing radius, with a closed tip.
    Horn,
    /// A dinosaur's leg with toes.
    Leg,
    /// A curled, tapered tail.
    Tail,
    /// A fish with its fins.
    Fish,
    /// The shell of a turtle.
    Turtle,
    /// An egg on its blunt end.
    Egg,
    /// A vase with a neck, a lip, and an inside.
    Vase,
    /// A thick letter of the alphabet.
    Letter,
}

/// The shortest edges, as a share of the diagonal.
const FINEST: f64 = 0.002;

impl Shape {
    /// Starts to make the triangles. `numbers` are those of [`Self::numbers`]; they are clamped to their ranges.
    /// `edge` is the wanted length of edges, as a share of the diagonal of the shape's bounding box. Edges are
    /// shorter where parts of the shape would be lost otherwise ([`Self::coarsest`]).
    pub fn making(self, numbers: &[f64], edge: f64, ends: Ends) -> ShapeMaking {
        ShapeMaking::new((self, ends), &self.fitted(numbers), fitted(edge))
    }

    /// Whether two lengths of edges lead to the same triangles; see [`Self::making`].
    pub fn is_alike(self, numbers: &[f64], ends: Ends, edges: [f64; 2]) -> bool {
        making::are_alike((self, ends), &self.fitted(numbers), edges.map(fitted))
    }

    /// The vertices and triangles, all at once; see [`Self::making`].
    pub fn build(self, numbers: &[f64], edge: f64) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let mut making = self.making(numbers, edge, Ends::Round);
        while !making.advance() {}
        let made = making.finish();
        (made.positions, made.triangles)
    }

    /// The longest edges that still resolve all parts, as a share of the diagonal.
    pub fn coarsest(self, numbers: &[f64]) -> f64 {
        match solid((self, Ends::Round), &self.fitted(numbers)) {
            Some(form) => {
                let (lo, hi) = form.bounds();
                form.coarsest() / (hi - lo).length()
            }
            None => PLAIN_COARSEST,
        }
    }

    /// The bones, from head to tail: down the leg and out along each toe, along the fish, up the vase, along the
    /// strokes of the letter, along the lane. Empty if the shape has none, see [`Self::main`].
    pub fn bones(self, numbers: &[f64]) -> Vec<Bone> {
        let numbers = self.fitted(numbers);
        match (solid((self, Ends::Round), &numbers), self) {
            (Some(form), _) => form.bones(),
            (None, Self::Terrain) => terrain::Terrain::new(&numbers).bones(),
            (None, Self::Cylinder) => drum::Drum::new(&numbers).bones(),
            (None, _) => Vec::new(),
        }
    }

    /// The plane faces where the body is cut off, if it is made with [`Ends::Cut`].
    pub fn cuts(self, numbers: &[f64]) -> Vec<Cut> {
        let form = solid((self, Ends::Cut), &self.fitted(numbers));
        form.map_or(Vec::new(), |form| form.cuts())
    }

    /// The claws and horny tips of a body made with [`Ends::Cut`], each from its root to its point.
    pub fn claws(self, numbers: &[f64]) -> Vec<Bone> {
        let form = solid((self, Ends::Cut), &self.fitted(numbers));
        form.map_or(Vec::new(), |form| form.claws())
    }

    /// Unit vector of the main direction, from head to tail.
    pub fn main(self) -> DVec3 {
        match self {
            Self::Fish | Self::Turtle => DVec3::X,
            Self::Leg => DVec3::NEG_Y,
            Self::Slope | Self::Stairs | Self::Terrain => DVec3::Z,
            _ => DVec3::Y,
        }
    }

    /// The height of the ground at a place; `None` for every shape but terrain.
    pub fn height(self, numbers: &[f64], x: f64, z: f64) -> Option<f64> {
        (self == Self::Terrain).then(|| terrain::Terrain::new(&self.fitted(numbers)).height(x, z))
    }
}

/// A wanted length of edges, within its range.
fn fitted(edge: f64) -> f64 {
    let edge = if edge.is_finite() { edge } else { 1.0 };
    edge.clamp(FINEST, 1.0)
}

/// The longest edges of ground, stairs and cylinders, as a share of the diagonal.
const PLAIN_COARSEST: f64 = 0.1;

/// The solid form of a shape, if it has one. `n` are the shape's numbers, within their ranges.
fn solid((shape, ends): (Shape, Ends), n: &[f64]) -> Option<Box<dyn Form>> {
    Some(match shape {
        Shape::Terrain | Shape::Slope | Shape::Stairs | Shape::Cylinder => return None,
        Shape::Sphere => Box::new(round::Ball::new(n)),
        Shape::Egg => Box::new(round::Egg::new(n)),
        Shape::Torus => Box::new(curled::torus(n)),
        Shape::Knot => Box::new(curled::knot(n)),
        Shape::Horn => Box::new(curled::horn(n, ends)),
        Shape::Tail => Box::new(curled::tail(n, ends)),
        Shape::Leg => Box::new(leg::Leg::new(n, ends)),
        Shape::Fish => Box::new(fish::Fish::new(n)),
        Shape::Turtle => Box::new(turtle::Turtle::new(n)),
        Shape::Vase => Box::new(vase::Vase::new(n)),
        Shape::Letter => Box::new(letter::Letter::new(n)),
    })
}

/// The triangles of a shape that has no solid form.
fn plain(shape: Shape, n: &[f64], edge: f64) -> Soup {
    let edge = edge.min(PLAIN_COARSEST);
    match shape {
        Shape::Slope => flight::slope(n, edge),
        Shape::Stairs => flight::stairs(n, edge),
        Shape::Cylinder => drum::Drum::new(n).build(edge),
        _ => terrain::Terrain::new(n).build(edge),
    }
}
