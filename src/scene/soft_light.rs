//! The light of a frame's samples. The lamp is a disc, and shines from another place of the disc for each sample.

use super::{Lighting, Scene, samples};

/// The angular radius of the lamp's disc, in degrees.
const RADIUS: f64 = 4.0;
/// The radius of a sample's part of the disc, relative to a disc with the sample's share of the area.
const OVERLAP: f64 = 1.25;

/// The radius of the part of the lamp's disc that one sample stands for, over its distance. Parts overlap a little.
pub(super) fn part_of_lamp(samples: usize) -> f32 {
    (OVERLAP * libm::tan(RADIUS.to_radians()) / libm::sqrt(samples as f64)) as f32
}

/// The lighting with the lamp in the middle of its disc, which is kept, and that of one later sample.
pub struct SoftLight {
    middle: Lighting,
    moved: Option<(usize, Lighting)>,
}

impl SoftLight {
    /// The light of a lamp whose middle is that of `middle`.
    pub fn new(middle: Lighting) -> Self {
        Self {
            middle,
            moved: None,
        }
    }

    /// The lighting of the first sample.
    pub fn middle(&self) -> &Lighting {
        &self.middle
    }

    /// The lighting of a sample, counted from 0. Its shadows may still have to be drawn ([`Lighting::advance`]).
    pub fn of_sample(&mut self, sample: usize, scene: &Scene) -> &mut Lighting {
        if sample == 0 {
            self.moved = None;
            return &mut self.middle;
        }
        let kept = self.moved.take().filter(|(of, _)| *of == sample);
        let new = || {
            let wide = libm::tan(RADIUS.to_radians());
            let lamp = self.middle.lamp().moved(samples::on_lamp(sample), wide);
            (sample, self.middle.with_lamp(scene, lamp))
        };
        &mut self.moved.insert(kept.unwrap_or_else(new)).1
    }
}
