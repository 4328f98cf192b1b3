//! The numbers of each shape.

use crate::shapes::ShapeNumber;
use crate::shapes::numbers::numbers;

numbers! {
    HEAP {
        height: "Height over width", "", 0.29, [0.1, 0.5, 0.01];
        round: "Roundness of the peak", "", 0.86, [0.3, 1.0, 0.02];
        depth: "Depth over width", "", 1.0, [0.5, 1.0, 0.05];
    }
    DOME {
        height: "Height over width", "", 0.5, [0.15, 0.8, 0.01];
        depth: "Depth over width", "", 1.0, [0.5, 1.0, 0.05];
    }
    RICE_BALL {
        thick: "Thickness over width", "", 0.45, [0.3, 0.65, 0.01];
        round: "Roundness of the corners", "", 0.5, [0.0, 1.0, 0.05];
    }
    BLOCK {
        height: "Height over width", "", 0.7, [0.2, 1.0, 0.05];
        depth: "Depth over width", "", 0.8, [0.2, 1.0, 0.05];
        round: "Roundness of edges", "", 0.25, [0.05, 1.0, 0.05];
    }
    BOWL {
        depth: "Depth inside over width", "", 0.34, [0.2, 0.5, 0.01];
        full: "How full", "", 0.7, [0.0, 1.0, 0.05];
    }
    OPEN_BOX {
        depth: "Depth over width", "", 0.75, [0.4, 1.0, 0.05];
        height: "Height of the sides over width", "", 0.3, [0.15, 0.6, 0.01];
        full: "How full", "", 0.7, [0.0, 1.0, 0.05];
    }
}
