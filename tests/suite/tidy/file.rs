//! The project's own text files as the tidiness rules see them: path, text, and for Rust the code alone.

use std::path::Path;

/// Folders that hold what was made or fetched, never what was written.
const NOT_OURS: [&str; 5] = [".git", "target", "dist", "node_modules", "proptest-regressions"];

/// One text file.
pub(super) struct File {
    /// Path from the top of the repository, with `/`.
    pub(super) path: String,
    /// All of it.
    pub(super) text: String,
    /// The text with comments and literals blanked out (same lines, same columns); for Rust only.
    pub(super) code: String,
}

impl File {
    pub(super) fn new(path: &str, text: &str) -> Self {
        let code = if path.ends_with(".rs") { code_of(text) } else { text.to_owned() };
        Self { path: path.to_owned(), text: text.to_owned(), code }
    }

    /// The lines of the code from 1, up to the test module that a file may end with.
    pub(super) fn code_lines(&self) -> impl Iterator<Item = (usize, &str)> {
        let end = self.code.find("#[cfg(test)]\nmod tests").unwrap_or(self.code.len());
        let code = self.code.get(..end).unwrap_or(&self.code);
        code.lines().enumerate().map(|(index, line)| (index + 1, line))
    }

    pub(super) fn ending(&self) -> &str {
        self.path.rsplit_once('.').map_or("", |(_, ending)| ending)
    }
}

/// Every text file of the project, in order of path.
pub(super) fn tree() -> Vec<File> {
    let mut files = Vec::new();
    walk(Path::new(env!("CARGO_MANIFEST_DIR")), "", &mut files);
    files.sort_by(|a, b| a.path.cmp(&b.path));
    files
}

/// The names at the top of the repository.
pub(super) fn top_level() -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(env!("CARGO_MANIFEST_DIR"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| !NOT_OURS.contains(&name.as_str()))
        .collect();
    names.sort();
    names
}

fn walk(folder: &Path, prefix: &str, files: &mut Vec<File>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let entry = entry.unwrap();
        let name = entry.file_name().into_string().unwrap();
        if NOT_OURS.contains(&name.as_str()) {
            continue;
        }
        let path = format!("{prefix}{name}");
        if entry.file_type().unwrap().is_dir() {
            walk(&entry.path(), &format!("{path}/"), files);
        } else if let Ok(text) = std::fs::read_to_string(entry.path()) {
            files.push(File::new(&path, &text));
        }
    }
}

/// Rust source with comments, strings and characters turned into spaces; line breaks stay.
fn code_of(text: &str) -> String {
    let source: Vec<char> = text.chars().collect();
    let at = |i: usize| source.get(i).copied().unwrap_or('\0');
    let mut out = String::with_capacity(text.len());
    let mut i = 0;
    while i < source.len() {
        let end = match (at(i), at(i + 1)) {
            ('/', '/') => (i..source.len()).find(|&j| at(j) == '\n').unwrap_or(source.len()),
            ('/', '*') => end_of_block_comment(&source, i),
            ('"', _) => end_of_string(&source, i),
            ('r', '"' | '#') if i == 0 || !is_word(at(i - 1)) || at(i - 1) == 'b' => {
                end_of_raw_string(&source, i)
            }
            ('\'', '\\') => (i + 3..source.len()).find(|&j| at(j) == '\'').map_or(i, |j| j + 1),
            ('\'', _) if at(i + 2) == '\'' => i + 3,
            _ => i,
        };
        if end > i {
            out.extend((i..end).map(|j| if at(j) == '\n' { '\n' } else { ' ' }));
            i = end;
        } else {
            out.push(at(i));
            i += 1;
        }
    }
    out
}

/// Whether a character can stand in a name.
pub(super) fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

fn end_of_block_comment(source: &[char], start: usize) -> usize {
    let mut depth = 0;
    let mut i = start;
    while i + 1 < source.len() {
        match (source[i], source[i + 1]) {
            ('/', '*') => (depth, i) = (depth + 1, i + 2),
            ('*', '/') => (depth, i) = (depth - 1, i + 2),
            _ => i += 1,
        }
        if depth == 0 {
            return i;
        }
    }
    source.len()
}

fn end_of_string(source: &[char], start: usize) -> usize {
    let mut i = start + 1;
    while i < source.len() && source[i] != '"' {
        i += if source[i] == '\\' { 2 } else { 1 };
    }
    (i + 1).min(source.len())
}

/// The end of `r"…"` or `r#"…"#`; `start` itself where no raw string begins (`r#type`).
fn end_of_raw_string(source: &[char], start: usize) -> usize {
    let hashes = source[start + 1..].iter().take_while(|&&c| c == '#').count();
    let open = start + 1 + hashes;
    if source.get(open) != Some(&'"') {
        return start;
    }
    let closes = |j: usize| {
        source[j] == '"' && source[j + 1..].iter().take_while(|&&c| c == '#').count() >= hashes
    };
    (open + 1..source.len()).find(|&j| closes(j)).map_or(source.len(), |j| j + 1 + hashes)
}

#[test]
fn code_is_what_is_left_without_comments_and_literals() {
    let text = "let a = \"todo!()\"; // todo!()\nlet b = r#\"\"x\"\"#; /* a /* b */ c */ let c = '\"';\nfn d<'a>(e: &'a str) {}";
    let code = code_of(text);
    assert_eq!(code.lines().count(), 3);
    assert!(!code.contains("todo") && !code.contains('x') && !code.contains("b */"), "{code}");
    for kept in ["let a =", "let b =", "let c =", "fn d<'a>(e: &'a str) {}"] {
        assert!(code.contains(kept), "{kept} in {code}");
    }
}
