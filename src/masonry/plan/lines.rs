//! Grid lines: columns of a face, and course lines that connected walls share.
//!
//! Legakis, Dorsey, Gortler (2001), section 5.1: the corners of a face give lines, and each interval between two lines
//! is cut into pieces as near as possible to the wanted size. Here course lines belong to all walls of a building
//! together, so bed joints meet around every corner.

use crate::order;

/// Lines nearer to each other than this count as one (metres).
const WELD: f64 = 1e-4;
/// Added to numbers of pieces before they are rounded, so that rounding errors never change the count.
const EPSILON: f64 = 1e-6;
/// Two lines nearer than this share of a course are too near.
const NEAR: f64 = 0.3;

/// How many pieces of a size an interval has: `max(1, round(length / size))`. Halves round up, and lengths that differ
/// by floating point noise have the same number.
pub fn pieces(length: f64, size: f64) -> usize {
    ((length / size + 0.5 + EPSILON).floor() as usize).max(1)
}

/// The lines of a grid between sorted fixed lines: `counts` pieces in each interval, all of one width.
pub fn divided(fixed: &[f64], counts: &[usize]) -> Vec<f64> {
    let mut lines: Vec<f64> = fixed.first().copied().into_iter().collect();
    for (ends, &count) in fixed.windows(2).zip(counts) {
        let piece = |k: usize| ends[0] + (ends[1] - ends[0]) * k as f64 / count as f64;
        lines.extend((1..count).map(piece));
        lines.push(ends[1]);
    }
    lines
}

/// Sorted lines without repetitions.
pub fn merged(mut lines: Vec<f64>) -> Vec<f64> {
    order::sort(&mut lines, |&x| (order::rank(x), 0));
    lines.dedup_by(|next, kept| *next - *kept < WELD);
    lines
}

/// A height that courses should meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CourseMark {
    /// The height (metres).
    pub y: f64,
    /// Whether it is the sill, head or springing of an opening: such lines are never dropped.
    pub is_opening: bool,
}

/// A warning about course lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CourseWarning {
    /// Two lines of openings are nearer than 0.3 courses, so a thin course lies between them.
    Near {
        /// The lower line (metres).
        low: f64,
        /// The upper line (metres).
        high: f64,
    },
    /// The courses between two fixed lines are less than 0.8 or more than 1.25 times as high as wanted.
    Stretched {
        /// The lower line (metres).
        low: f64,
        /// The upper line (metres).
        high: f64,
        /// Height of the courses over the wanted height.
        ratio: f64,
    },
}

/// The course lines of a group of connected walls.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Courses {
    /// The heights of bed joints, rising (metres).
    pub lines: Vec<f64>,
    /// The warnings.
    pub warnings: Vec<CourseWarning>,
}

impl Courses {
    /// The lines through the marks, with courses of about this height (metres, above 0) between them. A mark that is
    /// not at an opening is dropped if it is nearer to a line than 0.3 courses. The lowest and the highest such marks
    /// are kept.
    pub fn new(marks: &[CourseMark], height: f64) -> Self {
        let fixed = fixed_lines(marks, height);
        let counts: Vec<usize> = fixed
            .windows(2)
            .map(|w| pieces(w[1] - w[0], height))
            .collect();
        let warnings = fixed.windows(2).zip(&counts).filter_map(|(w, &count)| {
            let (low, high) = (w[0], w[1]);
            let ratio = (high - low) / (count as f64 * height);
            match ratio {
                _ if high - low < NEAR * height => Some(CourseWarning::Near { low, high }),
                0.8..=1.25 => None,
                _ => Some(CourseWarning::Stretched { low, high, ratio }),
            }
        });
        Self {
            warnings: warnings.collect(),
            lines: divided(&fixed, &counts),
        }
    }

    /// The number of the course at a height: course k lies between line k and line k + 1. Heights beyond the ends give
    /// the first or the last course.
    pub fn course(&self, y: f64) -> usize {
        let above = self.lines.partition_point(|&line| line <= y + WELD);
        above
            .saturating_sub(1)
            .min(self.lines.len().saturating_sub(2))
    }
}

/// The heights of all openings, and of those other marks that are not too near to another line.
fn fixed_lines(marks: &[CourseMark], height: f64) -> Vec<f64> {
    let of = |is_opening: bool| {
        let kept = marks
            .iter()
            .filter(move |mark| mark.is_opening == is_opening);
        merged(kept.map(|mark| mark.y).collect())
    };
    let (openings, others) = (of(true), of(false));
    let mut fixed = openings;
    // The lowest and the highest of the other marks are the ends of the walls. They come first, so the rest gives way.
    let ends = [others.first(), others.last()].into_iter().flatten();
    for &y in ends.chain(&others) {
        let is_end = Some(&y) == others.first() || Some(&y) == others.last();
        let least = if is_end { WELD } else { NEAR * height };
        if fixed.iter().all(|line| (line - y).abs() >= least) {
            fixed.push(y);
        }
    }
    merged(fixed)
}

#[cfg(test)]
mod tests {
    use super::*;

    const H: f64 = 1.0 / 12.0;

    fn marks(others: &[f64], openings: &[f64]) -> Vec<CourseMark> {
        let mark = |is_opening: bool| move |&y: &f64| CourseMark { y, is_opening };
        others
            .iter()
            .map(mark(false))
            .chain(openings.iter().map(mark(true)))
            .collect()
    }

    #[test]
    fn noise_does_not_change_the_number_of_pieces() {
        for k in 1..200 {
            for noise in [-1e-12, 0.0, 1e-12] {
                assert_eq!(
                    pieces((f64::from(k) + 0.5) * 0.125 + noise, 0.125),
                    k as usize + 1
                );
                assert_eq!(pieces(f64::from(k) * 0.125 + noise, 0.125), k as usize);
            }
        }
        assert_eq!(pieces(0.001, 0.125), 1);
    }

    #[test]
    fn lines_of_openings_are_never_dropped() {
        let courses = Courses::new(&marks(&[0.0, 3.0, 1.01], &[1.0, 1.02, 2.0]), H);
        for y in [0.0, 3.0, 1.0, 1.02, 2.0] {
            assert!(courses.lines.contains(&y), "{y}");
        }
        assert!(!courses.lines.contains(&1.01));
        assert_eq!(
            courses.warnings,
            [CourseWarning::Near {
                low: 1.0,
                high: 1.02
            }]
        );
        assert!(courses.lines.windows(2).all(|w| w[0] < w[1]));
    }

    #[test]
    fn courses_are_about_as_high_as_wanted_or_told() {
        for step in 0..40 {
            let sill = 0.5 + 0.013 * f64::from(step);
            let courses = Courses::new(&marks(&[0.0, 3.0], &[sill]), H);
            for w in courses.lines.windows(2) {
                let ratio = (w[1] - w[0]) / H;
                assert!((0.8..=1.25).contains(&ratio), "{ratio}");
            }
            assert!(courses.warnings.is_empty());
            let at = courses.course(sill + 0.01);
            assert_eq!(courses.lines[at], sill);
        }
        let tight = Courses::new(&marks(&[0.0, 0.05], &[]), H);
        assert!(
            matches!(tight.warnings[..], [CourseWarning::Stretched { ratio, .. }] if ratio < 0.7)
        );
        assert_eq!(Courses::new(&[], H).course(1.0), 0);
    }
}
