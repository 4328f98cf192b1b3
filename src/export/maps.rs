//! The data planes as texture maps for other programs. The maps of tiles repeat to the pixel.

use crate::heightfield::{Planes, row_slopes};
use crate::material::Material;
use std::ops::Range;

/// A map of `side` x `side` pixels, row after row from the top; or some of its rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// Pixels along a side.
    pub side: usize,
    /// 1 for grey, 3 for red, green, blue, or 4 with alpha.
    pub channels: u8,
    /// Bits of a channel: 8 or 16, or 32 for floats.
    pub bits: u8,
    /// The values, with the high byte first, as in PNG.
    pub bytes: Vec<u8>,
}

impl Map {
    /// A map of 8 bits and one or three channels as opaque RGBA, for display.
    pub fn rgba(&self) -> Vec<u8> {
        let channels = usize::from(self.channels);
        let opaque = |p: &[u8]| [p[0], p[channels / 2], p[channels - 1], 255];
        self.bytes.chunks_exact(channels).flat_map(opaque).collect()
    }

    /// The mask map of Unity, made of a map of kind [`MapKind::Orm`]: metal, occlusion, 0, and smoothness (1 -
    /// roughness) as red, green, blue and alpha. Only native programs use it; the page has its own.
    pub fn mask(&self) -> Map {
        let pixels = self.bytes.chunks_exact(3);
        let mask = pixels.flat_map(|p| [p[2], p[0], 0, 255 - p[1]]);
        Map {
            channels: 4,
            bytes: mask.collect(),
            ..*self
        }
    }
}

/// The content of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MapKind {
    /// Height: grey of 16 bits, from the lowest (0) to the highest (65535) value of the bump plane.
    /// [`super::Report::height_range`] has both.
    Height,
    /// Normals with green up the picture, as in OpenGL: x, y, z from -1..1 to 0..255.
    NormalOpengl,
    /// Normals with green down the picture, as in DirectX.
    NormalDirectx,
    /// Colour before light, sRGB.
    Albedo,
    /// Roughness (see [`roughness`]): grey, not sRGB.
    Roughness,
    /// The ambient light that reaches a point: grey, 255 for all of it, not sRGB.
    Occlusion,
    /// A unique colour for each cell, black for the ground: see [`id_colour`].
    Id,
    /// Ambient occlusion, roughness and metal (always 0) as red, green and blue.
    Orm,
    /// Height above the base level as floats, in sides of the picture.
    HeightFloat,
}

impl MapKind {
    /// All maps with their words, which are also the names of their files.
    pub const ALL: [(MapKind, &'static str); 9] = [
        (MapKind::Height, "height"),
        (MapKind::NormalOpengl, "normal-opengl"),
        (MapKind::NormalDirectx, "normal-directx"),
        (MapKind::Albedo, "albedo"),
        (MapKind::Roughness, "roughness"),
        (MapKind::Occlusion, "ao"),
        (MapKind::Id, "id"),
        (MapKind::Orm, "orm"),
        (MapKind::HeightFloat, "height-float"),
    ];

    /// The map's word.
    pub fn word(self) -> &'static str {
        let found = Self::ALL.iter().find(|(kind, _)| *kind == self);
        found.map_or("", |(_, word)| word)
    }

    /// A map of this kind without rows.
    pub(crate) fn empty(self, side: usize) -> Map {
        let (channels, bits) = match self {
            MapKind::Height => (1, 16),
            MapKind::HeightFloat => (1, 32),
            MapKind::Roughness | MapKind::Occlusion => (1, 8),
            _ => (3, 8),
        };
        Map {
            side,
            channels,
            bits,
            bytes: Vec::new(),
        }
    }

    /// The map with this word.
    pub fn of_word(word: &str) -> Option<MapKind> {
        let found = Self::ALL.iter().find(|(_, w)| *w == word);
        found.map(|&(kind, _)| kind)
    }
}

/// The roughness, 0..1, of a highlight with Phong's exponent.
///
/// Beckmann's distribution (and nearly GGX) equals cos^n for the width sqrt(2 / (n + 2)): Walter, Marschner, Li,
/// Torrance (2007), Microfacet Models for Refraction through Rough Surfaces, section 5.2. The roughness in today's
/// maps is the root of that width: Burley (2012), Physically Based Shading at Disney; Karis (2013), Real Shading in
/// Unreal Engine 4.
pub fn roughness(shininess: f64) -> f32 {
    (2.0 / (shininess.max(0.0) + 2.0)).sqrt().sqrt() as f32
}

/// Red, green, blue for an id of the id plane: 0 for the ground, else the cell's index + 1. Multiplication by an odd
/// factor gives all ids below 2^24 different colours, and neighbouring ids very different ones.
pub fn id_colour(id: u32) -> [u8; 3] {
    let [_, r, g, b] = id.wrapping_mul(0x009E_3779).to_be_bytes();
    [r, g, b]
}

/// The values that depend on all rows, for maps that are made row by row.
#[derive(Clone, Debug)]
pub struct Scale {
    /// The lowest and the highest value of the bump plane, in picture units.
    pub heights: (f32, f32),
    /// Roughness of each material, 0..255.
    roughness: Vec<u8>,
}

impl Scale {
    /// `materials` is the table that the plane of materials indexes; `shininess` is the factor on its exponents.
    pub fn new(planes: &Planes, materials: &[Material], shininess: f64) -> Self {
        let grey = |o: &Material| roughness(f64::from(o.shininess) * shininess);
        Self {
            heights: planes.height_range(),
            roughness: materials.iter().map(|o| byte(255.0 * grey(o))).collect(),
        }
    }

    fn rough(&self, material: u8) -> u8 {
        let found = self.roughness.get(usize::from(material));
        found.copied().unwrap_or(255)
    }

    /// A height as the 16 bits of [`MapKind::Height`].
    fn grey(&self, height: f32) -> u16 {
        let (low, high) = self.heights;
        let scale = if high > low {
            65535.0 / (high - low)
        } else {
            0.0
        };
        ((height - low) * scale + 0.5) as u16
    }
}

/// Makes a map of finished planes; see [`Scale::new`].
pub fn map(kind: MapKind, planes: &Planes, materials: &[Material], shininess: f64) -> Map {
    let scale = Scale::new(planes, materials, shininess);
    rows(kind, planes, &scale, 0..planes.side)
}

/// Makes these rows of a map of finished planes.
pub fn rows(kind: MapKind, planes: &Planes, scale: &Scale, rows: Range<usize>) -> Map {
    let at = rows.start * planes.side..rows.end * planes.side;
    let heights = &planes.bump[at.clone()];
    let mut map = kind.empty(planes.side);
    let bytes = &mut map.bytes;
    match kind {
        MapKind::Height => bytes.extend(heights.iter().flat_map(|&h| scale.grey(h).to_be_bytes())),
        MapKind::NormalOpengl => normals(planes, -1.0, rows, bytes),
        MapKind::NormalDirectx => normals(planes, 1.0, rows, bytes),
        MapKind::Albedo => bytes.extend_from_slice(planes.colour[at].as_flattened()),
        MapKind::Roughness => bytes.extend(planes.material[at].iter().map(|&k| scale.rough(k))),
        MapKind::Occlusion => bytes.extend_from_slice(&planes.occlusion[at]),
        MapKind::Id => bytes.extend(ids(&planes.id[at])),
        MapKind::Orm => {
            let pixels = planes.occlusion[at.clone()]
                .iter()
                .zip(&planes.material[at]);
            bytes.extend(pixels.flat_map(|(&open, &k)| [open, scale.rough(k), 0]));
        }
        MapKind::HeightFloat => {
            let unit = planes.pixel_scale as f32 / planes.side as f32;
            bytes.extend(heights.iter().flat_map(|h| (h * unit).to_be_bytes()));
        }
    }
    map
}

/// Red, green and blue of these ids.
pub(crate) fn ids(ids: &[u32]) -> impl Iterator<Item = u8> {
    ids.iter().flat_map(|&id| id_colour(id))
}

/// Normals of some rows. `green` is the direction of green: 1 down the picture, -1 up.
fn normals(planes: &Planes, green: f32, rows: Range<usize>, to: &mut Vec<u8>) {
    let mut slopes = [vec![0.0; planes.side], vec![0.0; planes.side]];
    for y in rows {
        row_slopes(planes, y, &mut slopes);
        for (&across, &down) in slopes[0].iter().zip(&slopes[1]) {
            let upright = 1.0 / (1.0 + across * across + down * down).sqrt();
            let normal = [-across * upright, -green * down * upright, upright];
            to.extend(normal.map(|v| byte(127.5 + 127.5 * v)));
        }
    }
}

fn byte(v: f32) -> u8 {
    (v + 0.5) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Planes that rise by 1 for a pixel to the right and by 2 for one down.
    fn slope() -> Planes {
        let mut planes = Planes::new(8);
        for at in 0..64 {
            planes.bump[at] = (at % 8 + 2 * (at / 8)) as f32;
            planes.material[at] = (at % 2) as u8;
        }
        planes
    }

    fn made(kind: MapKind) -> Map {
        let exponent = |shininess| Material::new(1.0, 1.0, 0.0, shininess);
        map(kind, &slope(), &[exponent(0.0), exponent(15.0)], 2.0)
    }

    #[test]
    fn normals_lean_against_the_slope() {
        let upright = 1.0 / 6.0f32.sqrt();
        let wanted = |green: f32| {
            [-upright, green * 2.0 * upright, upright].map(|v| (128.0 + 127.5 * v) as u8)
        };
        for (kind, green) in [(MapKind::NormalOpengl, 1.0), (MapKind::NormalDirectx, -1.0)] {
            assert_eq!(made(kind).bytes[3 * 27..][..3], wanted(green), "{kind:?}");
        }
    }

    #[test]
    fn heights_use_all_of_16_bits() {
        let map = made(MapKind::Height);
        assert_eq!((map.channels, map.bits, map.bytes.len()), (1, 16, 128));
        assert_eq!(
            (&map.bytes[..2], &map.bytes[126..]),
            (&[0, 0][..], &[255, 255][..])
        );
    }

    #[test]
    fn shinier_is_less_rough() {
        assert_eq!(made(MapKind::Roughness).bytes[..2], [255, 128]);
        assert!((0..200).all(|n| roughness(n.into()) > roughness((n + 1).into())));
    }

    #[test]
    fn packed_maps_have_the_single_ones() {
        let [rough, light] = [MapKind::Roughness, MapKind::Occlusion].map(|kind| made(kind).bytes);
        let orm = made(MapKind::Orm);
        let mask = orm.mask().bytes;
        for k in 0..64 {
            assert_eq!(orm.bytes[3 * k..][..3], [light[k], rough[k], 0]);
            assert_eq!(mask[4 * k..][..4], [0, light[k], 0, 255 - rough[k]]);
        }
        let float = made(MapKind::HeightFloat).bytes[4 * 9..][..4].try_into();
        assert_eq!(f32::from_be_bytes(float.unwrap()), 3.0 / 8.0);
    }

    #[test]
    fn ids_have_colours_of_their_own() {
        let mut seen = vec![false; 1 << 24];
        for id in 0..1 << 24 {
            let [r, g, b] = id_colour(id).map(usize::from);
            let place = &mut seen[r << 16 | g << 8 | b];
            assert!(!std::mem::replace(place, true), "{id}");
        }
        let far = |a: u32, b: u32| {
            let (a, b) = (id_colour(a), id_colour(b));
            (0..3).map(|k| a[k].abs_diff(b[k])).max()
        };
        assert!((0..5000).all(|id| (1..4).all(|step| far(id, id + step) > Some(16))));
    }
}
