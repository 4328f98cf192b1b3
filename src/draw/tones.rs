//! The colours of drawings: those of the future ground and stones, and the paper of figures.

use super::{Colour, Paper, blend, lit};
use crate::cells::Cell;
use crate::heightfield::TextureParams;
use crate::material::{Coat, Ground, Palette, ground, palette, stone_colour};
use crate::order;

/// The paper of figures (mesh, direction field).
pub const SHEET: Paper = Paper {
    surround: [0.886, 0.859, 0.812, 1.0],
    bed: [0.957, 0.941, 0.914, 1.0],
    line: [0.42, 0.36, 0.30, 1.0],
};

/// Mean lightness of stones in the picture, relative to their own colour.
const STONE_LIGHT: f32 = 0.95;
/// Lightness of the ground around the outline, relative to its mean colour.
const GROUND_LIGHT: f32 = 0.97;
/// Lightness of the bed, relative to the ground around it.
const BED_LIGHT: f32 = 0.78;
/// Share of grey in the ground's colour.
const CALM: f32 = 0.10;

/// The tones of a recipe's pavement.
#[derive(Clone, Debug)]
pub struct Tones {
    /// The colours of the future ground, without its texture.
    pub paper: Paper,
    palette: &'static Palette,
    seed: u64,
    vary: f32,
    /// The coats of cells, in the order of their ids.
    coats: Vec<(u32, Coat)>,
}

impl Tones {
    /// The tones of the pavement with these parameters.
    pub fn new(params: &TextureParams) -> Self {
        let palette = palette(params.palette);
        Self {
            paper: earth(&ground(params.ground, palette)),
            palette,
            seed: params.seed,
            vary: params.vary as f32,
            coats: Vec::new(),
        }
    }

    /// Adds the coats of the cells, once they are known.
    pub fn wearing(mut self, cells: &[Cell], coats: &[Coat]) -> Self {
        let named = cells.iter().map(|cell| cell.id).zip(coats.iter().copied());
        self.coats = named.collect();
        order::sort(&mut self.coats, |&(id, _)| (id.into(), 0));
        self
    }

    /// The tone of the stone that the cell `id` will become.
    pub fn stone(&self, id: u32) -> Colour {
        let place = self.coats.partition_point(|&(other, _)| other < id);
        let worn = self.coats.get(place).filter(|&&(other, _)| other == id);
        let coat = worn.map_or(Coat::default(), |&(_, coat)| coat);
        let [r, g, b] = stone_colour(self.palette, id, self.seed, self.vary, coat);
        lit([r / 255.0, g / 255.0, b / 255.0, 1.0], STONE_LIGHT)
    }
}

/// The paper for a ground: its colour, a darker bed, and a line that contrasts with both.
fn earth(ground: &Ground) -> Paper {
    let [a, b] = ground.colours;
    let [r, g, b] = [0, 1, 2].map(|k| (f32::from(a[k]) + f32::from(b[k])) / 510.0);
    let grey = (r + g + b) / 3.0;
    let surround = blend([r, g, b, 1.0], [grey, grey, grey, 1.0], CALM);
    let surround = lit(surround, GROUND_LIGHT);
    let line = match grey < 0.3 {
        true => blend(surround, [1.0, 0.96, 0.90, 1.0], 0.35),
        false => lit(surround, 0.48),
    };
    Paper {
        surround,
        bed: lit(surround, BED_LIGHT),
        line,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::{GROUNDS, PALETTES};

    fn light(t: Colour) -> f32 {
        (t[0] + t[1] + t[2]) / 3.0
    }

    #[test]
    fn every_ground_tells_bed_line_and_surround_apart() {
        for ground in GROUNDS {
            let paper = earth(&crate::material::ground(ground.name, palette("")));
            let (around, bed, line) = (light(paper.surround), light(paper.bed), light(paper.line));
            assert!(bed < around, "{}", ground.name);
            assert!((line - around).abs() > 0.1, "{}", ground.name);
            assert!((line - bed).abs() > 0.1, "{}", ground.name);
        }
    }

    #[test]
    fn stones_have_colours_of_their_own() {
        for palette in PALETTES {
            let tones = Tones::new(&TextureParams {
                palette: palette.name,
                ..TextureParams::default()
            });
            assert_eq!(tones.stone(7), tones.stone(7));
            assert!((0..20).any(|id| tones.stone(id) != tones.stone(7)));
            let ok = |c: f32| (0.0..=1.0).contains(&c);
            assert!((0..200).all(|id| tones.stone(id).into_iter().all(ok)));
        }
    }
}
