//! Recipes with names: every row of Table 1 of the papers, and others of the house.
//!
//! The papers are Miyata, Itoh, Shimada (2000), A Method of Generating Pavement Textures Using the
//! Square Packing Technique, and its Japanese journal version of 2001, whose figures are numbered one
//! lower. The seconds are those of the 2001 table; the rows 15(a) and 15(b) have the distortions
//! that the text of 2000 and the table of 2001 give them. The papers print no coordinates, so the
//! outlines are ours, in the spirit of the figures.

use super::Recipe;

/// A named recipe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Preset {
    /// Short name for scripts, unique.
    pub name: &'static str,
    /// Title on the page.
    pub title: &'static str,
    /// What it stands under on the page.
    pub group: &'static str,
    /// The papers' figures, empty for other presets.
    pub figure: &'static str,
    /// One sentence about it.
    pub note: &'static str,
    /// The fragment without `#`, as [`Recipe::link`] writes it.
    pub link: &'static str,
    /// Seconds of the packing in the 2001 paper (Ts, Pentium II, 300 MHz).
    pub packing_seconds: Option<f64>,
    /// Seconds of the texture in the 2001 paper (Tt).
    pub texture_seconds: Option<f64>,
}

impl Preset {
    /// The preset's recipe.
    pub fn recipe(&self) -> Recipe {
        Recipe::from_link(self.link).0
    }
}

/// Those without a figure.
const fn free(
    group: &'static str,
    name: &'static str,
    title: &'static str,
    note: &'static str,
    link: &'static str,
) -> Preset {
    Preset {
        name,
        title,
        group,
        figure: "",
        note,
        link,
        packing_seconds: None,
        texture_seconds: None,
    }
}

/// A row of the papers' table: name, figures of 2000 and 2001, note, link, Ts, Tt.
macro_rules! paper {
    ($name:literal, $first:literal, $second:literal, $note:literal, $link:literal, $ts:literal, $tt:literal) => {
        Preset {
            name: $name,
            title: concat!("Fig. ", $first, " / ", $second),
            group: "Papers",
            figure: concat!("Fig. ", $first, " of 2000, Fig. ", $second, " of 2001"),
            note: $note,
            link: $link,
            packing_seconds: Some($ts),
            texture_seconds: Some($tt),
        }
    };
}

const HOUSE: &str = "House";
const KINDS: &str = "Kinds, fields";

/// All presets, in the order of the page.
#[rustfmt::skip]
pub const PRESETS: &[Preset] = &[
    free(HOUSE, "ring", "Granite ring",
        "Where every visit begins: cobbles run round and round.",
        ""),
    free(HOUSE, "piazza", "Sandstone piazza",
        "Flagstones part around flower beds in the evening sun.",
        "v=1&outline=plaza&cs=27&vs=0.06&stone=flag&sv=0.98&hs=12&dr=0.14&fd=1.35&af=1.3&palette=sandstone&ground=mortar&az=205&el=30"),
    free(HOUSE, "serpentine", "Basalt serpentine",
        "Small dark setts follow five bends.",
        "v=1&outline=road_s&ow=1.45&on=5&cs=11&hs=9&dr=0.35&fd=1.4&af=1.1&palette=basalt"),
    free(HOUSE, "star", "Terracotta star",
        "Tiles with eight tips, laid in mortar.",
        "v=1&outline=star&ow=1.5&on=8&cs=19&stone=flag&sv=0.96&hs=9&dr=0.08&bh=0.14&fd=1.3&af=0.8&palette=terracotta&vary=1.3&ground=mortar&el=50"),
    free(HOUSE, "spiral", "Marble spiral",
        "White, rose and green pebbles wind inwards on sand.",
        "v=1&outline=road_spiral&ow=1.5&cs=15&vs=0.18&sv=0.96&hs=14&dr=0.22&fd=1.2&af=0.4&palette=marble&vary=1.2"),
    free(HOUSE, "lane", "Mossy lane",
        "Old stones through a garden, late in the day.",
        "v=1&outline=road_s&ow=1.25&cs=26&vs=0.15&dr=0.4&palette=mossy&ground=moss&az=240&el=36"),
    free(HOUSE, "ripples", "Porphyry ripples",
        "Stones grow from the middle of the crossing outwards.",
        "v=1&outline=crossing&ow=1.3&cs=17&gr=0.7&hs=15&dr=0.4&palette=porphyry&ground=soil"),
    free(HOUSE, "fountain", "Fountain court",
        "Marble setts make room for a basin.",
        "v=1&outline=plaza&ow=0.8&on=1&cs=16&vs=0.05&hs=12&dr=0.25&af=1&palette=marble&ground=soil"),
    free(HOUSE, "lantern", "Lantern at the fork",
        "Basalt at night: one lamp, long shadows.",
        "v=1&outline=y_fork&ow=1.25&cs=20&dr=0.4&palette=basalt&ground=dark&light=point&lx=0.5&ly=0.42&lz=0.16&amb=0.5&diff=1.3&spec=1.5"),

    free(KINDS, "bubbles", "Bubble mesh",
        "Circles settle like soap bubbles, six around each.",
        "v=1&outline=plaza&ow=0.9&on=1&kind=circle&cs=22&hs=14&dr=0.18&palette=marble&vary=1.3&ground=soil"),
    free(KINDS, "scales", "Ellipses on a curve",
        "Cells twice as long as wide swim along the bends.",
        "v=1&outline=road_s&ow=1.6&kind=ellipse&cs=18&hs=14&dr=0.15&fd=1.2&af=0.8&palette=slate&ground=dark&spec=1.3"),
    free(KINDS, "bricks", "Bricks round a ring",
        "Rectangles in courses, as long as two are wide.",
        "v=1&kind=rectangle&cs=20&stone=flag&sv=0.97&hs=9&dr=0.1&bh=0.12&fd=1.35&af=1.2&palette=terracotta&vary=1.3&ground=mortar&el=48"),
    free(KINDS, "whirl", "Spiral of squares",
        "All rows leave the middle at the same angle.",
        "v=1&outline=square&cs=17&gr=0.4&dir=spiral&fa=60&hs=10&dr=0.2&palette=porphyry"),
    free(KINDS, "rosette", "Rosette",
        "Two circles are constraint lines: rows follow them on both sides.",
        "v=1&outline=square&lines=05sBgggBnKk7Cpe02C3wB0tC9gC-gCztC4wBz2Cqej7CoKj7CnKz2CpeztC3wB9gC9gC3wBztCpez2CnKj7CoKj7Cqez2C4wBztC-gC9gC0tC3wB02Cpek7CnKk7CoK02Cqe0tC4wB-gC-gC4wB0tCqe02CoKk7C.0wLAzJ05Dvc62D1uB6wD7_BooDnvC68C58CovCnoD8_B5wD2uB52Dwcz5D0Jz5DzJ52Dvc5wD1uBnoD7_B58CnvCnvC58C7_BnoD1uB5wDvc52DzJz5D0Jz5Dwc52D2uB5wD8_BnoDovC58C68CnvCooD7_B6wD1uB62Dvc05DzJ05D0J62Dwc6wD2uBooD8_B68CovCovC68C8_BooD2uB6wDwc62D0J05D&cs=15&stone=flag&hs=8&dr=0.1&bh=0.14&palette=sandstone&ground=mortar"),
    free(KINDS, "courses", "Honeycomb, courses",
        "Lines cut the square in three; each part has a kind of its own.",
        "v=1&outline=square&lines=rmDs7VohHmzCqhHu-BohH-MqhHtqBohHnuCohHluCqhHtqBohH-MqhHu-BohHmzC.3smC0xPohHmzCqhHu-BohH-MqhHtqBohHluCohHnuCqhHtqBohH-MqhHu-BohHmzC&kind=circle&parts=gggBgggBC&cs=18&dir=strokes&hs=12&dr=0.2&palette=marble&ground=soil"),
    free(KINDS, "eye", "Graded circles",
        "The nearer to a wall, the smaller.",
        "v=1&outline=plaza&on=1&kind=circle&cs=22&gb=0.4&gd=0.2&hs=12"),
    free(KINDS, "craters", "Size spots",
        "Two soft spots of small cells among large ones.",
        "v=1&outline=square&kind=circle&cs=30&spots=6jVohXq4VmT.2nas4Vw0QmT&hs=16&dr=0.2&palette=basalt&ground=gravel"),
    free(KINDS, "reptile", "Strokes and a spot",
        "Rows follow a painted stroke; in a spot cells are longer.",
        "v=1&outline=square&kind=ellipse&ca=1.8&stretch=gggB05c6sW6sG&cs=20&gb=0.6&gd=0.3&dir=strokes&strokes=mzJ058B6sG5sWggQlzJggQnzJ6sG__P&hs=11&dr=0.15&fd=1.2&af=0.8&palette=mossy&ground=dark"),
    free(KINDS, "starfish", "Ellipses in a star",
        "Two-fold directions meet in singular points: look at the fields.",
        "v=1&outline=star&ow=1.4&on=7&kind=ellipse&cs=17&hs=12&dr=0.15&palette=limestone&ground=dark"),
    free(KINDS, "tile", "Seamless tile",
        "The picture repeats without a seam, to all sides.",
        "v=1&tile=1&kind=ellipse&cs=25&dir=strokes&strokes=9oBohfg1Gu6E-0G0nDg1G8Jg1G13Cg1Gv1Eg1Gv1Eg1G13Cg1G8J-0G0nDg1Gu6E&reach=0.3&hs=14&dr=0.2&palette=marble&vary=1.2&ground=dark"),
    free(KINDS, "voronoi", "Voronoi",
        "To compare: the cells of random points, as many as would be packed.",
        "v=1&outline=plaza&cs=24&cells=voronoi&sv=0.98&hs=12&palette=limestone&ground=soil"),
    free(KINDS, "lloyd", "Lloyd",
        "The same, evened out by fifty rounds of Lloyd’s relaxation.",
        "v=1&outline=plaza&cs=24&cells=lloyd&sv=0.98&hs=12&palette=limestone&ground=soil"),
    free(KINDS, "packed", "Bubbles, the same",
        "The same number of packed circles: even cells along every wall.",
        "v=1&outline=plaza&kind=circle&cs=24&sv=0.98&hs=12&palette=limestone&ground=soil"),

    paper!("fig13-1b", "13 (1b)", "12 (1b)",
        "The average pavement, from which the other two of the figure start.",
        "v=1&outline=road_s&on=1", 2.1, 8.4),
    paper!("fig13-2b", "13 (2b)", "12 (2b)",
        "Smaller stones, a little varied in size.",
        "v=1&outline=road_s&on=1&cs=18&vs=0.1", 2.1, 8.8),
    paper!("fig13-3b", "13 (3b)", "12 (3b)",
        "The sizes of the stones vary widely.",
        "v=1&outline=road_s&on=1&vs=0.3", 2.1, 8.7),
    paper!("fig14-b", "14 (b)", "13 (b)",
        "Cobblestones; the flagstones of (c) have the same packing.",
        "v=1&outline=road_s&ow=1.2&cs=20&hs=20", 11.9, 10.5),
    paper!("fig14-c", "14 (c)", "13 (c)",
        "Flagstones on the packing of (b).",
        "v=1&outline=road_s&ow=1.2&cs=20&stone=flag&hs=12&dr=0.2&fd=1.4&af=1.4", 11.9, 11.3),
    paper!("fig15-a", "15 (a)", "14 (a)",
        "The average distortion of the stones.",
        "v=1&outline=road_straight&ow=1.6&oa=-30&sv=1.1&hs=20", 3.6, 7.8),
    paper!("fig15-b", "15 (b)", "14 (b)",
        "No distortion: most stones have the same shape.",
        "v=1&outline=road_straight&ow=1.6&oa=-30&sv=1.1&hs=20&dr=0", 3.6, 7.7),
    paper!("fig15-c", "15 (c)", "14 (c)",
        "High distortion.",
        "v=1&outline=road_straight&ow=1.6&oa=-30&sv=1.1&hs=20&dr=0.6", 3.6, 7.9),
    paper!("fig16-a", "16 (a)", "15 (a)",
        "Holes: the stones stream around them.",
        "v=1&outline=plaza&cs=21", 9.1, 9.3),
    paper!("fig16-b", "16 (b)", "15 (b)",
        "A fork, with large distorted cobbles.",
        "v=1&outline=y_fork&ow=1.2&cs=25&hs=20&dr=0.5", 7.4, 13.6),
    paper!("fig16-c", "16 (c)", "15 (c)",
        "Cut-outs, with small flat flagstones.",
        "v=1&outline=road_notch&ow=1.4&on=2&cs=15&stone=flag&hs=8&dr=0.2&fd=1.3&af=1", 2.1, 8.8),
    paper!("fig16-d", "16 (d)", "15 (d)",
        "A crossing, its flagstones wider than their cells.",
        "v=1&outline=crossing&ow=1.2&stone=flag&sv=1.1&hs=14", 4.0, 11.8),
    paper!("fig16-e", "16 (e)", "15 (e)",
        "A ring of flagstones.",
        "v=1&cs=20&stone=flag&hs=12&dr=0.2&fd=1.3&af=1.2", 4.8, 12.7),
    paper!("fig16-f", "16 (f)", "15 (f)",
        "Bends, with wide joints.",
        "v=1&outline=road_s&ow=1.3&on=3&cs=20&sv=0.8", 3.6, 8.2),
];
