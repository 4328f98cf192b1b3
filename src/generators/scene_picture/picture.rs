//! A generator's scenes on a turntable: frames of the picture's bodies, or of a view of unfinished work.

use super::still::StillParams;
use super::yaw::{clockwise, seen_by, turned, turned_cut};
use crate::generators::lighting::LightParams;
use crate::generators::turntable::{Turntable, ViewSetup};
use crate::generators::{Budget, Clock, FrameSlice, SeenBody, TurnOrder};
use crate::light::Light;
use crate::material::Material;
use crate::notice::{Code, Notice};
use crate::scene::{Cut, Frame, Order, Scene};
use glam::Vec3;

/// A place counts as visible up to this distance behind the visible surface, in units of the scene.
const BURIED: f32 = 0.06;

/// The azimuth of the light on a body that is shown alone, in degrees.
const FRONT: f64 = 225.0;
/// The least elevation of this light if the picture has a parallel light, in degrees.
const LOW: f64 = 30.0;
/// The elevation of this light if the picture has a lamp at a place, in degrees.
const HIGH: f64 = 45.0;

/// Identifies a scene: its view, and the state of the work in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SceneKey<V> {
    pub view: V,
    /// Whether the work may still change what is shown.
    pub is_live: bool,
    /// The revision of the surface, the shape or the building.
    pub site: u64,
    /// The revision of the shown results.
    pub revision: u64,
}

impl<V: PartialEq> SceneKey<V> {
    /// Whether `after` is a later state of this scene. If so, an unfinished frame of this scene is finished before a
    /// frame of the later one begins; else no frame of moving bodies would ever be finished.
    pub fn leads_to(&self, after: &Self) -> bool {
        self.view == after.view && self.site == after.site && self.is_live
    }
}

/// The key of a scene of this source.
type KeyOf<S> = SceneKey<<S as SceneSource>::View>;

/// A generator's scenes, which are made in slices.
pub(crate) trait SceneSource: Sized {
    /// The views of the work.
    type View: Copy + PartialEq;
    /// A finished scene, with everything that the generator keeps of it.
    type Subject: AsRef<Scene>;
    /// An unfinished scene.
    type Making;

    /// The key of the present scene of a view; `None` while there is none.
    fn key(&self, view: &str) -> Option<KeyOf<Self>>;

    /// Whether the next scene is made by changing the shown scene, which is an earlier state of the same work.
    fn goes_on(&self, _shown: &Self::Subject) -> bool {
        false
    }

    /// Begins a scene. `shown` is the shown scene, if the new scene is made by changing it.
    fn begin(&self, shown: Option<Self::Subject>) -> Self::Making;

    /// Makes a slice of a scene; returns the scene once it is done.
    fn make(&mut self, key: KeyOf<Self>, making: &mut Self::Making) -> Option<Self::Subject>;

    /// The key of the bodies of a view, if the steps of their making can be shown now.
    fn making_key(&self, _view: &str) -> Option<KeyOf<Self>> {
        None
    }

    /// The scene of one step in the making of a body of a view; `None` if there is no such step.
    fn step_scene(&self, _view: &str, _step: (u32, usize)) -> Option<Scene> {
        None
    }

    /// The plane that cuts a scene, where an order asks for `asked`.
    fn cut(&self, _subject: &Self::Subject, asked: Option<Cut>) -> Option<Cut> {
        asked
    }

    /// The materials of a scene, if they are not those of the picture.
    fn materials(&self, _subject: &Self::Subject) -> Option<&'static [Material]> {
        None
    }
}

/// The pictures of a generator's scenes.
pub(crate) struct ScenePicture<S: SceneSource> {
    table: Turntable,
    /// The shown scene.
    shown: Option<(KeyOf<S>, S::Subject)>,
    /// The number of the shown scene, unique among all scenes of this generator.
    number: u64,
    /// The shown step in the making of a body.
    step: Option<ShownStep<S>>,
    /// Whether the last frame shows a step in the making of a body.
    is_step: bool,
    /// The count of all scenes so far.
    count: u64,
    /// The next scene, while it is made.
    making: Option<(KeyOf<S>, S::Making)>,
    /// The pixels of the last drawn view.
    pub(super) view: Vec<u8>,
}

/// A step in the making of a body.
struct ShownStep<S: SceneSource> {
    /// The key of all bodies, then the id of this body and the index of the step.
    of: (KeyOf<S>, (u32, usize)),
    number: u64,
    scene: Scene,
}

impl<S: SceneSource> Default for ScenePicture<S> {
    fn default() -> Self {
        Self {
            table: Turntable::default(),
            shown: None,
            number: 0,
            step: None,
            is_step: false,
            count: 0,
            making: None,
            view: Vec::new(),
        }
    }
}

/// The light on one body that is shown alone. It comes from the front, as the first camera for one body sees it.
fn close_up(light: &LightParams) -> LightParams {
    let mut light = light.clone();
    let elevation = match light.shade.light {
        Light::Parallel { elevation, .. } => elevation.max(LOW.to_radians()),
        Light::Point { .. } => HIGH.to_radians(),
    };
    light.shade.light = Light::Parallel {
        azimuth: FRONT.to_radians(),
        elevation,
    };
    light
}

impl<S: SceneSource> ScenePicture<S> {
    /// The last finished frame.
    pub fn frame(&self) -> Option<&Frame> {
        self.table.frame()
    }

    /// The shown scene with its key.
    pub fn shown(&self) -> Option<(KeyOf<S>, &S::Subject)> {
        self.shown.as_ref().map(|(key, subject)| (*key, subject))
    }

    fn scene(&self) -> Option<&Scene> {
        Some(self.shown()?.1.as_ref())
    }

    /// Works for about `budget` milliseconds on a frame of a source's scene. Camera and light of the source's picture
    /// are in `still`. Starts again if the order has changed.
    ///
    /// # Errors
    /// A notice if there is no scene yet, or no such frame.
    pub fn turn(
        &mut self,
        (source, still): (&mut S, &StillParams),
        order: &TurnOrder,
        clock: Clock,
        budget: f64,
    ) -> Result<FrameSlice, Notice> {
        let step = order.step()?;
        let budget = Budget::new(clock, budget);
        self.is_step = step.is_some();
        if let Some(step) = step {
            return self.step_slice((source, still), (order, step), clock, budget);
        }
        match self.choose(source, &order.how, clock, budget) {
            Some(slice) => Ok(slice),
            None => self.frame_slice((source, still), order, clock, budget),
        }
    }

    /// Works on the scene of a view. `None` if the scene is finished, or cannot be made yet.
    fn choose(
        &mut self,
        source: &mut S,
        view: &str,
        clock: Clock,
        budget: Budget,
    ) -> Option<FrameSlice> {
        let key = source.key(view)?;
        let shown = self.shown().map(|(key, _)| key);
        if shown == Some(key) {
            self.making = None;
            return None;
        }
        let is_later = shown.is_some_and(|shown| shown.leads_to(&key));
        if is_later && !self.table.is_idle() {
            return None;
        }
        let kept = self.making.take().filter(|(making, _)| *making == key);
        let is_new = kept.is_none();
        let mut making = match kept {
            Some((_, making)) => making,
            None => source.begin(self.take_earlier(source, key)),
        };
        let mut subject = None;
        let done = budget.until(clock, || {
            subject = source.make(key, &mut making);
            subject.is_some()
        });
        if done {
            self.count += 1;
            self.number = self.count;
            self.shown = subject.map(|subject| (key, subject));
            return None;
        }
        self.making = Some((key, making));
        Some(FrameSlice {
            begun: is_new,
            refined: false,
            done: false,
            progress: 0.0,
        })
    }

    /// Takes the shown scene, if the scene of `key` is made by changing it.
    fn take_earlier(&mut self, source: &S, key: KeyOf<S>) -> Option<S::Subject> {
        let goes_on = |(shown, subject): &mut (KeyOf<S>, S::Subject)| {
            shown.leads_to(&key) && source.goes_on(subject)
        };
        self.shown.take_if(goes_on).map(|(_, subject)| subject)
    }

    fn frame_slice(
        &mut self,
        (source, still): (&S, &StillParams),
        order: &TurnOrder,
        clock: Clock,
        budget: Budget,
    ) -> Result<FrameSlice, Notice> {
        let Some((_, subject)) = &self.shown else {
            return Err(Code::NotYet.into());
        };
        let mut light = seen_by(&still.light, still.yaw);
        if let Some(materials) = source.materials(subject) {
            light.materials = materials.to_vec();
        }
        let order = order.order()?;
        let order = Order {
            camera: turned(order.camera, still.yaw),
            cut: source
                .cut(subject, order.cut)
                .map(|cut| turned_cut(cut, still.yaw)),
            ..order
        };
        let scene = subject.as_ref();
        let stand = ViewSetup {
            scene,
            number: self.number,
            light: &light,
            ground: None,
        };
        let left = budget.left(clock);
        self.table.advance(&stand, order, clock, left)
    }

    fn step_slice(
        &mut self,
        (source, still): (&S, &StillParams),
        (order, step): (&TurnOrder, (u32, usize)),
        clock: Clock,
        budget: Budget,
    ) -> Result<FrameSlice, Notice> {
        let key = source.making_key(&order.how).ok_or(Code::NotYet)?;
        let of = (key, step);
        let shown = match self.step.take().filter(|shown| shown.of == of) {
            Some(shown) => shown,
            None => {
                let scene = source.step_scene(&order.how, step);
                let scene = scene.ok_or_else(|| order.no_such_body())?;
                self.count += 1;
                let number = self.count;
                ShownStep { of, number, scene }
            }
        };
        let shown = self.step.insert(shown);
        let light = close_up(&still.light);
        let stand = ViewSetup {
            scene: &shown.scene,
            number: shown.number,
            light: &light,
            ground: None,
        };
        let left = budget.left(clock);
        self.table.advance(&stand, order.order()?, clock, left)
    }

    /// The body at a pixel of the last finished frame, whose scene is turned by `yaw` degrees.
    pub fn body_at(&self, yaw: f64, x: usize, y: usize) -> Option<SeenBody> {
        let scene = self.scene().filter(|_| !self.is_step)?;
        let place = self.frame()?.instance_at(x, y)?;
        let instance = scene.instances.get(place).filter(|i| i.id > 0)?;
        let (middle, _) = scene.ball_of(instance);
        let [mx, mz] = clockwise([middle.x, middle.z].map(f64::from), yaw);
        Some(SeenBody {
            id: instance.id,
            middle: [mx, middle.y.into(), mz],
            figures: Vec::new(),
            words: Vec::new(),
        })
    }

    /// The place in the scene at a pixel of the last finished frame; `None` if there is no body.
    pub fn place_at(&self, x: usize, y: usize) -> Option<Vec3> {
        let frame = self.frame()?;
        frame.instance_at(x, y)?;
        let [width, height] = frame.order().size;
        let depth = *frame.depths().get(y * width + x)?;
        let view = frame.order().camera.view(width, height);
        let place = view.eye + view.ray(x as f32 + 0.5, y as f32 + 0.5) * depth;
        place.is_finite().then_some(place)
    }

    /// The pixel of a place in the last finished frame; `None` if the place is not visible.
    pub fn pixel_of(&self, place: Vec3) -> Option<[f64; 2]> {
        let frame = self.frame()?;
        let [width, height] = frame.order().size;
        let view = frame.order().camera.view(width, height);
        let seen = view.of(place);
        if seen.z <= view.near {
            return None;
        }
        let [x, y, _] = view.on_screen(seen);
        let is_inside = x >= 0.0 && y >= 0.0 && x < width as f32 && y < height as f32;
        let depth = frame.depths().get(y as usize * width + x as usize);
        let is_seen = is_inside && depth.is_some_and(|&depth| seen.z < depth + BURIED);
        is_seen.then(|| [x.into(), y.into()])
    }
}
