//! Middle lines of the strokes of the capital letters: y from 0 at the foot to 1 at the top, x from 0 to the right.

use glam::DVec2;

/// A part of a stroke.
#[derive(Clone, Copy)]
enum StrokePart {
    /// Starts the stroke at this point, or continues it straight to the point.
    To(f64, f64),
    /// Continues along an arc of an ellipse: middle, half axes, and the angles at its ends in degrees,
    /// counter-clockwise from x.
    Arc([f64; 2], [f64; 2], [f64; 2]),
}

use StrokePart::{Arc, To};

type Glyph = &'static [&'static [StrokePart]];

/// Straight pieces in a whole turn.
const PIECES: f64 = 96.0;

const GLYPHS: [Glyph; 26] = [
    // A
    &[
        &[To(0.0, 0.0), To(0.41, 1.0)],
        &[To(0.82, 0.0), To(0.41, 1.0)],
        &[To(0.1148, 0.28), To(0.7052, 0.28)],
    ],
    // B
    &[
        &[To(0.0, 0.0), To(0.0, 1.0)],
        &[
            To(0.0, 1.0),
            To(0.28, 1.0),
            Arc([0.28, 0.76], [0.26, 0.24], [90.0, -90.0]),
            To(0.0, 0.52),
        ],
        &[
            To(0.28, 0.52),
            Arc([0.32, 0.26], [0.28, 0.26], [90.0, -90.0]),
            To(0.0, 0.0),
        ],
    ],
    // C
    &[&[Arc([0.43, 0.5], [0.43, 0.5], [48.0, 312.0])]],
    // D
    &[
        &[To(0.0, 0.0), To(0.0, 1.0)],
        &[
            To(0.0, 1.0),
            To(0.26, 1.0),
            Arc([0.26, 0.5], [0.46, 0.5], [90.0, -90.0]),
            To(0.0, 0.0),
        ],
    ],
    // E
    &[
        &[To(0.0, 0.0), To(0.0, 1.0)],
        &[To(0.0, 1.0), To(0.56, 1.0)],
        &[To(0.0, 0.51), To(0.48, 0.51)],
        &[To(0.0, 0.0), To(0.56, 0.0)],
    ],
    // F
    &[
        &[To(0.0, 0.0), To(0.0, 1.0)],
        &[To(0.0, 1.0), To(0.56, 1.0)],
        &[To(0.0, 0.5), To(0.46, 0.5)],
    ],
    // G
    &[
        &[Arc([0.43, 0.5], [0.43, 0.5], [48.0, 352.0])],
        &[To(0.856, 0.43), To(0.52, 0.43)],
    ],
    // H
    &[
        &[To(0.0, 0.0), To(0.0, 1.0)],
        &[To(0.66, 0.0), To(0.66, 1.0)],
        &[To(0.0, 0.5), To(0.66, 0.5)],
    ],
    // I
    &[
        &[To(0.2, 0.0), To(0.2, 1.0)],
        &[To(0.0, 1.0), To(0.4, 1.0)],
        &[To(0.0, 0.0), To(0.4, 0.0)],
    ],
    // J
    &[&[
        To(0.52, 1.0),
        To(0.52, 0.26),
        Arc([0.26, 0.26], [0.26, 0.26], [0.0, -180.0]),
    ]],
    // K
    &[
        &[To(0.0, 0.0), To(0.0, 1.0)],
        &[To(0.6, 1.0), To(0.0, 0.4)],
        &[To(0.2, 0.6), To(0.64, 0.0)],
    ],
    // L
    &[
        &[To(0.0, 0.0), To(0.0, 1.0)],
        &[To(0.0, 0.0), To(0.56, 0.0)],
    ],
    // M
    &[
        &[To(0.0, 0.0), To(0.0, 1.0)],
        &[To(0.0, 1.0), To(0.43, 0.28)],
        &[To(0.86, 1.0), To(0.43, 0.28)],
        &[To(0.86, 0.0), To(0.86, 1.0)],
    ],
    // N
    &[
        &[To(0.0, 0.0), To(0.0, 1.0)],
        &[To(0.0, 1.0), To(0.7, 0.0)],
        &[To(0.7, 0.0), To(0.7, 1.0)],
    ],
    // O
    &[&[Arc([0.44, 0.5], [0.44, 0.5], [0.0, 360.0])]],
    // P
    &[
        &[To(0.0, 0.0), To(0.0, 1.0)],
        &[
            To(0.0, 1.0),
            To(0.3, 1.0),
            Arc([0.3, 0.73], [0.28, 0.27], [90.0, -90.0]),
            To(0.0, 0.46),
        ],
    ],
    // Q
    &[
        &[Arc([0.44, 0.5], [0.44, 0.5], [0.0, 360.0])],
        &[To(0.58, 0.27), To(0.86, 0.0)],
    ],
    // R
    &[
        &[To(0.0, 0.0), To(0.0, 1.0)],
        &[
            To(0.0, 1.0),
            To(0.3, 1.0),
            Arc([0.3, 0.74], [0.28, 0.26], [90.0, -90.0]),
            To(0.0, 0.48),
        ],
        &[To(0.3, 0.48), To(0.62, 0.0)],
    ],
    // S
    &[&[
        Arc([0.33, 0.75], [0.31, 0.25], [35.0, 270.0]),
        Arc([0.33, 0.25], [0.33, 0.25], [90.0, -145.0]),
    ]],
    // T
    &[
        &[To(0.35, 0.0), To(0.35, 1.0)],
        &[To(0.0, 1.0), To(0.7, 1.0)],
    ],
    // U
    &[&[
        To(0.0, 1.0),
        To(0.0, 0.34),
        Arc([0.34, 0.34], [0.34, 0.34], [180.0, 360.0]),
        To(0.68, 1.0),
    ]],
    // V
    &[
        &[To(0.0, 1.0), To(0.37, 0.0)],
        &[To(0.74, 1.0), To(0.37, 0.0)],
    ],
    // W
    &[
        &[To(0.0, 1.0), To(0.26, 0.0)],
        &[To(0.52, 0.86), To(0.26, 0.0)],
        &[To(0.52, 0.86), To(0.78, 0.0)],
        &[To(1.04, 1.0), To(0.78, 0.0)],
    ],
    // X
    &[
        &[To(0.0, 0.0), To(0.68, 1.0)],
        &[To(0.0, 1.0), To(0.68, 0.0)],
    ],
    // Y
    &[
        &[To(0.0, 1.0), To(0.36, 0.48)],
        &[To(0.72, 1.0), To(0.36, 0.48)],
        &[To(0.36, 0.48), To(0.36, 0.0)],
    ],
    // Z
    &[
        &[To(0.0, 1.0), To(0.64, 1.0)],
        &[To(0.64, 1.0), To(0.0, 0.0)],
        &[To(0.0, 0.0), To(0.64, 0.0)],
    ],
];

/// The strokes of a letter (A is 0) as polylines with gentle bends.
pub(super) fn strokes(letter: usize) -> Vec<Vec<DVec2>> {
    let line = |parts: &&[StrokePart]| {
        let mut line: Vec<DVec2> = Vec::new();
        for part in *parts {
            match *part {
                To(x, y) => line.push(DVec2::new(x, y)),
                Arc(middle, half, [from, to]) => {
                    let count = ((to - from).abs() / 360.0 * PIECES).ceil();
                    for k in 0..=count as usize {
                        let angle = (from + (to - from) * k as f64 / count).to_radians();
                        let (x, y) = (half[0] * libm::cos(angle), half[1] * libm::sin(angle));
                        let p = DVec2::new(middle[0] + x, middle[1] + y);
                        if line.last().is_none_or(|&last| (last - p).length() > 1e-9) {
                            line.push(p);
                        }
                    }
                }
            }
        }
        line
    };
    GLYPHS[letter.min(25)].iter().map(line).collect()
}
