//! The words about what was learned in English; what each word is for stands here for all languages.

use super::table::Text;

/// The words.
pub(super) static ENGLISH: Text = Text {
    lexicon: "The lexicon",
    lexicon_help: "Of the model that was trained here or asked about the rows last, or else the robot’s. What an entry is used in is known once the model is asked.",
    search: "Words, category or meaning",
    learned_only: "Only what was learned",
    words: "Words",
    category: "Category",
    meaning: "Meaning",
    weight: "Weight",
    uses: "Rows",
    from: "Learned from",
    example: "For example",
    open_row: |row| format!("Open row {row}"),
    seed: "known before",
    pick: |words| format!("Pick the entry of {words}"),
    nothing_learned: "Nothing was learned beyond what was known before: it knew all the words.",
    no_entry: "No entry holds this.",
    shown: |from, to, of| format!("{from} to {to} of {of} entries"),
    before: "Before",
    next: "Next",
    leave_out: |n| format!("Let the robot use the model without {n} entries"),
    without: |n| format!("the corpus, without {n} entries"),

    // Errors.
    errors: "Where it errs",
    no_errors: "Ask a model about every row under Data: then the worst commands, the unknown words and the features that decided wrongly stand here.",
    errs_nowhere: "Every row is answered as it was shown.",
    worst: "Commands that fail most",
    command: "Command",
    right: "Right",
    best_form: "Best form",
    unknown: "Unknown words",
    deciders: "Features that decided wrongly",
    feature: "Feature",
    by: "By",
    confusion: "What wrong answers did instead, on what is held out",
    task: "Task",
    does: "Did",
    nothing: "none",
    count: "Times",

    // Two models.
    compare: "Hold the robot's model against another",
    compare_with: "Choose a model file",
    no_model: |name| format!("{name} is no model file."),
    compared: "The models are compared.",
    robots: "The robot's",
    alone: |name, n| format!("{n} entries of {name} alone"),
    common: |n| format!("{n} entries of both"),
    moved: "Weights that differ most",
};
