//! The words about what is kept in English; what each word is for stands here for all languages.

use super::table::Text;
use crate::ui::page::keep::fault::Fault;
use crate::ui::train::kept::state::Kind;

/// The words.
pub(super) static ENGLISH: Text = Text {
    title: "Kept on this machine",
    help: "A run is kept by itself every few seconds, with its corpus, and goes on where it was when the page is opened again. What an experiment found is kept by itself. Corpora and models are kept when you say so. All of it stays in this browser, which may clear it when its disk is full or when you clear its data: save as a file what you must not lose.",
    name: "Name",
    keep_corpus: "Keep the corpus",
    keep_model: "Keep the robot’s model",
    nothing: "Nothing is kept yet.",
    kind: |kind| match kind {
        Kind::Corpus => "Corpus",
        Kind::Run => "Run",
        Kind::Experiment => "Experiment",
        Kind::Model => "Model",
    },
    what: "What",
    called: "Name",
    when: "Last changed",
    size: "Size",
    open: "Open",
    save: "Save as a file",
    delete: "Delete",
    sum: |n, size| format!("{n} kept, {size} in all, two copies of what has changed counted."),
    keep_here: "Keep runs in this tab instead",
    deleted: |name| format!("“{name}” is deleted."),
    written: |name| format!("“{name}” is kept."),
    opened: |name| format!("“{name}” is open."),
    was_damaged: |name| {
        format!(
            "What was written last of “{name}” is damaged: it is open as it was a little before."
        )
    },
    gone: |name| {
        format!(
            "“{name}” is not kept any more: the browser has cleared it, or another tab has deleted it."
        )
    },
    no_corpus: |corpus| {
        format!(
            "The corpus “{corpus}” of this run is not kept any more. Open its files again under Data to see its rows or to go on with the run."
        )
    },
    wrong: |name, why| format!("“{name}” cannot be opened: {why}."),
    is_back: |name| format!("The run “{name}” is here again, with its corpus."),
    goes_on: |name, pass, command| {
        format!("The run “{name}” goes on where it was: pass {pass}, command {command}.")
    },
    fault: |fault| {
        match fault {
        Fault::None => "This browser keeps nothing for this page, as in a private window: a run is lost when the page is closed. Save models and corpora as files.".to_owned(),
        Fault::Newer => "What is kept was written by a newer build of this page: nothing is kept until you load the page again.".to_owned(),
        Fault::Older => "An older build of this page is open in another tab and holds what is kept. Close that tab: this one goes on by itself.".to_owned(),
        Fault::Full => "There is no room left in this browser for this. Nothing that is kept is lost. Delete something here, or save a file.".to_owned(),
        Fault::Damaged => "It is damaged, both copies of it.".to_owned(),
        Fault::Elsewhere => "Another tab has the workbench open and keeps its runs. A run of this tab is lost when it is closed.".to_owned(),
        Fault::Other(words) => format!("It is not kept: the browser says “{words}”."),
    }
    },
    run_fault: |fault, reached| {
        let why = match fault {
            Fault::Full => {
                "There is no room left in this browser: the run goes on, but is not kept any more."
                    .to_owned()
            }
            other => (ENGLISH.fault)(other),
        };
        match reached {
            Some((pass, command)) => format!(
                "{why} It is kept as it was at pass {pass}, command {command}; what it has learned since would be lost with the page."
            ),
            None => {
                format!("{why} Nothing of it is kept yet: all of it would be lost with the page.")
            }
        }
    },
};
