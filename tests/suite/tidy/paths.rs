//! The paths that Rust code names: those of its `use` lines, each with the name that it brings in, and those that stand
//! in the code itself.

use super::file::{File, is_word};

/// A path, a name a part: `crate::logic::Ty` has three.
pub(super) type Path = Vec<String>;

/// What a file names.
#[derive(Debug, Default)]
pub(super) struct Paths {
    /// What its `use` lines bring in, and under which name.
    pub(super) uses: Vec<(Path, String)>,
    /// Paths of two names or more, as they stand in the code.
    pub(super) code: Vec<Path>,
}

impl Paths {
    /// What a file names, but for the test module that it may end with. A module that stands inside the file is read as
    /// part of it.
    pub(super) fn of(file: &File) -> Paths {
        let code: Vec<&str> = file.code_lines().map(|(_, line)| line).collect();
        let code = code.join("\n");
        let tokens = tokens(&code);
        let mut paths = Paths::default();
        let mut rest = tokens.as_slice();
        let mut before = "";
        while let [first, after @ ..] = rest {
            // `use<'a>` is a bound, no import.
            rest = if *first == "use" && after.first() != Some(&"<") {
                tree(&[], after, &mut paths.uses)
            } else if is_name(first) && ![".", "::", "$"].contains(&before) {
                let (path, after) = plain(rest);
                paths.code.extend((path.len() > 1).then_some(path));
                after
            } else {
                after
            };
            let taken = tokens.len() - rest.len();
            before = tokens.get(taken - 1).copied().unwrap_or_default();
        }
        paths
    }

    /// All of them.
    pub(super) fn all(&self) -> impl Iterator<Item = &Path> {
        self.uses.iter().map(|(path, _)| path).chain(&self.code)
    }
}

/// Reads the `use` tree that `rest` begins with; returns what follows it.
fn tree<'a, 'b>(
    prefix: &[String],
    rest: &'b [&'a str],
    uses: &mut Vec<(Path, String)>,
) -> &'b [&'a str] {
    let (mut path, mut rest) = (prefix.to_vec(), rest);
    while let [first, after @ ..] = rest {
        match *first {
            "::" => rest = after,
            "{" => {
                rest = after;
                while let [first, ..] = rest
                    && *first != "}"
                {
                    rest = tree(&path, rest, uses);
                    rest = rest.strip_prefix(&[","]).unwrap_or(rest);
                }
                return rest.get(1..).unwrap_or_default();
            }
            "self" if !path.is_empty() => rest = after,
            name if is_name(name) && name != "as" => {
                path.push(name.to_owned());
                rest = after;
            }
            _ => break,
        }
    }
    let own = path.last().cloned().unwrap_or_default();
    match rest {
        ["as", name, after @ ..] => {
            uses.push((path, (*name).to_owned()));
            after
        }
        [";", after @ ..] => {
            uses.push((path, own));
            after
        }
        [first, after @ ..] if ![",", "}"].contains(first) => {
            // A glob: whatever the module has.
            uses.push((path, "*".to_owned()));
            after
        }
        _ => {
            uses.push((path, own));
            rest
        }
    }
}

/// The path that `rest` begins with, and what follows it.
fn plain<'a, 'b>(rest: &'b [&'a str]) -> (Path, &'b [&'a str]) {
    let mut path = Path::new();
    let mut rest = rest;
    while let [name, after @ ..] = rest
        && is_name(name)
    {
        path.push((*name).to_owned());
        rest = after;
        match rest {
            ["::", after @ ..] if after.first().is_some_and(|name| is_name(name)) => rest = after,
            _ => break,
        }
    }
    (path, rest)
}

/// Names, `::`, and single signs.
fn tokens(code: &str) -> Vec<&str> {
    let mut tokens = Vec::new();
    let mut rest = code.trim_start();
    while let Some(first) = rest.chars().next() {
        let length = match rest.find(|c: char| !is_word(c)) {
            Some(0) if rest.starts_with("::") => 2,
            Some(0) => first.len_utf8(),
            Some(length) => length,
            None => rest.len(),
        };
        let (token, after) = rest.split_at(length);
        tokens.push(token);
        rest = after.trim_start();
    }
    tokens
}

fn is_name(token: &str) -> bool {
    token.starts_with(is_word)
}

#[test]
fn paths_are_those_of_use_lines_and_of_code() {
    let text = "pub(crate) use a::{self, b::{C, D as E}, f::*,};\nuse super::g;\nuse crate::{h, i};\n\
                fn f(x: &'a impl T + use<'_>) -> g::\n    H { $crate::skip::it(); x.b::<i::J>(super::k::l()) }\n\
                // m::n\n#[cfg(test)]\nmod tests { o::p() }";
    let paths = Paths::of(&File::new("src/a.rs", text));
    let shown = |path: &Path| path.join("::");
    let uses: Vec<String> =
        paths.uses.iter().map(|(path, name)| format!("{} {name}", shown(path))).collect();
    assert_eq!(
        uses,
        ["a a", "a::b::C C", "a::b::D E", "a::f *", "super::g g", "crate::h h", "crate::i i"]
    );
    let code: Vec<String> = paths.code.iter().map(shown).collect();
    assert_eq!(code, ["g::H", "i::J", "super::k::l"]);
}
