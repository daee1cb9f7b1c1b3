//! The words about the corpus in German.

use super::table::Text;
use crate::ui::page::files::Fault as FileFault;
use crate::ui::page::grammar::German;
use crate::ui::train::data::mapping::Column;
use crate::worker::protocol::{By, Deed, Half, Outcome, Rule, Status};

/// The words.
pub(super) static GERMAN: Text = Text {
    phrases: &German,

    corpus: "Woraus er lernt",
    open_corpus: "Einen Korpus öffnen",
    corpus_hint: "oder Dateien irgendwo fallen lassen: CSV mit Antworten, Tabellen, deren Spalten man zuordnet, JSON-Zeilen, mit gzip gepackt oder nicht. Höchstens 64 MB je Datei (entpackt), 100.000 Zeilen, 1 MB je Zelle.",
    corpus_open: |name, n| format!("{name} ist offen: {n} Befehle."),
    no_rows: |why| format!("Keine Zeile ist brauchbar, und was offen war, ist noch offen. {why}"),
    busy: "Auf dem offenen Korpus wird gerade trainiert. Erst anhalten, dann einen anderen öffnen.",
    commands: |n| format!("{n} Befehle"),
    rejected: |n| format!(", {n} abgelehnt"),
    left_out: |n| {
        format!(", {n} fehlerhafte {} ausgelassen", if n == 1 { "Zeile" } else { "Zeilen" })
    },
    held_out: |n| format!(", {n} zurückgehalten"),
    use_rejected: "Abgelehnte Zeilen auch verwenden",
    leave_rejected: "Abgelehnte Zeilen auslassen",
    reading: "Wird gelesen…",
    cancel: "Abbrechen",
    reading_stopped: "Das Lesen wurde angehalten. Was offen war, ist noch offen.",
    save_as: "Mit Entscheidungen sichern",
    save_csv: "CSV",
    save_json: "JSON-Zeilen",
    six_sentences: "Zurück zu den sechs Sätzen",
    file_fault: |name, fault| match fault {
        FileFault::Empty => {
            format!("{name} ist leer. Wähle eine Datei mit Kopfzeile und mindestens einer Zeile.")
        }
        FileFault::TooLarge => {
            format!("{name} ist größer als 64 MB. Teile sie und öffne einen Teil nach dem anderen.")
        }
        FileFault::Unreadable => format!(
            "{name} ließ sich nicht lesen. Sieh nach, ob sie noch da ist, und wähle sie neu."
        ),
        FileFault::NotText(line) => format!(
            "{name} ist kein Text in UTF-8 (zuerst in Zeile {line}). Sichere sie als UTF-8, oder wähle die CSV-Datei selbst, keine Tabelle und kein Archiv."
        ),
    },

    // Problems.
    problems: |n| format!(", {n} {}", if n == 1 { "Problem" } else { "Probleme" }),
    rows_to_look_at: |n| {
        format!("{n} {} in der Datei", if n == 1 { "Problem" } else { "Probleme" })
    },
    line: |n| format!("Zeile {n}"),
    file: "Datei",
    row_kept: " · Zeile behalten",
    and_more: |n| format!("und {n} weitere"),
    save_bad: |name, n| {
        format!(
            "Die {n} fehlerhaften Zeilen von {name} sichern, berichtigen und wieder fallen lassen"
        )
    },

    // Mapping columns.
    map: "Spalten von Hand zuordnen",
    map_help: |name| {
        format!(
            "Das sind die ersten Zeilen von {name}. Sag, was jede Spalte ist: der Befehl, und zu jeder Vorführung der Zustand vorher und nachher."
        )
    },
    column_is: |name| format!("{name} ist"),
    column: |column| match column {
        Column::Unused => "nicht verwendet".to_owned(),
        Column::Command => "Befehl".to_owned(),
        Column::Task => "Aufgabe".to_owned(),
        Column::Worker => "Person".to_owned(),
        Column::Id => "Name der Zeile".to_owned(),
        Column::Status => "Status".to_owned(),
        Column::Approve => "genehmigt".to_owned(),
        Column::Reject => "Grund der Ablehnung".to_owned(),
        Column::Before(n) => format!("vorher, {n}"),
        Column::After(n) => format!("nachher, {n}"),
    },
    map_use: "So lesen",
    map_save: "Zuordnung sichern",
    map_missing: "Nötig sind ein Befehl und mindestens eine Vorführung (vorher und nachher).",
    map_again: "Eine gesicherte Zuordnung kann man hier fallen lassen, oder zusammen mit den nächsten Dateien.",

    // The table.
    search: "Befehle durchsuchen",
    filter_task: "Aufgabe",
    filter_worker: "Person",
    filter_status: "Status",
    filter_outcome: "Lesart",
    filter_half: "Teil",
    filter_rule: "Markiert",
    any: "alle",
    none: "ohne",
    show_all: "Alle zeigen",
    seen: |n, of| if n == of { format!("{n} Zeilen") } else { format!("{n} von {of} Zeilen") },
    table: "Zeilen des Korpus. Pfeiltasten bewegen, Enter öffnet, die Leertaste wählt aus.",
    command: "Befehl",
    pairs: "Gezeigt",
    pick: |n| format!("Zeile {n} auswählen"),
    status: |status| match status {
        Status::Open => "offen",
        Status::Approved => "genehmigt",
        Status::Rejected => "abgelehnt",
    },
    outcome: |outcome| match outcome {
        Outcome::Right => "richtig",
        Outcome::Tied => "gleichauf mit falschen",
        Outcome::Lower => "gültig, nicht die beste",
        Outcome::Invalid => "keine gültige Lesart",
        Outcome::Unread => "keine Lesart",
    },
    rule: |rule| match rule {
        Rule::Invalid => "unter keiner Lesart gültig",
        Rule::Strange => "anders als die meisten der Aufgabe",
        Rule::Duplicate => "doppelt",
        Rule::Short => "zu kurz",
    },
    half: |half| match half {
        Half::Train => "zum Lernen",
        Half::HeldOut => "zurückgehalten",
        Half::Aside => "beiseite",
    },

    // A row.
    demonstration: |n| format!("Vorführung {n}, vorher:"),
    after: "Nachher:",
    way: |rooms, n| format!("Der Weg, {n} Aktionen: {rooms}"),
    unlike: |rooms, n| format!("Nicht so, {n} Aktionen: {rooms}"),
    close: "Zeile schließen",
    where_from: |id, line| if line > 0 { format!("{id}, Zeile {line}") } else { id.to_owned() },
    readings: |n| if n == 1 { "1 Lesart".to_owned() } else { format!("{n} Lesarten") },
    valid_for: |valid, n| {
        format!("{} für Vorführung {n}", if valid { "gültig" } else { "nicht gültig" })
    },
    not_audited: "Was das Modell daraus macht, ist noch nicht bekannt: unter Pflege fragen.",
    no_reading: |why| format!("Das Modell hat keine eindeutige Antwort: {why}."),

    // Care.
    care: "Pflege",
    picked: |n| format!("{n} ausgewählte Zeilen"),
    all_seen: |n| format!("alle {n} Zeilen der Ansicht"),
    with_rows: |rows| format!("Mit {rows}:"),
    pick_none: "Keine auswählen",
    approve: "Genehmigen",
    reject: "Ablehnen",
    reason: "Grund der Ablehnung",
    reopen: "Wieder öffnen",
    put: |half| match half {
        Half::Train => "Zum Lernen",
        Half::HeldOut => "Zurückhalten",
        Half::Aside => "Beiseite",
    },
    undo: "Letzte Entscheidung zurücknehmen",
    redo: "Wiederholen",
    done: |done| {
        let rows = done.rows;
        match done.deed {
            Deed::Approve => format!("{rows} Zeilen genehmigt."),
            Deed::Reject => format!("{rows} Zeilen abgelehnt."),
            Deed::Reopen => format!("{rows} Zeilen wieder offen."),
            Deed::Put(Half::Train) => format!("Aus {rows} Zeilen wird gelernt."),
            Deed::Put(Half::HeldOut) => format!("{rows} Zeilen werden zurückgehalten."),
            Deed::Put(Half::Aside) => format!("{rows} Zeilen sind beiseite."),
            Deed::Split => {
                format!("Der Korpus ist geteilt: {rows} Zeilen haben die Seite gewechselt.")
            }
        }
    },
    undone: |what| format!("Zurückgenommen: {what}"),
    rules: "Zeilen, die man zuerst ansehen sollte",
    find: "Kurze, doppelte und seltsame Zeilen suchen",
    audit: "Das Modell des Roboters nach jeder Zeile fragen",
    auditing: |done, of| format!("{done} von {of} Zeilen sind beurteilt."),
    audited: "Alle Zeilen sind beurteilt.",
    marked: |n| format!("{n} Zeilen"),

    // Splits.
    split: "Zeilen zurückhalten",
    split_help: "Was zurückgehalten wird, daraus wird nicht gelernt: Daran wird ein Modell nach jedem Durchgang beurteilt. Von Hand teilt man, indem man Zeilen auswählt.",
    share: "Anteil in Prozent",
    together: "Was beisammenbleibt",
    by: |by| match by {
        By::Row => "einzelne Zeilen",
        By::Command => "Zeilen eines Befehls",
        By::Task => "Zeilen einer Aufgabe",
        By::Worker => "Zeilen einer Person",
    },
    seed: "Startwert",
    split_share: "Diesen Anteil zurückhalten",
    split_none: "Nichts zurückhalten",
    split_view: |name| format!("Alles von {name} zurückhalten"),
};
