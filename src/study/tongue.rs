//! Which language a command is in, as far as a person who reviews wants it pointed out: by the small words that a
//! language cannot do without, and by its letters. Short commands may tell nothing.

/// Small words of languages, those of the study's two first.
const WORDS: [(&str, &str); 6] = [
    (
        "en",
        "the a an to of in into on and is it its then move go put bring take with near next from room robot block chair",
    ),
    (
        "de",
        "der die das den dem ein eine einen in im ins zu zum zur und ist mit auf neben geh gehe bring bringe raum zimmer",
    ),
    ("fr", "le la les un une des du de dans et est avec sur vers pièce chambre va mets apporte"),
    ("es", "el la los las un una en de del al y es con hacia habitación cuarto ve mueve lleva"),
    ("it", "il lo la gli le un una di del nella nel e con verso stanza vai porta sposta"),
    ("pt", "o a os as um uma de do da no na e com para quarto sala vá leve mova"),
];

/// Whether words seem to be of another language than this one: two small words more are of another, or most letters are
/// none of Latin.
pub(super) fn is_foreign(language: &str, words: &str) -> bool {
    let lower = words.to_lowercase();
    let letters = lower.chars().filter(|c| c.is_alphabetic());
    let is_latin = |c: char| c < '\u{250}' || ('\u{1e00}'..'\u{1f00}').contains(&c);
    let (all, other) =
        letters.fold((0, 0), |(all, other), c| (all + 1, other + u32::from(!is_latin(c))));
    if all > 0 && other * 2 > all {
        return true;
    }
    let parts: Vec<&str> =
        lower.split(|c: char| !c.is_alphanumeric()).filter(|part| !part.is_empty()).collect();
    let count =
        |list: &str| parts.iter().filter(|part| list.split(' ').any(|word| word == **part)).count();
    let own = WORDS.iter().find(|(code, _)| *code == language).map_or(0, |(_, list)| count(list));
    let best = WORDS.iter().map(|(_, list)| count(list)).max().unwrap_or(0);
    best >= own + 2
}
