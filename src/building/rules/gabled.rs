//! A house with gables under a roof that overhangs the walls. It is one solid: the walls end at the underside of the
//! roof.

use super::Module;
use super::drafting::Drafting;
use super::openings::{Opening, OpeningHead, spread, wall_face};
use super::wall_plane::WallPlane;
use crate::building::draft::Draft;
use crate::building::labels::ROOF;
use glam::{DVec2, DVec3};

/// How far the roof overhangs the long walls, and the gables (metres).
const OVER: [f64; 2] = [0.3, 0.2];
/// The thickness of the roof (metres).
const SLAB: f64 = 0.12;
/// The course at which windows begin, and that at which their heads do.
const WINDOW: [f64; 2] = [10.0, 20.0];

/// Lengths that walls and roof share (metres).
struct House {
    /// Half of the length along x and half of the width along z.
    half: DVec2,
    /// The height at which the underside of the roof meets the long walls.
    eaves: f64,
    /// The sine, the cosine and the tangent of the pitch.
    pitch: [f64; 3],
}

pub(super) fn gabled(module: &Module, n: &[f64]) -> Draft {
    let mut to = Drafting::default();
    let (sin, cos) = libm::sincos(n[3].to_radians());
    let house = House {
        half: 0.5 * DVec2::new(module.pier(n[0]), module.pier(n[1])),
        eaves: module.top(n[2]),
        pitch: [sin, cos, sin / cos],
    };
    let window = Opening {
        left: 0.0,
        width: 6.0,
        bottom: WINDOW[0],
        springing: WINDOW[1],
        head: OpeningHead::of(n[5]),
        is_door: false,
    };
    house.long_walls(&mut to, module, [n[0], n[4]], &window);
    house.gables(&mut to, module, [n[1], n[4]], &window);
    house.roof(&mut to);
    let h = house.half;
    let ground = [(-h.x, h.y), (-h.x, -h.y), (h.x, -h.y), (h.x, h.y)];
    let ground = ground.map(|(x, z)| DVec3::new(x, 0.0, z));
    to.panel(&[], &ground, DVec3::NEG_Y);
    to.on_ground()
}

impl House {
    /// Both walls below the eaves. The front has a door between its windows.
    fn long_walls(
        &self,
        to: &mut Drafting,
        module: &Module,
        [length, windows]: [f64; 2],
        window: &Opening,
    ) {
        let (x, z) = (self.half.x, self.half.y);
        for side in [1.0, -1.0] {
            let ends = [-side, side].map(|sign| DVec3::new(sign * x, 0.0, side * z));
            let is_front = side > 0.0;
            let mut openings = spread(length, windows + f64::from(u8::from(is_front)), window);
            let middle = openings.len() / 2;
            if let (true, Some(door)) = (is_front, openings.get_mut(middle)) {
                (door.bottom, door.is_door) = (1.0, true);
            }
            self.wall(to, module, ends, &openings, None);
        }
    }

    /// Both walls below the gables, with a small window near the top.
    fn gables(
        &self,
        to: &mut Drafting,
        module: &Module,
        [width, windows]: [f64; 2],
        window: &Opening,
    ) {
        let (x, z) = (self.half.x, self.half.y);
        let ridge = self.eaves + z * self.pitch[2];
        for side in [1.0, -1.0] {
            let ends = [side, -side].map(|sign| DVec3::new(side * x, 0.0, sign * z));
            let mut openings = spread(width, windows.min(3.0), window);
            openings.extend(self.attic(module, width));
            let apex = DVec2::new(0.5 * module.joint + z, ridge);
            self.wall(to, module, ends, &openings, Some(apex));
        }
    }

    /// A window in the gable, if there is room for it.
    fn attic(&self, module: &Module, width: f64) -> Option<Opening> {
        let bottom = (self.eaves / module.course).ceil() + 2.0;
        let springing = bottom + 5.0;
        let left = ((width - 4.0) / 2.0).round();
        let room =
            |courses: f64| (self.half.y * self.pitch[2] + self.eaves) - courses * module.course;
        // Level with its crown, the gable is over ten modules wide: three more than the window on each side.
        let is_low = room(springing + 3.0) > 5.0 * module.half * self.pitch[2];
        is_low.then_some(Opening {
            left,
            width: 4.0,
            bottom,
            springing,
            head: OpeningHead::Round,
            is_door: false,
        })
    }

    fn wall(
        &self,
        to: &mut Drafting,
        module: &Module,
        [left, right]: [DVec3; 2],
        openings: &[Opening],
        apex: Option<DVec2>,
    ) {
        let lead = 0.5 * module.joint;
        let plane = WallPlane::new(left, right, lead);
        let end = lead + left.distance(right);
        let corners = [(lead, 0.0), (end, 0.0), (end, self.eaves)].map(DVec2::from);
        let mut outline = corners.to_vec();
        outline.extend(apex);
        outline.push(DVec2::new(lead, self.eaves));
        wall_face(to, &plane, &outline, openings, (module, module.half));
    }

    /// The faces of the roof: slopes, eaves, ends, and undersides around the walls.
    fn roof(&self, to: &mut Drafting) {
        let [sin, cos, tan] = self.pitch;
        let (x, z) = (self.half.x, self.half.y);
        let far = x + OVER[1];
        let ridge = [self.eaves + z * tan, self.eaves + z * tan + SLAB / cos];
        let eave = [
            DVec2::new(z + OVER[0], self.eaves - OVER[0] * tan),
            DVec2::new(
                z + OVER[0] + SLAB * sin,
                self.eaves - OVER[0] * tan + SLAB * cos,
            ),
        ];
        for side in [1.0, -1.0] {
            let at = |x: f64, p: DVec2| DVec3::new(x, p.y, side * p.x);
            let top = |x: f64| DVec3::new(x, ridge[1], 0.0);
            let under = |x: f64| DVec3::new(x, ridge[0], 0.0);
            let wall = |x: f64| DVec3::new(x, self.eaves, side * z);
            let slope = DVec3::new(0.0, cos, side * sin);
            let upper = [top(far), top(-far), at(-far, eave[1]), at(far, eave[1])];
            to.panel(&[ROOF], &upper, slope);
            let [low, high] = eave;
            let edge = [at(-far, low), at(far, low), at(far, high), at(-far, high)];
            to.panel(&[ROOF], &edge, DVec3::new(0.0, -sin, side * cos));
            let below = [
                at(-far, low),
                at(far, low),
                under(far),
                under(x),
                wall(x),
                wall(-x),
                under(-x),
                under(-far),
            ];
            to.panel(&[ROOF], &below, -slope);
            let across = |p: DVec2, sign: f64| DVec3::new(side * far, p.y, sign * p.x);
            let end = [
                top(side * far),
                across(high, 1.0),
                across(low, 1.0),
                under(side * far),
                across(low, -1.0),
                across(high, -1.0),
            ];
            to.panel(&[ROOF], &end, DVec3::X * side);
        }
    }
}
