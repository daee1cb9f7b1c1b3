//! What all pages say in German.

use super::table::Text;

/// The words.
pub(super) static GERMAN: Text = Text {
    copied: "Kopiert.",
    not_copied: "Dieser Browser hat das Kopieren nicht erlaubt.",
    share: "Teilen",

    engine_stopped: "Der Rechenkern steht",
    engine_kept: "Geladenes und Gelehrtes ist noch da. Neu starten und weitermachen.",
    engine_restart: "Neu starten",
    engine_stopped_said: "Der Rechenkern steht. Geladenes ist noch da; man kann ihn neu starten.",
    engine_starting: "Der Rechenkern wird neu gestartet.",
    engine_silent: "Er hat seit einigen Sekunden nicht geantwortet.",
    other_version: "Seite und Rechenkern sind verschieden alt. Bitte die Seite neu laden.",

    no_model: |why| format!("Das Modell zu dieser Seite ließ sich nicht laden ({why})."),
    model_opened: |entries| format!("Das Modell ist offen: {entries} Einträge."),

    // The foot, and what is dropped on the page.
    stays_here: "Alles läuft in dieser Seite. Nichts, was man eingibt, lehrt oder öffnet, verlässt den Rechner. Befehle sind auf Englisch.",
    drop_here: "Datei zum Öffnen fallen lassen",
};
