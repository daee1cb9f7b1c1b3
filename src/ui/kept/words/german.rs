//! What is kept, in German.

use super::table::Text;

/// The words.
pub(super) static GERMAN: Text = Text {
    title: "Auf diesem Gerät aufbewahrt",
    about: "Die Seite bewahrt deine Sitzung hier auf, in diesem Browser, damit nichts verloren geht, wenn sie neu geladen wird, wenn man sie schließt oder sie abstürzt. Niemand sonst bekommt sie. Sie liegt zweimal da und wird beim Lesen geprüft.",
    nothing: "Es ist nichts aufbewahrt.",
    what: "Was",
    when: "Zuletzt geändert",
    size: "Größe",
    kinds: [
        ("own", "Deine Sitzung"),
        ("before", "Die Sitzung davor"),
        ("session", "Die Sitzung eines Links"),
        ("corpus", "Korpus"),
        ("run", "Lauf des Trainings"),
        ("experiment", "Experiment"),
        ("model", "Modell"),
        ("sitting", "Deine Antworten in einer Studie"),
        ("robot", "Wie dein Roboter eingerichtet ist"),
    ],
    save: "Als Datei sichern",
    delete: "Löschen",
    delete_all: "Alles löschen",
    deleted: "Es ist gelöscht.",
};
