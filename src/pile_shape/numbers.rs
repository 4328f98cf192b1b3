//! The numbers of each shape.

use crate::shapes::ShapeNumber;
use crate::shapes::numbers::numbers;

numbers! {
    HEAP {
        height: "Height over width", "One of the numbers that the shape is made by.", "", 0.29, [0.1, 0.5, 0.01];
        round: "Roundness of the peak", "One of the numbers that the shape is made by.", "", 0.86, [0.3, 1.0, 0.02];
        depth: "Depth over width", "One of the numbers that the shape is made by.", "", 1.0, [0.5, 1.0, 0.05];
    }
    DOME {
        height: "Height over width", "One of the numbers that the shape is made by.", "", 0.5, [0.15, 0.8, 0.01];
        depth: "Depth over width", "One of the numbers that the shape is made by.", "", 1.0, [0.5, 1.0, 0.05];
    }
    RICE_BALL {
        thick: "Thickness over width", "One of the numbers that the shape is made by.", "", 0.45, [0.3, 0.65, 0.01];
        round: "Roundness of the corners", "One of the numbers that the shape is made by.", "", 0.5, [0.0, 1.0, 0.05];
    }
    BLOCK {
        height: "Height over width", "One of the numbers that the shape is made by.", "", 0.7, [0.2, 1.0, 0.05];
        depth: "Depth over width", "One of the numbers that the shape is made by.", "", 0.8, [0.2, 1.0, 0.05];
        round: "Roundness of edges", "One of the numbers that the shape is made by.", "", 0.25, [0.05, 1.0, 0.05];
    }
    BOWL {
        depth: "Depth inside over width", "One of the numbers that the shape is made by.", "", 0.34, [0.2, 0.5, 0.01];
        full: "How full", "One of the numbers that the shape is made by.", "", 0.7, [0.0, 1.0, 0.05];
    }
    OPEN_BOX {
        depth: "Depth over width", "One of the numbers that the shape is made by.", "", 0.75, [0.4, 1.0, 0.05];
        height: "Height of the sides over width", "One of the numbers that the shape is made by.", "", 0.3, [0.15, 0.6, 0.01];
        full: "How full", "One of the numbers that the shape is made by.", "", 0.7, [0.0, 1.0, 0.05];
    }
}
