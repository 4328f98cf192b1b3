//! The catalogue of a module: generators, parameters and presets.

use super::object;
use crate::decimal;
use crate::generators::{ALL, Course, Generator, MeasuredPart, Preset, SampleRule, Timing};
use crate::recipe::{Item, Kind, Parameter};
use js_sys::{Array, Object, Reflect};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r"
/** One row of the parameter schema. */
export interface Parameter {
  key: string;
  /** The papers' symbol, or ''. */
  symbol: string;
  name: string;
  kind: 'number' | 'int' | 'choice' | 'text';
  min: number;
  max: number;
  step: number;
  default: string;
  unit: string;
  help: string;
  group: string;
  /** Whether it is one of the main parameters. */
  main: boolean;
  /** Whether randomising leaves it as it is. */
  steady: boolean;
  choices: { word: string; label: string }[];
  /** The content of a text's rows; '' for other kinds. Traces and patches lie on the bodies, and a file has one row. */
  item: '' | 'ring' | 'line' | 'spot' | 'seed' | 'bubble' | 'trace' | 'patch' | 'file' | 'feature' | 'plan' | 'opening';
  /** It applies only while another parameter has one of these words or, if there are none, differs from its default. */
  shownFor?: { key: string; words: string[] } | undefined;
}

/** A generator and what it offers. */
export interface Generator {
  /** The word in `make=` of a link. */
  word: string;
  title: string;
  /** The words of its stages, in their order. */
  stages: string[];
  /** The beginning of each stage, as a share of the time of common recipes; empty if unknown. */
  begins: number[];
  /** The stage that makes single steps; '' if none does. */
  stepping: string;
  /** The stage that makes one body after the other; '' if none does. */
  placing: string;
  /** The first stage that no longer changes the bodies; '' if unknown. */
  settled: string;
  /** The view that shows each stage in the automatic view; '' for the bodies. Empty if unknown. */
  seen: string[];
  /** Words of views: at most one base, and overlays. */
  bases: string[];
  overlays: string[];
  /** The parts of the page that it needs. */
  offers: string[];
  /** Keys of the parameters that describe a recipe without a name best. */
  names: string[];
  /** Rules for small pictures of the words of choices; see `SampleRule`. */
  samples: SampleRule[];
  /** The word of the table of ranges for randomising. */
  chance: string;
  /** The first camera for its bodies: numbers with commas between. */
  home: string;
  /** The lowest camera, in degrees. */
  lowest: number;
}

/**
 * A rule for small pictures of the words of choices: for these words, or for all but those in `without`. The choices of
 * all keys show the pictures of the first key. `link` has the other values of their recipes, `view` what is seen.
 */
export interface SampleRule {
  keys: string[];
  words: string[];
  without: string[];
  link: string;
  view: string;
}

export interface Preset {
  name: string;
  title: string;
  /** The title of its group on the page. */
  group: string;
  /** The figure of the paper, or ''. */
  figure: string;
  note: string;
  link: string;
  /** The words of its view, as a link has them; '' for the usual view. */
  view: string;
  /** The time that it took in the paper, if the paper prints it. */
  timing: Timing | null;
}

export interface Timing {
  /** The machine that it was measured on. */
  machine: string;
  /** The paper's parts of the work, with the stages here that do the same. */
  parts: { name: string; stages: string[]; seconds: number }[];
  /** The number of bodies in the paper's figure; 0 if it is not printed. */
  bodies: number;
}
";

/// The generators of this module; the first one is for links that name none.
#[wasm_bindgen(unchecked_return_type = "Generator[]")]
pub fn generators() -> Array {
    ALL.iter().map(generator_object).collect()
}

fn generator_object(generator: &'static Generator) -> Object {
    let Course {
        begins,
        stepping,
        placing,
        settled,
        seen,
        ..
    } = generator.course;
    let begins: Array = begins.iter().map(|&share| JsValue::from(share)).collect();
    let samples: Array = generator.samples.iter().map(sample_object).collect();
    object(&[
        ("word", generator.schema.word.into()),
        ("title", generator.title.into()),
        ("stages", words(generator.stages)),
        ("begins", begins.into()),
        ("stepping", stepping.into()),
        ("placing", placing.into()),
        ("settled", settled.into()),
        ("seen", words(seen)),
        ("bases", words(generator.views.bases)),
        ("overlays", words(generator.views.overlays)),
        ("offers", words(generator.offers)),
        ("names", words(generator.names)),
        ("samples", samples.into()),
        ("chance", generator.chance.into()),
        ("home", generator.home.into()),
        ("lowest", generator.lowest.into()),
    ])
}

fn sample_object(sample: &SampleRule) -> Object {
    object(&[
        ("keys", words(sample.keys)),
        ("words", words(sample.words)),
        ("without", words(sample.without)),
        ("link", sample.link.into()),
        ("view", sample.view.into()),
    ])
}

fn words(words: &[&str]) -> JsValue {
    let words: Array = words.iter().map(|&word| JsValue::from(word)).collect();
    words.into()
}

/// A generator's parameters, in the order of its links; empty for an unknown word.
#[wasm_bindgen(unchecked_return_type = "Parameter[]")]
pub fn schema(word: &str) -> Array {
    let generator = ALL.named(word).into_iter();
    let rows = generator.flat_map(|generator| generator.schema.rows);
    rows.map(parameter_object).collect()
}

fn parameter_object(p: &Parameter) -> Object {
    let default = match p.kind {
        Kind::Number | Kind::Int => decimal::text(p.default).into(),
        Kind::Choice => p.choices.first().map_or("", |c| c.word).into(),
        Kind::Text => "".into(),
    };
    let choices: Array = p
        .choices
        .iter()
        .map(|c| object(&[("word", c.word.into()), ("label", c.label.into())]))
        .collect();
    let row = object(&[
        ("key", p.key.0.into()),
        ("symbol", p.symbol.into()),
        ("name", p.name.into()),
        ("kind", p.kind.word().into()),
        ("min", p.min.into()),
        ("max", p.max.into()),
        ("step", p.step.into()),
        ("default", default),
        ("unit", p.unit.into()),
        ("help", p.help.into()),
        ("group", p.group.into()),
        ("main", p.is_main.into()),
        ("steady", p.is_steady.into()),
        ("choices", choices.into()),
        ("item", p.item.map_or("", Item::word).into()),
    ]);
    if let Some((key, only)) = p.shown_for {
        let only = object(&[("key", key.0.into()), ("words", words(only))]);
        let _ = Reflect::set(&row, &"shownFor".into(), &only);
    }
    row
}

/// A generator's named recipes, in the order of the page; empty for an unknown word.
#[wasm_bindgen(unchecked_return_type = "Preset[]")]
pub fn presets(word: &str) -> Array {
    let generator = ALL.named(word).into_iter();
    let presets = generator.flat_map(|generator| generator.presets);
    presets.map(preset_object).collect()
}

fn preset_object(p: &Preset) -> Object {
    let timing = p.timing.as_ref().map(timing_object);
    object(&[
        ("name", p.name.into()),
        ("title", p.title.into()),
        ("group", p.group.into()),
        ("figure", p.figure.into()),
        ("note", p.note.into()),
        ("link", p.link.into()),
        ("view", p.view.into()),
        ("timing", timing.map_or(JsValue::NULL, JsValue::from)),
    ])
}

fn timing_object(timing: &Timing) -> Object {
    let part = |part: &MeasuredPart| {
        object(&[
            ("name", part.name.into()),
            ("stages", words(part.stages)),
            ("seconds", part.seconds.into()),
        ])
    };
    let parts: Array = timing.parts().map(part).collect();
    object(&[
        ("machine", timing.machine.into()),
        ("parts", parts.into()),
        ("bodies", timing.bodies.unwrap_or(0).into()),
    ])
}
