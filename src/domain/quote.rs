//! Names between quotation marks, as JSON has them, without the whole of JSON: what every visitor loads draws worlds as
//! text, and reads no other JSON.

/// A name between quotation marks, as JSON has it: what no person could read or tell apart is escaped.
pub(super) fn quoted(name: &str) -> String {
    let each = |c: char| match c {
        '"' | '\\' => format!("\\{c}"),
        c if c.is_control() => format!("\\u{:04x}", u32::from(c)),
        c => c.to_string(),
    };
    format!("\"{}\"", name.chars().map(each).collect::<String>())
}

/// The name between quotation marks; `None` when they do not fit, or something is escaped that need not be.
pub(super) fn unquoted(text: &str) -> Option<String> {
    let mut name = String::new();
    let mut rest = text.strip_prefix('"')?.strip_suffix('"')?.chars();
    while let Some(c) = rest.next() {
        name.push(match c {
            '"' => return None,
            '\\' => match rest.next()? {
                'u' => {
                    let code = rest.as_str().get(..4)?;
                    rest = rest.as_str().get(4..)?.chars();
                    char::from_u32(u32::from_str_radix(code, 16).ok()?)?
                }
                c @ ('"' | '\\') => c,
                _ => return None,
            },
            c => c,
        });
    }
    Some(name)
}
