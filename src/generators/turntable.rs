//! Frames of scenes on a turntable, made in slices for the latest order. The lighting is kept while the camera moves.

use super::lighting::LightParams;
use super::{Budget, Clock, MOST_PIXELS};
use crate::cells::Cell;
use crate::notice::{Code, Notice, quote};
use crate::scene::{
    Backdrop, Body, Camera, Cut, Frame, Instance, Lamp, Lighting, MOST_SAMPLES, Order, Place,
    SAMPLES, Scene, Sharpness, SoftLight, WIDEST,
};
use crate::solid::Surface;
use glam::Vec3;

/// The work of one slice, in triangles drawn or pixels shaded.
const SLICE: usize = 6_000;

/// An order for a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct TurnOrder {
    /// Empty for all bodies, or a body's id and the index of a step in its making, as '12:3'.
    pub subject: String,
    /// The camera, in units of the scene. All bodies together and each single body are scenes of different scales.
    pub camera: Camera,
    /// Width and height in pixels.
    pub size: [usize; 2],
    /// Words joined by '+': 'moving' (coarser, without occlusion), 'still' (one sample) or 'fine' (the mean of [`SAMPLES`]
    /// samples); 'samples=N' for another number of samples, up to [`MOST_SAMPLES`]; 'aperture=A' for blur by depth
    /// ([`Order::aperture`]); 'floor', 'sky' or 'nothing' as the background; 'whole=X,Y,Z,D' or 'through=X,Y,Z,D' for a
    /// plane that cuts away bodies ([`Cut::read`]). Other words are ignored.
    pub how: String,
}

impl TurnOrder {
    /// The wanted body and step; `None` for all bodies.
    pub(super) fn step(&self) -> Result<Option<(u32, usize)>, Notice> {
        if self.subject.is_empty() {
            return Ok(None);
        }
        let pair = self.subject.split_once(':');
        let step = pair.and_then(|(id, step)| Some((id.parse().ok()?, step.parse().ok()?)));
        step.map(Some).ok_or_else(|| self.no_such_body())
    }

    pub(super) fn no_such_body(&self) -> Notice {
        Notice::new(Code::NoSuchBody).with("given", quote(&self.subject))
    }

    /// The order of the scene's frame.
    pub(super) fn order(&self) -> Result<Order, Notice> {
        let fits = |n: &usize| (1..=MOST_PIXELS).contains(n);
        if !self.size.iter().all(fits) {
            let [width, height] = self.size;
            let notice = Notice::new(Code::FrameSize).with("width", width);
            return Err(notice.with("height", height).with("most", MOST_PIXELS));
        }
        let has = |word: &str| self.how.split('+').any(|given| given == word);
        let given = |key: &str| {
            let mut words = self.how.split('+');
            let number = |word: &str| word.strip_prefix(key)?.strip_prefix('=')?.parse().ok();
            words
                .find_map(number)
                .filter(|number: &f64| number.is_finite())
        };
        let backdrop = Backdrop::ALL.iter().find(|(_, word)| has(word));
        let samples = if has("fine") { SAMPLES } else { 1 };
        Ok(Order {
            camera: self.camera,
            size: self.size,
            samples: (given("samples").unwrap_or(samples as f64) as usize).clamp(1, MOST_SAMPLES),
            aperture: given("aperture").map_or(0.0, |wide| wide.clamp(0.0, WIDEST)),
            is_moving: has("moving"),
            backdrop: backdrop.map_or(Backdrop::Floor, |&(backdrop, _)| backdrop),
            cut: self.how.split('+').find_map(Cut::read),
        })
    }
}

/// The result of a slice of work on a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameSlice {
    /// Whether a new frame begins: for another order, or the same one again.
    pub begun: bool,
    /// Whether one more sample is finished, so that the frame shows more than before.
    pub refined: bool,
    /// Whether the frame is finished.
    pub done: bool,
    /// The share of the work that is done, 0..1, a rough estimate.
    pub progress: f64,
}

/// A visible body.
#[derive(Clone, Debug, PartialEq)]
pub struct SeenBody {
    /// Its id; ids count from 1.
    pub id: u32,
    /// The middle of the body, in the scene.
    pub middle: [f64; 3],
    /// The generator's measures of it, by their words.
    pub figures: Vec<(&'static str, f64)>,
    /// Properties of the body that are words instead of numbers, each with the word of its kind.
    pub words: Vec<(&'static str, String)>,
}

/// A label at a pixel of a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct SeenLabel {
    /// The label, as the building has it.
    pub text: String,
    /// The pixel, from the top left corner of the frame.
    pub pixel: [f64; 2],
}

/// The inputs of a frame, to know whether a new frame must begin.
#[derive(Clone, PartialEq)]
struct FrameKey {
    scene: u64,
    light: LightParams,
    order: Order,
}

/// A light, after the number of the scene and the parameters that it was made for.
type KeptLight = (u64, LightParams, SoftLight);

/// The kept lighting, and the frame that is being made.
#[derive(Default)]
pub(super) struct Turntable {
    /// The fine lighting, then the coarse one.
    lights: [Option<KeptLight>; 2],
    frame: Option<Frame>,
    key: Option<FrameKey>,
}

/// A scene with its light, and a number that no other scene has.
pub(super) struct ViewSetup<'a> {
    pub scene: &'a Scene,
    pub number: u64,
    pub light: &'a LightParams,
    /// The height of the ground under lamps, in units of the scene; `None` for the height of the lowest body.
    pub ground: Option<f32>,
}

/// Moves and scales one stone so that it can be shown alone. The middle of the stone comes to the origin. A corner at
/// the mean distance from the cell's centre, at the top or at the base of the stone, is one unit from the origin.
pub(super) struct CloseUp {
    middle: Vec3,
    /// Units of the scene for each unit of the picture.
    pub unit: f32,
}

impl CloseUp {
    pub fn new(cell: &Cell, high: f64) -> Self {
        let far: f64 = cell.ring.iter().map(|&p| (p - cell.centre).length()).sum();
        let mean = far / cell.ring.len().max(1) as f64;
        let middle = cell.centre.as_vec2();
        Self {
            middle: Vec3::new(middle.x, 0.5 * high as f32, middle.y),
            unit: (1.0 / libm::hypot(mean, 0.5 * high).max(f64::MIN_POSITIVE)) as f32,
        }
    }

    /// Maps a place (picture x, height, picture y) into the scene.
    pub fn at(&self, p: Vec3) -> Vec3 {
        (p - self.middle) * self.unit
    }

    /// The scene of a surface alone, with lines over it.
    pub fn scene(&self, surface: &Surface, edges: &[[Vec3; 2]], id: u32) -> Scene {
        let line = |p: &Vec3| self.at(Vec3::new(p.x, p.z, p.y));
        Scene {
            bodies: vec![Body::new(vec![surface.upright(|p| self.at(p))], 1)],
            instances: vec![Instance {
                body: 0,
                place: Place::default(),
                id,
                paint: None,
            }],
            lines: edges.iter().map(|edge| edge.each_ref().map(line)).collect(),
            reach: 0.5,
            ..Scene::default()
        }
    }
}

impl ViewSetup<'_> {
    /// The lighting of the scene, on which all work is still to be done.
    pub fn lighting(&self, sharpness: Sharpness, cut: Option<Cut>) -> Lighting {
        let ground = self.ground.unwrap_or_else(|| self.scene.lowest());
        let lamp = Lamp::over_picture(self.light.shade.light, ground);
        let (params, materials) = (&self.light.shade, &self.light.materials);
        Lighting::new(self.scene, lamp, (params, materials), sharpness).cut_by(cut)
    }
}

impl Turntable {
    /// Works for about `budget` milliseconds on a frame. Starts again if the order differs from the last one.
    pub fn advance(
        &mut self,
        stand: &ViewSetup,
        order: Order,
        clock: Clock,
        budget: f64,
    ) -> Result<FrameSlice, Notice> {
        let key = FrameKey {
            scene: stand.number,
            light: stand.light.clone(),
            order,
        };
        let is_new = self.key.as_ref() != Some(&key);
        if self.frame.as_ref().map(|frame| frame.order().size) != Some(key.order.size) {
            self.frame = None;
            check_room(key.order.size)?;
        }
        let frame = match &mut self.frame {
            Some(frame) => {
                if is_new || frame.is_done() {
                    frame.begin(key.order);
                }
                frame
            }
            none => none.insert(Frame::new(key.order)),
        };
        let wanted = (Sharpness::of(&order), order.cut);
        self.key = Some(key);
        let budget = Budget::new(clock, budget);
        let light = light_for(&mut self.lights, stand, wanted);
        let before = frame.sample();
        let refined = budget.until(clock, || {
            let light = light.of_sample(frame.sample(), stand.scene);
            if light.advance(stand.scene, SLICE) {
                frame.advance(stand.scene, light, SLICE);
            }
            frame.sample() > before
        });
        Ok(FrameSlice {
            begun: is_new,
            refined,
            done: frame.is_done(),
            progress: frame.progress(),
        })
    }

    /// Whether there is no unfinished frame.
    pub fn is_idle(&self) -> bool {
        self.frame.as_ref().is_none_or(Frame::is_done)
    }

    /// The last frame, if at least its first sample is finished.
    pub fn frame(&self) -> Option<&Frame> {
        self.frame.as_ref().filter(|frame| frame.sample() > 0)
    }
}

/// Checks that there is memory for a frame, and for the picture that is handed over.
fn check_room([width, height]: [usize; 2]) -> Result<(), Notice> {
    let bytes = (Frame::BYTES + 4) * width * height;
    match Vec::<u8>::new().try_reserve_exact(bytes) {
        Ok(()) => Ok(()),
        Err(_) => Err(Notice::new(Code::NoMemory).with("side", width.max(height))),
    }
}

/// The lighting for a frame. While something moves, an existing fine lighting is used; if there is none, a coarse one,
/// which is made sooner.
fn light_for<'a>(
    [fine, coarse]: &'a mut [Option<KeptLight>; 2],
    stand: &ViewSetup,
    (wanted, cut): (Sharpness, Option<Cut>),
) -> &'a mut SoftLight {
    let is_of = |(number, params, light): &KeptLight| {
        *number == stand.number && params == stand.light && light.middle().cut() == cut
    };
    let is_coarse = wanted == Sharpness::Coarse;
    let kept = match is_coarse && !fine.as_ref().is_some_and(is_of) {
        true => coarse,
        false => fine,
    };
    let does = |light: &SoftLight| is_coarse || light.middle().sharpness() == wanted;
    let fits = kept.take().filter(|kept| is_of(kept) && does(&kept.2));
    let new = || {
        (
            stand.number,
            stand.light.clone(),
            SoftLight::new(stand.lighting(wanted, cut)),
        )
    };
    &mut kept.insert(fits.unwrap_or_else(new)).2
}
