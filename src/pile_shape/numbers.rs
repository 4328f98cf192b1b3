//! The numbers of each shape.

use crate::shapes::ShapeNumber;
use crate::shapes::numbers::numbers;

numbers! {
    HEAP {
        height: "Height over width", "Height of the peak; 0.1 is spread out flat, and 0.5 is steep.", "", 0.29, [0.1, 0.5, 0.01];
        round: "Roundness of the peak", "Softens the peak and the foot; 0.3 is almost a cone, and 1 is smooth all over.", "", 0.86, [0.3, 1.0, 0.02];
        depth: "Depth over width", "Squeezes the heap from front to back into an oval; 1 leaves its foot round.", "", 1.0, [0.5, 1.0, 0.05];
    }
    DOME {
        height: "Height over width", "Height of the dome; 0.5 makes half a ball if the depth is 1.", "", 0.5, [0.15, 0.8, 0.01];
        depth: "Depth over width", "Squeezes the dome from front to back into an oval; 1 leaves its foot round.", "", 1.0, [0.5, 1.0, 0.05];
    }
    RICE_BALL {
        thick: "Thickness over width", "Size from front to back; 0.3 is a thin rice ball, and 0.65 a plump one.", "", 0.45, [0.3, 0.65, 0.01];
        round: "Roundness of the corners", "Softens the three corners; 0 leaves a clear triangle, and 1 is almost a disk.", "", 0.5, [0.0, 1.0, 0.05];
    }
    BLOCK {
        height: "Height over width", "Size from the ground to the top; 1 makes the block as high as wide.", "", 0.7, [0.2, 1.0, 0.05];
        depth: "Depth over width", "Size from front to back; 1 makes the block as deep as wide.", "", 0.8, [0.2, 1.0, 0.05];
        round: "Roundness of edges", "Radius of the edges over half of the shortest side; at 1 narrow sides are half circles.", "", 0.25, [0.05, 1.0, 0.05];
    }
    BOWL {
        depth: "Depth inside over width", "Depth from the lip to the floor inside; 0.2 is a flat dish, and 0.5 a deep bowl.", "", 0.34, [0.2, 0.5, 0.01];
        full: "How full", "Raises the content; 0 ends a fifth of the depth below the lip, and 1 heaps it above the lip.", "", 0.7, [0.0, 1.0, 0.05];
    }
    OPEN_BOX {
        depth: "Depth over width", "Size from front to back; 1 makes the box square seen from above.", "", 0.75, [0.4, 1.0, 0.05];
        height: "Height of the sides over width", "Height of the boards around the box; the content rises with them.", "", 0.3, [0.15, 0.6, 0.01];
        full: "How full", "Raises the level content; 0 fills two fifths of the inside, and 1 reaches the rim.", "", 0.7, [0.0, 1.0, 0.05];
    }
}
