//! A pavement or a hide seen from a slant: its stones are bodies on the ground.

use super::Pavement;
use crate::generators::lighting::LightParams;
use crate::generators::turntable::{CloseUp, Turntable, ViewSetup};
use crate::generators::{Budget, Clock, FrameSlice, Frames, Inspect, SeenBody, TurnOrder};
use crate::heightfield::{HeightFieldScene, Surfaces};
use crate::light::Light;
use crate::notice::{Code, Notice};
use crate::scene::{Frame, Scene};
use crate::solid::{Solids, top};

/// The state of the turntable.
#[derive(Default)]
pub(super) struct TurntableScene {
    /// The revision of the planes from which the bodies are made.
    revision: u64,
    making: Option<HeightFieldScene>,
    scene: Option<Scene>,
    step: Option<ShownStep>,
    /// The number of `scene`. Numbers come from `count`, the count of all scenes so far.
    number: u64,
    count: u64,
    table: Turntable,
}

/// The step in the making of a stone that was requested last.
struct ShownStep {
    /// The revision of the planes, the id of the stone, and the index of the step.
    of: (u64, (u32, usize)),
    number: u64,
    scene: Scene,
}

impl Frames for Pavement {
    fn turn(&mut self, order: &TurnOrder, clock: Clock, budget: f64) -> Result<FrameSlice, Notice> {
        if !self.is_done() {
            return Err(Code::NotYet.into());
        }
        let budget = Budget::new(clock, budget);
        let mut slant = std::mem::take(&mut self.slant);
        let made = match self.build(&mut slant, clock, budget) {
            Some(slice) => Ok(slice),
            None => self.frame_slice(&mut slant, order, clock, budget),
        };
        self.slant = slant;
        made
    }

    fn frame(&self) -> Option<&Frame> {
        self.slant.table.frame()
    }

    fn body_at(&mut self, x: usize, y: usize) -> Option<SeenBody> {
        let scene = self.slant.scene.as_ref()?;
        let place = self.frame()?.instance_at(x, y)?;
        let instance = &scene.instances[place];
        let cell = self.scales().get((instance.id as usize).checked_sub(1)?)?;
        let (middle, _) = scene.ball_of(instance);
        let (id, centre) = (instance.id, cell.centre);
        Some(SeenBody {
            id,
            middle: middle.as_dvec3().to_array(),
            figures: self.probe(centre).map_or(Vec::new(), |cell| cell.figures()),
            words: Vec::new(),
        })
    }

    fn making(&self, id: u32) -> Vec<String> {
        let cell = (id as usize)
            .checked_sub(1)
            .and_then(|k| self.scales().get(k));
        let steps = cell.map_or(Vec::new(), |cell| self.surfaces().making(cell));
        steps.iter().map(|step| step.word().to_owned()).collect()
    }
}

impl Pavement {
    /// Works on the bodies within the budget; `None` when they exist.
    fn build(
        &self,
        slant: &mut TurntableScene,
        clock: Clock,
        budget: Budget,
    ) -> Option<FrameSlice> {
        let revision = self.made.finish.weather.revision();
        let is_new = slant.revision != revision;
        if is_new {
            (slant.revision, slant.making) = (revision, None);
        } else if slant.scene.is_some() && slant.making.is_none() {
            return None;
        }
        let (cells, planes) = (self.scales(), self.planes()?);
        let texture = *self.texture();
        let new = || HeightFieldScene::new(texture, cells.len(), planes);
        let mut making = slant.making.take().unwrap_or_else(new);
        if !budget.until(clock, || making.advance(cells, planes)) {
            let progress = 0.5 * making.progress(cells);
            slant.making = Some(making);
            return Some(FrameSlice {
                begun: is_new,
                refined: false,
                done: false,
                progress,
            });
        }
        slant.scene = Some(making.finish());
        slant.count += 1;
        slant.number = slant.count;
        None
    }

    fn frame_slice(
        &self,
        slant: &mut TurntableScene,
        order: &TurnOrder,
        clock: Clock,
        budget: Budget,
    ) -> Result<FrameSlice, Notice> {
        let (Some(scene), Some(planes)) = (&slant.scene, self.planes()) else {
            return Err(Code::NotYet.into());
        };
        let mut stand = ViewSetup {
            scene,
            number: slant.number,
            light: self.light(),
            ground: Some(planes.ground * planes.pixel_scale as f32 / planes.side as f32),
        };
        let beside: LightParams;
        if let Some(step) = order.step()? {
            let of = (slant.revision, step);
            if slant.step.as_ref().is_none_or(|shown| shown.of != of) {
                let scene = self.step_scene(step);
                let scene = scene.ok_or_else(|| order.no_such_body())?;
                slant.count += 1;
                let number = slant.count;
                slant.step = Some(ShownStep { of, number, scene });
            }
            beside = self.light_of(step.0);
            if let Some(ShownStep { number, scene, .. }) = &slant.step {
                (stand.scene, stand.number, stand.light) = (scene, *number, &beside);
            }
        }
        let left = budget.left(clock);
        let slice = slant.table.advance(&stand, order.order()?, clock, left)?;
        // The first half was the making of the bodies.
        Ok(FrameSlice {
            progress: 0.5 + 0.5 * slice.progress,
            ..slice
        })
    }

    fn surfaces(&self) -> Surfaces {
        let texture = *self.texture();
        Surfaces::new(texture, usize::MAX)
    }

    /// The light on a stone that is shown alone and large: its direction is that from the stone's place to the lamp.
    fn light_of(&self, id: u32) -> LightParams {
        let mut light = self.light().clone();
        let cell = self.scales().get((id as usize).wrapping_sub(1));
        if let (Light::Point { x, y, z }, Some(cell)) = (light.shade.light, cell) {
            let place = cell.centre / self.texture().side as f64;
            let (x, y) = (x - place.x, y - place.y);
            light.shade.light = Light::Parallel {
                azimuth: libm::atan2(y, x),
                elevation: libm::atan2(z, libm::hypot(x, y)),
            };
        }
        light
    }

    /// A step in the making of a stone, alone.
    fn step_scene(&self, (id, step): (u32, usize)) -> Option<Scene> {
        let index = (id as usize).checked_sub(1)?;
        let (cell, planes) = (self.scales().get(index)?, self.planes()?);
        let surfaces = self.surfaces();
        let making = *surfaces.making(cell).get(step)?;
        let made = surfaces.step(&mut Solids::new(), (cell, index), planes, making)?;
        let high = top(&self.texture().stone, cell.size);
        Some(CloseUp::new(cell, high).scene(&made.surface, &made.edges, cell.id))
    }
}
