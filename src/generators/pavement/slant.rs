//! A pavement or a hide seen from a slant: its stones as bodies on their ground.

use super::Pavement;
use crate::generators::turntable::{Stand, Turntable};
use crate::generators::{Clock, FrameSlice, SeenBody, TurnOrder};
use crate::heightfield::Cutout;
use crate::notice::{Code, Notice};
use crate::scene::{Frame, Scene};

/// What is on the turntable.
#[derive(Default)]
pub(super) struct Slant {
    /// Of which planes the bodies are.
    revision: u64,
    making: Option<Cutout>,
    scene: Option<Scene>,
    /// Of the scenes made so far.
    number: u64,
    table: Turntable,
}

impl Slant {
    /// The frame last finished.
    pub fn frame(&self) -> Option<&Frame> {
        self.table.frame()
    }
}

impl Pavement {
    pub(super) fn turn_slice(
        &mut self,
        order: &TurnOrder,
        clock: Clock,
        budget: f64,
    ) -> Result<FrameSlice, Notice> {
        if !self.is_done() {
            return Err(Code::NotYet.into());
        }
        let begin = clock();
        let mut slant = std::mem::take(&mut self.slant);
        let made = match self.build(&mut slant, clock, budget) {
            Some(slice) => Ok(slice),
            None => self.frame_slice(&mut slant, order, begin, clock, budget),
        };
        self.slant = slant;
        made
    }

    /// Makes the bodies, for about `budget` milliseconds; nothing where they are there.
    fn build(&self, slant: &mut Slant, clock: Clock, budget: f64) -> Option<FrameSlice> {
        let revision = self.made.finish.weather.revision();
        let is_new = slant.revision != revision;
        if is_new {
            (slant.revision, slant.making) = (revision, None);
        } else if slant.scene.is_some() && slant.making.is_none() {
            return None;
        }
        let (cells, planes) = (self.scales(), self.planes()?);
        let texture = self.working.params.finish.planes.texture;
        let new = || Cutout::new(texture, cells.len());
        let mut making = slant.making.take().unwrap_or_else(new);
        let begin = clock();
        while !making.advance(cells, planes) {
            // Not `>=`: a clock that fails must not make this endless.
            let inside = clock() - begin < budget;
            if !inside {
                let progress = 0.5 * making.progress(cells);
                slant.making = Some(making);
                return Some(FrameSlice {
                    begun: is_new,
                    done: false,
                    progress,
                });
            }
        }
        slant.scene = Some(making.finish());
        slant.number += 1;
        None
    }

    fn frame_slice(
        &self,
        slant: &mut Slant,
        order: &TurnOrder,
        begin: f64,
        clock: Clock,
        budget: f64,
    ) -> Result<FrameSlice, Notice> {
        let (Some(scene), Some(planes)) = (&slant.scene, self.planes()) else {
            return Err(Code::NotYet.into());
        };
        let stand = Stand {
            scene,
            number: slant.number,
            light: &self.working.params.finish.light,
            ground: planes.ground * planes.pixel_scale as f32 / planes.side as f32,
        };
        let left = budget - (clock() - begin);
        slant.table.advance(&stand, order, clock, left)
    }

    /// The stone at a pixel of the frame last finished.
    pub(super) fn seen_at(&self, x: usize, y: usize) -> Option<SeenBody> {
        let scene = self.slant.scene.as_ref()?;
        let place = self.slant.frame()?.instance_at(x, y)?;
        let instance = &scene.instances[place];
        let cell = self.scales().get((instance.id as usize).checked_sub(1)?)?;
        let (middle, _) = scene.ball_of(instance);
        Some(SeenBody {
            id: instance.id,
            cell: cell.centre.to_array(),
            middle: middle.as_dvec3().to_array(),
        })
    }

    /// The words of the steps in which a stone is made.
    pub(super) fn steps_of(&self, _id: u32) -> Vec<String> {
        Vec::new()
    }
}
