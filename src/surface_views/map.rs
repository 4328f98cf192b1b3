//! The view of a number on the surface as colours: its curvature, or the size of cells.
//!
//! Vertices hold the number in place of a colour. It becomes a colour at each pixel, so scales and contours are
//! sharp.

use super::bars::star;
use super::ground::push;
use super::paint::tint;
use super::spread::Spread;
use super::{BareSurface, MAP, standing};
use crate::draw::size::{CONTOURS, contour, heat};
use crate::draw::{Colour, SHEET, blend};
use crate::order::{self, greater, lesser};
use crate::scene::{Detail, Scene, Surfel};
use crate::surface_field::SurfaceFields;
use crate::trimesh::{SurfacePoint, TriMesh};

/// The number that a map shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The mean of the two principal curvatures, in one over the model's units.
    Mean,
    /// The square root of the Gaussian curvature's size, with the sign of that curvature: positive on domes, negative
    /// on saddles. In one over the model's units.
    Gaussian,
    /// The size that cells should have, in the model's units.
    Size,
}

/// The meaning of a map's colours.
#[derive(Clone, Debug, PartialEq)]
pub struct Legend {
    /// The number that the map shows.
    pub quantity: Quantity,
    /// The numbers at the ends of the scale; numbers beyond have the colours of the ends. Sizes are spread by their
    /// logarithms.
    pub ends: [f64; 2],
    /// Colours from one end to the other, evenly spaced.
    pub colours: Vec<[u8; 3]>,
}

/// A diverging scale from blue to orange, which colour-blind eyes can tell apart.
const CURVES: [Colour; 5] = [
    [0.09, 0.25, 0.53, 1.0],
    [0.42, 0.66, 0.84, 1.0],
    [0.93, 0.92, 0.89, 1.0],
    [0.94, 0.62, 0.27, 1.0],
    [0.62, 0.22, 0.05, 1.0],
];
/// The ink of contours.
const INK: f32 = 0.42;
/// The scale of curvatures covers this share of the surface.
const WITHIN: f64 = 0.96;
/// The most vertices that are sampled for the scale of curvatures.
const ASKED: usize = 4_000;
/// The scale of sizes covers at least this many doublings each way from the middle.
const LEAST: f64 = 0.35;
/// The most bars; and the least difference of the two principal curvatures for a bar, as a part of twice the greater
/// one.
const BARS: f64 = 1_100.0;
const DIFFER: f64 = 0.25;
/// Vertices and bodies in a slice.
const VERTICES: usize = 5_000;
const BODIES: usize = 12;

/// The view of a number on the surface, while it is made.
pub struct MapView {
    scene: Scene,
    quantity: Quantity,
    values: Vec<f64>,
    /// The steepest slope along the edges at each vertex, as shares of the scale in a unit of the scene.
    slopes: Vec<f32>,
    ends: Option<[f64; 2]>,
    bodies: usize,
    bars: Option<Spread>,
}

impl MapView {
    /// Starts the view. A map of curvature may have bars along the direction of least curvature.
    pub fn new(quantity: Quantity, has_bars: bool) -> Self {
        let has_bars = has_bars && quantity != Quantity::Size;
        Self {
            scene: Scene::default(),
            quantity,
            values: Vec::new(),
            slopes: Vec::new(),
            ends: None,
            bodies: 0,
            bars: has_bars.then(Spread::new),
        }
    }

    /// Does one more slice; true when done. Ground and fields must be the same each time, and belong to one mesh.
    pub fn advance(&mut self, ground: &BareSurface, fields: &SurfaceFields) -> bool {
        let mesh = fields.mesh().as_ref();
        let count = mesh.positions().len();
        if self.values.len() < count {
            self.ask(fields);
        } else if self.ends.is_none() {
            self.ends = Some(self.range());
            let ends = self.ends();
            let quantity = self.quantity;
            self.values
                .iter_mut()
                .for_each(|v| *v = share(quantity, ends, *v));
        } else if self.slopes.is_empty() {
            self.slopes = slopes(mesh, &self.values, ground.fit().scale);
        } else if self.bodies < ground.len() {
            let to = ground.len().min(self.bodies + BODIES);
            for part in self.bodies..to {
                let of = |v: u32, _: bool| coded(self.values[v as usize], self.slopes[v as usize]);
                let body = ground.body(part, (MAP, 0.0), of);
                push(&mut self.scene, body, 0);
            }
            self.bodies = to;
        } else if self.scatter(fields) {
            if self.scene.detail.is_none() {
                self.fill(ground, fields);
            }
            return true;
        }
        false
    }

    /// Does all the work at once.
    pub fn build(
        ground: &BareSurface,
        fields: &SurfaceFields,
        quantity: Quantity,
        has_bars: bool,
    ) -> Self {
        let mut view = Self::new(quantity, has_bars);
        while !view.advance(ground, fields) {}
        view
    }

    /// The finished scene.
    pub fn finish(self) -> Scene {
        self.scene
    }

    /// The meaning of the colours, once the scene is finished.
    pub fn legend(&self) -> Legend {
        let colour = |k: usize| {
            let [r, g, b] = colour_of(self.quantity, k as f32 / 16.0 - 1.0);
            [r, g, b].map(|v| (v + 0.5) as u8)
        };
        Legend {
            quantity: self.quantity,
            ends: self.ends(),
            colours: (0..=32).map(colour).collect(),
        }
    }

    fn ends(&self) -> [f64; 2] {
        self.ends.unwrap_or([-1.0, 1.0])
    }

    fn ask(&mut self, fields: &SurfaceFields) {
        let mesh = fields.mesh();
        let from = self.values.len();
        let to = mesh.positions().len().min(from + VERTICES);
        for v in from..to {
            let value = mesh
                .vertex_point(v as u32)
                .map_or(0.0, |p| self.value(fields, &p));
            self.values.push(value);
        }
    }

    fn value(&self, fields: &SurfaceFields, p: &SurfacePoint) -> f64 {
        if self.quantity == Quantity::Size {
            return fields.size(p);
        }
        let curvature = fields.curvature(p);
        let gauss = curvature.mean * curvature.mean - curvature.bend.length_squared();
        match self.quantity {
            Quantity::Gaussian => gauss.signum() * gauss.abs().sqrt(),
            _ => curvature.mean,
        }
    }

    /// The numbers at the ends of the scale.
    fn range(&self) -> [f64; 2] {
        if self.quantity == Quantity::Size {
            let each = || self.values.iter().copied();
            let (low, high) = (each().fold(f64::MAX, lesser), each().fold(0.0, greater));
            let middle = greater(low * high, f64::MIN_POSITIVE).sqrt();
            let reach = greater(0.5 * libm::log2(greater(high / low, 1.0)), LEAST);
            let factor = libm::exp2(reach);
            return [middle / factor, middle * factor];
        }
        let step = self.values.len().div_ceil(ASKED).max(1);
        let mut some: Vec<f64> = self.values.iter().step_by(step).map(|v| v.abs()).collect();
        order::sort(&mut some, |&v| (order::rank(v), 0));
        let last = some.len().saturating_sub(1);
        let most = some.get((WITHIN * last as f64) as usize).copied();
        let most = greater(most.unwrap_or(1.0), f64::MIN_POSITIVE);
        [-most, most]
    }

    /// Finds places for bars; true when they are found, or no bars are wanted.
    fn scatter(&mut self, fields: &SurfaceFields) -> bool {
        let mesh = fields.mesh().as_ref();
        let gap = (mesh.area() / BARS).sqrt().max(fields.mean_size());
        self.bars
            .as_mut()
            .is_none_or(|bars| bars.advance(mesh, |_| gap))
    }

    fn fill(&mut self, ground: &BareSurface, fields: &SurfaceFields) {
        let (fit, scene) = (ground.fit(), &mut self.scene);
        let gap = (fields.mesh().area() / BARS).sqrt().max(fields.mean_size());
        let mut tints = Vec::new();
        let body = scene.bodies.len() as u32;
        for p in self.bars.iter().flat_map(|bars| bars.places()) {
            let curvature = fields.curvature(p);
            let bend = curvature.bend.length();
            let part = bend / greater(curvature.mean.abs() + bend, f64::MIN_POSITIVE);
            // A nearly flat or evenly curved place has no direction.
            if part < DIFFER || bend * gap < 0.02 {
                continue;
            }
            let [_, (_, along)] = curvature.principal();
            tints.push([0.20, 0.18, 0.16]);
            let (frame, id) = (p.frame(), tints.len() as u32);
            let scale = gap * fit.scale * lesser(0.5 + part, 0.9);
            let axes = [frame.out(along), frame.normal];
            scene
                .instances
                .push(standing(body, id, fit.place(p.at), axes, scale));
        }
        if !tints.is_empty() {
            scene.bodies.push(star(2));
        }
        scene.reach = (0.5 * gap * fit.scale) as f32;
        scene.detail = Some(Box::new(Scale {
            quantity: self.quantity,
            tints,
        }));
    }
}

/// The place of a value on the scale, -1..1.
fn share(quantity: Quantity, [low, high]: [f64; 2], value: f64) -> f64 {
    let part = match quantity {
        Quantity::Size => libm::log2(value / low) / libm::log2(high / low),
        _ => (value - low) / (high - low),
    };
    (2.0 * part - 1.0).clamp(-1.0, 1.0)
}

/// For each vertex the steepest slope of shares around it, in the scene.
fn slopes(mesh: &TriMesh, shares: &[f64], scale: f64) -> Vec<f32> {
    let mut slopes = vec![0.0f32; shares.len()];
    for triangle in mesh.triangles() {
        for k in 0..3 {
            let [a, b] = [triangle[k], triangle[(k + 1) % 3]].map(|v| v as usize);
            let way = mesh.positions()[a].distance(mesh.positions()[b]) * scale;
            let slope = ((shares[a] - shares[b]).abs() / greater(way, 1e-9)) as f32;
            slopes[a] = greater(slopes[a], slope);
            slopes[b] = greater(slopes[b], slope);
        }
    }
    slopes
}

/// Steps of a coded share.
const FINE: f64 = 65_535.0;
/// The slope with code 255, and the codes in a doubling.
const STEEPEST: f32 = 4_096.0;
const DOUBLING: f32 = 14.0;

/// Codes a share and a slope as a colour. Interpolated colours give interpolated shares.
fn coded(share: f64, slope: f32) -> [u8; 3] {
    let steps = ((0.5 + 0.5 * share.clamp(-1.0, 1.0)) * FINE + 0.5) as u32;
    let doublings = libm::log2f(greater(slope, 1e-6) / STEEPEST);
    let code = 255.0 + DOUBLING * doublings;
    [
        (steps >> 8) as u8,
        steps as u8,
        code.clamp(0.0, 255.0) as u8,
    ]
}

/// Decodes the share and the slope.
fn decoded([high, low, code]: [f32; 3]) -> [f32; 2] {
    let share = (256.0 * high + low) / FINE as f32 * 2.0 - 1.0;
    [share, STEEPEST * libm::exp2f((code - 255.0) / DOUBLING)]
}

/// The colour of a share, each part 0..255.
fn colour_of(quantity: Quantity, share: f32) -> [f32; 3] {
    let share = share.clamp(-1.0, 1.0);
    let [r, g, b, _] = match quantity {
        Quantity::Size => {
            let [r, g, b, alpha] = heat(share);
            // Blended as over paper.
            blend(SHEET.bed, [r, g, b, 1.0], 0.14 + alpha)
        }
        _ => {
            let at = 2.0 * (share + 1.0);
            let first = (at as usize).min(3);
            blend(CURVES[first], CURVES[first + 1], at - first as f32)
        }
    };
    [r, g, b].map(|v| 255.0 * v)
}

/// Turns shares into colours.
struct Scale {
    quantity: Quantity,
    tints: Vec<[f32; 3]>,
}

impl Detail for Scale {
    fn refine(&self, surfel: &mut Surfel, id: u32, spread: f32) {
        if id > 0 {
            tint(&self.tints, surfel, id);
            return;
        }
        let [share, slope] = decoded(surfel.colour);
        surfel.colour = colour_of(self.quantity, share);
        if self.quantity != Quantity::Size {
            return;
        }
        let pixel = CONTOURS * slope * spread;
        // Contours that would touch each other are not drawn.
        let clear = (1.5 - 3.0 * pixel).clamp(0.0, 1.0);
        let dark = INK * contour(share, greater(pixel, 1e-6)) * clear;
        surfel.colour = surfel.colour.map(|v| v * (1.0 - dark));
    }
}
