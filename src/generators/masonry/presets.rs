//! Recipes with names: buildings, and figures of Legakis, Dorsey, Gortler (2001), whose text gives no numbers for them.

use crate::generators::Preset;

/// A figure of the paper.
const fn drawn(
    [name, title, figure]: [&'static str; 3],
    note: &'static str,
    link: &'static str,
) -> Preset {
    Preset::drawn(["The paper's figures", name, title, figure], note, link)
}

/// A figure of the paper in a view of its own.
const fn viewed(
    words: [&'static str; 3],
    note: &'static str,
    [link, view]: [&'static str; 2],
) -> Preset {
    Preset {
        view,
        ..drawn(words, note, link)
    }
}

/// The link to the steps of figure 8 with herringbone, and a view of them from near.
macro_rules! steps {
    () => {
        "v=1&make=masonry&building=steps&steps_steps=5&steps_width=20&steps_tread=3&steps_column=8&steps_height=22&pattern=diagonal&dressing=yellow&ground=paving&moss=0.1"
    };
}
macro_rules! near {
    ($words:literal) => {
        concat!($words, "camera=330,16,2.5")
    };
}

/// All presets, in the order of the page.
#[rustfmt::skip]
pub const PRESETS: &[Preset] = &[
    Preset::plain(
        ["Buildings", "cottage", "Cottage"],
        "Red brick with pale sills and quoins stands under slates in evening light.",
        "v=1&make=masonry",
    ),
    Preset::plain(
        ["Buildings", "farmhouse", "Farmhouse"],
        "Rough grey stones turn every corner of an L-shaped house, and moss grows on its tiles.",
        "v=1&make=masonry&building=lhouse&pattern=ashlar&module=ashlar&rough=0.5&walls=grey&roof=stone&moss=0.5&yaw=140",
    ),
    Preset::plain(
        ["Buildings", "stone-house", "Stone house"],
        "Honey-coloured ashlar frames its windows with long and short pale stones.",
        "v=1&make=masonry&pattern=ashlar&module=ashlar&rough=0.4&walls=honey&roof=tiles",
    ),
    Preset::plain(
        ["Buildings", "garden-wall", "Garden wall"],
        "Three openings have a round and two straight heads, and a coping keeps the rain off.",
        "v=1&make=masonry&building=wall&pattern=coped&ground=gravel&moss=0.45&az=60",
    ),
    Preset::plain(
        ["Buildings", "brick-tower", "Round tower"],
        "The bond closes all around a damp tower, and a coping lies on top.",
        "v=1&make=masonry&building=tower&pattern=coped&walls=yellow&damp=0.8&moss=0.4",
    ),
    Preset::plain(
        ["Buildings", "brick-gate", "Gate"],
        "Two rings of bricks on edge carry the wall above a round arch.",
        "v=1&make=masonry&building=gate&pattern=coped&walls=yellow&ground=paving",
    ),
    Preset::plain(
        ["Buildings", "brick-steps", "Steps"],
        "Bricks climb with the steps, and caps lie on the columns beside them.",
        "v=1&make=masonry&building=steps&pattern=bricks&walls=dark&ground=paving",
    ),
    Preset::plain(
        ["Buildings", "pentagon", "Pentagon"],
        "Five walls cannot alternate at every corner until one column is added.",
        "v=1&make=masonry&building=ring&pattern=bricks&ground=gravel",
    ),
    Preset::plain(
        ["Buildings", "walled-garden", "Walled garden"],
        "A gate and six windows look into a garden whose walls turn four corners at half a right angle.",
        "v=1&make=masonry&building=plan&plan_height=26&plan=A4CAjCUToCAUUAwB&openings=CQSMQA.CoBSMQA.GGSKQA.GYAUaE.G2BSKQA.KKSMQA.KeSKQA&pattern=coped&ground=gravel&moss=0.55",
    ),
    Preset::plain(
        ["Buildings", "bay-wall", "Wall with bays"],
        "The bond goes round eight oblique corners of a wall that steps forward in two bays.",
        "v=1&make=masonry&building=plan&plan_height=25&plan=AAQAMMYAMLcAMMYAMLQA&openings=GGQMQC.KGAQaE.OGQMQC&yaw=-15&pattern=coped&walls=dark&ground=grass&moss=0.4",
    ),
    Preset::plain(
        ["Buildings", "stone-yard", "Stone yard"],
        "Rough stones close a yard, with a porch before its gate.",
        "v=1&make=masonry&building=plan&plan_height=26&plan=A8BgBAAQgBAAPgBAA7B_CAA8B&openings=CKSMQC.GIAQaE.KKSMQC.MQSMQA.MiBSMQA&yaw=-20&pattern=ashlar&module=ashlar&rough=0.5&walls=honey&ground=gravel&moss=0.5",
    ),
    viewed(
        ["seams", "Seams", "Fig. 1"],
        "A plain texture breaks at the edges of a block; cells turn the corners beside it.",
        [
            "v=1&make=masonry&building=block&pattern=bricks&dressing=same&ground=none&moss=0&damp=0",
            "view=seams",
        ],
    ),
    viewed(
        ["cube-laid", "Cube, edges laid", "Fig. 5 (b)"],
        "The corners and the edges of a cube have their blocks, and its faces are still empty.",
        [
            "v=1&make=masonry&building=block&block_length=8&block_width=8&block_height=8&pattern=rgb&module=cube&walls=parts&dressing=same&ground=none&moss=0&damp=0",
            "step=80",
        ],
    ),
    drawn(
        ["masonry7-a", "Block, RGB", "Fig. 7"],
        "Blocks of corners are red, of edges green and of faces blue: the three passes of the method.",
        "v=1&make=masonry&building=block&pattern=rgb&module=cube&walls=parts&dressing=same&ground=none&moss=0&damp=0",
    ),
    drawn(
        ["masonry7-b", "Block, bricks", "Fig. 7"],
        "The running bond meets at every edge, since stretchers and headers alternate there.",
        "v=1&make=masonry&building=block&pattern=bricks&dressing=same&ground=none&moss=0&damp=0",
    ),
    drawn(
        ["masonry7-c", "Block, ashlar", "Fig. 7"],
        "Stones of random size fill the faces between alternating stones of the edges.",
        "v=1&make=masonry&building=block&pattern=ashlar&module=ashlar&rough=0.5&walls=honey&dressing=same&ground=none&moss=0&damp=0",
    ),
    drawn(
        ["masonry7-d", "House, RGB", "Fig. 7"],
        "The openings of a house have corners and edges of their own.",
        "v=1&make=masonry&pattern=rgb&module=cube&walls=parts&dressing=same&ground=none&moss=0&damp=0",
    ),
    drawn(
        ["masonry7-g", "Gate, RGB", "Fig. 7"],
        "The blocks of an arch's edge follow its curve.",
        "v=1&make=masonry&building=gate&pattern=rgb&module=cube&walls=parts&dressing=same&ground=none&moss=0&damp=0",
    ),
    drawn(
        ["masonry7-i", "Gate, ashlar", "Fig. 7"],
        "Voussoirs and a hood of thinner stones go round the arch.",
        "v=1&make=masonry&building=gate&pattern=ashlar&module=ashlar&rough=0.5&walls=honey&dressing=same&ground=none&moss=0&damp=0",
    ),
    drawn(
        ["steps-diagonal", "Steps, diagonal bricks", "Fig. 8 (a)"],
        "Two diagonal bricks meet at each top corner, and herringbone is set into the columns.",
        steps!(),
    ),
    drawn(
        ["steps-cement", "Steps, cement stones", "Fig. 8 (b)"],
        "Rough cast stones lie along the treads and caps, with bricks between them.",
        "v=1&make=masonry&building=steps&steps_steps=5&steps_width=20&steps_tread=3&steps_column=8&steps_height=22&pattern=cement&dressing=pale&ground=paving&moss=0.1",
    ),
    viewed(
        ["steps-corners", "Steps, corners", "Fig. 8 (c)"],
        "The corners have their bricks, three at each top corner of the steps.",
        [steps!(), near!("step=80&")],
    ),
    viewed(
        ["steps-edges", "Steps, edges", "Fig. 8 (d)"],
        "Bricks of the edges lie between those of the corners.",
        [steps!(), near!("step=420&")],
    ),
    viewed(
        ["steps-panels", "Steps, panels", "Fig. 8 (e)"],
        "The panels of the columns are set before the rest of their faces.",
        [steps!(), near!("step=716&")],
    ),
    viewed(
        ["steps-faces", "Steps, faces", "Fig. 8 (f)"],
        "Bricks of the faces fill the space that is left.",
        [steps!(), near!("")],
    ),
];
