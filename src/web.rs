//! The face towards the browser and Node: only what stands here knows JavaScript.
//!
//! Everything is said in numbers, strings and plain objects. Nothing here throws for bad input:
//! sentences come back instead.

#[cfg(feature = "bench")]
mod bench;
mod catalogue;

pub use catalogue::{presets, schema};

use crate::domain::Outline;
use crate::export::{Map, MapKind, MeshFormat};
use crate::packing::Sample;
use crate::recipe::{Key, Recipe};
use crate::studio::{Histogram, Probe, Studio, View};
use glam::DVec2;
use js_sys::{Array, Date, Float64Array, Object, Reflect, Uint8Array, Uint32Array};
use wasm_bindgen::prelude::*;
use wasm_bindgen::{Clamped, JsCast};
use web_sys::{CanvasRenderingContext2d, ImageData, Performance};

/// Milliseconds of a clock that only goes forward, in a page, in a worker and in Node.
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

/// A pavement in the making.
#[wasm_bindgen]
pub struct Bubblestone {
    studio: Studio,
    notices: Vec<String>,
    clock: Clock,
}

#[wasm_bindgen]
impl Bubblestone {
    /// Opens a link (a whole address, a fragment, or nothing for the default recipe). What did not
    /// fit is told by `notices`.
    #[wasm_bindgen(constructor)]
    pub fn new(link: &str) -> Bubblestone {
        // The page's own module has no words for a panic: see scripts/lib/trim.mjs.
        #[cfg(debug_assertions)]
        console_error_panic_hook::set_once();
        let (recipe, notices) = Recipe::from_link(link);
        Self {
            studio: Studio::new(recipe),
            notices,
            clock: Clock::new(),
        }
    }

    /// Opens another link; answers with what was clamped, dropped or refused.
    pub fn open(&mut self, link: &str) -> Vec<String> {
        let (recipe, notices) = Recipe::from_link(link);
        self.studio.set_recipe(recipe);
        self.notices = notices;
        self.notices.clone()
    }

    /// What the last link opened said.
    pub fn notices(&self) -> Vec<String> {
        self.notices.clone()
    }

    /// The recipe's link, without '#'.
    pub fn link(&self) -> String {
        self.studio.recipe().link()
    }

    /// Sets a parameter from text: '' or a sentence that says what was clamped or refused.
    pub fn set(&mut self, key: &str, text: &str) -> String {
        let mut recipe = self.studio.recipe().clone();
        let said = recipe.set(key, text);
        if said.is_ok() {
            self.studio.set_recipe(recipe);
        }
        match said {
            Ok(notice) => notice.unwrap_or_default(),
            Err(sentence) => sentence,
        }
    }

    /// A parameter's value as text.
    pub fn get(&self, key: &str) -> String {
        self.studio.recipe().get(key)
    }

    /// Works for about `budget` milliseconds and makes at most `max_steps` packing steps (0 holds
    /// the packing still, the other stages go on). True when what is shown may have changed.
    pub fn tick(&mut self, budget: f64, max_steps: u32) -> bool {
        let clock = &self.clock;
        self.studio.tick(&mut || clock.now(), budget, max_steps)
    }

    /// Exactly one packing step; nothing when the packing is over.
    pub fn step(&mut self) {
        let clock = &self.clock;
        self.studio.step(&mut || clock.now());
    }

    /// While live, the cells flow after each change of outline, fields or packing; the end of it
    /// makes the packing again from its own start: the link's.
    #[wasm_bindgen(js_name = setLive)]
    pub fn set_live(&mut self, on: bool) {
        self.studio.set_live(on);
    }

    /// All stages again, from the same recipe.
    pub fn restart(&mut self) {
        self.studio.restart();
    }

    /// The stage at work, then 'done', or 'error' where no pavement can be made.
    pub fn stage(&self) -> String {
        self.studio.stage().to_string()
    }

    /// Why there is 'error'; '' while all is well.
    pub fn problem(&self) -> String {
        self.studio.problem().unwrap_or_default().to_string()
    }

    /// `{ cells, steps, largestMove, energy, added, removed, converged, stones, ms }`
    pub fn status(&mut self) -> Object {
        let energy = self.studio.energy();
        let last = self.studio.progress();
        object(&[
            ("cells", last.cells.into()),
            ("steps", last.step.into()),
            ("largestMove", last.largest_move.into()),
            ("energy", energy.into()),
            ("added", last.added.into()),
            ("removed", last.removed.into()),
            ("converged", last.converged.into()),
            ("stones", self.studio.stones().into()),
            ("ms", self.milliseconds().into()),
        ])
    }

    fn milliseconds(&self) -> Object {
        let times = self.studio.milliseconds();
        let entries: Vec<(&str, JsValue)> = times.iter().map(|t| (t.stage, t.ms.into())).collect();
        object(&entries)
    }

    /// Draws a view at the context's upper left corner: words joined by '+', at most one of what lies
    /// at the bottom ('auto', 'picture', 'paper', 'height', 'normals', 'albedo', 'roughness', 'ao',
    /// 'ids', 'potential') and any of what is drawn over it ('size', 'packed', 'energy', 'cells',
    /// 'mesh', 'anisotropy', 'direction', 'forces', 'singularities'; alone they stand on paper). Words
    /// that name nothing are passed over.
    pub fn draw(&mut self, context: &CanvasRenderingContext2d, view: &str) {
        let side = self.studio.side() as u32;
        let frame = self.studio.view(View::of_words(view));
        let image = ImageData::new_with_u8_clamped_array_and_sh(Clamped(frame), side, side);
        // A context that is lost draws nothing; the next frame tries again.
        let _ = image.and_then(|image| context.put_image_data(&image, 0.0, 0.0));
    }

    /// Draws beforehand, for about `budget` milliseconds, what is much to draw of a view; true when
    /// [`Bubblestone::draw`] has only the rest to do.
    pub fn prepare(&mut self, view: &str, budget: f64) -> bool {
        let clock = &self.clock;
        self.studio
            .prepare(View::of_words(view), &mut || clock.now(), budget)
    }

    /// What of a view shows nothing, and why: each as its word, ':' and 'not_yet', 'at_rest', 'no_point',
    /// 'no_mesh', 'one_size' or 'all_even'.
    pub fn absences(&mut self, view: &str) -> Vec<String> {
        let found = self.studio.absences(View::of_words(view));
        let told = found.iter().map(|(word, why)| [word, why.word()].join(":"));
        told.collect()
    }

    /// From black to white in the view 'height', in picture units; 0 before there are planes.
    #[wasm_bindgen(js_name = heightRange)]
    pub fn height_range(&self) -> f64 {
        self.studio.height_range()
    }

    /// The cell at a place in picture units: undefined where there is none, or `{ cell, x, y, kind,
    /// size, wanted, aspect, angle, off, outline, area, sides, neighbours }`, lengths in picture units,
    /// angles in degrees with y down. `angle` and `off` are null of circles; `area`, `sides` and
    /// `neighbours` are null while the cells are packed.
    pub fn probe(&mut self, x: f64, y: f64) -> JsValue {
        let probe = self.studio.probe(x, y);
        probe.map_or(JsValue::UNDEFINED, |probe| probe_object(&probe).into())
    }

    /// `{ step, energy, move }`: how the packing went so far, three lists of the same length.
    pub fn series(&self) -> Object {
        let rows = self.studio.samples();
        let column = |value: fn(&Sample) -> f64| {
            let column: Vec<f64> = rows.iter().map(value).collect();
            Float64Array::from(&column[..]).into()
        };
        object(&[
            ("step", column(|row| row.step.into())),
            ("energy", column(|row| row.energy)),
            ("move", column(|row| row.largest_move)),
        ])
    }

    /// `{ size, angle }`, each `{ from, to, counts }`: how many cells have a size so many times the
    /// wanted one, and how many stand so many degrees off the direction field.
    pub fn histograms(&mut self) -> Object {
        let [size, angle] = self.studio.histograms();
        let histogram = |Histogram { from, to, counts }: Histogram| -> JsValue {
            let counts = Uint32Array::from(&counts[..]).into();
            object(&[("from", from.into()), ("to", to.into()), ("counts", counts)]).into()
        };
        object(&[("size", histogram(size)), ("angle", histogram(angle))])
    }

    /// The cells as a standalone SVG file; '' before there are any.
    pub fn svg(&self) -> String {
        self.studio.svg()
    }

    /// `{ side, channels, bits, bytes }`: a map of the finished picture ('height', 'normal-opengl',
    /// 'normal-directx', 'albedo', 'roughness', 'ao', 'id'), values of 16 bits with the high byte
    /// first; or the sentence that says why there is none.
    pub fn map(&self, word: &str) -> JsValue {
        map_object(word, |kind| self.studio.map(kind))
    }

    /// Works for about `budget` milliseconds on the file of all cells' surfaces ('glb' or 'obj'):
    /// `{ begun, parts, done }`, the next parts of the file as bytes, whether it begins with them, and
    /// whether it ends; or the sentence that says why there is none.
    #[wasm_bindgen(js_name = meshFile)]
    pub fn mesh_file(&mut self, ending: &str, budget: f64) -> JsValue {
        let Some(&(format, _)) = MeshFormat::ALL.iter().find(|(_, word)| *word == ending) else {
            return NO_SUCH_FILE.into();
        };
        let clock = &self.clock;
        match self.studio.mesh_file(format, &mut || clock.now(), budget) {
            Ok(slice) => {
                let parts = slice.parts.iter().map(|part| Uint8Array::from(&part[..]));
                object(&[
                    ("begun", slice.begun.into()),
                    ("parts", parts.collect::<Array>().into()),
                    ("done", slice.done.into()),
                ])
                .into()
            }
            Err(sentence) => sentence.into(),
        }
    }

    /// Works for about `budget` milliseconds on the finished picture at `scale` (1 to 4) times its side:
    /// `{ begun, done, progress, side, rows }`, where `rows` are red, green, blue of the next whole rows,
    /// mostly none yet; or the sentence that says why there is none. `stopFile` frees what it holds.
    #[wasm_bindgen(js_name = pictureFile)]
    pub fn picture_file(&mut self, scale: u32, budget: f64) -> JsValue {
        let clock = &self.clock;
        let made = self
            .studio
            .picture_file(scale as usize, &mut || clock.now(), budget);
        match made {
            Ok(slice) => object(&[
                ("begun", slice.begun.into()),
                ("done", slice.done.into()),
                ("progress", slice.progress.into()),
                ("side", (slice.side as u32).into()),
                ("rows", Uint8Array::from(&slice.rows[..]).into()),
            ])
            .into(),
            Err(sentence) => sentence.into(),
        }
    }

    /// As `map`, of the picture that `pictureFile` finished last.
    #[wasm_bindgen(js_name = biggerMap)]
    pub fn bigger_map(&self, word: &str) -> JsValue {
        map_object(word, |kind| self.studio.bigger_map(kind))
    }

    /// Stops `meshFile` or `pictureFile` and frees what they hold.
    #[wasm_bindgen(js_name = stopFile)]
    pub fn stop_file(&mut self) {
        self.studio.stop_file();
    }

    /// The fields of the native program's report.json, as text.
    pub fn report(&mut self) -> String {
        let mut report = self.studio.report();
        report.notices.clone_from(&self.notices);
        report.json()
    }

    /// The default of a number in the recipe at hand.
    #[wasm_bindgen(js_name = defaultOf)]
    pub fn default_of(&self, key: &str) -> f64 {
        let key = Key::from_word(key);
        key.map_or(0.0, |key| self.studio.recipe().default_of(key))
    }

    /// Hex digest of the planes; '' until done.
    pub fn digest(&self) -> String {
        self.studio.digest()
    }

    /// Makes a free polygon of rings (x, y, x, y, ...; in any order) the outline:
    /// '' or the sentence that says what is wrong with it; then the last good outline stays.
    #[wasm_bindgen(js_name = setOutline)]
    pub fn set_outline(&mut self, points: &[f64], ring_lengths: &[u32]) -> String {
        let outline = match rings_of(points, ring_lengths) {
            Ok(outline) => outline,
            Err(sentence) => return sentence,
        };
        let mut recipe = self.studio.recipe().clone();
        let said = recipe.set_polygon(&outline);
        if said.is_ok() {
            self.studio.set_recipe(recipe);
        }
        match said {
            Ok(notices) => notices.join(" "),
            Err(sentence) => sentence,
        }
    }

    /// `{ points, rings }`: the outline in use, x, y, x, y, ... and the rings' lengths in points.
    pub fn outline(&self) -> Object {
        let numbers = |ring: &&[DVec2]| ring.iter().flat_map(|p| [p.x, p.y]).collect();
        let rings: Vec<Vec<f64>> = self.studio.rings().iter().map(numbers).collect();
        rows_object(&rings, 2, ["points", "rings"])
    }

    /// `{ numbers, rows }`: a list parameter's numbers row after row, lengths in sides of the
    /// picture, and how many numbers each row has. `set` takes them back as text, with commas
    /// between numbers and semicolons between rows.
    pub fn list(&self, key: &str) -> Object {
        let rows = Key::from_word(key).map_or(Vec::new(), |key| self.studio.recipe().list(key));
        rows_object(&rows, 1, ["numbers", "rows"])
    }

    /// Which of the parts that lines cut the outline into holds this point; -1 outside.
    pub fn part(&self, x: f64, y: f64) -> i32 {
        let p = DVec2::new(x, y);
        let domain = self.studio.domain().filter(|domain| domain.contains(p));
        domain.map_or(-1, |domain| domain.part(p) as i32)
    }

    /// Pixels along the picture's side.
    pub fn side(&self) -> u32 {
        self.studio.side() as u32
    }
}

fn probe_object(probe: &Probe) -> Object {
    let number = |x: Option<f64>| x.map_or(JsValue::NULL, JsValue::from);
    let outline: Vec<f64> = probe.outline.iter().flat_map(|p| [p.x, p.y]).collect();
    let polygon = probe.polygon;
    object(&[
        ("cell", probe.cell.into()),
        ("x", probe.centre.x.into()),
        ("y", probe.centre.y.into()),
        ("kind", probe.kind.word().into()),
        ("size", probe.size.into()),
        ("wanted", probe.wanted.into()),
        ("aspect", probe.aspect.into()),
        ("angle", number(probe.angle)),
        ("off", number(probe.off)),
        ("outline", Float64Array::from(&outline[..]).into()),
        ("area", number(polygon.map(|p| p.area))),
        ("sides", number(polygon.map(|p| p.sides as f64))),
        ("neighbours", number(polygon.map(|p| p.neighbours as f64))),
    ])
}

/// Said of words that name no file.
const NO_SUCH_FILE: &str = "There is no file of that name.";

fn map_object(word: &str, made: impl Fn(MapKind) -> Result<Map, String>) -> JsValue {
    let kind = MapKind::of_word(word).ok_or(NO_SUCH_FILE.to_owned());
    match kind.and_then(made) {
        Ok(map) => object(&[
            ("side", (map.side as u32).into()),
            ("channels", map.channels.into()),
            ("bits", map.bits.into()),
            ("bytes", Uint8Array::from(&map.bytes[..]).into()),
        ])
        .into(),
        Err(sentence) => sentence.into(),
    }
}

/// Cuts a list of coordinates into rings.
fn rings_of(points: &[f64], lengths: &[u32]) -> Result<Outline, String> {
    let total: u64 = lengths.iter().map(|&n| u64::from(n)).sum();
    if lengths.is_empty() || 2 * total != points.len() as u64 {
        return Err(format!(
            "The outline has {} numbers, but its rings ask for {}; the last outline is kept.",
            points.len(),
            2 * total
        ));
    }
    let mut points = points.chunks_exact(2).map(DVec2::from_slice);
    let ring = |&length: &u32| points.by_ref().take(length as usize).collect();
    Ok(Outline {
        rings: lengths.iter().map(ring).collect(),
        ..Outline::default()
    })
}

/// Rows of numbers one after the other, and their lengths in units of `size` numbers.
fn rows_object(rows: &[Vec<f64>], size: usize, [numbers, lengths]: [&str; 2]) -> Object {
    let counts: Vec<u32> = rows.iter().map(|row| (row.len() / size) as u32).collect();
    object(&[
        (numbers, Float64Array::from(&rows.concat()[..]).into()),
        (lengths, Uint32Array::from(&counts[..]).into()),
    ])
}

fn object(entries: &[(&str, JsValue)]) -> Object {
    let object = Object::new();
    for (key, value) in entries {
        // Setting a property of a fresh object cannot fail.
        let _ = Reflect::set(&object, &(*key).into(), value);
    }
    object
}

/// A seed for the dice: any whole number below 2^32.
#[wasm_bindgen]
pub fn random_seed() -> u32 {
    // Where the browser has no source of chance, the clock will do for a throw of dice.
    getrandom::u32().unwrap_or_else(|_| Date::now() as u64 as u32)
}

/// The digest of a link's planes, all worked out at once; the problem's sentence where there are
/// none.
#[wasm_bindgen]
pub fn digest_of_link(link: &str) -> String {
    let (recipe, _) = Recipe::from_link(link);
    let mut studio = Studio::new(recipe);
    match studio.finish(&mut || 0.0) {
        Ok(()) => studio.digest(),
        Err(sentence) => sentence,
    }
}

/// What working out a link took and gave: the fields of the native program's report.json, and
/// `problem` where it could not be done.
#[wasm_bindgen]
pub fn report_of_link(link: &str) -> Object {
    let (recipe, notices) = Recipe::from_link(link);
    let mut studio = Studio::new(recipe);
    let clock = Clock::new();
    let problem = studio.finish(&mut || clock.now()).err();
    let mut report = studio.report();
    report.notices = notices;
    let parsed = js_sys::JSON::parse(&report.json()).map(JsCast::unchecked_into);
    let object: Object = parsed.unwrap_or_default();
    if let Some(sentence) = problem {
        let _ = Reflect::set(&object, &"problem".into(), &sentence.into());
    }
    object
}
