//! Thick walls with openings that go through: a free-standing wall, and a gate.

use super::Module;
use super::drafting::Drafting;
use super::openings::{Opening, OpeningHead, Reveal, WallPlane};
use crate::building::draft::Draft;
use glam::{DVec2, DVec3};

/// A wall of a thickness, around the plane z = 0.
struct ThickWall {
    front: WallPlane,
    thickness: f64,
    /// Both ends and the top, in the front's plane.
    ends: [f64; 2],
    top: f64,
}

impl ThickWall {
    fn new(module: &Module, [length, height, thickness]: [f64; 3]) -> Self {
        let (half, thickness) = (0.5 * module.pier(length), module.pier(thickness));
        let place = |x: f64| DVec3::new(x, 0.0, 0.5 * thickness);
        let lead = 0.5 * module.joint;
        Self {
            front: WallPlane::new(place(-half), place(half), lead),
            thickness,
            ends: [lead, lead + 2.0 * half],
            top: height,
        }
    }

    /// Adds both faces. `outline` is the outer loop, counter-clockwise seen from the front.
    fn add_faces(&self, to: &mut Drafting, outline: &[DVec2], holes: &[Reveal]) {
        let ring = |behind: f64| outline.iter().map(|&p| self.front.at(p, behind)).collect();
        let hole = |behind: f64| holes.iter().map(move |hole| hole.hole(&self.front, behind));
        let loops = |behind: f64| -> Vec<Vec<DVec3>> {
            let outer: Vec<DVec3> = ring(behind);
            [outer].into_iter().chain(hole(behind)).collect()
        };
        to.flat(&[], &loops(0.0));
        let mut back = loops(self.thickness);
        back.iter_mut().for_each(|ring| ring.reverse());
        to.flat(&[], &back);
    }

    /// Adds the narrow face below or beside a side of the outline.
    fn add_side(&self, to: &mut Drafting, from: DVec2, end: DVec2) {
        let at = |p, behind| self.front.at(p, behind);
        let behind = self.thickness;
        to.flat(
            &[],
            &[vec![
                at(end, 0.0),
                at(from, 0.0),
                at(from, behind),
                at(end, behind),
            ]],
        );
    }

    /// The corners from the lower left one on, counter-clockwise.
    fn corners(&self) -> [DVec2; 4] {
        let ([u, v], top) = (self.ends, self.top);
        [(u, 0.0), (v, 0.0), (v, top), (u, top)].map(DVec2::from)
    }
}

/// Three openings side by side: a window, an arch, and a wide window.
pub(super) fn wall(module: &Module, n: &[f64]) -> Draft {
    let mut to = Drafting::default();
    let (length, width) = (n[0], n[3].min(((n[0] - 10.0) / 4.0).floor()));
    let wall = ThickWall::new(module, [length, module.top(n[1]), n[2]]);
    let widths = [width, width, width + 2.0];
    let gap = ((length - widths.iter().sum::<f64>()) / 4.0)
        .max(2.0)
        .floor();
    let heads = [
        OpeningHead::Straight,
        OpeningHead::of(n[4]),
        OpeningHead::Straight,
    ];
    let mut left = gap;
    let mut holes = Vec::new();
    for (width, head) in widths.into_iter().zip(heads) {
        // Round heads rise above the springing by half their width.
        let rise = match head {
            OpeningHead::Straight => 0.0,
            _ => (0.5 * width * module.half / module.course).ceil(),
        };
        let opening = Opening {
            left,
            width,
            bottom: 7.0,
            springing: (n[1] - 5.0 - rise).clamp(9.0, 17.0),
            head,
            is_door: false,
        };
        holes.push(opening.reveal(module));
        left += width + gap;
    }
    let corners = wall.corners();
    wall.add_faces(&mut to, &corners, &holes);
    for k in 0..4 {
        wall.add_side(&mut to, corners[k], corners[(k + 1) % 4]);
    }
    for hole in &holes {
        hole.faces(&mut to, &wall.front, wall.thickness, true);
        hole.pane(&mut to, &wall.front, 0.5 * wall.thickness);
    }
    to.on_ground()
}

pub(super) fn gate(module: &Module, n: &[f64]) -> Draft {
    let mut to = Drafting::default();
    let [span, pier, springing, over, thickness] = [n[0], n[1], n[2], n[3], n[4]];
    let crown = springing * module.course + 0.5 * (span * module.half + module.joint);
    let courses = ((crown + module.joint) / module.course).ceil() + over;
    let wall = ThickWall::new(module, [span + 2.0 * pier, module.top(courses), thickness]);
    let arch = Opening {
        left: pier,
        width: span,
        bottom: 0.0,
        springing,
        head: OpeningHead::Round,
        is_door: false,
    };
    let reveal = arch.reveal(module).plain();
    let [a, b, c, d] = wall.corners();
    let notch = reveal.corners();
    let outline = [&[a][..], &notch, &[b, c, d]].concat();
    wall.add_faces(&mut to, &outline, &[]);
    reveal.faces(&mut to, &wall.front, wall.thickness, false);
    for [from, end] in [[a, notch[0]], [notch[3], b], [b, c], [c, d], [d, a]] {
        wall.add_side(&mut to, from, end);
    }
    to.on_ground()
}
