//! One picture of a scene, in slices: visibility, ambient occlusion, and light, for each of its samples.

use super::floor::FloorPlane;
use super::mean::Mean;
use super::shade::{Shading, ShadingInputs, far_floor, find_floor};
use super::soft_light::part_of_lamp;
use super::visibility::{FLOOR, VisibilityBuffer};
use super::{Backdrop, Lighting, Order, Scene, lines, samples};
use crate::hash::Hash;
use glam::Vec3;

/// Shading one pixel costs about as much as drawing this many triangles.
const PIXEL_WORK: usize = 1;

/// A frame in progress.
pub struct Frame {
    order: Order,
    sight: VisibilityBuffer,
    shading: Shading,
    phase: FramePhase,
    /// The number of finished samples.
    sample: usize,
    /// The mean of the samples, if there are several.
    mean: Mean,
    rgba: Vec<u8>,
    planes: FramePlanes,
    /// The surface normal at each pixel; zero where there is no body.
    normals: Vec<Vec3>,
    /// The depth in focus.
    focus: f32,
}

/// The visibility of the first sample. Later samples do not change it.
#[derive(Default)]
struct FramePlanes {
    owner: Vec<u32>,
    ids: Vec<u32>,
    depths: Vec<f32>,
}

impl FramePlanes {
    /// Exchanges its lists with those of a visibility buffer.
    fn swap(&mut self, sight: &mut VisibilityBuffer) {
        std::mem::swap(&mut self.owner, &mut sight.owner);
        std::mem::swap(&mut self.ids, &mut sight.triangle);
        std::mem::swap(&mut self.depths, &mut sight.inverse);
    }
}

/// The next phase, with the number of instances, rows or lines done.
#[derive(Clone, Copy, Debug, PartialEq)]
enum FramePhase {
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
            phase: FramePhase::Done,
            sample: 0,
            mean: Mean::new(),
            rgba: Vec::new(),
            planes: FramePlanes::default(),
            normals: Vec::new(),
            focus: 0.0,
            order,
        };
        frame.begin(order);
        frame
    }

    /// Starts another frame in the same memory.
    pub fn begin(&mut self, order: Order) {
        self.order = order;
        self.sample = 0;
        // Swaps the lists back: a frame of one sample then needs memory for only one set of them.
        self.planes.swap(&mut self.sight);
        let pixels = order.size[0] * order.size[1];
        self.mean.begin(if self.has_mean() { pixels } else { 0 });
        self.rgba.clear();
        self.rgba.reserve_exact(4 * pixels);
        self.normals.clear();
        self.phase = self.begin_sample();
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
            FramePhase::Room(_) => 0.0,
            FramePhase::Sight => 0.3 * self.sight.progress(),
            FramePhase::Floor(_) => 0.3,
            FramePhase::Shade(row) => 0.3 + 0.65 * row as f64 / rows,
            FramePhase::Lines(_) | FramePhase::Sum(_) | FramePhase::Planes(_) => 0.95,
            FramePhase::Done => return 1.0,
        };
        (self.sample as f64 + part) / self.order.samples.max(1) as f64
    }

    /// The number of finished samples. Each sample needs the lighting of its number ([`super::SoftLight::of_sample`]).
    /// Once one is finished, the planes are complete. The picture is the mean of the finished samples until the next
    /// call of [`Frame::advance`].
    pub fn sample(&self) -> usize {
        self.sample
    }

    /// Pixels of the frame. Lists of visible triangles are a little longer than that.
    fn pixels(&self) -> usize {
        self.order.size[0] * self.order.size[1]
    }

    fn has_mean(&self) -> bool {
        self.order.samples > 1
    }

    /// Normals need much memory, so only frames of one sample have them.
    fn has_normals(&self) -> bool {
        !self.has_mean()
    }

    /// Does the work of about this many triangles, or as many pixels; true when finished. Scene and light must not
    /// change during a sample, and the light must be ready.
    pub fn advance(&mut self, scene: &Scene, light: &Lighting, amount: usize) -> bool {
        let [width, height] = self.order.size;
        let rows = (amount / (PIXEL_WORK * width)).clamp(1, height);
        self.phase = match self.phase {
            FramePhase::Room(row) => self.make_room(height.min(row.saturating_add(8 * rows))),
            FramePhase::Sight => match self.sight.advance(scene, amount) {
                true if self.order.backdrop == Backdrop::Floor => FramePhase::Floor(0),
                true => FramePhase::Shade(0),
                false => FramePhase::Sight,
            },
            FramePhase::Floor(row) => {
                let end = height.min(row.saturating_add(4 * rows));
                let ground = light.floor_plane();
                (row..end).for_each(|y| find_floor(&mut self.sight, ground, y));
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
                    _ if self.has_mean() => FramePhase::Sum(0),
                    _ => FramePhase::Planes(0),
                }
            }
            FramePhase::Sum(row) => self.sum(row, height.min(row.saturating_add(4 * rows))),
            FramePhase::Planes(row) => {
                self.make_planes(scene, row, height.min(row.saturating_add(4 * rows)))
            }
            FramePhase::Done => FramePhase::Done,
        };
        self.is_done()
    }

    fn begin_sample(&mut self) -> FramePhase {
        let [width, height] = self.order.size;
        let view = self.order.camera.view(width, height);
        let view = match self.sample {
            0 => view,
            sample => {
                let radius = 0.5 * self.order.aperture as f32 * self.focus;
                let place = samples::on_lens(sample).map(|v| v * radius);
                let beside = view.beside(place, self.focus);
                beside.moved(samples::in_pixel(sample))
            }
        };
        self.sight.begin(view, self.order.is_moving, self.order.cut);
        let has_occlusion = !self.order.is_moving;
        self.shading.begin([width, height], has_occlusion);
        FramePhase::Room(0)
    }

    /// Counts a finished sample, and begins the next one.
    fn end_sample(&mut self) -> FramePhase {
        self.sample += 1;
        match self.sample < self.order.samples {
            true => self.begin_sample(),
            false => FramePhase::Done,
        }
    }

    /// Allocates the rows before `to`.
    fn make_room(&mut self, to: usize) -> FramePhase {
        let [width, height] = self.order.size;
        let pixels = to * width;
        self.sight.make_room(pixels);
        self.shading.make_room(width, to);
        if self.sample == 0 {
            self.rgba.resize(4 * pixels, 0);
            if self.has_mean() {
                self.mean.make_room(pixels);
            }
            if self.has_normals() {
                self.normals.resize(pixels, Vec3::ZERO);
            }
        }
        match to == height {
            true => FramePhase::Sight,
            false => FramePhase::Room(to),
        }
    }

    /// Shades about this many rows; gives the next one.
    fn shade(&mut self, scene: &Scene, light: &Lighting, from: usize, rows: usize) -> usize {
        let ground = match self.order.backdrop {
            Backdrop::Floor => light.floor_plane(),
            _ => FloorPlane::default(),
        };
        let studio = ShadingInputs {
            scene,
            light,
            sight: &self.sight,
            backdrop: self.order.backdrop,
            ground,
            part_of_lamp: match self.has_mean() {
                true => part_of_lamp(self.order.samples),
                false => 0.0,
            },
            far: far_floor(light, self.sight.view(), &ground),
        };
        let (rgba, normals) = (&mut self.rgba, &mut self.normals);
        let keep = |at: usize, normal| {
            if let Some(kept) = normals.get_mut(at) {
                *kept = normal;
            }
        };
        self.shading.advance(studio, from, rows, rgba, keep)
    }

    /// Adds rows of this sample to the mean; after the last one, gives the next phase.
    fn sum(&mut self, from: usize, to: usize) -> FramePhase {
        let [width, height] = self.order.size;
        let span = from * width..to * width;
        let rgba = &mut self.rgba[4 * span.start..4 * span.end];
        self.mean.add(span, self.sample, rgba);
        match (to == height, self.sample) {
            (false, _) => FramePhase::Sum(to),
            (true, 0) => FramePhase::Planes(0),
            (true, _) => self.end_sample(),
        }
    }

    /// Turns rows of the visibility buffer into the planes, in the same memory: inverse depths become depths, triangles
    /// become ids.
    fn make_planes(&mut self, scene: &Scene, from: usize, to: usize) -> FramePhase {
        let [width, height] = self.order.size;
        let VisibilityBuffer {
            owner,
            inverse,
            triangle,
            ..
        } = &mut self.sight;
        for at in from * width..to * width {
            (inverse[at], triangle[at]) = match scene.instances.get(owner[at] as usize) {
                Some(instance) => (1.0 / inverse[at], instance.id),
                None => (0.0, 0),
            };
        }
        if to < height {
            return FramePhase::Planes(to);
        }
        self.planes.swap(&mut self.sight);
        let middle = self.planes.depths[height / 2 * width + width / 2];
        self.focus = match middle > 0.0 {
            true => middle,
            false => self.order.camera.distance as f32,
        };
        self.end_sample()
    }

    /// The finished picture: red, green, blue and alpha (not premultiplied), row by row from the top. See
    /// [`Frame::sample`] for unfinished ones.
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

    /// The depth of the body at each pixel, in units of the scene; 0 where there is none. All planes show the first
    /// sample, and are valid as soon as it is finished.
    pub fn depths(&self) -> &[f32] {
        &self.planes.depths[..self.pixels()]
    }

    /// The id of the body at each pixel; 0 where there is none.
    pub fn ids(&self) -> &[u32] {
        &self.planes.ids[..self.pixels()]
    }

    /// The unit normal of the body at each pixel, in the world; zero where there is none. Frames of several samples have
    /// no normals.
    pub fn normals(&self) -> &[Vec3] {
        &self.normals
    }

    /// The index of the instance at a pixel in the scene's list; `None` where there is no body.
    pub fn instance_at(&self, x: usize, y: usize) -> Option<usize> {
        let [width, height] = self.order.size;
        let owner = *self.planes.owner.get(y * width + x)?;
        (x < width && y < height && owner < FLOOR).then_some(owner as usize)
    }
}
