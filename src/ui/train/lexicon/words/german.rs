//! The words about what was learned in German.

use super::table::Text;

/// The words.
pub(super) static GERMAN: Text = Text {
    lexicon: "Das Lexikon",
    lexicon_help: "Des Modells, das hier zuletzt trainiert oder nach den Zeilen gefragt wurde, sonst des Modells des Roboters. Wo ein Eintrag gebraucht wird, ist bekannt, sobald das Modell gefragt ist.",
    search: "Wörter, Kategorie oder Bedeutung",
    learned_only: "Nur Gelerntes",
    words: "Wörter",
    category: "Kategorie",
    meaning: "Bedeutung",
    weight: "Gewicht",
    uses: "Zeilen",
    from: "Gelernt aus",
    example: "Zum Beispiel",
    open_row: |row| format!("Zeile {row} öffnen"),
    seed: "vorher bekannt",
    pick: |words| format!("Den Eintrag von {words} auswählen"),
    nothing_learned: "Nichts wurde über das vorher Bekannte hinaus gelernt: Es kannte alle Wörter.",
    no_entry: "Kein Eintrag enthält das.",
    shown: |from, to, of| format!("{from} bis {to} von {of} Einträgen"),
    before: "Zurück",
    next: "Weiter",
    leave_out: |n| format!("Den Roboter das Modell ohne {n} Einträge verwenden lassen"),
    without: |n| format!("dem Korpus, ohne {n} Einträge"),

    // Errors.
    errors: "Wo es irrt",
    no_errors: "Unter Daten ein Modell nach jeder Zeile fragen: Dann stehen hier die schlechtesten Befehle, die unbekannten Wörter und die Merkmale, die falsch entschieden.",
    errs_nowhere: "Jede Zeile wird beantwortet, wie sie vorgeführt wurde.",
    worst: "Befehle, die am meisten scheitern",
    command: "Befehl",
    right: "Richtig",
    best_form: "Beste Form",
    unknown: "Unbekannte Wörter",
    deciders: "Merkmale, die falsch entschieden",
    feature: "Merkmal",
    by: "Um",
    confusion: "Was falsche Antworten stattdessen taten, an Zurückgehaltenem",
    task: "Aufgabe",
    does: "Tat",
    nothing: "nichts",
    count: "Mal",

    // Two models.
    compare: "Das Modell des Roboters mit einem anderen vergleichen",
    compare_with: "Eine Modelldatei wählen",
    no_model: |name| format!("{name} ist keine Modelldatei."),
    compared: "Die Modelle sind verglichen.",
    robots: "Das des Roboters",
    alone: |name, n| format!("{n} Einträge nur von {name}"),
    common: |n| format!("{n} Einträge von beiden"),
    moved: "Gewichte, die sich am meisten unterscheiden",
};
