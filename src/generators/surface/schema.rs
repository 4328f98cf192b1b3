//! The one table of a surface's parameters; see [`crate::recipe::Schema`].

use crate::generators::rows::rows;
use crate::generators::rows::shapes;
use crate::generators::rows::shared;
use crate::generators::rows::stones::{self, SKIN};
use crate::recipe::parameter::{choice, int, number, text};
use crate::recipe::schema::choices;
use crate::recipe::{Choice, Item};

/// The word for the surface that a file gives.
pub const FILE: &str = "file";

rows! {
    form FORM: "The surface that is covered: one by rule, or that of a file." =>
        choice("Surface", choices![
            terrain: "Terrain", slope: "Slope", stairs: "Stairs", cylinder: "Cylinder", sphere: "Sphere", torus: "Torus", knot: "Knot", horn: "Horn", leg: "Leg", tail: "Tail", fish: "Fish", turtle: "Turtle's back", egg: "Egg", vase: "Vase", letter: "Letter", file: "From a file",
        ]).group("Shape").main();
    ..[shapes::NUMBERS];
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
            fit: "As fine as needed", whole: "The surface itself", simple: "A simpler surface",
        ])
            .group("Shape").steady().only_for(keys::FORM, &[FILE]);
    crease CREASE: "Cells are folded over sharp edges, or the surface is cut along them." =>
        choice("Creases", choices![fold: "Folded over", cut: "Cut"]).group("Shape");
    fold FOLD: "Edges that bend by more than this are creases." =>
        number("", "Angle of creases").range(5.0, 120.0, 1.0, 25.0).unit("°").group("Shape").steady();
    open OPEN: "Ends of the surface show the inside of a shell, the cut through a body, or ground down to a floor." =>
        choice("Openings", choices![
            own: "As the surface has them", shell: "A shell", capped: "A body", block: "Ground",
        ]).group("Shape").steady();
    ends ENDS: "Where a leg or a tail is cut off, and how its toes and its tip end: all in cells, or with a plain cut, claws and a tip of horn." =>
        choice("Ends", choices![round: "In cells", cut: "Cut and claws"]).group("Shape")
            .only_for(keys::FORM, &["leg", "tail", "horn"]);
    yaw YAW: "Turns the model about its upright axis, under the same light." =>
        shared::YAW.group("Shape");
    size SIZE: "Side of the square picture." => shared::SIZE;

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
    cn CN: "Number of cells on the surface, approximately." =>
        int("", "Cells").range(30.0, 20_000.0, 10.0, 1200.0).group("Size").main();
    taper TAPER: "Size of the cells at the end over that at the beginning." =>
        number("", "Taper").range(0.1, 10.0, 0.05, 1.0).group("Size");
    along ALONG: "Cells grow or shrink along the body from head to tail, or along one direction." =>
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
    dir DIR: "Rows of cells follow the body from head to tail, one direction, the bending, borders, or only each other." =>
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
    seed SEED: "Names the random numbers: another seed, other stones." => shared::SEED.group("Packing");

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

    ..[shared::FACES];
    fd FD => shared::FD.default_while(keys::STONE, SKIN, 1.1);
    af AF => shared::AF.default_while(keys::STONE, SKIN, 0.03);

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

    ..[shared::WEATHERING];
    moss MOSS: "Lets moss grow, in the joints, in hollows and on what faces up." => shared::MOSS;

    ..[shared::LIGHTING];
    az AZ => shared::AZ.range(0.0, 360.0, 1.0, 130.0);
}

/// The kinds with an aspect ratio.
const STRETCHED: &[&str] = &["rectangle", "ellipse"];
