//! Every row of Table 1 of Itoh, Miyata, Shimada (2003), Generation of Organic Textures with
//! Controlled Anisotropy and Directionality via Packing Rectangular and Elliptical Cells.
//!
//! The seconds are those of Table 2, which has six of the thirteen. The paper prints no coordinates
//! and no colours, so outlines, lines and palettes are ours, in the spirit of the figures.

use super::{Part, Preset, Timing};
use crate::recipe::Stage;

/// The seconds of Table 2.
const fn timing(tessellation: f64, skin: f64) -> Option<Timing> {
    let (first, rest) = Stage::ALL.split_at(5);
    Some(Timing {
        machine: "Pentium III, 933 MHz",
        parts: [
            Part {
                name: "tessellation",
                stages: first,
                seconds: tessellation,
            },
            Part {
                name: "skin",
                stages: rest.split_at(2).0,
                seconds: skin,
            },
        ],
    })
}

/// A row of Table 1: name, figure, note, link, seconds.
macro_rules! paper {
    ($name:literal, $figure:literal, $note:literal, $link:expr, $timing:expr) => {
        Preset {
            name: $name,
            title: concat!("Fig. ", $figure),
            group: "Paper: skins",
            figure: concat!("Fig. ", $figure, " of 2003"),
            note: $note,
            link: $link,
            timing: $timing,
        }
    };
}

/// Fig. 14: a hide, in which the aspect ratio changes.
#[rustfmt::skip]
macro_rules! fig14 {
    ($change:literal) => {
        concat!(
            "v=1&outline=polygon&poly=w0wB-oBlqB4sEnT-6F2nCu0F0wDm8FisEo8Fm-D8oG23BqqH-P4sHhVqqHjeqvF__vBAqvB9xG0iBjlI9fr0GtmCnlGrtD1wF9zDtrFx7Cj3F_9Bv5FxEpvG4OrhF&kind=ellipse",
            $change, "&cs=17&dir=strokes&strokes=-oB-oBlK2wLy5E0wLqhHk8KsmD05M9xCi3O.umjBju9Bt9B2nKq4F0wLoqIklM0nCi3OlzB05M&stone=skin&dr=0&palette=mossy&ground=dark")
    };
}

/// Fig. 15: a flank, in which the skew changes.
#[rustfmt::skip]
macro_rules! fig15 {
    ($change:literal) => {
        concat!(
            "v=1&outline=polygon&poly=4eggQqpB3vE4gC5_D-sDhhD8sFp2Bw5GvXigHrO4lH9P4sH5GqxGwMwvF8cq0EkwBoqD82CkwB6qEmGsxFjD6jGmGs9GhD6vH5hB02G_kCyxF3jDs4EtqE04Dh_F4yC_lH6yBpqHqev0HgTn5HzBxqG7lBvkE9xC_1Cr2D_5B7zEnc58FNv6GkDhvGtIv3F7EnsF&kind=ellipse&cs=20&dir=strokes&strokes=AyiOq_E-hCyjH84CwjHgyBolG9MolGxzB-7G7uCkgJ99Dk3Jl5E-7G_tD.___ByiuB29E8uCkiHoqDymH08BgzG5Jm3Gv3BmlHviDk3I9vF8kJp7GouG39E&stone=skin&sr=2",
            $change, "&tc=0.8&af=0.2&palette=slate&ground=dark")
    };
}

/// Fig. 16: a limb, in which the taper changes.
#[rustfmt::skip]
macro_rules! fig16 {
    ($change:literal) => {
        concat!(
            "v=1&outline=polygon&poly=058B4eickhF8M45GpvB8hHxrC2gHtmD46F7xC81F1CmsG0rBstG0-Ci3G25C6jFnq4BAurB5jFg7Bh3G2nCnxGmzBpoGvLz5E9xBx5Ez-C_hG15Cz3G3VnqIoB_2G&kind=rectangle&cs=20&dir=strokes&strokes=u9B4ewUohPq4F05Mu9BmzJ76Dy5MtmD86L.oz5Bvi-B-oB86L76DyiOp4F0wL-oBy5Mq4F86L&stone=skin&sv=1.3",
            $change, "&palette=sandstone&ground=dark")
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
        "v=1&outline=polygon&poly=mz5B4eojBw9H2uBkqK6zBi-JqoBsoJgHy7GlRg-F5zBi3GzyB6jFp41BAsP5jFkFh3GziB_9FpvBx7G9xBroJ_fh-J0ZpqK6jBp9H&lines=41XA5aigHjO-_ImqBggIm8BggIo8BggImqBggIjO-_I7aigH.4-I___B7aigHjO-_ImqBggIo8BggIm8BggImqBggIjO-_I5aigH&kind=ellipse&parts=gggBgggBC&cs=24&gb=0.65&gd=0.4&dir=strokes&strokes=smD4et9B0nS-xCumT-xCy5MvU86L.86zBvi-B-xC0nSk8CumTlKy5MtmD86L&stone=skin&sv=3&sc=2&tc=0.7&palette=porphyry&ground=dark", None),
    paper!("skin17-b", "17 (b)",
        "A belly: plates across between two lines, hexagons beside them.",
        "v=1&outline=polygon&poly=4e4ewi-BAAwi-Bvi-BA&lines=w0QAt0BigH_xB-_IzCggIkXggI8sBggIw5BggI6jC-_Ii3BigH.2na___Bu0BigHgyB-_I0CggIjXggI7sBggIv5BggI5jC-_Ih3BigH&kind=ellipse&parts=gggBgggBC&cs=20&dir=constant&strokes=AvU05Mm8CsmT2esmT1e05Ml8C.___B05c05Mk8CsmT4esmT3e05Mj8C.___B05c05Mk8CsmT4esmT3e05Mj8C&reach=1&stone=skin&sr=0.8&palette=limestone&ground=dark", timing(32.0, 4.8)),
    paper!("skin17-c", "17 (c)",
        "A face: rings of plates around the eye, a line for the mouth.",
        "v=1&outline=polygon&poly=4e4ewi-BAAwi-Bvi-BA.g5fjylBriBpmBtzBrZ58BhJ58BiJtzBsZriBqmBjMitBkMgtBsiBqmBuzBuZ68BgJ68B_IuzBtZsiBpmBiM_sB&lines=svkBm8ajN0lC1lB8-B_6B4xBjqC-fpyCiLpyChLlqC9f96B3xB1lB7-BjNzlCkN1lC2lB7-B-6B3xBmqC9fqyChLqyCiLkqC-fg7B4xB2lB8-BkN2lC.whKA3O05DrrBwzDhmC6nDl9Cu2CrvDshCj8DqoB7iE4N7iE3Nj8DpoBrvDrhCl9Ct2ChmC5nDtrBvzD1Oz5D2O15DurBvzDimC5nDm9Ct2CsvDphCk8DroB8iE1N8iE2Nk8DsoBsvDqhCm9Cu2CimC6nDsrBwzD4O25D.pugBilc-oGhuBkuI5jBkuImqB66I2nBqhKhuBk8Hp4B&kind=ellipse&parts=klcgggBC.A41HC&cs=19&dir=strokes&stone=skin&sv=1.6&sr=2&dr=0.1&palette=mossy&ground=dark", timing(16.0, 4.0)),
    paper!("skin17-d", "17 (d)",
        "A tail: rectangles only, five lines across.",
        "v=1&outline=polygon&poly=058B4erP2wGzZywIziBm-HnvB6hIrhC6hI_tCm-HllDywIjzC2wGjudApqC1wGv5CxwI5jCl-Hh3B5hI9f5hIvdl-Hj3BxwIpvB1wG&lines=A41HggQm8CggQ2eggQ1eggQl8C.___BiuNggQm8CggQ4eggQ3eggQl8C.___B05MggQm8CggQ2eggQ1eggQl8C.___BklMggQm8CggQ2eggQ1eggQl8C.___B2nKggQk8CggQ4eggQ3eggQj8C&kind=rectangle&cs=20&gy=-0.3&dir=strokes&stone=skin&tc=0.1&dr=0&palette=basalt&ground=dark", timing(10.0, 3.9)),
];
