//! Every row of Table 1 of Itoh, Miyata, Shimada (2003), Generation of Organic Textures with
//! Controlled Anisotropy and Directionality via Packing Rectangular and Elliptical Cells.
//!
//! The seconds are those of Table 2, which has six of the thirteen rows. The paper prints no
//! coordinates and no colours, so outlines, lines and palettes are ours, in the spirit of the
//! figures.

use super::{MeasuredPart, Preset, Timing};
use crate::generators::pavement::stage;

/// The times of a skin in the paper's Table 2, in seconds.
const fn timing(tessellation: f64, skin: f64) -> Option<Timing> {
    let (first, rest) = stage::WORDS.split_at(5);
    Some(Timing {
        machine: "Pentium III, 933 MHz",
        first: MeasuredPart {
            name: "tessellation",
            stages: first,
            seconds: tessellation,
        },
        second: Some(MeasuredPart {
            name: "skin",
            stages: rest.split_at(2).0,
            seconds: skin,
        }),
        bodies: None,
    })
}

/// A row of Table 1: name, figure, note, link, seconds.
macro_rules! paper {
    ($name:literal, $figure:literal, $note:literal, $link:expr, $timing:expr) => {
        Preset {
            name: $name,
            title: concat!("Fig. ", $figure),
            group: "Paper: skin",
            figure: concat!("Fig. ", $figure, " of 2003"),
            note: $note,
            link: $link,
            view: "",
            timing: $timing,
        }
    };
}

/// Fig. 14: a hide, in which the aspect ratio changes.
#[rustfmt::skip]
macro_rules! fig14 {
    ($change:literal) => {
        concat!(
            "v=1&outline=polygon&poly=q41BrvEvmB8oH9Wk3IiuB-_F6sC2wFogDo8Fi4C8oG8rB0-GwNu4H_YumKrgBwrI5j1BAi3BjuJqvBnhLjOhgHpvBx5FtuC1wFr1CtrF1mCtrFjwBllGatrJyPx9H&kind=ellipse",
            $change, "&cs=17&dir=strokes&strokes=-oBrvErQgpR62D0wL6jFk8Ku9B05MrmDsvU.iutB3-oCt9BggQ86D0wLq4FklMs5Bi3Or5B-xS&start=quadtree&stone=skin&dr=0&palette=lizard&vary=1.2&ground=hide&gloss=glossy&pattern=rosettes&pn=0.22&ps=0.8&pm=0.8&rim=0.35&belly=0.6&ba=45&el=40&diff=1.3")
    };
}

/// Fig. 15: a flank, in which the skew changes.
#[rustfmt::skip]
macro_rules! fig15 {
    ($change:literal) => {
        concat!(
            "v=1&outline=polygon&poly=-oB-oR4mBtyEm8BlpE8pDvpDwuFp6B-7Gzag8GtR61GhTg2G5Jy6FsIs4EyXq9D6pB-6CguC4vBq8D2NghFA45FhD6_GxQ04H5pB8_GlkCq4Fr9Cq_Ej9Du_D9mF26CzmG66B7vG6iBjjHgRrsH5G7_F9oB76D1vCtuCzxD12BzwExfz9FxHr8G5BrsGzHzqF5B56E&kind=ellipse&cs=20&dir=strokes&strokes=AyiOq_E-hCyjH84CwjHgyBolG9MolGxzB-7G7uCkgJ99Dk3Jl5E-7G_tD.___ByiuB29E8uCkiHoqDymH08BgzG5Jm3Gv3BmlHviDk3I9vF8kJp7GouG39E&start=quadtree&stone=skin&sr=2",
            $change, "&tc=0.8&af=0.2&palette=coral&gloss=glossy&rim=-0.5&belly=0.6&ba=60&az=160&el=50&amb=1.3&diff=1.4")
    };
}

/// Fig. 16: a limb, in which the taper changes.
#[rustfmt::skip]
macro_rules! fig16 {
    ($change:literal) => {
        concat!(
            "v=1&outline=polygon&poly=058BrmDic2jH8Mq8IpvBoqHxrCq4GtmD46F7xC81F7D4jG6sB61G8oD05I-jDsmHlz5BA81BrmHglCz5I8oC15GgyB7_FvLz5E9xBx5Ez-Cx5F15ChgH3V5sKoBx5I&kind=rectangle&cs=19&dir=strokes&strokes=u9BrmDwUsmTq4F05Mu9BmzJ76Dy5M76DggQ.2n6B3smC-oBggQ76DyiOp4F0wL-oBy5M6sGggQ&stone=skin&sv=1.3",
            $change, "&palette=desert&ground=hide&gloss=glossy&pattern=bands&pn=0.25&pa=90&pc=0.35&rim=0.5&belly=0.5&ba=45&el=40&diff=1.3")
    };
}

#[rustfmt::skip]
pub(super) const PRESETS: &[Preset] = &[
    paper!("skin14-a", "14 (a)",
        "A hide: cells a half longer than wide.",
        fig14!("&ca=1.5"), timing(31.0, 5.3)),
    paper!("skin14-b", "14 (b)",
        "The same hide, its cells twice as long as wide.",
        fig14!(""), timing(34.0, 4.2)),
    paper!("skin14-c", "14 (c)",
        "The same hide, its cells three times as long as wide.",
        fig14!("&ca=3"), timing(32.0, 3.8)),
    paper!("skin15-a", "15 (a)",
        "Spines that stand upright: tapered, not skewed.",
        fig15!(""), None),
    paper!("skin15-b", "15 (b)",
        "Skewed along the flow, they lie over each other as scales.",
        fig15!("&sc=2"), None),
    paper!("skin15-c", "15 (c)",
        "Skewed still farther: long overlapping scales.",
        fig15!("&sc=3"), None),
    paper!("skin16-a", "16 (a)",
        "A limb in rows of blocks, not tapered.",
        fig16!("&tc=0"), None),
    paper!("skin16-b", "16 (b)",
        "A little tapered: the blocks bulge.",
        fig16!(""), None),
    paper!("skin16-c", "16 (c)",
        "Tapered by half: each is a knob.",
        fig16!("&tc=0.5"), None),
    paper!("skin17-a", "17 (a)",
        "A back: rows of plates between two lines, flanks of overlapping scales.",
        "v=1&outline=polygon&poly=-5mC__PkxBggMujBggMhBggMzkBggMlxBggM1dggM6IggMspBggMvrvCArpB__L5I__L2d__LmxB__L0kB__LiB__LtjB__LlxB__L&lines=oyU__PkxBggMujBggMfggM1kBggMjxBggM3dggM6IggMspBggM.0xU___CmxBggMsjBggMfggM1kBggMjxBggM1dggM6IggMspBggM&kind=ellipse&parts=gggBgggBC&cs=30&dir=strokes&strokes=goE__PkxBggMujBggMfggM1kBggMjxBggM1dggM6IggMqpBggM.u-K___CkxBggMujBggMfggM1kBggMjxBggM1dggM6IggMspBggM.o5O___CmxBggMujBggMhBggMzkBggMlxBggM1dggM6IggMspBggM.q5O___CkxBggMujBggMfggM1kBggMjxBggM3dggM6IggMspBggM.u-K___CkxBggMujBggMfggM1kBggMjxBggM1dggM6IggMspBggM&reach=1&stone=skin&sv=3&sc=2&tc=0.7&palette=snake&vary=1.3&ground=hide&gloss=glossy&pattern=lines&pn=0.1&rim=0.5&az=90&el=38&diff=1.35", None),
    paper!("skin17-b", "17 (b)",
        "A belly: plates across between two lines, hexagons beside them.",
        "v=1&outline=polygon&poly=rmDrmD4smCAA4smC3smCA&lines=-oR76Dz-Bw9In8Bs9K7D6nIsYm4HurBm4H-6B6nIiuCs9KqhCw9I.4-Y31nC0-Bw9Io8Bs9K8D6nIrYm4HzrBm4H36B6nIhuCs9KphCw9I&kind=ellipse&parts=gggBgggBC&cs=20&dir=constant&strokes=AvU05Mm8CsmT2esmT1e05Ml8C.___B05c05Mk8CsmT4esmT3e05Mj8C.___B05c05Mk8CsmT4esmT3e05Mj8C&reach=1&stone=skin&sr=0.8&palette=desert&vary=1.2&ground=hide&gloss=glossy&rim=0.5&az=135&el=40", timing(32.0, 4.8)),
    paper!("skin17-c", "17 (c)",
        "A face: rings of plates around the eye, a line for the mouth.",
        "v=1&outline=polygon&poly=76D76D41nCAA41nC31nCA.m9mB1-oB5Rp-B_xB3xBnoCzbpwCApoC0b9xB4xB5Rq-B6Ro-B-xB4xBqoC0bqwCAooCzbgyB3xB.jXn-B3NouB1mBilB93BwU79BA73BvU1mBhlB3NnuB4NpuB2mBhlB83BvU89BA-3BwU2mBilB&lines=i3uBm8ahbyxEzuCqjEn6DooDn6E4iC5qFkX5qFjXl6E3iCn6DnoD1uCpjE_axxEgbzxE2uCpjEo6DnoDm6E3iC6qFjX6qFkXo6E4iCo6DooD0uCqjEib0xE.9xyB86T2nKu9B0wL8xCm8KgpBk8K_oB0wL76Dw0Q76D&kind=ellipse&parts=4-oBm8aC&cs=20&spots=iudm8aiuF05F&strokes=9xC05MyrP7jFsmT9xCsmT-xCyrP8jF.7jlCggwBq4Vu9BumTvUklcrvE.jlMx5cklMsmD.7jlCrmD4-I_oB.1nKumT2nKu9B0wL8xCm8KgpBk8K_oB0wL76Dw0Q76D&reach=0.1&start=quadtree&stone=skin&sv=1.6&sr=2&dr=0.1&palette=lizard&ground=hide&gloss=glossy&pattern=lines&pn=0.04&ps=0.3&el=40", timing(16.0, 4.0)),
    paper!("skin17-d", "17 (d)",
        "A tail: rectangles only, five lines across.",
        "v=1&outline=polygon&poly=iu9BrmDxZozI7jBkzK5jBsmIhuB05H1-B05H1wCsmI15DkzKznDozIj8aA5-CnzI_tDjzKtmCrmIt0Bz5H3ez5H1ermIphCjzKx5BnzI&lines=A41HggQm8CggQ2eggQ1eggQl8C.___BiuNggQm8CggQ4eggQ3eggQl8C.___B05MggQm8CggQ2eggQ1eggQl8C.___BklMggQm8CggQ2eggQ1eggQl8C.___B2nKggQk8CggQ4eggQ3eggQj8C&kind=rectangle&cs=20&gy=-0.3&dir=strokes&stone=skin&tc=0.1&dr=0&palette=lizard&ground=hide&gloss=glossy&pattern=boundary&pn=0.06&ps=0.9&rim=0.35&el=44&amb=1.1&diff=1.3", timing(10.0, 3.9)),
];
