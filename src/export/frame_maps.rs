//! The planes of a frame as files: for compositing, and as training data.

use super::Map;
use super::maps::id_colour;
use crate::scene::Frame;

/// A plane of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FramePlane {
    /// Nearness of bodies as 16 bit grey, linear in depth, from the farthest (1) to the nearest (65535); 0 where
    /// there is none.
    Depth,
    /// Normals in view axes, green up (OpenGL): right, up and towards the eye, from -1..1 to 0..255. Black where
    /// there is no body.
    Normal,
    /// A unique colour for each body, as in the map of ids. Black for the ground and where there is no body.
    Id,
}

impl FramePlane {
    /// All planes with their words.
    pub const ALL: [(FramePlane, &'static str); 3] = [
        (FramePlane::Depth, "depth"),
        (FramePlane::Normal, "normal"),
        (FramePlane::Id, "id"),
    ];

    /// The plane with this word.
    pub fn of_word(word: &str) -> Option<FramePlane> {
        let found = Self::ALL.iter().find(|(_, w)| *w == word);
        found.map(|&(plane, _)| plane)
    }
}

/// A plane of a finished frame. `side` of the result is the frame's width; it has as many rows as the frame.
pub fn frame_map(frame: &Frame, plane: FramePlane) -> Map {
    let (channels, bits, bytes) = match plane {
        FramePlane::Depth => (1, 16, depth(frame.depths())),
        FramePlane::Normal => (3, 8, normals(frame)),
        FramePlane::Id => {
            let colours = frame.ids().iter().map(|&id| id_colour(id));
            (3, 8, colours.flatten().collect())
        }
    };
    Map {
        side: frame.order().size[0],
        channels,
        bits,
        bytes,
    }
}

fn depth(depths: &[f32]) -> Vec<u8> {
    let there = || depths.iter().filter(|&&depth| depth > 0.0);
    let near = there().fold(f32::MAX, |near, &depth| near.min(depth));
    let far = there().fold(0.0, |far: f32, &depth| far.max(depth));
    let span = (far - near).max(f32::MIN_POSITIVE);
    let grey = |&depth: &f32| match depth > 0.0 {
        true => 1 + ((far - depth) / span * 65534.0 + 0.5) as u16,
        false => 0,
    };
    depths.iter().flat_map(|d| grey(d).to_be_bytes()).collect()
}

fn normals(frame: &Frame) -> Vec<u8> {
    let order = frame.order();
    let view = order.camera.view(order.size[0], order.size[1]);
    let byte = |v: f32| ((0.5 * v + 0.5) * 255.0 + 0.5) as u8;
    let colours = frame
        .normals()
        .iter()
        .map(|n| match *n == glam::Vec3::ZERO {
            true => [0; 3],
            false => [view.right, view.up, -view.ahead].map(|axis| byte(n.dot(axis))),
        });
    colours.flatten().collect()
}
