//! Every row of Table 1 of the papers on pavements: Miyata, Itoh, Shimada (2000), A Method of
//! Generating Pavement Textures Using the Square Packing Technique, and its Japanese journal version
//! of 2001, whose figures are numbered one lower.
//!
//! The seconds are those of the 2001 table; the rows 15(a) and 15(b) have the distortions that the
//! text of 2000 and the table of 2001 give them. The papers print no coordinates, so the outlines
//! are ours, in the spirit of the figures.

use super::{MeasuredPart, Preset, Timing};
use crate::generators::pavement::stage;

/// The times Ts and Tt of the 2001 paper.
const fn timing(packing: f64, texture: f64) -> Option<Timing> {
    let (first, second) = stage::WORDS.split_at(3);
    Some(Timing {
        machine: "Pentium II, 300 MHz",
        first: MeasuredPart {
            name: "packing",
            stages: first,
            seconds: packing,
        },
        second: Some(MeasuredPart {
            name: "texture",
            stages: second,
            seconds: texture,
        }),
        bodies: None,
    })
}

/// A row of the table: name, figures of 2000 and 2001, note, link, Ts, Tt.
macro_rules! paper {
    ($name:literal, $first:literal, $second:literal, $note:literal, $link:literal, $ts:literal, $tt:literal) => {
        Preset {
            name: $name,
            title: concat!("Fig. ", $first, " / ", $second),
            group: "Papers: stone",
            figure: concat!("Fig. ", $first, " of 2000, Fig. ", $second, " of 2001"),
            note: $note,
            link: $link,
            view: "",
            timing: timing($ts, $tt),
        }
    };
}

#[rustfmt::skip]
pub(super) const PRESETS: &[Preset] = &[
    paper!("fig13-1b", "13 (1b)", "12 (1b)",
        "The average pavement, from which the other two of the figure start.",
        "v=1&outline=road_s&on=1&az=215&el=38&amb=1.1&diff=1.25", 2.1, 8.4),
    paper!("fig13-2b", "13 (2b)", "12 (2b)",
        "Smaller stones, a little varied in size.",
        "v=1&outline=road_s&on=1&cs=18&vs=0.1&palette=sandstone&az=215&el=38&amb=1.1&diff=1.25", 2.1, 8.8),
    paper!("fig13-3b", "13 (3b)", "12 (3b)",
        "The sizes of the stones vary widely.",
        "v=1&outline=road_s&on=1&vs=0.3&seed=2&cells=packed&palette=limestone&ground=moss&wear=0.3&az=215&el=38&amb=1.1&diff=1.25", 2.1, 8.7),
    paper!("fig14-b", "14 (b)", "13 (b)",
        "Cobblestones; the flagstones of (c) have the same packing.",
        "v=1&outline=road_s&ow=1.2&cs=20&hs=20&palette=sandstone&ground=moss&az=205&el=36", 11.9, 10.5),
    paper!("fig14-c", "14 (c)", "13 (c)",
        "Flagstones on the packing of (b).",
        "v=1&outline=road_s&ow=1.2&cs=20&stone=flag&hs=12&dr=0.2&fd=1.4&af=1.4&palette=sandstone&ground=moss&az=205&el=36", 11.9, 11.3),
    paper!("fig15-a", "15 (a)", "14 (a)",
        "The average distortion of the stones.",
        "v=1&outline=road_straight&ow=1.6&oa=-30&sv=1.1&hs=20&palette=sandstone&vary=1.2&ground=soil&soft=0.4&amb=1.1&diff=1.3", 3.6, 7.8),
    paper!("fig15-b", "15 (b)", "14 (b)",
        "No distortion: most stones have the same shape.",
        "v=1&outline=road_straight&ow=1.6&oa=-30&sv=1.1&hs=20&dr=0&palette=limestone&vary=1.2&ground=moss&soft=0.3&amb=1.1&diff=1.3", 3.6, 7.7),
    paper!("fig15-c", "15 (c)", "14 (c)",
        "High distortion.",
        "v=1&outline=road_straight&ow=1.6&oa=-30&sv=1.1&hs=20&dr=0.6&vary=1.3&ground=moss&az=215&el=38&amb=1.1&diff=1.3", 3.6, 7.9),
    paper!("fig16-a", "16 (a)", "15 (a)",
        "Holes: the stones stream around them.",
        "v=1&outline=plaza&cs=21&palette=porphyry&ground=gravel&az=215&el=40&amb=1.1&diff=1.2", 9.1, 9.3),
    paper!("fig16-b", "16 (b)", "15 (b)",
        "A fork, with large distorted cobbles.",
        "v=1&outline=y_fork&ow=1.2&cs=25&hs=20&dr=0.5&palette=mossy&ground=soil&az=300&el=40", 7.4, 13.6),
    paper!("fig16-c", "16 (c)", "15 (c)",
        "Cut-outs, with small flat flagstones.",
        "v=1&outline=road_notch&ow=1.4&on=2&cs=15&stone=flag&hs=8&dr=0.2&fd=1.3&af=1&palette=terracotta&vary=1.2&ground=dark&el=38&amb=1.15&diff=1.35", 2.1, 8.8),
    paper!("fig16-d", "16 (d)", "15 (d)",
        "A crossing, its flagstones wider than their cells.",
        "v=1&outline=crossing&ow=1.2&stone=flag&sv=1.1&hs=14&palette=sandstone&ground=moss&soft=0.4&az=200&el=36&amb=1.1&diff=1.2", 4.0, 11.8),
    paper!("fig16-e", "16 (e)", "15 (e)",
        "A ring of flagstones.",
        "v=1&cs=20&stone=flag&hs=12&dr=0.2&fd=1.3&af=1.2&palette=terracotta&vary=1.2&ground=mortar&el=40", 4.8, 12.7),
    paper!("fig16-f", "16 (f)", "15 (f)",
        "Bends, with wide joints.",
        "v=1&outline=road_s&ow=1.3&on=3&cs=20&sv=0.8&palette=marble&vary=1.2&ground=moss&soft=0.6&az=240&el=38&diff=1.2", 3.6, 8.2),
];
