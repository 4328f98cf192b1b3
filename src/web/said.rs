//! Notices as objects for the page.

use super::object;
use crate::notice::{Arg, Notice};
use js_sys::{Array, Object};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r"
/** A message for people: a code, its arguments by name, and the whole text in English. */
export interface Notice {
  code: string;
  args: Record<string, NoticeArg>;
  text: string;
}

/**
 * An argument: text that is the same in all languages, a parameter, a word of a choice, a part of the sentence, or a
 * list of these.
 */
export type NoticeArg = string | { key: string; name: string } | { key: string; word: string; label: string } | Notice | NoticeArg[];

/** The result of a change: if it was refused, the reason; else the values that were clamped or corrected. */
export interface Answer {
  refused: boolean;
  notices: Notice[];
}
";

pub(super) fn notice(notice: &Notice) -> Object {
    let args = notice.args.iter().map(|(name, arg)| (*name, value(arg)));
    let args: Vec<(&str, JsValue)> = args.collect();
    object(&[
        ("code", notice.code.word().into()),
        ("args", object(&args).into()),
        ("text", notice.to_string().into()),
    ])
}

fn value(arg: &Arg) -> JsValue {
    match arg {
        Arg::Text(text) => text.into(),
        Arg::Parameter { key, name } => {
            object(&[("key", (*key).into()), ("name", (*name).into())]).into()
        }
        Arg::Choice { key, word, label } => object(&[
            ("key", (*key).into()),
            ("word", (*word).into()),
            ("label", (*label).into()),
        ])
        .into(),
        Arg::Part(part) => notice(part).into(),
        Arg::AnyOf(all) => all.iter().map(value).collect::<Array>().into(),
    }
}

pub(super) fn all(notices: &[Notice]) -> Array {
    notices.iter().map(notice).collect()
}

pub(super) fn answer(said: &Result<Vec<Notice>, Notice>) -> Object {
    let notices = match said {
        Ok(mended) => all(mended),
        Err(why) => Array::of1(&notice(why)),
    };
    object(&[
        ("refused", said.is_err().into()),
        ("notices", notices.into()),
    ])
}

/// The result, or the notice with the reason why there is none.
pub(super) fn or_why(made: Result<Object, Notice>) -> Object {
    made.unwrap_or_else(|why| notice(&why))
}
