//! The words about experiments in German.

use super::table::Text;
use crate::ui::train::experiments::action::Saved;
use crate::ui::train::experiments::matrix::Kind;
use crate::worker::protocol::By;

/// The words.
pub(super) static GERMAN: Text = Text {
    experiments: "Versuche",
    help: "Mehrere Läufe mit den Einstellungen des Teils Trainieren, einer nach dem anderen. Woraus gelernt wird und was zurückgehalten ist, gilt so, wie der Korpus unter Daten geteilt ist; für die Tabellen des Aufsatzes beide Dateien öffnen und die Testdatei zurückhalten.",
    experiment: "Versuch",
    kind: |kind| match kind {
        Kind::Cross => "Kreuzvalidierung",
        Kind::Curve => "Lernkurve",
        Kind::Features => "Ohne jede Art von Merkmalen",
        Kind::Demonstrations => "Mit 1, 2 und 3 Vorführungen",
        Kind::Seeds => "Mehrere Startwerte",
        Kind::Table2 => "Tabelle II des Aufsatzes",
        Kind::Table3 => "Tabelle III des Aufsatzes",
    },
    folds: "Teile",
    seeds: "Startwerte",
    together: "Was beisammenbleibt",
    by: |by| match by {
        By::Row => "einzelne Zeilen",
        By::Command => "Zeilen eines Befehls",
        By::Task => "Zeilen einer Aufgabe",
        By::Worker => "Zeilen einer Person",
    },
    needs_held_out: "Dieser wird an Zurückgehaltenem beurteilt: erst unter Daten Zeilen zurückhalten.",
    go: "Durchführen",
    stop: "Beenden",
    repeat: "Die Läufe einer Datei wiederholen",
    no_plan: "Diese Datei plant keine Läufe.",
    begun: "Die Läufe haben begonnen.",
    stopped: "Die Läufe wurden beendet: Nichts davon bleibt.",
    ended: |n| format!("{n} Läufe sind fertig."),
    at: |run, runs, name, part| format!("Lauf {run} von {runs}: {name}. {part}"),
    learning: |p| {
        format!("Durchgang {} von {}, Befehl {} von {}.", p.epoch, p.epochs, p.example, p.examples)
    },
    judging: |n, of| format!("An {n} von {of} Befehlen beurteilt."),
    results: "Ergebnisse",
    none: "Noch wurde nichts gefunden.",
    run: "Lauf",
    examples: "Gelernt aus",
    valid: "Gültig",
    entries: "Einträge",
    precision: "Genauigkeit",
    recall: "Trefferquote",
    f1: "F1",
    paper: "Aufsatz",
    all: "alle zusammen",
    saved: |saved| match saved {
        Saved::Csv => "Als CSV sichern",
        Saved::Json => "als JSON",
        Saved::Report => "als Bericht",
        Saved::Plan => "die Läufe, um sie zu wiederholen",
    },
    forget: "Dieses Ergebnis vergessen",
};
