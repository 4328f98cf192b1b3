//! The numbers of buildings by rule.

use crate::shapes::ShapeNumber;
use crate::shapes::numbers::numbers;

numbers! {
    BLOCK {
        length: "Length in modules", "Size from left to right; a module is half a brick with its joint.", "", 20.0, [2.0, 80.0, 1.0];
        width: "Width in modules", "Size from front to back, in halves of a brick with their joints.", "", 14.0, [2.0, 80.0, 1.0];
        height: "Height in courses", "Rows of bricks from the ground to the top; a course is a row with its joint.", "", 18.0, [2.0, 80.0, 1.0];
    }
    L_HOUSE {
        length: "Length in modules", "Size of the main house from left to right, along its ridge.", "", 44.0, [16.0, 80.0, 1.0];
        width: "Width in modules", "Size from front to back, with the wing.", "", 36.0, [16.0, 80.0, 1.0];
        wing: "Width of the wing in modules", "Size of the wing from left to right; the main house stays at least 6 modules longer.", "", 18.0, [8.0, 60.0, 1.0];
        depth: "Length of the wing in modules", "How far the wing reaches behind the main house, which stays at least 6 modules wide.", "", 16.0, [8.0, 60.0, 1.0];
        height: "Height of the eaves in courses", "Rows of bricks from the ground to the roof; windows stay at their height.", "", 34.0, [24.0, 60.0, 1.0];
        windows: "Windows in a wall", "Windows in each wall, as many as fit; the door takes the place of one and stays without them.", "", 3.0, [0.0, 6.0, 1.0];
        head: "Heads of openings", "Tops of windows and the door; segmental heads are flat arcs, and round ones half circles.", "", 1.0, [0.0, 2.0, 1.0];
        pitch: "Pitch of the roof", "Angle of the roof to the level; a wide wing has a flatter one, so that its ridge stays lower.", "°", 44.0, [20.0, 60.0, 1.0];
    }
    GABLED {
        length: "Length in modules", "Size along the ridge; the roof reaches 20 cm beyond both gables.", "", 44.0, [20.0, 80.0, 1.0];
        width: "Width in modules", "Size across the ridge; a wider house has a higher roof.", "", 30.0, [18.0, 60.0, 1.0];
        height: "Height of the eaves in courses", "Rows of bricks in the long walls, from the ground to the underside of the roof.", "", 32.0, [26.0, 60.0, 1.0];
        pitch: "Pitch of the roof", "Angle of the roof to the level; a steep one leaves room for a window in each gable.", "°", 42.0, [20.0, 60.0, 1.0];
        windows: "Windows in a wall", "Windows in each wall, as many as fit, and at most 3 below a gable; the front has a door as well.", "", 2.0, [0.0, 6.0, 1.0];
        head: "Heads of openings", "Tops of the door and the windows; the small window in each gable is always round.", "", 0.0, [0.0, 2.0, 1.0];
    }
    WALL {
        length: "Length in modules", "Size from end to end; a short wall has narrower openings.", "", 44.0, [26.0, 100.0, 1.0];
        height: "Height in courses", "Rows of bricks from the ground to the top; a low wall has lower openings.", "", 26.0, [20.0, 60.0, 1.0];
        thickness: "Thickness in modules", "Size from front to back; 2 modules are the length of a brick.", "", 3.0, [2.0, 6.0, 1.0];
        width: "Width of an opening in modules", "Width of the left and the middle opening; the right one is 2 modules wider.", "", 6.0, [3.0, 8.0, 1.0];
        head: "Head of the middle opening", "Top of the opening in the middle; those on both sides are always straight.", "", 2.0, [0.0, 2.0, 1.0];
    }
    GATE {
        span: "Span in modules", "Width of the passage; the arch above it is half as high as wide.", "", 12.0, [4.0, 24.0, 1.0];
        pier: "Width of a pier in modules", "Width of the wall on each side of the passage.", "", 6.0, [2.0, 12.0, 1.0];
        springing: "Height of the springing in courses", "Rows of bricks from the ground to the place where the arch begins.", "", 16.0, [6.0, 40.0, 1.0];
        over: "Courses above the crown", "Rows of bricks from the top of the arch to the top of the wall.", "", 6.0, [3.0, 20.0, 1.0];
        thickness: "Thickness in modules", "Length of the passage from front to back; 2 modules are the length of a brick.", "", 4.0, [2.0, 12.0, 1.0];
    }
    STEPS {
        steps: "Steps", "Steps from the ground to the top; more of them lead higher and farther back.", "", 4.0, [2.0, 12.0, 1.0];
        width: "Width in modules", "Size of the steps from side to side, between both columns.", "", 16.0, [6.0, 40.0, 1.0];
        tread: "Tread in modules", "Depth of each step; 2 modules are the length of a brick.", "", 2.0, [2.0, 4.0, 1.0];
        riser: "Riser in courses", "Rows of bricks from one tread up to the next one; more make the steps steeper.", "", 2.0, [1.0, 3.0, 1.0];
        column: "Width of a column in modules", "Width and depth of both columns; caps reach 1 module beyond them on each side.", "", 6.0, [4.0, 10.0, 1.0];
        height: "Height of a column in courses", "Rows of bricks from the ground to the top of a column; its cap takes 2 of them.", "", 16.0, [8.0, 40.0, 1.0];
    }
    TOWER {
        around: "Circumference in modules", "Length of a course around the outside; 80 modules make a tower about 25 modules wide.", "", 80.0, [40.0, 240.0, 2.0];
        height: "Height in courses", "Rows of bricks from the ground to the open top.", "", 48.0, [24.0, 120.0, 1.0];
        thickness: "Thickness in modules", "Size of the wall from outside to inside; 2 modules are the length of a brick.", "", 3.0, [2.0, 4.0, 1.0];
        windows: "Windows", "Windows around the tower, as many as fit; every other one stands higher.", "", 6.0, [0.0, 12.0, 1.0];
        width: "Width of a window in modules", "Width of each window along the wall; wide windows leave room for fewer.", "", 4.0, [2.0, 6.0, 1.0];
    }
    RING {
        walls: "Walls", "Walls of a regular ring; 3 make a triangle, and 12 are nearly a circle.", "", 5.0, [3.0, 12.0, 1.0];
        side: "Length of a wall in modules", "Length of each wall outside, from corner to corner; longer walls make a wider ring.", "", 12.0, [8.0, 40.0, 1.0];
        height: "Height in courses", "Rows of bricks from the ground to the top of all walls.", "", 14.0, [3.0, 60.0, 1.0];
        thickness: "Thickness in modules", "Size across each wall; 1 module is half a brick, and 2 are the length of one.", "", 2.0, [1.0, 2.0, 1.0];
    }
    SHEET {
        length: "Length in modules", "Size from end to end of the single face, which has no openings.", "", 30.0, [4.0, 100.0, 1.0];
        height: "Height in courses", "Rows of bricks from the ground to the top of the face.", "", 20.0, [3.0, 60.0, 1.0];
        thickness: "Thickness in modules", "How far bricks reach behind the face; 1 module is half a brick, and 2 are the length of one.", "", 2.0, [1.0, 6.0, 1.0];
    }
    PLAN {
        height: "Height in courses", "Rows of bricks in all walls; openings end at least 4 courses below the top.", "", 24.0, [8.0, 60.0, 1.0];
        thickness: "Thickness in modules", "Size across the walls, which stand to the left of the drawn line.", "", 2.0, [2.0, 6.0, 1.0];
        pitch: "Pitch of a roof; 0 for none", "Raises a roof over a closed plan without inward corners; 0 leaves the walls open above.", "°", 0.0, [0.0, 60.0, 1.0];
    }
}
