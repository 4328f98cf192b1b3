//! What there is to choose from: parameters and presets.

use super::object;
use crate::decimal;
use crate::generators::{ALL, Generator, Part, Preset, Timing};
use crate::recipe::{Kind, Parameter};
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
  /** It is one of those that matter most. */
  main: boolean;
  /** Chance leaves it as it is. */
  steady: boolean;
  choices: { word: string; label: string }[];
  /** It applies only while another parameter has one of these words or, where there are none, is not at its default. */
  shownFor?: { key: string; words: string[] } | undefined;
}

/** What can be made. */
export interface Generator {
  /** As `make=` in the link. */
  word: string;
  title: string;
  /** In their order. */
  stages: string[];
  /** Words of views: at most one base, and overlays. */
  bases: string[];
  overlays: string[];
  /** The page's parts that it needs. */
  offers: string[];
  /** From where its bodies are seen at first: the numbers of a camera, with commas between. */
  home: string;
}

export interface Preset {
  name: string;
  title: string;
  /** What it stands under on the page. */
  group: string;
  /** The figure of the paper, or ''. */
  figure: string;
  note: string;
  link: string;
  /** How long it took in the paper, where that is printed. */
  timing: Timing | null;
}

export interface Timing {
  /** What it was measured on. */
  machine: string;
  /** The paper's parts of the work, and the stages here that do the same. */
  parts: { name: string; stages: string[]; seconds: number }[];
}
";

/// The generators of this module; the first is that of links that name none.
#[wasm_bindgen(unchecked_return_type = "Generator[]")]
pub fn generators() -> Array {
    ALL.iter().map(generator_object).collect()
}

fn generator_object(generator: &'static Generator) -> Object {
    let words = |words: &[&str]| -> JsValue {
        let words: Array = words.iter().map(|&word| JsValue::from(word)).collect();
        words.into()
    };
    object(&[
        ("word", generator.schema.word.into()),
        ("title", generator.title.into()),
        ("stages", words(generator.stages)),
        ("bases", words(generator.views.bases)),
        ("overlays", words(generator.views.overlays)),
        ("offers", words(generator.offers)),
        ("home", generator.home.into()),
    ])
}

/// A generator's parameters, in the order of its links; none of an unknown word.
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
    ]);
    if let Some((key, words)) = p.shown_for {
        let words: Array = words.iter().map(|&w| JsValue::from(w)).collect();
        let only = object(&[("key", key.0.into()), ("words", words.into())]);
        let _ = Reflect::set(&row, &"shownFor".into(), &only);
    }
    row
}

/// A generator's named recipes, in the order of the page; none of an unknown word.
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
        ("timing", timing.map_or(JsValue::NULL, JsValue::from)),
    ])
}

fn timing_object(timing: &Timing) -> Object {
    let part = |part: &Part| {
        let stages: Array = part.stages.iter().map(|&s| JsValue::from(s)).collect();
        object(&[
            ("name", part.name.into()),
            ("stages", stages.into()),
            ("seconds", part.seconds.into()),
        ])
    };
    let parts: Array = timing.parts.iter().map(part).collect();
    object(&[("machine", timing.machine.into()), ("parts", parts.into())])
}
