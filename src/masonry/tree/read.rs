//! Reads pattern trees from JSON, and checks them.

use super::fault::{TreeError, TreeFault};
use super::generator::{GeneratorNode, Parameter, PatternGenerator, StoneRow};
use super::node::{CornerPattern, PatternNode, PatternTree, joined};
use super::{MOST_DEPTH, MOST_NODES};
use crate::building::Heading;
use serde_json::{Map, Value};

type Checked<T> = Result<T, TreeError>;

impl PatternTree {
    /// Reads a tree from JSON.
    ///
    /// # Errors
    /// The first fault.
    pub fn read(text: &str) -> Result<Self, TreeError> {
        let value: Value = serde_json::from_str(text).map_err(|why| TreeError {
            path: String::new(),
            fault: TreeFault::NotJson {
                line: why.line(),
                column: why.column(),
            },
        })?;
        let mut reader = TreeReader { nodes: 0 };
        let root = reader.node(&value, "", 1)?;
        Ok(Self { root })
    }
}

/// The keys for the children of `ByLabel` and `ByCorner`.
const LABELLED: [&str; 2] = ["cases", "else"];

struct TreeReader {
    /// The nodes read so far.
    nodes: usize,
}

impl TreeReader {
    fn node(&mut self, value: &Value, path: &str, depth: usize) -> Checked<PatternNode> {
        self.nodes += 1;
        if depth > MOST_DEPTH {
            return Err(fault(path, TreeFault::TooDeep));
        }
        if self.nodes > MOST_NODES {
            return Err(fault(path, TreeFault::TooMany));
        }
        let object = object(value, path)?;
        let word = object
            .get("type")
            .ok_or_else(|| fault(path, TreeFault::NoType))?;
        let word = text(word, &joined(path, "type"))?;
        let at = (path, depth);
        match word {
            "None" => only(object, path, &[]).map(|()| PatternNode::Nothing),
            "ByLabel" => self.by_label(object, at),
            "ByFeature" => {
                let [corner, edge, face] =
                    self.parts(object, at, ["corner", "edge", "face"], &[])?;
                Ok(PatternNode::ByFeature { corner, edge, face })
            }
            "ByCorner" => self.by_corner(object, at),
            "Orientation" => self.orientation(object, at),
            "AnalyzeWindow" => {
                let [bottom, top, side] = self.parts(object, at, ["bottom", "top", "side"], &[])?;
                Ok(PatternNode::AnalyzeWindow { bottom, top, side })
            }
            "Seq" => self.seq(object, at),
            word => match PatternGenerator::of_word(word) {
                Some(generator) => generator_node(generator, object, path).map(PatternNode::Lay),
                None => Err(fault(
                    path,
                    TreeFault::UnknownNode {
                        word: word.to_owned(),
                    },
                )),
            },
        }
    }

    /// The child under a key, or [`PatternNode::Nothing`] if the key is missing.
    fn child(
        &mut self,
        object: &Map<String, Value>,
        key: &str,
        (path, depth): (&str, usize),
    ) -> Checked<PatternNode> {
        match object.get(key) {
            Some(value) => self.node(value, &joined(path, key), depth + 1),
            None => Ok(PatternNode::Nothing),
        }
    }

    /// The children under `keys` of a node. It is a fault if the node has other keys than these and
    /// `more`.
    fn parts<const N: usize>(
        &mut self,
        object: &Map<String, Value>,
        at: (&str, usize),
        keys: [&str; N],
        more: &[&str],
    ) -> Checked<[Box<PatternNode>; N]> {
        only(object, at.0, &[&keys[..], more].concat())?;
        let mut parts = [(); N].map(|()| Box::new(PatternNode::Nothing));
        for (part, key) in parts.iter_mut().zip(keys) {
            **part = self.child(object, key, at)?;
        }
        Ok(parts)
    }

    fn by_label(&mut self, map: &Map<String, Value>, at: (&str, usize)) -> Checked<PatternNode> {
        let (path, depth) = at;
        only(map, path, &LABELLED)?;
        let within = joined(path, "cases");
        let empty = Map::new();
        let list = map
            .get("cases")
            .map_or(Ok(&empty), |value| object(value, &within))?;
        let mut cases = Vec::new();
        for (label, value) in list {
            if label.trim().is_empty() {
                return Err(fault(&within, TreeFault::EmptyLabel));
            }
            cases.push((
                label.clone(),
                self.node(value, &joined(&within, label), depth + 1)?,
            ));
        }
        cases.sort_by(|a, b| a.0.cmp(&b.0));
        let otherwise = Box::new(self.child(map, "else", at)?);
        Ok(PatternNode::ByLabel { cases, otherwise })
    }

    fn by_corner(&mut self, map: &Map<String, Value>, at: (&str, usize)) -> Checked<PatternNode> {
        let (path, depth) = at;
        only(map, path, &LABELLED)?;
        let within = joined(path, "cases");
        let list = map
            .get("cases")
            .map_or(Ok(&[][..]), |value| array(value, &within))?;
        let mut cases = Vec::new();
        for (k, value) in list.iter().enumerate() {
            let path = joined(&within, &k.to_string());
            let object = object(value, &path)?;
            let pattern = corner_pattern(object, &path)?;
            let node = self.child(object, "node", (&path, depth))?;
            cases.push((pattern, node));
        }
        let otherwise = Box::new(self.child(map, "else", at)?);
        Ok(PatternNode::ByCorner { cases, otherwise })
    }

    fn orientation(&mut self, map: &Map<String, Value>, at: (&str, usize)) -> Checked<PatternNode> {
        const WORDS: &[&str] = &["horizontal", "vertical"];
        let [horizontal, vertical] =
            self.parts(map, at, ["horizontal", "vertical"], &["corners"])?;
        let path = joined(at.0, "corners");
        let corners = map
            .get("corners")
            .map_or(Ok("vertical"), |value| word(value, &path, WORDS))?;
        Ok(PatternNode::Orientation {
            horizontal,
            vertical,
            are_corners_horizontal: corners == "horizontal",
        })
    }

    fn seq(
        &mut self,
        map: &Map<String, Value>,
        (path, depth): (&str, usize),
    ) -> Checked<PatternNode> {
        only(map, path, &["children"])?;
        let within = joined(path, "children");
        let list = map
            .get("children")
            .map_or(Ok(&[][..]), |value| array(value, &within))?;
        let nodes = list.iter().enumerate();
        let nodes =
            nodes.map(|(k, value)| self.node(value, &joined(&within, &k.to_string()), depth + 1));
        nodes.collect::<Checked<_>>().map(PatternNode::Seq)
    }
}

fn corner_pattern(map: &Map<String, Value>, path: &str) -> Checked<CornerPattern> {
    only(
        map,
        path,
        &[
            "convex",
            "concave",
            "single_convex",
            "single_concave",
            "node",
        ],
    )?;
    const COUNT: Parameter = Parameter {
        key: "",
        range: [0.0, 16.0],
        default: 0.0,
        is_whole: true,
    };
    let count = |key: &str| -> Checked<Option<usize>> {
        let value = map
            .get(key)
            .map(|value| number(value, &joined(path, key), &COUNT));
        Ok(value.transpose()?.map(|count| count as usize))
    };
    let heading = |key: &str| -> Checked<Option<Heading>> {
        let value = map
            .get(key)
            .map(|value| word(value, &joined(path, key), &HEADINGS));
        let at = |word: &str| HEADINGS.iter().position(|&known| known == word);
        Ok(value
            .transpose()?
            .and_then(at)
            .map(|at| [Heading::Up, Heading::Down, Heading::Level][at]))
    };
    Ok(CornerPattern {
        convex: count("convex")?,
        concave: count("concave")?,
        single_convex: heading("single_convex")?,
        single_concave: heading("single_concave")?,
    })
}

/// The words of the directions of edges in JSON, in the order of [`Heading`].
pub(super) const HEADINGS: [&str; 3] = ["up", "down", "level"];

fn generator_node(
    generator: PatternGenerator,
    map: &Map<String, Value>,
    path: &str,
) -> Checked<GeneratorNode> {
    let mut node = GeneratorNode::new(generator);
    for (key, value) in map.iter().filter(|(key, _)| *key != "type") {
        let within = joined(path, key);
        if key == "rows" && generator.has_rows() {
            node.rows = rows(value, &within)?;
            continue;
        }
        let parameters = generator.parameters();
        let at = parameters.iter().position(|parameter| parameter.key == key);
        let at = at.ok_or_else(|| fault(path, TreeFault::UnknownParameter { key: key.clone() }))?;
        node.numbers[at] = number(value, &within, &parameters[at])?;
    }
    Ok(node)
}

/// Rows of stones, each as an array of length, width and extrusion.
fn rows(value: &Value, path: &str) -> Checked<Vec<StoneRow>> {
    let list = array(value, path)?;
    in_range(list.len() as f64, [1.0, StoneRow::MOST as f64], path)?;
    let row = |(k, value): (usize, &Value)| {
        let path = joined(path, &k.to_string());
        let numbers = array(value, &path)?;
        in_range(numbers.len() as f64, [3.0; 2], &path)?;
        let mut found = [0.0; 3];
        for (n, range) in StoneRow::RANGES.into_iter().enumerate() {
            let parameter = Parameter {
                key: "",
                range,
                default: 0.0,
                is_whole: false,
            };
            found[n] = number(&numbers[n], &joined(&path, &n.to_string()), &parameter)?;
        }
        let [length, width, extrude] = found;
        Ok(StoneRow {
            length,
            width,
            extrude,
        })
    };
    list.iter().enumerate().map(row).collect()
}

fn fault(path: &str, fault: TreeFault) -> TreeError {
    TreeError {
        path: path.to_owned(),
        fault,
    }
}

fn not_a(path: &str, wanted: &'static str) -> TreeError {
    fault(path, TreeFault::NotA { wanted })
}

/// Refuses keys other than `type` and those given.
fn only(object: &Map<String, Value>, path: &str, keys: &[&str]) -> Checked<()> {
    let mut others = object
        .keys()
        .filter(|key| *key != "type" && !keys.contains(&key.as_str()));
    match others.next() {
        Some(key) => Err(fault(
            path,
            TreeFault::UnknownParameter { key: key.clone() },
        )),
        None => Ok(()),
    }
}

fn object<'a>(value: &'a Value, path: &str) -> Checked<&'a Map<String, Value>> {
    value.as_object().ok_or_else(|| not_a(path, "object"))
}

fn array<'a>(value: &'a Value, path: &str) -> Checked<&'a [Value]> {
    value
        .as_array()
        .map(Vec::as_slice)
        .ok_or_else(|| not_a(path, "array"))
}

fn text<'a>(value: &'a Value, path: &str) -> Checked<&'a str> {
    value.as_str().ok_or_else(|| not_a(path, "text"))
}

fn word<'a>(value: &'a Value, path: &str, allowed: &'static [&'static str]) -> Checked<&'a str> {
    let word = text(value, path)?;
    let known = allowed.contains(&word);
    known.then_some(word).ok_or_else(|| {
        fault(
            path,
            TreeFault::UnknownWord {
                word: word.to_owned(),
                allowed,
            },
        )
    })
}

fn number(value: &Value, path: &str, parameter: &Parameter) -> Checked<f64> {
    let number = value.as_f64().ok_or_else(|| not_a(path, "number"))?;
    if parameter.is_whole && number.fract() != 0.0 {
        return Err(not_a(path, "whole number"));
    }
    in_range(number, parameter.range, path).map(|()| number)
}

fn in_range(number: f64, [least, most]: [f64; 2], path: &str) -> Checked<()> {
    let is_in = (least..=most).contains(&number);
    is_in
        .then_some(())
        .ok_or_else(|| fault(path, TreeFault::OutOfRange { least, most }))
}
