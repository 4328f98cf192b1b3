//! The drawing of the house (docs/house.svg) agrees with the code. Each use between folders has arrows, each
//! arrow stands for a use, and no arrows form a circle. No files use each other in a circle either. No name of a type
//! is defined in more than two files, in the crate or in the page.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

/// Pairs of folders, of which the first uses the second.
type Uses = BTreeSet<(String, String)>;

/// Basic folders, which any folder of src may use without an arrow.
const GROUND: [&str; 6] = ["notice", "order", "csr", "random", "decimal", "hash"];

fn root() -> &'static std::path::Path {
    std::path::Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// All files below a folder, or the file itself.
fn files(path: &std::path::Path) -> Vec<String> {
    if path.is_file() {
        return vec![fs::read_to_string(path).unwrap()];
    }
    let entries = fs::read_dir(path).unwrap();
    entries
        .flat_map(|entry| files(&entry.unwrap().path()))
        .collect()
}

/// The names in a folder, without endings.
fn rooms(top: &str) -> BTreeSet<String> {
    let entries = fs::read_dir(root().join(top)).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    let stem = |path: std::path::PathBuf| path.file_stem().unwrap().to_str().unwrap().to_owned();
    paths.map(stem).collect()
}

/// The code of a Rust file, without comments and without the tests at its end.
fn code(file: &str) -> String {
    let shipped = file.split("#[cfg(test)]\nmod tests {").next().unwrap();
    let lines = shipped
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"));
    lines.collect::<Vec<_>>().join("\n")
}

/// The names from the crate's root to a module or an item.
type Path = Vec<String>;

/// The shipped code of `src` by module, and the names that modules re-export with `pub use`.
struct Modules {
    code: BTreeMap<Path, String>,
    handed_on: BTreeMap<Path, Path>,
}

impl Modules {
    fn read() -> Self {
        let mut code = BTreeMap::new();
        read_module(&root().join("src"), &[], &mut code);
        let mut modules = Self {
            code,
            handed_on: BTreeMap::new(),
        };
        for (module, code) in &modules.code {
            for (is_public, path) in imports(code) {
                let path = modules.path_from_root(module, &path);
                if let (true, Some(path)) = (is_public, path) {
                    let name = path[path.len() - 1].clone();
                    modules.handed_on.insert(below(module, &name), path);
                }
            }
        }
        modules
    }

    /// The path from the root of a path in a module; none if it leads to another crate.
    fn path_from_root(&self, module: &[String], path: &[String]) -> Option<Path> {
        let ups = path.iter().take_while(|name| *name == "super").count();
        let (base, rest) = match path[0].as_str() {
            "crate" => (&[][..], &path[1..]),
            "self" => (module, &path[1..]),
            "super" => (&module[..module.len() - ups], &path[ups..]),
            name if self.code.contains_key(&below(module, name)) => (module, path),
            _ => return None,
        };
        Some([base, rest].concat())
    }

    /// The module that defines the item of a path from the root; the empty path is the root itself.
    fn home(&self, path: &[String]) -> Path {
        for end in 1..=path.len() {
            if let Some(to) = self.handed_on.get(&path[..end])
                && !self.code.contains_key(&path[..end])
            {
                return self.home(&[to, &path[end..]].concat());
            }
        }
        let ends = (0..=path.len()).rev();
        let mut modules = ends.map(|end| path[..end].to_vec());
        modules
            .find(|path| self.code.contains_key(path))
            .unwrap_or_default()
    }

    /// Each module with the modules that it uses.
    fn uses(&self) -> BTreeMap<&Path, BTreeSet<Path>> {
        let of = |module: &Path, code: &str| -> BTreeSet<Path> {
            let imported = imports(code).into_iter().map(|(_, path)| path);
            let paths = imported.chain(paths_in_code(code));
            let paths = paths.filter_map(|path| self.path_from_root(module, &path));
            paths.map(|path| self.home(&path)).collect()
        };
        let all = self.code.iter();
        all.map(|(module, code)| (module, of(module, code)))
            .collect()
    }
}

fn below(module: &[String], name: &str) -> Path {
    [module, &[name.to_owned()]].concat()
}

/// Reads a folder of `src` without its test modules.
fn read_module(folder: &std::path::Path, module: &[String], found: &mut BTreeMap<Path, String>) {
    let head = ["mod.rs", "lib.rs"].map(|name| fs::read_to_string(folder.join(name)));
    let beside = fs::read_to_string(folder.with_extension("rs"));
    let head = head.into_iter().chain([beside]).find_map(Result::ok);
    let head = head.unwrap_or_default();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap();
        let declared = format!("mod {name};");
        let lines: Vec<&str> = head.lines().collect();
        let line = lines.iter().position(|line| line.ends_with(&declared));
        let Some(line) = line else { continue };
        if line > 0 && lines[line - 1] == "#[cfg(test)]" {
            continue;
        }
        let module = below(module, name);
        if path.is_dir() {
            let head = path.join("mod.rs");
            if head.exists() {
                found.insert(module.clone(), code(&fs::read_to_string(head).unwrap()));
            }
            read_module(&path, &module, found);
        } else {
            found.insert(module, code(&fs::read_to_string(path).unwrap()));
        }
    }
}

/// The trees of the `use` lines in some code; true for `pub use`.
fn use_lines(code: &str) -> impl Iterator<Item = (bool, &str)> {
    let starts = code.match_indices("use ");
    starts.filter_map(|(at, word)| {
        let line = code[..at].rsplit('\n').next().unwrap().trim();
        let begins = line.is_empty() || (line.starts_with("pub") && !line.contains(' '));
        let behind = code[at + word.len()..].split(';').next().unwrap();
        begins.then_some((!line.is_empty(), behind))
    })
}

/// The imported paths; true for those that are re-exported.
fn imports(code: &str) -> Vec<(bool, Path)> {
    let mut found = Vec::new();
    for (is_public, tree) in use_lines(code) {
        let mut paths = Vec::new();
        expand(&[], tree, &mut paths);
        found.extend(paths.into_iter().map(|path| (is_public, path)));
    }
    found
}

/// Lists all paths of a tree of imports such as `a::{b, c::{d, e}}`.
fn expand(before: &[String], tree: &str, paths: &mut Vec<Path>) {
    let names = |text: &str| -> Path {
        let names = text.split("::").map(str::trim);
        let names = names.filter(|name| !name.is_empty());
        names.map(str::to_owned).collect()
    };
    let Some((head, list)) = tree.split_once('{') else {
        let path = tree.split(" as ").next().unwrap();
        paths.push([before, &names(path)].concat());
        return;
    };
    let before = [before, &names(head)].concat();
    let list = &list[..list.rfind('}').unwrap()];
    let (mut depth, mut start) = (0, 0);
    for (at, c) in list.char_indices().chain([(list.len(), ',')]) {
        depth += i32::from(c == '{') - i32::from(c == '}');
        if c == ',' && depth == 0 {
            if !list[start..at].trim().is_empty() {
                expand(&before, &list[start..at], paths);
            }
            start = at + 1;
        }
    }
}

/// The paths in code that begin with `crate` or `super`, except in `use` lines.
fn paths_in_code(code: &str) -> Vec<Path> {
    let is_end = |c: char| !c.is_alphanumeric() && c != '_' && c != ':';
    let words = code.split(is_end);
    let paths = words.filter(|word| ["crate::", "super::"].iter().any(|s| word.starts_with(s)));
    let paths = paths.map(|path| path.split("::").filter(|name| !name.is_empty()));
    let paths = paths.map(|names| names.map(str::to_owned).collect::<Path>());
    paths.filter(|path| path.len() > 1).collect()
}

/// The name of the type that a line defines. Types named in traits and in their implementations do not count: such
/// lines are indented.
fn defined_type(line: &str) -> Option<&str> {
    let mut words = line.split_whitespace().peekable();
    words.next_if(|word| word.starts_with("pub"));
    let is_type = match words.next()? {
        "struct" | "enum" | "trait" | "union" => true,
        word => word == "type" && !line.starts_with(' '),
    };
    let name = words.next().filter(|_| is_type)?;
    name.split(|c: char| !c.is_alphanumeric()).next()
}

/// The name of the type that a line of the page's code defines.
fn defined_page_type(line: &str) -> Option<&str> {
    const BEFORE: [&str; 5] = ["export", "default", "declare", "abstract", "const"];
    let rest = line.split(' ').skip_while(|word| BEFORE.contains(word));
    let [kind, name] = rest.take(2).collect::<Vec<_>>().try_into().ok()?;
    let is_type = ["type", "interface", "class", "enum"].contains(&kind);
    let name = name.split(|c: char| !c.is_alphanumeric()).next()?;
    (is_type && !name.is_empty()).then_some(name)
}

/// The TypeScript files below a folder, by path.
fn page_files(folder: &std::path::Path, found: &mut BTreeMap<String, String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            page_files(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "ts") {
            let name = path.strip_prefix(root()).unwrap().display().to_string();
            found.insert(name, fs::read_to_string(path).unwrap());
        }
    }
}

/// The names that more than two files define, with these files. There are more than `least` names.
fn defined_too_often<'a>(
    definitions: impl Iterator<Item = (&'a str, String)>,
    least: usize,
) -> BTreeMap<&'a str, BTreeSet<String>> {
    let mut files: BTreeMap<&str, BTreeSet<String>> = BTreeMap::new();
    for (name, file) in definitions {
        files.entry(name).or_default().insert(file);
    }
    assert!(files.len() > least, "{}", files.len());
    files.retain(|_, files| files.len() > 2);
    files
}

/// Uses between the folders of `src`.
fn uses_of_src() -> Uses {
    let modules = Modules::read();
    let mut uses = Uses::new();
    for (module, used) in modules.uses() {
        for other in used.iter().filter(|other| !other.is_empty()) {
            if other[0] != module[0] && !GROUND.contains(&other[0].as_str()) {
                uses.insert((module[0].clone(), other[0].clone()));
            }
        }
    }
    uses
}

/// Uses between the folders of `www`, by static and dynamic imports.
fn uses_of_www() -> Uses {
    let drawn: BTreeSet<String> = arrows().into_iter().flat_map(|(a, b)| [a, b]).collect();
    let mut uses = Uses::new();
    for room in rooms("www").intersection(&drawn) {
        for file in files(&root().join("www").join(room)) {
            for behind in file.split("'../").skip(1) {
                let name = behind.trim_start_matches("../").split(['/', '\'']);
                let name = name.into_iter().next().unwrap();
                if name != room && drawn.contains(name) {
                    uses.insert((room.clone(), name.to_owned()));
                }
            }
        }
    }
    uses
}

/// The arrows of the drawing.
fn arrows() -> Uses {
    let svg = fs::read_to_string(root().join("docs/house.svg")).unwrap();
    let document = roxmltree::Document::parse(&svg).unwrap();
    let arrows = document
        .descendants()
        .filter_map(|path| path.attribute("data-uses"));
    arrows
        .map(|words| words.split_once(' ').unwrap())
        .map(|(a, b)| (a.to_owned(), b.to_owned()))
        .collect()
}

/// The folders that a folder's arrows lead to, directly or over others.
fn reached<'a>(arrows: &'a Uses, from: &str) -> BTreeSet<&'a str> {
    let mut reached = BTreeSet::new();
    let mut ends = vec![from];
    while let Some(end) = ends.pop() {
        for (_, next) in arrows.iter().filter(|(a, _)| a == end) {
            if reached.insert(next.as_str()) {
                ends.push(next);
            }
        }
    }
    reached
}

#[test]
fn the_drawing_shows_what_uses_what() {
    let arrows = arrows();
    let uses: Uses = &uses_of_src() | &uses_of_www();
    for (a, b) in &uses {
        assert!(
            reached(&arrows, a).contains(b.as_str()),
            "{a} uses {b}, and no arrow of docs/house.svg says so"
        );
    }
    // Between page, crate and programs there are no imports by these names.
    let joints = [("module", "web"), ("examples", "studio")];
    for (a, b) in &arrows {
        let known =
            joints.contains(&(a.as_str(), b.as_str())) || uses.contains(&(a.clone(), b.clone()));
        assert!(
            known,
            "docs/house.svg has an arrow from {a} to {b}, which does not use it"
        );
        assert!(
            !reached(&arrows, b).contains(a.as_str()),
            "{a} and {b} use each other in docs/house.svg"
        );
    }
    assert!(uses.len() > 60, "{uses:?}");
}

#[test]
fn no_files_use_each_other_in_a_circle() {
    let modules = Modules::read();
    let mut left: Uses = Uses::new();
    for (module, used) in modules.uses() {
        // A file may use the head of its own folder, which lists its files.
        for other in used.iter().filter(|other| !module.starts_with(other)) {
            let [user, used] = [module, other].map(|path| path.join("::"));
            left.insert((user, used));
        }
    }
    assert!(left.len() > 800, "{}", left.len());
    // Removes the ends of chains until only circles are left, or nothing.
    loop {
        let users: BTreeSet<String> = left.iter().map(|(user, _)| user.clone()).collect();
        let before = left.len();
        left.retain(|(_, used)| users.contains(used));
        let used: BTreeSet<String> = left.iter().map(|(_, used)| used.clone()).collect();
        left.retain(|(user, _)| used.contains(user));
        if left.len() == before {
            break;
        }
    }
    assert!(left.is_empty(), "{left:#?}");
}

#[test]
fn a_name_of_a_type_is_defined_in_two_files_at_most() {
    let modules = Modules::read();
    let crate_types = modules.code.iter().flat_map(|(module, code)| {
        let names = code.lines().filter_map(defined_type);
        names.map(|name| (name, module.join("::")))
    });
    let often = defined_too_often(crate_types, 500);
    assert!(often.is_empty(), "{often:#?}");

    let mut page = BTreeMap::new();
    page_files(&root().join("www"), &mut page);
    let page_types = page.iter().flat_map(|(file, code)| {
        let names = code.lines().filter_map(defined_page_type);
        names.map(|name| (name, file.clone()))
    });
    let often = defined_too_often(page_types, 300);
    assert!(often.is_empty(), "{often:#?}");
}
