//! A scene of stones on a surface, in slices.

use super::claws::{Claw, HORN_ROW};
use super::fit::Fit;
use super::ground::{Bed, GroundMaking, GroundSlice};
use super::look::{Look, Own};
use super::maker::Maker;
use super::{Paving, StonesParams, mean_size};
use crate::heightfield::GROUND;
use crate::material::{GROUND_ROW, GrainStrength, NearGrain};
use crate::order::{greater, lesser};
use crate::scene::{Body, Detail, Instance, Place, Scene, Surfel};
use crate::solid::{Surface, finest};
use crate::surface_cells::SurfaceCell;
use crate::trimesh::TriMesh;
use glam::Vec3;

/// The least and the most triangles of a stone at its finest level.
const EACH: [usize; 2] = [70, 1000];
/// Rows of the bed in a slice.
const ROWS: usize = 64;
/// The reach of a stone's ambient occlusion, in sizes of a stone.
const REACH: f64 = 0.5;
/// Picture units under a pixel from which grain begins to fade, and at which it is gone; beyond that it would only
/// sparkle.
const FADES: [f32; 2] = [1.2, 4.0];
/// The steepest slope of the relief.
const STEEPEST: f32 = 1.6;

/// A scene that is being made.
pub struct Stones {
    params: StonesParams,
    maker: Maker,
    scene: Scene,
    owns: Vec<Option<Own>>,
    cell: usize,
    size: f64,
    ground: Option<GroundMaking>,
    fit: Fit,
}

/// About the number of triangles of a stone at its finest level, among this number of cells.
pub(super) fn most_triangles(cells: usize) -> usize {
    finest(cells, EACH)
}

impl Stones {
    /// Starts with cells whose axes agree already ([`super::make_one_sense`]). The mesh need not be that of the
    /// packing; a coarser mesh will do.
    pub fn new(params: StonesParams, mesh: &TriMesh, cells: &[SurfaceCell]) -> Self {
        let most = most_triangles(cells.len());
        let (fit, size) = (Fit::new(mesh), mean_size(cells));
        let deep = params.texture.depth() / params.unit;
        Self {
            maker: Maker::new(&params, cells, most),
            scene: Scene {
                reach: (greater(REACH * size, deep) * fit.scale) as f32,
                ..Scene::default()
            },
            owns: Vec::with_capacity(cells.len()),
            cell: 0,
            size,
            ground: None,
            fit,
            params,
        }
    }

    /// The share of the work that is done, 0 to 1.
    pub fn progress(&self, cells: &[SurfaceCell]) -> f64 {
        let stones = self.cell as f64 / cells.len().max(1) as f64;
        let ground = self.ground.as_ref().map_or(0.0, GroundMaking::progress);
        0.85 * stones + 0.15 * ground
    }

    /// Adds the next stone or, after the last one, a part of the ground; true when all is there. Mesh and paving must
    /// be the same each time.
    pub fn advance(&mut self, mesh: &TriMesh, paving: Paving) -> bool {
        if !self.maker.look.advance(ROWS) {
            return false;
        }
        if self.cell < paving.cells.len() {
            self.add(paving);
            self.cell += 1;
            return false;
        }
        let colour = self.maker.look.ground_colour();
        let bed = || Bed::new(&self.params, mesh, self.size, colour);
        let ground = self.ground.get_or_insert_with(GroundMaking::default);
        let levels = match ground.next(mesh, bed) {
            GroundSlice::More => return false,
            GroundSlice::Part(levels) => levels,
            GroundSlice::End => {
                self.add_claws(paving.claws);
                return true;
            }
        };
        let levels = levels.iter().map(|level| self.on_stand(level)).collect();
        self.push(Body::new(levels, GROUND_ROW), Vec3::ZERO, GROUND);
        false
    }

    /// The finished scene.
    pub fn finish(self) -> Scene {
        let texture = self.maker.look.texture;
        let finish = StoneDetail {
            look: self.maker.look,
            owns: self.owns,
            fit: self.fit,
            unit: self.params.unit,
            grain: NearGrain::new(texture.seed),
            strengths: [false, true].map(|is_stone| texture.near_grain(is_stone)),
        };
        Scene {
            detail: Some(Box::new(finish)),
            ..self.scene
        }
    }

    fn add(&mut self, paving: Paving) {
        let cell = &paving.cells[self.cell];
        let Some(made) = paving.stone(&mut self.maker, self.cell) else {
            self.owns.push(None);
            return;
        };
        let scale = self.fit.scale as f32;
        let mut levels = made.levels;
        for p in levels.iter_mut().flat_map(|level| &mut level.positions) {
            *p *= scale;
        }
        self.owns.push(Some(made.own));
        let origin = self.fit.place(cell.centre.at);
        let id = self.cell as u32 + 1;
        self.push(Body::new(levels, made.material), origin, id);
    }

    fn add_claws(&mut self, claws: &[Claw]) {
        for claw in claws {
            let surface = claw.placed(self.maker.look.palette, |p| self.fit.place(p));
            self.push(Body::new(vec![surface], HORN_ROW), Vec3::ZERO, GROUND);
        }
    }

    fn push(&mut self, body: Body, origin: Vec3, id: u32) {
        self.scene.instances.push(Instance {
            body: self.scene.bodies.len() as u32,
            place: Place::at(origin),
            id,
            paint: None,
        });
        self.scene.bodies.push(body);
    }

    fn on_stand(&self, surface: &Surface) -> Surface {
        let place = |p: &Vec3| self.fit.place(p.as_dvec3());
        Surface {
            positions: surface.positions.iter().map(place).collect(),
            ..surface.clone()
        }
    }
}

/// Colour, material and relief of stones and ground at a pixel.
struct StoneDetail {
    look: Look,
    owns: Vec<Option<Own>>,
    fit: Fit,
    unit: f64,
    grain: NearGrain,
    /// The grain of the ground and of stones.
    strengths: [GrainStrength; 2],
}

impl Detail for StoneDetail {
    fn refine(&self, surfel: &mut Surfel, id: u32, spread: f32) {
        // Picture units, and model units, in a unit of the scene.
        let (unit, model) = (self.unit / self.fit.scale, 1.0 / self.fit.scale);
        let covered = spread * unit as f32;
        let near = ((FADES[1] - covered) / (FADES[1] - FADES[0])).clamp(0.0, 1.0);
        if near <= 0.0 {
            return;
        }
        let own = self.owns.get((id as usize).wrapping_sub(1));
        if id == GROUND && surfel.material == HORN_ROW {
            return;
        }
        let (seen, rise, part) = match own.and_then(Option::as_ref) {
            Some(own) => {
                let at = surfel.position * model as f32 + self.fit.middle.as_vec3() - own.at;
                let (seen, rise) = self.look.of_stone(own, at, surfel.normal);
                (seen, rise, Look::is_top(own, surfel.normal))
            }
            None => {
                let at = surfel.position * unit as f32;
                let (seen, rise) = self.look.of_ground(at, surfel.normal);
                (seen, rise, 1.0)
            }
        };
        for (own, fine) in surfel.colour.iter_mut().zip(seen.colour) {
            *own += (fine - *own) * near;
        }
        surfel.material = seen.material;
        let along = rise - surfel.normal * surfel.normal.dot(rise);
        let steep = along.length();
        let limit = lesser(1.0, STEEPEST / greater(steep, 1e-6));
        let fine = surfel.normal - along * (limit * near * part);
        surfel.normal = fine.normalize_or(surfel.normal);
        let strength = self.strengths[usize::from(id != GROUND)];
        let place = (surfel.position * unit as f32, surfel.normal);
        if let Some(grain) = self.grain.at(place, covered, strength) {
            grain.add_to(&mut surfel.colour, &mut surfel.normal);
        }
    }
}
