//! Tidiness: the shape of the project, held from the first day. Every rule is tried on the whole tree and
//! on a sample that breaks it, so that each is seen to be able to fail.

#[path = "tidy/arrows.rs"]
mod arrows;
#[path = "tidy/circles.rs"]
mod circles;
#[path = "tidy/file.rs"]
mod file;
#[path = "tidy/imports.rs"]
mod imports;
#[path = "tidy/paths.rs"]
mod paths;
#[path = "tidy/rules.rs"]
mod rules;

use file::File;
use std::collections::BTreeMap;

/// What may stand at the top of the repository.
const TOP: [&str; 19] = [
    ".cargo",
    ".ci",
    ".clippy.toml",
    ".gitattributes",
    ".github",
    ".gitignore",
    ".rustfmt.toml",
    "Cargo.lock",
    "Cargo.toml",
    "LICENSE-APACHE",
    "LICENSE-MIT",
    "Makefile",
    "README.md",
    "Trunk.toml",
    "assets",
    // Scripts that show surprises of other people's software; nothing needs them, and CI does not run them.
    "findings",
    "src",
    "tests",
    "www",
];

/// Runs `rule` over the tree.
#[track_caller]
fn holds(rule: fn(&File) -> Vec<String>) {
    let complaints: Vec<String> = file::tree()
        .iter()
        .flat_map(|file| rule(file).into_iter().map(|what| format!("{}: {what}", file.path)))
        .collect();
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

/// Runs `rule` over all files of the tree together.
#[track_caller]
fn holds_of_all(rule: fn(&[File]) -> Vec<String>) {
    let complaints = rule(&file::tree());
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

/// Runs `rule` over a sample that breaks it and over one that does not.
#[track_caller]
fn tells_apart(rule: fn(&File) -> Vec<String>, path: &str, bad: &str, good: &str) {
    assert!(!rule(&File::new(path, bad)).is_empty(), "not caught in {path}: {bad}");
    assert_eq!(rule(&File::new(path, good)), Vec::<String>::new(), "wrongly caught: {good}");
}

/// A small tree: the modules that the rules on imports are tried on, with `changes` to their files.
fn sample(changes: &[(&str, &str)]) -> Vec<File> {
    let mut files = BTreeMap::from([
        ("src/lib.rs", "pub mod a;\npub mod b;\npub mod render;\npub mod ui;"),
        ("src/a.rs", ""),
        ("src/b/mod.rs", "pub mod c;\npub mod d;\npub use c::C;"),
        ("src/b/c.rs", ""),
        ("src/b/d.rs", ""),
        ("src/render/mod.rs", ""),
        (
            "src/ui/mod.rs",
            "pub mod page;\npub mod talk;\npub mod train;\npub mod app;\npub use train::Train;",
        ),
        ("src/ui/page/mod.rs", "mod a;\npub use a::P;"),
        ("src/ui/page/a.rs", ""),
        ("src/ui/talk/mod.rs", "pub mod a;\nmod b;"),
        ("src/ui/talk/a.rs", ""),
        ("src/ui/talk/b.rs", ""),
        ("src/ui/train/mod.rs", "pub mod a;\npub use a::{T, Train};"),
        ("src/ui/train/a.rs", ""),
        ("src/ui/app/mod.rs", "pub mod a;"),
        ("src/ui/app/a.rs", ""),
    ]);
    files.extend(changes.iter().copied());
    files.iter().map(|(path, text)| File::new(path, text)).collect()
}

/// Runs `rule` over a small tree that breaks it and over one that does not: the same with `cure`.
#[track_caller]
fn all_tell_apart(rule: fn(&[File]) -> Vec<String>, bad: &[(&str, &str)], cure: &[(&str, &str)]) {
    assert!(!rule(&sample(bad)).is_empty(), "not caught: {bad:?}");
    let good = [bad, cure].concat();
    assert_eq!(rule(&sample(&good)), Vec::<String>::new(), "wrongly caught: {good:?}");
}

#[test]
fn imports_go_one_way() {
    let rule = arrows::imports_go_one_way;
    tells_apart(rule, "src/logic/a.rs", "use crate::ccg::Chart;", "use crate::logic::Ty;");
    tells_apart(rule, "src/plan/a.rs", "fn f(s: crate::domain::State) {}", "use crate::mdp::Mdp;");
    tells_apart(
        rule,
        "src/ground/a.rs",
        "use crate::{\n    logic::{Terms, TermId as T},\n    domain::State, learn::Trainer,\n};",
        "use crate::{\n    logic::{Terms, TermId as T},\n    domain::State, mdp,\n};",
    );
    tells_apart(
        rule,
        "src/ui/a.rs",
        "use crate::worker::job::Job;",
        "use crate::worker::protocol::Event;",
    );
    tells_apart(rule, "src/logic/a.rs", "use super::super::ground::Goal;", "use super::ty::Ty;");
    assert!(!rule(&File::new("src/shell/a.rs", "fn f() {}")).is_empty(), "a module of no place");
    holds(rule);
}

#[test]
fn imports_make_no_circle() {
    let rule = circles::imports_make_no_circle;
    let by_use =
        [("src/a.rs", "use crate::b::{self, c::C};"), ("src/b/c.rs", "use super::super::a::A;")];
    all_tell_apart(rule, &by_use, &[("src/b/c.rs", "")]);
    let by_path =
        [("src/a.rs", "fn f() { super::b::c::f() }"), ("src/b/c.rs", "fn f(a: crate::a::A) {}")];
    all_tell_apart(rule, &by_path, &[("src/b/c.rs", "fn f(a: a::A) {}")]);
    let by_module = [
        ("src/a.rs", "use crate::b::c as d;\nfn f() { d::f() }"),
        ("src/b/c.rs", "use crate::a;\nfn f() { a::f() }"),
    ];
    all_tell_apart(rule, &by_module, &[("src/b/c.rs", "use crate::b as a;\nfn f() { a::C::f() }")]);
    let handed_on = [
        ("src/a.rs", "use crate::b::C;"),
        ("src/b/mod.rs", "mod c;\nmod d;\npub use c::C;\npub use d::D;"),
        ("src/b/c.rs", "use super::D;"),
        ("src/b/d.rs", "use crate::a::A;"),
    ];
    all_tell_apart(rule, &handed_on, &[("src/b/d.rs", "use super::C as _;"), ("src/b/c.rs", "")]);
    let unknown = [("src/b/c.rs", "use super::E;")];
    all_tell_apart(rule, &unknown, &[("src/b/c.rs", "use std::E;")]);
    let of_three = [
        ("src/a.rs", "use crate::b::c::C;"),
        ("src/b/c.rs", "use super::d::D;"),
        ("src/b/d.rs", "use crate::a::A;"),
    ];
    let said = rule(&sample(&of_three));
    assert_eq!(said, ["a circle: src/a.rs → src/b/c.rs → src/b/d.rs → src/a.rs"]);
    let in_tests = [
        ("tests/b.rs", "#[path = \"b/../c.rs\"]\nmod c;\nfn f() { c::f() }"),
        ("tests/c.rs", "use super::f;"),
    ];
    all_tell_apart(rule, &in_tests, &[("tests/c.rs", "use groundling::a::f;")]);
    holds_of_all(rule);
}

#[test]
fn pages_know_no_other() {
    let rule = circles::pages_know_no_other;
    for (path, bad, good) in [
        ("src/ui/talk/a.rs", "use crate::ui::train::T;", "use crate::ui::page::P;"),
        ("src/ui/talk/a.rs", "fn f() { super::super::train::a::f() }", "use super::b::B;"),
        ("src/ui/talk/a.rs", "use crate::ui::{app::A, page::P};", "use crate::ui::{page::P};"),
        ("src/ui/talk/a.rs", "use crate::ui::Train;", "use crate::render::Scene;"),
        ("src/ui/page/a.rs", "use crate::ui::talk::T;", "use super::P;"),
        ("src/ui/page/a.rs", "use super::super::app::A;", "use crate::ui::page::P;"),
    ] {
        all_tell_apart(
            rule,
            &[(path, bad)],
            &[
                (path, good),
                (
                    "src/ui/app/a.rs",
                    "use crate::ui::{page::P, talk, train::T};\nfn f() { talk::a::f() }",
                ),
            ],
        );
    }
    holds_of_all(rule);
}

#[test]
fn modules_stand_in_reading_order() {
    let rule = arrows::modules_stand_in_reading_order;
    tells_apart(
        rule,
        "src/lib.rs",
        "pub mod plan;\npub mod logic;",
        "pub mod logic;\npub mod plan;",
    );
    tells_apart(rule, "src/lib.rs", "pub mod helpers;", "pub mod ccg;");
    tells_apart(
        rule,
        "src/kernel.rs",
        "pub mod solve;\npub mod plan;",
        "pub mod plan;\npub mod solve;",
    );
    holds(rule);
}

#[test]
fn files_are_short() {
    let rule = rules::is_short;
    tells_apart(rule, "src/logic/a.rs", &"//\n".repeat(501), &"//\n".repeat(500));
    tells_apart(rule, "tests/e2e/a.mjs", &"//\n".repeat(501), &"//\n".repeat(500));
    tells_apart(rule, "src/ui/talk/a.rs", &"//\n".repeat(301), &"//\n".repeat(300));
    tells_apart(rule, "src/ui/talk/words/english.rs", &"//\n".repeat(501), &"//\n".repeat(500));
    holds(rule);
}

#[test]
fn checks_of_a_flow_wait_for_what_they_check() {
    let rule = rules::flows_wait;
    let path = "tests/e2e/flows/a.mjs";
    let good =
        "await t.equal(() => demo.plain(), 'a', 'b');\nconst holds = () => t.check(is, 'b');";
    tells_apart(rule, path, "await t.equal(await demo.plain(), 'a', 'b');", good);
    tells_apart(rule, path, "await t.check((await demo.why()).includes('a'), 'b');", good);
    tells_apart(rule, path, "  t.check(seen, 'b');", good);
    holds(rule);
}

#[test]
fn files_begin_by_saying_what_they_are() {
    let rule = rules::has_a_head;
    tells_apart(rule, "src/a.rs", "fn f() {}", "//! What this file is, in a few words.");
    tells_apart(rule, "tests/e2e/a.mjs", "let a = 1;", "// What this file is, in a few words.");
    tells_apart(rule, "www/a.css", "a { }", "/* What this file is, in a few words. */");
    tells_apart(
        rule,
        "findings/a.sh",
        "#!/bin/sh\nls",
        "#!/bin/sh\n# What this file is, in a few words.",
    );
    holds(rule);
}

#[test]
fn mod_files_only_list() {
    let rule = rules::mod_files_only_list;
    let good = "//! Docs.\npub mod a;\n#[cfg(target_arch = \"wasm32\")]\nmod gpu;\npub use a::{\n    A,\n};";
    tells_apart(rule, "src/logic/mod.rs", "pub mod a;\nfn f() {}", good);
    holds(rule);
}

#[test]
fn only_the_edge_asks_where_it_is_built() {
    let rule = rules::cfg_only_at_the_edge;
    let wasm = |line: &str| {
        format!("#[cfg(target_arch = \"wasm32\")]\n{line}\n#[cfg(test)]\nmod tests {{}}")
    };
    let cases = [
        ("src/render/mod.rs", "pub mod scene;", "pub mod gpu;"),
        ("src/render/mod.rs", "pub use scene::Scene;", "pub use gpu::Gpu;"),
        ("src/render/mod.rs", "pub mod link;", "mod gpu;"),
        ("src/render/mod.rs", "pub mod view;", "pub(crate) mod agent;"),
        ("src/robot/mod.rs", "pub mod links;", "pub mod link;"),
        ("src/ui/talk/mod.rs", "pub mod link;", "pub mod view;"),
        ("src/ui/mod.rs", "pub mod page;", "pub mod view;"),
    ];
    for (path, bad, good) in cases {
        tells_apart(rule, path, &wasm(bad), &wasm(good));
    }
    tells_apart(rule, "src/plan/a.rs", "if cfg!(debug_assertions) {}", "// cfg!(debug_assertions)");
    for edge in
        ["src/render/gpu/a.rs", "src/ui/talk/view.rs", "src/ui/page/view/a.rs", "src/robot/link.rs"]
    {
        assert!(rule(&File::new(edge, "#[cfg(windows)]")).is_empty(), "{edge}");
    }
    holds(rule);
}

#[test]
fn the_core_is_pure() {
    let rule = rules::core_is_pure;
    tells_apart(rule, "src/plan/a.rs", "use std::time::Duration;", "// no std::time here");
    tells_apart(rule, "src/plan/a.rs", "std::thread::spawn(f);", "let thread = 1;");
    tells_apart(rule, "src/plan/a.rs", "println!();", "writeln!(out);");
    tells_apart(rule, "src/plan/a.rs", "x.powf(1.1)", "libm::pow(x, 1.1)");
    tells_apart(
        rule,
        "src/plan/a.rs",
        "use std::collections::HashMap;",
        "use rustc_hash::FxHashMap;",
    );
    tells_apart(
        rule,
        "src/plan/a.rs",
        "rand::rng()",
        "fn f() {}\n#[cfg(test)]\nmod tests { println!(); }",
    );
    assert!(!rule(&File::new("src/render/link.rs", "println!();")).is_empty(), "not the robot's");
    assert!(!rule(&File::new("src/ui/talk/review.rs", "println!();")).is_empty(), "no view");
    assert!(rule(&File::new("src/bin/groundling.rs", "println!();")).is_empty());
    holds(rule);
}

#[test]
fn learning_never_plans() {
    let rule = rules::learning_never_plans;
    let reads = "use super::planning::Validation;";
    tells_apart(rule, "src/learn/a.rs", "use crate::plan::Budget;", reads);
    tells_apart(rule, "src/learn/a.rs", "fn f() { AStar::new(); }", reads);
    assert!(rule(&File::new("src/learn/planning.rs", "use crate::plan::AStar;")).is_empty());
    holds(rule);
}

#[test]
fn names_come_in_one_by_one() {
    tells_apart(rules::no_globs, "src/a.rs", "use super::*;", "let a = b * c; // ::*");
    holds(rules::no_globs);
}

#[test]
fn nothing_is_left_for_later() {
    let rule = rules::nothing_left_for_later;
    tells_apart(rule, "src/a.rs", "todo!()", "// todo!()");
    tells_apart(rule, "tests/a.rs", "#[ignore]\nfn f() {}", "#[test]\nfn f() {}");
    holds(rule);
}

#[test]
fn no_file_names_a_machine() {
    let rule = rules::names_no_machine;
    tells_apart(rule, "README.md", &format!("see /{}/me/x", "home"), "see src/home/me");
    tells_apart(rule, "findings/a.sh", &format!("curl {}.org", "npmjs"), "curl example.org");
    holds(rule);
}

#[test]
fn crates_of_the_browser_are_for_wasm_only() {
    let rule = rules::browser_crates_are_wasm_only;
    let good = "[target.'cfg(target_arch = \"wasm32\")'.dependencies]\nyew = \"1\"\n[lints.rust]";
    tells_apart(rule, "Cargo.toml", "[dependencies]\nyew = \"1\"", good);
    holds(rule);
}

#[test]
fn the_top_level_is_the_one_of_the_design() {
    let stray: Vec<String> =
        file::top_level().into_iter().filter(|name| !TOP.contains(&name.as_str())).collect();
    assert!(stray.is_empty(), "not named by the design: {stray:?}");
    assert!(!TOP.contains(&"utils"));
}
