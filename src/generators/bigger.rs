//! The finished picture with more pixels: the same bodies and noises in finer detail.
//!
//! The stages up to the cells' coats only use picture units. From the painter on, `pixel_scale` pixels stand for each
//! unit. A picture of 8192 pixels along a side fits into [`MOST_MEMORY`], because only planes that later stages read
//! everywhere are held in full: heights, colours and materials (8 bytes a pixel), then occlusion and light. The
//! ground's tile, the samples of stones and the ids exist for one band of rows at a time. The means of the weather
//! exist for the rows around the present one. Rows of the picture or of its maps are handed out as soon as they are
//! made. No stage depends on where bands meet, so no joint shows. Stencils of large scales of skin have no limit of
//! their own: they get the memory that remains. If it is too little, the scales have fewer Loop steps.

use super::height_field::{Bodies, HeightFieldParams, Painting, ROWS, solids};
use super::lighting::LightParams;
use super::{Clock, PictureSlice, until};
use crate::export::{Map, MapKind, maps};
use crate::heightfield::{Planes, Shader, Weathering};
use crate::material::{Coat, WeatherParams};
use crate::notice::{Code, Notice};
use crate::solid::Solids;
use std::ops::Range;

/// Most pixels along a side of a picture or a frame. A larger one would not fit into the memory that browsers give a
/// page.
pub const MOST_PIXELS: usize = 8192;
/// The most pixels of the bigger picture for each pixel of the picture, along a side.
const MOST_SCALE: usize = 8;
/// Most bytes of a bigger picture. The 1 GiB of the module then has room for the picture itself. If the stencils of the
/// finest solids need more bytes than remain, solids are coarser.
const MOST_MEMORY: usize = 800 << 20;
/// Most bytes of a bigger picture and the picture itself together. The picture itself takes [`OWN`] bytes for each of
/// its pixels. Beside a picture of 2048 pixels along a side, a bigger one of 8192 has less than [`MOST_MEMORY`].
const WITH_PICTURE: usize = 1000 << 20;
const OWN: usize = 64;
/// Least and most pixels of a band. Samples of stones are held for one band only. A stone is made again in each band
/// that it reaches, so few large bands take less time.
const BAND: [usize; 2] = [1 << 20, 3 << 20];
/// Bytes for each pixel after painting: 8 for the planes, and 2 for occlusion and light.
const BYTES: usize = 10;
/// Bytes while stones are painted: for each pixel, in addition for each pixel of the band, and once for noise and
/// ground.
const PAINTING: [usize; 3] = [8, 43, 64 << 20];
/// Rows are handed out as soon as they have this many bytes, even if time is left.
const HANDED: usize = 4 << 20;

/// A bigger picture, or its maps, while it is made.
pub(super) struct Bigger {
    scale: usize,
    /// The wanted maps; empty for the picture itself.
    kinds: Vec<MapKind>,
    /// The revision of the finished picture that is made bigger.
    revision: u64,
    side: usize,
    light: LightParams,
    work: BiggerPhase,
    /// Slices done in the current stage.
    slices: usize,
    /// Rows of the picture whose stones are all painted.
    painted: usize,
    heights: (f32, f32),
    /// Rows to hand out.
    rows: Vec<Map>,
}

/// The current stage and its result.
enum BiggerPhase {
    Painting(Painting, Solids, WeatherParams),
    Weathering(Weathering),
    Shading(Planes, Shader),
    Mapping(Planes, maps::Scale, usize),
    Done,
}

/// The inputs of a bigger picture, from the finished picture.
pub(super) struct Picture<'a> {
    /// Pixels along the side of the finished picture.
    pub side: usize,
    /// The revision of the picture; `None` before the picture is finished.
    pub revision: Option<u64>,
    pub bodies: Option<Bodies<'a>>,
}

impl Bigger {
    /// Works for about `budget` milliseconds on the maps `kinds`, or on the picture if `kinds` is empty. Both have
    /// `scale` times as many pixels along the side. `kept` holds the unfinished work.
    ///
    /// # Errors
    /// A notice if the picture is not finished, or the bigger one would be too large; nothing is kept then.
    pub fn advance(
        kept: &mut Option<Bigger>,
        picture: &Picture,
        ((scale, kinds), params): ((usize, &[MapKind]), &dyn Fn() -> HeightFieldParams),
        clock: Clock,
        budget: f64,
    ) -> Result<PictureSlice, Notice> {
        let goes_on = |b: &Bigger| {
            let is_same = (b.scale, Some(b.revision)) == (scale, picture.revision);
            is_same && b.kinds == kinds && !b.is_done()
        };
        let going = kept.take().filter(goes_on);
        let Picture {
            side,
            revision: Some(revision),
            bodies: Some(bodies),
        } = *picture
        else {
            return Err(Code::NotYet.into());
        };
        let begun = going.is_none();
        let mut bigger = match going {
            Some(bigger) => bigger,
            None => {
                let params = params();
                let mut solids = solids(&params.planes);
                let stone = &params.planes.texture.stone;
                let band = rows(scale, side, |bytes| solids.fit(bodies.cells, stone, bytes))?;
                Self::begin(
                    (scale, kinds),
                    scale * side,
                    revision,
                    params,
                    (bodies.coats, solids, band),
                )
            }
        };
        until(clock, budget, || {
            bigger.add(bodies);
            bigger.is_done() || bigger.bytes() >= HANDED
        });
        let slice = PictureSlice {
            begun,
            progress: bigger.progress(bodies.cells.len()),
            rows: bigger.take(),
            heights: bigger.heights,
            done: bigger.is_done(),
        };
        *kept = Some(bigger);
        Ok(slice)
    }

    /// Starts a picture of `side` pixels along its side. Stones with these coats are painted into `band` rows at a
    /// time.
    pub fn begin(
        (scale, kinds): (usize, &[MapKind]),
        side: usize,
        revision: u64,
        params: HeightFieldParams,
        (coats, solids, band): (&[Coat], Solids, usize),
    ) -> Bigger {
        let painting = Painting::new(&params.planes, coats, band);
        let rows = match kinds {
            // Red, green and blue, as in the map of colours.
            [] => vec![MapKind::Albedo.empty(side)],
            _ => kinds.iter().map(|kind| kind.empty(side)).collect(),
        };
        Bigger {
            scale,
            kinds: kinds.to_vec(),
            revision,
            side,
            light: params.light,
            work: BiggerPhase::Painting(painting, solids, params.weather),
            slices: 0,
            painted: 0,
            heights: (0.0, 0.0),
            rows,
        }
    }

    /// Whether all rows are made.
    pub fn is_done(&self) -> bool {
        matches!(self.work, BiggerPhase::Done)
    }

    /// Does one slice of the work.
    pub fn add(&mut self, bodies: Bodies) {
        self.slices += 1;
        self.work = match std::mem::replace(&mut self.work, BiggerPhase::Done) {
            BiggerPhase::Painting(mut painting, mut solids, weather) => {
                match painting.advance(&mut solids, bodies.cells) && !self.next_band(&mut painting)
                {
                    false => BiggerPhase::Painting(painting, solids, weather),
                    true => {
                        self.slices = 0;
                        // The next stage uses the memory of painting.
                        drop(solids);
                        BiggerPhase::Weathering(Weathering::new(weather, painting.finish()))
                    }
                }
            }
            BiggerPhase::Weathering(mut weathering) => {
                match weathering.advance(bodies.domain, ROWS) {
                    false => BiggerPhase::Weathering(weathering),
                    true => self.finishing(weathering.finish()),
                }
            }
            BiggerPhase::Shading(planes, mut shader) => {
                let done = shader.advance(&planes, &self.light.materials, ROWS);
                let pixels = shader.finished().chunks_exact(4);
                let rgb = pixels.flat_map(|p| [p[0], p[1], p[2]]);
                self.rows[0].bytes.extend(rgb);
                match done {
                    false => BiggerPhase::Shading(planes, shader),
                    true => BiggerPhase::Done,
                }
            }
            BiggerPhase::Mapping(planes, scale, from) => {
                let end = self.side.min(from + ROWS);
                self.map(&planes, &scale, from..end);
                match end == self.side {
                    false => BiggerPhase::Mapping(planes, scale, end),
                    true => BiggerPhase::Done,
                }
            }
            BiggerPhase::Done => BiggerPhase::Done,
        };
    }

    /// Hands out the ids of the band, whose stones are all painted, and goes on to the next band; false if no band is
    /// left.
    fn next_band(&mut self, painting: &mut Painting) -> bool {
        let ids = painting.ids();
        self.painted += ids.len() / self.side;
        for (map, kind) in self.rows.iter_mut().zip(&self.kinds) {
            if *kind == MapKind::Id {
                map.bytes.extend(maps::ids(ids));
            }
        }
        painting.next_band()
    }

    /// The stage after the weather: shading for the picture, mapping for maps.
    fn finishing(&mut self, planes: Planes) -> BiggerPhase {
        self.slices = 0;
        let shade = &self.light.shade;
        if self.kinds.is_empty() {
            let shader = Shader::banded(shade, [planes.side, planes.pixel_scale], ROWS);
            return BiggerPhase::Shading(planes, shader);
        }
        let scale = maps::Scale::new(&planes, &self.light.materials, shade.shininess);
        self.heights = scale.heights;
        BiggerPhase::Mapping(planes, scale, 0)
    }

    /// Hands out these rows of all maps except ids, which are handed out while stones are painted.
    fn map(&mut self, planes: &Planes, scale: &maps::Scale, rows: Range<usize>) {
        for (map, &kind) in self.rows.iter_mut().zip(&self.kinds) {
            if kind != MapKind::Id {
                let made = maps::rows(kind, planes, scale, rows.clone());
                map.bytes.extend(made.bytes);
            }
        }
    }

    fn progress(&self, cells: usize) -> f64 {
        let slices = self.slices as f64;
        let rows = self.side.div_ceil(ROWS) as f64;
        let (from, to, part) = match &self.work {
            BiggerPhase::Painting(painting, ..) => {
                let band = painting.ids().len() as f64 / (self.side * self.side) as f64;
                let stones = painting.stones() as f64 / cells.max(1) as f64;
                let done = self.painted as f64 / self.side as f64;
                (0.0, 0.7, done + band * stones)
            }
            BiggerPhase::Weathering(_) => (0.7, 0.85, slices / (2.2 * rows)),
            BiggerPhase::Shading(..) => (0.85, 1.0, slices / (2.0 * rows)),
            BiggerPhase::Mapping(..) => (0.85, 1.0, slices / rows),
            BiggerPhase::Done => (1.0, 1.0, 0.0),
        };
        from + (to - from) * part.min(1.0)
    }

    /// Bytes of the rows to hand out.
    fn bytes(&self) -> usize {
        self.rows.iter().map(|map| map.bytes.len()).sum()
    }

    /// Hands out the rows made since the last call.
    pub fn take(&mut self) -> Vec<Map> {
        let taken = |map: &mut Map| Map {
            bytes: std::mem::take(&mut map.bytes),
            ..*map
        };
        self.rows.iter_mut().map(taken).collect()
    }
}

/// The number of rows in a band, or a notice if a picture of `side` pixels cannot be made `scale` times as large. `fit`
/// limits stencils to the given bytes, and returns the bytes that they take.
fn rows(scale: usize, side: usize, fit: impl FnOnce(usize) -> usize) -> Result<usize, Notice> {
    let bigger = side.saturating_mul(scale);
    if !(1..=MOST_SCALE).contains(&scale) || bigger > MOST_PIXELS {
        let most = (MOST_PIXELS / side).clamp(1, MOST_SCALE);
        let notice = Notice::new(Code::BadScale).with("side", side);
        let notice = notice.with("most", most).with("given", scale);
        return Err(notice.with("pixels", MOST_PIXELS));
    }
    let [each, in_band, more] = PAINTING;
    let pixels = bigger * bigger;
    let [least, most] = BAND.map(|band| band.min(pixels));
    let memory = MOST_MEMORY.min(WITH_PICTURE.saturating_sub(OWN.saturating_mul(side * side)));
    let left = memory.saturating_sub(each * pixels + in_band * least + more);
    let stencils = fit(left);
    let band = (least + left.saturating_sub(stencils) / in_band).min(most);
    // The planes are two blocks; light and occlusion use the memory that painting has freed.
    let painting = in_band * band + more + stencils;
    let blocks = [
        each * pixels / 2,
        each * pixels / 2,
        painting.max((BYTES - each) * pixels),
    ];
    let mut held: [Vec<u8>; 3] = Default::default();
    let mut blocks = held.iter_mut().zip(blocks);
    match blocks.all(|(room, bytes)| room.try_reserve_exact(bytes).is_ok()) {
        true => Ok((band / bigger).max(ROWS)),
        false => Err(Notice::new(Code::NoMemory).with("side", bigger)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_and_the_bigger_one_fit_into_the_module() {
        for (side, scale) in [(1024, 8), (1365, 6), (2047, 4), (2048, 4)] {
            let mut stencils = 0;
            let band = rows(scale, side, |most| {
                stencils = most;
                most
            });
            let pixels = scale * side * scale * side;
            let in_band = band.expect("room") * scale * side;
            let painting = PAINTING[1] * in_band + PAINTING[2] + stencils;
            let all = OWN * side * side + PAINTING[0] * pixels + painting;
            assert!((800 << 20..1016 << 20).contains(&all), "{side}: {all}");
        }
    }
}
