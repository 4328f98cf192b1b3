//! Types of bodies: the data that heaping needs.

use super::Turn;
use crate::component::{Component, Sphere};
use glam::DVec3;

/// One variant of a component. The origin is the centre of the largest inner sphere, about which bodies turn
/// (section 4.1.3).
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// The spheres that stand for the body, the most important ones first. They may be wider than the inner spheres.
    pub spheres: Vec<Sphere>,
    /// Points of the surface: walls and the paper's cost look at these.
    pub points: Vec<DVec3>,
    /// R, the radius of the largest inner sphere.
    pub radius: f64,
    /// d, the diagonal of the bounding box.
    pub diagonal: f64,
    /// The greatest distance of the surface and of the spheres from the origin.
    pub bound: f64,
}

/// The most points of a shape: they are the vertices of the finest level of detail that has no more.
const MOST_POINTS: usize = 400;

impl Shape {
    /// The part of a component that heaping uses.
    pub fn of(component: &Component) -> Self {
        let spheres: Vec<Sphere> = component.widened().collect();
        let reach = |s: &Sphere| s.centre.length() + s.radius;
        Self {
            points: component.coarse(MOST_POINTS).mesh.positions().to_vec(),
            radius: component.radius,
            diagonal: component.diagonal,
            bound: spheres.iter().map(reach).fold(component.reach, f64::max),
            spheres,
        }
    }
}

/// A type of bodies, and how it is heaped.
#[derive(Clone, Debug, PartialEq)]
pub struct Kind {
    /// The variants of the component, at least one. The first one gives R and d of the type.
    pub shapes: Vec<Shape>,
    /// The size of a body, as a factor of its component; above 0.
    pub scale: f64,
    /// Sizes differ by up to this share of `scale`, 0 to below 1.
    pub jitter: f64,
    /// σ, the factor of the distribution radius (section 4.1.1): below 1 is tight, above 1 is loose.
    pub density: f64,
    /// How bodies are turned.
    pub turn: Turn,
    /// l, the length of the refinement range in units of d (section 4.2.2).
    pub range: f64,
    /// The share of the range that lies inside of the surface, 0 to 1.
    pub inward: f64,
}

impl Kind {
    /// R of the type: that of its first variant, at its size.
    pub fn radius(&self) -> f64 {
        self.shapes[0].radius * self.scale
    }

    /// d of the type: that of its first variant, at its size.
    pub fn diagonal(&self) -> f64 {
        self.shapes[0].diagonal * self.scale
    }

    /// The least distance of two darts: twice the distribution radius r = σ R / 2 (section 4.1.1).
    pub fn spacing(&self) -> f64 {
        self.density * self.radius()
    }

    /// The greatest distance of a surface from its body's origin, over all variants and sizes.
    pub fn bound(&self) -> f64 {
        let widest = self.shapes.iter().map(|s| s.bound).fold(0.0, f64::max);
        widest * self.scale * (1.0 + self.jitter)
    }
}

/// Bodies that a normal of the surface should pierce: "three to five components" (section 4.2.2).
const PIERCED: f64 = 4.0;
/// The share of the space that bodies fill in a pile, measured over the components by rule.
const FILLED: f64 = 0.45;

/// The range l, in units of d, in which about four bodies are pierced along a normal.
///
/// A layer of thickness h in which bodies fill the share f of the space has f h S / (4 V) bodies along a line. Bodies
/// of volume V and surface area S are 4 V / S thick in the mean (Cauchy). A pile is thicker than its range by half of
/// the difference between a body's diagonal and its mean thickness.
pub fn natural_range(volume: f64, area: f64, diagonal: f64) -> f64 {
    let thickness = 4.0 * volume / area;
    let height = PIERCED * thickness / FILLED;
    ((height - 0.5 * (diagonal - thickness)) / diagonal).clamp(0.05, 12.0)
}
