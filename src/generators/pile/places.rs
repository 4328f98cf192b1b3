//! The places of a pile's bodies, for the scatter tools of other programs.

use super::PileEngine;
use crate::decimal;
use crate::pile::{Body, Fate, Refining};
use std::fmt::Write;

impl PileEngine {
    /// The transforms as CSV, a line for each body: the place, the rotation as a quaternion, the scale, the component.
    /// Lengths are in the shape's units, y up. Empty before bodies have settled.
    pub(super) fn places_table(&self) -> String {
        let bodies = self.made.settled.made().map(Refining::bodies);
        let Some(bodies) = bodies else {
            return String::new();
        };
        let words = self.made.words();
        let mut text = String::from("x,y,z,qx,qy,qz,qw,scale,component,variant,dart,layer\n");
        for body in bodies.iter().filter(|body| body.fate == Fate::Kept) {
            let turn = glam::DQuat::from_mat3(&body.turn).to_array();
            let at = body.place().to_array();
            for v in at.into_iter().chain(turn).chain([body.scale]) {
                let _ = write!(text, "{},", decimal::text(v));
            }
            let word = words[body.kind as usize];
            let Body {
                shape, dart, layer, ..
            } = body;
            let _ = writeln!(text, "{word},{shape},{dart},{layer}");
        }
        text
    }
}
