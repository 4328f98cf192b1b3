//! Rows of the numbers of buildings by rule.

use super::lists::lists;
use super::numbered::rule_row;
use crate::building::rules::numbers;
use crate::recipe::parameter::Parameter;
use crate::recipe::schema::choices;
use crate::recipe::{Choice, Key};
use crate::shapes::ShapeNumber;

/// The key of the choice of a building.
const BUILDING: Key = Key("building");

/// The shapes of heads of openings, by their numbers, with each default first.
const STRAIGHT_FIRST: &[Choice] = choices![0: "Straight", 1: "Segmental", 2: "Round"];
const SEGMENTAL_FIRST: &[Choice] = choices![1: "Segmental", 0: "Straight", 2: "Round"];
const ROUND_FIRST: &[Choice] = choices![2: "Round", 0: "Straight", 1: "Segmental"];

/// The row of a number of a building.
const fn number_row(of: &ShapeNumber, building: &'static [&'static str]) -> Parameter {
    rule_row(of, "Building").only_for(BUILDING, building)
}

lists! {
    NUMBERS: "Rows of the numbers of all buildings." {
        block_length BLOCK_LENGTH => number_row(&numbers::BLOCK[0], &["block"]);
        block_width BLOCK_WIDTH => number_row(&numbers::BLOCK[1], &["block"]);
        block_height BLOCK_HEIGHT => number_row(&numbers::BLOCK[2], &["block"]);
        lhouse_length LHOUSE_LENGTH => number_row(&numbers::L_HOUSE[0], &["lhouse"]);
        lhouse_width LHOUSE_WIDTH => number_row(&numbers::L_HOUSE[1], &["lhouse"]);
        lhouse_wing LHOUSE_WING => number_row(&numbers::L_HOUSE[2], &["lhouse"]);
        lhouse_depth LHOUSE_DEPTH => number_row(&numbers::L_HOUSE[3], &["lhouse"]);
        lhouse_height LHOUSE_HEIGHT => number_row(&numbers::L_HOUSE[4], &["lhouse"]);
        lhouse_windows LHOUSE_WINDOWS => number_row(&numbers::L_HOUSE[5], &["lhouse"]);
        lhouse_head LHOUSE_HEAD => number_row(&numbers::L_HOUSE[6], &["lhouse"]).as_choice(SEGMENTAL_FIRST);
        lhouse_pitch LHOUSE_PITCH => number_row(&numbers::L_HOUSE[7], &["lhouse"]);
        gabled_length GABLED_LENGTH => number_row(&numbers::GABLED[0], &["gabled"]);
        gabled_width GABLED_WIDTH => number_row(&numbers::GABLED[1], &["gabled"]);
        gabled_height GABLED_HEIGHT => number_row(&numbers::GABLED[2], &["gabled"]);
        gabled_pitch GABLED_PITCH => number_row(&numbers::GABLED[3], &["gabled"]);
        gabled_windows GABLED_WINDOWS => number_row(&numbers::GABLED[4], &["gabled"]);
        gabled_head GABLED_HEAD => number_row(&numbers::GABLED[5], &["gabled"]).as_choice(STRAIGHT_FIRST);
        wall_length WALL_LENGTH => number_row(&numbers::WALL[0], &["wall"]);
        wall_height WALL_HEIGHT => number_row(&numbers::WALL[1], &["wall"]);
        wall_thickness WALL_THICKNESS => number_row(&numbers::WALL[2], &["wall"]);
        wall_width WALL_WIDTH => number_row(&numbers::WALL[3], &["wall"]);
        wall_head WALL_HEAD => number_row(&numbers::WALL[4], &["wall"]).as_choice(ROUND_FIRST);
        gate_span GATE_SPAN => number_row(&numbers::GATE[0], &["gate"]);
        gate_pier GATE_PIER => number_row(&numbers::GATE[1], &["gate"]);
        gate_springing GATE_SPRINGING => number_row(&numbers::GATE[2], &["gate"]);
        gate_over GATE_OVER => number_row(&numbers::GATE[3], &["gate"]);
        gate_thickness GATE_THICKNESS => number_row(&numbers::GATE[4], &["gate"]);
        steps_steps STEPS_STEPS => number_row(&numbers::STEPS[0], &["steps"]);
        steps_width STEPS_WIDTH => number_row(&numbers::STEPS[1], &["steps"]);
        steps_tread STEPS_TREAD => number_row(&numbers::STEPS[2], &["steps"]);
        steps_riser STEPS_RISER => number_row(&numbers::STEPS[3], &["steps"]);
        steps_column STEPS_COLUMN => number_row(&numbers::STEPS[4], &["steps"]);
        steps_height STEPS_HEIGHT => number_row(&numbers::STEPS[5], &["steps"]);
        tower_around TOWER_AROUND => number_row(&numbers::TOWER[0], &["tower"]);
        tower_height TOWER_HEIGHT => number_row(&numbers::TOWER[1], &["tower"]);
        tower_thickness TOWER_THICKNESS => number_row(&numbers::TOWER[2], &["tower"]);
        tower_windows TOWER_WINDOWS => number_row(&numbers::TOWER[3], &["tower"]);
        tower_width TOWER_WIDTH => number_row(&numbers::TOWER[4], &["tower"]);
        ring_walls RING_WALLS => number_row(&numbers::RING[0], &["ring"]);
        ring_side RING_SIDE => number_row(&numbers::RING[1], &["ring"]);
        ring_height RING_HEIGHT => number_row(&numbers::RING[2], &["ring"]);
        ring_thickness RING_THICKNESS => number_row(&numbers::RING[3], &["ring"]);
        sheet_length SHEET_LENGTH => number_row(&numbers::SHEET[0], &["sheet"]);
        sheet_height SHEET_HEIGHT => number_row(&numbers::SHEET[1], &["sheet"]);
        sheet_thickness SHEET_THICKNESS => number_row(&numbers::SHEET[2], &["sheet"]);
        plan_height PLAN_HEIGHT => number_row(&numbers::PLAN[0], &["plan"]);
        plan_thickness PLAN_THICKNESS => number_row(&numbers::PLAN[1], &["plan"]);
        plan_pitch PLAN_PITCH => number_row(&numbers::PLAN[2], &["plan"]);
    }
}
