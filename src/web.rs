//! The interface to browsers and Node. Only this module knows JavaScript.
//!
//! All results are numbers, strings and plain objects, whose types are declared where they are made. Nothing
//! here throws for bad input; notices are returned instead.

#[cfg(feature = "bench")]
mod bench;
mod catalogue;
mod directions;
mod files;
#[cfg(house)]
mod given;
mod memory;
mod objects;
mod said;
mod steps;
#[cfg(house)]
mod turn;

pub use catalogue::{generators, presets, schema};

use crate::domain::Outline;
use crate::generators::{ALL, Inspect, Outlines};
use crate::notice::{Code, Notice};
use crate::recipe::Recipe;
use crate::studio::Studio;
use glam::DVec2;
use js_sys::{Array, Date, Object, Reflect};
use memory::Memory;
use said::{all, answer, notice};
use wasm_bindgen::prelude::*;
use wasm_bindgen::{Clamped, JsCast};
use web_sys::{CanvasRenderingContext2d, ImageData, Performance};

/// A clock in milliseconds that never goes back, in a page, in a worker and in Node.
struct Clock(Option<Performance>);

impl Clock {
    fn new() -> Self {
        let performance = Reflect::get(&js_sys::global(), &"performance".into());
        let performance = performance.ok().filter(JsValue::is_object);
        Self(performance.map(JsCast::unchecked_into))
    }

    fn now(&self) -> f64 {
        self.0.as_ref().map_or_else(Date::now, Performance::now)
    }
}

/// A picture of any generator, while it is made.
#[wasm_bindgen]
pub struct Bubblestone {
    studio: Studio,
    notices: Vec<Notice>,
    clock: Clock,
    memory: Memory,
    /// The file that is being received.
    #[cfg(house)]
    arriving: Option<crate::generators::GivenFile>,
}

#[wasm_bindgen]
impl Bubblestone {
    /// Opens a link (a whole address, a fragment, or nothing for the default recipe). `notices` lists the parts
    /// that did not fit.
    #[wasm_bindgen(constructor)]
    pub fn new(link: &str) -> Bubblestone {
        // A release ends at a panic without a message: the hook would add its words to the download.
        #[cfg(debug_assertions)]
        console_error_panic_hook::set_once();
        let (recipe, notices) = ALL.recipe(link);
        Self {
            studio: Studio::new(ALL, recipe),
            notices,
            clock: Clock::new(),
            memory: Memory::default(),
            #[cfg(house)]
            arriving: None,
        }
    }

    /// Opens another link. Returns notices on values that were clamped, dropped or refused.
    #[wasm_bindgen(unchecked_return_type = "Notice[]")]
    pub fn open(&mut self, link: &str) -> Array {
        let (recipe, notices) = ALL.recipe(link);
        self.studio.set_recipe(recipe);
        self.notices = notices;
        self.notices()
    }

    /// The notices of the last link opened.
    #[wasm_bindgen(unchecked_return_type = "Notice[]")]
    pub fn notices(&self) -> Array {
        all(&self.notices)
    }

    /// The recipe's link, without '#'.
    pub fn link(&self) -> String {
        self.studio.recipe().link()
    }

    /// The word of the generator at work.
    pub fn generator(&self) -> String {
        self.studio.generator().schema.word.to_owned()
    }

    /// Sets a parameter from text.
    #[wasm_bindgen(unchecked_return_type = "Answer")]
    pub fn set(&mut self, key: &str, text: &str) -> Object {
        let mut recipe = self.studio.recipe().clone();
        let said = recipe.set(key, text);
        self.take(recipe, said)
    }

    fn inspect(&mut self) -> Option<&mut dyn Inspect> {
        self.studio.engine_mut().inspect()
    }

    fn outlines(&mut self) -> Option<&mut dyn Outlines> {
        self.studio.engine_mut().outlines()
    }

    /// Takes a recipe, unless the change was refused.
    fn take(&mut self, recipe: Recipe, said: Result<Vec<Notice>, Notice>) -> Object {
        if said.is_ok() {
            self.studio.set_recipe(recipe);
        }
        answer(&said)
    }

    /// A parameter's value as text.
    pub fn get(&self, key: &str) -> String {
        self.studio.recipe().get(key)
    }

    /// Works for about `budget` milliseconds and makes at most `max_steps` packing steps (with 0 the packing
    /// pauses, but the other stages go on). True if the picture may have changed.
    pub fn tick(&mut self, budget: f64, max_steps: u32) -> bool {
        self.memory.make_room();
        let clock = &self.clock;
        self.studio.tick(&mut || clock.now(), budget, max_steps)
    }

    /// Makes exactly one packing step; does nothing when the packing is over.
    pub fn step(&mut self) {
        let clock = &self.clock;
        self.studio.step(&mut || clock.now());
    }

    /// While live, the cells flow after each change of outline, fields or packing. At the end the packing is
    /// made again from its own start, as the link describes it.
    #[wasm_bindgen(js_name = setLive)]
    pub fn set_live(&mut self, on: bool) {
        self.studio.set_live(on);
    }

    /// Makes the steps again, from the held one if there is one, and all stages after them, for the same recipe.
    pub fn restart(&mut self) {
        self.studio.restart();
    }

    /// The stage at work, then 'done', or 'error' if no picture can be made.
    pub fn stage(&self) -> String {
        self.studio.stage().to_string()
    }

    /// The reason for the stage 'error'; undefined without an error.
    #[wasm_bindgen(unchecked_return_type = "Notice | undefined")]
    pub fn problem(&self) -> JsValue {
        let problem = self.studio.problem();
        problem.map_or(JsValue::UNDEFINED, |why| notice(why).into())
    }

    /// Remarks on the result: repairs, and what does not fit or end well.
    #[wasm_bindgen(unchecked_return_type = "Notice[]")]
    pub fn remarks(&self) -> Array {
        all(&self.studio.engine().remarks())
    }

    /// The progress of the work.
    #[wasm_bindgen(unchecked_return_type = "Status")]
    pub fn status(&mut self) -> Object {
        let energy = self.studio.engine_mut().energy();
        objects::status(&self.studio.progress(), energy, &self.studio.milliseconds())
    }

    /// Draws a view at the context's upper left corner. A view is words joined by '+': at most one base
    /// ('auto', 'picture', 'paper', 'height', 'normals', 'albedo', 'roughness', 'ao', 'ids', 'potential') and
    /// any overlays ('size', 'packed', 'energy', 'cells', 'mesh', 'anisotropy', 'direction', 'forces',
    /// 'singularities'; without a base they are drawn on paper). The words 'x2' and 'x3' ask for two or three pixels
    /// along each unit of the picture's side: drawings have them, if they are not more than 2048 along a side. The
    /// potential has at most two, and nothing has more with 'size'. Unknown words are ignored. Returns the pixels along
    /// the drawing's side.
    pub fn draw(&mut self, context: &CanvasRenderingContext2d, view: &str) -> u32 {
        let frame = self.studio.engine_mut().view(view);
        let side = (frame.len() / 4).isqrt() as u32;
        let image = ImageData::new_with_u8_clamped_array_and_sh(Clamped(frame), side, side);
        // A lost context draws nothing; the next frame tries again.
        let _ = image.and_then(|image| context.put_image_data(&image, 0.0, 0.0));
        side
    }

    /// Prepares the large parts of a view for about `budget` milliseconds; true when only the rest is left to
    /// [`Bubblestone::draw`].
    pub fn prepare(&mut self, view: &str, budget: f64) -> bool {
        let clock = &self.clock;
        let engine = self.studio.engine_mut();
        engine.prepare(view, &mut || clock.now(), budget)
    }

    /// The parts of a view that show nothing, with the reason: each as its word, ':' and 'not_yet', 'at_rest',
    /// 'no_point', 'no_mesh', 'one_size' or 'all_even'.
    pub fn absences(&mut self, view: &str) -> Vec<String> {
        let found = self
            .inspect()
            .map_or(Vec::new(), |cells| cells.absences(view));
        let told = found.iter().map(|&(word, why)| [word, why].join(":"));
        told.collect()
    }

    /// The difference in height between black and white in the view 'height', in picture units; 0 before there
    /// are planes.
    #[wasm_bindgen(js_name = heightRange)]
    pub fn height_range(&mut self) -> f64 {
        self.inspect().map_or(0.0, |cells| cells.height_range())
    }

    /// The cell at a place in picture units.
    #[wasm_bindgen(unchecked_return_type = "Probe | undefined")]
    pub fn probe(&mut self, x: f64, y: f64) -> JsValue {
        let cells = self.inspect();
        let probe = cells.and_then(|cells| cells.probe(DVec2::new(x, y)));
        probe.map_or(JsValue::UNDEFINED, |probe| objects::probe(&probe).into())
    }

    /// The progress of the packing so far.
    #[wasm_bindgen(unchecked_return_type = "Series")]
    pub fn series(&mut self) -> Object {
        objects::series(self.inspect().map_or(&[], |cells| cells.samples()))
    }

    /// Histograms of the cells: sizes relative to the wanted ones, and angles to the direction field in
    /// degrees.
    #[wasm_bindgen(unchecked_return_type = "Histograms")]
    pub fn histograms(&mut self) -> Object {
        let cells = self.inspect();
        objects::histograms(&cells.map(|cells| cells.histograms()).unwrap_or_default())
    }

    /// The default of a number in the present recipe.
    #[wasm_bindgen(js_name = defaultOf)]
    pub fn default_of(&self, key: &str) -> f64 {
        let recipe = self.studio.recipe();
        let row = recipe.schema().row(key);
        row.map_or(0.0, |row| recipe.default_of(row))
    }

    /// The digest of the planes in hex; '' until done.
    pub fn digest(&self) -> String {
        self.studio.digest()
    }

    /// Sets the outline to a free polygon of rings (x, y, x, y, ...; in any order). If it is refused, the last
    /// valid outline stays.
    #[wasm_bindgen(js_name = setOutline, unchecked_return_type = "Answer")]
    pub fn set_outline(&mut self, points: &[f64], ring_lengths: &[u32]) -> Object {
        let mut recipe = self.studio.recipe().clone();
        let said = match self.outlines() {
            Some(drawn) => {
                rings_of(points, ring_lengths).and_then(|outline| drawn.draw(&mut recipe, &outline))
            }
            None => Err(Code::NoOutline.into()),
        };
        self.take(recipe, said)
    }

    /// The present outline.
    #[wasm_bindgen(unchecked_return_type = "Rings")]
    pub fn outline(&mut self) -> Object {
        let numbers = |ring: &&[DVec2]| ring.iter().flat_map(|p| [p.x, p.y]).collect();
        let rings = self.outlines().map_or(Vec::new(), |drawn| drawn.rings());
        let rings: Vec<Vec<f64>> = rings.iter().map(numbers).collect();
        objects::rows(&rings, 2, ["points", "rings"])
    }

    /// A list parameter. `set` takes it back as text, with commas between numbers and semicolons between rows.
    #[wasm_bindgen(unchecked_return_type = "Rows")]
    pub fn list(&self, key: &str) -> Object {
        let recipe = self.studio.recipe();
        let row = recipe.schema().row(key);
        let rows = row.map_or(Vec::new(), |row| recipe.list(row.key));
        objects::rows(&rows, 1, ["numbers", "rows"])
    }

    /// The index of the part that contains this point, if lines divide the outline; -1 outside.
    pub fn part(&mut self, x: f64, y: f64) -> i32 {
        let drawn = self.outlines();
        let part = drawn.and_then(|drawn| drawn.part(DVec2::new(x, y)));
        part.map_or(-1, |part| part as i32)
    }

    /// Pixels along the picture's side.
    pub fn side(&self) -> u32 {
        self.studio.side() as u32
    }
}

/// Cuts a list of coordinates into rings.
fn rings_of(points: &[f64], lengths: &[u32]) -> Result<Outline, Notice> {
    let total: u64 = lengths.iter().map(|&n| u64::from(n)).sum();
    if lengths.is_empty() || 2 * total != points.len() as u64 {
        let notice = Notice::new(Code::OutlineNumbers).with("n", points.len());
        return Err(notice.with("asked", (2 * total).to_string()));
    }
    let mut points = points.chunks_exact(2).map(DVec2::from_slice);
    let ring = |&length: &u32| points.by_ref().take(length as usize).collect();
    Ok(Outline {
        rings: lengths.iter().map(ring).collect(),
        ..Outline::default()
    })
}

fn object(entries: &[(&str, JsValue)]) -> Object {
    let object = Object::new();
    for (key, value) in entries {
        // Setting a property of a fresh object cannot fail.
        let _ = Reflect::set(&object, &(*key).into(), value);
    }
    object
}

/// A random seed: any whole number below 2^32.
#[wasm_bindgen]
pub fn random_seed() -> u32 {
    // If the browser has no random source, the clock is good enough for a throw of dice.
    getrandom::u32().unwrap_or_else(|_| Date::now() as u64 as u32)
}

/// The digest of a link's planes or bodies, computed in one call; the sentence of the problem if there are none. For
/// programs that compare results between machines.
#[wasm_bindgen]
pub fn digest_of_link(link: &str) -> String {
    let (recipe, _) = ALL.recipe(link);
    let mut studio = Studio::new(ALL, recipe);
    match studio.form(&mut || 0.0) {
        Ok(()) => studio.engine().digest(),
        Err(why) => why.to_string(),
    }
}
