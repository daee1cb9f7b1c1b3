//! The rules of a single file: size, head comment, what a `mod.rs` holds, `cfg`, globs, loose ends,
//! a pure core, no address of a machine. Each returns its complaints.

use super::file::File;

/// The most lines that a source file may have, and one of the page that is no table of words.
const MOST_LINES: usize = 500;
const MOST_LINES_OF_UI: usize = 300;

/// Endings of what is written by hand as source.
const SOURCES: [&str; 7] = ["rs", "mjs", "js", "css", "wgsl", "sh", "html"];

/// Says so when a source file is too long to be read at a sitting.
pub(super) fn is_short(file: &File) -> Vec<String> {
    let lines = file.text.lines().count();
    let is_words = ["/words/", "/text/"].iter().any(|folder| file.path.contains(folder));
    let is_ui = file.path.starts_with("src/ui/") && !is_words;
    let most = if is_ui { MOST_LINES_OF_UI } else { MOST_LINES };
    let counts = SOURCES.contains(&file.ending()) && lines > most;
    counts.then(|| format!("{lines} lines, at most {most}")).into_iter().collect()
}

/// Says so when a source file does not begin by saying what it is.
pub(super) fn has_a_head(file: &File) -> Vec<String> {
    let first = file.text.lines().find(|line| !line.starts_with("#!") || line.starts_with("#!["));
    let head = first.unwrap_or_default();
    let starts: &[&str] = match file.ending() {
        "rs" => &["//! "],
        "mjs" | "js" | "wgsl" => &["// ", "/* ", "/** "],
        "css" => &["/* "],
        "sh" => &["# "],
        _ if file.path == "Makefile" || file.path == ".ci/run" => &["# "],
        _ => return Vec::new(),
    };
    let good = starts.iter().any(|start| head.starts_with(start) && head.len() > 20);
    (!good).then(|| "no head comment".to_owned()).into_iter().collect()
}

/// Says so when a `mod.rs` holds more than its docs, its modules and what it hands on.
pub(super) fn mod_files_only_list(file: &File) -> Vec<String> {
    if !file.path.starts_with("src/") || !file.path.ends_with("/mod.rs") {
        return Vec::new();
    }
    let items = ["pub mod ", "mod ", "pub use ", "pub(crate) mod ", "pub(crate) use ", "#["];
    let mut complaints = Vec::new();
    let mut open = false;
    for (number, line) in file.code_lines() {
        let line = line.trim();
        if !open && !line.is_empty() && !items.iter().any(|item| line.starts_with(item)) {
            complaints.push(format!("line {number}: only docs, `mod` and `pub use` belong here"));
        }
        open = !line.is_empty() && !line.ends_with(';') && !line.ends_with(']') && {
            open || items.iter().any(|item| line.starts_with(item))
        };
    }
    complaints
}

/// Whether a path belongs to the core, which is the same everywhere (invariant 2 of `src/lib.rs`).
fn is_core(path: &str) -> bool {
    // Each a folder, or a file of that name.
    let edge = [("src/", "gpu"), ("src/", "agent"), ("src/robot/", "link"), ("src/ui/", "view")];
    let is_edge = edge.iter().any(|(under, name)| {
        let is_there = [format!("/{name}/"), format!("/{name}.rs")];
        path.starts_with(under) && is_there.iter().any(|there| path.contains(there))
    });
    path.starts_with("src/") && path.ends_with(".rs") && !path.starts_with("src/bin/") && !is_edge
}

/// Says so when the core asks where it is built, but for tests and the lines that admit a wasm-only file.
pub(super) fn cfg_only_at_the_edge(file: &File) -> Vec<String> {
    if !is_core(&file.path) {
        return Vec::new();
    }
    let lines: Vec<&str> = file.text.lines().map(str::trim).collect();
    let folder = file.path.rsplit_once('/').map_or("", |(folder, _)| folder);
    let admits = |number: usize| {
        let module = lines.get(number).and_then(|line| module_named(line));
        lines.get(number - 1) == Some(&"#[cfg(target_arch = \"wasm32\")]")
            && module.is_some_and(|name| !is_core(&format!("{folder}/{name}.rs")))
    };
    let mut complaints = Vec::new();
    for (number, line) in file.code.lines().enumerate().map(|(index, line)| (index + 1, line)) {
        let asks =
            ["cfg(", "cfg!", "cfg_attr", "cfg_select"].iter().any(|word| has_word(line, word));
        if asks && !line.trim().starts_with("#[cfg(test)]") && !admits(number) {
            complaints.push(format!("line {number}: `cfg` in the core: {}", line.trim()));
        }
    }
    complaints
}

/// The module that a line declares, or of which it hands on a name.
fn module_named(line: &str) -> Option<&str> {
    let item = line.trim_start_matches("pub(crate) ").trim_start_matches("pub ");
    let declared = item.strip_prefix("mod ").and_then(|item| item.strip_suffix(';'));
    declared.or_else(|| Some(item.strip_prefix("use ")?.split_once("::")?.0))
}

/// Says so when the core reaches for a clock, a thread, the system or the console, or for maths that
/// differs between machines.
pub(super) fn core_is_pure(file: &File) -> Vec<String> {
    const SYSTEM: [&str; 22] = [
        "std::time",
        "std::thread",
        "std::env",
        "std::fs",
        "std::net",
        "std::process",
        "std::io::stdin",
        "std::io::stdout",
        "std::io::stderr",
        "Instant",
        "SystemTime",
        "getrandom",
        "thread_rng",
        "OsRng",
        "StdRng",
        "rand::rng",
        "RandomState",
        "println!",
        "print!",
        "eprintln!",
        "eprint!",
        "include!",
    ];
    const HASHES: [&str; 2] = ["HashMap", "HashSet"];
    const MATHS: [&str; 24] = [
        "powf(",
        "powi(",
        "exp(",
        "exp2(",
        "exp_m1(",
        "ln(",
        "ln_1p(",
        "log(",
        "log2(",
        "log10(",
        "sin(",
        "cos(",
        "tan(",
        "asin(",
        "acos(",
        "atan(",
        "atan2(",
        "sinh(",
        "cosh(",
        "tanh(",
        "cbrt(",
        "hypot(",
        "mul_add(",
        "algebraic_add(",
    ];
    if !is_core(&file.path) {
        return Vec::new();
    }
    let mut complaints = Vec::new();
    for (number, line) in file.code_lines() {
        if let Some(word) = SYSTEM.iter().find(|word| has_word(line, word)) {
            complaints.push(format!("line {number}: {word} in the core"));
        }
        if let Some(word) = HASHES.iter().find(|word| has_word(line, word)) {
            complaints
                .push(format!("line {number}: {word} is seeded by the system; take Fx{word}"));
        }
        let method = |name: &&&str| {
            line.contains(&format!(".{name}"))
                || line.contains(&format!("f64::{name}"))
                || line.contains(&format!("f32::{name}"))
        };
        if let Some(name) = MATHS.iter().find(method) {
            let name = name.trim_end_matches('(');
            complaints.push(format!("line {number}: {name} differs between machines; take libm's"));
        }
    }
    complaints
}

/// Says so when learning reaches for a planner, but in the baseline that is there to be compared against
/// (invariant 5).
pub(super) fn learning_never_plans(file: &File) -> Vec<String> {
    if !file.path.starts_with("src/learn/") || file.path == "src/learn/planning.rs" {
        return Vec::new();
    }
    let plans = |(_, line): &(usize, &str)| line.contains("plan::") || has_word(line, "AStar");
    let complaint = |(number, _)| format!("line {number}: a planner in learning");
    file.code_lines().filter(plans).map(complaint).collect()
}

/// Says so when names come in by the handful.
pub(super) fn no_globs(file: &File) -> Vec<String> {
    if file.ending() != "rs" {
        return Vec::new();
    }
    file.code
        .lines()
        .enumerate()
        .filter(|(_, line)| line.contains("::*") || line.contains("{*}"))
        .map(|(index, line)| format!("line {}: glob: {}", index + 1, line.trim()))
        .collect()
}

/// Says so when something was left for later.
pub(super) fn nothing_left_for_later(file: &File) -> Vec<String> {
    if file.ending() != "rs" {
        return Vec::new();
    }
    let loose =
        ["todo!", "unimplemented!", "dbg!", "#[ignore", "#![allow(dead_code", "#[allow(dead_code"];
    let mut complaints = Vec::new();
    for (index, line) in file.code.lines().enumerate() {
        for word in loose.iter().filter(|word| has_word(line, word)) {
            complaints.push(format!("line {}: {word}", index + 1));
        }
    }
    complaints
}

/// Says so when a file names a package registry or a path of somebody's machine.
pub(super) fn names_no_machine(file: &File) -> Vec<String> {
    // Written in halves, so that this file does not name them itself.
    const HOSTS: [(&str, &str); 8] = [
        ("crates", ".io"),
        ("npmjs", ".org"),
        ("npmjs", ".com"),
        ("yarnpkg", ".com"),
        ("pypi", ".org"),
        ("deb.debian", ".org"),
        ("proxy.golang", ".org"),
        ("unpkg", ".com"),
    ];
    const PATHS: [(&str, &str); 6] = [
        ("/wo", "rk/"),
        ("/ro", "ot/"),
        ("/tm", "p/"),
        ("/ho", "me/"),
        ("/Us", "ers/"),
        ("file:", "///"),
    ];
    let mut complaints = Vec::new();
    for (index, line) in file.text.lines().enumerate() {
        // Cargo itself writes this name of its index into every lock file.
        let cargo = file.path == "Cargo.lock" && line.starts_with("source = \"registry+");
        for (a, b) in HOSTS.iter().filter(|_| !cargo) {
            if line.contains(&format!("{a}{b}")) {
                complaints.push(format!("line {}: names a registry, {a}{b}", index + 1));
            }
        }
        for (a, b) in PATHS {
            let path = format!("{a}{b}");
            let found = line.match_indices(&path).any(|(at, _)| {
                let before = line.get(..at).unwrap_or_default().chars().next_back();
                !before.is_some_and(|c| c.is_alphanumeric() || "_-.})$*".contains(c))
            });
            if found {
                complaints.push(format!("line {}: a machine's path, {path}", index + 1));
            }
        }
    }
    complaints
}

/// Says so when a flow checks what it has looked at once, before the page may have redrawn: a check is given how to look,
/// and is awaited.
pub(super) fn flows_wait(file: &File) -> Vec<String> {
    if !file.path.starts_with("tests/e2e/flows/") {
        return Vec::new();
    }
    let mut complaints = Vec::new();
    for (index, line) in file.text.lines().enumerate() {
        for (at, call) in ["t.check(", "t.equal("].iter().flat_map(|call| line.match_indices(call))
        {
            let (before, after) = (&line[..at], &line[at + call.len()..]);
            let before = before.trim_end_matches("demo.");
            let is_awaited = ["await ", "=> ", "return "].iter().any(|word| before.ends_with(word));
            let looks_once = after.trim_start_matches('(').starts_with("await ");
            // A draw is an action, and not to be done again.
            if !is_awaited || looks_once && !after.contains("await draw(") {
                complaints.push(format!("line {}: this check does not wait", index + 1));
            }
        }
    }
    complaints
}

/// Says so when a crate of the browser is linked natively.
pub(super) fn browser_crates_are_wasm_only(file: &File) -> Vec<String> {
    const BROWSER: [&str; 6] = ["wasm-bindgen", "web-sys", "js-sys", "yew", "wgpu", "gloo"];
    if file.path != "Cargo.toml" {
        return Vec::new();
    }
    let mut native = false;
    let mut complaints = Vec::new();
    for (index, line) in file.text.lines().enumerate() {
        if line.starts_with('[') {
            native = line.contains("dependencies") && !line.contains("wasm32");
        }
        if native && BROWSER.iter().any(|name| line.starts_with(name)) {
            complaints.push(format!("line {}: for the browser only: {line}", index + 1));
        }
    }
    complaints
}

/// Whether `word` stands in `line` and is not the tail of a longer name.
fn has_word(line: &str, word: &str) -> bool {
    line.match_indices(word).any(|(at, _)| {
        let before = line.get(..at).unwrap_or_default().chars().next_back();
        let after = line.get(at + word.len()..).unwrap_or_default().chars().next();
        let name = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
        !(name(before) || name(after) && name(word.chars().next_back()))
    })
}
