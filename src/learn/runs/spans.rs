//! Numbers of rows as a short text: `0-4,7,9-12`, ascending.

/// Ascending numbers as a text.
pub fn write(rows: &[u32]) -> String {
    let mut spans: Vec<(u32, u32)> = Vec::new();
    for &row in rows {
        match spans.last_mut() {
            Some((_, last)) if *last + 1 == row => *last = row,
            _ => spans.push((row, row)),
        }
    }
    let text = |&(first, last): &(u32, u32)| match first == last {
        true => first.to_string(),
        false => format!("{first}-{last}"),
    };
    spans.iter().map(text).collect::<Vec<_>>().join(",")
}

/// The numbers of a text, which must all be below `end`; nothing where it is no such text.
pub fn read(text: &str, end: u32) -> Option<Vec<u32>> {
    let mut rows = Vec::new();
    for span in text.split(',').filter(|span| !span.is_empty()) {
        let (first, last) = span.split_once('-').unwrap_or((span, span));
        let (first, last): (u32, u32) = (first.parse().ok()?, last.parse().ok()?);
        let follows = rows.last().is_none_or(|&before| before < first);
        if !follows || last < first || last >= end {
            return None;
        }
        rows.extend(first..=last);
    }
    Some(rows)
}
