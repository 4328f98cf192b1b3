//! Makes the surfaces of a cell's stone, bent and coloured.

use super::look::{Look, Own, bytes};
use super::template::{SharedLevels, StoneLevel, Templates};
use super::{StonesParams, UnfoldedCell, mean_size};
use crate::heightfield::{Surfaces, TextureParams};
use crate::material::{Coat, StoneTexture};
use crate::order::{greater, lesser};
use crate::solid::{StoneKind, StoneParams, Surface, normals, top};
use crate::surface_cells::SurfaceCell;
use crate::trimesh::TangentFrame;
use glam::{DVec3, Vec3};
use std::rc::Rc;

/// Makes stones on a surface.
pub(super) struct Maker {
    pub look: Look,
    templates: Templates,
    unit: f64,
}

/// A stone on its cell.
pub(super) struct Made {
    pub own: Own,
    /// Levels of detail, the finest first. Positions are relative to the cell's centre, in the model's axes and
    /// units. Triangles run counter-clockwise seen from outside.
    pub levels: Vec<Surface>,
    /// The row of the material at the middle of its top.
    pub material: u8,
}

/// A stone in the tangent plane of its cell.
pub(super) struct FlatStone {
    /// The plane, with the map back onto the surface.
    pub flat: UnfoldedCell,
    params: StoneParams,
    face: StoneTexture,
    /// All vertices in picture units, with a closed base; without normals and colours.
    pub surface: Surface,
    /// The triangles without those of the base.
    pub walls: Rc<[[u32; 3]]>,
    /// The levels of detail.
    pub template: Rc<SharedLevels>,
}

impl Maker {
    /// Starts; `most` is about the number of triangles of a stone at its finest level.
    pub fn new(params: &StonesParams, cells: &[SurfaceCell], most: usize) -> Self {
        let texture = params.texture;
        let curvature = mean_curvature(cells) / params.unit;
        Self {
            look: Look::new(texture, params.weather, Surfaces::new(texture, most)),
            templates: Templates::new(texture.stone, most, curvature, texture.level() as f32),
            unit: params.unit,
        }
    }

    /// Makes the stone of a cell with a coat. `leans_out` tells whether a scale would stand out over a border, see
    /// [`leans_out`]. Nothing if the cell has next to no area. [`Look::advance`] has to be finished before.
    pub fn stone(&mut self, cell: &SurfaceCell, coat: Coat, leans_out: bool) -> Option<Made> {
        let FlatStone {
            flat,
            params,
            face,
            mut surface,
            walls,
            template,
        } = self.flat_stone(cell, coat, leans_out)?;
        let own = Own::new(&flat, face);
        let up = flat.axes[2].y as f32;
        self.colour(&mut surface, &own, template.levels.first()?, up);
        let middle = Vec3::new(0.0, 0.0, top(&params, flat.cell.size) as f32);
        let material = self.look.bare(&own, middle, up).material;
        bend(&mut surface, &flat, &walls);
        let levels = template.levels.iter();
        let levels = levels.map(|level| level_of(&surface, level, flat.axes[2]));
        Some(Made {
            own,
            levels: levels.collect(),
            material,
        })
    }

    /// Colours the vertices of the finest level, and gives them the height of their relief. Coarser levels use some of
    /// them.
    fn colour(&self, surface: &mut Surface, own: &Own, finest: &StoneLevel, up: f32) {
        for v in finest.kept.iter().map(|&v| v as usize) {
            let p = &mut surface.positions[v];
            let seen = self.look.bare(own, *p, up);
            surface.colours[v] = bytes(seen.colour);
            p.z = greater(seen.height, p.z.min(self.look.level));
        }
    }
}

impl Maker {
    /// Makes the stone of a cell in the tangent plane, with its relief, and fits the map back to it.
    pub fn flat_stone(
        &mut self,
        cell: &SurfaceCell,
        coat: Coat,
        leans_out: bool,
    ) -> Option<FlatStone> {
        let mut flat = UnfoldedCell::new(cell, self.unit);
        let texture = self.look.texture;
        let params = own_params(&texture.stone, leans_out);
        let is_hollow = flat.bend.is_hollow();
        let (solid, template) = self.templates.solid(&flat.cell, &params, is_hollow)?;
        let face = self.look.face(&flat.cell, coat);
        let mut surface = Surface {
            colours: vec![[0; 3]; solid.vertices.len()],
            positions: solid.vertices,
            triangles: solid.triangles.to_vec(),
            ..Surface::default()
        };
        self.look.surfaces.roughen(&face, &mut surface.positions);
        surface.cap(&template.boundary);
        let none = [f32::MAX, f32::MIN];
        let span = surface.positions.iter().fold(none, |[low, high], p| {
            [lesser(low, p.z), greater(high, p.z)]
        });
        flat.bend
            .stand(anchor(&texture, flat.cell.size), span.map(f64::from));
        Some(FlatStone {
            flat,
            params,
            face,
            surface,
            walls: solid.triangles,
            template,
        })
    }
}

/// Bends a flat stone onto the surface, and gives it normals.
fn bend(surface: &mut Surface, flat: &UnfoldedCell, walls: &[[u32; 3]]) {
    for p in &mut surface.positions {
        *p = flat.placed(p.as_dvec3()).as_vec3();
    }
    // The axes are left-handed, so triangles run the other way round. Take normals without the cap, which would
    // bend the normals of the walls.
    let turned: Vec<[u32; 3]> = walls.iter().map(|&[a, b, c]| [a, c, b]).collect();
    surface.normals = normals(&surface.positions, &turned);
}

/// A level of detail of a bent stone. `out` is the direction away from the ground.
fn level_of(bent: &Surface, level: &StoneLevel, out: DVec3) -> Surface {
    let kept = level.kept.iter().map(|&v| v as usize);
    let mut surface = Surface {
        positions: kept.clone().map(|v| bent.positions[v]).collect(),
        normals: kept.clone().map(|v| bent.normals[v]).collect(),
        colours: kept.map(|v| bent.colours[v]).collect(),
        triangles: level.triangles.iter().map(|&[a, b, c]| [a, c, b]).collect(),
    };
    under(&mut surface, out);
    surface
}

/// Sets the normal of the cap's middle, which belongs to no wall, so that it points inwards.
fn under(surface: &mut Surface, out: DVec3) {
    for normal in &mut surface.normals {
        if *normal == Vec3::NEG_Z {
            *normal = -out.as_vec3();
        }
    }
}

/// The height of stones that lies on the surface. For stones it is their top, so that joints are as wide as in the
/// plane. For skin it is the ground, and scales stand out from the body.
pub(super) fn anchor(texture: &TextureParams, size: f64) -> f64 {
    match texture.stone.kind {
        StoneKind::Skin => texture.level(),
        _ => top(&texture.stone, size),
    }
}

/// The depth of the ground below the surface, in picture units.
pub(super) fn sunk(texture: &TextureParams) -> f64 {
    anchor(texture, texture.size) - texture.level()
}

/// Whether a cell on the border points away from its neighbours. `neighbours` are indices into `cells`.
pub(super) fn leans_out(cell: &SurfaceCell, neighbours: &[u32], cells: &[SurfaceCell]) -> bool {
    let towards = |&k: &u32| (cells[k as usize].centre.at - cell.centre.at).normalize_or_zero();
    let inwards: DVec3 = neighbours.iter().map(towards).sum();
    let inwards = TangentFrame::of(cell.centre.normal).within(inwards);
    cell.on_border && cell.axis.dot(inwards) <= 0.3 * inwards.length()
}

/// The parameters for one cell: scales that would stand out over a border lie flat.
pub(super) fn own_params(stone: &StoneParams, leans_out: bool) -> StoneParams {
    let mut own = *stone;
    if leans_out && stone.kind == StoneKind::Skin {
        own.skin = own.skin.upright();
        own.scale = own.scale.min(1.0);
    }
    own
}

/// The mean curvature of cells, without sign, in the model's units: the angle by which normals turn from centres to
/// corners over the distance.
fn mean_curvature(cells: &[SurfaceCell]) -> f64 {
    let (mut turned, mut away) = (0.0, 0.0);
    for cell in cells {
        for (&p, n) in cell.ring.iter().zip(&cell.normals) {
            let (n, own) = (*n, cell.centre.normal);
            turned += libm::atan2(n.cross(own).length(), n.dot(own));
            away += (p - cell.centre.at).length();
        }
    }
    if mean_size(cells) > 0.0 && away > 0.0 {
        turned / away
    } else {
        0.0
    }
}
