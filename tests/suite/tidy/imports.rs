//! Who imports whom, file by file. What a `mod.rs` hands on counts as imported from the file that it comes from; where
//! that cannot be told, from the `mod.rs` itself, which imports all that it hands on.

use super::file::File;
use super::paths::{Path, Paths};
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// The names of our crates in others, each with its root.
const CRATES: [(&str, &str); 2] =
    [("groundling", "src/lib.rs"), ("groundling_kernel", "src/kernel.rs")];
/// How often a name may be handed on, or renamed, on its way to its file.
const MOST_HANDS: usize = 16;

/// The Rust files of a tree by the files that they import.
pub(super) struct Imports<'a> {
    files: &'a [File],
    paths: Vec<Paths>,
    /// The file of a module; a module's path begins with the file at the root of its crate.
    modules: BTreeMap<Path, usize>,
    /// By file, those that it imports.
    edges: Vec<BTreeSet<usize>>,
}

impl<'a> Imports<'a> {
    pub(super) fn of(files: &'a [File]) -> Self {
        let is_rust = |file: &File| file.ending() == "rs";
        let paths =
            files.iter().map(|file| if is_rust(file) { Paths::of(file) } else { Paths::default() });
        let paths = paths.collect();
        let children: Vec<Vec<(String, usize)>> = files
            .iter()
            .map(|file| if is_rust(file) { declared(file, files) } else { Vec::new() })
            .collect();
        let owned: BTreeSet<usize> = children.iter().flatten().map(|(_, child)| *child).collect();
        let roots = (0..files.len()).filter(|at| is_rust(&files[*at]) && !owned.contains(at));
        let mut open: Vec<(Path, usize)> =
            roots.map(|at| (vec![files[at].path.clone()], at)).collect();
        let mut modules = BTreeMap::new();
        while let Some((module, at)) = open.pop() {
            for (name, child) in &children[at] {
                open.push(([&module[..], std::slice::from_ref(name)].concat(), *child));
            }
            modules.insert(module, at);
        }
        let mut imports =
            Imports { files, paths, modules, edges: vec![BTreeSet::new(); files.len()] };
        for (module, &at) in &imports.modules {
            for path in imports.paths[at].all() {
                let file = imports.absolute(module, path, MOST_HANDS);
                let file = file.and_then(|path| imports.file(path, MOST_HANDS));
                imports.edges[at].extend(file.filter(|file| *file != at));
            }
        }
        imports
    }

    /// The files that import, each with one that it imports.
    pub(super) fn pairs(&self) -> impl Iterator<Item = (&'a File, &'a File)> {
        let files = self.files;
        let from = self.edges.iter().zip(files);
        from.flat_map(move |(to, from)| to.iter().map(move |&to| (from, &files[to])))
    }

    /// Circles of files that import each other, a shortest one for each file that is in none of those before.
    pub(super) fn circles(&self) -> Vec<Vec<&'a str>> {
        let mut named = BTreeSet::new();
        let mut circles = Vec::new();
        for start in 0..self.files.len() {
            if named.contains(&start) {
                continue;
            }
            if let Some(circle) = self.circle(start) {
                circles.push(circle.iter().map(|&at| self.files[at].path.as_str()).collect());
                named.extend(circle);
            }
        }
        circles
    }

    /// The shortest way from a file back to itself.
    fn circle(&self, start: usize) -> Option<Vec<usize>> {
        let mut came_from = BTreeMap::new();
        let mut open = VecDeque::from([start]);
        while let Some(at) = open.pop_front() {
            for &next in &self.edges[at] {
                came_from.entry(next).or_insert_with(|| {
                    open.push_back(next);
                    at
                });
            }
        }
        let mut circle = vec![start];
        let mut at = *came_from.get(&start)?;
        while at != start {
            circle.push(at);
            at = *came_from.get(&at)?;
        }
        circle.push(start);
        circle.reverse();
        Some(circle)
    }

    /// A path as it is written in a module, from the root of its crate; `None` when it leads out of the project.
    fn absolute(&self, module: &[String], path: &[String], hands: usize) -> Option<Path> {
        let (first, rest) = path.split_first()?;
        let parent = module.split_last().map_or(module, |(_, parent)| parent);
        match first.as_str() {
            "crate" => return Some([&module[..1], rest].concat()),
            "self" => return Some([module, rest].concat()),
            "super" if rest.first().is_some_and(|next| next == "super") => {
                return self.absolute(parent, rest, hands);
            }
            "super" => return Some([parent, rest].concat()),
            _ => {}
        }
        if let Some((_, root)) = CRATES.iter().find(|(name, _)| name == first) {
            return Some([&[(*root).to_owned()], rest].concat());
        }
        let child = [module, &path[..1]].concat();
        if self.modules.contains_key(&child) {
            return Some([module, path].concat());
        }
        let meant = self.brought(module, first).filter(|meant| meant.first() != Some(first))?;
        self.absolute(module, &[meant, rest].concat(), hands.checked_sub(1)?)
    }

    /// What a `use` line of a module brings in under a name.
    fn brought(&self, module: &[String], name: &str) -> Option<&Path> {
        let uses = &self.paths[*self.modules.get(module)?].uses;
        uses.iter().find(|(_, own)| own == name).map(|(path, _)| path)
    }

    /// The file that has what a path from the root names; none for a folder as such.
    fn file(&self, path: Path, hands: usize) -> Option<usize> {
        let ends = (1..=path.len()).rev();
        let (end, at) =
            ends.map(|end| (end, self.modules.get(&path[..end]))).find(|(_, at)| at.is_some())?;
        let at = *at?;
        if !["mod.rs", "lib.rs"]
            .iter()
            .any(|list| self.files[at].path.ends_with(&format!("/{list}")))
        {
            return Some(at);
        }
        let (module, [name, rest @ ..]) = path.split_at(end) else { return None };
        match self.brought(module, name) {
            Some(meant) if hands > 0 => {
                let path = self.absolute(module, &[meant, rest].concat(), hands)?;
                self.file(path, hands - 1)
            }
            _ => Some(at),
        }
    }
}

/// The modules that a file declares, with their files.
fn declared(file: &File, files: &[File]) -> Vec<(String, usize)> {
    let (folder, name) = file.path.rsplit_once('/').unwrap_or(("", &file.path));
    let stem = name.trim_end_matches(".rs");
    let lines: Vec<&str> = file.text.lines().collect();
    let mut declared = Vec::new();
    for (number, line) in file.code_lines() {
        let line = line.trim();
        let Some(name) = line.strip_suffix(';').and_then(|line| {
            let (before, name) = line.rsplit_once("mod ")?;
            (before.is_empty() || before.starts_with("pub")).then_some(name)
        }) else {
            continue;
        };
        let given = number
            .checked_sub(2)
            .and_then(|above| lines.get(above))
            .and_then(|above| above.trim().strip_prefix("#[path = \"")?.strip_suffix("\"]"));
        let places = match given {
            Some(given) => vec![plainly(&format!("{folder}/{given}"))],
            None => [format!("{folder}/{stem}"), folder.to_owned()]
                .iter()
                .flat_map(|folder| {
                    [format!("{folder}/{name}.rs"), format!("{folder}/{name}/mod.rs")]
                })
                .collect(),
        };
        let found = places.iter().find_map(|place| files.iter().position(|f| f.path == *place));
        declared.extend(found.map(|child| (name.to_owned(), child)));
    }
    declared
}

/// A path of files without `..`.
fn plainly(path: &str) -> String {
    let mut parts = Vec::new();
    for part in path.split('/') {
        if part == ".." {
            parts.pop();
        } else {
            parts.push(part);
        }
    }
    parts.join("/")
}
