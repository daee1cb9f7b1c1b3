//! The words about training in German.

use super::duration::duration;
use super::table::Text;
use crate::ui::page::document::{Model, Origin};
use crate::ui::train::run::action::Number;
use crate::worker::protocol::FeatureKind;

/// The words.
pub(super) static GERMAN: Text = Text {
    training: "Einen Parser trainieren",
    train: "Trainieren",
    go_on: "Weiter",
    pause: "Anhalten",
    pausing: "Hält an…",
    step_example: "Ein Beispiel",
    step_epoch: "Bis zum Ende des Durchgangs",
    stop: "Beenden",
    resume: "Da weitermachen, wo es beendet wurde",
    use_so_far: "Das Modell bis hierher verwenden",
    help: |n, settings| {
        let more = if settings.idioms { " und einem, der nach Wendungen sucht" } else { "" };
        format!(
            "Er kann aus {n} Befehlen lernen, jeder mit dem Raum vorher und nachher gezeigt, in {} Durchgängen{more}.",
            settings.epochs
        )
    },
    beginning: "Beginnt…",
    begun: "Das Training hat begonnen.",
    stopped: "Das Training wurde beendet. Das Modell des Roboters ist, wie es war.",
    rests: "Das Training ruht.",
    trained: |valid, n| {
        format!(
            "Trainiert: {valid} von {n} Befehlen haben eine gültige Bedeutung. Der Roboter verwendet das neue Modell."
        )
    },
    at: |p| {
        format!(
            "Durchgang {} von {}, Befehl {} von {}. {} mit gültiger Bedeutung, {} Anpassungen, {} Einträge im Lexikon.",
            p.epoch, p.epochs, p.example, p.examples, p.valid, p.updates, p.entries
        )
    },
    times: |worked, left| {
        let worked = duration(worked);
        match left {
            Some(left) => format!("Bisher {worked}, noch etwa {}.", duration(left)),
            None => format!("Bisher {worked}."),
        }
    },
    model_is: |model: &Model| {
        let report = &model.report;
        let origin = match &model.origin {
            Origin::Shipped => "das Modell zu dieser Seite".to_owned(),
            Origin::Trained(corpus) => format!("ein hier auf {corpus} trainiertes Modell"),
            Origin::File => "ein Modell aus einer Datei".to_owned(),
        };
        format!(
            "Der Roboter verwendet {origin}: {} von {} Befehlen haben eine gültige Bedeutung, {} Einträge im Lexikon.",
            report.valid, report.examples, report.entries
        )
    },
    open_model: "Ein Modell öffnen",
    save_model: "Das Modell sichern",

    // Settings.
    settings: "Einstellungen",
    paper: "Die des Aufsatzes",
    are_paper: "Das sind die des Aufsatzes.",
    number: |number| match number {
        Number::Epochs => "Durchgänge",
        Number::Beam => "Strahl",
        Number::LexicalBeam => "Strahl beim Erzeugen von Einträgen",
        Number::Demonstrations => "Vorführungen je Befehl (0: alle)",
        Number::Margin => "Abstand",
        Number::Seed => "Startwert der Reihenfolge",
        Number::Budget => "Versuchte Herleitungen je Tabelle",
        Number::LexicalBudget => "Dasselbe beim Erzeugen",
        Number::Generations => "Durchgänge mit neuen Einträgen",
    },
    idioms: "Wiederkehrende Befehle dürfen Redewendungen werden",
    lexicon: "Vorher bekannt",
    lexicons: [
        "was zum Korpus passt",
        "wenige Funktionswörter (Abschnitt VII)",
        "das Englisch der Domäne",
    ],
    own_lexicon: "Eigene Lexikondatei",
    no_lexicon: |name| format!("{name} ist kein Lexikon: ein Text in UTF-8 von höchstens 4 MB."),
    save_curves: "Kurven als SVG sichern",
    without: "Weggelassene Merkmale",
    kind: |kind| match kind {
        FeatureKind::Lexeme => "Wörter mit ihren Konstanten",
        FeatureKind::Template => "Schablonen",
        FeatureKind::Entry => "Einträge",
        FeatureKind::Rule => "Regeln",
        FeatureKind::Pair => "Paare von Konstanten",
        FeatureKind::Conjoined => "Verbundenes",
        FeatureKind::Alone => "einzelne Konstanten",
        FeatureKind::Head => "Köpfe",
    },

    // Curves.
    curves: "Wie es läuft",
    held_out: "An Zurückgehaltenem (mit 95-%-Intervallen)",
    nothing_held_out: "Es ist nichts zurückgehalten: Unter Daten kann man einen Anteil der Zeilen zurückhalten, und die Kurven zeigen dann, wie gut das Modell daran abschneidet.",
    precision: "Genauigkeit",
    recall: "Trefferquote",
    f1: "F1",
    valid: "Befehle mit gültiger Lesart",
    updates: "Anpassungen der Gewichte",
    entries: "Einträge im Lexikon",
    pass: "Durchgang",
    as_table: "Dasselbe als Tabelle",

    // What is being learned.
    now: "Was gerade gelernt wird",
    nothing_yet: "Hier steht der Befehl, an dem gearbeitet wird, mit seinen besten Formen, den Einträgen, die er brachte, und den Merkmalen, die er bewegte.",
    forms: |n| format!("Formen, die besten von {n}"),
    valid_in: |valid, n| format!("gültig in {valid} von {n}"),
    added: "Neue Einträge",
    moved: "Bewegte Merkmale",
    moved_by: "um",
    moved_to: "auf",
    feature: "Merkmal",
};
