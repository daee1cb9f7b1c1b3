//! The Talk page in English; what each word is for stands here for all languages.

use super::table::{Faults, Helps, Meant, Text};
use crate::ui::page::document::Origin;
use crate::ui::page::grammar::English;
use crate::ui::talk::room::edit::Obstacle;
use crate::worker::protocol::{Beyond, Refusal};

/// The words.
pub(super) static ENGLISH: Text = Text {
    phrases: &English,

    copy: "Copy",
    close: "Close",
    try_again: "Try again",

    link: "Link",
    link_copied: "The link is copied.",
    link_made: "Here is the link.",
    link_help: "It holds the room, its rules, the command and what you taught. Whoever opens it gets a copy.",
    bad_link: |why| format!("This link or file cannot be opened: {why}. Nothing was changed."),
    not_saved: |why| format!("The file cannot be made: {why}. Nothing is lost: try it again."),
    save_as_file: "Save as a file",

    what_to_do: "What should the robot do?",
    tell: "Tell it",
    stop: "Stop",
    try_this: "Try",
    hello: "Tell me what to do, in English, or press an example.",
    ask_why: "Why?",
    show_grammar: "Show the grammar",
    less: "Less",
    unknown_example: "A word that I do not know yet: teach me",
    getting_ready: "Getting ready…",
    soon: "One moment: I am getting ready, and then I will do it.",
    train_one: "Train one",
    the_words: "The words as I read them",
    it_means: "I will",
    it_would_mean: "I would",
    has_steps: |n| {
        if n == 1 {
            "The plan has one step.".to_owned()
        } else {
            format!("The plan has {n} steps.")
        }
    },
    it_could: "I could",
    take_for: |own, other| format!("I take “{own}” for “{other}”."),
    which: ["Is this what you mean?", "Which do you mean?"],
    none_of_these: "None of these: I will show you",
    remember: "Remember this",
    heard_as: |word| format!("heard as “{word}”"),
    fate_empty: "means nothing by itself",
    fate_skipped: "left out",
    fate_unknown: "never seen in training",
    planning_stopped: "Stopped before there was a plan.",
    why: Faults {
        empty: (
            "There is no word in this command.",
            "Type what the robot should do, such as “go to the blue room”.",
        ),
        too_long: (
            "This command has more than 50 words; one that long is not read.",
            "Say it in fewer words, or in several commands.",
        ),
        unknown_words: (
            |words| format!("I have never seen {}.", quoted(words)),
            "Take a word that I know, or show me what you mean.",
        ),
        unknown_left_out: (
            |words| format!("I have never seen {}, and left that out.", quoted(words)),
            "See whether it still means what you meant.",
        ),
        skipped: (
            |words| format!("I left out {}.", quoted(words)),
            "See whether it still means what you meant, or show me.",
        ),
        no_parse: (
            "I know the words, but they do not fit together into a goal.",
            "Say it in another order, or show me what you mean.",
        ),
        budget: (
            "This command can be read in too many ways to look at them all.",
            "Say it in fewer words.",
        ),
        no_referent: "Name one thing that is in the room.",
        no_world: "A phrase of this command does not name exactly one thing in this room.",
        unreachable: (
            "It is understood, but the robot cannot bring it about: a wall, a door or a thing is in the way.",
            "Something may have to give:",
        ),
        blocked: (
            |demand| {
                format!("It is understood, but there is no way while this must hold: {demand}.")
            },
            "Something has to give:",
        ),
        already_broken: (
            |demand| format!("This does not hold where I stand now: {demand}."),
            "I can see to it first, and keep to it from then on.",
        ),
        broken: (
            |demand| format!("I stopped, since this does not hold any more: {demand}."),
            "Shall I go on?",
        ),
        plan_budget: (
            "It is understood, but no plan was found within the time allowed.",
            "Make it easier:",
        ),
        bad_goal: (
            "It was read as something that cannot be a goal here.",
            "Say it in another way, or show me.",
        ),
        half: |words| format!("I did not take into account: {}.", quoted(words)),
        nothing_without: |words| {
            format!(
                "I would have to leave out {}, and then it would mean something else.",
                quoted(words)
            )
        },
        half_time: "What comes first here, or is passed on the way, I did not understand. Say it in another way.",
        half_denied: "What must not happen here I did not understand. Say it in another way.",
        half_other: "See whether the rest is what you meant.",
        keeps: "There is nothing to do, and I will not remember it for later.",
        already_true: (
            "That is already so: the robot has nothing to do.",
            "Ask for something that is not so yet, or go elsewhere.",
        ),
        not_reached: (
            "This time the robot did not get there: too much went wrong.",
            "Try it again, or leave less to chance.",
        ),
    },
    help: Helps {
        say: |phrase| format!("Say “{phrase}”"),
        just: "Do just this",
        without: "Do it without this",
        once: "Do this first, and keep to it then",
        teach: "Show me what you mean",
        show: "Point at",
        add: |look| format!("Put a {look} there"),
        edit: "Change the room",
        free_landmarks: "Let it move other things",
        pull: "Let it pull",
        unlock: "Open all doors",
        no_chance: "Leave nothing to chance",
        other_world: "Go to another room",
        guide: "What I understand",
    },

    readings: "Readings",
    best_reading: "the most likely",
    all_readings: "Show all of them",
    less_likely: |gap, words| match words {
        [] => format!("scores {gap:.2} less"),
        _ => format!("scores {gap:.2} less; differs in {}", quoted(words)),
    },
    where_it_holds: "Where the goal would hold",
    phrases_title: "What it is about",

    said_before: "What you said",
    say_again: "Say it again",
    go_on: "Go on from here",
    go_on_after: |command| format!("Go on from here: after “{command}”"),
    gone_back: |command| format!("The room is as it was after “{command}”."),
    outcomes: [
        "It was so already.",
        "I asked what is meant.",
        "It cannot be done.",
        "I did not understand.",
        "I told you.",
    ],

    can_do: "I go to rooms, doors and things, and I bring things where you want them: “go to the blue room”, “put the block in the red room”. Press ? for more, with examples.",
    cannot_tell: "That I cannot tell. I can tell where a thing is, what is in a room, whether a thing is somewhere, and how many there are.",
    yes_no: ["Yes, it is.", "No, it is not."],
    beyond: |beyond, words| {
        let words = quoted(words);
        match beyond {
            Beyond::Number => format!("I do not count: {words} is beyond me."),
            Beyond::Between => {
                format!("{words}: I know “in” and “next to”, but no place between two things.")
            }
            Beyond::Door => {
                format!("{words}: a door is a place to stand in or to go through; I know none beside it.")
            }
            Beyond::Condition => format!("{words}: I do what is to be so, and know no conditions."),
            Beyond::Direction => {
                format!("{words}: I go to rooms and things, not by steps and directions.")
            }
            Beyond::Manner => {
                format!("{words}: how, how fast and how often I do a thing is my own affair.")
            }
            Beyond::Deed => format!("{words}: I can only go somewhere and bring things somewhere."),
        }
    },
    beyond_fix: "Say what should be so in the end.",

    the_room: "The room",
    choose_world: "Choose a room",
    own_world: "Your own",
    another_world: "A random room",
    reset: "As it began",
    moved: "What is that to mean?",
    moved_teach: "Teach this",
    moved_keep: "Just move it",
    moved_back: "Put it back",
    as_it_began: "The room is as it began.",
    room_is_for: "What to do in the room",
    room_keys: "The room",
    modes: [
        ("Watch", "Watch the robot.", "Arrow keys go from cell to cell, Escape leaves them."),
        (
            "Edit",
            "Change the room: take a tool and use it on a cell.",
            "Arrow keys go from cell to cell, Enter uses the tool, or takes and puts down, R turns the robot, Escape lets go.",
        ),
        (
            "Teach",
            "Show what a command means: move things to how they should be, then say it.",
            "Arrow keys drive the robot. With Shift they go from cell to cell; Enter takes and puts down, R turns the robot, Escape lets go.",
        ),
    ],
    worlds: ["Three rooms", "Hall", "Store", "Locked doors"],
    cell_by_cell: "Cell by cell",
    model_in_use: |origin, entries, lessons| {
        let own = match origin {
            Origin::Shipped => "the page’s own".to_owned(),
            Origin::Trained(corpus) => format!("trained here on {corpus}"),
            Origin::File => "from a file".to_owned(),
        };
        let taught = if lessons > 0 { format!(", taught {lessons}") } else { String::new() };
        format!("Model: {own}, {entries} entries{taught}")
    },
    cells_caption: "The room, from the north row to the south, cells from the west.",

    the_plan: "The plan",
    play: "Play",
    pause: "Pause",
    to_start: "To the start",
    step_back: "Step back",
    step_forward: "Step forward",
    step_of_plan: "Step of the plan",
    speed: "Speed",
    course: "The steps of the task",
    never: "never: ",
    plan_of: |n| {
        if n == 1 { "A plan of one step".to_owned() } else { format!("A plan of {n} steps") }
    },
    step_of: |at, n, action| format!("Step {at} of {n}: {}", action.replace('_', " ")),
    done_in: |n| {
        if n == 1 { "Done in one step.".to_owned() } else { format!("Done in {n} steps.") }
    },
    surprises: [
        "The door turned out to be locked. It thinks again.",
        "It slipped: nothing happened.",
        "What it moved stayed behind.",
    ],

    planner: "How it plans",
    layers: "What to show in the room",
    layer_names: ["Goal", "Values", "Policy"],
    value_legend: "What it is worth to stand there",
    solver: "Solver",
    solvers: [("astar", "A*"), ("vi", "Value iteration"), ("lrtdp", "LRTDP"), ("uct", "UCT")],
    why_chosen: "Why",
    chosen: |why| why.to_string(),
    states: "States",
    took: "Took",
    milliseconds: |seconds| format!("{:.0} ms", seconds * 1000.0),
    worth: "Worth of the start",
    length: "Length",
    near_shortest: |percent| format!("within {percent} % of the shortest"),
    replans: "Thought again",
    no_plan_yet: "There is no plan yet: tell it something.",
    try_many: |n| format!("Try it {n} times"),
    runs: |runs| {
        let steps = runs.mean_steps.map(|steps| format!(", {steps:.1} steps on average"));
        format!(
            "{} of {} runs got there: {:.0} % [{:.0}, {:.0}]{}.",
            runs.successes,
            runs.runs,
            100.0 * share(runs.successes, runs.runs),
            100.0 * runs.interval[0],
            100.0 * runs.interval[1],
            steps.unwrap_or_default(),
        )
    },
    chart: "How the planner closed in",
    residual: "Residual",
    bounds: "Bounds of the start's worth",
    steps: "States looked at",

    rules: "What can happen",
    landmarks_stay: "Only what the command names may be moved",
    can_pull: "The robot can pull",
    drives: "It drives: forward, turn left, turn right",
    chance: "Chance",
    slips: "An action does nothing",
    locks: "An untried door is locked",
    loses: "A thing stays behind",
    other_luck: "Try again with other luck",
    percent: |p| format!("{:.0} %", p * 100.0),

    tools: "Tools",
    tool_names: [
        ("Move", "Drag the robot or a thing. Click the robot to turn it."),
        ("Object", "Click a free cell to put a thing there."),
        ("Room", "Drag from corner to corner, walls included; click inside a room to paint it."),
        ("Door", "Click a wall between two floors. Click again: untried, locked, gone."),
        ("Erase", "Click a thing, a door, or a room's floor to take it away."),
    ],
    shape: "Shape",
    color: "Colour",
    size: "Size",
    no_size: "none",
    random_world: "Random rooms, and rooms as text",
    style: "Plan",
    styles: ["Cuts", "Rows", "Hall"],
    rooms: "Rooms",
    columns: "Columns",
    rows: "Rows",
    objects: "Objects",
    doors: "Doors",
    lock_names: ["open", "locked", "untried"],
    seed: "Seed",
    draw: "Draw",
    as_text: "Show the room as text",
    hide_text: "Hide the text",
    world_as_text: "The room as text: a map, an empty line, and a line for every mark",
    open_this: "Open this room",
    obstacle: |obstacle| match obstacle {
        Obstacle::NoFloor => "There is no floor.",
        Obstacle::Taken => "Something stands there already.",
        Obstacle::TooManyObjects => "There can be 8 objects: take one away first.",
        Obstacle::TooManyRooms => "There can be 12 rooms: take one away first.",
        Obstacle::TooSmall => {
            "A room has at least one cell of floor within its walls: drag further."
        }
        Obstacle::TooLarge => "A world has at most 32 cells a side.",
        Obstacle::Overlap => "Rooms may share walls, but not floor.",
        Obstacle::NoPassage => "A door needs a wall with floor on two opposite sides.",
        Obstacle::Occupied => "Something stands in there: move it out first.",
        Obstacle::RobotStays => "The robot stays.",
        Obstacle::Nothing => "There is nothing to take away.",
        Obstacle::Blocked => "The robot cannot go on there.",
    },

    show_it: "Show it: drag the robot and things to how they should be, or drive with the arrow keys.",
    show_again: "From the start",
    say_it: "Say it: what would you tell the robot to do this?",
    teach: "Teach",
    learning: "Learning…",
    learned: "Learned. Press Tell it to try.",
    not_learned: |command| {
        format!(
            "It could not learn “{command}” from this: no meaning of these words fits what you showed. Say it in words closer to what happens, or show it more clearly."
        )
    },
    missing: [
        "Nothing is shown yet: move the robot or a thing first.",
        "Nothing is said yet: type the command.",
        "Show what is meant, too: drive the robot all the way.",
    ],
    way_counts: "The way counts, too: stop as soon as it is done.",
    straight: |rooms| {
        format!("Only to get there I would have gone another way: {rooms}. Would that be wrong?")
    },
    unlike: "Not like this",
    unlike_this: |rooms| format!("Not like this: {rooms}"),
    by_end: "No meaning of these words fits the way that you showed: I learned from where it ends.",
    lessons: "What you taught",
    save_lessons: "Save as a corpus",
    not_understood: " (not understood any more)",
    forget: "Forget",
    forget_lesson: |command| format!("Forget “{command}”"),
    it_learned: |command, n| match n {
        0 => format!("I know what “{command}” means: I weigh its words otherwise now."),
        _ => format!("From “{command}” I learned:"),
    },
    now_means: |command| format!("From now on I know what you mean by “{command}”."),
    told: |words, meant| match meant {
        Meant::Nothing => format!("“{words}” says nothing by itself."),
        Meant::Like(other) => format!("“{words}” is said like “{other}”."),
        Meant::This(this) => format!("“{words}” means: {this}"),
        Meant::Other => format!("“{words}” has a meaning now that there are no plain words for."),
    },
    otherwise: "As I read it first, it would end otherwise than you showed. Did you mean this?",
    refused: |command, refusal| match refusal {
        Refusal::Closed(word) => {
            format!("“{word}” keeps its meaning: teach “{command}” without it.")
        }
        Refusal::Known => format!("I know what “{command}” means already. Call it something else."),
        Refusal::Lost => {
            "I do not understand in just one way what it is to mean. Say that part alone first."
                .to_owned()
        }
    },
    words: "Words",
    category: "Category",
    meaning: "Meaning",

    derivation: "How the words made it",
    proof_label: "Derivation. Arrow keys go from part to part.",
    copy_as_text: "Copy as text",
    copy_as_svg: "Copy as SVG",
    formula: "As people write logic",
    form: "As the parser writes it",
    reduction: "How the chosen part came about",
    all_steps: "All steps",
    from_lexicon: "It stands so in the lexicon.",
    working_out: "Working it out…",
    score: "Score",
    feature: "Feature",
    times: "Times",
    weight: "Weight",
    adds: "Adds",
    entries: "Entries used",
    learned_entry: "learned",
    seed_entry: "from the start",
};

fn quoted(words: &[&str]) -> String {
    words.iter().map(|word| format!("“{word}”")).collect::<Vec<_>>().join(", ")
}

fn share(part: u32, all: u32) -> f64 {
    f64::from(part) / f64::from(all.max(1))
}
