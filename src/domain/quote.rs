//! Names in quotes, as JSON writes strings. A parser of all of JSON for what stands in a legend once in a while would
//! weigh eight kilobytes in what every visitor loads.

/// A name in quotes.
pub(super) fn quoted(name: &str) -> String {
    let mut out = String::from("\"");
    for c in name.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            '\n' => out.push_str("\\n"),
            c if c.is_control() => out.push_str(&format!("\\u{:04x}", u32::from(c))),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

/// The name that stands in quotes.
///
/// # Errors
/// What is wrong with it.
pub(super) fn unquoted(text: &str) -> Result<String, &'static str> {
    let mut rest = text.strip_prefix('"').ok_or("it does not begin with a quote")?.chars();
    let mut name = String::new();
    loop {
        match rest.next().ok_or("it does not end with a quote")? {
            '"' => break,
            '\\' => name.push(escaped(&mut rest).ok_or("there is no such escape")?),
            c => name.push(c),
        }
    }
    if rest.as_str().is_empty() { Ok(name) } else { Err("something stands behind its quote") }
}

/// The letter behind a backslash.
fn escaped(rest: &mut std::str::Chars<'_>) -> Option<char> {
    Some(match rest.next()? {
        'n' => '\n',
        't' => '\t',
        'r' => '\r',
        'b' => '\u{8}',
        'f' => '\u{c}',
        'u' => {
            let digits = rest.as_str().get(..4)?;
            *rest = rest.as_str().get(4..)?.chars();
            char::from_u32(u32::from_str_radix(digits, 16).ok()?)?
        }
        c @ ('"' | '\\' | '/') => c,
        _ => return None,
    })
}
