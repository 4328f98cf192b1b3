//! The making of a stone, step by step: after the steps of [`crate::solid::steps`], those that need the
//! planes.
//!
//! Stones: Miyata, Itoh, Shimada (2000), section 5.3 and fig. 12. Fractal noise exists on a grid of its own;
//! the stone's shape seen from above masks it, and the masked noise is added to the stone's height. The steps
//! show a sheet of noise around the stone with the mask's outline, then the masked part of the sheet, then
//! the finished stone with it, in the colours of section 5.4.
//!
//! Skin: Itoh, Miyata, Shimada (2003), section 6.3 and figs. 12 and 13. Its noise is part of the solid, and
//! scales overlap. So the mask is the visible part of the scale, at the heights of the planes.
//!
//! A square of the sheet is a pixel of the planes, or several pixels where there would be too many squares.

use super::{Planes, Surfaces};
use crate::cells::Cell;
use crate::material::Coat;
use crate::order::{greater, lesser};
use crate::solid::{Making, PLAIN, Solids, Step, StoneKind, Surface, control_mesh, normals};
use crate::solid::{step, steps, used};
use glam::{DVec2, Vec3};

/// Most squares along a side of a sheet.
const MOST_SQUARES: f64 = 128.0;
/// The side of a sheet, relative to the longer side of the box around the cell and its stone.
const SHEET: f64 = 1.12;
/// Thickness of a sheet of noise at its lowest point, relative to its side.
const THICK: f32 = 0.03;

impl Surfaces {
    /// All steps in the making of a cell's stone, in order; empty if the cell has no appreciable area.
    pub fn making(&self, cell: &Cell) -> Vec<Making> {
        let stone = &self.params.stone;
        let mut steps = steps(cell, stone);
        if !steps.is_empty() {
            if stone.kind != StoneKind::Skin {
                steps.push(Making::Noise);
            }
            steps.extend([Making::Mask, Making::Finish]);
        }
        steps
    }

    /// One of the steps of [`Surfaces::making`]; `None` if the cell has no such step. `index` is the cell's index in
    /// the list that the planes were painted from, and `solids` caches the stencils. A mask is empty if nothing of the
    /// stone is visible. The finished stone has at most as many triangles as these surfaces are made for.
    pub fn step(
        &self,
        solids: &mut Solids,
        (cell, index): (&Cell, usize),
        planes: &Planes,
        making: Making,
    ) -> Option<Step> {
        let steps = self.making(cell);
        if !steps.contains(&making) {
            return None;
        }
        let stone = &self.params.stone;
        let is_skin = stone.kind == StoneKind::Skin;
        let (surface, edges) = match making {
            Making::Noise if !is_skin => {
                let sheet = Sheet::new(self, cell, index, planes)?;
                (sheet.body(&vec![true; sheet.own.len()]), sheet.outline())
            }
            Making::Mask => {
                let sheet = Sheet::new(self, cell, index, planes)?;
                (sheet.body(&sheet.own), sheet.outline())
            }
            Making::Finish => {
                let level = steps.iter().filter_map(|step| step.level()).max()?;
                let solid = solids.solid_of_level(cell, stone, level);
                (self.close(&solid, cell, index, planes), Vec::new())
            }
            _ => return step(solids, cell, stone, making),
        };
        Some(Step {
            making,
            surface,
            edges,
        })
    }
}

/// A square grid of heights around a stone, aligned with the planes' rows and columns.
struct Sheet {
    /// Squares along a side.
    side: usize,
    /// For each square, row by row, whether the stone is visible there.
    own: Vec<bool>,
    /// The grid's points, one more along a side than squares.
    points: Vec<Vec3>,
}

impl Sheet {
    /// `None` if the cell has no appreciable area.
    fn new(surfaces: &Surfaces, cell: &Cell, index: usize, planes: &Planes) -> Option<Self> {
        let mesh = control_mesh(cell, &surfaces.params.stone)?;
        let (mut low, mut high) = (DVec2::MAX, DVec2::MIN);
        // Loop's scheme stays within the bounding box of the control mesh.
        let stone = mesh.vertices.iter().map(|v| v.truncate().as_dvec2());
        for p in stone.chain(cell.ring.iter().copied()) {
            (low, high) = (low.min(p), high.max(p));
        }
        let scale = planes.pixel_scale.max(1) as f64;
        let pixels = SHEET * (high - low).max_element() * scale;
        let each = (pixels / MOST_SQUARES).ceil().max(1.0);
        let side = (pixels / each).ceil() as usize + 1;
        let from = (low + high) * (0.5 * scale) - 0.5 * each * side as f64;
        let [left, up, each] = [from.x, from.y, each].map(|v| v.floor() as i32);
        let pixel = |[i, j]: [usize; 2]| [left + each * i as i32, up + each * j as i32];
        let middle = |at| pixel(at).map(|v| v + each / 2);
        let heights: Vec<Option<f32>> = places(side)
            .map(|at| height_of(index as u32 + 1, planes, middle(at)))
            .collect();
        let point = |at| {
            let [x, y] = pixel(at).map(|v| v as f32 / scale as f32);
            Vec3::new(x, y, 0.0)
        };
        let mut sheet = Self {
            side,
            own: heights.iter().map(Option::is_some).collect(),
            points: places(side + 1).map(point).collect(),
        };
        match surfaces.params.stone.kind {
            StoneKind::Skin => sheet.rise_to(&heights),
            _ => sheet.rise_by_relief(surfaces, cell),
        }
        Some(sheet)
    }

    /// Each point takes the mean height of the squares around it.
    fn rise_to(&mut self, heights: &[Option<f32>]) {
        let mut sums = vec![(0.0, 0.0); self.points.len()];
        for (square, height) in heights.iter().enumerate() {
            for k in self.corners(square) {
                sums[k].0 += height.unwrap_or(0.0);
                sums[k].1 += f32::from(u8::from(height.is_some()));
            }
        }
        for (point, (sum, count)) in self.points.iter_mut().zip(sums) {
            point.z = greater(sum / greater(count, 1.0), 0.0);
        }
    }

    /// Sets heights to the relief alone, over a bottom thick enough to leave no hole.
    fn rise_by_relief(&mut self, surfaces: &Surfaces, cell: &Cell) {
        let face = surfaces.params.face(cell, Coat::default());
        let mut lowest = f32::MAX;
        for point in &mut self.points {
            point.z = surfaces.relief(&face, point.x - 0.5, point.y - 0.5);
            lowest = lesser(lowest, point.z);
        }
        let bottom = THICK * (self.points[self.side].x - self.points[0].x);
        self.points.iter_mut().for_each(|p| p.z += bottom - lowest);
    }

    /// The corners of a square, clockwise on screen from the upper left.
    fn corners(&self, square: usize) -> [usize; 4] {
        let upper = square + square / self.side;
        let lower = upper + self.side + 1;
        [upper, upper + 1, lower + 1, lower]
    }

    /// The sides between squares in `part` and others, clockwise on screen.
    fn borders(&self, part: &[bool]) -> Vec<[usize; 2]> {
        let n = self.side;
        let mut borders = Vec::new();
        for square in (0..part.len()).filter(|&k| part[k]) {
            let [a, b, c, d] = self.corners(square);
            let (i, j) = (square % n, square / n);
            for (is_open, side) in [
                (j == 0 || !part[square - n], [a, b]),
                (i == n - 1 || !part[square + 1], [b, c]),
                (j == n - 1 || !part[square + n], [c, d]),
                (i == 0 || !part[square - 1], [d, a]),
            ] {
                if is_open {
                    borders.push(side);
                }
            }
        }
        borders
    }

    /// The outline of the mask, on the sheet.
    fn outline(&self) -> Vec<[Vec3; 2]> {
        let line = |ends: [usize; 2]| ends.map(|k| self.points[k]);
        self.borders(&self.own).into_iter().map(line).collect()
    }

    /// The squares in `part` as a body: the sheet on top, walls around it, and the base level below.
    fn body(&self, part: &[bool]) -> Surface {
        let squares = || (0..part.len()).filter(|&k| part[k]);
        let top = squares().flat_map(|square| {
            let [a, b, c, d] = self.corners(square).map(|k| k as u32);
            [[a, b, c], [a, c, d]]
        });
        let (kept, triangles) = used(&top.collect::<Vec<_>>(), self.points.len());
        let positions: Vec<Vec3> = kept.iter().map(|&k| self.points[k as usize]).collect();
        let mut surface = Surface {
            normals: normals(&positions, &triangles),
            positions,
            triangles,
            ..Surface::default()
        };
        let base = |k: usize| self.points[k].with_z(0.0);
        for square in squares() {
            let [a, b, c, d] = self.corners(square).map(base);
            surface.add_square([a, d, c, b], Vec3::NEG_Z);
        }
        for [a, b] in self.borders(part) {
            let along = base(b) - base(a);
            let out = Vec3::new(along.y, -along.x, 0.0).normalize_or(Vec3::NEG_Z);
            surface.add_square([base(a), base(b), self.points[b], self.points[a]], out);
        }
        surface.colours = vec![PLAIN; surface.positions.len()];
        surface
    }
}

impl Surface {
    /// Adds a flat square; corners run clockwise on screen, seen from the side its normal points to.
    fn add_square(&mut self, corners: [Vec3; 4], normal: Vec3) {
        let first = self.positions.len() as u32;
        self.positions.extend(corners);
        self.normals.extend([normal; 4]);
        let of_first = |k: u32| [first, first + k, first + k + 1];
        self.triangles.extend([1, 2].map(of_first));
    }
}

/// Column and row of each cell of a square grid, row by row.
fn places(side: usize) -> impl Iterator<Item = [usize; 2]> {
    (0..side * side).map(move |k| [k % side, k / side])
}

/// The height of the planes at a pixel, on a tile also outside the picture, if the stone `id` is visible
/// there.
fn height_of(id: u32, planes: &Planes, mut pixel: [i32; 2]) -> Option<f32> {
    let side = planes.side as i32;
    if planes.tile {
        pixel = pixel.map(|v| v.rem_euclid(side));
    }
    let [x, y] = pixel;
    let inside = (0..side).contains(&x) && (0..side).contains(&y);
    let at = inside.then_some((y * side + x) as usize)?;
    (planes.id.get(at) == Some(&id)).then(|| planes.bump[at])
}
