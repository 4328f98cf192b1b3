//! Phong's shading of the data planes, in slices of rows.

use super::shadow::Shadows;
use crate::heightfield::{Planes, row_slopes, smooth_row_slopes};
use crate::light::{Finish, GAP, LAMP, Light, SHINE, SKY, STEEP, ShadeParams, Tone, lamp_from};
use crate::material::Material;
use crate::order::greater;

/// Picture units to each side over which slopes are smoothed for the highlights of wet and glossy stones.
const REACH: usize = 3;

/// Shades planes into a picture.
pub struct Shader {
    params: ShadeParams,
    side: usize,
    /// Picture units for each pixel.
    unit: f32,
    shadows: Shadows,
    shaded: bool,
    tone: Tone,
    finishes: Vec<Finish>,
    row: usize,
    row_light: RowLight,
    /// Rows of the picture in memory: all, or as many as are handed out at a time.
    room: usize,
    rgba: Vec<u8>,
}

/// The light that reaches each pixel of a row, independent of material and colour.
#[derive(Default)]
struct RowLight {
    /// Rise of the surface to the right and downwards.
    slope: [Vec<f32>; 2],
    /// The rise that highlights see: on surfaces with a film, the relief is smoothed.
    gleam: [Vec<f32>; 2],
    /// Light of the sky.
    sky: Vec<f32>,
    /// Light of the lamp: all of it, and the part that a matt surface scatters.
    lamp: Vec<f32>,
    matt: Vec<f32>,
    /// The cosine between mirrored light and view, as an index into the table of highlights.
    mirrored: Vec<i32>,
}

impl RowLight {
    fn new(side: usize) -> Self {
        let row = || vec![0.0; side];
        Self {
            slope: [row(), row()],
            gleam: [row(), row()],
            sky: row(),
            lamp: row(),
            matt: row(),
            mirrored: vec![0; side],
        }
    }
}

impl Shader {
    /// For a picture of `side` pixels with `pixel_scale` for each picture unit; black at first.
    pub fn new(params: &ShadeParams, side: usize, pixel_scale: usize) -> Self {
        Self::banded(params, [side, pixel_scale], side)
    }

    /// Like [`Shader::new`], with at most `room` rows in memory.
    pub fn banded(params: &ShadeParams, [side, pixel_scale]: [usize; 2], room: usize) -> Self {
        let mut rgba = vec![0; side * room * 4];
        rgba.iter_mut().skip(3).step_by(4).for_each(|a| *a = 255);
        Self {
            params: *params,
            side,
            unit: 1.0 / pixel_scale as f32,
            shadows: Shadows::new(params.light, side, pixel_scale),
            shaded: params.shadow <= 0.0,
            tone: Tone::new(),
            finishes: Vec::new(),
            row: 0,
            row_light: RowLight::new(side),
            room,
            rgba,
        }
    }

    /// Starts again under another light, keeping the data that do not depend on it.
    pub fn restart(&mut self, params: &ShadeParams) {
        self.params = *params;
        self.shadows.restart(params.light);
        self.shaded = params.shadow <= 0.0;
        self.finishes.clear();
        self.row = 0;
    }

    /// Pixels along the picture's side.
    pub fn side(&self) -> usize {
        self.side
    }

    /// Does about `rows` rows, first of the shadows, then of the picture; true when finished. The planes must
    /// have the side given at first, and the table must be that of their materials.
    pub fn advance(&mut self, planes: &Planes, materials: &[Material], rows: usize) -> bool {
        if self.finishes.is_empty() {
            let finish = |o| Finish::new(o, &self.params);
            self.finishes = materials.iter().map(finish).collect();
        }
        if !self.shaded {
            self.shaded = self.shadows.advance(planes, rows);
            return false;
        }
        let end = self.side.min(self.row.saturating_add(rows));
        let end = end.min((self.row / self.room + 1) * self.room);
        for y in self.row..end {
            self.shade_row(planes, y);
        }
        self.row = end;
        end == self.side
    }

    /// The picture: red, green, blue, 255 for each pixel, row by row.
    pub fn rgba(&self) -> &[u8] {
        &self.rgba
    }

    /// The rows that are shaded by now; if there is no room for all, only those in memory.
    pub fn finished(&self) -> &[u8] {
        let rows = match self.row % self.room {
            0 => self.row.min(self.room),
            some => some,
        };
        &self.rgba[..4 * self.side * rows]
    }

    fn shade_row(&mut self, planes: &Planes, y: usize) {
        row_slopes(planes, y, &mut self.row_light.slope);
        self.gleam_row(planes, y);
        match self.params.light {
            Light::Parallel { azimuth, elevation } => {
                let flat = libm::cos(elevation);
                let to = [
                    (libm::cos(azimuth) * flat) as f32,
                    (libm::sin(azimuth) * flat) as f32,
                    libm::sin(elevation) as f32,
                ];
                self.light_row(planes, y, |_, _| (to, 1.0));
            }
            Light::Point { x, y: v, z } => {
                let unit = self.unit;
                let s = self.side as f64 * f64::from(unit);
                let at = [(x * s) as f32, (v * s) as f32, (z * s).max(1.0) as f32];
                self.light_row(planes, y, |x, height| {
                    let [x, y] = [x as f32, y as f32].map(|v| (v + 0.5) * unit);
                    lamp_from([x, y, height - planes.ground], at)
                });
            }
        }
        self.colour_row(planes, y);
    }

    /// Computes the slopes that highlights see.
    fn gleam_row(&mut self, planes: &Planes, y: usize) {
        let RowLight { slope, gleam, .. } = &mut self.row_light;
        let materials = &planes.material[y * self.side..][..self.side];
        let fine = |x: usize| self.finishes[usize::from(materials[x])].fine;
        if (0..self.side).any(|x| fine(x) < 1.0) {
            smooth_row_slopes(planes, y, REACH * planes.pixel_scale, gleam);
        }
        for (gleam, slope) in gleam.iter_mut().zip(slope) {
            for (x, (smooth, own)) in gleam.iter_mut().zip(slope).enumerate() {
                let fine = fine(x);
                let mixed = *smooth + (*own - *smooth) * fine;
                *smooth = if fine < 1.0 { mixed } else { *own };
            }
        }
    }

    /// Computes the light that reaches a row. `lamp` gives the unit vector to the lamp and its strength, for
    /// a column and a height.
    fn light_row(&mut self, planes: &Planes, y: usize, lamp: impl Fn(i32, f32) -> ([f32; 3], f32)) {
        let n = self.side;
        let here = y * n..(y + 1) * n;
        let heights = &planes.bump[here.clone()][..n];
        let open = &planes.occlusion[here.clone()][..n];
        let lit = &self.shadows.lit()[here][..n];
        let (shadow, occlusion) = (self.params.shadow as f32, self.params.occlusion as f32);
        let line = &mut self.row_light;
        let [across, down] = [&line.slope[0][..n], &line.slope[1][..n]];
        let [right, below] = [&line.gleam[0][..n], &line.gleam[1][..n]];
        let (sky, all, matt) = (&mut line.sky[..n], &mut line.lamp[..n], &mut line.matt[..n]);
        let entries = &mut line.mirrored[..n];
        for x in 0..n {
            let (dx, dy) = (across[x], down[x]);
            let upright = 1.0 / (1.0 + dx * dx + dy * dy).sqrt();
            let ([lx, ly, lz], strength) = lamp(x as i32, heights[x]);
            let facing = greater((lz - dx * lx - dy * ly) * upright, 0.0);
            let open = 1.0 - occlusion * (1.0 - f32::from(open[x]) * (1.0 / 255.0));
            let seen = 1.0 - shadow * (1.0 - f32::from(lit[x]) * (1.0 / 255.0));
            let arrives = seen * strength * (1.0 - GAP * (1.0 - open));
            // With the lamp behind the surface there is no mirrored light.
            let (dx, dy) = (right[x], below[x]);
            let rise = 1.0 / (1.0 + dx * dx + dy * dy).sqrt();
            let gleams = greater((lz - dx * lx - dy * ly) * rise, 0.0);
            let mirrored = if facing > 0.0 {
                (2.0 * gleams * rise - lz).clamp(0.0, 1.0)
            } else {
                0.0
            };
            sky[x] = open * (STEEP + (1.0 - STEEP) * upright);
            all[x] = arrives;
            matt[x] = facing * arrives;
            entries[x] = (mirrored * SHINE as f32) as i32;
        }
    }

    /// Computes the colours of a row from the light that reaches it.
    fn colour_row(&mut self, planes: &Planes, y: usize) {
        let n = self.side;
        let here = y * n..(y + 1) * n;
        let out = self.rgba[4 * (y % self.room) * n..][..4 * n].chunks_exact_mut(4);
        let colours = &planes.colour[here.clone()][..n];
        let materials = &planes.material[here][..n];
        let line = &self.row_light;
        let (sky, lamp, matt) = (&line.sky[..n], &line.lamp[..n], &line.matt[..n]);
        let entries = &line.mirrored[..n];
        for (x, pixel) in out.enumerate() {
            let finish = &self.finishes[usize::from(materials[x])];
            let ambient = finish.ambient * sky[x];
            let diffuse = finish.diffuse * matt[x];
            let shine = finish.shine[entries[x] as usize] * lamp[x];
            for k in 0..3 {
                let albedo = self.tone.linear(colours[x][k]);
                let light = albedo * (ambient * SKY[k] + diffuse * LAMP[k]) + shine * LAMP[k];
                pixel[k] = self.tone.screen(light);
            }
        }
    }
}
