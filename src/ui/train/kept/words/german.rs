//! The words about what is kept in German.

use super::table::Text;
use crate::ui::page::keep::fault::Fault;
use crate::ui::train::kept::state::Kind;

/// The words.
pub(super) static GERMAN: Text = Text {
    title: "Auf diesem Gerät aufbewahrt",
    help: "Ein Lauf wird alle paar Sekunden von selbst aufbewahrt, samt seinem Korpus, und geht dort weiter, wo er war, wenn die Seite wieder geöffnet wird. Was ein Experiment fand, wird von selbst aufbewahrt. Korpora und Modelle werden aufbewahrt, wenn du es sagst. Alles bleibt in diesem Browser, der es löschen kann, wenn seine Platte voll ist oder wenn du seine Daten löschst: Sichere als Datei, was nicht verloren gehen darf.",
    name: "Name",
    keep_corpus: "Korpus aufbewahren",
    keep_model: "Modell des Roboters aufbewahren",
    nothing: "Noch ist nichts aufbewahrt.",
    kind: |kind| match kind {
        Kind::Corpus => "Korpus",
        Kind::Run => "Lauf",
        Kind::Experiment => "Experiment",
        Kind::Model => "Modell",
    },
    what: "Was",
    called: "Name",
    when: "Zuletzt geändert",
    size: "Größe",
    open: "Öffnen",
    save: "Als Datei sichern",
    delete: "Löschen",
    sum: |n, size| format!("{n} aufbewahrt, {size} zusammen, von Geändertem zwei Kopien gezählt."),
    keep_here: "Läufe stattdessen hier aufbewahren",
    deleted: |name| format!("„{name}“ ist gelöscht."),
    written: |name| format!("„{name}“ ist aufbewahrt."),
    opened: |name| format!("„{name}“ ist offen."),
    was_damaged: |name| {
        format!(
            "Was zuletzt von „{name}“ geschrieben wurde, ist beschädigt: Es ist offen, wie es kurz davor war."
        )
    },
    gone: |name| {
        format!(
            "„{name}“ ist nicht mehr aufbewahrt: Der Browser hat es gelöscht, oder ein anderer Tab."
        )
    },
    no_corpus: |corpus| {
        format!(
            "Der Korpus „{corpus}“ dieses Laufs ist nicht mehr aufbewahrt. Öffne seine Dateien wieder unter Daten, um seine Zeilen zu sehen oder den Lauf weitergehen zu lassen."
        )
    },
    wrong: |name, why| format!("„{name}“ kann nicht geöffnet werden: {why}."),
    is_back: |name| format!("Der Lauf „{name}“ ist wieder da, mit seinem Korpus."),
    goes_on: |name, pass, command| {
        format!("Der Lauf „{name}“ geht weiter, wo er war: Durchgang {pass}, Befehl {command}.")
    },
    fault: |fault| {
        match fault {
        Fault::None => "Dieser Browser bewahrt für diese Seite nichts auf, wie in einem privaten Fenster: Ein Lauf ist verloren, wenn die Seite geschlossen wird. Sichere Modelle und Korpora als Dateien.".to_owned(),
        Fault::Newer => "Was aufbewahrt ist, schrieb eine neuere Fassung dieser Seite: Nichts wird aufbewahrt, bis du die Seite neu lädst.".to_owned(),
        Fault::Older => "Eine ältere Fassung dieser Seite ist in einem anderen Tab offen und hält fest, was aufbewahrt ist. Schließ ihn: Dieser geht von selbst weiter.".to_owned(),
        Fault::Full => "In diesem Browser ist dafür kein Platz mehr. Nichts Aufbewahrtes ist verloren. Lösch hier etwas, oder sichere eine Datei.".to_owned(),
        Fault::Damaged => "Es ist beschädigt, beide Kopien.".to_owned(),
        Fault::Elsewhere => "Ein anderer Tab hat die Werkbank offen und bewahrt ihre Läufe auf. Ein Lauf dieses Tabs ist verloren, wenn er geschlossen wird.".to_owned(),
        Fault::Other(words) => format!("Es ist nicht aufbewahrt: Der Browser sagt „{words}“."),
    }
    },
    run_fault: |fault, reached| {
        let why = match fault {
            Fault::Full => "In diesem Browser ist kein Platz mehr: Der Lauf geht weiter, wird aber nicht mehr aufbewahrt.".to_owned(),
            other => (GERMAN.fault)(other),
        };
        match reached {
            Some((pass, command)) => format!(
                "{why} Aufbewahrt ist er, wie er bei Durchgang {pass}, Befehl {command} war; was er seither gelernt hat, ginge mit der Seite verloren."
            ),
            None => format!(
                "{why} Noch ist nichts von ihm aufbewahrt: Er ginge mit der Seite ganz verloren."
            ),
        }
    },
};
