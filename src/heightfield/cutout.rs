//! A pavement or a hide as a scene: its stones as bodies on a block of ground, for [`crate::scene`].
//!
//! Each stone is the closed surface that exported files have, at several levels of detail, with the planes as
//! its finish. The ground is a block with the picture's top, cut off straight at its edges.

use super::bump_map::BumpMap;
use super::sheet::GroundSheet;
use super::{GROUND, Planes, Surfaces, TextureParams};
use crate::cells::Cell;
use crate::order::lesser;
use crate::scene::{Body, Instance, Place, Scene};
use crate::solid::{Solids, Surface, finest, joint_depth, levels, top};
use glam::Vec3;

/// Fewest and most triangles of a stone at the finest level.
const EACH: [usize; 2] = [150, 1500];
/// A stone with fewer triangles is not recognisable.
const LEAST: usize = 28;
/// Squares along a side of the ground at each level, finest first.
const SQUARES: [usize; 3] = [192, 96, 48];
/// Pixels of the planes copied in one slice.
const PIXELS: usize = 65_536;
/// Depth of the block below the base of the stones, in sides of the picture.
const THICK: f32 = 0.035;
/// Colour of the cut faces at the top and at the bottom, relative to the mean colour of the ground along the
/// edges.
const CUT: [f32; 2] = [1.0, 0.75];
/// Distance at which a stone occludes others, in sizes of a stone.
const REACH: f64 = 0.5;

/// A scene in progress.
pub struct HeightFieldScene {
    params: TextureParams,
    solids: Solids,
    surfaces: Surfaces,
    /// Triangles of a stone at the finest level.
    most: usize,
    /// For each stone, whether any of it is in the picture.
    is_seen: Vec<bool>,
    scene: Scene,
    cell: usize,
    /// The finished levels of the ground and the current one.
    ground: Vec<Surface>,
    sheet: Option<GroundSheet>,
    relief: Option<BumpMap>,
}

impl HeightFieldScene {
    /// Takes the parameters that the planes were made with, and the number of cells.
    pub fn new(params: TextureParams, cells: usize, planes: &Planes) -> Self {
        let mut is_seen = vec![false; cells];
        for &id in &planes.id {
            if let Some(is_seen) = is_seen.get_mut((id as usize).wrapping_sub(1)) {
                *is_seen = true;
            }
        }
        let most = finest(cells, EACH);
        let side = params.side as f64;
        let deep = joint_depth(&params.stone, params.size);
        let reach = (REACH * params.size).max(deep) / side;
        Self {
            solids: Solids::to_simplify(most),
            surfaces: Surfaces::new(params, most),
            most,
            is_seen,
            scene: Scene {
                reach: reach as f32,
                ..Scene::default()
            },
            cell: 0,
            ground: Vec::new(),
            sheet: None,
            relief: None,
            params,
        }
    }

    /// The progress, 0..1.
    pub fn progress(&self, cells: &[Cell]) -> f64 {
        self.cell as f64 / (cells.len() + 1) as f64
    }

    /// Adds the next stone; after the last one a part of the ground, then a part of the planes. True when
    /// finished. Cells and planes must not change.
    pub fn advance(&mut self, cells: &[Cell], planes: &Planes) -> bool {
        if let Some(cell) = cells.get(self.cell) {
            // A stone beyond the picture's edge has neither colours nor ground.
            if self.is_seen[self.cell] || self.is_within(cell) {
                self.add(cell, planes);
            }
            self.cell += 1;
            return false;
        }
        if let Some(&squares) = SQUARES.get(self.ground.len()) {
            self.advance_ground(planes, squares.min(planes.side));
            return false;
        }
        let relief = self
            .relief
            .get_or_insert_with(|| BumpMap::new(&self.params, planes));
        let is_there = relief.add(planes, PIXELS);
        if is_there && let Some(relief) = self.relief.take() {
            self.scene.detail = Some(Box::new(relief));
        }
        is_there
    }

    /// The finished scene.
    pub fn finish(self) -> Scene {
        self.scene
    }

    fn is_within(&self, cell: &Cell) -> bool {
        let within = 0.0..self.params.side as f64;
        within.contains(&cell.centre.x) && within.contains(&cell.centre.y)
    }

    fn add(&mut self, cell: &Cell, planes: &Planes) {
        let stone = &self.params.stone;
        let solid = self.solids.solid(cell, stone);
        let finest = self.surfaces.close(&solid, cell, self.cell, planes);
        if finest.triangles.is_empty() {
            return;
        }
        let floor = (top(stone, cell.size) - joint_depth(stone, cell.size)) as f32;
        let mut made = vec![finest];
        for most in levels(self.most, LEAST).skip(1) {
            made.push(made[made.len() - 1].coarser(most, floor));
        }
        let levels: Vec<Surface> = made.iter().map(|level| self.upright(level)).collect();
        let material = self.material(cell, planes);
        let body = Body::new(levels, material);
        let (middle, radius) = (body.middle, body.radius);
        let number = self.scene.bodies.len() as u32;
        self.scene.bodies.push(body);
        for [x, z] in images(middle, radius, self.params.tile) {
            self.scene.instances.push(Instance {
                body: number,
                place: Place::at(Vec3::new(x, 0.0, z)),
                id: self.cell as u32 + 1,
                paint: None,
            });
        }
    }

    /// The material at the stone's centre.
    fn material(&self, cell: &Cell, planes: &Planes) -> u8 {
        let side = planes.side as f64;
        let scale = planes.pixel_scale as f64;
        let at = |v: f64| (v * scale).rem_euclid(side).min(side - 1.0) as usize;
        planes.material[at(cell.centre.y) * planes.side + at(cell.centre.x)]
    }

    /// Makes a row of the current level of the ground; the last row completes it.
    fn advance_ground(&mut self, planes: &Planes, squares: usize) {
        let sheet = self.sheet.get_or_insert_with(|| GroundSheet::new(squares));
        if !sheet.advance(planes) {
            return;
        }
        let Some(sheet) = self.sheet.take() else {
            return;
        };
        let mut sheet = sheet.finish(planes);
        cut_off(&mut sheet, squares, THICK * self.params.side as f32);
        self.ground.push(self.upright(&sheet));
        if self.ground.len() < SQUARES.len() {
            return;
        }
        self.scene.instances.push(Instance {
            body: self.scene.bodies.len() as u32,
            place: Place::default(),
            id: GROUND,
            paint: None,
        });
        let body = Body::new(self.ground.clone(), crate::material::GROUND_ROW);
        self.scene.bodies.push(body);
    }

    /// Maps a surface into scene coordinates: the picture's side is 1 and its centre the origin.
    fn upright(&self, surface: &Surface) -> Surface {
        let side = self.params.side as f32;
        surface.upright(|p| p / side - Vec3::new(0.5, 0.0, 0.5))
    }
}

/// The positions of a body's images that reach into the picture of a tile; the first is the body itself.
fn images(middle: Vec3, radius: f32, tile: bool) -> Vec<[f32; 2]> {
    let mut images = vec![[0.0, 0.0]];
    if !tile {
        return images;
    }
    for k in (0..9).filter(|&k| k != 4) {
        let to = [(k % 3 - 1) as f32, (k / 3 - 1) as f32];
        let reaches = |at: f32, by: f32| (at + by).abs() < 0.5 + radius;
        if reaches(middle.x, to[0]) && reaches(middle.z, to[1]) {
            images.push(to);
        }
    }
    images
}

/// Turns a sheet with `n` squares a side into a block: adds walls along its edges and a bottom.
fn cut_off(sheet: &mut Surface, n: usize, thick: f32) {
    let row = n + 1;
    // Clockwise on screen, seen from above, with the wall's normal.
    let sides: [(Vec3, &dyn Fn(usize) -> usize); 4] = [
        (Vec3::NEG_Y, &|k| k),
        (Vec3::X, &|k| k * row + n),
        (Vec3::Y, &|k| n * row + n - k),
        (Vec3::NEG_X, &|k| (n - k) * row),
    ];
    // Each wall has one colour: single grains of sand would make streaks.
    let mut mean = Vec3::ZERO;
    for (_, place) in &sides {
        let colours = (0..n).map(|k| sheet.colours[place(k)]);
        mean += colours.map(|c| Vec3::from(c.map(f32::from))).sum::<Vec3>() / (4 * n) as f32;
    }
    let cut = CUT.map(|part| (mean * part).to_array().map(|v| v as u8));
    for (normal, place) in sides {
        let first = sheet.positions.len() as u32;
        for k in 0..=n {
            let p = sheet.positions[place(k)];
            for (z, colour) in [(p.z, cut[0]), (-thick, cut[1])] {
                sheet.positions.push(Vec3::new(p.x, p.y, lesser(z, p.z)));
                sheet.normals.push(normal);
                sheet.colours.push(colour);
            }
        }
        for k in 0..n as u32 {
            let [a, b, c, d] = [0, 1, 2, 3].map(|v| first + 2 * k + v);
            sheet.triangles.extend([[a, b, c], [b, d, c]]);
        }
    }
    let first = sheet.positions.len() as u32;
    for place in [0, n, n * row, n * row + n] {
        let p = sheet.positions[place];
        sheet.positions.push(Vec3::new(p.x, p.y, -thick));
        sheet.normals.push(Vec3::NEG_Z);
        sheet.colours.push(cut[1]);
    }
    let [a, b, c, d] = [0, 1, 2, 3].map(|v| first + v);
    sheet.triangles.extend([[a, c, b], [b, c, d]]);
}

#[cfg(test)]
mod tests {
    use super::super::ground;
    use super::*;
    use glam::DVec3;

    #[test]
    fn a_block_is_as_large_as_its_sheet() {
        let mut planes = Planes::new(20);
        planes.bump.fill(3.0);
        let mut sheet = ground(&planes, 5);
        cut_off(&mut sheet, 5, 1.0);
        assert_eq!(sheet.fault(), None);
        // By the divergence theorem, in the picture's axes, which are left-handed.
        let six: f64 = sheet
            .triangles
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|k| sheet.positions[k as usize].as_dvec3());
                DVec3::dot(a, b.cross(c))
            })
            .sum();
        assert!((six / 6.0 - 20.0 * 20.0 * 4.0).abs() < 1e-2, "{six}");
    }

    #[test]
    fn images_are_those_that_reach_in() {
        let middle = Vec3::new(0.49, 0.0, 0.0);
        assert_eq!(images(middle, 0.05, false), [[0.0, 0.0]]);
        assert_eq!(images(middle, 0.05, true), [[0.0, 0.0], [-1.0, 0.0]]);
        let corner = Vec3::new(-0.49, 0.0, 0.49);
        assert_eq!(images(corner, 0.05, true).len(), 4);
    }
}
