//! Thick walls with openings that go through: a free-standing wall, and a gate.

use super::Module;
use super::drafting::Drafting;
use super::openings::{Opening, OpeningHead};
use super::wall_line::WallLine;
use crate::building::draft::Draft;

/// Three openings side by side: a window, an arch, and a wide window.
pub(super) fn wall(module: &Module, n: &[f64]) -> Draft {
    let mut to = Drafting::default();
    let (length, width) = (n[0], n[3].min(((n[0] - 10.0) / 4.0).floor()));
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
    let mut openings = Vec::new();
    for (width, head) in widths.into_iter().zip(heads) {
        // Curved heads rise above the springing by at most half their width.
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
        openings.push((0, opening));
        left += width + gap;
    }
    WallLine::straight(module, length, [n[1], n[2]]).build(&mut to, &openings, true);
    to.on_ground()
}

pub(super) fn gate(module: &Module, n: &[f64]) -> Draft {
    let mut to = Drafting::default();
    let [span, pier, springing, over, thickness] = [n[0], n[1], n[2], n[3], n[4]];
    let crown = springing * module.course + 0.5 * (span * module.half + module.joint);
    let courses = ((crown + module.joint) / module.course).ceil() + over;
    let arch = Opening {
        left: pier,
        width: span,
        bottom: 0.0,
        springing,
        head: OpeningHead::Round,
        is_door: false,
    };
    let length = span + 2.0 * pier;
    WallLine::straight(module, length, [courses, thickness]).build(&mut to, &[(0, arch)], false);
    to.on_ground()
}
