//! The planes of a frame as files: for compositing, and for whoever learns from pictures.

use super::Map;
use super::maps::id_colour;
use crate::scene::Frame;

/// What a plane of a frame tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FramePlane {
    /// How near bodies are: grey of 16 bits, from the farthest (1) to the nearest (65535), evenly by depth; 0 where
    /// none is.
    Depth,
    /// Normals as the eye sees them, green up (OpenGL): right, up and to the eye from -1..1 to 0..255; black
    /// where no body is.
    Normal,
    /// A colour for each body that no other has, as the map of ids has it; black for ground and none.
    Id,
}

impl FramePlane {
    /// All, with their words.
    pub const ALL: [(FramePlane, &'static str); 3] = [
        (FramePlane::Depth, "depth"),
        (FramePlane::Normal, "normal"),
        (FramePlane::Id, "id"),
    ];

    /// The plane of a word.
    pub fn of_word(word: &str) -> Option<FramePlane> {
        let found = Self::ALL.iter().find(|(_, w)| *w == word);
        found.map(|&(plane, _)| plane)
    }
}

/// A plane of a finished frame; its `side` is the frame's width, and rows are as many as the frame has.
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
