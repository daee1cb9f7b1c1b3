//! Driving a robot in English; what each word is for stands here for all languages.

use super::table::Text;
use crate::robot::address::Fault;
use crate::robot::calibration::Uncalibrated;
use crate::robot::session::Kind;
use crate::robot::sight::Unseen;
use crate::robot::trial::Untried;
use crate::robot::{Check, Halt, Stage, Told};
use crate::ui::page::grammar::English;
use crate::ui::page::world::Name;
use crate::ui::robot::state::Link;

/// The words.
pub(super) static ENGLISH: Text = Text {
    grammar: &English,
    title: "Drive a robot",
    front: "Back to the rooms",
    guide: "Guide",
    other_language: "Deutsch",
    intro: "Say what a Turtlebot should do, and it drives there: a simulated one, or your own over rosbridge. Nothing moves before a dry run, and only while you hold the key.",

    robot: "The robot",
    which: "Which robot?",
    simulated: "A simulated one",
    real: "My own",
    address: "Address of its rosbridge",
    link: "Connect",
    unlink: "Disconnect",
    start: "Start it",
    end: "Put it away",
    fault: |fault| match fault {
        Fault::NoSocket => {
            "An address of a rosbridge begins with ws:// or wss:// and names a machine, such as ws://192.168.0.20:9090."
        }
        Fault::Mixed => {
            "This page came over https, and from such a page browsers open ws:// to their own machine only. Either load this page over http (the guide says how to serve it from the robot itself), or reach the robot by wss://, or by ws://localhost through a tunnel: ssh -L 9090:localhost:9090 ROBOT."
        }
    },
    linked: |link| match link {
        Link::Off => "Not connected.",
        Link::Opening(0) => "Connecting …",
        Link::Opening(_) => "Connecting again …",
        Link::Open => "Connected.",
        Link::Lost(1) => "The link is gone. It is opened again in a moment.",
        Link::Lost(_) => "Nobody answers there. It is tried again in a moment.",
    },
    topics: "Topics and types",
    velocity: "It takes velocities on",
    pose: "It says where it is on",
    object: |look| format!("Where the {look} is, if something tracks it"),
    objects: "Things that nobody tracks are taken to be where they should be.",
    types: "Types",
    types_asked: "Ask the robot",
    kind: |kind| match kind {
        Kind::Unasked => "not asked yet".to_owned(),
        Kind::Asked => "asked …".to_owned(),
        Kind::Command(command, generation) => command.name(*generation),
        Kind::Sighting(sighting, generation) => sighting.name(*generation),
        Kind::Absent => "no such topic there".to_owned(),
        Kind::Other(name) => format!("{name}, which is of no use here"),
        Kind::Failed(why) => format!("rosapi could not say: {why}"),
    },

    place: "Where it is",
    world: "Rooms",
    world_name: |name| match name {
        Name::ThreeRooms => "Three rooms",
        Name::Hall => "A hall with two rooms",
        Name::Store => "A store of things",
        Name::Locked => "A locked door",
    },
    own_world: "Your own rooms",
    drawing: "Draw your own rooms",
    drawing_help: "A cell a character, as the front page writes a world: # is wall, a letter a room’s floor, < > ^ v the robot and where it looks. Below, what the letters are.",
    draw: "Use these rooms",
    size: "A cell measures (m)",
    here: "It stands as drawn",
    here_help: "Put the robot in the middle of the cell where it is drawn, looking the way it is drawn. Good for wheel odometry.",
    corners: "By four corners",
    corners_help: "Put the robot in four cells, one after another. Best for motion capture, and it finds how large a cell is.",
    corner: |at, of, cell| {
        format!("{at} of {of}: put the robot in the middle of {cell}, and wait until it stands.")
    },
    recalled: "This is from an earlier visit. Look whether the robot is drawn where it stands: wheel odometry begins anew when a robot is switched on.",
    note: "It stands there",
    calibrated: |size, off| match off {
        0.0 => format!("Calibrated: a cell measures {size:.2} m."),
        off => format!(
            "Calibrated: a cell measures {size:.2} m; the worst place is {:.0} % of a cell off.",
            100.0 * off
        ),
    },
    uncalibrated: |why| {
        match why {
        Uncalibrated::TooFew => "The places were one and the same. Do it again.".to_owned(),
        Uncalibrated::Mirrored => "The corners were taken the wrong way round: they fit the rooms in a mirror only. Do it again, in the order shown.".to_owned(),
        Uncalibrated::Off(off) => format!("The corners do not fit: one is {off:.1} cells off. Do it again."),
        Uncalibrated::Size(size) => format!("A cell would measure {size:.2} m, which cannot be. Do it again."),
    }
    },

    dry: "Dry run",
    dry_help: "All of this must be well before the robot may be driven. Nothing moves but in the last one, where it turns a little while you hold the key.",
    check: |check| match check {
        Check::Linked => "There is a link",
        Check::Velocity => "It takes velocities",
        Check::Poses => "It says where it is, often enough",
        Check::Bodies => "What is tracked is seen",
        Check::Calibrated => "Metres are mapped to cells",
        Check::Placed => "It stands in a room",
        Check::Stops => "Its base stops by itself when it hears nothing",
    },
    good: "well",
    bad: "not well",
    open: "not known yet",
    try_stop: "See whether it stops by itself",
    try_help: "Now hold the key: it turns a little, is left without a word, and has to stop.",
    rehearse: "Rehearse the plan",
    rehearsed: |rehearsal| match &rehearsal.halt {
        None if rehearsal.is_done => format!(
            "In rehearsal it took {:.0} seconds, and {:.0} cm were left to the nearest wall.",
            rehearsal.seconds,
            100.0 * rehearsal.nearest
        ),
        None => format!(
            "In rehearsal it would have had to think again after {:.0} seconds.",
            rehearsal.seconds
        ),
        Some(why) => format!("In rehearsal it stopped. {}", halt(why)),
    },
    came_wrong: |bad| format!("Last trouble: {bad}."),

    drive: "Drive",
    drive_help: "Hold the key to drive, let go to stop. The page stops it, too, when it is hidden, when no pose comes for half a second, and at any error.",
    speed: "At most",
    speeds: ["slow: 0.10 m/s", "usual: 0.18 m/s", "fast: 0.30 m/s"],
    arm: "Allow driving",
    disarm: "Forbid driving",
    release: "I have looked: go on",
    hold: "Hold to drive",
    hold_help: "the space bar, too",
    stop: "Stop",
    stage: |stage| match stage {
        Stage::Off => "Off: nothing is sent.".to_owned(),
        Stage::Trying(trial) if trial.is_waiting() => {
            "Hold the key to see whether it stops by itself.".to_owned()
        }
        Stage::Trying(_) => "Keep holding …".to_owned(),
        Stage::Ready => "Ready: hold the key to drive.".to_owned(),
        Stage::Driving => "Driving.".to_owned(),
        Stage::Halted(why) => format!("Stopped. {}", halt(why)),
    },
    halt,
    told: |told| {
        match told {
        Told::Stops(ms) => format!("It stops by itself, within {:.1} seconds.", f64::from(*ms) / 1000.0),
        Told::Untried(Untried::GoesOn) => "It went on turning though it heard nothing: its base has no timeout, and is not to be driven over a link. The guide says how to give it one.".to_owned(),
        Told::Untried(Untried::Still) => "It did not turn. Is it switched on, and is that the right topic?".to_owned(),
        Told::Untried(Untried::LetGo) => "You let go too early. Try it again.".to_owned(),
        Told::Drives => "It drives.".to_owned(),
        Told::Waits => "It waits.".to_owned(),
        Told::Arrived => "Done.".to_owned(),
        Told::Rethinks => "The world is not where it was expected: it thinks again.".to_owned(),
        Told::Halted(why) => format!("Stopped. {}", halt(why)),
    }
    },

    command: "Your command to the robot",
    command_hint: "go to the biggest room",
    go: "Plan",
    thinking: "It thinks …",
    loading: "What it takes to understand you is being loaded …",
    no_model: |why| format!("What it takes to understand you could not be loaded ({why})."),
    meant: "Understood:",
    which_meant: "Which of these do you mean?",
    plan: |done, of| format!("Step {done} of {of}."),
    nothing: "That was not understood. The front page says why, and can be taught.",
    unknown: |words| format!("It does not know {}.", quoted(words)),
    left_out: |words| format!("It would have to leave out {}.", quoted(words)),
    no_way: "There is no way to do that.",
    demands: |what| format!("This does not hold, or leaves no way: {what}."),
    without: "Do it without this",
    once: "See to this first, and keep to it then",
    done_already: "That is so already.",
    room: "The rooms, as the robot is seen in them",
};

fn quoted(words: &[&str]) -> String {
    words.iter().map(|word| format!("“{word}”")).collect::<Vec<_>>().join(", ")
}

fn halt(why: &Halt) -> String {
    match why {
        Halt::Emergency => "You said so.".to_owned(),
        Halt::Hidden => "The page was not to be seen.".to_owned(),
        Halt::NoPose => "No pose came for half a second.".to_owned(),
        Halt::Leapt => "Its pose leapt: was it carried?".to_owned(),
        Halt::Unlinked => "The link is gone. Its base has to stop by itself.".to_owned(),
        Halt::Backlog => "What is sent does not leave this machine.".to_owned(),
        Halt::Slept => "The page itself stood still for too long.".to_owned(),
        Halt::Bad(bad) => format!("What came in is not as it should be: {bad}."),
        Halt::Unseen(Unseen::Robot(x, y)) => {
            format!("It is seen at column {x}, row {y}, where there is no floor: calibrate again.")
        }
        Halt::Unseen(Unseen::Body(_)) => {
            "A tracked thing is seen where there is no floor.".to_owned()
        }
        Halt::Unseen(Unseen::Shared(x, y)) => {
            format!("Two things are seen at column {x}, row {y}.")
        }
        Halt::Stuck => "A step took too long: is something in its way?".to_owned(),
        Halt::TooOften => "It had to think again too often.".to_owned(),
        Halt::NoWay => "From here there is no way to do that any more.".to_owned(),
    }
}
