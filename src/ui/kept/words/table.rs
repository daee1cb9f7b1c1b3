//! What a language has to have a word for where what is kept is listed.

/// The words of a language.
#[expect(missing_docs, reason = "the English table says what each is")]
pub struct Text {
    pub title: &'static str,
    pub about: &'static str,
    pub nothing: &'static str,
    pub what: &'static str,
    pub when: &'static str,
    pub size: &'static str,
    pub kinds: [(&'static str, &'static str); 9],
    pub save: &'static str,
    pub delete: &'static str,
    pub delete_all: &'static str,
    pub deleted: &'static str,
}

impl Text {
    /// What is kept of a kind under a name.
    pub fn item(&self, kind: &str, name: &str) -> String {
        let known = |wanted: &str| self.kinds.iter().find(|(known, _)| *known == wanted);
        match (kind, known(name), known(kind)) {
            ("session", Some((_, words)), _)
            | ("session", None, Some((_, words)))
            | ("robot", _, Some((_, words))) => (*words).to_owned(),
            (_, _, Some((_, words))) => format!("{words}: {name}"),
            (..) => format!("{kind} {name}"),
        }
    }
}
