//! The view of directions: bars on the surface, and singular points.

use super::bars::{star, tube};
use super::domes::ball;
use super::ground::push;
use super::paint::Tints;
use super::spread::Spread;
use super::{BARE, BareSurface, CALM, SATIN, Tally, standing};
use crate::draw::field::{AGAINST, CROSS, STROKE, WITH};
use crate::draw::size::{LARGE, SMALL};
use crate::draw::{Colour, blend};
use crate::order::{greater, lesser};
use crate::scene::Scene;
use crate::surface_field::{Stroke, SurfaceFields, SurfaceSingularity};
use crate::surface_stones::Fit;
use crate::trimesh::SurfacePoint;
use glam::DVec2;

/// The most bars.
const MOST: f64 = 3_000.0;
/// The radius of a singular point's ball, in mean distances between bars; and the bounds of that radius in the scene.
const BALL: f64 = 0.36;
const BALLS: (f64, f64) = (0.006, 0.013);
/// The radius of a stroke, relative to the radius of a singular point's ball.
const TUBE: f64 = 0.4;
/// Sizes count as equal if the largest exceeds the smallest by no more than this factor.
const SAME: f64 = 1.02;
/// The colour of the middle size. The usual colour, `CROSS`, would not stand out from the ground.
const MIDDLE: Colour = [0.80, 0.56, 0.10, 1.0];
/// Triangles in a slice.
const TRIANGLES: usize = 6_000;

/// The view of a direction field, while it is made.
pub struct FieldView {
    scene: Scene,
    strokes: Vec<Stroke>,
    spread: Spread,
    /// The distance between bars, relative to that between cells.
    factor: f64,
    searched: usize,
    singular: Vec<SurfaceSingularity>,
    tally: Option<Tally>,
}

impl FieldView {
    /// Starts the view of fields, with the strokes that shape them.
    pub fn new(fields: &SurfaceFields, strokes: &[Stroke]) -> Self {
        Self {
            scene: Scene::default(),
            strokes: strokes.to_vec(),
            spread: Spread::new(),
            factor: greater(fields.about_cells() / MOST, 1.0).sqrt(),
            searched: 0,
            singular: Vec::new(),
            tally: None,
        }
    }

    /// Does one more slice; true when done. Ground and fields must be the same each time.
    pub fn advance(&mut self, ground: &BareSurface, fields: &SurfaceFields) -> bool {
        let mesh = fields.mesh().as_ref();
        let count = mesh.triangles().len();
        let gap = |p: &SurfacePoint| self.factor * fields.size(p);
        if self.scene.bodies.is_empty() {
            ground.add_to(&mut self.scene, BARE, 0.0, CALM);
        } else if self.searched < count {
            let to = count.min(self.searched + TRIANGLES);
            self.singular
                .extend(fields.singular_among(self.searched..to));
            self.searched = to;
        } else if self.tally.is_none() {
            self.tally = Some(Tally::of(fields, &self.singular));
        } else if self.spread.advance(mesh, gap) {
            if self.scene.detail.is_none() {
                self.fill(&ground.fit(), fields);
            }
            return true;
        }
        false
    }

    /// Does all the work at once.
    pub fn build(ground: &BareSurface, fields: &SurfaceFields, strokes: &[Stroke]) -> Self {
        let mut view = Self::new(fields, strokes);
        while !view.advance(ground, fields) {}
        view
    }

    /// The counts of singular points; complete when the view is.
    pub fn tally(&self) -> Tally {
        self.tally.unwrap_or_default()
    }

    /// The finished scene.
    pub fn finish(self) -> Scene {
        self.scene
    }

    fn fill(&mut self, fit: &Fit, fields: &SurfaceFields) {
        let scene = &mut self.scene;
        let star_of = scene.bodies.len() as u32;
        scene.bodies.push(star(fields.symmetry()));
        let mut tints = Vec::new();
        let heat = Heat::new(fields);
        for p in self.spread.places() {
            let axis = fields.axis(p);
            if axis == DVec2::ZERO {
                continue;
            }
            let size = fields.size(p);
            tints.push(rgb(heat.colour(size)));
            let (frame, scale) = (p.frame(), self.factor * size * fit.scale);
            let axes = [frame.out(axis), frame.normal];
            let id = tints.len() as u32;
            scene
                .instances
                .push(standing(star_of, id, fit.place(p.at), axes, scale));
        }
        let mean = self.factor * fields.mean_size() * fit.scale;
        let radius = (BALL * mean).clamp(BALLS.0, BALLS.1);
        if !self.singular.is_empty() {
            let ball_of = scene.bodies.len() as u32;
            scene.bodies.push(ball(1.0, SATIN));
            for point in &self.singular {
                let colour = if point.turns > 0 { WITH } else { AGAINST };
                tints.push(rgb(colour));
                let scale = radius * f64::from(point.turns.abs()).sqrt();
                let (frame, id) = (point.at.frame(), tints.len() as u32);
                let axes = [frame.x, frame.normal];
                let at = fit.place(point.at.at + frame.normal * (0.35 * scale / fit.scale));
                scene.instances.push(standing(ball_of, id, at, axes, scale));
            }
        }
        for stroke in &self.strokes {
            if let Some(tube) = tube(&stroke.points, TUBE * radius, fit) {
                tints.push(rgb(STROKE));
                push(scene, tube, tints.len() as u32);
            }
        }
        scene.reach = (0.5 * mean) as f32;
        scene.detail = Some(Box::new(Tints(tints)));
    }
}

/// The colours of sizes.
struct Heat {
    middle: f64,
    /// Doublings from the middle size to either end; 0 if all sizes are equal.
    reach: f64,
}

impl Heat {
    fn new(fields: &SurfaceFields) -> Self {
        let (low, high) = fields.size_range();
        let reach = if high > SAME * low {
            0.5 * libm::log2(high / low)
        } else {
            0.0
        };
        Self {
            middle: (low * high).sqrt(),
            reach,
        }
    }

    fn colour(&self, size: f64) -> Colour {
        if self.reach == 0.0 {
            return CROSS;
        }
        let off = (libm::log2(size / self.middle) / self.reach) as f32;
        blend(
            MIDDLE,
            if off < 0.0 { SMALL } else { LARGE },
            lesser(off.abs(), 1.0),
        )
    }
}

fn rgb([r, g, b, _]: Colour) -> [f32; 3] {
    [r, g, b]
}
