//! One picture of a scene, in slices: what is seen, how much of the sky each place sees, and its light.

use super::backdrop::{FLOOR_COLOUR, behind, floor_part};
use super::met::Met;
use super::occlusion::Occlusion;
use super::sight::{FLOOR, NOTHING, Sight};
use super::{Backdrop, Camera, Lighting, Scene, Surfel, lines};
use crate::hash::Hash;
use crate::order::lesser;
use glam::Vec3;
use std::ops::Range;

/// Pixels that are shaded with about the work of one triangle that is drawn: their inverse.
const PIXEL_WORK: usize = 1;
/// Where the samples of a pixel lie, from its middle.
const SAMPLES: [[f32; 2]; 4] = [[-0.25, -0.25], [0.25, -0.25], [-0.25, 0.25], [0.25, 0.25]];

/// What frame is wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Order {
    /// Where it is seen from.
    pub camera: Camera,
    /// Width and height in pixels, 1 to 8192.
    pub size: [usize; 2],
    /// Each pixel is the mean of two by two samples, or there is one.
    pub is_fine: bool,
    /// Something moves: bodies are a level coarser, and there is no occlusion.
    pub is_moving: bool,
    /// What is behind the bodies.
    pub backdrop: Backdrop,
}

/// A frame in the making.
pub struct Frame {
    order: Order,
    sight: Sight,
    occlusion: Occlusion,
    /// By pixel: the normal of the triangles there; zero in the end where none is.
    normals: Vec<Vec3>,
    phase: Phase,
    sample: usize,
    /// Sums over samples of red, green, blue and alpha.
    sums: Vec<[u16; 4]>,
    rgba: Vec<u8>,
    /// Middle and radius of the ball around all bodies, and the floor's height.
    ground: ((Vec3, f32), f32),
}

/// What comes next; instances, rows or lines that are done.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Phase {
    Ground(usize),
    Room(usize),
    Sight,
    Normals(usize),
    Occlusion,
    Shade(usize),
    Lines(usize),
    Sum(usize),
    Planes(usize),
    Done,
}

impl Frame {
    /// Bytes that a frame has for each pixel, at most.
    pub const BYTES: usize = 38;

    /// A frame to be made.
    pub fn new(order: Order) -> Self {
        let view = order.camera.view(order.size[0], order.size[1]);
        let mut frame = Self {
            sight: Sight::new(view),
            occlusion: Occlusion::new(),
            normals: Vec::new(),
            phase: Phase::Ground(0),
            sample: 0,
            sums: Vec::new(),
            rgba: Vec::new(),
            ground: ((Vec3::ZERO, 0.0), 0.0),
            order,
        };
        frame.begin(order);
        frame
    }

    /// Begins another frame in the same memory.
    pub fn begin(&mut self, order: Order) {
        self.order = order;
        self.phase = Phase::Ground(0);
        self.sample = 0;
        self.ground = ((Vec3::ZERO, 0.0), 0.0);
        let pixels = order.size[0] * order.size[1];
        self.sums.clear();
        self.sums
            .reserve_exact(if order.is_fine { pixels } else { 0 });
        self.rgba.clear();
        self.rgba.reserve_exact(4 * pixels);
    }

    /// What frame it is.
    pub fn order(&self) -> &Order {
        &self.order
    }

    /// Is it finished?
    pub fn is_done(&self) -> bool {
        self.phase == Phase::Done
    }

    /// How much of it is done, 0..1, by a rough estimate.
    pub fn progress(&self) -> f64 {
        let rows = self.order.size[1] as f64;
        let part = match self.phase {
            Phase::Ground(_) | Phase::Room(_) => 0.0,
            Phase::Sight => 0.3 * self.sight.progress(),
            Phase::Normals(row) => 0.3 + 0.1 * row as f64 / rows,
            Phase::Occlusion => 0.4,
            Phase::Shade(row) => 0.6 + 0.35 * row as f64 / rows,
            Phase::Lines(_) | Phase::Sum(_) | Phase::Planes(_) => 0.95,
            Phase::Done => return 1.0,
        };
        (self.sample as f64 + part) / self.samples() as f64
    }

    fn samples(&self) -> usize {
        if self.order.is_fine { SAMPLES.len() } else { 1 }
    }

    /// Goes on for about the work of so many triangles, or of as many pixels; true when it is done. Scene and light must be the same
    /// from the first call to the last; the light must be ready.
    pub fn advance(&mut self, scene: &Scene, light: &Lighting, amount: usize) -> bool {
        let [width, height] = self.order.size;
        let rows = (amount / (PIXEL_WORK * width)).clamp(1, height);
        self.phase = match self.phase {
            Phase::Ground(place) => self.find_ground(scene, place, amount),
            Phase::Room(row) => self.make_room(height.min(row.saturating_add(8 * rows))),
            Phase::Sight => match self.sight.advance(scene, amount) {
                true => Phase::Normals(0),
                false => Phase::Sight,
            },
            Phase::Normals(row) => {
                let end = height.min(row.saturating_add(2 * rows));
                (row..end).for_each(|y| self.find_normals(scene, y));
                match end == height {
                    true if self.order.is_moving => Phase::Shade(0),
                    true => Phase::Occlusion,
                    false => Phase::Normals(end),
                }
            }
            Phase::Occlusion => {
                let (sight, normals) = (&self.sight, &self.normals);
                match self.occlusion.advance(sight, normals, scene.reach, rows) {
                    true => Phase::Shade(0),
                    false => Phase::Occlusion,
                }
            }
            Phase::Shade(row) => {
                let end = height.min(row.saturating_add(rows));
                (row..end).for_each(|y| self.shade(scene, light, y));
                match end == height {
                    true => Phase::Lines(0),
                    false => Phase::Shade(end),
                }
            }
            Phase::Lines(line) => {
                let (sight, rgba) = (&self.sight, &mut self.rgba);
                match lines::draw(sight, &scene.lines, line, amount, rgba) {
                    next if next < scene.lines.len() => Phase::Lines(next),
                    _ if self.order.is_fine => Phase::Sum(0),
                    _ => Phase::Planes(0),
                }
            }
            Phase::Sum(row) => self.sum(row, height.min(row.saturating_add(4 * rows))),
            Phase::Planes(row) => {
                let end = height.min(row.saturating_add(4 * rows));
                self.make_planes(scene, row * width..end * width);
                match end == height {
                    true => Phase::Done,
                    false => Phase::Planes(end),
                }
            }
            Phase::Done => Phase::Done,
        };
        self.is_done()
    }

    /// Finds out where bodies end, before the first sample.
    fn find_ground(&mut self, scene: &Scene, from: usize, amount: usize) -> Phase {
        if self.order.backdrop == Backdrop::Floor {
            if from == 0 {
                self.ground = (scene.ball(), f32::MAX);
            }
            let (mut at, mut work) = (from, 0);
            while at < scene.instances.len() && work < amount {
                let (low, points) = scene.lowest_of(&scene.instances[at]);
                self.ground.1 = lesser(self.ground.1, low);
                (at, work) = (at + 1, work + 1 + points / 8);
            }
            if at < scene.instances.len() {
                return Phase::Ground(at);
            }
            if at == 0 {
                self.ground.1 = 0.0;
            }
        }
        self.begin_sample();
        Phase::Room(0)
    }

    fn begin_sample(&mut self) {
        let [width, height] = self.order.size;
        let view = self.order.camera.view(width, height);
        let view = match self.order.is_fine {
            true => view.moved(SAMPLES[self.sample]),
            false => view,
        };
        self.sight.begin(view, self.order.is_moving);
        self.occlusion.begin(width * height);
        self.normals.clear();
        self.normals.reserve_exact(width * height);
    }

    /// Makes room for rows.
    fn make_room(&mut self, to: usize) -> Phase {
        let [width, height] = self.order.size;
        let pixels = to * width;
        self.sight.make_room(pixels);
        self.occlusion.make_room(pixels);
        self.normals.resize(pixels, Vec3::ZERO);
        if self.sample == 0 {
            self.rgba.resize(4 * pixels, 0);
            if self.order.is_fine {
                self.sums.resize(pixels, [0; 4]);
            }
        }
        match to == height {
            true => Phase::Sight,
            false => Phase::Room(to),
        }
    }

    /// Finds the normals of a row, and where the floor is seen.
    fn find_normals(&mut self, scene: &Scene, y: usize) {
        let view = *self.sight.view();
        let width = view.size[0];
        let has_floor = self.order.backdrop == Backdrop::Floor;
        let ((middle, radius), floor) = self.ground;
        for x in 0..width {
            let at = y * width + x;
            let ray = view.ray(x as f32 + 0.5, y as f32 + 0.5);
            if self.sight.owner[at] == NOTHING {
                let depth = (floor - view.eye.y) / ray.y;
                let met = view.eye + ray * depth;
                let is_near = || floor_part((met - middle).length(), radius) > 0.0;
                // Seen from below there is no floor.
                if has_floor && ray.y < 0.0 && depth > view.near && is_near() {
                    self.sight.owner[at] = FLOOR;
                    self.sight.inverse[at] = 1.0 / depth;
                    self.normals[at] = Vec3::Y;
                }
                continue;
            }
            self.normals[at] = Met::new(&self.sight, scene, at, ray).normal;
        }
    }

    fn shade(&mut self, scene: &Scene, light: &Lighting, y: usize) {
        let view = *self.sight.view();
        let width = view.size[0];
        let ((middle, radius), _) = self.ground;
        for x in 0..width {
            let at = y * width + x;
            let ray = view.ray(x as f32 + 0.5, y as f32 + 0.5);
            let way = ray.normalize_or(Vec3::NEG_Y);
            let owner = self.sight.owner[at];
            let pixel = &mut self.rgba[4 * at..][..4];
            if owner == NOTHING {
                let colour = behind(self.order.backdrop, way);
                for k in 0..3 {
                    pixel[k] = (colour[k] + 0.5) as u8;
                }
                pixel[3] = if self.order.backdrop == Backdrop::Nothing {
                    0
                } else {
                    255
                };
                continue;
            }
            let depth = 1.0 / self.sight.inverse[at];
            let position = view.eye + ray * depth;
            let open = f32::from(self.occlusion.open[at]) * (1.0 / 255.0);
            let mut surfel = Surfel {
                position,
                normal: self.normals[at],
                colour: FLOOR_COLOUR,
                material: 0,
                open: 1.0,
            };
            if owner == FLOOR {
                let met = Met::floor(surfel.colour);
                let lit = light.light(&surfel, &met, -way, open);
                let part = floor_part((position - middle).length(), radius);
                let back = behind(Backdrop::Floor, way);
                let pixel = &mut self.rgba[4 * at..][..4];
                for k in 0..3 {
                    let floor = f32::from(light.tone().screen(lit[k]));
                    pixel[k] = (back[k] + (floor - back[k]) * part + 0.5) as u8;
                }
                pixel[3] = 255;
                continue;
            }
            let instance = &scene.instances[owner as usize];
            let met = Met::new(&self.sight, scene, at, ray);
            surfel.colour = met.colour;
            surfel.material = scene.bodies[instance.body as usize].material;
            if let Some(detail) = &scene.detail {
                detail.refine(&mut surfel, instance.id, depth / view.focal);
            }
            let open = if surfel.open < open {
                surfel.open
            } else {
                open
            };
            let lit = light.light(&surfel, &met, -way, open);
            let pixel = &mut self.rgba[4 * at..][..4];
            for k in 0..3 {
                pixel[k] = light.tone().screen(lit[k]);
            }
            pixel[3] = 255;
        }
    }

    /// Adds rows of this sample to the others; after the last one, what comes next.
    fn sum(&mut self, from: usize, to: usize) -> Phase {
        let [width, height] = self.order.size;
        let last = self.sample + 1 == SAMPLES.len();
        let span = from * width..to * width;
        let pixels = self.rgba[4 * span.start..4 * span.end].chunks_exact_mut(4);
        for (sum, pixel) in self.sums[span].iter_mut().zip(pixels) {
            // Colours count as far as something is there.
            let there = u16::from(pixel[3] > 0);
            for k in 0..3 {
                sum[k] += there * u16::from(pixel[k]);
            }
            sum[3] += there;
            if last {
                let count = sum[3].max(1);
                for k in 0..3 {
                    pixel[k] = ((sum[k] + count / 2) / count) as u8;
                }
                pixel[3] = (sum[3] * 255 / SAMPLES.len() as u16) as u8;
            }
        }
        if to < height {
            return Phase::Sum(to);
        }
        if last {
            return Phase::Planes(0);
        }
        self.sample += 1;
        self.begin_sample();
        Phase::Room(0)
    }

    /// What was seen last becomes the planes, in the same memory: inverse depths those of depth, triangles those of ids.
    fn make_planes(&mut self, scene: &Scene, pixels: Range<usize>) {
        let Sight {
            owner,
            inverse,
            triangle,
            ..
        } = &mut self.sight;
        for at in pixels {
            match scene.instances.get(owner[at] as usize) {
                Some(instance) => {
                    (inverse[at], triangle[at]) = (1.0 / inverse[at], instance.id);
                }
                None => {
                    (inverse[at], triangle[at]) = (0.0, 0);
                    self.normals[at] = Vec3::ZERO;
                }
            }
        }
    }

    /// The finished picture: red, green, blue and alpha (not multiplied in), row after row from the top.
    pub fn rgba(&self) -> &[u8] {
        &self.rgba
    }

    /// 16 hex digits that change with any bit of the picture and of the planes of depth and ids.
    pub fn hash(&self) -> String {
        let mut hash = Hash::new();
        hash.add(self.order.size[0] as u64);
        let pixels = self.rgba.as_chunks().0.iter();
        let planes = self.depths().iter().zip(self.ids());
        for (&pixel, (depth, &id)) in pixels.zip(planes) {
            hash.add(u64::from(depth.to_bits()) << 32 | u64::from(u32::from_le_bytes(pixel)));
            hash.add(id.into());
        }
        hash.text()
    }

    /// Of each pixel the depth of the body there, in units of the scene; 0 where none is. Of a finished frame, as the
    /// other planes are: its only sample, or the last one.
    pub fn depths(&self) -> &[f32] {
        &self.sight.inverse
    }

    /// Of each pixel the id of the body there; 0 where none is.
    pub fn ids(&self) -> &[u32] {
        &self.sight.triangle
    }

    /// Of each pixel the unit normal of the body there, in the world; zero where none is.
    pub fn normals(&self) -> &[Vec3] {
        &self.normals
    }

    /// The place in the scene's list of the body at a pixel.
    pub fn instance_at(&self, x: usize, y: usize) -> Option<usize> {
        let [width, height] = self.order.size;
        let owner = *self.sight.owner.get(y * width + x)?;
        (x < width && y < height && owner < FLOOR).then_some(owner as usize)
    }
}
