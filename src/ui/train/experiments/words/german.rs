//! The words about experiments in German.

use super::table::Text;
use crate::ui::train::experiments::action::Saved;
use crate::ui::train::experiments::matrix::Kind;
use crate::worker::protocol::By;

/// The words.
pub(super) static GERMAN: Text = Text {
    experiments: "Versuche",
    help: "Mehrere Läufe mit den Einstellungen des Teils Trainieren, verteilt auf so viele Rechenkerne, wie das Gerät Platz hat, höchstens vier; eines fände dasselbe. Woraus gelernt wird und was zurückgehalten ist, gilt so, wie der Korpus unter Daten geteilt ist.",
    of_paper: "Die Versuche des Aufsatzes",
    paper_help: "Jeder mit einem Druck, am offenen Korpus. Für die Zahlen des Aufsatzes seine Trainings- und Testdateien zusammen öffnen und die Testdatei unter Daten zurückhalten.",
    paper_share: "Noch ist nichts zurückgehalten: Ein Fünftel der Befehle wird es, gezogen mit dem Startwert der Einstellungen. Unter Daten kann das zurückgenommen werden.",
    about: |kind| match kind {
        Kind::Table2 { is_raw: false } => {
            "lernt aus 3, 2 und 1 Vorführungen je Befehl, neben den Zahlen des Aufsatzes für seine gesäuberte Menge"
        }
        Kind::Table2 { is_raw: true } => "dasselbe neben den Zahlen für seine rohe Menge",
        Kind::Table3 => "lernt ohne Planer und mit einem vom Horizont 1, 10 und 20",
        _ => "",
    },
    six: "Die sechs Sätze",
    about_six: "Abschnitt VII: lernt aus sechs Sätzen und tut dann, was keiner von ihnen sagt; der offene Korpus bleibt",
    six_learned: |n, right| {
        format!(
            "Gelernt aus {n} Sätzen; {right} davon werden beantwortet, wie sie vorgeführt wurden."
        )
    },
    never_heard: "Nie gehört:",
    carried_out: |steps| format!("Es wurde in {steps} Schritten ausgeführt."),
    not_done: |reason| format!("Es wurde nicht ausgeführt: {reason}."),
    paper_six: "Der Aufsatz: Das nie gehörte „go to the blue room“ wurde ausgeführt.",
    pool: |done, runs, engines| match engines {
        1 => format!("{done} von {runs} Läufen sind fertig."),
        _ => format!("{done} von {runs} Läufen sind fertig, mit {engines} Rechenkernen."),
    },
    experiment: "Versuch",
    kind: |kind| match kind {
        Kind::Cross => "Kreuzvalidierung",
        Kind::Curve => "Lernkurve",
        Kind::Features => "Ohne jede Art von Merkmalen",
        Kind::Demonstrations => "Mit 1, 2 und 3 Vorführungen",
        Kind::Seeds => "Mehrere Startwerte",
        Kind::Table2 { is_raw: false } => "Tabelle II, gesäubert",
        Kind::Table2 { is_raw: true } => "Tabelle II, roh",
        Kind::Table3 => "Tabelle III",
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
    was_lost: |name| {
        format!(
            "„{name}“ lief, als die Seite verlassen wurde: Was die Läufe gefunden hatten, ist verloren. Starte sie noch einmal."
        )
    },
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
        Saved::Svg => "als SVG",
        Saved::Json => "als JSON",
        Saved::Report => "als Bericht",
        Saved::Plan => "die Läufe, um sie zu wiederholen",
    },
    settings: |s| {
        format!(
            "Der erste Lauf: Startwert {}, {} Durchgänge, Strahlen {} und {}.",
            s.seed, s.epochs, s.beam, s.lexical_beam
        )
    },
    forget: "Dieses Ergebnis löschen",
};
