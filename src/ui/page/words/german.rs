//! What all pages say in German.

use super::table::Text;
use crate::ui::page::keep::fault::Fault;

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

    fault: |fault| {
        match fault {
        Fault::None => "Dieser Browser bewahrt für diese Seite nichts auf, wie in einem privaten Fenster: Sichere, was du tust, als Datei, bevor du sie schließt.".to_owned(),
        Fault::Newer => "Was hier aufbewahrt ist, hat eine neuere Fassung dieser Seite geschrieben: Es bleibt, wie es ist, und nichts wird aufbewahrt, bis du die Seite neu lädst.".to_owned(),
        Fault::Older => "Eine ältere Fassung dieser Seite ist in einem anderen Tab offen und hält fest, was aufbewahrt ist. Schließ jenen Tab: Dieser macht von selbst weiter.".to_owned(),
        Fault::Full => "In diesem Browser ist kein Platz mehr: Die letzte Änderung ist nicht aufbewahrt. Lösche etwas, oder sichere eine Datei.".to_owned(),
        Fault::Damaged => "Was aufbewahrt war, ist beschädigt, beide Male.".to_owned(),
        Fault::Elsewhere => "Ein anderer Tab hat diese Sitzung offen und bewahrt sie auf. Was du hier tust, wird nicht aufbewahrt.".to_owned(),
        Fault::Other(words) => format!("Nichts wird aufbewahrt: Der Browser sagt „{words}“."),
    }
    },
    origins: [
        "Hier warst du zuletzt.",
        "Hier warst du kurz davor: Was zuletzt geschrieben wurde, ist beschädigt.",
        "Das ist die Sitzung eines Links. Deine eigene ist daneben aufbewahrt.",
        "Das ist die Sitzung des Links, wie du sie verlassen hast. Deine eigene ist daneben aufbewahrt.",
        "Auch die Sitzung, die du vorher hattest, ist aufbewahrt.",
    ],
    afresh: "Neu anfangen",
    begun_afresh: "Alles ist wie beim ersten Besuch. Rückgängig bringt zurück, was war.",
    go_back: "Zurück zu meiner",
    keep_here: "Stattdessen hier aufbewahren",
    what_is_kept: "Was aufbewahrt ist",
    open_saved: "Gesicherte Datei öffnen",
    close: "Schließen",

    no_model: |why| format!("Das Modell zu dieser Seite ließ sich nicht laden ({why})."),
    model_opened: |entries| format!("Das Modell ist offen: {entries} Einträge."),

    // The foot, and what is dropped on the page.
    stays_here: "Alles läuft in dieser Seite. Nichts, was man eingibt, lehrt oder öffnet, verlässt den Rechner. Befehle sind auf Englisch.",
    drop_here: "Datei zum Öffnen fallen lassen",
};
