//! One picture of a scene, in slices: visibility, ambient occlusion, and light.

use super::shade::{FloorPlane, Shading, ShadingInputs, far_floor, find_floor};
use super::visibility::{FLOOR, VisibilityBuffer};
use super::{Backdrop, Lighting, Order, Scene, lines};
use crate::hash::Hash;
use crate::order::lesser;
use glam::Vec3;
use std::ops::Range;

/// Shading one pixel costs about as much as drawing this many triangles.
const PIXEL_WORK: usize = 1;
/// Offsets of a pixel's samples from its centre.
const SAMPLES: [[f32; 2]; 4] = [[-0.25, -0.25], [0.25, -0.25], [-0.25, 0.25], [0.25, 0.25]];

/// A frame in progress.
pub struct Frame {
    order: Order,
    sight: VisibilityBuffer,
    shading: Shading,
    phase: FramePhase,
    sample: usize,
    /// Sums over samples of red, green, blue and alpha.
    sums: Vec<[u16; 4]>,
    rgba: Vec<u8>,
    /// The surface normal at each pixel; zero where there is no body.
    normals: Vec<Vec3>,
    ground: FloorPlane,
}

/// The next phase, with the number of instances, rows or lines done.
#[derive(Clone, Copy, Debug, PartialEq)]
enum FramePhase {
    Ground(usize),
    Room(usize),
    Sight,
    Floor(usize),
    Shade(usize),
    Lines(usize),
    Sum(usize),
    Planes(usize),
    Done,
}

impl Frame {
    /// Most bytes of memory for each pixel of a frame.
    pub const BYTES: usize = 38;

    /// Prepares a frame.
    pub fn new(order: Order) -> Self {
        let view = order.camera.view(order.size[0], order.size[1]);
        let mut frame = Self {
            sight: VisibilityBuffer::new(view),
            shading: Shading::new(),
            phase: FramePhase::Ground(0),
            sample: 0,
            sums: Vec::new(),
            rgba: Vec::new(),
            normals: Vec::new(),
            ground: FloorPlane::default(),
            order,
        };
        frame.begin(order);
        frame
    }

    /// Starts another frame in the same memory.
    pub fn begin(&mut self, order: Order) {
        self.order = order;
        self.phase = FramePhase::Ground(0);
        self.sample = 0;
        self.ground = FloorPlane::default();
        let pixels = order.size[0] * order.size[1];
        self.sums.clear();
        self.sums
            .reserve_exact(if order.is_fine { pixels } else { 0 });
        self.rgba.clear();
        self.rgba.reserve_exact(4 * pixels);
    }

    /// The order of this frame.
    pub fn order(&self) -> &Order {
        &self.order
    }

    /// Whether it is finished.
    pub fn is_done(&self) -> bool {
        self.phase == FramePhase::Done
    }

    /// The progress, 0..1, a rough estimate.
    pub fn progress(&self) -> f64 {
        let rows = self.order.size[1] as f64;
        let part = match self.phase {
            FramePhase::Ground(_) | FramePhase::Room(_) => 0.0,
            FramePhase::Sight => 0.3 * self.sight.progress(),
            FramePhase::Floor(_) => 0.3,
            FramePhase::Shade(row) => 0.3 + 0.65 * row as f64 / rows,
            FramePhase::Lines(_) | FramePhase::Sum(_) | FramePhase::Planes(_) => 0.95,
            FramePhase::Done => return 1.0,
        };
        (self.sample as f64 + part) / self.samples() as f64
    }

    /// Pixels of the frame. Lists of visible triangles are a little longer than that.
    fn pixels(&self) -> usize {
        self.order.size[0] * self.order.size[1]
    }

    fn samples(&self) -> usize {
        if self.order.is_fine { SAMPLES.len() } else { 1 }
    }

    /// Does the work of about this many triangles, or as many pixels; true when finished. Scene and light
    /// must not change during a frame, and the light must be ready.
    pub fn advance(&mut self, scene: &Scene, light: &Lighting, amount: usize) -> bool {
        let [width, height] = self.order.size;
        let rows = (amount / (PIXEL_WORK * width)).clamp(1, height);
        self.phase = match self.phase {
            FramePhase::Ground(place) => self.find_ground(scene, place, amount),
            FramePhase::Room(row) => self.make_room(height.min(row.saturating_add(8 * rows))),
            FramePhase::Sight => match self.sight.advance(scene, amount) {
                true if self.order.backdrop == Backdrop::Floor => FramePhase::Floor(0),
                true => FramePhase::Shade(0),
                false => FramePhase::Sight,
            },
            FramePhase::Floor(row) => {
                let end = height.min(row.saturating_add(4 * rows));
                (row..end).for_each(|y| find_floor(&mut self.sight, self.ground, y));
                match end == height {
                    true => FramePhase::Shade(0),
                    false => FramePhase::Floor(end),
                }
            }
            FramePhase::Shade(row) => match self.shade(scene, light, row, rows) {
                end if end == height => FramePhase::Lines(0),
                end => FramePhase::Shade(end),
            },
            FramePhase::Lines(line) => {
                let (sight, rgba) = (&self.sight, &mut self.rgba);
                match lines::draw(sight, &scene.lines, line, amount, rgba) {
                    next if next < scene.lines.len() => FramePhase::Lines(next),
                    _ if self.order.is_fine => FramePhase::Sum(0),
                    _ => FramePhase::Planes(0),
                }
            }
            FramePhase::Sum(row) => self.sum(row, height.min(row.saturating_add(4 * rows))),
            FramePhase::Planes(row) => {
                let end = height.min(row.saturating_add(4 * rows));
                self.make_planes(scene, row * width..end * width);
                match end == height {
                    true => FramePhase::Done,
                    false => FramePhase::Planes(end),
                }
            }
            FramePhase::Done => FramePhase::Done,
        };
        self.is_done()
    }

    /// Finds the lowest point of the bodies before the first sample.
    fn find_ground(&mut self, scene: &Scene, from: usize, amount: usize) -> FramePhase {
        if self.order.backdrop == Backdrop::Floor {
            if from == 0 {
                let (middle, radius) = scene.ball();
                let height = f32::MAX;
                self.ground = FloorPlane {
                    middle,
                    radius,
                    height,
                };
            }
            let (mut at, mut work) = (from, 0);
            while at < scene.instances.len() && work < amount {
                let (low, points) = scene.lowest_of(&scene.instances[at]);
                self.ground.height = lesser(self.ground.height, low);
                (at, work) = (at + 1, work + 1 + points / 8);
            }
            if at < scene.instances.len() {
                return FramePhase::Ground(at);
            }
            if at == 0 {
                self.ground.height = 0.0;
            }
        }
        self.begin_sample();
        FramePhase::Room(0)
    }

    fn begin_sample(&mut self) {
        let [width, height] = self.order.size;
        let view = self.order.camera.view(width, height);
        let view = match self.order.is_fine {
            true => view.moved(SAMPLES[self.sample]),
            false => view,
        };
        self.sight.begin(view, self.order.is_moving, self.order.cut);
        let has_occlusion = !self.order.is_moving;
        self.shading.begin([width, height], has_occlusion);
        self.normals.clear();
        self.normals.reserve_exact(width * height);
    }

    /// Allocates rows.
    fn make_room(&mut self, to: usize) -> FramePhase {
        let [width, height] = self.order.size;
        let pixels = to * width;
        self.sight.make_room(pixels);
        self.shading.make_room(width, to);
        self.normals.resize(pixels, Vec3::ZERO);
        if self.sample == 0 {
            self.rgba.resize(4 * pixels, 0);
            if self.order.is_fine {
                self.sums.resize(pixels, [0; 4]);
            }
        }
        match to == height {
            true => FramePhase::Sight,
            false => FramePhase::Room(to),
        }
    }

    /// Shades about this many rows; gives the next one.
    fn shade(&mut self, scene: &Scene, light: &Lighting, from: usize, rows: usize) -> usize {
        let studio = ShadingInputs {
            scene,
            light,
            sight: &self.sight,
            backdrop: self.order.backdrop,
            ground: self.ground,
            far: far_floor(light, self.sight.view(), &self.ground),
        };
        let (rgba, normals) = (&mut self.rgba, &mut self.normals);
        let keep = |at: usize, normal| normals[at] = normal;
        self.shading.advance(studio, from, rows, rgba, keep)
    }

    /// Adds rows of this sample to the sums; after the last one, gives the next phase.
    fn sum(&mut self, from: usize, to: usize) -> FramePhase {
        let [width, height] = self.order.size;
        let last = self.sample + 1 == SAMPLES.len();
        let span = from * width..to * width;
        let pixels = self.rgba[4 * span.start..4 * span.end].chunks_exact_mut(4);
        for (sum, pixel) in self.sums[span].iter_mut().zip(pixels) {
            // Colours count only if the pixel is covered.
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
            return FramePhase::Sum(to);
        }
        if last {
            return FramePhase::Planes(0);
        }
        self.sample += 1;
        self.begin_sample();
        FramePhase::Room(0)
    }

    /// Turns the last visibility buffer into the planes, in the same memory: inverse depths become depths,
    /// triangles become ids.
    fn make_planes(&mut self, scene: &Scene, pixels: Range<usize>) {
        let VisibilityBuffer {
            owner,
            inverse,
            triangle,
            ..
        } = &mut self.sight;
        for at in pixels {
            (inverse[at], triangle[at]) = match scene.instances.get(owner[at] as usize) {
                Some(instance) => (1.0 / inverse[at], instance.id),
                None => (0.0, 0),
            };
        }
    }

    /// The finished picture: red, green, blue and alpha (not premultiplied), row by row from the top.
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

    /// The depth of the body at each pixel, in units of the scene; 0 where there is none. Like the other
    /// planes it is valid for a finished frame, and has its only sample or the last one.
    pub fn depths(&self) -> &[f32] {
        &self.sight.inverse[..self.pixels()]
    }

    /// The id of the body at each pixel; 0 where there is none.
    pub fn ids(&self) -> &[u32] {
        &self.sight.triangle[..self.pixels()]
    }

    /// The unit normal of the body at each pixel, in the world; zero where there is none.
    pub fn normals(&self) -> &[Vec3] {
        &self.normals
    }

    /// The index in the scene's list of the instance at a pixel.
    pub fn instance_at(&self, x: usize, y: usize) -> Option<usize> {
        let [width, height] = self.order.size;
        let owner = *self.sight.owner.get(y * width + x)?;
        (x < width && y < height && owner < FLOOR).then_some(owner as usize)
    }
}
