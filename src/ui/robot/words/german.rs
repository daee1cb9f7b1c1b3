//! Driving a robot in German.

use super::table::Text;
use crate::robot::address::Fault;
use crate::robot::calibration::Uncalibrated;
use crate::robot::frame::Misread;
use crate::robot::message::Flaw;
use crate::robot::session::{Bad, Kind};
use crate::robot::sight::Unseen;
use crate::robot::trial::Untried;
use crate::robot::{Check, Halt, Stage, Told};
use crate::ui::page::grammar::German;
use crate::ui::page::world::Name;
use crate::ui::robot::state::Link;

/// The words.
pub(super) static GERMAN: Text = Text {
    grammar: &German,
    title: "Einen Roboter fahren",
    front: "Zurück zu den Räumen",
    guide: "Anleitung",
    other_language: "English",
    intro: "Sagen Sie, was ein Turtlebot tun soll, und er fährt los: ein simulierter oder Ihr eigener über rosbridge. Nichts bewegt sich vor einem Trockenlauf, und nur solange Sie die Taste halten.",

    robot: "Der Roboter",
    which: "Welcher Roboter?",
    simulated: "Ein simulierter",
    real: "Mein eigener",
    address: "Adresse seiner rosbridge",
    link: "Verbinden",
    unlink: "Trennen",
    start: "Starten",
    end: "Wegräumen",
    fault: |fault| match fault {
        Fault::NoSocket => {
            "Die Adresse einer rosbridge beginnt mit ws:// oder wss:// und nennt einen Rechner, etwa ws://192.168.0.20:9090."
        }
        Fault::Mixed => {
            "Diese Seite kam über https, und von einer solchen öffnen Browser ws:// nur zum eigenen Rechner. Laden Sie die Seite über http (die Anleitung sagt, wie der Roboter sie selbst ausliefert), oder erreichen Sie den Roboter über wss:// oder durch einen Tunnel über ws://localhost: ssh -L 9090:localhost:9090 ROBOTER."
        }
    },
    linked: |link| match link {
        Link::Off => "Nicht verbunden.",
        Link::Opening(0) => "Die Verbindung wird aufgebaut …",
        Link::Opening(_) => "Die Verbindung wird wieder aufgebaut …",
        Link::Open => "Verbunden.",
        Link::Lost(1) => "Die Verbindung ist weg. Gleich wird sie wieder aufgebaut.",
        Link::Lost(_) => "Dort antwortet niemand. Gleich wird es wieder versucht.",
    },
    topics: "Topics und Typen",
    velocity: "Geschwindigkeiten nimmt er auf",
    pose: "Wo er ist, sagt er auf",
    object: |look| format!("Wo das ist, falls es verfolgt wird: {look}"),
    objects: "Was niemand verfolgt, wird dort vermutet, wo es sein müsste.",
    types: "Typen",
    types_asked: "Den Roboter fragen",
    kind: |kind| match kind {
        Kind::Unasked => "noch nicht gefragt".to_owned(),
        Kind::Asked => "gefragt …".to_owned(),
        Kind::Command(command, generation) => command.name(*generation),
        Kind::Sighting(sighting, generation) => sighting.name(*generation),
        Kind::Absent => "kein solches Topic dort".to_owned(),
        Kind::Other(name) => format!("{name}, hier nicht zu gebrauchen"),
        Kind::Failed(why) => format!("rosapi konnte es nicht sagen: {why}"),
    },

    place: "Wo er ist",
    world: "Räume",
    world_name: |name| match name {
        Name::ThreeRooms => "Drei Räume",
        Name::Hall => "Ein Flur mit zwei Räumen",
        Name::Store => "Ein Lager",
        Name::Locked => "Eine verschlossene Tür",
    },
    own_world: "Eigene Räume",
    drawing: "Eigene Räume zeichnen",
    drawing_help: "Ein Zeichen je Zelle, wie die Startseite eine Welt schreibt: # ist Wand, ein Buchstabe der Boden eines Raums, < > ^ v der Roboter und sein Blick. Darunter, wofür die Buchstaben stehen.",
    draw: "Diese Räume nehmen",
    size: "Eine Zelle misst (m)",
    here: "Er steht wie gezeichnet",
    here_help: "Stellen Sie den Roboter in die Mitte der Zelle, in der er gezeichnet ist, mit dem gezeichneten Blick. Gut für die Odometrie der Räder.",
    corners: "Mit vier Ecken",
    corners_help: "Stellen Sie den Roboter nacheinander in vier Zellen. Am besten für Motion Capture; findet auch, wie groß eine Zelle ist.",
    corner: |at, of, cell| {
        format!(
            "{at} von {of}: Stellen Sie den Roboter in die Mitte von {cell}, und warten Sie, bis er steht."
        )
    },
    recalled: "Das ist von einem früheren Besuch. Sieh nach, ob der Roboter dort gezeichnet ist, wo er steht: Nach dem Einschalten zählen die Räder von vorn.",
    note: "Er steht dort",
    calibrated: |size, off| match off {
        0.0 => format!("Kalibriert: Eine Zelle misst {size:.2} m."),
        off => format!(
            "Kalibriert: Eine Zelle misst {size:.2} m; der schlechteste Ort liegt {:.0} % einer Zelle daneben.",
            100.0 * off
        ),
    },
    uncalibrated: |why| {
        match why {
        Uncalibrated::TooFew => "Die Orte waren ein und derselbe. Bitte noch einmal.".to_owned(),
        Uncalibrated::Mirrored => "Die Ecken kamen falsch herum: Sie passen nur auf die gespiegelten Räume. Bitte noch einmal, in der gezeigten Reihenfolge.".to_owned(),
        Uncalibrated::Off(off) => format!("Die Ecken passen nicht: Eine liegt {off:.1} Zellen daneben. Bitte noch einmal."),
        Uncalibrated::Size(size) => format!("Eine Zelle würde {size:.2} m messen, was nicht sein kann. Bitte noch einmal."),
    }
    },

    dry: "Trockenlauf",
    dry_help: "All dies muss in Ordnung sein, bevor der Roboter fahren darf. Nichts bewegt sich, außer im letzten Punkt: Dort dreht er sich ein wenig, solange Sie die Taste halten.",
    check: |check| match check {
        Check::Linked => "Es gibt eine Verbindung",
        Check::Velocity => "Er nimmt Geschwindigkeiten",
        Check::Poses => "Er sagt oft genug, wo er ist",
        Check::Bodies => "Was verfolgt wird, ist zu sehen",
        Check::Calibrated => "Meter sind auf Zellen abgebildet",
        Check::Placed => "Er steht in einem Raum",
        Check::Stops => "Er hält von selbst, wenn er nichts hört",
    },
    good: "in Ordnung",
    bad: "nicht in Ordnung",
    open: "noch nicht bekannt",
    try_stop: "Sehen, ob er von selbst hält",
    try_help: "Halten Sie jetzt die Taste: Er dreht sich ein wenig, hört dann nichts mehr und muss halten.",
    rehearse: "Den Plan proben",
    rehearsed: |rehearsal| match &rehearsal.halt {
        None if rehearsal.is_done => format!(
            "In der Probe brauchte er {:.0} Sekunden, und {:.0} cm blieben zur nächsten Wand.",
            rehearsal.seconds,
            100.0 * rehearsal.nearest
        ),
        None => format!(
            "In der Probe hätte er nach {:.0} Sekunden neu nachdenken müssen.",
            rehearsal.seconds
        ),
        Some(why) => format!("In der Probe hielt er an. {}", halt(why)),
    },
    came_wrong: |bad| format!("Letzte Störung: {}.", said(bad)),

    drive: "Fahren",
    drive_help: "Halten Sie die Taste zum Fahren, lassen Sie los zum Halten. Die Seite hält ihn auch an, wenn sie verdeckt ist, wenn eine halbe Sekunde keine Pose kommt und bei jedem Fehler.",
    speed: "Höchstens",
    speeds: ["langsam: 0,10 m/s", "üblich: 0,18 m/s", "schnell: 0,30 m/s"],
    arm: "Fahren erlauben",
    disarm: "Fahren verbieten",
    release: "Ich habe nachgesehen: weiter",
    hold: "Zum Fahren halten",
    hold_help: "auch die Leertaste",
    stop: "Halt",
    stage: |stage| match stage {
        Stage::Off => "Aus: Nichts wird gesendet.".to_owned(),
        Stage::Trying(trial) if trial.is_waiting() => {
            "Halten Sie die Taste, um zu sehen, ob er von selbst hält.".to_owned()
        }
        Stage::Trying(_) => "Weiter halten …".to_owned(),
        Stage::Ready => "Bereit: Halten Sie die Taste zum Fahren.".to_owned(),
        Stage::Driving => "Er fährt.".to_owned(),
        Stage::Halted(why) => format!("Angehalten. {}", halt(why)),
    },
    halt,
    told: |told| {
        match told {
        Told::Stops(ms) => format!("Er hält von selbst, innerhalb von {:.1} Sekunden.", f64::from(*ms) / 1000.0),
        Told::Untried(Untried::GoesOn) => "Er drehte sich weiter, obwohl er nichts hörte: Seine Basis hat kein Zeitlimit und darf nicht über eine Verbindung gefahren werden. Die Anleitung sagt, wie sie eines bekommt.".to_owned(),
        Told::Untried(Untried::Still) => "Er drehte sich nicht. Ist er eingeschaltet, und ist es das richtige Topic?".to_owned(),
        Told::Untried(Untried::LetGo) => "Sie haben zu früh losgelassen. Bitte noch einmal.".to_owned(),
        Told::Drives => "Er fährt.".to_owned(),
        Told::Waits => "Er wartet.".to_owned(),
        Told::Arrived => "Getan.".to_owned(),
        Told::Rethinks => "Die Welt ist nicht, wo sie erwartet wurde: Er denkt neu nach.".to_owned(),
        Told::Halted(why) => format!("Angehalten. {}", halt(why)),
    }
    },

    command: "Ihr Befehl an den Roboter, auf Englisch",
    command_hint: "go to the biggest room",
    go: "Planen",
    thinking: "Er denkt nach …",
    loading: "Was es braucht, um Sie zu verstehen, wird geladen …",
    no_model: |why| {
        format!("Was es braucht, um Sie zu verstehen, konnte nicht geladen werden ({why}).")
    },
    meant: "Verstanden:",
    which_meant: "Was davon meinen Sie?",
    plan: |done, of| format!("Schritt {done} von {of}."),
    nothing: "Das wurde nicht verstanden. Die Startseite sagt, warum, und kann es lernen.",
    unknown: |words| format!("Er kennt {} nicht.", quoted(words)),
    left_out: |words| format!("Er müsste {} auslassen.", quoted(words)),
    no_way: "Dahin führt kein Weg.",
    demands: |what| format!("Das gilt nicht, oder es lässt keinen Weg: {what}."),
    without: "Ohne das tun",
    once: "Erst dafür sorgen, dann dabei bleiben",
    done_already: "Das ist schon so.",
    room: "Die Räume, und wo der Roboter darin zu sehen ist",
};

fn quoted(words: &[&str]) -> String {
    words.iter().map(|word| format!("„{word}“")).collect::<Vec<_>>().join(", ")
}

fn halt(why: &Halt) -> String {
    match why {
        Halt::Emergency => "Sie haben es gesagt.".to_owned(),
        Halt::Hidden => "Die Seite war nicht zu sehen.".to_owned(),
        Halt::NoPose => "Eine halbe Sekunde kam keine Pose.".to_owned(),
        Halt::Leapt => "Seine Pose sprang: Wurde er getragen?".to_owned(),
        Halt::Unlinked => "Die Verbindung ist weg. Seine Basis muss von selbst halten.".to_owned(),
        Halt::Backlog => "Was gesendet wird, verlässt diesen Rechner nicht.".to_owned(),
        Halt::Slept => "Die Seite selbst stand zu lange still.".to_owned(),
        Halt::Bad(bad) => format!("Was hereinkam, ist nicht, wie es sein soll: {}.", said(bad)),
        Halt::Unseen(Unseen::Robot(x, y)) => format!(
            "Er ist in Spalte {x}, Zeile {y} zu sehen, wo kein Boden ist: Kalibrieren Sie neu."
        ),
        Halt::Unseen(Unseen::Body(_)) => {
            "Ein verfolgtes Ding ist zu sehen, wo kein Boden ist.".to_owned()
        }
        Halt::Unseen(Unseen::Shared(x, y)) => {
            format!("Zwei Dinge sind in Spalte {x}, Zeile {y} zu sehen.")
        }
        Halt::Stuck => "Ein Schritt dauerte zu lange: Ist etwas im Weg?".to_owned(),
        Halt::TooOften => "Er musste zu oft neu nachdenken.".to_owned(),
        Halt::NoWay => "Von hier führt kein Weg mehr dahin.".to_owned(),
    }
}

/// What came in wrong; what the bridge says stays in its words.
fn said(bad: &Bad) -> String {
    match bad {
        Bad::Frame(Misread::TooLong(bytes)) => format!("eine Nachricht von {bytes} Bytes"),
        Bad::Frame(Misread::Bare(word)) => format!("ein bloßes {word}, was kein JSON ist"),
        Bad::Frame(Misread::NotJson(why)) => format!("kein JSON: {why}"),
        Bad::Frame(Misread::NoFrame(why)) => format!("kein Rahmen des Protokolls: {why}"),
        Bad::Message(topic, Flaw::Null(field)) => {
            format!("{topic}: null, wo eine Zahl hingehört, in {field}")
        }
        Bad::Message(topic, Flaw::Missing(field)) => format!("{topic}: keine Zahl in {field}"),
        Bad::Message(topic, Flaw::NoTurn) => format!("{topic}: eine Orientierung, die keine ist"),
        Bad::Service(service, why) => format!("{service} schlug fehl: {why}"),
        Bad::Status(words) => format!("die Brücke sagt: {words}"),
    }
}
