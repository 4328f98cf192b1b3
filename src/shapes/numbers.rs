//! The table of shapes: their names and their numbers.

use super::Shape;

/// One of the numbers of a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShapeNumber {
    /// Its key in links, unique within the shape.
    pub word: &'static str,
    /// Its English label.
    pub label: &'static str,
    /// One English sentence that says more.
    pub help: &'static str,
    /// Its unit; empty if it has none.
    pub unit: &'static str,
    /// Its value when a link does not set it.
    pub default: f64,
    /// Its least value.
    pub least: f64,
    /// Its greatest value.
    pub most: f64,
    /// The step of a control. For a count, only whole numbers of steps above the least value are valid.
    pub step: f64,
}

impl ShapeNumber {
    /// Whether it is a count or a choice, with no value between two steps.
    pub const fn is_count(&self) -> bool {
        self.step >= 1.0 && self.unit.is_empty()
    }

    /// The nearest valid value; the default for a number that is not finite.
    pub fn fitted(&self, number: f64) -> f64 {
        if !number.is_finite() {
            return self.default;
        }
        let within = number.clamp(self.least, self.most);
        if self.is_count() {
            let steps = ((within - self.least) / self.step).round();
            return (self.least + steps * self.step).min(self.most);
        }
        within
    }
}

/// The tables of shapes. A row has a word, a label, a sentence of help, a unit, the default, the least and the greatest
/// value, and the step.
macro_rules! numbers {
    ($($shape:ident { $($word:ident: $label:literal, $help:literal, $unit:literal, $default:expr, $range:expr;)* })*) => {
        $(pub(crate) const $shape: &[ShapeNumber] = &[$(ShapeNumber {
            word: stringify!($word),
            label: $label,
            help: $help,
            unit: $unit,
            default: $default,
            least: $range[0],
            most: $range[1],
            step: $range[2],
        }),*];)*
    };
}
pub(crate) use numbers;

/// The table of an enum of shapes or buildings by rule. A row has the key in links, the English label, and the numbers.
macro_rules! by_rule {
    ($of:ident { $($own:ident: $word:literal, $label:literal, $numbers:expr;)* }) => {
        impl $of {
            /// All of them.
            pub const ALL: [Self; [$($word),*].len()] = [$(Self::$own),*];

            fn row(self) -> (&'static str, &'static str, &'static [$crate::shapes::ShapeNumber]) {
                match self {
                    $(Self::$own => ($word, $label, $numbers),)*
                }
            }

            /// Its key in links.
            pub fn word(self) -> &'static str {
                self.row().0
            }

            /// Its English label.
            pub fn label(self) -> &'static str {
                self.row().1
            }

            /// Its numbers with their ranges.
            pub fn numbers(self) -> &'static [$crate::shapes::ShapeNumber] {
                self.row().2
            }

            /// The one with this key.
            pub fn of_word(word: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|own| own.word() == word)
            }

            /// All its numbers: the nearest valid values to those given, and defaults for the rest.
            pub fn fitted(self, given: &[f64]) -> Vec<f64> {
                let each = self.numbers().iter().enumerate();
                each.map(|(k, number)| number.fitted(given.get(k).copied().unwrap_or(number.default)))
                    .collect()
            }
        }
    };
}
pub(crate) use by_rule;

numbers! {
    TERRAIN {
        hills: "Hills across", "Fits more hills into the same square; they become narrower and lower.", "", 2.5, [1.0, 5.0, 0.1];
        height: "Height over width of a hill", "Makes hills higher and steeper; 0 leaves the ground level.", "", 0.4, [0.0, 0.6, 0.02];
        lane: "Depth of the lane", "Cuts a lane through the hills; 0 leaves them whole, and 1 brings it down to the valleys.", "", 0.6, [0.0, 1.0, 0.05];
        wind: "How the lane winds", "Swings the lane to both sides; 0 leaves it straight, and 1 moves it by about a fifth of the width.", "", 0.5, [0.0, 1.0, 0.05];
        hill: "Seed of the hills", "Places the hills and the lane anew; each whole number gives another ground.", "", 1.0, [1.0, 999.0, 1.0];
    }
    SLOPE {
        rise: "Angle of the slope", "Tilts the ground between both landings; 0 leaves all of it level.", "°", 22.0, [0.0, 50.0, 1.0];
        landing: "Level share at each end", "Share of the length that is level at the top, and again at the bottom; 0 slopes all of it.", "", 0.2, [0.0, 0.4, 0.02];
        width: "Width over length", "Size from side to side over that from back to front; 1 makes a square seen from above.", "", 0.6, [0.2, 1.5, 0.05];
        round: "Roundness of the bends", "Rounds the bends at the landings; 0 leaves sharp folds, and 1 makes the widest arcs that fit.", "", 0.5, [0.0, 1.0, 0.05];
    }
    STAIRS {
        steps: "Steps", "Steps from the ground to the landing; the whole keeps its size, so more steps are smaller.", "", 5.0, [2.0, 12.0, 1.0];
        pitch: "Riser over tread", "Height of a step over its depth; 0.3 climbs gently, and above 1 steps are higher than deep.", "", 0.55, [0.3, 1.2, 0.05];
        width: "Width over length", "Size from side to side over the length of all treads and the landing.", "", 0.8, [0.3, 1.5, 0.05];
        landing: "Landing at the top, in treads", "Depth of the level top; 1 makes it as deep as a tread.", "", 1.0, [1.0, 4.0, 0.25];
    }
    CYLINDER {
        height: "Height over diameter", "Height over the diameter of the bottom; below 1 the cylinder is wider than high.", "", 1.2, [0.3, 3.0, 0.05];
        top: "Width at the top over that below", "Leans the wall in below 1 and out above 1; at 1 the top is as wide as the bottom.", "", 1.0, [0.4, 1.6, 0.05];
        belly: "Belly, or waist below 0", "Swells the wall at half its height, in radii of the bottom; below 0 it draws a waist.", "", 0.0, [-0.35, 0.5, 0.05];
        caps: "Ends", "Closes both ends with flat disks, or leaves a tube that is open above and below.", "", 1.0, [0.0, 1.0, 1.0];
    }
    SPHERE {
        height: "Height over width", "Squashes the ball below 1 and stretches it upwards above 1.", "", 1.0, [0.4, 2.0, 0.05];
        depth: "Depth over width", "Makes the ball thinner from front to back below 1, and longer above 1.", "", 1.0, [0.4, 2.0, 0.05];
        square: "Squareness", "Turns the ball into a box with rounded edges; 2 leaves it round, and 6 is almost a box.", "", 2.0, [2.0, 6.0, 0.1];
    }
    TORUS {
        tube: "Radius of the tube over that of the ring", "Thickens the tube, which makes the hole smaller; deep waves limit it.", "", 0.4, [0.12, 0.75, 0.01];
        height: "Height of the tube over its width", "Flattens the tube below 1 and raises it above 1; at 1 its section is a circle.", "", 1.0, [0.5, 2.0, 0.05];
        waves: "Waves around", "Counts how often the ring bends out and in; 0 leaves a circle, and 2 makes an oval.", "", 0.0, [0.0, 8.0, 1.0];
        swell: "Depth of the waves", "Share of the deepest waves that the ring can take; 0 leaves a circle. Many waves are shallower.", "", 0.5, [0.0, 1.0, 0.05];
    }
    KNOT {
        turns: "Turns around the middle", "Turns of the tube until it closes; 3 make a denser knot than 2.", "", 2.0, [2.0, 3.0, 1.0];
        lobes: "Lobes", "Loops around the middle; a multiple of the turns would give no knot, so it gets one more.", "", 3.0, [3.0, 8.0, 1.0];
        tube: "Thickness", "Share of the thickness at which the tube would touch itself; 0.85 leaves only narrow gaps.", "", 0.7, [0.35, 0.85, 0.05];
        swing: "How far lobes swing in and out", "Share of the knot's middle radius; more opens the loops and narrows the hole in the middle.", "", 0.42, [0.25, 0.52, 0.01];
        height: "How far lobes swing to front and back", "Multiple of the swing in and out; 0.6 makes a flat knot, and 1.4 a deep one.", "", 0.9, [0.6, 1.4, 0.05];
    }
    HORN {
        turns: "Turns", "Turns from the root to the tip; 0.25 is hardly bent, and 3 wind like a snail's shell.", "", 2.0, [0.25, 3.0, 0.05];
        rise: "How far it winds out of its plane", "Draws the spiral out to the front, in radii of its widest turn; 0 leaves it flat like an ammonite.", "", 1.0, [0.0, 2.0, 0.05];
        taper: "Width of the tip over that of the root", "Smaller values sharpen the tip and draw the inner turns closer to the middle.", "", 0.14, [0.08, 0.6, 0.01];
        girth: "Thickness", "Share of the thickness at which turns would touch or bends fold; 0.85 leaves narrow gaps.", "", 0.7, [0.35, 0.85, 0.05];
    }
    LEG {
        toes: "Toes", "Toes in a fan to the front; those in the middle are the longest.", "", 4.0, [3.0, 5.0, 1.0];
        spread: "Angle between toes", "Angle from each toe to the next one; greater angles open the fan.", "°", 27.0, [21.0, 34.0, 1.0];
        bend: "Bend of the knee", "Bends knee and ankle together; 0 leaves the leg almost straight. Its height stays the same.", "°", 34.0, [0.0, 55.0, 1.0];
        girth: "Thickness", "Multiple of the usual thickness of the limb; toes change by a fifth as much.", "", 1.0, [0.75, 1.25, 0.05];
        reach: "Length of the toes", "Multiple of the usual length of the toes; the rest of the leg stays the same.", "", 1.0, [0.7, 1.35, 0.05];
    }
    TAIL {
        curl: "Curl", "Angle by which the tail turns from root to tip, most of it near the tip; 0 leaves it straight.", "°", 290.0, [0.0, 450.0, 5.0];
        taper: "Width of the tip over that of the root", "Smaller values sharpen the tip; 0.6 leaves it blunt.", "", 0.2, [0.1, 0.6, 0.01];
        girth: "Width of the root over the length", "Thickens the whole tail; a tight flat curl limits it, so that its turns do not touch.", "", 0.17, [0.08, 0.26, 0.01];
        lift: "How far it winds out of its plane", "Leads the curl to the front like a screw; 0 keeps it flat, 1 moves the tip by over a third of the length.", "", 0.3, [0.0, 1.0, 0.05];
    }
    FISH {
        height: "Height of the body over the length", "Height without fins; 0.22 is as slender as a pike, and 0.52 as tall as a bream.", "", 0.36, [0.22, 0.52, 0.01];
        width: "Width of the body over its height", "Thickness from side to side; 0.34 is flat, and 0.7 is plump.", "", 0.46, [0.34, 0.7, 0.02];
        tail: "Size of the tail", "Multiple of the usual size of the tail fin; a greater one also makes the fish longer.", "", 1.0, [0.7, 1.3, 0.05];
        fins: "Size of the fins", "Multiple of the usual size of the fins on back, belly and sides; the tail stays the same.", "", 1.0, [0.7, 1.3, 0.05];
        swim: "Bend to the side", "Curves head and tail to the front, below 0 to the back, by about this angle; 0 leaves the fish straight.", "°", 14.0, [-40.0, 40.0, 2.0];
    }
    TURTLE {
        width: "Width over length", "Size from side to side over that from head to tail; 1 makes the shell nearly round.", "", 0.8, [0.6, 1.0, 0.01];
        height: "Height over length", "Height of the dome; 0.18 is as flat as a pond turtle, and 0.55 as high as a tortoise.", "", 0.34, [0.18, 0.55, 0.01];
        rim: "Thickness of the rim", "Thickens the edge around the shell, from a thin rim at 0 to a thick one at 1.", "", 0.5, [0.0, 1.0, 0.05];
        keel: "Keels along the back", "Raises three ridges from head to tail; 0 leaves none, 1 raises the middle by a seventh of the height.", "", 0.4, [0.0, 1.0, 0.05];
    }
    EGG {
        height: "Height over width", "Height before the base is cut off; below 1 the egg is wider than high.", "", 1.35, [0.8, 1.9, 0.05];
        point: "How pointed the top is", "Narrows the top and widens the bottom; at 0 both ends are alike.", "", 0.2, [0.0, 0.4, 0.02];
        base: "Part cut off below", "Share of the height that is cut off, so that the egg stands; 0 leaves the round end.", "", 0.0, [0.0, 0.3, 0.01];
    }
    VASE {
        height: "Height over width", "Height over the greatest width; 1 is a squat pot, and 2.4 a tall vase.", "", 1.5, [1.0, 2.4, 0.05];
        shoulder: "Height of the widest place", "Share of the height at which the vase is widest; small values give a low belly, great ones shoulders.", "", 0.52, [0.35, 0.65, 0.01];
        neck: "Width of the neck over the widest", "Smaller values draw the neck in; at 0.8 there is hardly a neck.", "", 0.42, [0.3, 0.8, 0.01];
        lip: "Width of the lip over that of the neck", "Spreads the lip beyond the neck, at most to the greatest width; 1 leaves no lip.", "", 1.35, [1.0, 1.7, 0.05];
        hollow: "Depth inside over the height", "Depth from the lip to the floor inside; 0.2 leaves most of the vase solid, and 0.85 a thin floor.", "", 0.6, [0.2, 0.85, 0.05];
    }
    LETTER {
        letter: "Letter", "Capital letter that stands as a solid of thick strokes.", "", 1.0, [1.0, 26.0, 1.0];
        weight: "Width of strokes over height", "Width of each stroke; 0.13 is light, and 0.22 is bold.", "", 0.18, [0.13, 0.22, 0.01];
        depth: "Depth over height", "Thickness from front to back; the outline of the letter stays the same.", "", 0.26, [0.14, 0.5, 0.02];
        round: "Roundness of edges", "Rounds the edges; 1 makes them as round as they can be, and 0.35 leaves flat faces.", "", 0.6, [0.35, 1.0, 0.05];
        lean: "Lean", "Leans the letter to the right like italics, below 0 to the left; 0 leaves it upright.", "°", 0.0, [-10.0, 20.0, 1.0];
    }
}

by_rule! {
    Shape {
        Terrain: "terrain", "Terrain", TERRAIN;
        Slope: "slope", "Slope", SLOPE;
        Stairs: "stairs", "Stairs", STAIRS;
        Cylinder: "cylinder", "Cylinder", CYLINDER;
        Sphere: "sphere", "Sphere", SPHERE;
        Torus: "torus", "Torus", TORUS;
        Knot: "knot", "Knot", KNOT;
        Horn: "horn", "Horn", HORN;
        Leg: "leg", "Leg", LEG;
        Tail: "tail", "Tail", TAIL;
        Fish: "fish", "Fish", FISH;
        Turtle: "turtle", "Turtle's back", TURTLE;
        Egg: "egg", "Egg", EGG;
        Vase: "vase", "Vase", VASE;
        Letter: "letter", "Letter", LETTER;
    }
}
