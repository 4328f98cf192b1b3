//! The data planes as pictures: heights in grey, normals as colours, ids as distinct colours.

use crate::heightfield::{GROUND, Planes, beside};

/// Heights from black (the lowest) to white (the highest), opaque RGBA.
pub fn height(planes: &Planes) -> Vec<u8> {
    let (lo, hi) = planes.height_range();
    let scale = if hi > lo { 255.0 / (hi - lo) } else { 0.0 };
    opaque(planes.bump.iter().map(|h| {
        let grey = ((h - lo) * scale + 0.5) as u8;
        [grey; 3]
    }))
}

/// Unit normals as colours: red = x, green = up on screen (-y), blue = towards the eye, mapped from -1..1 to
/// 0..255 as in normal maps. Opaque RGBA.
pub fn normals(planes: &Planes) -> Vec<u8> {
    let side = planes.side;
    opaque((0..planes.bump.len()).map(|at| {
        let [nx, ny, nz] = normal(planes, at % side, at / side);
        [nx, -ny, nz].map(|c| (127.5 + 127.5 * c + 0.5) as u8)
    }))
}

/// The unit normal of the bump plane at a pixel, by central differences, z towards the eye.
pub fn normal(planes: &Planes, x: usize, y: usize) -> [f32; 3] {
    let side = planes.side;
    let bump = |x: usize, y: usize| planes.bump[y * side + x];
    let [[left, right], [above, below]] = [x, y].map(|k| beside(k, side, planes.tile));
    // At the edges of a picture that does not repeat, one neighbour is missing.
    let steps = |k: usize| match planes.tile || (k > 0 && k + 1 < side) {
        true => 2.0,
        false => 1.0,
    };
    let dx = (bump(right, y) - bump(left, y)) / steps(x);
    let dy = (bump(x, below) - bump(x, above)) / steps(y);
    let scale = 1.0 / (dx * dx + dy * dy + 1.0).sqrt();
    [-dx * scale, -dy * scale, scale]
}

/// A colour for each stone, different from its neighbours', and a dark ground. Opaque RGBA.
pub fn ids(planes: &Planes) -> Vec<u8> {
    opaque(planes.id.iter().map(|&id| id_colour(id)))
}

/// The colour of a stone's id: hues a golden section apart, in three alternating lightnesses.
pub fn id_colour(id: u32) -> [u8; 3] {
    if id == GROUND {
        return [38, 34, 30];
    }
    let hue = (id.wrapping_mul(0x9E37_79B9) >> 8) as f32 / (1 << 24) as f32;
    let light = [0.62, 0.74, 0.86][(id % 3) as usize];
    let channel = |shift: f32| {
        let h = (hue + shift).fract();
        let wave = ((6.0 * h - 3.0).abs() - 1.0).clamp(0.0, 1.0);
        let soft = light * (0.42 + 0.58 * wave);
        (255.0 * soft + 0.5) as u8
    };
    [channel(0.0), channel(2.0 / 3.0), channel(1.0 / 3.0)]
}

fn opaque(colours: impl Iterator<Item = [u8; 3]>) -> Vec<u8> {
    colours.flat_map(|[r, g, b]| [r, g, b, 255]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slope() -> Planes {
        let side = 8;
        let n = side * side;
        Planes {
            bump: (0..n).map(|at| (at % side) as f32).collect(),
            id: (0..n as u32).collect(),
            ..Planes::new(side)
        }
    }

    #[test]
    fn a_slope_rises_in_grey_and_leans_left() {
        let planes = slope();
        let grey = height(&planes);
        assert_eq!((grey[0], grey[4 * 7]), (0, 255));
        let n = normal(&planes, 3, 3);
        assert!((n[0] + 0.5f32.sqrt()).abs() < 1e-6 && n[1] == 0.0);
        assert_eq!(normals(&planes).len(), 4 * 64);
    }

    #[test]
    fn neighbouring_ids_differ() {
        for id in 0..1000 {
            let (a, b) = (id_colour(id), id_colour(id + 1));
            let far: i32 = (0..3).map(|k| (a[k] as i32 - b[k] as i32).abs()).sum();
            assert!(far > 24, "{id}: {a:?} {b:?}");
        }
    }

    #[test]
    fn empty_planes_give_an_empty_picture() {
        assert!(height(&Planes::default()).is_empty());
    }
}
