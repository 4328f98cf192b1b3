//! A pavement or a hide as a scene: its stones as bodies on a block of ground, for [`crate::scene`].
//!
//! Each stone is the closed surface that exported files have, at several levels of detail, with the planes as
//! its finish. The ground is a block with the picture's top, cut off straight at its edges. Stones that reach over the
//! picture's edge are whole, and the block is wide enough to hold their feet.

use super::block::{cut_off, widened};
use super::bump_map::BumpMap;
use super::sheet::GroundSheet;
use super::{GROUND, Planes, Surfaces, TextureParams};
use crate::cells::Cell;
use crate::order::{greater, lesser};
use crate::scene::{Body, Instance, Place, Scene};
use crate::solid::{Solids, Surface, finest, joint_depth, levels, top};
use glam::Vec3;

/// Fewest and most triangles of a stone at the finest level.
const EACH: [usize; 2] = [150, 1500];
/// The fewest triangles of a stone at its coarsest level: with fewer it is not recognisable.
const LEAST: usize = 28;
/// Squares along a side of the ground at each level, finest first.
const SQUARES: [usize; 3] = [192, 96, 48];
/// Pixels of the planes copied in one slice.
const PIXELS: usize = 65_536;
/// Depth of the block below the base of the stones, in sides of the picture.
const THICK: f32 = 0.035;
/// On a tile, a stone's image at the opposite edge is shown if at least this share of its extent, along both sides,
/// lies in the picture.
const INSIDE: f32 = 0.35;
/// The most by which the block is wider than the picture at each edge, and the bare rim beyond the outermost stone, in
/// sides of the picture.
const WIDEST: f32 = 0.2;
const BARE: f32 = 0.012;
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
    /// How far stones reach over the picture's edge, in sides of the picture.
    over: f32,
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
            over: 0.0,
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
        let extent = extent(&levels[0].positions);
        let number = self.scene.bodies.len() as u32;
        self.scene.bodies.push(Body::new(levels, material));
        for [x, z] in images(extent, self.params.tile) {
            self.over = greater(self.over, over(extent, [x, z]));
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
        let side = self.params.side as f32;
        let mut squares = squares;
        if self.over > 0.0 {
            sheet = widened(&sheet, squares, lesser(self.over + BARE, WIDEST) * side);
            squares += 4;
        }
        cut_off(&mut sheet, squares, THICK * side);
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

/// The extent of a body along the picture's two sides, each from the least to the greatest.
fn extent(positions: &[Vec3]) -> [[f32; 2]; 2] {
    let none = [f32::MAX, f32::MIN];
    positions.iter().fold([none; 2], |[x, z], p| {
        let grown = |[low, high]: [f32; 2], v: f32| [lesser(low, v), greater(high, v)];
        [grown(x, p.x), grown(z, p.z)]
    })
}

/// How far a body, moved by this much, reaches over the picture's edge.
fn over(extent: [[f32; 2]; 2], by: [f32; 2]) -> f32 {
    let beyond = |([low, high], by): ([f32; 2], f32)| greater(-(low + by), high + by) - 0.5;
    let [x, z] = [0, 1].map(|k| beyond((extent[k], by[k])));
    greater(greater(x, z), 0.0)
}

/// The positions of a body's images that lie in the picture of a tile; the first is the body itself.
fn images(extent: [[f32; 2]; 2], tile: bool) -> Vec<[f32; 2]> {
    let mut images = vec![[0.0, 0.0]];
    if !tile {
        return images;
    }
    for k in (0..9).filter(|&k| k != 4) {
        let to = [(k % 3 - 1) as f32, (k / 3 - 1) as f32];
        let is_in = |axis: usize| {
            let [low, high] = extent[axis].map(|v| v + to[axis]);
            lesser(high, 0.5) - greater(low, -0.5) >= INSIDE * (high - low)
        };
        if is_in(0) && is_in(1) {
            images.push(to);
        }
    }
    images
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
        // The volume by the divergence theorem, in the picture's axes, which are left-handed.
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
        let about = |x: f32, z: f32| [[x - 0.05, x + 0.05], [z - 0.05, z + 0.05]];
        let edge = about(0.49, 0.0);
        assert_eq!(images(edge, false), [[0.0, 0.0]]);
        assert_eq!(images(edge, true), [[0.0, 0.0], [-1.0, 0.0]]);
        assert_eq!(images(about(-0.49, 0.49), true).len(), 4);
        // Less than a third of the stone would lie in the picture.
        assert_eq!(images(about(0.46, 0.0), true), [[0.0, 0.0]]);
        assert!((over(edge, [0.0; 2]) - 0.04).abs() < 1e-6);
        assert!((over(edge, [-1.0, 0.0]) - 0.06).abs() < 1e-6);
        assert_eq!(over(about(0.3, -0.2), [0.0; 2]), 0.0);
    }

    #[test]
    fn a_wider_block_has_a_plain_rim() {
        let mut planes = Planes::new(20);
        planes.bump.fill(3.0);
        let sheet = ground(&planes, 5);
        let mut rimmed = widened(&sheet, 5, 2.0);
        let places: Vec<Vec3> = rimmed
            .positions
            .iter()
            .map(|p| Vec3::new(p.x, p.z, p.y))
            .collect();
        assert_eq!(super::extent(&places), [[-2.0, 22.0]; 2]);
        let area = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|k| rimmed.positions[k as usize]);
            0.5 * (b - a).cross(c - a).length()
        };
        assert!((rimmed.triangles.iter().map(area).sum::<f32>() - 24.0 * 24.0).abs() < 0.01);
        assert!(rimmed.triangles.iter().all(|t| area(t) > 0.0));
        cut_off(&mut rimmed, 9, 1.0);
        assert_eq!(rimmed.fault(), None);
    }
}
