//! The one table of a pavement's parameters. The link, the controls of the page, clamping and presets
//! all read it: a new parameter is one row, its use, and its words.

use crate::domain::MAX_POINTS;
use crate::field::FieldParams;
use crate::generators::rows::rows;
use crate::generators::rows::shared;
use crate::generators::rows::stones::{self, SKIN};
use crate::packing::{PackingParams, Physics};
use crate::recipe::parameter::{choice, int, number, text};
use crate::recipe::schema::choices;
use crate::recipe::{Choice, Item, SideLimits};
use crate::solid::SkinParams;

/// The defaults of the library, which the rows use.
const FIELDS: &FieldParams = &FieldParams::DEFAULT;
const PACKING: &PackingParams = &PackingParams::DEFAULT;
const PHYSICS: &Physics = &Physics::DEFAULT;

/// The word for an outline that is given by its points.
pub const POLYGON: &str = "polygon";

/// Cells smaller than two pixels would look like noise.
const CELL_LIMITS: SideLimits = SideLimits {
    finest: 400.0,
    least: 2.0,
    coarsest: 2.0,
};

rows! {
    outline OUTLINE: "The shape of the area to pave." =>
        choice("Outline", choices![
            annulus: "Ring", road_s: "S-curve", road_straight: "Straight road",
            road_spiral: "Spiral", y_fork: "Fork", crossing: "Crossing",
            plaza: "Plaza with holes", road_notch: "Cut-out road", l_shape: "L", star: "Star",
            square: "Square", polygon: "Free polygon",
        ]).group("Outline").main().only_for(keys::TILE, &["0"]);
    poly POLY: "The free polygon's points, as compact text; draw it or load it from a file instead." =>
        text("Points", Item::Ring(MAX_POINTS)).group("Outline").steady()
            .drawn_for(keys::OUTLINE, POLYGON).only_for(keys::OUTLINE, &[POLYGON]);
    lines LINES: "Constraint lines inside the outline: cells line up along both sides of them." =>
        text("Lines", Item::Line).group("Outline");
    tile TILE: "Makes the whole picture a tile that repeats without a seam; the outline does not count." =>
        choice("Area", &[
            Choice { word: "0", label: "Outline" }, Choice { word: "1", label: "Seamless tile" },
        ]).group("Outline");
    size SIZE: "Side of the square picture; the outline grows with it, the stones only as their own lengths do." =>
        shared::SIZE.group("Outline");
    ow OW: "Width of the paved way, as a factor of the shape's own." =>
        number("", "Width").range(0.3, 1.7, 0.05, 1.0).group("Outline")
            .only_for(keys::OUTLINE, BUILT_IN);
    on ON: "Number of bends, turns, arms, holes, notches or points; 0 takes the shape's own." =>
        int("", "Number").range(0.0, 12.0, 1.0, 0.0).group("Outline")
            .only_for(keys::OUTLINE, COUNTED);
    oa OA: "Turns the shape clockwise; it always fills the picture." =>
        number("", "Turn").range(-180.0, 180.0, 1.0, 0.0).unit("°").group("Outline")
            .only_for(keys::OUTLINE, BUILT_IN);

    kind KIND: "Shape of the packed cells: squares and rectangles in rows, circles and ellipses like honeycombs." =>
        choice("Kind", choices![
            square: "Square", rectangle: "Rectangle", circle: "Circle", ellipse: "Ellipse",
        ]).group("Cells").main();
    parts PARTS: "Kinds of the parts that lines cut the outline into." =>
        text("Kinds of parts", Item::Seed(keys::KIND)).group("Cells").only_with(keys::LINES);
    ca CA: "Length of a cell along the direction over its width." =>
        number("Ca", "Aspect ratio").range(1.0, 5.0, 0.05, FIELDS.aspect).group("Cells").main()
            .only_for(keys::KIND, STRETCHED);
    cb CB: "Factor of the aspect ratio on the boundary; inwards it goes over to the plain one." =>
        number("", "Aspect at the boundary").range(0.2, 5.0, 0.05, FIELDS.aspect_grading.factor).group("Cells")
            .only_for(keys::KIND, STRETCHED);
    cd CD: "How far from the boundary the aspect ratio changes, in picture sides." =>
        number("", "Aspect reach").range(0.02, 1.0, 0.01, FIELDS.aspect_grading.reach / FIELDS.side).group("Cells").steady()
            .only_with(keys::CB);
    stretch STRETCH: "Soft spots with an aspect ratio of their own." =>
        text("Aspect spots", Item::Spot(1.0, 5.0)).group("Cells").only_for(keys::KIND, STRETCHED);
    cs CS: "Average side of a cell." =>
        number("Cs", "Cell size").range(2.0, 256.0, 1.0, FIELDS.size).per_side(CELL_LIMITS).unit("px")
            .group("Size").main();
    gx GX: "Makes cells grow from left to right (or shrink, below 0); on a tile a wave." =>
        number("", "Size gradient x").range(-0.8, 0.8, 0.05, FIELDS.linear.x).group("Size");
    gy GY: "Makes cells grow from top to bottom (or shrink, below 0); on a tile a wave." =>
        number("", "Size gradient y").range(-0.8, 0.8, 0.05, FIELDS.linear.y).group("Size");
    gr GR: "Makes cells grow from the picture's centre outwards (or shrink, below 0)." =>
        number("", "Size gradient radial").range(-0.8, 0.8, 0.05, FIELDS.radial).group("Size");
    gb GB: "Factor of the size on the boundary; inwards it goes over to the plain one." =>
        number("", "Size at the boundary").range(0.2, 3.0, 0.05, FIELDS.size_grading.factor).group("Size");
    gd GD: "How far from the boundary the size changes, in picture sides." =>
        number("", "Size reach").range(0.02, 1.0, 0.01, FIELDS.size_grading.reach / FIELDS.side).group("Size")
            .only_with(keys::GB);
    spots SPOTS: "Soft spots of larger or smaller cells." =>
        text("Size spots", Item::Spot(0.2, 3.0)).group("Size");
    dir DIR: "Rows of cells follow the boundary, painted strokes, one angle, a point, or eq. (1) as it is printed." =>
        choice("Direction", choices![
            boundary: "Along the boundary", constant: "One angle", printed: "Eq. (1) as printed",
            radial: "Radial", circular: "Circular", spiral: "Spiral", strokes: "Strokes only",
        ]).group("Direction");
    angle ANGLE: "Direction of the rows, clockwise from the x axis." =>
        number("θ", "Angle").range(-90.0, 90.0, 1.0, FIELDS.angle.to_degrees()).unit("°").group("Direction")
            .only_for(keys::DIR, &["constant", "strokes"]);
    fx FX: "The point that rows turn about, from left to right, in picture sides." =>
        number("", "Centre x").range(-1.0, 2.0, 0.01, FIELDS.centre.x / FIELDS.side).group("Direction")
            .only_for(keys::DIR, ABOUT);
    fy FY: "The point that rows turn about, from top to bottom, in picture sides." =>
        number("", "Centre y").range(-1.0, 2.0, 0.01, FIELDS.centre.y / FIELDS.side).group("Direction")
            .only_for(keys::DIR, ABOUT);
    fa FA: "Angle of the spiral to the rays from its point: 0 radial, 90 circular." =>
        number("", "Spiral angle").range(-90.0, 90.0, 1.0, 45.0).unit("°")
            .group("Direction").only_for(keys::DIR, &["spiral"]);
    dp DP: "Power of the distance in the direction's weights: the higher, the nearer a wall must be." =>
        int("", "Distance power").range(2.0, 4.0, 1.0, FIELDS.power as f64).group("Direction").steady()
            .only_for(keys::DIR, &["boundary", "strokes"]);
    ends ENDS: "Weight of the outline's short ends in the direction of cells that are not square." =>
        number("", "Weight of ends").range(0.0, 1.0, 0.05, FIELDS.ends).group("Direction").steady()
            .only_for(keys::KIND, &["rectangle", "circle", "ellipse"]);
    strokes STROKES: "Painted lines that the rows follow." =>
        text("Strokes", Item::Line).group("Direction");
    reach REACH: "Up to where a stroke counts more than one angle or the point, in picture sides." =>
        number("", "Reach of strokes").range(0.02, 1.0, 0.01, FIELDS.reach / FIELDS.side).group("Direction").steady()
            .only_with(keys::STROKES);

    edge EDGE: "The outermost cells have their edges on the boundary, or their centres, which then stay. Without walls cells may leave." =>
        choice("Boundary", choices![wall: "Edges on it", on: "Centres on it", open: "No walls"])
            .group("Packing").steady();
    start START: "Where cells are put at first." =>
        choice("Start", choices![
            stream: "Along the direction", quadtree: "Quadtree", random: "Random",
        ])
            .group("Packing").steady();
    move MOVE: "How the equation of motion is integrated." =>
        choice("Integrator", choices![
            semi: "Semi-implicit", rk4: "Runge-Kutta 4", euler: "Explicit Euler",
        ])
            .group("Packing").steady();
    pop POP: "How cells are added and removed on the way." =>
        choice("Population", choices![
            slots: "Empty slots", smallest: "Smallest distance", off: "Off",
            opposite: "Opposite the nearest",
        ]).group("Packing").steady();
    vs VS: "Random variance of the cells' size." =>
        number("Vs", "Size variance").range(0.0, 0.5, 0.01, PACKING.variance).group("Packing").main();
    seed SEED: "Names the random numbers: another seed, another pavement." =>
        shared::SEED.group("Packing");

    cells CELLS: "Cells fitted to each other without gaps, or as they were packed; to compare, Voronoi cells of as many random points, plain or evened out by Lloyd's relaxation." =>
        choice("Cells", choices![
            fitted: "Fitted", packed: "As packed", voronoi: "Voronoi", lloyd: "Lloyd",
        ]).group("Packing");
    rounds ROUNDS: "Rounds of Lloyd's relaxation; more than 50 improve little." =>
        int("", "Lloyd's rounds").range(0.0, 50.0, 1.0, 50.0).group("Packing").steady()
            .only_for(keys::CELLS, &["lloyd"]);

    count COUNT: "How many cells start at random places; 0 takes as many as have room." =>
        int("", "Cells at first").range(0.0, 2000.0, 1.0, 0.0).group("Physics").steady()
            .only_for(keys::START, &["random"]);
    given GIVEN: "The cells at the start, instead of all others: x and y in picture sides, and 1 if it is held, else 0." =>
        text("Given cells", Item::Bubble).group("Physics").steady();
    jolt JOLT: "Moves each free cell at the start, at random up to this many sizes." =>
        number("", "Jolt").range(0.0, 2.0, 0.05, 0.0).group("Physics").steady();
    damp DAMP: "Drag on moving cells; without it they swing for ever." =>
        number("c", "Damping").range(0.0, 10.0, 0.05, 2.0).default_while(keys::KIND, "circle", 0.2)
            .group("Physics").steady();
    mass MASS: "Mass of a cell." =>
        number("m", "Mass").range(0.1, 10.0, 0.1, PHYSICS.mass).group("Physics").steady();
    stiff STIFF: "Factor of all forces." =>
        number("k0", "Stiffness").range(0.1, 10.0, 0.1, PHYSICS.stiffness).group("Physics").steady();
    dt DT: "Time of one step." =>
        number("", "Time step").range(0.01, 2.0, 0.01, 0.5).default_while(keys::MOVE, "rk4", 0.6)
            .group("Physics").steady();
    cw CW: "Weight of the corner bubbles; by default √2 − 1." =>
        number("", "Corner weight").range(0.0, 1.0, 0.002, 0.414).group("Physics").steady()
            .only_for(keys::KIND, CORNERED);
    cr CR: "Radius of the corner bubbles, in radii of a cell; by default √2 − 1." =>
        number("", "Corner radius").range(0.0, 1.0, 0.002, 0.414).group("Physics").steady()
            .only_for(keys::KIND, CORNERED);
    crowd CROWD: "A cell goes if its nearest neighbour is nearer; 0 takes the kind's own." =>
        number("", "Crowded below").range(0.0, 1.0, 0.01, 0.0).group("Physics").steady()
            .only_for(keys::POP, CONTROLLED);
    room ROOM: "A cell comes where the nearest one is at least this far; 0 takes the rule's own." =>
        number("", "Room from").range(0.0, 1.5, 0.01, 0.0).group("Physics").steady()
            .only_for(keys::POP, CONTROLLED);
    fend FEND: "The run may end when no force is larger, in cell sizes." =>
        number("", "Force at rest").range(0.0, 0.5, 0.001, PHYSICS.force_end).group("Physics").steady();
    mend MEND: "The run may end when no move is longer, in cell sizes." =>
        number("", "Move at rest").range(0.0, 0.5, 0.001, PHYSICS.move_end).group("Physics").steady();
    most MOST: "The run ends after this many steps at the latest." =>
        int("", "Most steps").range(1.0, 10_000.0, 1.0, PHYSICS.most_steps as f64).group("Physics").steady();
    cool COOL: "Factor of the time step for each late step." =>
        number("", "Cooling").range(0.5, 1.0, 0.01, 0.97).group("Physics").steady();

    ..[stones::LEAN];
    sv SV => stones::SV.default_while(keys::STONE, SKIN, 1.4);
    hs HS => stones::HS.unit("px");
    flow FLOW: "Which way scales lean as a whole: as their axes happen to point, along the painted strokes, or against them." =>
        choice("Flow", choices![own: "As it comes", strokes: "Along strokes", against: "Against strokes"])
            .group("Relief").steady().only_for(keys::STONE, &[SKIN]);
    ..[stones::TOP];
    dr DR => stones::DR.default_while(keys::STONE, SKIN, 0.05);

    ..[shared::FACES];
    fd FD => shared::FD.default_while(keys::STONE, SKIN, SkinParams::DEFAULT.dimension);
    af AF => shared::AF.default_while(keys::STONE, SKIN, SkinParams::DEFAULT.amplitude);

    ..[stones::MARKS];
    pattern PATTERN: "The rule by which cells have the palette's mark colour." =>
        choice("Pattern", choices![
            none: "None", bands: "Bands", spots: "Spots", rosettes: "Rosettes",
            blotches: "Blotches", turing: "Reaction-diffusion", size: "By size",
            boundary: "Near the boundary", lines: "Near lines", direction: "By direction",
        ]).group("Colour");
    pn PN => stones::PN.only_for(keys::PATTERN, SCALED);
    ps PS => stones::PS.only_for(keys::PATTERN, PATTERNS);
    pc PC => stones::PC.only_for(keys::PATTERN, PATTERNS);
    pm PM => stones::PM.only_for(keys::PATTERN, PATTERNS);

    ..[shared::WEATHERING];
    ..[shared::LIGHTING];
}

/// The kinds with corners.
const CORNERED: &[&str] = &["square", "rectangle"];

/// The rules that add and remove cells.
const CONTROLLED: &[&str] = &["slots", "smallest", "opposite"];

/// The kinds with an aspect ratio.
const STRETCHED: &[&str] = &["rectangle", "ellipse"];

/// All patterns; [`SCALED`] lists the patterns that have a scale.
const PATTERNS: &[&str] = &[
    "bands",
    "spots",
    "rosettes",
    "blotches",
    "turing",
    "size",
    "boundary",
    "lines",
    "direction",
];
const SCALED: &[&str] = &[
    "bands", "spots", "rosettes", "blotches", "turing", "boundary", "lines",
];

/// The directions about a point.
const ABOUT: &[&str] = &["radial", "circular", "spiral"];

/// Every outline but the free polygon.
const BUILT_IN: &[&str] = &[
    "annulus",
    "road_s",
    "road_straight",
    "road_spiral",
    "y_fork",
    "crossing",
    "plaza",
    "road_notch",
    "l_shape",
    "star",
    "square",
];

/// The outlines with a number of bends, turns, arms, holes, notches or points.
const COUNTED: &[&str] = &[
    "road_s",
    "road_spiral",
    "y_fork",
    "crossing",
    "plaza",
    "road_notch",
    "star",
];
