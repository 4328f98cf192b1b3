//! Tone mapping: between linear light and values of the screen.

/// Entries of the table from linear light to screen values.
const STEPS: usize = 8192;
/// Linear light at the table's end; anything brighter is white.
const BRIGHTEST: f32 = 2.0;
/// Above this screen brightness (linear) highlights are compressed.
const SHOULDER: f64 = 0.55;

/// Conversion of sRGB (IEC 61966-2-1) to linear light and back, the latter with a soft shoulder like film.
#[derive(Clone)]
pub struct Tone {
    linear: [f32; 256],
    screen: Vec<u8>,
}

impl Tone {
    /// Computes both tables.
    pub fn new() -> Self {
        let screen = (0..STEPS).map(|i| {
            let light = (i as f64 + 0.5) / STEPS as f64 * f64::from(BRIGHTEST);
            (255.0 * encoded(shouldered(light)) + 0.5) as u8
        });
        Self {
            linear: std::array::from_fn(|i| decoded(i as f64 / 255.0) as f32),
            screen: screen.collect(),
        }
    }

    /// Linear light of a screen value.
    pub fn linear(&self, value: u8) -> f32 {
        self.linear[usize::from(value)]
    }

    /// The screen value of linear light; 1 is white paper in full light.
    pub fn screen(&self, light: f32) -> u8 {
        // Through i32: a cast to unsigned is slower on x86.
        let i = (light * (STEPS as f32 / BRIGHTEST)) as i32;
        self.screen[i.clamp(0, STEPS as i32 - 1) as usize]
    }
}

/// Linear light of a screen value, both 0..1.
pub(crate) fn decoded(v: f64) -> f64 {
    if v <= 0.04045 {
        v / 12.92
    } else {
        libm::pow((v + 0.055) / 1.055, 2.4)
    }
}

fn encoded(v: f64) -> f64 {
    if v <= 0.003_130_8 {
        v * 12.92
    } else {
        1.055 * libm::pow(v, 1.0 / 2.4) - 0.055
    }
}

fn shouldered(light: f64) -> f64 {
    if light <= SHOULDER {
        return light;
    }
    let room = 1.0 - SHOULDER;
    let over = (light - SHOULDER) / room;
    SHOULDER + room * (over / (1.0 + over)) * 1.08f64.min(1.0 + over)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn screen_values_return_and_rise() {
        let tone = Tone::new();
        for v in 0..=180u8 {
            let back = tone.screen(tone.linear(v));
            assert!(back.abs_diff(v) <= 1, "{v} came back as {back}");
        }
        assert!(tone.screen.is_sorted());
        assert_eq!(tone.screen(f32::MAX), tone.screen[STEPS - 1]);
        assert_eq!(tone.screen(-1.0), 0);
    }
}
