//! A house with an L-shaped plan: a main house with two gables, and a wing with one. Roofs do not overhang the walls.
//! The wing's roof meets the main roof in two valleys.

use super::Module;
use super::drafting::Drafting;
use super::openings::{Opening, OpeningHead, spread, wall_face};
use super::plain::{over, sides, turned};
use super::wall_plane::WallPlane;
use crate::building::draft::Draft;
use crate::building::labels::ROOF;
use glam::{DVec2, DVec3};

/// The index of the inner corner in the plan.
const INNER: usize = 3;
/// The wall with the door: that of the main house beside the wing, so that door and wing are seen together.
const DOOR: usize = INNER - 1;
/// The greatest rise of the wing's roof, as a share of the rise of the main roof.
const LOWER: f64 = 0.85;

/// The house: the main part lies along x in front, and the wing stands behind it on the left.
struct House {
    plan: [DVec2; 6],
    /// The height of the eaves (metres).
    eaves: f64,
    /// The rises of the main roof and of the wing's roof (metres).
    rises: [f64; 2],
}

/// The plan (metres). Walls stand half a joint inside of the grid's lines, at the inner corner, too. So the two walls
/// that meet there are whole modules long.
fn plan(module: &Module, [length, width, wing, depth]: [f64; 4]) -> [DVec2; 6] {
    let wing = wing.min(length - 6.0);
    let depth = depth.min(width - 6.0);
    let half = 0.5 * DVec2::new(module.pier(length), module.pier(width));
    let inner = DVec2::new(-half.x + module.pier(wing), half.y - depth * module.half);
    let corners = [
        (-half.x, -half.y),
        (half.x, -half.y),
        (half.x, inner.y),
        (inner.x, inner.y),
        (inner.x, half.y),
        (-half.x, half.y),
    ];
    corners.map(DVec2::from)
}

pub(super) fn l_house(module: &Module, n: &[f64]) -> Draft {
    let mut to = Drafting::default();
    let plan = plan(module, [n[0], n[1], n[2], n[3]]);
    let (sin, cos) = libm::sincos(n[7].to_radians());
    let rise = |span: f64| 0.5 * span * sin / cos;
    let main = rise(plan[INNER].y - plan[0].y);
    let house = House {
        eaves: module.top(n[4]),
        rises: [main, rise(plan[INNER].x - plan[0].x).min(LOWER * main)],
        plan,
    };
    let window = Opening {
        left: 0.0,
        width: 6.0,
        bottom: 10.0,
        springing: 19.0,
        head: OpeningHead::of(n[6]),
        is_door: false,
    };
    for (k, ends) in sides(&plan).enumerate() {
        // A house without windows keeps its door.
        let openings = if k == DOOR { n[5].max(1.0) } else { n[5] };
        house.wall(&mut to, module, (k, ends), (openings, &window));
    }
    house.roof(&mut to);
    to.flat(&[], &[turned(&plan, 0.0)]);
    to.on_ground()
}

impl House {
    fn wall(
        &self,
        to: &mut Drafting,
        module: &Module,
        (k, [a, b]): (usize, [DVec2; 2]),
        (windows, window): (f64, &Opening),
    ) {
        let length = ((a.distance(b) + module.joint) / module.half).round();
        let mut openings = spread(length, windows, window);
        let middle = openings.len() / 2;
        if let (DOOR, Some(door)) = (k, openings.get_mut(middle)) {
            (door.bottom, door.is_door) = (1.0, true);
        }
        let lead = 0.5
            * if k == INNER {
                -module.joint
            } else {
                module.joint
            };
        let plane = WallPlane::new(over(a, 0.0), over(b, 0.0), lead);
        let end = lead + a.distance(b);
        let mut outline = [(lead, 0.0), (end, 0.0), (end, self.eaves)]
            .map(DVec2::from)
            .to_vec();
        let top = self.top(k).into_iter();
        outline.extend(top.map(|(p, y)| DVec2::new(lead + a.distance(p), y)));
        outline.push(DVec2::new(lead, self.eaves));
        wall_face(to, &plane, &outline, &openings, (module, module.half));
    }

    /// The places in plan, with their heights, at which the top of a wall bends, from its right to its left end.
    fn top(&self, wall: usize) -> Vec<(DVec2, f64)> {
        let [main, wing] = self.ridges();
        match wall {
            1 => vec![main[1]],
            4 => vec![wing[0]],
            5 => vec![main[0], (self.meeting(), self.eaves)],
            _ => Vec::new(),
        }
    }

    /// Where the outer wall of the wing becomes the gable of the main house.
    fn meeting(&self) -> DVec2 {
        DVec2::new(self.plan[0].x, self.plan[INNER].y)
    }

    /// The ends of the main ridge (left, right) and of the wing's ridge (gable, valley), in plan with their heights.
    fn ridges(&self) -> [[(DVec2, f64); 2]; 2] {
        let (plan, [main, wing]) = (&self.plan, self.rises);
        let y = 0.5 * (plan[0].y + plan[INNER].y);
        let x = 0.5 * (plan[0].x + plan[INNER].x);
        let ridge = [plan[0].x, plan[1].x].map(|x| (DVec2::new(x, y), self.eaves + main));
        // The wing's ridge meets the slope of the main house where both are equally high.
        let back = plan[INNER].y - (plan[INNER].y - y) * wing / main;
        let own = [plan[5].y, back].map(|y| (DVec2::new(x, y), self.eaves + wing));
        [ridge, own]
    }

    /// The four slopes.
    fn roof(&self, to: &mut Drafting) {
        let [[left, right], [gable, valley]] = self.ridges();
        let at = |(p, y): (DVec2, f64)| over(p, y);
        let eave = |p: DVec2| over(p, self.eaves);
        let [a, b, c, inner, d, e] = self.plan.map(eave);
        let meeting = eave(self.meeting());
        let [left, right, gable, valley] = [left, right, gable, valley].map(at);
        let slopes = [
            vec![a, b, right, left],
            vec![c, inner, valley, meeting, left, right],
            vec![e, meeting, valley, gable],
            vec![inner, d, gable, valley],
        ];
        for slope in slopes {
            to.panel(&[ROOF], &slope, DVec3::Y);
        }
    }
}
