//! What a scene is made of: bodies, and where they stand.

use crate::notice::{Code, Notice};
use crate::order::{greater, lesser};
use crate::scene::Detail;
use crate::solid::Surface;
use glam::Vec3;

/// Something solid, at several degrees of detail.
#[derive(Clone, Debug, Default)]
pub struct Body {
    /// Its surface from the finest to the coarsest, at least one; right-handed, y up, triangles
    /// counter-clockwise seen from outside.
    pub levels: Vec<Surface>,
    /// Row of the table of materials.
    pub material: u8,
    /// The middle of the box around it.
    pub middle: Vec3,
    /// No vertex is farther from the middle.
    pub radius: f32,
    /// Seen at less than a pixel it is a dot of this colour.
    pub colour: [u8; 3],
    /// No vertex has a smaller y.
    pub lowest: f32,
}

impl Body {
    /// A body of surfaces without faults ([`Surface::fault`]), of this material.
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
            levels,
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

/// Where a body stands: turned, scaled alike in all directions, moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Where the body's axes point to: orthogonal, of one length, right-handed.
    pub axes: [Vec3; 3],
    /// Where the body's origin is.
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
    /// Not turned, not scaled.
    pub fn at(origin: Vec3) -> Self {
        Self {
            origin,
            ..Self::default()
        }
    }

    /// A point of the body, in the world.
    #[inline(always)]
    pub fn of(&self, p: Vec3) -> Vec3 {
        self.origin + self.turned(p)
    }

    /// A direction of the body, in the world; as long as the axes make it.
    #[inline(always)]
    pub fn turned(&self, v: Vec3) -> Vec3 {
        self.axes[0] * v.x + self.axes[1] * v.y + self.axes[2] * v.z
    }

    /// How many times as large the body is.
    pub fn scale(&self) -> f32 {
        self.axes[0].length()
    }
}

/// A body in its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instance {
    /// Its place in the list of bodies.
    pub body: u32,
    /// Where it stands.
    pub place: Place,
    /// What it is called in the plane of ids; 0 is nothing, or the ground.
    pub id: u32,
}

/// All that is seen.
#[derive(Default)]
pub struct Scene {
    /// Each once, however many there are of it.
    pub bodies: Vec<Body>,
    /// Where they stand.
    pub instances: Vec<Instance>,
    /// What surfaces have beyond their triangles; none where those are all.
    pub detail: Option<Box<dyn Detail>>,
    /// Lines over the surfaces, such as the edges of a control mesh.
    pub lines: Vec<[Vec3; 2]>,
    /// How far light is held off by what is near, in the world: about half of a body.
    pub reach: f32,
}

impl Scene {
    /// What is wrong with it, if anything is: with a surface, or an instance that has no body or no place.
    pub fn fault(&self) -> Option<Notice> {
        let surfaces = self.bodies.iter().flat_map(|body| &body.levels);
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
            let why = Notice::new(Code::SurfaceMissing).with("n", bad);
            Some(Notice::new(Code::SurfaceFault).with("why", why))
        })
    }

    /// The middle and the radius of a ball with all bodies in it.
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

    /// Where the ball around a body is.
    #[inline(always)]
    pub fn ball_of(&self, instance: &Instance) -> (Vec3, f32) {
        let body = &self.bodies[instance.body as usize];
        let place = &instance.place;
        (place.of(body.middle), body.radius * place.scale())
    }

    /// The lowest point of all bodies; 0 where there are none.
    pub fn lowest(&self) -> f32 {
        let heights = self.instances.iter().map(|i| self.lowest_of(i).0);
        let low = heights.fold(f32::MAX, lesser);
        if low == f32::MAX { 0.0 } else { low }
    }

    /// The lowest point of a body, and how many there were to look at.
    pub(super) fn lowest_of(&self, instance: &Instance) -> (f32, usize) {
        let (body, place) = (&self.bodies[instance.body as usize], &instance.place);
        // To the bit what all points would give: rounding keeps their order.
        if place.axes.map(|axis| axis.y) == [0.0, 1.0, 0.0] {
            return (place.origin.y + body.lowest, 1);
        }
        let points = body.levels.first().map_or(&[][..], |l| &l.positions);
        let heights = points.iter().map(|&p| place.of(p).y);
        (heights.fold(f32::MAX, lesser), points.len())
    }
}
