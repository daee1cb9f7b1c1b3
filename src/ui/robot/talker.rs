//! Where the engine that talks is: the front page names its program, by a name that changes with every build.

/// Script and program of the front page, as its text names them.
pub fn named(page: &str) -> Option<(&str, &str)> {
    Some((link(page, "script")?, link(page, "program")?))
}

/// What the link of this name refers to. Attributes stand in any order, in quotes or without.
fn link<'a>(page: &'a str, name: &str) -> Option<&'a str> {
    let tags = page.split('<').filter_map(|tag| tag.strip_prefix("link"));
    let mut tags = tags.filter_map(|tag| tag.split('>').next());
    let tag = tags.find(|tag| attribute(tag, "data-app") == Some(name))?;
    attribute(tag, "href")
}

fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    let value = tag.split_once(&format!("{name}="))?.1;
    match value.strip_prefix('"') {
        Some(quoted) => quoted.split('"').next(),
        None => value.split_whitespace().next(),
    }
}
