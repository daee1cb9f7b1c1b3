//! Values in Python's notation, as `repr` writes them: texts, numbers, lists, tuples, dictionaries, `None`, `True`. What
//! is none of these is a text as it stands.

use serde_json::{Map, Value};

/// The deepest that lists and dictionaries are read.
const DEPTH: usize = 32;

/// The value that a text stands for.
pub(super) fn value(text: &str) -> Value {
    let mut reader = Reader { rest: text.trim() };
    match reader.value(0) {
        Some(value) if reader.rest.trim().is_empty() => value,
        _ => Value::String(text.to_owned()),
    }
}

struct Reader<'a> {
    rest: &'a str,
}

impl Reader<'_> {
    fn value(&mut self, depth: usize) -> Option<Value> {
        self.rest = self.rest.trim_start();
        if depth > DEPTH {
            return None;
        }
        match self.rest.chars().next()? {
            '[' => Some(Value::Array(self.list('[', ']', depth)?)),
            '(' => Some(Value::Array(self.list('(', ')', depth)?)),
            '{' => self.dictionary(depth),
            '\'' | '"' => self.text().map(Value::String),
            'u' | 'b' if self.rest[1..].starts_with(['\'', '"']) => {
                self.rest = &self.rest[1..];
                self.text().map(Value::String)
            }
            _ => self.word(),
        }
    }

    fn word(&mut self) -> Option<Value> {
        let end = self.rest.find([',', ']', ')', '}', ':', ' ']).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        match word {
            "None" => Some(Value::Null),
            "True" => Some(Value::Bool(true)),
            "False" => Some(Value::Bool(false)),
            _ => serde_json::from_str(word.trim_end_matches('L')).ok(),
        }
    }

    /// Goes over a sign, if it comes next.
    fn takes(&mut self, sign: char) -> bool {
        self.rest = self.rest.trim_start();
        match self.rest.strip_prefix(sign) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn list(&mut self, open: char, close: char, depth: usize) -> Option<Vec<Value>> {
        let mut all = Vec::new();
        self.takes(open);
        loop {
            if self.takes(close) {
                return Some(all);
            }
            all.push(self.value(depth + 1)?);
            if !self.takes(',') {
                return self.takes(close).then_some(all);
            }
        }
    }

    fn dictionary(&mut self, depth: usize) -> Option<Value> {
        let mut all = Map::new();
        self.takes('{');
        loop {
            if self.takes('}') {
                return Some(Value::Object(all));
            }
            let key = match self.value(depth + 1)? {
                Value::String(key) => key,
                other => other.to_string(),
            };
            if !self.takes(':') {
                return None;
            }
            all.insert(key, self.value(depth + 1)?);
            if !self.takes(',') {
                return self.takes('}').then_some(Value::Object(all));
            }
        }
    }

    fn text(&mut self) -> Option<String> {
        let mut chars = self.rest.char_indices();
        let (_, quote) = chars.next()?;
        let mut out = String::new();
        while let Some((at, c)) = chars.next() {
            if c == quote {
                self.rest = &self.rest[at + c.len_utf8()..];
                return Some(out);
            }
            if c != '\\' {
                out.push(c);
                continue;
            }
            let (_, escaped) = chars.next()?;
            let digits = match escaped {
                'n' => {
                    out.push('\n');
                    0
                }
                't' => {
                    out.push('\t');
                    0
                }
                'r' => {
                    out.push('\r');
                    0
                }
                'x' => 2,
                'u' => 4,
                'U' => 8,
                other => {
                    out.push(other);
                    0
                }
            };
            if digits > 0 {
                let hex: String = (0..digits).map_while(|_| chars.next()).map(|(_, c)| c).collect();
                out.push(u32::from_str_radix(&hex, 16).ok().and_then(char::from_u32)?);
            }
        }
        None
    }
}
