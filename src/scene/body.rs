//! The contents of a scene: bodies, and where they stand.

use crate::order::{greater, lesser};
use crate::scene::Detail;
use crate::solid::Surface;
use glam::Vec3;
use std::rc::Rc;

/// A solid at several levels of detail.
#[derive(Clone, Debug, Default)]
pub struct Body {
    /// The surfaces from the finest level of detail to the coarsest, at least one: right-handed, y up, triangles
    /// counter-clockwise seen from outside. Copies of the body share the list.
    pub levels: Rc<[Surface]>,
    /// Row of the table of materials.
    pub material: u8,
    /// The centre of its bounding box.
    pub middle: Vec3,
    /// Largest distance of a vertex from the centre.
    pub radius: f32,
    /// The mean colour of the vertices (sRGB): for the dot that is drawn if the body is smaller than a pixel, and for
    /// cut faces.
    pub colour: [u8; 3],
    /// The smallest y of its vertices.
    pub lowest: f32,
}

impl Body {
    /// A body with these levels of detail, the finest first. Their surfaces must have no faults ([`Surface::fault`]).
    pub fn new(levels: Vec<Surface>, material: u8) -> Self {
        let finest = levels.first();
        let points = finest.map_or(&[][..], |surface| &surface.positions);
        let (mut low, mut high) = (Vec3::MAX, Vec3::MIN);
        for &p in points {
            (low, high) = (low.min(p), high.max(p));
        }
        let middle = match points {
            [] => Vec3::ZERO,
            _ => (low + high) * 0.5,
        };
        let far = points
            .iter()
            .fold(0.0, |far, p| greater(far, (*p - middle).length_squared()));
        Self {
            material,
            middle,
            radius: far.sqrt(),
            lowest: low.y,
            colour: finest.map_or([128; 3], |surface| mean(&surface.colours)),
            levels: levels.into(),
        }
    }
}

fn mean(colours: &[[u8; 3]]) -> [u8; 3] {
    let count = colours.len().max(1) as u64;
    std::array::from_fn(|k| {
        let sum: u64 = colours.iter().map(|colour| u64::from(colour[k])).sum();
        (sum / count) as u8
    })
}

/// The placement of a body: rotated, uniformly scaled, moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The body's axes in the world: orthogonal, of one length, right-handed.
    pub axes: [Vec3; 3],
    /// The body's origin in the world.
    pub origin: Vec3,
}

impl Default for Place {
    fn default() -> Self {
        Self {
            axes: [Vec3::X, Vec3::Y, Vec3::Z],
            origin: Vec3::ZERO,
        }
    }
}

impl Place {
    /// Neither rotated nor scaled.
    pub fn at(origin: Vec3) -> Self {
        Self {
            origin,
            ..Self::default()
        }
    }

    /// Maps a point of the body into the world.
    #[inline(always)]
    pub fn of(&self, p: Vec3) -> Vec3 {
        self.origin + self.turned(p)
    }

    /// Maps a direction of the body into the world; its length is scaled, too.
    #[inline(always)]
    pub fn turned(&self, v: Vec3) -> Vec3 {
        self.axes[0] * v.x + self.axes[1] * v.y + self.axes[2] * v.z
    }

    /// The scale factor.
    pub fn scale(&self) -> f32 {
        self.axes[0].length()
    }
}

/// Colour and material of one instance: the tint multiplies the body's colours, the material replaces the body's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Paint {
    /// Multiplies the mesh's colours (sRGB, 255 is one): a white mesh gets this colour.
    pub tint: [u8; 3],
    /// Row of the table of materials.
    pub material: u8,
}

impl Paint {
    /// Applies the tint to a colour of the mesh (sRGB, 0..255).
    pub(crate) fn over(self, colour: [f32; 3]) -> [f32; 3] {
        std::array::from_fn(|k| colour[k] * f32::from(self.tint[k]) / 255.0)
    }
}

/// A body in its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instance {
    /// Index in the list of bodies.
    pub body: u32,
    /// Where it stands.
    pub place: Place,
    /// Its id in the plane of ids; 0 is the background or the ground.
    pub id: u32,
    /// Its own colour and material; `None` leaves those of the mesh.
    pub paint: Option<Paint>,
}

/// Everything to be drawn: bodies, their placements, surface details and lines.
#[derive(Default)]
pub struct Scene {
    /// The distinct bodies; each may have many instances.
    pub bodies: Vec<Body>,
    /// The placements of the bodies.
    pub instances: Vec<Instance>,
    /// Surface details beyond the triangles, if any.
    pub detail: Option<Box<dyn Detail>>,
    /// Lines over the surfaces, such as the edges of a control mesh.
    pub lines: Vec<[Vec3; 2]>,
    /// Within this distance, in the world, surfaces occlude each other (ambient occlusion): about half of a body.
    pub reach: f32,
}

impl Scene {
    /// The first fault, if any: of a surface, or of an instance without a body or with an invalid placement.
    pub fn fault(&self) -> Option<String> {
        let surfaces = self.bodies.iter().flat_map(|body| body.levels.iter());
        let mut faults = surfaces.filter_map(Surface::fault);
        faults.next().or_else(|| {
            let is_bad = |instance: &Instance| {
                let body = self.bodies.get(instance.body as usize);
                let (place, has_surface) = (&instance.place, |body: &Body| !body.levels.is_empty());
                let numbers = [place.axes[0], place.axes[1], place.axes[2], place.origin];
                let is_good = |v: &Vec3| v.abs().max_element() <= Surface::LARGEST && v.is_finite();
                !body.is_some_and(has_surface) || !numbers.iter().all(is_good)
            };
            let bad = self.instances.iter().position(is_bad)?;
            Some(format!("body {bad} has no surface, or no valid place"))
        })
    }

    /// The centre and the radius of a ball around all bodies.
    pub fn ball(&self) -> (Vec3, f32) {
        let balls = || self.instances.iter().map(|instance| self.ball_of(instance));
        let (mut low, mut high) = (Vec3::MAX, Vec3::MIN);
        for (middle, radius) in balls() {
            low = low.min(middle - Vec3::splat(radius));
            high = high.max(middle + Vec3::splat(radius));
        }
        if self.instances.is_empty() {
            return (Vec3::ZERO, 0.0);
        }
        let middle = (low + high) * 0.5;
        let radius = balls().fold(0.0, |most, (at, radius)| {
            greater(most, (at - middle).length() + radius)
        });
        (middle, radius)
    }

    /// The ball around an instance.
    #[inline(always)]
    pub fn ball_of(&self, instance: &Instance) -> (Vec3, f32) {
        let body = &self.bodies[instance.body as usize];
        let place = &instance.place;
        (place.of(body.middle), body.radius * place.scale())
    }

    /// The lowest y of all bodies; 0 if there are none.
    pub fn lowest(&self) -> f32 {
        let all = self.instances.iter();
        let low = all.fold(f32::MAX, |low, i| lesser(low, self.lowest_of(i, low).0));
        if low == f32::MAX { 0.0 } else { low }
    }

    /// The lowest y of an instance, and the number of vertices inspected. If the instance lies wholly above the height
    /// `below`, the y may be `f32::MAX`.
    pub(super) fn lowest_of(&self, instance: &Instance, below: f32) -> (f32, usize) {
        let (body, place) = (&self.bodies[instance.body as usize], &instance.place);
        // Turned about y at most: this is bit for bit the minimum over all points, as rounding preserves their order.
        if place.axes.map(|axis| axis.y) == [0.0, 1.0, 0.0] {
            return (place.origin.y + body.lowest, 1);
        }
        if self.is_above(instance, below) {
            return (f32::MAX, 1);
        }
        let points = body.levels.first().map_or(&[][..], |l| &l.positions);
        let heights = points.iter().map(|&p| place.of(p).y);
        (heights.fold(f32::MAX, lesser), points.len())
    }

    /// Whether the ball around an instance certainly lies above this height, with a margin for rounding.
    fn is_above(&self, instance: &Instance, height: f32) -> bool {
        let (middle, radius) = self.ball_of(instance);
        let body = &self.bodies[instance.body as usize];
        let size = radius + instance.place.scale() * body.middle.length();
        let slack = 1e-3 * size + 1e-5 * instance.place.origin.y.abs();
        middle.y - radius - slack > height
    }
}
