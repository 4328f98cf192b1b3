//! The one table of a surface's parameters; see [`crate::recipe::Schema`].

use crate::generators::rows::rows;
use crate::generators::rows::shared as common;
use crate::generators::rows::stones::{self, SKIN};
use crate::recipe::parameter::{Parameter, choice, int, number, text};
use crate::recipe::schema::choices;
use crate::recipe::{Choice, Item, Key};
use crate::shapes::{ShapeNumber, numbers};

/// The word for the surface that a file gives.
pub const FILE: &str = "file";

/// The row of a number of a shape.
const fn own(key: Key, of: &ShapeNumber, shape: &'static [&'static str]) -> Parameter {
    let row = match of.is_count() {
        true => int("", of.label),
        false => number("", of.label),
    };
    row.range(of.least, of.most, of.step, of.default)
        .unit(of.unit)
        .group("Shape")
        .named(key, "One of the numbers that the surface is made by.")
        .only_for(keys::FORM, shape)
}

rows! {
    form FORM: "The surface that is covered: one by rule, or that of a file." =>
        choice("Surface", choices![
            terrain: "Terrain", slope: "Slope", stairs: "Stairs", cylinder: "Cylinder", sphere: "Sphere", torus: "Torus", knot: "Knot", horn: "Horn", leg: "Leg", tail: "Tail", fish: "Fish", turtle: "Turtle's back", egg: "Egg", vase: "Vase", letter: "Letter", file: "From a file",
        ]).group("Shape").main();
    terrain_hills TERRAIN_HILLS => own(keys::TERRAIN_HILLS, &numbers::TERRAIN[0], &["terrain"]);
    terrain_height TERRAIN_HEIGHT => own(keys::TERRAIN_HEIGHT, &numbers::TERRAIN[1], &["terrain"]);
    terrain_lane TERRAIN_LANE => own(keys::TERRAIN_LANE, &numbers::TERRAIN[2], &["terrain"]);
    terrain_wind TERRAIN_WIND => own(keys::TERRAIN_WIND, &numbers::TERRAIN[3], &["terrain"]);
    terrain_hill TERRAIN_HILL => own(keys::TERRAIN_HILL, &numbers::TERRAIN[4], &["terrain"]);
    slope_rise SLOPE_RISE => own(keys::SLOPE_RISE, &numbers::SLOPE[0], &["slope"]);
    slope_landing SLOPE_LANDING => own(keys::SLOPE_LANDING, &numbers::SLOPE[1], &["slope"]);
    slope_width SLOPE_WIDTH => own(keys::SLOPE_WIDTH, &numbers::SLOPE[2], &["slope"]);
    slope_round SLOPE_ROUND => own(keys::SLOPE_ROUND, &numbers::SLOPE[3], &["slope"]);
    stairs_steps STAIRS_STEPS => own(keys::STAIRS_STEPS, &numbers::STAIRS[0], &["stairs"]);
    stairs_pitch STAIRS_PITCH => own(keys::STAIRS_PITCH, &numbers::STAIRS[1], &["stairs"]);
    stairs_width STAIRS_WIDTH => own(keys::STAIRS_WIDTH, &numbers::STAIRS[2], &["stairs"]);
    stairs_landing STAIRS_LANDING => own(keys::STAIRS_LANDING, &numbers::STAIRS[3], &["stairs"]);
    cylinder_height CYLINDER_HEIGHT => own(keys::CYLINDER_HEIGHT, &numbers::CYLINDER[0], &["cylinder"]);
    cylinder_top CYLINDER_TOP => own(keys::CYLINDER_TOP, &numbers::CYLINDER[1], &["cylinder"]);
    cylinder_belly CYLINDER_BELLY => own(keys::CYLINDER_BELLY, &numbers::CYLINDER[2], &["cylinder"]);
    cylinder_caps CYLINDER_CAPS => own(keys::CYLINDER_CAPS, &numbers::CYLINDER[3], &["cylinder"]);
    sphere_height SPHERE_HEIGHT => own(keys::SPHERE_HEIGHT, &numbers::SPHERE[0], &["sphere"]);
    sphere_depth SPHERE_DEPTH => own(keys::SPHERE_DEPTH, &numbers::SPHERE[1], &["sphere"]);
    sphere_square SPHERE_SQUARE => own(keys::SPHERE_SQUARE, &numbers::SPHERE[2], &["sphere"]);
    torus_tube TORUS_TUBE => own(keys::TORUS_TUBE, &numbers::TORUS[0], &["torus"]);
    torus_height TORUS_HEIGHT => own(keys::TORUS_HEIGHT, &numbers::TORUS[1], &["torus"]);
    torus_waves TORUS_WAVES => own(keys::TORUS_WAVES, &numbers::TORUS[2], &["torus"]);
    torus_swell TORUS_SWELL => own(keys::TORUS_SWELL, &numbers::TORUS[3], &["torus"]);
    knot_turns KNOT_TURNS => own(keys::KNOT_TURNS, &numbers::KNOT[0], &["knot"]);
    knot_lobes KNOT_LOBES => own(keys::KNOT_LOBES, &numbers::KNOT[1], &["knot"]);
    knot_tube KNOT_TUBE => own(keys::KNOT_TUBE, &numbers::KNOT[2], &["knot"]);
    knot_swing KNOT_SWING => own(keys::KNOT_SWING, &numbers::KNOT[3], &["knot"]);
    knot_height KNOT_HEIGHT => own(keys::KNOT_HEIGHT, &numbers::KNOT[4], &["knot"]);
    horn_turns HORN_TURNS => own(keys::HORN_TURNS, &numbers::HORN[0], &["horn"]);
    horn_rise HORN_RISE => own(keys::HORN_RISE, &numbers::HORN[1], &["horn"]);
    horn_taper HORN_TAPER => own(keys::HORN_TAPER, &numbers::HORN[2], &["horn"]);
    horn_girth HORN_GIRTH => own(keys::HORN_GIRTH, &numbers::HORN[3], &["horn"]);
    leg_toes LEG_TOES => own(keys::LEG_TOES, &numbers::LEG[0], &["leg"]);
    leg_spread LEG_SPREAD => own(keys::LEG_SPREAD, &numbers::LEG[1], &["leg"]);
    leg_bend LEG_BEND => own(keys::LEG_BEND, &numbers::LEG[2], &["leg"]);
    leg_girth LEG_GIRTH => own(keys::LEG_GIRTH, &numbers::LEG[3], &["leg"]);
    leg_reach LEG_REACH => own(keys::LEG_REACH, &numbers::LEG[4], &["leg"]);
    tail_curl TAIL_CURL => own(keys::TAIL_CURL, &numbers::TAIL[0], &["tail"]);
    tail_taper TAIL_TAPER => own(keys::TAIL_TAPER, &numbers::TAIL[1], &["tail"]);
    tail_girth TAIL_GIRTH => own(keys::TAIL_GIRTH, &numbers::TAIL[2], &["tail"]);
    tail_lift TAIL_LIFT => own(keys::TAIL_LIFT, &numbers::TAIL[3], &["tail"]);
    fish_height FISH_HEIGHT => own(keys::FISH_HEIGHT, &numbers::FISH[0], &["fish"]);
    fish_width FISH_WIDTH => own(keys::FISH_WIDTH, &numbers::FISH[1], &["fish"]);
    fish_tail FISH_TAIL => own(keys::FISH_TAIL, &numbers::FISH[2], &["fish"]);
    fish_fins FISH_FINS => own(keys::FISH_FINS, &numbers::FISH[3], &["fish"]);
    fish_swim FISH_SWIM => own(keys::FISH_SWIM, &numbers::FISH[4], &["fish"]);
    turtle_width TURTLE_WIDTH => own(keys::TURTLE_WIDTH, &numbers::TURTLE[0], &["turtle"]);
    turtle_height TURTLE_HEIGHT => own(keys::TURTLE_HEIGHT, &numbers::TURTLE[1], &["turtle"]);
    turtle_rim TURTLE_RIM => own(keys::TURTLE_RIM, &numbers::TURTLE[2], &["turtle"]);
    turtle_keel TURTLE_KEEL => own(keys::TURTLE_KEEL, &numbers::TURTLE[3], &["turtle"]);
    egg_height EGG_HEIGHT => own(keys::EGG_HEIGHT, &numbers::EGG[0], &["egg"]);
    egg_point EGG_POINT => own(keys::EGG_POINT, &numbers::EGG[1], &["egg"]);
    egg_base EGG_BASE => own(keys::EGG_BASE, &numbers::EGG[2], &["egg"]);
    vase_height VASE_HEIGHT => own(keys::VASE_HEIGHT, &numbers::VASE[0], &["vase"]);
    vase_shoulder VASE_SHOULDER => own(keys::VASE_SHOULDER, &numbers::VASE[1], &["vase"]);
    vase_neck VASE_NECK => own(keys::VASE_NECK, &numbers::VASE[2], &["vase"]);
    vase_lip VASE_LIP => own(keys::VASE_LIP, &numbers::VASE[3], &["vase"]);
    vase_hollow VASE_HOLLOW => own(keys::VASE_HOLLOW, &numbers::VASE[4], &["vase"]);
    letter_letter LETTER_LETTER => own(keys::LETTER_LETTER, &numbers::LETTER[0], &["letter"]);
    letter_weight LETTER_WEIGHT => own(keys::LETTER_WEIGHT, &numbers::LETTER[1], &["letter"]);
    letter_depth LETTER_DEPTH => own(keys::LETTER_DEPTH, &numbers::LETTER[2], &["letter"]);
    letter_round LETTER_ROUND => own(keys::LETTER_ROUND, &numbers::LETTER[3], &["letter"]);
    letter_lean LETTER_LEAN => own(keys::LETTER_LEAN, &numbers::LETTER[4], &["letter"]);
    model MODEL: "The file's digest and its name: a link does not hold the file itself." =>
        text("Model", Item::File).group("Shape").main().steady()
            .drawn_for(keys::FORM, FILE).only_for(keys::FORM, &[FILE]);
    up UP: "Which way is up in the file." =>
        choice("Upright axis", choices![y: "y", z: "z"]).group("Shape").steady()
            .only_for(keys::FORM, &[FILE]);
    side SIDE: "The outside of the model's open parts, where the stones stand. Closed parts have only one." =>
        choice("Outside of open parts", choices![
            given: "As the file says", guess: "Upwards or outwards", other: "Downwards or inwards",
        ])
            .group("Shape").steady().only_for(keys::FORM, &[FILE]);
    on ON: "Cells are packed on the surface as it is, or on a simpler one, and brought back from there." =>
        choice("Packed on", choices![
            fit: "What is fine enough", whole: "The surface itself", simple: "A simpler surface",
        ])
            .group("Shape").steady().only_for(keys::FORM, &[FILE]);
    crease CREASE: "Cells are folded over sharp edges, or the surface is cut along them." =>
        choice("Creases", choices![fold: "Folded over", cut: "Cut"]).group("Shape");
    fold FOLD: "Edges that bend by more than this are creases." =>
        number("", "Angle of creases").range(5.0, 120.0, 1.0, 25.0).unit("°").group("Shape").steady();
    open OPEN: "What is beyond the ends of the surface: the inside of a shell, the cut through a body, or ground down to a floor." =>
        choice("Openings", choices![
            own: "As the surface has them", shell: "A shell", capped: "A body", block: "Ground",
        ]).group("Shape").steady();
    ends ENDS: "Where a leg or a tail is cut off, and how its toes and its tip end: all in cells, or with a plain cut, claws and a tip of horn." =>
        choice("Ends", choices![round: "In cells", cut: "Cut and claws"]).group("Shape")
            .only_for(keys::FORM, &["leg", "tail", "horn"]);
    yaw YAW: "Turns the model about its upright axis, under the same light." =>
        number("", "Turn").range(-180.0, 180.0, 1.0, 0.0).unit("°").group("Shape");
    size SIZE: "Side of the square picture." => common::SIZE;

    kind KIND: "Shape of the packed cells: squares and rectangles in rows, circles and ellipses like honeycombs." =>
        choice("Kind", choices![
            square: "Square", rectangle: "Rectangle", circle: "Circle", ellipse: "Ellipse",
        ]).group("Cells").main();
    ca CA: "Length of a cell along the direction over its width." =>
        number("Ca", "Aspect ratio").range(1.0, 5.0, 0.05, 2.0).group("Cells").main()
            .only_for(keys::KIND, STRETCHED);
    bent BENT: "The same aspect ratio everywhere, or round where the surface bends alike in all directions." =>
        choice("Aspect", choices![even: "Even", curvature: "By curvature"]).group("Cells")
            .only_for(keys::KIND, STRETCHED);
    stretch STRETCH: "Soft spots on the surface with an aspect ratio of their own." =>
        text("Aspect spots", Item::Patch(1.0, 5.0)).group("Cells").only_for(keys::KIND, STRETCHED);
    cn CN: "About so many cells cover the surface." =>
        int("", "Cells").range(30.0, 20_000.0, 10.0, 1200.0).group("Size").main();
    taper TAPER: "Size of the cells at the end over that at the beginning." =>
        number("", "Taper").range(0.1, 10.0, 0.05, 1.0).group("Size");
    along ALONG: "What cells grow or shrink along: the body from head to tail, or one direction." =>
        choice("Taper along", choices![bones: "Head to tail", up: "Upwards", right: "To the right", front: "To the front"])
            .group("Size").only_with(keys::TAPER);
    cc CC: "Smaller cells where the surface bends more: the angle that a cell spans there; 0 leaves sizes even." =>
        number("", "Angle of a cell").range(0.0, 40.0, 0.5, 0.0).unit("°").group("Size");
    cl CL: "The smallest cells, of the mean size." =>
        number("", "Smallest cells").range(0.2, 1.0, 0.05, 0.4).group("Size").only_with(keys::CC);
    ch CH: "The largest cells, of the mean size." =>
        number("", "Largest cells").range(1.0, 3.0, 0.05, 1.5).group("Size").only_with(keys::CC);
    spots SPOTS: "Soft spots of larger or smaller cells on the surface." =>
        text("Size spots", Item::Patch(0.2, 3.0)).group("Size");
    dir DIR: "What the rows of cells follow: the body from head to tail, one direction, the bending, borders, or only each other." =>
        choice("Direction", choices![
            bones: "Head to tail", axis: "One direction", curvature: "Along the bending",
            border: "Borders and creases", free: "As smooth as can be",
        ]).group("Direction");
    axis AXIS: "The direction in space that rows follow." =>
        choice("Towards", choices![up: "Upwards", right: "To the right", front: "To the front"])
            .group("Direction").only_for(keys::DIR, &["axis"]);
    angle ANGLE: "Turns all directions, counter-clockwise seen from outside." =>
        number("", "Angle").range(-90.0, 90.0, 1.0, 0.0).unit("°").group("Direction");
    strokes STROKES: "Lines painted on the surface that the rows follow, and the flow along them." =>
        text("Strokes", Item::Trace).group("Direction");
    reach REACH: "Up to where a stroke counts, in sides of the box around the model." =>
        number("", "Reach of strokes").range(0.02, 1.0, 0.01, 0.08).group("Direction").steady()
            .only_with(keys::STROKES);
    lines LINES: "Lines on the surface that cells line up along." =>
        text("Lines", Item::Trace).group("Direction");
    flow FLOW: "Where scales lean to: from head to tail, along one direction, along the strokes, or as their neighbours do." =>
        choice("Flow", choices![
            bones: "Head to tail", axis: "One direction", strokes: "Along strokes", free: "As neighbours do",
        ]).group("Direction");
    flip FLIP: "Which way the flow goes." =>
        choice("Sense of the flow", &[
            Choice { word: "0", label: "As it is" }, Choice { word: "1", label: "The other way" },
        ]).group("Direction");
    vs VS: "Random variance of the cells' size." =>
        number("Vs", "Size variance").range(0.0, 0.5, 0.01, 0.0).group("Packing");
    seed SEED: "Names the random numbers: another seed, other stones." => common::SEED.group("Packing");

    ..[stones::LEAN];
    sv SV => stones::SV.range(0.5, 3.0, 0.01, 0.97).default_while(keys::STONE, SKIN, 1.3);
    hs HS: "Height of the stones, in cell sizes." => stones::HS.range(0.05, 2.0, 0.01, 0.4);
    sr SR => stones::SR.range(0.05, 4.0, 0.05, 0.45);
    sc SC => stones::SC.range(0.0, 4.0, 0.05, 0.9);
    tilt TILT => stones::TILT.range(0.0, 1.0, 0.01, 0.28);
    sa SA: "Where the top leans and rises to, from the flow, counter-clockwise seen from outside." => stones::SA;
    ..[stones::TOP];
    tc TC => stones::TC.range(0.0, 1.0, 0.01, 0.25).called("Taper of the top");
    keel KEEL => stones::KEEL.range(0.0, 1.0, 0.01, 0.4);
    dr DR => stones::DR.default_while(keys::STONE, SKIN, 0.03);

    ..[common::FACES];
    fd FD => common::FD.default_while(keys::STONE, SKIN, 1.1);
    af AF => common::AF.default_while(keys::STONE, SKIN, 0.03);

    ..[stones::MARKS];
    pn PN: "From one mark to the next, or how far marks reach, in sides of the box around the model." =>
        stones::PN;
    pa PA: "Across bands, or where marked cells point, clockwise from the x axis, seen from the front." =>
        stones::PA;
    pt PT: "Where bands run: across the pattern's angle, or around the body from head to tail, as rings." =>
        choice("Bands run", choices![across: "Across the angle", body: "Around the body"])
            .group("Colour").only_for(keys::PATTERN, &["bands"]);
    belly BELLY: "How much of the palette's belly colour there is on one side of the body." => stones::BELLY;
    ba BA: "Where the belly is, clockwise from the x axis, seen from the front." => stones::BA;

    ..[common::WEATHERING];
    moss MOSS: "Lets moss grow, in the joints, in hollows and on what faces up." => common::MOSS;

    ..[common::LIGHTING];
    az AZ => common::AZ.range(0.0, 360.0, 1.0, 130.0);
}

/// The kinds with an aspect ratio.
const STRETCHED: &[&str] = &["rectangle", "ellipse"];
