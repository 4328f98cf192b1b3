//! PLY: text, and binary of either byte order.

use super::text::{LineCount, next_word, number, whole, words};
use super::{Reader, add_strip, bad_line, ends, too_large};
use crate::notice::{Code, Notice};
use crate::trimesh::{MOST_TRIANGLES, Soup, polygon};
use glam::DVec3;

/// Numbers that a slice reads.
const NUMBERS: usize = 1 << 17;
/// The longest head that is read, in bytes.
const HEAD: usize = 1 << 16;

/// Whether a file is PLY: it begins with `ply` and white space.
pub(super) fn is_one(bytes: &[u8]) -> bool {
    let [a, b, c, end, ..] = *bytes else {
        return false;
    };
    [a, b, c].eq_ignore_ascii_case(b"ply") && end.is_ascii_whitespace()
}

#[derive(Clone, Copy, PartialEq)]
enum Format {
    Text,
    Little,
    Big,
}

/// The type of a number, with its size in bytes.
#[derive(Clone, Copy)]
enum Scalar {
    Signed(usize),
    Unsigned(usize),
    Float,
    Double,
}

#[derive(Clone, Copy, PartialEq)]
enum Role {
    /// A coordinate along an axis.
    Place(usize),
    Corners,
    Strip,
    None,
}

struct Property {
    /// The type of a list's count; `None` if the property is a single number.
    count: Option<Scalar>,
    item: Scalar,
    role: Role,
}

struct Element {
    count: u64,
    is_vertex: bool,
    properties: Vec<Property>,
}

#[derive(Default)]
pub(super) struct Ply {
    head: Option<Head>,
    at: usize,
    element: usize,
    /// How many items of the element have been read.
    item: u64,
    /// How many properties of the item have been read, and how many numbers are left of a list that a slice began.
    property: usize,
    left: Option<usize>,
    place: [f64; 3],
    list: Vec<u32>,
    spent: usize,
    lines: LineCount,
    has_faces: bool,
}

struct Head {
    format: Format,
    elements: Vec<Element>,
}

impl Reader for Ply {
    fn advance(&mut self, bytes: &[u8], soup: &mut Soup) -> Result<bool, Notice> {
        let Some(head) = self.head.take() else {
            self.head = Some(self.read_head(bytes)?);
            return Ok(false);
        };
        self.spent = 0;
        while self.spent < NUMBERS {
            let Some(element) = head.elements.get(self.element) else {
                if !self.has_faces && !soup.positions.is_empty() {
                    return Err(Notice::new(Code::FilePoints).with("kind", "PLY".to_owned()));
                }
                return Ok(true);
            };
            if self.item == element.count || element.properties.is_empty() {
                (self.element, self.item) = (self.element + 1, 0);
                continue;
            }
            if self.read_item(bytes, head.format, element, soup)? {
                self.item += 1;
            }
        }
        if head.format == Format::Text {
            self.lines.reach(bytes, self.at);
        }
        self.head = Some(head);
        Ok(false)
    }

    fn progress(&self, bytes: &[u8]) -> f64 {
        self.at as f64 / bytes.len().max(1) as f64
    }
}

fn bad_head() -> Notice {
    Notice::new(Code::FileHead).with("kind", "PLY".to_owned())
}

fn scalar(word: &[u8]) -> Result<Scalar, Notice> {
    Ok(match word {
        b"char" | b"int8" => Scalar::Signed(1),
        b"uchar" | b"uint8" => Scalar::Unsigned(1),
        b"short" | b"int16" => Scalar::Signed(2),
        b"ushort" | b"uint16" => Scalar::Unsigned(2),
        b"int" | b"int32" => Scalar::Signed(4),
        b"uint" | b"uint32" => Scalar::Unsigned(4),
        b"float" | b"float32" => Scalar::Float,
        b"double" | b"float64" => Scalar::Double,
        _ => return Err(bad_head()),
    })
}

/// The byte that ends the lines of the head. The numbers of a binary file begin right after it, so it must be known
/// exactly.
fn line_end(bytes: &[u8]) -> u8 {
    match bytes {
        [_, _, _, b'\r', after, ..] if *after != b'\n' => b'\r',
        _ => b'\n',
    }
}

fn format_of(word: &[u8]) -> Result<Format, Notice> {
    Ok(match word {
        b"ascii" => Format::Text,
        b"binary_little_endian" => Format::Little,
        b"binary_big_endian" => Format::Big,
        _ => return Err(bad_head()),
    })
}

/// An element that has no properties yet.
fn element(name: &[u8], count: &[u8]) -> Result<Element, Notice> {
    Ok(Element {
        count: whole(count).ok_or_else(bad_head)?,
        is_vertex: name == b"vertex",
        properties: Vec::new(),
    })
}

impl Ply {
    /// The next line of the head, in lower case. `end` is the byte that ends lines.
    fn head_line(&mut self, bytes: &[u8], end: u8) -> Result<Vec<u8>, Notice> {
        let rest = bytes.get(self.at..).unwrap_or(&[]);
        let length = rest.iter().take(HEAD).position(|&b| b == end);
        let Some(length) = length.filter(|_| self.at < HEAD) else {
            return Err(if rest.len() < HEAD {
                ends("PLY")
            } else {
                bad_head()
            });
        };
        self.at += length + 1;
        Ok(rest[..length].to_ascii_lowercase())
    }

    fn read_head(&mut self, bytes: &[u8]) -> Result<Head, Notice> {
        let end = line_end(bytes);
        let mut format = None;
        let mut elements: Vec<Element> = Vec::new();
        loop {
            let line = self.head_line(bytes, end)?;
            let line: Vec<&[u8]> = words(&line).collect();
            match line[..] {
                [b"format", kind, ..] => format = Some(format_of(kind)?),
                [b"element", name, count] => {
                    elements.push(element(name, count)?);
                    // Strips are recognised by the name of their element.
                    self.has_faces |= name == b"tristrips";
                }
                [b"property", b"list", count, item, name] => {
                    let count = scalar(count)?;
                    add_property(&mut elements, name, item, Some(count))?;
                }
                [b"property", item, name] => add_property(&mut elements, name, item, None)?,
                [b"end_header"] => break,
                [b"ply"] | [b"comment", ..] | [b"obj_info", ..] | [] => {}
                _ => return Err(bad_head()),
            }
        }
        let format = format.ok_or_else(bad_head)?;
        let mut head = Head { format, elements };
        check(&mut head, self.has_faces)?;
        self.has_faces = false;
        Ok(head)
    }

    /// Reads an item, or a part of it if it is long; true at its end.
    fn read_item(
        &mut self,
        bytes: &[u8],
        format: Format,
        element: &Element,
        soup: &mut Soup,
    ) -> Result<bool, Notice> {
        while let Some(property) = element.properties.get(self.property) {
            if let Some(count) = property.count {
                if !self.read_list(bytes, format, (count, property), soup)? {
                    return Ok(false);
                }
            } else {
                let x = self.read(bytes, format, property.item)?;
                if let Role::Place(axis) = property.role {
                    self.place[axis] = x;
                }
            }
            self.property += 1;
        }
        self.property = 0;
        if element.is_vertex {
            soup.positions.push(DVec3::from(self.place));
            if soup.positions.len() > 9 * MOST_TRIANGLES {
                return Err(too_large(soup.positions.len() / 3));
            }
        }
        Ok(true)
    }

    /// Reads a list, or a part of it; true at its end.
    fn read_list(
        &mut self,
        bytes: &[u8],
        format: Format,
        (count, property): (Scalar, &Property),
        soup: &mut Soup,
    ) -> Result<bool, Notice> {
        let mut left = match self.left.take() {
            Some(left) => left,
            None => {
                let count = self.read(bytes, format, count)?;
                // Each item takes at least one byte, so a longer list cannot be in the file.
                if !(count >= 0.0 && count <= (bytes.len() - self.at) as f64) {
                    return Err(ends("PLY"));
                }
                self.list.clear();
                count as usize
            }
        };
        while left > 0 {
            if self.spent >= NUMBERS {
                self.left = Some(left);
                return Ok(false);
            }
            left -= 1;
            let x = self.read(bytes, format, property.item)?;
            let fits = x >= -1.0 && x < f64::from(u32::MAX) && x as i64 as f64 == x;
            // `u32::MAX`, which no vertex can have, is reported later.
            let corner = if fits { x as i64 as u32 } else { u32::MAX };
            if property.role != Role::None {
                self.list.push(corner);
            }
        }
        self.add(property.role, soup)?;
        Ok(true)
    }

    fn add(&mut self, role: Role, soup: &mut Soup) -> Result<(), Notice> {
        if self.list.len() > 3 * MOST_TRIANGLES {
            return Err(too_large(self.list.len()));
        }
        match role {
            Role::Corners => polygon::add(&soup.positions, &self.list, &mut soup.triangles),
            Role::Strip => {
                // The corner -1 ends a strip.
                for strip in self.list.split(|&v| v == u32::MAX) {
                    add_strip(strip, &mut soup.triangles);
                }
            }
            _ => return Ok(()),
        }
        self.has_faces = true;
        Ok(())
    }

    fn read(&mut self, bytes: &[u8], format: Format, scalar: Scalar) -> Result<f64, Notice> {
        self.spent += 1;
        if format == Format::Text {
            let word = next_word(bytes, &mut self.at).ok_or_else(|| ends("PLY"))?;
            let mut line = || self.lines.reach(bytes, self.at);
            // Some programs write values that are not numbers; the check of the model reports them.
            let is_none = |word: &[u8]| {
                [&b"nan"[..], b"-nan", b"inf", b"-inf"]
                    .iter()
                    .any(|none| word.eq_ignore_ascii_case(none))
            };
            return match number(word) {
                None if is_none(word) => Ok(f64::NAN),
                x => x.ok_or_else(|| bad_line("PLY", line(), word)),
            };
        }
        let size = match scalar {
            Scalar::Signed(size) | Scalar::Unsigned(size) => size,
            Scalar::Float => 4,
            Scalar::Double => 8,
        };
        let bits = bytes
            .get(self.at..self.at + size)
            .ok_or_else(|| ends("PLY"))?;
        self.at += size;
        let add = |sum: u64, &byte: &u8| sum << 8 | u64::from(byte);
        let bits = match format {
            Format::Big => bits.iter().fold(0, add),
            _ => bits.iter().rev().fold(0, add),
        };
        Ok(match scalar {
            Scalar::Unsigned(_) => bits as f64,
            // The sign is the highest bit.
            Scalar::Signed(size) => ((bits << (64 - 8 * size)) as i64 >> (64 - 8 * size)) as f64,
            Scalar::Float => f32::from_bits(bits as u32).into(),
            Scalar::Double => f64::from_bits(bits),
        })
    }
}

/// Adds a property to the last element. A list has a `count`: the kind of the number that tells its length.
fn add_property(
    elements: &mut [Element],
    name: &[u8],
    item: &[u8],
    count: Option<Scalar>,
) -> Result<(), Notice> {
    let last = elements.last_mut();
    let is_vertex = last.as_ref().is_some_and(|last| last.is_vertex);
    let axis = [b"x", b"y", b"z"].iter().position(|axis| *axis == name);
    let is_corners = matches!(name, b"vertex_indices" | b"vertex_index");
    let role = match axis {
        Some(axis) if is_vertex && count.is_none() => Role::Place(axis),
        None if is_corners && !is_vertex && count.is_some() => Role::Corners,
        _ => Role::None,
    };
    let item = scalar(item)?;
    last.ok_or_else(bad_head)?
        .properties
        .push(Property { count, item, role });
    Ok(())
}

/// Checks that vertices have three coordinates. If there are strips and only one element with corners, marks its
/// corners as strips.
fn check(head: &mut Head, has_strips: bool) -> Result<(), Notice> {
    let Some(vertex) = head.elements.iter().find(|e| e.is_vertex) else {
        return Err(bad_head());
    };
    let has = |axis| {
        vertex
            .properties
            .iter()
            .any(|p| p.role == Role::Place(axis))
    };
    if !(has(0) && has(1) && has(2)) {
        return Err(bad_head());
    }
    let faces = |e: &Element| e.properties.iter().any(|p| p.role == Role::Corners);
    let lists = head.elements.iter().filter(|e| faces(e)).count();
    if has_strips && lists == 1 {
        let lists = head.elements.iter_mut().flat_map(|e| &mut e.properties);
        for property in lists.filter(|p| p.role == Role::Corners) {
            property.role = Role::Strip;
        }
    }
    Ok(())
}
