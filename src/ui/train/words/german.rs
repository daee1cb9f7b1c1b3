//! The Train page in German.

use super::table::Text;
use crate::ui::page::document::{Model, Origin};
use crate::ui::page::files::Fault;
use crate::ui::page::grammar::German;

/// The words.
pub(super) static GERMAN: Text = Text {
    phrases: &German,

    training: "Einen Parser trainieren",
    begin_training: "Trainieren",
    cancel: "Abbrechen",
    train_help: |n, epochs| {
        format!(
            "Er kann aus {n} Befehlen lernen, jeder gezeigt mit dem Raum vorher und nachher, in {epochs} Durchgängen."
        )
    },
    beginning: "Beginnt…",
    training_begun: "Das Training hat begonnen.",
    training_stopped: "Das Training wurde abgebrochen. Was vorher da war, ist wie es war.",
    training_at: |p| {
        format!(
            "Durchgang {} von {}, Befehl {} von {}. {} mit gültiger Bedeutung, {} Einträge im Lexikon.",
            p.epoch, p.epochs, p.example, p.examples, p.valid, p.entries
        )
    },
    trained: |valid, n| {
        format!("Trainiert: {valid} von {n} Befehlen haben eine gültige Bedeutung.")
    },
    model_is: |model: &Model| {
        let report = &model.report;
        let origin = match &model.origin {
            Origin::Shipped => "das Modell zu dieser Seite".to_owned(),
            Origin::Trained(corpus) => format!("ein hier auf {corpus} trainiertes Modell"),
            Origin::File => "ein Modell aus einer Datei".to_owned(),
        };
        format!(
            "In Gebrauch: {origin}. {} von {} Befehlen haben eine gültige Bedeutung, {} Einträge im Lexikon.",
            report.valid, report.examples, report.entries
        )
    },
    open_model: "Ein Modell öffnen",
    save_model: "Das Modell sichern",

    corpus: "Woraus er lernt",
    open_corpus: "Einen Korpus öffnen",
    corpus_hint: "oder Dateien irgendwo fallen lassen: CSV mit Antworten oder JSON-Zeilen",
    corpus_open: |name, n| format!("{name} ist offen: {n} Befehle."),
    no_rows: |name| format!("Keine Zeile von {name} ist brauchbar. Was offen war, ist noch offen."),
    commands: |n| format!("{n} Befehle"),
    rejected: |n| format!(", {n} abgelehnte Zeilen ausgelassen"),
    left_out: |n| format!(", {n} fehlerhafte Zeilen ausgelassen"),
    use_rejected: "Abgelehnte Zeilen auch verwenden",
    reading_stopped: "Das Lesen wurde angehalten. Was offen war, ist noch offen.",
    problems: |n| format!(", {n} Probleme"),
    rows_to_look_at: |n| format!("{n} Zeilen zum Ansehen"),
    save_corpus: "Diese Datei sichern",
    six_sentences: "Zurück zu den sechs Sätzen",
    more_rows: |n| format!("Mehr zeigen (noch {n})"),
    demonstrations: |n| {
        if n == 1 { "1 Vorführung".to_owned() } else { format!("{n} Vorführungen") }
    },
    demonstration: |n| format!("Vorführung {n}, vorher:"),
    after: "Nachher:",
    reading_row: "Wird gelesen…",
    line: |n| format!("Zeile {n}"),
    file: "Datei",
    row_kept: " · Zeile behalten",
    and_more: |n| format!("und {n} weitere"),
    file_fault: |name, fault| match fault {
        Fault::Empty => {
            format!("{name} ist leer. Wähle eine Datei mit Kopfzeile und mindestens einer Zeile.")
        }
        Fault::TooLarge => {
            format!("{name} ist größer als 64 MB. Teile sie und öffne einen Teil nach dem anderen.")
        }
        Fault::Unreadable => format!(
            "{name} ließ sich nicht lesen. Sieh nach, ob sie noch da ist, und wähle sie neu."
        ),
        Fault::NotText(line) => format!(
            "{name} ist kein Text in UTF-8 (zuerst in Zeile {line}). Sichere sie als UTF-8, oder wähle die CSV-Datei selbst, keine Tabelle und kein Archiv."
        ),
    },
};
