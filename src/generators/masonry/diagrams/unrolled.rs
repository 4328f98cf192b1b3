//! The occupancy map of one face, unrolled into its (s, t), in three states: all free, with the cells of its corners
//! and edges, and also with its own cells (Legakis, Dorsey, Gortler 2001, Feature-based cellular texturing for
//! architectural models, section 3.3, figure 3).

use super::super::colours::{FEATURES, type_of};
use super::super::parts::add_plain;
use super::occupancy::{FREE, TONE, runs};
use super::toned;
use crate::building::FaceId;
use crate::masonry::laying::{Feature, Laying};
use crate::masonry::occupancy::{Claims, PixelRun};
use crate::scene::{Camera, Scene};
use crate::solid::Surface;
use glam::{DVec2, Vec3};

/// The words of the states of a map: all free, then before and after the face's own cells are laid.
pub(in crate::generators::masonry) const STATES: [&str; 3] = ["free", "before", "after"];
/// The angle and the height (degrees) of the page's first camera for one body. The map faces this camera.
const VIEWER: (f64, f64) = (80.0, 30.0);
/// The distance between lines of the hatching, as a share of half the map's diagonal.
const HATCH: f64 = 0.045;
/// The distance of lines before the map, as a share of half the map's diagonal.
const BEFORE: f64 = 0.002;
/// The row of the picture's materials.
const ROW: u8 = 0;

/// The shares of a face's pixels that are occupied before and after its own cells are laid.
pub(in crate::generators::masonry) fn occupied(laying: &Laying, face: FaceId) -> [f64; 2] {
    [1, 2].map(|state| {
        let (_, runs) = runs(laying, face, &claims(laying, face, state));
        let count = |is_counted: fn(&PixelRun) -> bool| {
            let own = runs.iter().filter(|run| is_counted(run));
            own.map(PixelRun::count).sum::<usize>() as f64
        };
        count(|run| run.claim.is_some()) / count(|_| true).max(1.0)
    })
}

/// The claims on a face in a state of its map, an index of [`STATES`].
fn claims(laying: &Laying, id: FaceId, state: usize) -> Claims {
    let mut claims = Claims::new(laying.building().face(id).bounds());
    let all = laying.face_map(id).claims().list().iter();
    let is_own = |cell: u32| laying.cells()[cell as usize].feature == Feature::Face(id);
    let shown = all.filter(|claim| state > 0 && (state > 1 || !is_own(claim.cell)));
    shown.for_each(|claim| claims.add(claim.clone()));
    claims
}

/// The map of a face in a state, alone. Free pixels are pale. Occupied pixels have the colour of the cell's feature and
/// a hatching: level for corners, rising for edges, falling for faces.
pub(in crate::generators::masonry) fn scene(laying: &Laying, face: FaceId, state: usize) -> Scene {
    let [low, high] = laying.building().face(face).bounds();
    let board = MapPlane::new(low, high);
    let (_, runs) = runs(laying, face, &claims(laying, face, state));
    let mut surface = Surface::default();
    let mut lines = Vec::new();
    for run in &runs {
        let kind = run.claim.map(|cell| laying.cells()[cell as usize].feature);
        let kind = kind.map(type_of);
        let colour = match (kind, run.claim) {
            (Some(kind), Some(cell)) => toned(FEATURES[kind], TONE, cell),
            _ => FREE,
        };
        board.add(&mut surface, run, colour);
        let hatched = kind
            .iter()
            .flat_map(|&kind| hatching(run, kind, HATCH / board.scale));
        lines.extend(hatched.map(|ends| ends.map(|p| board.place(p, BEFORE))));
    }
    let mut scene = Scene {
        lines,
        reach: 0.1,
        ..Scene::default()
    };
    add_plain(&mut scene, surface, (0, [255; 3], ROW));
    scene
}

/// A flat board that faces the viewer, with the middle of a map at the origin and its corners at distance 1.
struct MapPlane {
    middle: DVec2,
    scale: f64,
    right: Vec3,
    up: Vec3,
}

impl MapPlane {
    fn new(low: DVec2, high: DVec2) -> Self {
        let (angle, height) = VIEWER;
        let camera = Camera {
            angle,
            height,
            ..Camera::default()
        };
        let view = camera.view(1, 1);
        Self {
            middle: 0.5 * (low + high),
            scale: 2.0 / (high - low).length().max(f64::MIN_POSITIVE),
            right: view.right,
            up: view.up,
        }
    }

    /// The place in the scene of a point (s, t) of the map, at the distance `before` in front of the board.
    fn place(&self, p: DVec2, before: f64) -> Vec3 {
        let [x, y] = ((p - self.middle) * self.scale)
            .to_array()
            .map(|v| v as f32);
        self.right * x + self.up * y + self.right.cross(self.up) * before as f32
    }

    fn add(&self, surface: &mut Surface, run: &PixelRun, colour: [u8; 3]) {
        let (low, high) = (run.low, run.high);
        let corners = [
            low,
            DVec2::new(high.x, low.y),
            high,
            DVec2::new(low.x, high.y),
        ];
        let first = surface.positions.len() as u32;
        let normal = self.right.cross(self.up);
        surface
            .positions
            .extend(corners.map(|p| self.place(p, 0.0)));
        surface.normals.extend([normal; 4]);
        surface.colours.extend([colour; 4]);
        surface
            .triangles
            .extend([[0, 1, 2], [0, 2, 3]].map(|t| t.map(|k| first + k)));
    }
}

/// The lines of a hatching within a rectangle, `apart` metres from each other along t. Their direction depends on
/// `kind`, the type of the feature.
fn hatching(run: &PixelRun, kind: usize, apart: f64) -> Vec<[DVec2; 2]> {
    let slope = [0.0, 1.0, -1.0][kind];
    let (low, high) = (run.low, run.high);
    // A line has one value of t - slope * s.
    let [a, b] = [low.x, high.x].map(|s| slope * s);
    let (least, most) = (low.y - a.max(b), high.y - a.min(b));
    let (from, to) = ((least / apart).ceil(), (most / apart).floor());
    let numbers = 0..=(to - from).max(-1.0) as i64;
    let lines = numbers.filter_map(|number| {
        let level = (from + number as f64) * apart;
        let at = |t: f64| (t - level) / slope;
        let ends = if slope == 0.0 {
            [low.x, high.x]
        } else {
            let [a, b] = [at(low.y), at(high.y)];
            [a.min(b).max(low.x), a.max(b).min(high.x)]
        };
        let is_inside = ends[0] < ends[1];
        is_inside.then(|| ends.map(|s| DVec2::new(s, level + slope * s)))
    });
    lines.collect()
}
