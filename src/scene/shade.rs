//! Shades visible surfaces.

use super::backdrop::{behind, dithered, end_of_floor, floor_part, left_of_corner};
use super::floor::FloorPlane;
use super::hit::{Facets, PixelHit};
use super::occlusion::Occlusion;
use super::penumbra;
use super::reflection::Reaching;
use super::shadow::ShadowSample;
use super::tile::{BAND, Each, NO_VECTORS, SQUARE, Tile, Vectors, get, set, units};
use super::tile_light::TileSurfels;
use super::visibility::{FLOOR, NOTHING, VisibilityBuffer};
use super::{Backdrop, Lighting, Scene, Surfel, View};
use crate::order::lesser;
use glam::Vec3;

/// Where a body's normal has a greater y than this, the floor's light is too weak for its darkness to matter.
const LEVEL: f32 = 0.9;

/// The thickness of bodies that light goes through, in their radii.
const THICK: f32 = 0.1;

/// The inputs of shading.
#[derive(Clone, Copy)]
pub(super) struct ShadingInputs<'a> {
    pub scene: &'a Scene,
    pub light: &'a Lighting,
    pub sight: &'a VisibilityBuffer,
    pub backdrop: Backdrop,
    pub ground: FloorPlane,
    /// The radius of the part of the lamp that lights this sample's floor, over its distance.
    pub part_of_lamp: f32,
    /// The colour on the screen of the floor where it fades.
    pub far: [f32; 3],
}

/// The state of shading, which goes from the top of a frame to its bottom.
pub(super) struct Shading {
    occlusion: Occlusion,
    has_occlusion: bool,
    facets: Facets,
    /// The surfaces found in two bands of rows: the band to be shaded, and the next one, which its occlusion needs.
    found: Vec<Found>,
    found_rows: usize,
}

impl Shading {
    pub fn new() -> Self {
        Self {
            occlusion: Occlusion::new(),
            has_occlusion: false,
            facets: Facets::new(),
            found: Vec::new(),
            found_rows: 0,
        }
    }

    /// Starts a frame.
    pub fn begin(&mut self, size: [usize; 2], has_occlusion: bool) {
        self.has_occlusion = has_occlusion;
        self.occlusion.begin(size);
        self.found.resize(2 * BAND * size[0], Found::NOTHING);
        self.found_rows = 0;
    }

    /// Makes room for rows of this width up to `rows`. All rows are needed before [`Shading::advance`].
    pub fn make_room(&mut self, width: usize, rows: usize) {
        self.occlusion.make_room(width, rows);
    }

    /// Shades about `rows` rows from row `from` on, which is 0 or the last result; returns the next row. Calls `keep`
    /// with each pixel that shows a body, and its normal.
    pub fn advance(
        &mut self,
        studio: ShadingInputs,
        from: usize,
        rows: usize,
        rgba: &mut [u8],
        mut keep: impl FnMut(usize, Vec3),
    ) -> usize {
        let height = studio.sight.view().size[1];
        // Finding surfaces and shading them take about half of the work each.
        let (mut row, mut left) = (from, 2 * rows);
        while row < height && left > 0 {
            let end = height.min(row + BAND);
            if self.found_rows < height.min(end + BAND) {
                self.find(studio, &mut keep);
            } else {
                if self.has_occlusion {
                    (row..end).for_each(|y| self.occlusion.average(studio.sight, y));
                }
                let width = studio.sight.view().size[0];
                for from in (0..width).step_by(BAND) {
                    self.shade_square(studio, Tile([from, row]), rgba);
                }
                row = end;
            }
            left = left.saturating_sub(BAND);
        }
        row
    }

    /// Finds the surfaces of the next rows.
    fn find(&mut self, studio: ShadingInputs, keep: &mut impl FnMut(usize, Vec3)) {
        let [width, height] = studio.sight.view().size;
        let rows = self.found_rows..height.min(self.found_rows + BAND);
        for from in (0..width).step_by(BAND) {
            self.find_square(studio, Tile([from, rows.start]), keep);
        }
        self.found_rows = rows.end;
        if self.has_occlusion {
            for y in rows {
                let normal = |x: usize| self.found[slot(width, x, y)].normal;
                self.occlusion
                    .look(studio.sight, normal, studio.scene.reach, y);
            }
        }
    }

    /// Finds the surfaces of a tile. Loops that read memory are apart from loops that compute, so that computing never
    /// waits.
    fn find_square(
        &mut self,
        studio: ShadingInputs,
        square: Tile,
        keep: &mut impl FnMut(usize, Vec3),
    ) {
        let ShadingInputs { sight, light, .. } = studio;
        let view = sight.view();
        let width = view.size[0];
        let rays = square.rays(view);
        let points = square.points(sight, &rays);
        let facing = self.meet_rays(studio, square, &rays);
        let mut spots = [ShadowSample::BESIDE; SQUARE];
        for (k, [x, y, at]) in square.pixels(view) {
            let normal = get(&facing.normals, k);
            let is_body = sight.owner[at] < FLOOR;
            keep(at, if is_body { normal } else { Vec3::ZERO });
            let both = [normal, get(&facing.flats, k)];
            let (seen, spot) = studio.spot(at, get(&points, k), both, facing.lifts[k]);
            let found = &mut self.found[slot(width, x, y)];
            (found.normal, found.seen) = (normal, seen);
            spots[k] = spot;
        }
        for (k, [x, y, _]) in square.pixels(view) {
            // Pixels that face away from the lamp have no place in its map.
            self.found[slot(width, x, y)].seen *= light.seen(&spots[k]);
        }
    }

    /// Intersects a tile's rays with the triangles that its pixels show. Stores the colours there.
    #[inline(always)]
    fn meet_rays(&mut self, studio: ShadingInputs, square: Tile, rays: &Vectors) -> TileNormals {
        let ShadingInputs { scene, sight, .. } = studio;
        let view = sight.view();
        self.facets.look_up(scene, sight, square);
        let (mut normals, mut flats, mut lifts) = (NO_VECTORS, NO_VECTORS, [0.0; SQUARE]);
        for (k, [x, y, at]) in square.pixels(view) {
            let met = match sight.owner[at] {
                owner if owner < FLOOR => match sight.cap(at) {
                    Some(normal) => Facets::cap(scene, owner, normal),
                    None => self.facets.met(scene, owner, rays, k),
                },
                _ => PixelHit::FLOOR,
            };
            self.found[slot(view.size[0], x, y)].colour = met.colour;
            set(&mut normals, k, met.normal);
            set(&mut flats, k, met.flat);
            lifts[k] = met.lift;
        }
        TileNormals {
            normals: units(&normals, &flats),
            flats,
            lifts,
        }
    }

    /// Computes the colours of a tile's pixels on the screen.
    fn shade_square(&self, studio: ShadingInputs, square: Tile, rgba: &mut [u8]) {
        let (sight, view) = (studio.sight, studio.sight.view());
        let rays = square.rays(view);
        let points = square.points(sight, &rays);
        let ways = units(&rays, &rays);
        let surfels = self.surfels(studio, square, &points);
        let is_body = |[_, _, at]: [usize; 3]| sight.owner[at] < FLOOR;
        let lights = match square.pixels(view).any(|(_, pixel)| is_body(pixel)) {
            true => surfels.reflected(studio.light, &points, &ways),
            false => NO_VECTORS,
        };
        for (k, [x, y, at]) in square.pixels(view) {
            let [r, g, b] = match sight.owner[at] {
                NOTHING | FLOOR => {
                    let place = [&points, &ways].map(|v| get(v, k));
                    let colour = studio.behind(at, place, &Reaching::at(&surfels.reaching, k));
                    dithered(colour, [x, y])
                }
                _ => studio.light.screen(get(&lights, k)),
            };
            let is_clear = sight.owner[at] == NOTHING && studio.backdrop == Backdrop::Nothing;
            let alpha = if is_clear { 0 } else { 255 };
            rgba[4 * at..][..4].copy_from_slice(&[r, g, b, alpha]);
        }
    }

    /// The surfaces found in a tile, with the light that reaches them.
    #[inline(always)]
    fn surfels(&self, studio: ShadingInputs, square: Tile, points: &Vectors) -> TileSurfels {
        let (sight, view) = (studio.sight, studio.sight.view());
        let mut tile = TileSurfels::NOTHING;
        for (k, [x, y, at]) in square.pixels(view) {
            let found = &self.found[slot(view.size[0], x, y)];
            let surfel = studio.surfel(at, get(points, k), found);
            let from_there = f32::from(self.occlusion.open[at]) * (1.0 / 255.0);
            let floor = match surfel.normal.y > LEVEL && sight.owner[at] < FLOOR {
                true => 1.0,
                false => studio.light.floor_open(surfel.position),
            };
            let sky = lesser(from_there, surfel.open);
            set(&mut tile.reaching, k, Vec3::new(found.seen, sky, floor));
            let finish = studio.light.finish(surfel.material);
            for (list, &v) in tile.finishes.iter_mut().zip(finish) {
                list[k] = v;
            }
            set(&mut tile.colours, k, Vec3::from(surfel.colour));
            set(&mut tile.normals, k, surfel.normal);
            set(&mut tile.smooth, k, found.normal);
        }
        tile
    }
}

/// The unit normals at the points where a tile's rays meet bodies.
struct TileNormals {
    /// Interpolated over the triangles.
    normals: Vectors,
    /// The triangles' own.
    flats: Vectors,
    /// See [`PixelHit::lift`].
    lifts: Each,
}

/// The surface at a pixel.
#[derive(Clone, Copy)]
struct Found {
    normal: Vec3,
    colour: [f32; 3],
    /// The visible share of the lamp.
    seen: f32,
}

impl Found {
    const NOTHING: Self = Self {
        normal: Vec3::Y,
        colour: [0.0; 3],
        seen: 1.0,
    };
}

/// The index of a pixel in the list of surfaces found.
fn slot(width: usize, x: usize, y: usize) -> usize {
    y % (2 * BAND) * width + x
}

impl ShadingInputs<'_> {
    /// The visible share of this sample's part of the lamp at a point of the floor.
    fn seen_by_floor(&self, point: Vec3) -> f32 {
        let reach = 2.0 * self.ground.radius;
        penumbra::visible(self.light, point, self.part_of_lamp, reach)
    }

    /// The share of the lamp that a pixel's surface sees without regard to the shadow maps, and its place in these maps.
    /// `normals` are the interpolated normal and that of the triangle.
    #[inline(always)]
    fn spot(&self, at: usize, point: Vec3, normals: [Vec3; 2], lift: f32) -> (f32, ShadowSample) {
        let owner = self.sight.owner[at];
        let slack = match owner {
            NOTHING => return (1.0, ShadowSample::BESIDE),
            FLOOR if self.part_of_lamp > 0.0 => {
                return (self.seen_by_floor(point), ShadowSample::BESIDE);
            }
            FLOOR => 0.0,
            _ => lift + self.sight.slack(at),
        };
        if let Some(there) = self.light.spot(point, normals, slack) {
            return (1.0, there);
        }
        match self.thickness(owner) {
            Some(thick) => (1.0, self.light.spot_behind(point, normals[0], thick)),
            None => (0.0, ShadowSample::BESIDE),
        }
    }

    /// About how thick a body is, in the world, if light goes through it.
    fn thickness(&self, owner: u32) -> Option<f32> {
        let instance = self.scene.instances.get(owner as usize)?;
        let body = &self.scene.bodies[instance.body as usize];
        let material = instance.paint.map_or(body.material, |paint| paint.material);
        let [.., thin] = self.light.finish(material);
        (*thin > 0.0).then(|| THICK * self.scene.ball_of(instance).1)
    }

    /// The surface element at a pixel, before light.
    #[inline(always)]
    fn surfel(&self, at: usize, position: Vec3, found: &Found) -> Surfel {
        let mut surfel = Surfel {
            position,
            normal: found.normal,
            colour: found.colour,
            material: 0,
            open: 1.0,
        };
        let sight = self.sight;
        if let Some(instance) = self.scene.instances.get(sight.owner[at] as usize) {
            surfel.material = self.scene.bodies[instance.body as usize].material;
            if let Some(paint) = instance.paint {
                (surfel.colour, surfel.material) = (paint.over(surfel.colour), paint.material);
            }
            if let Some(detail) = &self.scene.detail {
                let spread = sight.view().slope / sight.inverse[at];
                detail.refine(&mut surfel, instance.id, spread);
            }
        }
        surfel
    }

    /// The colour on the screen of a pixel that shows no body. `point` is the floor's place, `way` the direction from the
    /// eye.
    #[inline(always)]
    fn behind(&self, at: usize, [point, way]: [Vec3; 2], reaching: &Reaching) -> [f32; 3] {
        let back = behind(self.backdrop, way, self.far);
        if self.backdrop != Backdrop::Floor {
            return back;
        }
        let left = left_of_corner(self.sight.view(), way);
        if self.sight.owner[at] == NOTHING {
            return back.map(|v| v * left);
        }
        let (floor, part) = (self.light.floor(point, reaching), self.floor_part(point));
        std::array::from_fn(|k| (back[k] + (floor[k] - back[k]) * part) * left)
    }

    fn floor_part(&self, at: Vec3) -> f32 {
        floor_part((at - self.ground.middle).length(), self.ground.radius)
    }
}

/// The colour on the screen of the floor where it fades, straight ahead, as the lamp lights it there.
pub(super) fn far_floor(light: &Lighting, view: &View, ground: &FloorPlane) -> [f32; 3] {
    let flat = |v: Vec3, y: f32| Vec3::new(v.x, y, v.z);
    let away = flat(view.ahead, 0.0).normalize_or(Vec3::NEG_Z);
    let position = flat(ground.middle, ground.height) + away * end_of_floor(ground.radius);
    light.floor(position, &Reaching::ALL)
}

/// Marks the pixels of a row that show the floor.
pub(super) fn find_floor(sight: &mut VisibilityBuffer, ground: FloorPlane, y: usize) {
    let view = *sight.view();
    for x in 0..view.size[0] {
        let at = y * view.size[0] + x;
        if sight.owner[at] != NOTHING {
            continue;
        }
        let ray = view.ray(x as f32 + 0.5, y as f32 + 0.5);
        let depth = (ground.height - view.eye.y) / ray.y;
        let met = view.eye + ray * depth;
        let is_near = || floor_part((met - ground.middle).length(), ground.radius) > 0.0;
        // The floor is invisible from below.
        if ray.y < 0.0 && depth > view.near && is_near() {
            sight.owner[at] = FLOOR;
            sight.inverse[at] = 1.0 / depth;
        }
    }
}
