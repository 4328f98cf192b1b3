//! Pattern trees by name.

use super::node::PatternTree;

/// A tree with a name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TreePreset {
    /// Its word in links.
    pub word: &'static str,
    /// Its name in English.
    pub name: &'static str,
    /// The tree as JSON.
    pub json: &'static str,
}

impl TreePreset {
    /// The preset with this word.
    pub fn of_word(word: &str) -> Option<&'static Self> {
        PRESETS.iter().find(|preset| preset.word == word)
    }

    /// The tree.
    ///
    /// # Panics
    /// Never for those of [`PRESETS`].
    pub fn tree(&self) -> PatternTree {
        PatternTree::read(self.json).expect("a preset is a tree")
    }
}

/// All presets. The first three have the names of Legakis, Dorsey, Gortler (2001), fig. 4. Their structure follows
/// sections 4.1, 5.2 and 5.5.
pub static PRESETS: [TreePreset; 7] = [
    TreePreset {
        word: "rgb",
        name: "RGB Blocks",
        json: r#"{
  "type": "ByLabel",
  "cases": {"Glass": {"type": "None"}},
  "else": {
    "type": "ByFeature",
    "corner": {"type": "RGBBlocks", "tag": 0},
    "edge": {"type": "RGBBlocks", "tag": 1},
    "face": {"type": "RGBBlocks", "tag": 2}
  }
}"#,
    },
    TreePreset {
        word: "bricks",
        name: "Bricks",
        json: r#"{
  "type": "ByLabel",
  "cases": {
    "Arch": {"type": "ByFeature", "corner": {"type": "None"}, "edge": {"type": "ArchBricks"}, "face": {"type": "Bricks"}},
    "Door": {
      "type": "ByFeature",
      "corner": {
        "type": "AnalyzeWindow",
        "bottom": {"type": "Bricks"},
        "top": {"type": "None"},
        "side": {"type": "Bricks"}
      },
      "edge": {
        "type": "AnalyzeWindow",
        "bottom": {"type": "Bricks"},
        "top": {"type": "ArchStones", "rows": [[0.25, 0.0625, 0]]},
        "side": {"type": "Bricks"}
      },
      "face": {"type": "Bricks"}
    },
    "Glass": {"type": "None"},
    "Roof": {
      "type": "ByFeature",
      "corner": {"type": "None"},
      "edge": {"type": "Seq", "children": [{"type": "Raking", "extrude": 0}, {"type": "Tiles"}]},
      "face": {"type": "Tiles"}
    },
    "Window": {
      "type": "ByFeature",
      "corner": {
        "type": "AnalyzeWindow",
        "bottom": {"type": "WindowBottomBricks"},
        "top": {"type": "None"},
        "side": {"type": "Bricks"}
      },
      "edge": {
        "type": "AnalyzeWindow",
        "bottom": {"type": "WindowBottomBricks"},
        "top": {"type": "ArchStones", "rows": [[0.25, 0.0625, 0]]},
        "side": {"type": "Bricks"}
      },
      "face": {"type": "Bricks"}
    }
  },
  "else": {"type": "Bricks"}
}"#,
    },
    TreePreset {
        word: "ashlar",
        name: "Random Ashlar",
        json: r#"{
  "type": "ByLabel",
  "cases": {
    "Arch": {
      "type": "ByFeature",
      "corner": {"type": "None"},
      "edge": {"type": "ArchStones", "rows": [[0.3, 0.22, 0], [0.1, 0.3, 0.05]], "quoin": 3},
      "face": {"type": "RandomAshlar"}
    },
    "Door": {
      "type": "ByFeature",
      "corner": {
        "type": "AnalyzeWindow",
        "bottom": {"type": "RandomAshlar"},
        "top": {"type": "None"},
        "side": {"type": "RandomAshlar"}
      },
      "edge": {
        "type": "AnalyzeWindow",
        "bottom": {"type": "RandomAshlar"},
        "top": {"type": "ArchStones", "rows": [[0.25, 0.25, 0.02]], "quoin": 3},
        "side": {"type": "RandomAshlar"}
      },
      "face": {"type": "RandomAshlar"}
    },
    "Glass": {"type": "None"},
    "Roof": {
      "type": "ByFeature",
      "corner": {"type": "None"},
      "edge": {"type": "Tiles"},
      "face": {"type": "Tiles", "length": 0.34, "width": 0.24}
    },
    "Window": {
      "type": "ByFeature",
      "corner": {"type": "None"},
      "edge": {"type": "ArchStones", "rows": [[0.25, 0.25, 0.02]], "quoin": 3},
      "face": {"type": "RandomAshlar"}
    }
  },
  "else": {"type": "RandomAshlar"}
}"#,
    },
    TreePreset {
        word: "quoins",
        name: "Bricks with stone quoins",
        json: r#"{
  "type": "ByLabel",
  "cases": {
    "Arch": {
      "type": "ByFeature",
      "corner": {"type": "None"},
      "edge": {"type": "ArchStones", "rows": [[0.25, 0.2, 0]], "keystone": 0.08, "tag": 1},
      "face": {"type": "Bricks"}
    },
    "Door": {
      "type": "ByFeature",
      "corner": {
        "type": "AnalyzeWindow",
        "bottom": {"type": "Quoins", "extrude": 0.012, "tag": 1},
        "top": {"type": "None"},
        "side": {"type": "Quoins", "extrude": 0.012, "tag": 1}
      },
      "edge": {
        "type": "AnalyzeWindow",
        "bottom": {"type": "Seq", "children": [{"type": "Bricks"}, {"type": "Coping", "tag": 1}]},
        "top": {"type": "ArchStones", "rows": [[0.25, 0.2, 0]], "keystone": 0.08, "tag": 1},
        "side": {"type": "Quoins", "extrude": 0.012, "tag": 1}
      },
      "face": {"type": "Bricks"}
    },
    "Glass": {"type": "None"},
    "Roof": {
      "type": "ByFeature",
      "corner": {"type": "None"},
      "edge": {"type": "Seq", "children": [{"type": "Raking", "extrude": 0.015}, {"type": "Tiles"}]},
      "face": {"type": "Tiles"}
    },
    "Window": {
      "type": "ByFeature",
      "corner": {"type": "None"},
      "edge": {
        "type": "AnalyzeWindow",
        "bottom": {"type": "WindowBottomBricks"},
        "top": {"type": "ArchStones", "rows": [[0.25, 0.2, 0]], "keystone": 0.08, "tag": 1},
        "side": {"type": "Bricks"}
      },
      "face": {"type": "Bricks"}
    }
  },
  "else": {
    "type": "ByFeature",
    "corner": {"type": "Quoins", "extrude": 0.012, "tag": 1},
    "edge": {
      "type": "Orientation",
      "horizontal": {"type": "Seq", "children": [{"type": "Bricks"}, {"type": "Coping", "tag": 1}]},
      "vertical": {"type": "Quoins", "extrude": 0.012, "tag": 1}
    },
    "face": {"type": "Bricks"}
  }
}"#,
    },
    TreePreset {
        word: "diagonal",
        name: "Steps with diagonal bricks",
        json: include_str!("diagonal.json"),
    },
    TreePreset {
        word: "coped",
        name: "Bricks with a coping",
        json: r#"{
  "type": "ByLabel",
  "cases": {
    "Arch": {"type": "ByFeature", "corner": {"type": "None"}, "edge": {"type": "ArchBricks"}, "face": {"type": "Bricks"}},
    "Door": {
      "type": "ByFeature",
      "corner": {
        "type": "AnalyzeWindow",
        "bottom": {"type": "Bricks"},
        "top": {"type": "None"},
        "side": {"type": "Bricks"}
      },
      "edge": {
        "type": "AnalyzeWindow",
        "bottom": {"type": "Seq", "children": [{"type": "Bricks"}, {"type": "Coping", "tag": 1}]},
        "top": {"type": "ArchStones", "rows": [[0.25, 0.2, 0]], "keystone": 0.08, "tag": 1},
        "side": {"type": "Seq", "children": [{"type": "Bricks"}, {"type": "Coping", "tag": 1}]}
      },
      "face": {"type": "Bricks"}
    },
    "Glass": {"type": "None"},
    "Roof": {
      "type": "ByFeature",
      "corner": {"type": "None"},
      "edge": {"type": "Seq", "children": [{"type": "Raking", "extrude": 0.015}, {"type": "Tiles"}]},
      "face": {"type": "Tiles"}
    },
    "Window": {
      "type": "ByFeature",
      "corner": {
        "type": "AnalyzeWindow",
        "bottom": {"type": "WindowBottomBricks"},
        "top": {"type": "None"},
        "side": {"type": "Bricks"}
      },
      "edge": {
        "type": "AnalyzeWindow",
        "bottom": {"type": "WindowBottomBricks"},
        "top": {"type": "ArchStones", "rows": [[0.25, 0.2, 0]], "keystone": 0.08, "tag": 1},
        "side": {"type": "Bricks"}
      },
      "face": {"type": "Bricks"}
    }
  },
  "else": {
    "type": "ByFeature",
    "corner": {"type": "Bricks"},
    "edge": {"type": "Seq", "children": [{"type": "Bricks"}, {"type": "Coping", "tag": 1}]},
    "face": {"type": "Bricks"}
  }
}"#,
    },
    TreePreset {
        word: "cement",
        name: "Steps with cement stones",
        json: include_str!("cement.json"),
    },
];
