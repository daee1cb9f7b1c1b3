//! The Talk page in German. Commands stay English: the parser has learned no other.

use super::table::{Faults, Helps, Meant, Text};
use crate::ui::page::document::Origin;
use crate::ui::page::grammar::German;
use crate::ui::talk::room::edit::Obstacle;
use crate::worker::protocol::Why;
use crate::worker::protocol::{Beyond, Refusal};

/// The words.
pub(super) static GERMAN: Text = Text {
    phrases: &German,

    copy: "Kopieren",
    close: "Schließen",
    try_again: "Noch einmal",

    link: "Link",
    link_copied: "Der Link ist kopiert.",
    link_made: "Hier ist der Link.",
    link_help: "Er enthält den Raum, seine Regeln, den Befehl und das Gelehrte. Wer ihn öffnet, bekommt eine Kopie.",
    bad_link: |why| {
        format!(
            "Dieser Link oder diese Datei lässt sich nicht öffnen: {why}. Es hat sich nichts geändert."
        )
    },
    not_saved: |why| {
        format!(
            "Die Datei lässt sich nicht herstellen: {why}. Nichts ist verloren: noch einmal versuchen."
        )
    },
    save_as_file: "Als Datei sichern",

    what_to_do: "Was soll der Roboter tun? (auf Englisch)",
    tell: "Sagen",
    stop: "Halt",
    try_this: "Zum Beispiel",
    hello: "Sag mir auf Englisch, was ich tun soll, oder drück ein Beispiel.",
    ask_why: "Warum?",
    show_grammar: "Grammatik zeigen",
    less: "Weniger",
    unknown_example: "Ein Wort, das ich noch nicht kenne: Bring es mir bei",
    getting_ready: "Gleich bereit…",
    soon: "Einen Augenblick: Ich mache mich bereit, dann tue ich es.",
    train_one: "Eines trainieren",
    the_words: "Die Wörter, wie ich sie lese",
    it_means: "Ich werde",
    it_would_mean: "Ich würde",
    has_steps: |n| {
        if n == 1 {
            "Der Plan hat einen Schritt.".to_owned()
        } else {
            format!("Der Plan hat {n} Schritte.")
        }
    },
    it_could: "Ich könnte",
    take_for: |own, other| format!("„{own}“ halte ich für „{other}“."),
    which: ["Meinst du das?", "Was davon meinst du?"],
    none_of_these: "Nichts davon: Ich zeige es dir",
    remember: "Das merken",
    heard_as: |word| format!("gehört als „{word}“"),
    fate_empty: "bedeutet allein nichts",
    fate_skipped: "ausgelassen",
    fate_unknown: "im Training nie gesehen",
    planning_stopped: "Angehalten, bevor es einen Plan gab.",
    why: Faults {
        empty: (
            "In diesem Befehl steht kein Wort.",
            "Schreib, was der Roboter tun soll, etwa “go to the blue room”.",
        ),
        too_long: (
            "Dieser Befehl hat mehr als 50 Wörter; so lange werden nicht gelesen.",
            "Sag es kürzer oder in mehreren Befehlen.",
        ),
        unknown_words: (
            |words| format!("Nie gesehen: {}.", quoted(words)),
            "Ich verstehe Englisch. Nimm ein Wort, das ich kenne, oder zeig mir, was du meinst.",
        ),
        unknown_left_out: (
            |words| format!("Nie gesehen und ausgelassen: {}.", quoted(words)),
            "Sieh nach, ob es noch bedeutet, was du meinst.",
        ),
        skipped: (
            |words| format!("Ausgelassen: {}.", quoted(words)),
            "Sieh nach, ob es noch bedeutet, was du meinst, oder zeig es.",
        ),
        no_parse: (
            "Ich kenne die Wörter, aber sie ergeben zusammen kein Ziel.",
            "Sag es in anderer Reihenfolge, oder zeig mir, was du meinst.",
        ),
        budget: ("Dieser Befehl lässt sich auf zu viele Arten lesen.", "Sag es kürzer."),
        no_referent: "Nenn genau ein Ding, das im Raum ist.",
        no_world: "Etwas in diesem Befehl benennt nicht genau ein Ding in diesem Raum.",
        unreachable: (
            "Verstanden, aber der Roboter kann es nicht bewirken: eine Wand, eine Tür oder ein Ding ist im Weg.",
            "Etwas muss vielleicht nachgeben:",
        ),
        blocked: (
            |demand| {
                format!("Verstanden, aber es gibt keinen Weg, solange dies gelten muss: {demand}.")
            },
            "Etwas muss nachgeben:",
        ),
        already_broken: (
            |demand| format!("Dies gilt nicht, wo ich jetzt stehe: {demand}."),
            "Ich kann erst dafür sorgen und mich dann daran halten.",
        ),
        broken: (
            |demand| format!("Ich habe angehalten, denn dies gilt nicht mehr: {demand}."),
            "Soll ich weitergehen?",
        ),
        plan_budget: (
            "Verstanden, aber in der erlaubten Zeit fand sich kein Plan.",
            "Mach es leichter:",
        ),
        bad_goal: (
            "Das wurde als etwas gelesen, das hier kein Ziel sein kann.",
            "Sag es anders, oder zeig es.",
        ),
        half: |words| format!("Nicht berücksichtigt habe ich: {}.", quoted(words)),
        nothing_without: |words| {
            format!("Ich müsste {} auslassen, und dann hieße es etwas anderes.", quoted(words))
        },
        half_time: "Was hier zuerst kommt oder auf dem Weg liegt, habe ich nicht verstanden. Sag es anders.",
        half_denied: "Was hier nicht geschehen darf, habe ich nicht verstanden. Sag es anders.",
        half_other: "Sieh nach, ob der Rest ist, was du meinst.",
        keeps: "Zu tun ist nichts, und für später merke ich es mir nicht.",
        already_true: (
            "Das ist schon so: Der Roboter hat nichts zu tun.",
            "Verlange etwas, das noch nicht so ist, oder geh woandershin.",
        ),
        not_reached: (
            "Diesmal kam der Roboter nicht an: Zu viel ging schief.",
            "Versuch es noch einmal, oder überlass weniger dem Zufall.",
        ),
    },
    help: Helps {
        say: |phrase| format!("Sag “{phrase}”"),
        just: "Nur das tun",
        without: "Ohne das tun",
        once: "Erst dies, dann dabei bleiben",
        teach: "Zeigen, was gemeint ist",
        show: "Zeig auf",
        add: |look| format!("Hinstellen: {look}"),
        edit: "Den Raum ändern",
        free_landmarks: "Auch anderes bewegen lassen",
        pull: "Ziehen lassen",
        unlock: "Alle Türen öffnen",
        no_chance: "Nichts dem Zufall überlassen",
        other_world: "In einen anderen Raum gehen",
        guide: "Was ich verstehe",
    },

    readings: "Lesarten",
    best_reading: "die wahrscheinlichste",
    all_readings: "Alle zeigen",
    less_likely: |gap, words| match words {
        [] => format!("{} Punkte weniger", comma(gap, 2)),
        _ => format!("{} Punkte weniger; anders bei {}", comma(gap, 2), quoted(words)),
    },
    where_it_holds: "Wo das Ziel erreicht wäre",
    phrases_title: "Worum es geht",

    said_before: "Was du gesagt hast",
    say_again: "Noch einmal sagen",
    go_on: "Von hier aus weiter",
    go_on_after: |command| format!("Von hier aus weiter: nach „{command}“"),
    gone_back: |command| format!("Der Raum ist wie nach „{command}“."),
    outcomes: [
        "Es war schon so.",
        "Ich habe nachgefragt.",
        "Das geht nicht.",
        "Ich habe es nicht verstanden.",
        "Ich habe es gesagt.",
    ],

    can_do: "Ich gehe zu Räumen, Türen und Dingen und bringe Dinge dahin, wo du sie haben willst: „go to the blue room“, „put the block in the red room“. Mit ? gibt es mehr, mit Beispielen.",
    cannot_tell: "Das kann ich nicht sagen. Sagen kann ich, wo ein Ding ist, was in einem Raum ist, ob ein Ding irgendwo ist und wie viele es gibt.",
    yes_no: ["Ja, so ist es.", "Nein, so ist es nicht."],
    beyond: |beyond, words| {
        let words = quoted(words);
        match beyond {
            Beyond::Number => format!("Ich zähle nicht: {words} kann ich nicht."),
            Beyond::Between => format!(
                "{words}: Ich kenne „in“ und „neben“, aber keinen Platz zwischen zwei Dingen."
            ),
            Beyond::Door => format!(
                "{words}: Eine Tür ist ein Ort, in dem man steht oder durch den man geht; einen daneben kenne ich nicht."
            ),
            Beyond::Condition => {
                format!("{words}: Ich tue, was so sein soll, und kenne keine Bedingungen.")
            }
            Beyond::Direction => format!(
                "{words}: Ich gehe zu Räumen und Dingen, nicht nach Schritten und Richtungen."
            ),
            Beyond::Manner => {
                format!("{words}: Wie, wie schnell und wie oft ich etwas tue, ist meine Sache.")
            }
            Beyond::Deed => {
                format!("{words}: Ich kann nur irgendwohin gehen und Dinge irgendwohin bringen.")
            }
        }
    },
    beyond_fix: "Sag, was am Ende so sein soll.",

    the_room: "Der Raum",
    choose_world: "Einen Raum wählen",
    own_world: "Eigener",
    another_world: "Ein zufälliger Raum",
    reset: "Wie am Anfang",
    moved: "Was soll das bedeuten?",
    moved_teach: "Das lehren",
    moved_keep: "Nur umstellen",
    moved_back: "Zurückstellen",
    as_it_began: "Der Raum ist wie am Anfang.",
    room_is_for: "Was man im Raum tut",
    room_keys: "Der Raum",
    modes: [
        (
            "Zusehen",
            "Dem Roboter zusehen.",
            "Pfeiltasten gehen von Feld zu Feld, Escape verlässt sie.",
        ),
        (
            "Ändern",
            "Den Raum ändern: ein Werkzeug nehmen und auf ein Feld anwenden.",
            "Pfeiltasten gehen von Feld zu Feld, Eingabe wendet das Werkzeug an oder nimmt und setzt ab, R dreht den Roboter, Escape lässt los.",
        ),
        (
            "Lehren",
            "Zeigen, was ein Befehl bedeutet: alles dorthin bewegen, wo es sein soll, dann sagen.",
            "Pfeiltasten fahren den Roboter. Mit Umschalt gehen sie von Feld zu Feld; Eingabe nimmt und setzt ab, R dreht den Roboter, Escape lässt los.",
        ),
    ],
    worlds: ["Drei Räume", "Flur", "Lager", "Verschlossene Türen"],
    cell_by_cell: "Feld für Feld",
    model_in_use: |origin, entries, lessons| {
        let own = match origin {
            Origin::Shipped => "das der Seite".to_owned(),
            Origin::Trained(corpus) => format!("hier trainiert mit {corpus}"),
            Origin::File => "aus einer Datei".to_owned(),
        };
        let taught = if lessons > 0 { format!(", gelehrt: {lessons}") } else { String::new() };
        format!("Modell: {own}, {entries} Einträge{taught}")
    },
    cells_caption: "Der Raum, von der nördlichen Zeile zur südlichen, Felder von Westen.",

    the_plan: "Der Plan",
    play: "Abspielen",
    pause: "Anhalten",
    to_start: "Zum Anfang",
    step_back: "Schritt zurück",
    step_forward: "Schritt vor",
    step_of_plan: "Schritt des Plans",
    speed: "Tempo",
    course: "Die Schritte der Aufgabe",
    never: "nie: ",
    plan_of: |n| {
        if n == 1 {
            "Ein Plan mit einem Schritt".to_owned()
        } else {
            format!("Ein Plan mit {n} Schritten")
        }
    },
    step_of: |at, n, action| format!("Schritt {at} von {n}: {}", deed(action)),
    done_in: |n| {
        if n == 1 {
            "Fertig in einem Schritt.".to_owned()
        } else {
            format!("Fertig in {n} Schritten.")
        }
    },
    surprises: [
        "Die Tür war verschlossen. Er denkt neu nach.",
        "Er ist gerutscht: Nichts ist geschehen.",
        "Was er bewegte, blieb liegen.",
    ],

    planner: "Wie er plant",
    layers: "Was im Raum zu sehen ist",
    layer_names: ["Ziel", "Werte", "Strategie"],
    value_legend: "Was es wert ist, dort zu stehen",
    solver: "Verfahren",
    solvers: [("astar", "A*"), ("vi", "Wertiteration"), ("lrtdp", "LRTDP"), ("uct", "UCT")],
    why_chosen: "Warum",
    chosen: |why| match why {
        Why::Sure => "Nichts bleibt dem Zufall, also wird der kürzeste Plan gesucht.".to_owned(),
        Why::Small => {
            "Manches kann schiefgehen, und die Lage ist klein genug, um alles durchzurechnen."
                .to_owned()
        }
        Why::Large(most) => format!(
            "Manches kann schiefgehen, und es gibt mehr als {most} Lagen; gerechnet wird nur, was eine gute Strategie treffen kann."
        ),
        Why::Undecided => {
            "Die halbe Rechenzeit zeigte keinen Weg; nun wird alles durchgerechnet.".to_owned()
        }
        Why::Spent => {
            "Die Rechenzeit reichte nicht für einen Beweis; nun wird ausprobiert.".to_owned()
        }
    },
    states: "Zustände",
    took: "Dauer",
    milliseconds: |seconds| format!("{:.0} ms", seconds * 1000.0),
    worth: "Wert des Anfangs",
    length: "Länge",
    near_shortest: |percent| format!("höchstens {percent} % länger als der kürzeste"),
    replans: "Neu nachgedacht",
    no_plan_yet: "Es gibt noch keinen Plan: Sag ihm etwas.",
    try_many: |n| format!("{n}-mal versuchen"),
    runs: |runs| {
        let steps =
            runs.mean_steps.map(|steps| format!(", im Mittel {} Schritte", comma(steps, 1)));
        let share = f64::from(runs.successes) / f64::from(runs.runs.max(1));
        format!(
            "{} von {} Versuchen kamen an: {:.0} % [{:.0}, {:.0}]{}.",
            runs.successes,
            runs.runs,
            100.0 * share,
            100.0 * runs.interval[0],
            100.0 * runs.interval[1],
            steps.unwrap_or_default(),
        )
    },
    chart: "Wie das Verfahren sich annäherte",
    residual: "Restfehler",
    bounds: "Schranken für den Wert des Anfangs",
    steps: "Angesehene Zustände",

    rules: "Was geschehen kann",
    landmarks_stay: "Nur bewegen, was der Befehl nennt",
    can_pull: "Der Roboter kann ziehen",
    drives: "Er fährt: vorwärts, links drehen, rechts drehen",
    chance: "Zufall",
    slips: "Eine Aktion bewirkt nichts",
    locks: "Eine Tür, die niemand probiert hat, ist zu",
    loses: "Ein Ding bleibt liegen",
    other_luck: "Noch einmal mit anderem Glück",
    percent: |p| format!("{:.0} %", p * 100.0),

    tools: "Werkzeuge",
    tool_names: [
        ("Bewegen", "Den Roboter oder ein Ding ziehen. Ein Klick auf den Roboter dreht ihn."),
        ("Ding", "Auf ein freies Feld klicken, um ein Ding hinzustellen."),
        ("Raum", "Von Ecke zu Ecke ziehen, Wände mitgezählt; ein Klick in einen Raum färbt ihn."),
        (
            "Tür",
            "Auf eine Wand zwischen zwei Böden klicken. Weitere Klicks: unprobiert, verschlossen, weg.",
        ),
        ("Löschen", "Auf ein Ding, eine Tür oder den Boden eines Raums klicken."),
    ],
    shape: "Form",
    color: "Farbe",
    size: "Größe",
    no_size: "keine",
    random_world: "Zufällige Räume und Räume als Text",
    style: "Grundriss",
    styles: ["Schnitte", "Reihen", "Flur"],
    rooms: "Räume",
    columns: "Spalten",
    rows: "Zeilen",
    objects: "Dinge",
    doors: "Türen",
    lock_names: ["offen", "verschlossen", "unprobiert"],
    seed: "Startzahl",
    draw: "Zeichnen",
    as_text: "Den Raum als Text zeigen",
    hide_text: "Den Text verbergen",
    world_as_text: "Der Raum als Text: eine Karte, eine Leerzeile und eine Zeile je Zeichen",
    open_this: "Diesen Raum öffnen",
    obstacle: |obstacle| match obstacle {
        Obstacle::NoFloor => "Dort ist kein Boden.",
        Obstacle::Taken => "Dort steht schon etwas.",
        Obstacle::TooManyObjects => "Es kann 8 Dinge geben: erst eines wegnehmen.",
        Obstacle::TooManyRooms => "Es kann 12 Räume geben: erst einen wegnehmen.",
        Obstacle::TooSmall => {
            "Ein Raum hat mindestens ein Feld Boden in seinen Wänden: weiter ziehen."
        }
        Obstacle::TooLarge => "Eine Welt hat höchstens 32 Felder je Seite.",
        Obstacle::Overlap => "Räume dürfen sich Wände teilen, aber keinen Boden.",
        Obstacle::NoPassage => "Eine Tür braucht eine Wand mit Boden auf zwei Seiten.",
        Obstacle::Occupied => "Darin steht etwas: erst herausnehmen.",
        Obstacle::RobotStays => "Der Roboter bleibt.",
        Obstacle::Nothing => "Hier ist nichts zum Wegnehmen.",
        Obstacle::Blocked => "Dort kommt der Roboter nicht weiter.",
    },

    show_it: "Zeigen: den Roboter und Dinge dorthin ziehen, wo sie sein sollen, oder mit den Pfeiltasten fahren.",
    show_again: "Von vorn",
    say_it: "Sagen: Wie würde man das dem Roboter auf Englisch auftragen?",
    teach: "Lehren",
    learning: "Lernt…",
    learned: "Gelernt. Mit Sagen ausprobieren.",
    not_learned: |command| {
        format!(
            "„{command}“ war daraus nicht zu lernen: Keine Bedeutung dieser Wörter passt zum Gezeigten. Sag es näher an dem, was geschieht, oder zeig es deutlicher."
        )
    },
    missing: [
        "Noch ist nichts gezeigt: erst den Roboter oder ein Ding bewegen.",
        "Noch ist nichts gesagt: den Befehl eintippen.",
        "Zeig auch, was gemeint ist: den Roboter den ganzen Weg fahren.",
    ],
    way_counts: "Auch der Weg zählt: anhalten, sobald es getan ist.",
    straight: |rooms| {
        format!("Nur um dahin zu kommen, wäre ich anders gefahren: {rooms}. Wäre das falsch?")
    },
    unlike: "Nicht so",
    unlike_this: |rooms| format!("Nicht so: {rooms}"),
    by_end: "Keine Bedeutung dieser Wörter passt zum gezeigten Weg: Gelernt ist daraus, wo er endet.",
    lessons: "Was du gelehrt hast",
    save_lessons: "Als Korpus sichern",
    not_understood: " (nicht mehr verstanden)",
    forget: "Vergessen",
    forget_lesson: |command| format!("„{command}“ vergessen"),
    it_learned: |command, n| match n {
        0 => format!("Ich weiß, was „{command}“ heißt: Ich gewichte die Wörter jetzt anders."),
        _ => format!("Aus „{command}“ habe ich gelernt:"),
    },
    now_means: |command| format!("Ab jetzt weiß ich, was du mit „{command}“ meinst."),
    told: |words, meant| match meant {
        Meant::Nothing => format!("„{words}“ sagt für sich allein nichts."),
        Meant::Like(other) => format!("„{words}“ sagt man wie „{other}“."),
        Meant::This(this) => format!("„{words}“ heißt: {this}"),
        Meant::Other => {
            format!("„{words}“ hat jetzt eine Bedeutung, für die es keine einfachen Worte gibt.")
        }
    },
    otherwise: "So, wie ich es zuerst lese, würde es anders enden, als du gezeigt hast. Meintest du das?",
    refused: |command, refusal| match refusal {
        Refusal::Closed(word) => {
            format!("„{word}“ behält seine Bedeutung: Lehre „{command}“ ohne das Wort.")
        }
        Refusal::Known => format!("Was „{command}“ heißt, weiß ich schon. Nenn es anders."),
        Refusal::Lost => {
            "Was es heißen soll, verstehe ich nicht auf genau eine Weise. Sag erst nur diesen Teil."
                .to_owned()
        }
    },
    words: "Wörter",
    category: "Kategorie",
    meaning: "Bedeutung",

    derivation: "Wie die Wörter es ergaben",
    proof_label: "Herleitung. Pfeiltasten gehen von Teil zu Teil.",
    copy_as_text: "Als Text kopieren",
    copy_as_svg: "Als SVG kopieren",
    formula: "Wie Menschen Logik schreiben",
    form: "Wie der Parser es schreibt",
    reduction: "Wie der gewählte Teil entstand",
    all_steps: "Alle Schritte",
    from_lexicon: "So steht es im Lexikon.",
    working_out: "Wird ausgerechnet…",
    score: "Punkte",
    feature: "Merkmal",
    times: "Wie oft",
    weight: "Gewicht",
    adds: "Ergibt",
    entries: "Benutzte Einträge",
    learned_entry: "gelernt",
    seed_entry: "von Anfang an",
};

fn quoted(words: &[&str]) -> String {
    words.iter().map(|word| format!("„{word}“")).collect::<Vec<_>>().join(", ")
}

/// A number with a decimal comma.
fn comma(number: f64, digits: usize) -> String {
    format!("{number:.digits$}").replace('.', ",")
}

/// An action by its name.
fn deed(action: &str) -> &str {
    match action {
        "north" => "nach Norden",
        "south" => "nach Süden",
        "east" => "nach Osten",
        "west" => "nach Westen",
        "pull" => "ziehen",
        "forward" => "vorwärts",
        "turn_left" => "links drehen",
        "turn_right" => "rechts drehen",
        other => other,
    }
}
