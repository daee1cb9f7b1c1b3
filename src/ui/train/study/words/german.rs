//! Studies in German.

use super::table::Text;
use crate::study::Flag;
use crate::study::file::{Again, Order};
use crate::ui::train::study::action::{Place, Saved, Value, Way};

/// The words.
pub(super) static GERMAN: Text = Text {
    make_title: "Eine Studie machen",
    make_help: "Menschen sehen Paare von Bildern und schreiben einen Auftrag für alle. Zu jeder Aufgabe werden Paare gezogen; die Studie ist eine Datei, die neben collect.html gehört.",
    name: "Name",
    german: "Auf Deutsch",
    pairs: "Paare je Aufgabe",
    shown: "Gezeigte Paare",
    asked: "Aufgaben je Person (0: alle)",
    seed: "Startwert",
    cents: "Lohn je Antwort (Cent)",
    has_ways: "Statt vorher und nachher den Weg des Roboters zeigen",
    checks: "Prüfungen: Aufgaben, an denen sich zeigt, ob jemand hinsieht",
    checks_help: "Sie kommen bei allen hinzu. Eine Antwort muss jedes der Wörter haben; von Wörtern mit einem Strich dazwischen, wie rot/rötlich, eines.",
    check: "Eine Aufgabe, die prüft",
    must: "Wörter, die eine Antwort haben muss",
    stop: "Anhalten",
    words: "Eigene Worte",
    says: |place| match place {
        Place::Welcome => "Begrüßung (leer: die der Seite)",
        Place::Consent => "Einwilligung (leer: die der Seite)",
        Place::Instructions => "Anleitung (leer: die der Seite)",
        Place::Example => "Der Auftrag des Beispiels (leer: der der Seite)",
        Place::Thanks => "Dank (leer: der der Seite)",
    },
    order: "Reihenfolge der Aufgaben",
    orders: |order| match order {
        Order::Shuffled => "für alle eine andere",
        Order::Fixed => "wie in der Datei",
    },
    again: "Wer nach einem Abbruch wiederkommt",
    agains: |again| match again {
        Again::Resume => "macht weiter",
        Again::Restart => "fängt neu an",
        Again::Refuse => "wird mit Dank weggeschickt",
    },
    hosts: "Rechner, an die Antworten gehen dürfen",
    ends: "Wie sie endet (JSON)",
    tasks: "Aufgaben, als Datei (leer: die 23 des Korpus)",
    make: "Ziehen",
    making: "Paare werden gezogen",
    open_study: "Eine Studie öffnen",
    bad_ends: |error| format!("Die Enden sind kein JSON von Enden: {error}."),
    made: |items| format!("Die Studie hat {items} Aufgaben."),
    study_is: |name, items, mark| format!("„{name}“, {items} Aufgaben, Kennung {mark}"),
    no_study: "Es gibt noch keine Studie: Zieh eine, oder öffne eine.",
    open: "Was die Paare offenlassen",
    host_it: "Leg die Datei neben collect.html und schick die Leute zu collect.html?study=study.json; mit &preview siehst du sie wie sie.",

    way: "Übliche Enden",
    ways: |way| match way {
        Way::File => "ein Code, und eine Datei zum Schicken",
        Way::Endpoint => "ein eigener Empfänger, und ein Code",
        Way::Prolific => "ein eigener Empfänger, und zurück zu Prolific",
        Way::Frame => "das Formular eines Rahmens wie bei Mechanical Turk",
    },
    preview: "Wie eine Teilnehmerin sehen",
    link: "Ein Link, der alles enthält",

    review_title: "Antworten prüfen",
    review_help: "Bring die Dateien, die man dir geschickt hat, was ein Empfänger bekam, oder Batch-Ergebnisse, in beliebiger Reihenfolge. Dateien von jsPsych und psiTurk werden erst zugeordnet.",
    bring: "Antworten bringen",
    counts: |all, [open, approved, rejected], [doubles, others]| {
        let more = match (doubles, others) {
            (0, 0) => String::new(),
            (doubles, others) => {
                format!(" {doubles} kamen noch einmal, {others} gehören zu einer anderen Studie.")
            }
        };
        format!("{all} Antworten: {open} offen, {approved} angenommen, {rejected} abgelehnt.{more}")
    },
    flaws: "Was an den Dateien nicht stimmt",
    bringing: "Dateien werden gelesen (kB)",
    unfit: |n| {
        format!(
            "{n} weggelassen: Ein Korpus nimmt keinen Auftrag mit mehr als 2.000 Zeichen oder ohne ein Wort."
        )
    },
    judge: "Das Modell des Roboters fragen",
    judge_by: "Ein Modell aus einer Datei fragen",
    judging: "Die Antworten werden gelesen",
    judged: |n| format!("Das Modell hat {n} Antworten gelesen."),
    no_model: "Es gibt noch kein Modell.",
    only: "Nur Antworten mit",
    all: "irgendeinem Zeichen oder keinem",
    flag: |flag| match flag {
        Flag::Unseen => "Paare nicht angesehen",
        Flag::Fast => "zu schnell",
        Flag::Pasted => "eingefügt",
        Flag::Copied => "die Worte des Beispiels",
        Flag::Same => "bei jeder Aufgabe dasselbe",
        Flag::Foreign => "andere Sprache",
        Flag::Missed => "Prüfaufgabe verfehlt",
        Flag::SomePairs => "stimmt nur bei einigen Paaren",
        Flag::NoPair => "stimmt bei keinem Paar",
        Flag::Unread => "das Modell versteht es nicht",
        Flag::Twin => "wie eine andere Person",
        Flag::Again => "mehr als einmal teilgenommen",
        Flag::Simulated => "simuliert",
        Flag::Unfit => "zu lang oder kein Wort",
    },
    reason: |flag| match flag {
        Flag::Unseen => "nicht alle Paare wurden angesehen",
        Flag::Fast => "die Antwort kam zu schnell",
        Flag::Pasted => "der Auftrag wurde eingefügt",
        Flag::Copied => "der Auftrag ist der des Beispiels",
        Flag::Same => "bei jeder Aufgabe steht derselbe Auftrag",
        Flag::Foreign => "der Auftrag ist in einer anderen Sprache",
        Flag::Missed => "eine Prüfaufgabe wurde verfehlt",
        Flag::SomePairs | Flag::NoPair => "der Auftrag stimmt nicht bei allen Paaren",
        Flag::Unread => "der Auftrag ist nicht zu verstehen",
        Flag::Twin => "die Aufträge sind die einer anderen Person",
        Flag::Again => "die Person hat mehr als einmal teilgenommen",
        Flag::Simulated => "die Teilnahme ist simuliert",
        Flag::Unfit => "der Auftrag ist zu lang oder hat kein Wort",
    },
    answer: "Antwort",
    task: "Aufgabe",
    person: "Person",
    flags: "Zeichen",
    decision: "Entscheidung",
    decisions: ["offen", "angenommen", "abgelehnt"],
    approve: "Annehmen",
    reject: "Ablehnen",
    reopen: "Wieder offen",
    steps: |n| format!("→ {n} Schritte →"),
    look: "Paare",
    before: |at| format!("Davor {at}"),
    after: |at| format!("Danach {at}"),
    why: "Grund der Ablehnung",
    rule_title: "Entscheiden, was offen ist",
    rule: "Ablehnen, was eines dieser Zeichen hat, den Rest annehmen:",
    decide: "Entscheiden",
    decided: |approved, rejected| {
        format!("{approved} angenommen, {rejected} abgelehnt. Jede lässt sich anders entscheiden.")
    },
    range: |from, to, all| format!("{from} bis {to} von {all}"),
    earlier: "Frühere",
    later: "Spätere",

    coverage: "Nach Aufgabe",
    items: "Stücke",
    answers: "Antworten",
    approved: "Angenommen",
    rejected: "Abgelehnt",
    valid: "Stimmen bei allen Paaren",
    agreement: "Einigkeit",
    wanted: "Gewünschte Antworten je Aufgabe",
    enough: "Jede Aufgabe hat genug Antworten.",
    out_title: "Herausgeben",
    key: "Pseudonyme aus (leer: Namen, wie sie sind)",
    approved_only: "Nur Angenommenes",
    saved: |saved| match saved {
        Saved::Study => "Studie sichern",
        Saved::Table => "Batch-Ergebnisse (CSV)",
        Saved::Lines => "JSON-Zeilen",
        Saved::Pay => "Lohnliste",
        Saved::TopUp => "Nachstudie",
        Saved::Mapping => "Zuordnung sichern",
    },
    train: "Damit trainieren",

    survey_title: "Datei eines anderen Programms",
    survey_help: |rows| {
        format!(
            "{rows} Durchgänge. Sag, welcher Wert was ist; Durchgänge ohne Auftrag und Zustände bleiben weg."
        )
    },
    value: |value| match value {
        Value::Command => "Auftrag".to_owned(),
        Value::Worker => "Person".to_owned(),
        Value::Task => "Aufgabe".to_owned(),
        Value::Pre(at) => format!("Davor {}", at + 1),
        Value::Post(at) => format!("Danach {}", at + 1),
    },
    none: "–",
    convert: "Antworten übernehmen",
    open_mapping: "Eine Zuordnung öffnen",
    converted: |answers, others, unfinished| {
        format!(
            "{answers} Antworten. {others} Durchgänge ohne eine; {unfinished} von Leuten, die nicht fertig wurden, bleiben weg."
        )
    },
};
