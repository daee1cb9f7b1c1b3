//! The words about training in English; what each word is for stands here for all languages.

use super::duration::duration;
use super::table::Text;
use crate::ui::page::document::{Model, Origin};
use crate::ui::train::run::action::Number;
use crate::worker::protocol::FeatureKind;

/// The words.
pub(super) static ENGLISH: Text = Text {
    training: "Train a parser",
    train: "Train",
    go_on: "Go on",
    pause: "Pause",
    pausing: "Pausing…",
    step_example: "One example",
    step_epoch: "To the end of the pass",
    stop: "Stop",
    resume: "Go on where it was stopped",
    use_so_far: "Use the model so far",
    help: |n, settings| {
        let more = if settings.idioms { ", and one more that looks for idioms" } else { "" };
        format!(
            "It can learn from {n} commands, each shown with the room before and after, in {} passes{more}.",
            settings.epochs
        )
    },
    beginning: "Beginning…",
    begun: "Training has begun.",
    stopped: "Training was stopped. The robot's model is as it was.",
    rests: "Training rests.",
    trained: |valid, n| {
        format!(
            "Trained: {valid} of {n} commands have a valid meaning. The robot uses the new model."
        )
    },
    at: |p| {
        format!(
            "Pass {} of {}, command {} of {}. {} with a valid meaning, {} updates, {} entries in the lexicon.",
            p.epoch, p.epochs, p.example, p.examples, p.valid, p.updates, p.entries
        )
    },
    times: |worked, left| {
        let worked = duration(worked);
        match left {
            Some(left) => format!("{worked} so far, about {} left.", duration(left)),
            None => format!("{worked} so far."),
        }
    },
    model_is: |model: &Model| {
        let report = &model.report;
        let origin = match &model.origin {
            Origin::Shipped => "the model that comes with this page".to_owned(),
            Origin::Trained(corpus) => format!("a model trained here on {corpus}"),
            Origin::File => "a model from a file".to_owned(),
        };
        format!(
            "The robot uses {origin}: {} of {} commands have a valid meaning, {} entries in its lexicon.",
            report.valid, report.examples, report.entries
        )
    },
    open_model: "Open a model",
    save_model: "Save the model",

    // Settings.
    settings: "Settings",
    paper: "The paper's settings",
    are_paper: "These are the paper's.",
    number: |number| match number {
        Number::Epochs => "Passes",
        Number::Beam => "Beam",
        Number::LexicalBeam => "Beam of lexical generation",
        Number::Demonstrations => "Demonstrations a command (0: all)",
        Number::Margin => "Margin",
        Number::Seed => "Seed of the order",
        Number::Budget => "Derivations tried in a chart",
        Number::LexicalBudget => "The same in lexical generation",
        Number::Generations => "Passes with new entries",
    },
    idioms: "Commands that recur may become idioms",
    lexicon: "Known before",
    lexicons: [
        "what suits the corpus",
        "a few function words (Section VII)",
        "the English of the domain",
    ],
    own_lexicon: "Own lexicon file",
    no_lexicon: |name| format!("{name} is no lexicon: a text in UTF-8 of at most 4 MB."),
    save_curves: "Save the curves as SVG",
    without: "Kinds of features left out",
    kind: |kind| match kind {
        FeatureKind::Lexeme => "words with their constants",
        FeatureKind::Template => "templates",
        FeatureKind::Entry => "entries",
        FeatureKind::Rule => "rules",
        FeatureKind::Pair => "pairs of constants",
        FeatureKind::Conjoined => "what is joined",
        FeatureKind::Alone => "constants alone",
        FeatureKind::Head => "heads",
    },

    // Curves.
    curves: "How it goes",
    held_out: "On what is held out (with 95 % intervals)",
    nothing_held_out: "Nothing is held out: under Data a share of the rows can be, and the curves then show how well the model does on it.",
    precision: "Precision",
    recall: "Recall",
    f1: "F1",
    valid: "Commands with a valid parse",
    updates: "Updates of weights",
    entries: "Entries in the lexicon",
    pass: "Pass",
    as_table: "The same as a table",

    // What is being learned.
    now: "What is being learned",
    nothing_yet: "Here the command at work is shown with its best forms, the entries that it added and the features that it moved.",
    forms: |n| format!("Forms, the best of {n}"),
    valid_in: |valid, n| format!("valid in {valid} of {n}"),
    added: "Entries added",
    moved: "Features moved",
    moved_by: "by",
    moved_to: "to",
    feature: "Feature",
};
