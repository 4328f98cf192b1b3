//! Maps a surface's axes and units to those of mesh files.

#[cfg(house)]
use super::chart::Chart;
use glam::Vec3;

/// The axes and units of a surface.
pub(super) enum ExportSpace {
    /// x, y down and height, in picture units; `unit` is the length of a picture unit in the file.
    Picture { unit: f32 },
    /// Coordinates of a model, unchanged; a chart gives texture coordinates.
    #[cfg(house)]
    Model(Option<Chart>),
}

impl ExportSpace {
    pub fn place(&self, p: Vec3) -> [f32; 3] {
        match *self {
            Self::Picture { unit } => [p.x * unit - 0.5, p.z * unit, p.y * unit - 0.5],
            #[cfg(house)]
            Self::Model(_) => p.to_array(),
        }
    }

    /// The place in the maps, from the upper left corner to the right and down, 0..1 in the picture; on a model, the
    /// place in the chart.
    pub fn place_in_maps(&self, p: Vec3) -> Option<[f32; 2]> {
        match *self {
            Self::Picture { unit } => Some([p.x * unit, p.y * unit]),
            #[cfg(house)]
            Self::Model(chart) => chart.map(|chart| chart.of(p)),
        }
    }

    pub fn has_maps(&self) -> bool {
        self.place_in_maps(Vec3::ZERO).is_some()
    }

    pub fn direction(&self, n: Vec3) -> [f32; 3] {
        match self {
            Self::Picture { .. } => [n.x, n.z, n.y],
            #[cfg(house)]
            Self::Model(_) => n.to_array(),
        }
    }

    /// The file's order of a triangle's corners. Exchanging two axes mirrors; the result is counter-clockwise seen
    /// from outside.
    pub fn turned(&self, [a, b, c]: [u32; 3]) -> [u32; 3] {
        match self {
            Self::Picture { .. } => [a, c, b],
            #[cfg(house)]
            Self::Model(_) => [a, b, c],
        }
    }
}
