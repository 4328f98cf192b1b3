//! Frames of bodies in light, and queries on them.

use super::said::{notice, or_why};
use super::{Bubblestone, object, objects};
use crate::export::{FramePlane, frame_map};
use crate::generators::{ALL, FrameSlice, Frames, SeenLabel, TurnOrder};
use crate::notice::{Code, Notice};
use crate::scene::Camera;
use crate::studio::Studio;
use js_sys::{Array, Object, Uint8Array};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r"
/** The result of a slice of work on a frame. */
export interface FrameSlice {
  /** Whether a new frame begins. */
  begun: boolean;
  done: boolean;
  /** The approximate progress, 0..1. */
  progress: number;
  /** The RGBA pixels (alpha is not premultiplied) from the top, when one more sample is done: the mean so far. */
  pixels?: Uint8Array<ArrayBuffer>;
}

/** A label at a pixel of a frame, from the top left corner. */
export interface SeenLabel { text: string; x: number; y: number }

/** A body at a pixel of a frame. */
export interface SeenBody {
  /** Ids count from 1. */
  id: number;
  /** The middle of the body, in the scene. */
  centre: [x: number, y: number, z: number];
  /** The generator's measures of it, by their words; lengths in picture units, angles in degrees. */
  figures: Record<string, number>;
  /** Words that tell of it what numbers cannot, each by the word of its kind. */
  words: Record<string, string>;
}
";

#[wasm_bindgen]
impl Bubblestone {
    /// Works for about `budget` milliseconds on a frame of the bodies. `subject` is '' for all bodies, or a
    /// body's id and the index of a step in its making, such as '12:3'. `camera` is numbers with commas
    /// between: angle, height, distance, lens, and the target's x, y, z; trailing numbers may be missing. `how`
    /// is words joined by '+': 'moving', 'still' (one sample) or 'fine' (the mean of several), 'samples=N' for
    /// another number of samples, 'aperture=A' for blur by depth, the background 'floor', 'sky' or 'nothing', and
    /// 'whole=X,Y,Z,D' or 'through=X,Y,Z,D' for a plane that cuts away bodies. If any of these differs from the last
    /// call, a new frame begins.
    #[wasm_bindgen(unchecked_return_type = "FrameSlice | Notice")]
    pub fn turn(
        &mut self,
        subject: &str,
        camera: &str,
        width: u32,
        height: u32,
        how: &str,
        budget: f64,
    ) -> Object {
        self.memory.make_room();
        let clock = &self.clock;
        let home = self.studio.generator().camera();
        let order = order(home, subject, camera, [width, height], how);
        let made = self.studio.frames().and_then(|frames| {
            let slice = frames.turn(&order, &mut || clock.now(), budget)?;
            Ok(frame_slice(slice, frames.frame()))
        });
        or_why(made)
    }

    fn frames(&mut self) -> Option<&mut dyn Frames> {
        self.studio.engine_mut().frames()
    }

    /// The body at a pixel of the last finished frame.
    #[wasm_bindgen(js_name = bodyAt, unchecked_return_type = "SeenBody | undefined")]
    pub fn body_at(&mut self, x: u32, y: u32) -> JsValue {
        let frames = self.frames();
        let body = frames.and_then(|frames| frames.body_at(x as usize, y as usize));
        body.map_or(JsValue::UNDEFINED, |body| {
            let middle: Array = body.middle.iter().map(|&v| JsValue::from(v)).collect();
            let figures = body
                .figures
                .iter()
                .map(|&(word, value)| (word, value.into()));
            let figures: Vec<(&str, JsValue)> = figures.collect();
            let words = body.words.iter().map(|(of, word)| (*of, word.into()));
            let words: Vec<(&str, JsValue)> = words.collect();
            object(&[
                ("id", body.id.into()),
                ("centre", middle.into()),
                ("figures", object(&figures).into()),
                ("words", object(&words).into()),
            ])
            .into()
        })
    }

    /// A plane of the last finished frame: 'depth', 'normal' or 'id'. Its side is the frame's width.
    #[wasm_bindgen(js_name = frameMap, unchecked_return_type = "PixelMap | Notice")]
    pub fn frame_plane(&mut self, word: &str) -> Object {
        let plane = FramePlane::of_word(word).ok_or(Notice::from(Code::NoSuchFile));
        let map = plane.and_then(|plane| {
            let frame = self.frames().and_then(|frames| frames.frame());
            Ok(frame_map(frame.ok_or(Code::NotYet)?, plane))
        });
        or_why(map.map(|map| objects::map(&map)))
    }

    /// The words of the steps in the making of a body. The subject 'ID:STEP' shows a step.
    pub fn making(&mut self, id: u32) -> Vec<String> {
        self.frames().map_or(Vec::new(), |frames| frames.making(id))
    }

    /// The place on the model at a pixel of the frame last finished, in the units of painted rows; undefined
    /// beside the model.
    #[wasm_bindgen(js_name = placeAt)]
    pub fn place_at(&mut self, x: u32, y: u32) -> Option<Vec<i32>> {
        let place = self.frames()?.place_at(x as usize, y as usize)?;
        Some(place.map(|n| n as i32).to_vec())
    }

    /// The labels that the shown view has in the frame last finished, the most important one first, at its pixels.
    #[wasm_bindgen(unchecked_return_type = "SeenLabel[]")]
    pub fn labels(&mut self) -> Array {
        let labels = self.frames().map_or(Vec::new(), |frames| frames.labels());
        let label =
            |SeenLabel {
                 text,
                 pixel: [x, y],
             }| { object(&[("text", text.into()), ("x", x.into()), ("y", y.into())]) };
        labels.into_iter().map(label).collect()
    }

    /// The caption of a view.
    #[wasm_bindgen(unchecked_return_type = "Notice | undefined")]
    pub fn caption(&mut self, words: &str) -> JsValue {
        let caption = self.frames().and_then(|frames| frames.caption(words));
        caption.map_or(JsValue::UNDEFINED, |caption| notice(&caption).into())
    }

    /// The pixel of a place as from `placeAt` in the frame last finished; undefined if the place is hidden there.
    #[wasm_bindgen(js_name = pixelOf)]
    pub fn pixel_of(&mut self, x: i32, y: i32, z: i32) -> Option<Vec<f64>> {
        let place = [x, y, z].map(i64::from);
        Some(self.frames()?.pixel_of(place)?.to_vec())
    }

    /// 16 hex digits that change with any bit of the last finished frame; '' before there is one.
    #[wasm_bindgen(js_name = frameHash)]
    pub fn frame_hash(&mut self) -> String {
        let frame = self.frames().and_then(|frames| frames.frame());
        frame.map_or(String::new(), crate::scene::Frame::hash)
    }
}

/// The hash of the still of a link by a camera: as large as the picture, with one sample for each pixel, at
/// full detail. The sentence of the problem if there is none.
#[wasm_bindgen]
pub fn frame_of_link(link: &str, camera: &str) -> String {
    let (recipe, _) = ALL.recipe(link);
    let mut studio = Studio::new(ALL, recipe);
    let side = studio.side() as u32;
    let home = studio.generator().camera();
    let order = order(home, "", camera, [side, side], "still");
    match studio.finish_frame(&order, &mut || 0.0) {
        Ok(frame) => frame.hash(),
        Err(why) => why.to_string(),
    }
}

fn order(home: Camera, subject: &str, camera: &str, size: [u32; 2], how: &str) -> TurnOrder {
    // The page has reported faulty words of a link before.
    let (camera, _) = home.read(camera);
    TurnOrder {
        subject: subject.to_owned(),
        camera,
        size: size.map(|n| n as usize),
        how: how.to_owned(),
    }
}

fn frame_slice(slice: FrameSlice, frame: Option<&crate::scene::Frame>) -> Object {
    let said = object(&[
        ("begun", slice.begun.into()),
        ("done", slice.done.into()),
        ("progress", slice.progress.into()),
    ]);
    if let Some(frame) = frame.filter(|_| slice.refined) {
        let pixels = Uint8Array::from(frame.rgba());
        // Setting a property of a fresh object cannot fail.
        let _ = js_sys::Reflect::set(&said, &"pixels".into(), &pixels);
    }
    said
}
