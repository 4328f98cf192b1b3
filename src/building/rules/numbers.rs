//! The numbers of buildings by rule.

use crate::shapes::ShapeNumber;
use crate::shapes::numbers::numbers;

numbers! {
    BLOCK {
        length: "Length in modules", "One of the numbers that the building is made by.", "", 20.0, [2.0, 80.0, 1.0];
        width: "Width in modules", "One of the numbers that the building is made by.", "", 14.0, [2.0, 80.0, 1.0];
        height: "Height in courses", "One of the numbers that the building is made by.", "", 18.0, [2.0, 80.0, 1.0];
    }
    L_HOUSE {
        length: "Length in modules", "One of the numbers that the building is made by.", "", 44.0, [16.0, 80.0, 1.0];
        width: "Width in modules", "One of the numbers that the building is made by.", "", 36.0, [16.0, 80.0, 1.0];
        wing: "Length of the wing in modules", "One of the numbers that the building is made by.", "", 18.0, [8.0, 60.0, 1.0];
        depth: "Width of the wing in modules", "One of the numbers that the building is made by.", "", 16.0, [8.0, 60.0, 1.0];
        height: "Height in courses", "One of the numbers that the building is made by.", "", 34.0, [24.0, 60.0, 1.0];
        windows: "Windows in a wall", "One of the numbers that the building is made by.", "", 3.0, [0.0, 6.0, 1.0];
        head: "Heads of openings", "One of the numbers that the building is made by.", "", 1.0, [0.0, 2.0, 1.0];
        pitch: "Pitch of the roof", "One of the numbers that the building is made by.", "°", 44.0, [20.0, 60.0, 1.0];
    }
    GABLED {
        length: "Length in modules", "One of the numbers that the building is made by.", "", 44.0, [20.0, 80.0, 1.0];
        width: "Width in modules", "One of the numbers that the building is made by.", "", 30.0, [18.0, 60.0, 1.0];
        height: "Height of the eaves in courses", "One of the numbers that the building is made by.", "", 32.0, [26.0, 60.0, 1.0];
        pitch: "Pitch of the roof", "One of the numbers that the building is made by.", "°", 42.0, [20.0, 60.0, 1.0];
        windows: "Windows in a wall", "One of the numbers that the building is made by.", "", 2.0, [0.0, 6.0, 1.0];
        head: "Heads of openings", "One of the numbers that the building is made by.", "", 0.0, [0.0, 2.0, 1.0];
    }
    WALL {
        length: "Length in modules", "One of the numbers that the building is made by.", "", 44.0, [26.0, 100.0, 1.0];
        height: "Height in courses", "One of the numbers that the building is made by.", "", 26.0, [20.0, 60.0, 1.0];
        thickness: "Thickness in modules", "One of the numbers that the building is made by.", "", 3.0, [2.0, 6.0, 1.0];
        width: "Width of an opening in modules", "One of the numbers that the building is made by.", "", 6.0, [3.0, 8.0, 1.0];
        head: "Head of the middle opening", "One of the numbers that the building is made by.", "", 2.0, [0.0, 2.0, 1.0];
    }
    GATE {
        span: "Span in modules", "One of the numbers that the building is made by.", "", 12.0, [4.0, 24.0, 1.0];
        pier: "Width of a pier in modules", "One of the numbers that the building is made by.", "", 6.0, [2.0, 12.0, 1.0];
        springing: "Height of the springing in courses", "One of the numbers that the building is made by.", "", 16.0, [6.0, 40.0, 1.0];
        over: "Courses above the crown", "One of the numbers that the building is made by.", "", 6.0, [3.0, 20.0, 1.0];
        thickness: "Thickness in modules", "One of the numbers that the building is made by.", "", 4.0, [2.0, 12.0, 1.0];
    }
    STEPS {
        steps: "Steps", "One of the numbers that the building is made by.", "", 4.0, [2.0, 12.0, 1.0];
        width: "Width in modules", "One of the numbers that the building is made by.", "", 16.0, [6.0, 40.0, 1.0];
        tread: "Tread in modules", "One of the numbers that the building is made by.", "", 2.0, [2.0, 4.0, 1.0];
        riser: "Riser in courses", "One of the numbers that the building is made by.", "", 2.0, [1.0, 3.0, 1.0];
        column: "Width of a column in modules", "One of the numbers that the building is made by.", "", 6.0, [4.0, 10.0, 1.0];
        height: "Height of a column in courses", "One of the numbers that the building is made by.", "", 16.0, [8.0, 40.0, 1.0];
    }
    TOWER {
        around: "Circumference in modules", "One of the numbers that the building is made by.", "", 80.0, [40.0, 240.0, 2.0];
        height: "Height in courses", "One of the numbers that the building is made by.", "", 48.0, [24.0, 120.0, 1.0];
        thickness: "Thickness in modules", "One of the numbers that the building is made by.", "", 3.0, [2.0, 4.0, 1.0];
        windows: "Windows", "One of the numbers that the building is made by.", "", 6.0, [0.0, 12.0, 1.0];
        width: "Width of a window in modules", "One of the numbers that the building is made by.", "", 4.0, [2.0, 6.0, 1.0];
    }
    RING {
        walls: "Walls", "One of the numbers that the building is made by.", "", 5.0, [3.0, 12.0, 1.0];
        side: "Length of a wall in modules", "One of the numbers that the building is made by.", "", 12.0, [8.0, 40.0, 1.0];
        height: "Height in courses", "One of the numbers that the building is made by.", "", 14.0, [3.0, 60.0, 1.0];
        thickness: "Thickness in modules", "One of the numbers that the building is made by.", "", 2.0, [1.0, 2.0, 1.0];
    }
    SHEET {
        length: "Length in modules", "One of the numbers that the building is made by.", "", 30.0, [4.0, 100.0, 1.0];
        height: "Height in courses", "One of the numbers that the building is made by.", "", 20.0, [3.0, 60.0, 1.0];
        thickness: "Thickness in modules", "One of the numbers that the building is made by.", "", 2.0, [1.0, 6.0, 1.0];
    }
    PLAN {
        height: "Height in courses", "One of the numbers that the building is made by.", "", 24.0, [8.0, 60.0, 1.0];
        thickness: "Thickness in modules", "One of the numbers that the building is made by.", "", 2.0, [2.0, 6.0, 1.0];
        pitch: "Pitch of a roof; 0 for none", "One of the numbers that the building is made by.", "°", 0.0, [0.0, 60.0, 1.0];
    }
}
