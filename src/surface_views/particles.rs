//! The view of packed cells as bubbles, while they move.

use super::domes::Dome;
use super::paint::Tints;
use super::{BARE, BareSurface, GLOSS, standing};
use crate::draw::stages::stressed;
use crate::draw::{Colour, Tones, blend, lit};
use crate::field::CellKind;
use crate::packing::{BEYOND, Stress, stress_on};
use crate::scene::{Body, Scene};
use crate::surface_packing::{PackingMesh, SurfaceParticle};
use crate::surface_stones::Fit;
use glam::{DVec2, DVec3};

/// Stretched cells have bodies for aspect ratios from 1 to this one, ...
const LONGEST: f64 = 5.0;
/// ... in this many steps.
const STEPS: u32 = 24;
/// The factor on the drawn size, so that neighbours at rest can be told apart.
const SHRUNK: f64 = 0.975;
/// A bubble's height, its depth below the surface, and the radius of its corners, in half widths.
const HIGH: f64 = 0.58;
const DEEP: f64 = 0.34;
const ROUND: f64 = 0.36;
/// The share of a light colour that is mixed in: bubbles are lighter than the stones to come.
const PALE: f32 = 0.5;
const LIGHT: Colour = [0.93, 0.90, 0.84, 1.0];
/// The colour of the surface below the bubbles.
const UNDER: [u8; 3] = [126, 120, 112];
/// The angle of rims, in radians.
const RIM: f64 = 1.32;
/// The brightness of rims, and of cells that are fixed on a border.
const DARK: f64 = 0.66;
const FIXED: f32 = 0.82;

/// All kinds, in the order of their bodies.
const KINDS: [CellKind; 4] = [
    CellKind::Square,
    CellKind::Rectangle,
    CellKind::Circle,
    CellKind::Ellipse,
];

/// A scene of packed cells that is updated as they move: bodies stay, and only their places change.
pub struct Particles {
    scene: Scene,
    fit: Fit,
    /// How many bodies, and instances, belong to the ground.
    ground: usize,
    /// For each kind the index of its first body.
    first: [Option<u32>; 4],
}

/// The scene of cells at one time, in the tones of the stones to come.
pub fn particles(
    ground: &BareSurface,
    site: &PackingMesh,
    cells: &[SurfaceParticle],
    tones: &Tones,
) -> Scene {
    let mut view = Particles::new(ground);
    view.update(site, cells, tones);
    view.finish()
}

impl Particles {
    /// Starts with the ground alone.
    pub fn new(ground: &BareSurface) -> Self {
        let mut scene = Scene::default();
        ground.add_to(&mut scene, BARE, 0.0, UNDER);
        Self {
            scene,
            fit: ground.fit(),
            ground: ground.len(),
            first: [None; 4],
        }
    }

    /// Shows these cells, which lie on `site`: in their shapes, warm where they are pressed, cool where they have
    /// room. The id of a cell in frames is its index plus 1.
    pub fn update(&mut self, site: &PackingMesh, cells: &[SurfaceParticle], tones: &Tones) {
        self.make_bodies(cells);
        let scene = &mut self.scene;
        scene.instances.truncate(self.ground);
        let stress = stress(site, cells);
        let (mut tints, mut sizes) = (Vec::with_capacity(cells.len()), 0.0);
        for ((cell, stress), id) in cells.iter().zip(stress).zip(1..) {
            let own = blend(tones.stone(cell.id), LIGHT, PALE);
            let own = lit(own, if cell.fixed { FIXED } else { 1.0 });
            let [r, g, b, _] = stressed(own, stress);
            tints.push([r, g, b]);
            sizes += cell.size;
            let first = self.first[place_of(cell.kind)].unwrap_or_default();
            let frame = cell.centre.frame();
            let along = frame.out(cell.axis.normalize_or(DVec2::X));
            let scale = SHRUNK * cell.size * self.fit.scale;
            let at = self.fit.place(cell.centre.at);
            let axes = [along, frame.normal];
            scene
                .instances
                .push(standing(first + step_of(cell), id, at, axes, scale));
        }
        let mean = sizes / cells.len().max(1) as f64;
        scene.reach = (0.5 * mean * self.fit.scale) as f32;
        scene.detail = Some(Box::new(Tints(tints)));
    }

    /// Makes the bodies of all kinds that occur, in a fixed order.
    fn make_bodies(&mut self, cells: &[SurfaceParticle]) {
        let is_there = KINDS.map(|kind| cells.iter().any(|c| c.kind == kind));
        if self.first.map(|first| first.is_some()) == is_there {
            return;
        }
        let bodies = &mut self.scene.bodies;
        bodies.truncate(self.ground);
        for (k, kind) in KINDS.into_iter().enumerate() {
            self.first[k] = is_there[k].then_some(bodies.len() as u32);
            if is_there[k] {
                let steps = if kind.is_stretched() { STEPS } else { 0 };
                bodies.extend((0..=steps).map(|step| bubble(kind, step)));
            }
        }
    }

    /// The current scene.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The scene, to keep.
    pub fn finish(self) -> Scene {
        self.scene
    }
}

/// The stress on each cell.
pub(super) fn stress(site: &PackingMesh, cells: &[SurfaceParticle]) -> Vec<Stress> {
    // For each cell two vectors, with which dot products measure a way in the cell's own metric: a half axis is half a
    // size long.
    let axes = |cell: &SurfaceParticle| {
        let (frame, (e, f)) = (cell.centre.frame(), cell.half_axes());
        let axis = |v: DVec2| frame.out(v) * (0.5 * cell.size / v.length_squared());
        [axis(e), axis(f)]
    };
    let axes: Vec<[DVec3; 2]> = cells.iter().map(axes).collect();
    let may_meet = |k: usize, j: usize| {
        let way = cells[j].centre.at - cells[k].centre.at;
        let far = BEYOND * 0.5 * (cells[k].size + cells[j].size);
        let is_near = |[e, f]: [DVec3; 2]| {
            let [x, y] = [e.dot(way), f.dot(way)];
            x * x + y * y < far * far
        };
        is_near(axes[k]) || is_near(axes[j])
    };
    let mesh = site.mesh();
    stress_on(site, cells, may_meet, |p, by| !mesh.walk(&p, by).slid)
}

fn place_of(kind: CellKind) -> usize {
    KINDS.iter().position(|&k| k == kind).unwrap_or_default()
}

/// The index of a cell's body among the bodies of its kind, which are more and more stretched.
fn step_of(cell: &SurfaceParticle) -> u32 {
    if !cell.kind.is_stretched() || cell.axis == DVec2::ZERO {
        return 0;
    }
    let part = libm::log(cell.aspect) / libm::log(LONGEST);
    (f64::from(STEPS) * part.clamp(0.0, 1.0) + 0.5) as u32
}

/// The body of a cell of size 1.
fn bubble(kind: CellKind, step: u32) -> Body {
    let root = libm::pow(LONGEST, 0.5 * f64::from(step) / f64::from(STEPS));
    let half = DVec2::new(0.5 * root, 0.5 / root);
    let dome = Dome {
        half,
        round: kind.has_corners().then_some(ROUND * half.y),
        high: HIGH * half.y,
        deep: DEEP * half.y,
        rim: RIM,
        dark: DARK,
    };
    dome.body(GLOSS)
}
