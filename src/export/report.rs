//! The report of a run, for report.json.

use super::json::{list, text};
use crate::decimal;
use crate::notice::Notice;

/// The time one stage took.
#[derive(Clone, Debug, PartialEq)]
pub struct StageTime {
    /// The stage's word.
    pub stage: &'static str,
    /// Milliseconds of work by the caller's clock.
    pub ms: f64,
}

/// The figures of one run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// The recipe's link, without '#'; empty for the default.
    pub link: String,
    /// Pixels along the picture's side.
    pub size: usize,
    /// Cells in the pavement.
    pub cells: usize,
    /// Steps of the packing.
    pub steps: u32,
    /// Whether forces and moves became small before the packing's last step.
    pub converged: bool,
    /// The greatest move of the last step, in cell sizes.
    pub largest_move: f64,
    /// Cells that the population control has added.
    pub added: u32,
    /// Cells that the population control has removed.
    pub removed: u32,
    /// Potential energy after the last step.
    pub energy: f64,
    /// Time by stage, in the stages' order.
    pub milliseconds: Vec<StageTime>,
    /// The heights shown as 0 and as 65535 in height.png, in picture units.
    pub height_range: (f32, f32),
    /// The result of [`super::metrics_json`], or the measures of masonry, as JSON.
    pub metrics: Option<String>,
    /// Notices of values that were clamped, dropped or given up.
    pub notices: Vec<Notice>,
    /// Digest of the planes, in hex.
    pub hash: String,
    /// Hash of the still from the requested camera, in hex, if there was one.
    pub frame: Option<String>,
}

/// A JSON number, null if it is not finite. `json::number` is faster, but would bring the standard library's code for
/// numbers into the WebAssembly.
fn number(x: f64) -> String {
    if x.is_finite() {
        decimal::text(x)
    } else {
        "null".to_owned()
    }
}

impl Report {
    /// The report as a JSON object.
    pub fn json(&self) -> String {
        let times = self
            .milliseconds
            .iter()
            .map(|t| format!("{}:{}", text(t.stage), number(decimal::round_to(3, t.ms))));
        let times: Vec<String> = times.collect();
        let (low, high) = self.height_range;
        let mut fields = vec![
            ("link", text(&self.link)),
            ("size", self.size.to_string()),
            ("cells", self.cells.to_string()),
            ("steps", self.steps.to_string()),
            ("converged", self.converged.to_string()),
            ("largest_move", number(self.largest_move)),
            ("added", self.added.to_string()),
            ("removed", self.removed.to_string()),
            ("energy", number(self.energy)),
            ("milliseconds", format!("{{{}}}", times.join(","))),
            (
                "height_range",
                list([low, high].into_iter().map(|h| number(h.into()))),
            ),
            (
                "notices",
                list(self.notices.iter().map(|n| text(&n.to_string()))),
            ),
            ("hash", text(&self.hash)),
        ];
        fields.extend(self.frame.as_deref().map(|frame| ("frame", text(frame))));
        fields.extend(self.metrics.clone().map(|metrics| ("metrics", metrics)));
        let lines: Vec<String> = fields
            .iter()
            .map(|(key, value)| format!("  {}: {value}", text(key)))
            .collect();
        format!("{{\n{}\n}}\n", lines.join(",\n"))
    }
}

// Without the feature house, serde_json is a dependency of native builds only.
#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;
    use crate::notice::Code;

    #[test]
    fn a_report_is_json() {
        let report = Report {
            notices: vec![Notice::new(Code::NotAParameter).with("given", "\"big\"".to_owned())],
            milliseconds: vec![StageTime {
                stage: "packing",
                ms: 1.23456,
            }],
            metrics: Some("{\"mesh\":{}}".into()),
            ..Report::default()
        };
        let value: serde_json::Value = serde_json::from_str(&report.json()).unwrap();
        assert_eq!(value["milliseconds"]["packing"], 1.235);
        assert!(value["metrics"]["mesh"].is_object());
        assert_eq!(
            value["notices"][0],
            "\"big\" is not a parameter; it was dropped."
        );
    }
}
