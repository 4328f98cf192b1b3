//! Rows of the numbers of shapes in space, shared by the generators that use a shape. A row is shown with its shape
//! only.

use super::lists::lists;
use super::numbered::rule_row;
use crate::pile_shape::numbers as piled;
use crate::recipe::parameter::Parameter;
use crate::recipe::schema::choices;
use crate::recipe::{Choice, Key};
use crate::shapes::{ShapeNumber, numbers};

/// The key of the choice of a shape.
const FORM: Key = Key("form");

/// The ends of a cylinder, by their numbers.
const ENDS: &[Choice] = choices![1: "Closed", 0: "Open"];

/// The letters, by their numbers.
const LETTERS: &[Choice] = choices![
    1: "A", 2: "B", 3: "C", 4: "D", 5: "E", 6: "F", 7: "G", 8: "H", 9: "I", 10: "J", 11: "K", 12: "L", 13: "M", 14: "N", 15: "O", 16: "P", 17: "Q", 18: "R", 19: "S", 20: "T", 21: "U", 22: "V", 23: "W", 24: "X", 25: "Y", 26: "Z",
];

/// The row of a number of a shape.
const fn number_row(of: &ShapeNumber, shape: &'static [&'static str]) -> Parameter {
    rule_row(of, "Shape").only_for(FORM, shape)
}

lists! {
    NUMBERS: "Rows of the numbers of all shapes." {
        terrain_hills TERRAIN_HILLS => number_row(&numbers::TERRAIN[0], &["terrain"]);
        terrain_height TERRAIN_HEIGHT => number_row(&numbers::TERRAIN[1], &["terrain"]);
        terrain_lane TERRAIN_LANE => number_row(&numbers::TERRAIN[2], &["terrain"]);
        terrain_wind TERRAIN_WIND => number_row(&numbers::TERRAIN[3], &["terrain"]);
        terrain_hill TERRAIN_HILL => number_row(&numbers::TERRAIN[4], &["terrain"]);
        slope_rise SLOPE_RISE => number_row(&numbers::SLOPE[0], &["slope"]);
        slope_landing SLOPE_LANDING => number_row(&numbers::SLOPE[1], &["slope"]);
        slope_width SLOPE_WIDTH => number_row(&numbers::SLOPE[2], &["slope"]);
        slope_round SLOPE_ROUND => number_row(&numbers::SLOPE[3], &["slope"]);
        stairs_steps STAIRS_STEPS => number_row(&numbers::STAIRS[0], &["stairs"]);
        stairs_pitch STAIRS_PITCH => number_row(&numbers::STAIRS[1], &["stairs"]);
        stairs_width STAIRS_WIDTH => number_row(&numbers::STAIRS[2], &["stairs"]);
        stairs_landing STAIRS_LANDING => number_row(&numbers::STAIRS[3], &["stairs"]);
        cylinder_height CYLINDER_HEIGHT => number_row(&numbers::CYLINDER[0], &["cylinder"]);
        cylinder_top CYLINDER_TOP => number_row(&numbers::CYLINDER[1], &["cylinder"]);
        cylinder_belly CYLINDER_BELLY => number_row(&numbers::CYLINDER[2], &["cylinder"]);
        cylinder_caps CYLINDER_CAPS => number_row(&numbers::CYLINDER[3], &["cylinder"]).as_choice(ENDS);
        sphere_height SPHERE_HEIGHT => number_row(&numbers::SPHERE[0], &["sphere"]);
        sphere_depth SPHERE_DEPTH => number_row(&numbers::SPHERE[1], &["sphere"]);
        sphere_square SPHERE_SQUARE => number_row(&numbers::SPHERE[2], &["sphere"]);
        torus_tube TORUS_TUBE => number_row(&numbers::TORUS[0], &["torus"]);
        torus_height TORUS_HEIGHT => number_row(&numbers::TORUS[1], &["torus"]);
        torus_waves TORUS_WAVES => number_row(&numbers::TORUS[2], &["torus"]);
        torus_swell TORUS_SWELL => number_row(&numbers::TORUS[3], &["torus"]);
        knot_turns KNOT_TURNS => number_row(&numbers::KNOT[0], &["knot"]);
        knot_lobes KNOT_LOBES => number_row(&numbers::KNOT[1], &["knot"]);
        knot_tube KNOT_TUBE => number_row(&numbers::KNOT[2], &["knot"]);
        knot_swing KNOT_SWING => number_row(&numbers::KNOT[3], &["knot"]);
        knot_height KNOT_HEIGHT => number_row(&numbers::KNOT[4], &["knot"]);
        horn_turns HORN_TURNS => number_row(&numbers::HORN[0], &["horn"]);
        horn_rise HORN_RISE => number_row(&numbers::HORN[1], &["horn"]);
        horn_taper HORN_TAPER => number_row(&numbers::HORN[2], &["horn"]);
        horn_girth HORN_GIRTH => number_row(&numbers::HORN[3], &["horn"]);
        leg_toes LEG_TOES => number_row(&numbers::LEG[0], &["leg"]);
        leg_spread LEG_SPREAD => number_row(&numbers::LEG[1], &["leg"]);
        leg_bend LEG_BEND => number_row(&numbers::LEG[2], &["leg"]);
        leg_girth LEG_GIRTH => number_row(&numbers::LEG[3], &["leg"]);
        leg_reach LEG_REACH => number_row(&numbers::LEG[4], &["leg"]);
        tail_curl TAIL_CURL => number_row(&numbers::TAIL[0], &["tail"]);
        tail_taper TAIL_TAPER => number_row(&numbers::TAIL[1], &["tail"]);
        tail_girth TAIL_GIRTH => number_row(&numbers::TAIL[2], &["tail"]);
        tail_lift TAIL_LIFT => number_row(&numbers::TAIL[3], &["tail"]);
        fish_height FISH_HEIGHT => number_row(&numbers::FISH[0], &["fish"]);
        fish_width FISH_WIDTH => number_row(&numbers::FISH[1], &["fish"]);
        fish_tail FISH_TAIL => number_row(&numbers::FISH[2], &["fish"]);
        fish_fins FISH_FINS => number_row(&numbers::FISH[3], &["fish"]);
        fish_swim FISH_SWIM => number_row(&numbers::FISH[4], &["fish"]);
        turtle_width TURTLE_WIDTH => number_row(&numbers::TURTLE[0], &["turtle"]);
        turtle_height TURTLE_HEIGHT => number_row(&numbers::TURTLE[1], &["turtle"]);
        turtle_rim TURTLE_RIM => number_row(&numbers::TURTLE[2], &["turtle"]);
        turtle_keel TURTLE_KEEL => number_row(&numbers::TURTLE[3], &["turtle"]);
        egg_height EGG_HEIGHT => number_row(&numbers::EGG[0], &["egg"]);
        egg_point EGG_POINT => number_row(&numbers::EGG[1], &["egg"]);
        egg_base EGG_BASE => number_row(&numbers::EGG[2], &["egg"]);
        vase_height VASE_HEIGHT => number_row(&numbers::VASE[0], &["vase"]);
        vase_shoulder VASE_SHOULDER => number_row(&numbers::VASE[1], &["vase"]);
        vase_neck VASE_NECK => number_row(&numbers::VASE[2], &["vase"]);
        vase_lip VASE_LIP => number_row(&numbers::VASE[3], &["vase"]);
        vase_hollow VASE_HOLLOW => number_row(&numbers::VASE[4], &["vase"]);
        letter_letter LETTER_LETTER => number_row(&numbers::LETTER[0], &["letter"]).as_choice(LETTERS);
        letter_weight LETTER_WEIGHT => number_row(&numbers::LETTER[1], &["letter"]);
        letter_depth LETTER_DEPTH => number_row(&numbers::LETTER[2], &["letter"]);
        letter_round LETTER_ROUND => number_row(&numbers::LETTER[3], &["letter"]);
        letter_lean LETTER_LEAN => number_row(&numbers::LETTER[4], &["letter"]);
    }

    PILED: "Rows of the numbers of shapes made for piles." {
        heap_height HEAP_HEIGHT => number_row(&piled::HEAP[0], &["heap"]);
        heap_round HEAP_ROUND => number_row(&piled::HEAP[1], &["heap"]);
        heap_depth HEAP_DEPTH => number_row(&piled::HEAP[2], &["heap"]);
        dome_height DOME_HEIGHT => number_row(&piled::DOME[0], &["dome"]);
        dome_depth DOME_DEPTH => number_row(&piled::DOME[1], &["dome"]);
        riceball_thick RICEBALL_THICK => number_row(&piled::RICE_BALL[0], &["riceball"]);
        riceball_round RICEBALL_ROUND => number_row(&piled::RICE_BALL[1], &["riceball"]);
        block_height BLOCK_HEIGHT => number_row(&piled::BLOCK[0], &["block"]);
        block_depth BLOCK_DEPTH => number_row(&piled::BLOCK[1], &["block"]);
        block_round BLOCK_ROUND => number_row(&piled::BLOCK[2], &["block"]);
        bowl_depth BOWL_DEPTH => number_row(&piled::BOWL[0], &["bowl"]);
        bowl_full BOWL_FULL => number_row(&piled::BOWL[1], &["bowl"]);
        openbox_depth OPENBOX_DEPTH => number_row(&piled::OPEN_BOX[0], &["openbox"]);
        openbox_height OPENBOX_HEIGHT => number_row(&piled::OPEN_BOX[1], &["openbox"]);
        openbox_full OPENBOX_FULL => number_row(&piled::OPEN_BOX[2], &["openbox"]);
    }
}
