//! Paints stones into the data planes, one by one.
//!
//! Miyata, Itoh, Shimada (2000), sections 5.3 and 5.4: heights by scan conversion, fractal noise added within
//! the stone's mask, colour and material recorded at the same time. Where stones meet the higher surface
//! wins, as in a depth buffer. A pixel has nine samples: its height and colour are blended by the number of
//! samples of each stone and of the ground, which keeps rims smooth.

use super::ground::Bed;
use super::pixel_scale::PixelScale;
use super::samples::{BLEND, PER_PIXEL, Samples};
use super::scan::Raster;
use super::weather::Painted;
use super::{GROUND, Planes, TextureParams};
use crate::cells::Cell;
use crate::material::{Coat, Palette, StoneTexture, TextureNoise, palette};
use crate::order::{greater, lesser};
use crate::solid::{Solid, Solids, StoneKind};
use glam::{DVec2, Vec3};
use std::ops::Range;

/// Work of one slice, in triangles refined and scan-converted or in pixels.
const SLICE: usize = 60_000;

/// Makes the data planes, one cell at a time.
pub struct Painter {
    params: TextureParams,
    palette: &'static Palette,
    planes: Planes,
    bed: Bed,
    noise: TextureNoise,
    coats: Vec<Coat>,
    raster: Raster,
    pixel_scale: PixelScale,
    /// Pixels along a side of the picture.
    side: usize,
    /// The rows being painted, and their samples.
    band: Range<usize>,
    samples: Samples,
    level: f32,
    depth: f32,
    relief: f32,
    /// Rows of the picture whose ground is laid.
    laid: usize,
    /// First and last row of each stone that was painted in an earlier band, in picture units.
    spans: Vec<Option<[f32; 2]>>,
    /// The stone in progress.
    work: Option<PartialStone>,
}

/// A stone that is partly in the planes.
struct PartialStone {
    face: StoneTexture,
    solid: Solid,
    /// A stack of offsets of the images still to be painted.
    images: Vec<[i32; 2]>,
    /// The offset of the current image; the solid is moved to it.
    offset: [i32; 2],
    /// Rows of the current image that are done; `None` while it is scan-converted.
    rows: Option<usize>,
}

impl PartialStone {
    /// Continues with the next image; false if there is none.
    fn next_image(&mut self) -> bool {
        let Some(to) = self.images.pop() else {
            return false;
        };
        for v in &mut self.solid.vertices {
            v.x += (to[0] - self.offset[0]) as f32;
            v.y += (to[1] - self.offset[1]) as f32;
        }
        (self.offset, self.rows) = (to, None);
        true
    }
}

impl Painter {
    /// Starts with planes without ground or stones.
    pub fn new(params: TextureParams) -> Self {
        Self::banded(params, usize::MAX)
    }

    /// Like [`Painter::new`], but paints only a band of rows at a time, from the top: samples of all pixels would take
    /// four times the memory of the planes. [`Painter::next_band`] continues.
    pub fn banded(params: TextureParams, rows: usize) -> Self {
        let side = params.side * params.pixel_scale;
        let (level, depth) = (params.level() as f32, params.depth() as f32);
        let pixel_scale = PixelScale::new(params.pixel_scale);
        let doublings = pixel_scale.noise_doublings();
        let band = 0..side.min(rows);
        let planes = match band.len() == side {
            true => Planes::new(side),
            false => Planes::banded(side, band.len()),
        };
        let mut bed = params.bed();
        bed.hold(band.clone());
        let share_per_height = match params.stone.kind {
            StoneKind::Skin => 1.0 / BLEND,
            _ => f32::INFINITY,
        };
        Self {
            palette: palette(params.palette),
            planes: Planes {
                tile: params.tile,
                pixel_scale: params.pixel_scale,
                ground: level,
                ..planes
            },
            bed,
            noise: TextureNoise::new(params.seed, params.size, params.dimension, doublings),
            coats: Vec::new(),
            raster: Raster::default(),
            pixel_scale,
            side,
            samples: Samples::new(band.len() * side, share_per_height),
            band,
            level,
            depth,
            relief: params.relief(),
            laid: 0,
            spans: Vec::new(),
            work: None,
            params,
        }
    }

    /// Makes and lays about `rows` rows of the band's ground; true when all are laid. [`Painter::paint`] lays
    /// the missing ones.
    pub fn lay_ground(&mut self, rows: usize) -> bool {
        let (side, band_end) = (self.side, self.band.end);
        if self.laid == self.band.start && !self.bed.advance(rows) {
            return false;
        }
        let end = band_end.min(self.laid.saturating_add(rows));
        for y in self.laid..end {
            for x in 0..side {
                let (px, py) = (x as i32, y as i32);
                self.planes.bump[y * side + x] = self.bed.height(px, py);
                self.planes.colour[y * side + x] = bytes(self.bed.colour(px, py));
            }
        }
        self.laid = end;
        end == band_end
    }

    /// Sets the coats of the cells to be painted, by index. Cells beyond the list are plain.
    pub fn set_coats(&mut self, coats: &[Coat]) {
        self.coats = coats.to_vec();
    }

    /// Continues with the next band; false if there is none.
    pub fn next_band(&mut self) -> bool {
        if self.band.end == self.side {
            self.samples.clear(0);
            return false;
        }
        let end = self.side.min(self.band.end + self.band.len());
        self.band = self.band.end..end;
        let pixels = self.band.len() * self.side;
        self.samples.clear(pixels);
        self.planes.id.clear();
        self.planes.id.resize(pixels, GROUND);
        self.bed.hold(self.band.clone());
        true
    }

    /// Paints the stone of a cell into the planes, with the id `index` + 1.
    pub fn paint(&mut self, solids: &mut Solids, cell: &Cell, index: usize) {
        while !self.paint_slice(solids, cell, index) {}
    }

    /// Like [`Painter::paint`], in slices; most stones need only one. True when finished. Until then, calls must be for
    /// the same cell.
    pub fn paint_slice(&mut self, solids: &mut Solids, cell: &Cell, index: usize) -> bool {
        let mut left = SLICE;
        let mut work = match self.work.take() {
            Some(work) => work,
            None => {
                self.lay_ground(usize::MAX);
                if self.is_beyond(cell, index) {
                    return true;
                }
                let Some(solid) = solids.solid_or_slice(cell, &self.params.stone) else {
                    return false;
                };
                if solid.vertices.is_empty() {
                    return true;
                }
                left = left.saturating_sub(solid.triangles.len());
                self.begin(solid, cell, index)
            }
        };
        let done = self.place(&mut work, index, left);
        if !done {
            self.work = Some(work);
        }
        done
    }

    fn begin(&mut self, solid: Solid, cell: &Cell, index: usize) -> PartialStone {
        let coat = self.coats.get(index).copied().unwrap_or_default();
        let mut images = match self.params.tile {
            true => images(&solid.vertices, self.params.side as i32),
            false => Vec::new(),
        };
        images.reverse();
        self.spans.resize(self.spans.len().max(index + 1), None);
        let rows = solid.vertices.iter().map(|v| v.y);
        let none = [f32::MAX, f32::MIN];
        let span = rows.fold(none, |[low, high], y| [lesser(low, y), greater(high, y)]);
        self.spans[index] = Some(span);
        let (window, pixel_scale) = (self.window(), self.params.pixel_scale as f32);
        self.raster.begin(&solid, window, pixel_scale);
        PartialStone {
            face: self.params.face(cell, coat),
            solid,
            images,
            offset: [0, 0],
            rows: None,
        }
    }

    /// Whether no part of a cell's stone can be in the current band.
    fn is_beyond(&self, cell: &Cell, index: usize) -> bool {
        let rows =
            [self.band.start, self.band.end].map(|row| row as f64 / self.params.pixel_scale as f64);
        let side = self.params.side as f64;
        let turns = match self.params.tile {
            true => &[-1.0, 0.0, 1.0][..],
            false => &[0.0],
        };
        let is_off = |low: f64, high: f64| {
            let is_off = |by: f64| low + by > rows[1] || high + by < rows[0];
            turns.iter().all(|turn| is_off(turn * side))
        };
        if let Some(span) = self.spans.get(index).copied().flatten() {
            let [low, high] = span.map(f64::from);
            return is_off(low, high);
        }
        let (mut low, mut high) = (DVec2::MAX, DVec2::MIN);
        for &p in &cell.ring {
            (low, high) = (low.min(p), high.max(p));
        }
        let stone = &self.params.stone;
        // Scale, skew and distortion displace a prism's corners.
        let reach = 1.0 + stone.scale + stone.skin.skew + stone.distortion;
        let reach = reach * (high - low).max_element();
        let is_aside = low.x - reach > side || high.x + reach < 0.0;
        (!self.params.tile && is_aside) || is_off(low.y - reach, high.y + reach)
    }

    /// The columns and rows of the current band.
    fn window(&self) -> [Range<usize>; 2] {
        [0..self.side, self.band.clone()]
    }

    /// Paints a stone and its images, which are shifted by whole pixels and look alike, with work for about
    /// `left` triangles; true when finished.
    fn place(&mut self, work: &mut PartialStone, index: usize, mut left: usize) -> bool {
        let mut raster = std::mem::take(&mut self.raster);
        let floor = self.level - 0.5 * self.depth - 2.0 * self.relief;
        let done = loop {
            if left == 0 {
                break false;
            }
            let done = match work.rows {
                None => {
                    if raster.advance(&work.solid, floor, left) {
                        work.rows = Some(0);
                    }
                    work.solid.triangles.len()
                }
                Some(row) if row < raster.extent[1] => {
                    self.place_row(work, &raster, row, index as u32 + 1);
                    work.rows = Some(row + 1);
                    raster.extent[0]
                }
                Some(_) => {
                    if !work.next_image() {
                        break true;
                    }
                    let pixel_scale = self.params.pixel_scale as f32;
                    raster.begin(&work.solid, self.window(), pixel_scale);
                    0
                }
            };
            left = left.saturating_sub(done);
        };
        self.raster = raster;
        done
    }

    /// Paints a row of pixels of a stone's image.
    fn place_row(&mut self, work: &PartialStone, raster: &Raster, row: usize, id: u32) {
        let moved = work.offset.map(|v| v * self.pixel_scale.per_unit());
        for x in 0..raster.extent[0] {
            if let Some(heights) = raster.pixel(x, row) {
                let at = [x as i32 + raster.origin[0], row as i32 + raster.origin[1]];
                self.pixel(&work.face, at, moved, heights, id);
            }
        }
    }

    /// The present planes.
    pub fn planes(&self) -> &Planes {
        &self.planes
    }

    /// Ids of the rows of the current band.
    pub fn band_ids(&self) -> &[u32] {
        &self.planes.id
    }

    /// The finished planes, ready for the weather.
    pub fn finish(mut self) -> Painted {
        self.lay_ground(usize::MAX);
        if self.band.len() < self.side {
            self.planes.id = Vec::new();
            self.bed.drop_rows();
        }
        Painted {
            planes: self.planes,
            bed: self.bed.into(),
            size: self.params.size,
            depth: self.depth,
        }
    }

    fn pixel(
        &mut self,
        face: &StoneTexture,
        [x, y]: [i32; 2],
        moved: [i32; 2],
        heights: [f32; PER_PIXEL],
        id: u32,
    ) {
        let i = y as usize * self.side + x as usize;
        let [own_x, own_y] = [x - moved[0], y - moved[1]];
        let own_place = [
            self.pixel_scale.centre(own_x),
            self.pixel_scale.centre(own_y),
        ];
        let rough = face.relief(
            &self.noise,
            [own_x, own_y].map(|v| self.pixel_scale.noise_value(v)),
        );
        let raise = self.relief * rough + face.lift(own_place);
        let soil = self.bed.height(x, y);
        let in_band = i - self.band.start * self.side;
        let cover = self.samples.cover(in_band, heights, raise, soil);
        if cover.new == 0 && cover.shared == 0.0 {
            return;
        }
        let dust = self.bed.colour(x, y);
        let own = cover.heights / cover.weight;
        let stand = (own - self.level) / self.depth;
        let colour = face.colour(self.palette, &self.noise, own_place, rough, (stand, dust));
        let each = 1.0 / PER_PIXEL as f32;
        let new = f32::from(cover.new);
        self.planes.bump[i] += (cover.new_heights - soil * new) * each + cover.gained * each;
        let old = self.planes.colour[i].map(f32::from);
        self.planes.colour[i] = bytes(std::array::from_fn(|k| {
            let gain =
                (colour[k] - dust[k]) * cover.new_share + (colour[k] - old[k]) * cover.shared;
            old[k] + gain * each
        }));
        if self.samples.is_owner(in_band, &cover) {
            self.planes.id[in_band] = id;
            self.planes.material[i] = face.material;
        }
    }
}

/// The offsets of a stone's images on a tile that reach into the picture.
fn images(vertices: &[Vec3], side: i32) -> Vec<[i32; 2]> {
    let (mut low, mut high) = ([f32::MAX; 2], [f32::MIN; 2]);
    for v in vertices {
        low = [lesser(low[0], v.x), lesser(low[1], v.y)];
        high = [greater(high[0], v.x), greater(high[1], v.y)];
    }
    let mut images = Vec::new();
    for to in (0..9).map(|k| [(k % 3 - 1) * side, (k / 3 - 1) * side]) {
        let reaches = |k: usize| {
            let by = to[k] as f32;
            low[k] + by < side as f32 && high[k] + by > 0.0
        };
        if to != [0, 0] && reaches(0) && reaches(1) {
            images.push(to);
        }
    }
    images
}

fn bytes(colour: [f32; 3]) -> [u8; 3] {
    colour.map(|v| (v + 0.5) as u8)
}
