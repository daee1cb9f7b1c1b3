//! Which module may import which, and the order in which they are read.

use super::file::File;
use super::paths::Paths;

/// The modules in reading order, each with what it may import. `worker::protocol` admits that part alone.
pub(super) const ARROWS: [(&str, &[&str]); 14] = [
    ("logic", &[]),
    ("mdp", &[]),
    ("domain", &["mdp"]),
    ("ground", &["logic", "mdp", "domain"]),
    ("plan", &["mdp"]),
    ("solve", &["mdp", "domain", "ground", "plan"]),
    ("ccg", &["logic"]),
    ("corpus", &["domain"]),
    ("learn", &["logic", "ccg", "mdp", "domain", "ground", "plan", "corpus"]),
    ("study", &["logic", "ccg", "mdp", "domain", "ground", "plan", "corpus", "learn"]),
    ("render", &["domain"]),
    (
        "worker",
        &["logic", "ccg", "mdp", "domain", "ground", "plan", "solve", "corpus", "learn", "study"],
    ),
    ("robot", &["domain", "mdp", "plan"]),
    ("ui", &["worker::protocol", "render", "domain", "corpus", "study", "robot"]),
];

/// Says so when a file of `src/` imports against the arrows.
pub(super) fn imports_go_one_way(file: &File) -> Vec<String> {
    let Some(module) = file.path.strip_prefix("src/").and_then(|path| path.split_once('/')) else {
        return Vec::new();
    };
    let Some((own, allowed)) = ARROWS.iter().find(|(name, _)| *name == module.0) else {
        return if module.0 == "bin" {
            Vec::new()
        } else {
            vec![format!("src/{} is not in the reading order", module.0)]
        };
    };
    let mut complaints = Vec::new();
    for path in paths_from_root(file) {
        let part = path.split("::").next().unwrap_or_default();
        let known = ARROWS.iter().any(|(name, _)| *name == part);
        let admitted = part == *own
            || allowed.iter().any(|a| {
                path == *a || path.strip_prefix(a).is_some_and(|rest| rest.starts_with("::"))
            });
        if known && !admitted {
            complaints.push(format!("{own} must not import {path}"));
        }
    }
    complaints
}

/// Says so when the root of a crate does not declare its modules in reading order.
pub(super) fn modules_stand_in_reading_order(file: &File) -> Vec<String> {
    if !["src/kernel.rs", "src/lib.rs"].contains(&file.path.as_str()) {
        return Vec::new();
    }
    let mut last = 0;
    let mut complaints = Vec::new();
    for line in file.code.lines() {
        let Some(name) = line.trim().strip_prefix("pub mod ").and_then(|l| l.strip_suffix(';'))
        else {
            continue;
        };
        match ARROWS.iter().position(|(module, _)| *module == name) {
            Some(place) if place >= last => last = place,
            Some(_) => complaints.push(format!("{name} stands too late")),
            None => complaints.push(format!("{name} is not in the reading order")),
        }
    }
    complaints
}

/// Every path that starts at the crate's root, without `crate`: from `use` trees and from the code alike.
fn paths_from_root(file: &File) -> Vec<String> {
    // How many `super` lead from this file to the root.
    let folders = file.path.trim_start_matches("src/").matches('/').count();
    let depth = if file.path.ends_with("/mod.rs") { folders } else { folders + 1 };
    let from_root = |path: &[String]| match path {
        [first, rest @ ..] if first == "crate" => Some(rest.join("::")),
        _ => {
            let (up, rest) = path.split_at_checked(depth)?;
            up.iter().all(|part| part == "super").then(|| rest.join("::"))
        }
    };
    Paths::of(file).all().filter_map(|path| from_root(path)).collect()
}
