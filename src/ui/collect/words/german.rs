//! Taking part in German.

use super::table::Text;
use crate::study::ends::Refusal;
use crate::ui::collect::action::Trouble;
use crate::ui::page::grammar::German;
use crate::ui::page::keep::fault::Fault;

/// The words.
pub(super) static GERMAN: Text = Text {
    grammar: &German,
    loading: "Die Studie wird geladen …",
    no_study: "Hier ist keine Studie",
    trouble: |trouble| {
        match trouble {
        Trouble::Unnamed => "Der Link nennt keine Studie. Bitte um den ganzen Link: Er endet mit ?study= und einem Namen.".to_owned(),
        Trouble::Elsewhere => "Der Link nennt eine Studie einer anderen Website, die diese Seite nicht öffnet.".to_owned(),
        Trouble::Absent(why) => format!("Die Studie konnte nicht geladen werden ({why}). Lade die Seite gleich noch einmal."),
        Trouble::Bad(why) => format!("Die Studie ist nicht zu gebrauchen: {why}."),
    }
    },
    other_language: "English",

    welcome: "Du siehst einen Roboter in einigen Räumen, bevor und nachdem er etwas getan hat. Sag in deinen Worten, was ihm aufgetragen wurde.",
    consent: "Die Teilnahme ist freiwillig. Du kannst jederzeit aufhören, dann wird gelöscht, was du geantwortet hast. Was du schreibst und wie lange es dauert, wird für die Forschung genutzt.",
    consent_title: "Bevor es losgeht",
    posts_to: |hosts| {
        format!(
            "Deine Antworten gehen am Ende an {} und nirgendwo sonst hin. Bis dahin bleiben sie in diesem Browser.",
            hosts.join(", ")
        )
    },
    posts_nowhere: "Diese Seite sendet nichts: Deine Antworten bleiben in diesem Browser, bis du sie selbst weitergibst.",
    preview: "Das ist eine Vorschau: Nichts wird aufgezeichnet oder gesendet.",
    simulated: "Diese Teilnahme ist simuliert.",
    agree: "Ich bin einverstanden und nehme teil",
    instructions_title: "Was zu tun ist",
    instructions: "Jede Aufgabe zeigt, wie derselbe Auftrag an mehreren Orten ausgeführt wird, mit einem Bild davor und einem danach. Finde heraus, was alle gemeinsam haben, und schreib einen Auftrag, mit dem der Roboter es an jedem dieser Orte täte. Sieh dir alle an: Einer allein kann täuschen.",
    instructions_runs: "Jede Aufgabe zeigt, wie derselbe Auftrag an mehreren Orten ausgeführt wird. Spiel jeden bis zum Ende ab. Finde heraus, was allen gemeinsam ist, auch auf dem Weg, und schreib einen Auftrag, mit dem der Roboter das an jedem von ihnen tut. Sieh dir alle an: Einer allein kann täuschen.",
    example: "Ein Beispiel",
    example_said: "Ein guter Auftrag dafür:",
    begin: "Los geht’s",

    item: |at, of| format!("Aufgabe {at} von {of}"),
    ask: |n| match n {
        1 => "Schreib einen Auftrag, mit dem der Roboter das tut.".to_owned(),
        n => format!("Schreib einen Auftrag, mit dem der Roboter das an allen {n} Orten tut."),
    },
    showing: |at| format!("Ort {at}"),
    before: "Davor",
    after: "Danach",
    show_change: "Zeigen, was sich ändert",
    hide_change: "Nicht mehr zeigen",
    play: "Abspielen",
    pause: "Anhalten",
    one_step: "Ein Schritt",
    step: |gone, of| format!("Schritt {gone} von {of}"),
    command: "Dein Auftrag an den Roboter",
    hint: "Ein Satz, wie du ihn jemandem sagen würdest.",
    next: "Weiter",
    kept: "Deine Antworten sind in diesem Browser aufbewahrt: Du kannst die Seite schließen und wiederkommen.",
    keeping: "Wird aufbewahrt …",
    fault: |fault| {
        match fault {
        Fault::None => "Dieser Browser bewahrt für diese Seite nichts auf, wie in einem privaten Fenster: Bleib bis zum Ende auf der Seite.".to_owned(),
        Fault::Full => "In diesem Browser ist kein Platz mehr: Bleib bis zum Ende auf der Seite, oder schaff Platz.".to_owned(),
        Fault::Newer | Fault::Older => "Eine andere Fassung dieser Seite ist in einem anderen Tab offen. Schließ ihn und lade diese neu.".to_owned(),
        Fault::Damaged => "Was von deinen Antworten aufbewahrt war, ist beschädigt.".to_owned(),
        Fault::Elsewhere => "In einem anderen Tab geht es damit weiter.".to_owned(),
        Fault::Other(words) => format!("Nichts ist aufbewahrt (der Browser sagt „{words}“): Bleib bis zum Ende auf der Seite."),
    }
    },

    elsewhere: "Das ist in einem anderen Tab offen. Mach dort weiter, oder hier mit dem, was du bisher geantwortet hast.",
    take: "Hier weitermachen",
    refused: "Du hast das schon begonnen und bist gegangen. Diese Studie geht nur in einem Zug.",

    end_title: "Gleich geschafft",
    sending: |host| format!("Deine Antworten gehen an {host} …"),
    not_sent: |why, tries| {
        format!(
            "Deine Antworten sind noch nicht gesendet ({why}; {tries}-mal versucht). Sie bleiben hier, und es wird von selbst wieder versucht. Lass die Seite offen, oder komm später wieder."
        )
    },
    try_again: "Jetzt noch einmal",
    form: |host| format!("Sende deine Antworten an {host}."),
    submit: "Senden",
    code: "Das ist dein Code. Kopiere ihn dorthin, wo du danach gefragt wurdest.",
    copy: "Code kopieren",
    copied: "Kopiert.",
    go_on: "Ich habe ihn, weiter",
    file: "Sichere deine Antworten als Datei, und schick sie denen, die dich um Teilnahme gebeten haben.",
    save: "Datei sichern",
    file_sent: "Ich habe sie geschickt",
    back: |host| format!("Geh zurück zu {host}, dort weiß man dann, dass du fertig bist."),
    go_back: "Zurück und fertig",
    refusal: |refusal| {
        match refusal {
        Refusal::Linked => "Diese Studie kam im Link selbst und darf nichts senden. Sichere deine Antworten stattdessen als Datei.".to_owned(),
        Refusal::Unsafe(url) => format!("{url} ist keine Adresse für Antworten: Andere könnten mitlesen. Sichere sie stattdessen als Datei."),
        Refusal::Unlisted(host) => format!("Die Studie führt {host} nicht auf, deshalb geht nichts dorthin. Sichere deine Antworten stattdessen als Datei."),
        Refusal::Simulated => "Antworten einer simulierten Teilnahme gehen an keinen fremden Rechner.".to_owned(),
        Refusal::Nowhere => "Der Link sagt nicht, wohin die Antworten sollen. Sichere sie stattdessen als Datei.".to_owned(),
    }
    },
    end_preview: "Hier würden deine Antworten übergeben.",

    thanks: "Danke! Du bist fertig.",
    over_code: "Dein Code:",
    over_form: "Deine Antworten wurden mit einem Formular gesendet. Ob sie angekommen sind, weiß nur die andere Seite: Wenn sie sie nicht angenommen hat, sende sie noch einmal. Sie sind hier aufbewahrt, bis du sie löschst.",
    erased: "Davon ist in diesem Browser nichts mehr aufbewahrt.",
    delete: "Löschen, was hier aufbewahrt ist",
    withdraw: "Teilnahme zurückziehen",
    sure: "Alles löschen, was du hier geantwortet hast?",
    withdraw_yes: "Ja, löschen",
    withdraw_no: "Nein, weitermachen",
    withdrawn: "Du hast deine Teilnahme zurückgezogen. Was du geantwortet hattest, ist gelöscht.",
};
