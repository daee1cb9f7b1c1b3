//! Studies: the file of tasks, the pairs that are drawn for them, and the command that writes both.

use crate::command::{answers, call};
use crate::dynamics::chances::Draws;
use groundling::corpus::{Options, Pair, read};
use groundling::domain::{Blueprint, Bounds, Color, Lock, Size, State, Style};
use groundling::ground::Goal;
use groundling::logic::{TermId, Terms, read as form};
use groundling::study::{
    DrawError, Drawing, Drawn, Paint, Saying, StudyTask, TASKS, draw, read_tasks,
};
use std::collections::BTreeSet;
use std::path::PathBuf;

#[path = "study/command.rs"]
mod collecting;
#[path = "study/files.rs"]
pub(crate) mod files;
#[path = "study/links.rs"]
mod links;
#[path = "study/reviews.rs"]
pub(crate) mod reviews;
#[path = "study/sittings.rs"]
mod sittings;
#[path = "study/surveys.rs"]
mod surveys;

fn tasks() -> Vec<StudyTask> {
    read_tasks(TASKS).unwrap()
}

fn said(voice: Option<&str>, words: &str) -> Saying {
    Saying { voice: voice.map(str::to_owned), words: words.to_owned() }
}

fn term(terms: &mut Terms, text: &str) -> TermId {
    form(terms, text).unwrap_or_else(|e| panic!("{text}: {e}"))
}

#[test]
fn the_corpus_has_twenty_three_tasks() {
    let tasks = tasks();
    assert_eq!(tasks.len(), 23);
    let goals: BTreeSet<&str> = tasks.iter().map(|t| t.goal.as_str()).collect();
    assert_eq!(goals.len(), 23);
    let chair = tasks.iter().find(|t| t.name == "agent-near-red-chair").unwrap();
    assert_eq!(chair.says, [said(None, "Go next to the red chair.")]);
    assert_eq!(chair.things[0].paint, Paint::Is(Color::Red));
    assert_eq!(chair.rooms, [Color::Red, Color::Green, Color::Blue].map(Paint::Is));
    assert!(!chair.apart && tasks.iter().any(|t| t.apart));
}

#[test]
fn pairs_show_their_task_and_nothing_else() {
    let tasks = tasks();
    for task in &tasks {
        for seed in 0..4 {
            let drawn = draw(&tasks, &task.name, 3, seed).unwrap_or_else(|e| panic!("{e}"));
            assert_eq!(drawn.pairs.len(), 3);
            assert_eq!(drawn.open, [""; 0], "{} seed {seed}", task.name);
            let mut terms = Terms::new();
            let goal = term(&mut terms, &task.goal);
            let readings = tasks.iter().map(|t| &t.goal).filter(|g| **g != task.goal);
            let readings: Vec<TermId> =
                readings.chain(&task.unlike).map(|text| term(&mut terms, text)).collect();
            let explains = |reading: TermId| {
                drawn.pairs.iter().all(|pair| {
                    let goal = Goal::new(&terms, reading, &pair.pre).unwrap();
                    !goal.holds(&pair.pre) && goal.holds(&pair.post)
                })
            };
            assert!(explains(goal));
            assert!(!readings.iter().any(|&r| explains(r)), "{} seed {seed}", task.name);
            for pair in &drawn.pairs {
                pair.pre.check().unwrap();
                pair.post.check().unwrap();
                let movable = Goal::new(&terms, goal, &pair.pre).unwrap().movable(&pair.pre);
                for (i, before) in pair.pre.objects.iter().enumerate() {
                    assert!(movable.allows(i) || pair.post.objects[i] == *before, "{}", task.name);
                }
            }
        }
    }
}

#[test]
fn looks_and_sizes_are_as_asked() {
    let tasks = tasks();
    for task in &tasks {
        for pair in draw(&tasks, &task.name, 4, 9).unwrap().pairs {
            let colors: BTreeSet<Color> = pair.pre.rooms.iter().map(|r| r.color).collect();
            assert_eq!(colors, [Color::Red, Color::Green, Color::Blue].into());
            for (look, object) in task.things.iter().zip(&pair.pre.objects) {
                assert_eq!(look.shape, object.shape);
                match look.paint {
                    Paint::Is(color) => assert_eq!(object.color, color),
                    Paint::Any => {}
                    Paint::Other => {
                        let like = task.things.iter().filter(|t| t.shape == look.shape);
                        assert!(like.into_iter().all(|t| t.paint != Paint::Is(object.color)));
                    }
                }
            }
            let mut sizes: Vec<i64> = pair.pre.rooms.iter().map(|r| r.bounds.area()).collect();
            sizes.sort_unstable();
            let apart = sizes.windows(2).all(|s| s[1] * 4 >= s[0] * 5);
            assert!(apart || !task.apart);
        }
    }
}

#[test]
fn worlds_begin_and_end_as_asked() {
    let inside = |of: &str| format!("(in:<e,<e,t>> (the:<<e,t>,e> {of}:<e,t>) $0)");
    let somewhere = |of: &str| {
        format!("(exists:<<e,t>,t> (lambda $0:e (and:<t*,t> (room:<e,t> $0) {})))", inside(of))
    };
    let text = format!(
        "task bag\nsays one: To the bag with you.\nsays two: Stand by the bag.\n\
         goal (near:<e,<e,t>> (the:<<e,t>,e> agent:<e,t>) (the:<<e,t>,e> bag:<e,t>))\n\
         before (not:<t,t> {})\nafter {}\nrooms red red other other any\nthing large any bag\ndoorway",
        somewhere("agent"),
        somewhere("agent"),
    );
    let tasks = read_tasks(&text).unwrap();
    assert_eq!(
        tasks[0].says,
        [said(Some("one"), "To the bag with you."), said(Some("two"), "Stand by the bag.")]
    );
    let Drawn { pairs, .. } = draw(&tasks, "bag", 4, 1).unwrap();
    for Pair { pre, post, .. } in pairs {
        let room = |state: &State| {
            let at = |b: &Bounds| {
                let (x, y) = (state.agent.x, state.agent.y);
                b.left < x && x < b.right && b.bottom < y && y < b.top
            };
            state.rooms.iter().any(|r| at(&r.bounds))
        };
        assert!(!room(&pre) && room(&post), "out of a doorway");
        assert_eq!(pre.objects[0].size, Some(Size::Large));
        let red = pre.rooms.iter().filter(|r| r.color == Color::Red).count();
        let others: BTreeSet<Color> = pre.rooms.iter().map(|r| r.color).collect();
        assert!(pre.rooms.len() == 5 && red >= 2 && others.len() >= 3);
    }
}

#[test]
fn pairs_are_a_function_of_task_and_seed() {
    let mut tasks = tasks();
    let name = "chair-near-block";
    let first = draw(&tasks, name, 3, 5).unwrap();
    assert_eq!(draw(&tasks, name, 3, 5).unwrap(), first);
    assert_ne!(draw(&tasks, name, 3, 6).unwrap(), first);
    tasks.reverse();
    assert_eq!(draw(&tasks, name, 3, 5).unwrap(), first, "wherever it stands in the file");
    let one = draw(&tasks, "agent-in-biggest", 1, 0).unwrap();
    assert!(!one.open.is_empty(), "the biggest room has a colour");
}

#[test]
fn drawing_can_be_pumped() {
    let tasks = tasks();
    let mut drawing = Drawing::new(&tasks, "block-in-blue", 3, 2).unwrap();
    let mut most = 0;
    let drawn = loop {
        let before = drawing.progress();
        if let Some(ended) = drawing.step() {
            break ended.unwrap();
        }
        assert!(drawing.progress() <= before + 1, "a step tries one world");
        most = drawing.progress();
    };
    assert_eq!((most, Ok(drawn)), (3, draw(&tasks, "block-in-blue", 3, 2)));
}

#[test]
fn no_text_makes_the_reader_of_tasks_panic() {
    let whole: Vec<&str> = TASKS.lines().filter(|l| !l.is_empty()).collect();
    for seed in 0..400 {
        let mut draws = Draws::new(seed);
        let lines = (0..12).map(|_| {
            let line = whole[draws.below(whole.len() as u64) as usize];
            let (from, to) = (draws.below(40) as usize, draws.below(200) as usize);
            let kept = line.chars().skip(if from > 20 { 0 } else { from }).take(to);
            kept.collect::<String>() + ["", " é", "(", "\t"][draws.below(4) as usize]
        });
        // Whatever it says to that.
        let _ = read_tasks(&lines.collect::<Vec<_>>().join("\n"));
    }
}

/// A task that is whole, with further lines.
fn file(lines: &str) -> String {
    let goal = "(near:<e,<e,t>> (the:<<e,t>,e> agent:<e,t>) (the:<<e,t>,e> bag:<e,t>))";
    format!("task near-bag\nsays Go to the bag.\ngoal {goal}\n{lines}")
}

#[test]
fn a_bad_file_of_tasks_is_refused_with_its_line() {
    assert_eq!(read_tasks(&file("thing any bag\n")).unwrap().len(), 1);
    for (text, expected) in [
        (String::new(), "line 1: there is no task: begin with `task NAME`"),
        ("says Go.".into(), "line 1: `says` stands before the first task"),
        ("task a\nsays Go.\n\ntask b".into(), "line 1: the task `a` has no line `goal`"),
        ("# x\ntask".into(), "line 2: a task needs a name"),
        (file("task near-bag"), "line 4: a second task is called `near-bag`"),
        (file("says Once more."), "line 4: a second `says`"),
        (file("says one: Once more."), "line 4: a second `says`"),
        (file("says one:"), "line 4: a second `says`"),
        ("task a\nsays one: Go.\nsays two: Go.".into(), "line 3: the same words stand there"),
        ("task a\nsays".into(), "line 2: `says` needs words"),
        (file("goal true:t"), "line 4: a second `goal`"),
        (file("thing red"), "line 4: `thing` needs a colour and a shape, like `thing red chair`"),
        (file("thing pink bag"), "line 4: unknown colour `pink`: use one of red"),
        (file("thing red sofa"), "line 4: unknown shape `sofa`: use one of chair"),
        (file(&"thing any bag\n".repeat(9)), "line 12: more than 8 things"),
        (file("thing huge red bag"), "line 4: unknown size `huge`: use one of small"),
        (file("rooms red green"), "line 4: `rooms` needs 3 to 6 colours"),
        (file("rooms red green pink"), "line 4: unknown colour `pink`: use one of red"),
        (file("before red:<e,t>"), "line 4: a goal has type t"),
        (file("unlike red:<e,t>"), "line 4: a goal has type t"),
        (file("unlike (near"), "line 4: column "),
        (file("colour red"), "line 4: `colour` is unknown here: use task, says"),
    ] {
        let error = read_tasks(&text).unwrap_err().to_string();
        assert!(error.starts_with(expected), "{text}\n{error}");
    }
}

#[test]
fn a_task_without_a_world_is_refused_with_the_reason() {
    let why = |lines: &str| {
        let tasks = read_tasks(&file(lines)).unwrap();
        draw(&tasks, "near-bag", 1, 0).unwrap_err()
    };
    let none = why("thing any chair").to_string();
    assert!(none.contains("`near-bag`") && none.ends_with("a phrase of its goal does not refer"));
    assert_eq!(why("thing any bag\nthing any bag"), why(""), "two are as bad as none");
    let tasks = tasks();
    assert!(matches!(draw(&tasks, "dance", 1, 0), Err(DrawError::BadTask { .. })));
}

#[test]
fn the_command_writes_a_corpus() {
    let generate = |more: &[&str]| {
        let all = ["generate", "--tasks", "all", "--pairs", "2", "--seed", "3"];
        call(&[&all, more].concat(), "")
    };
    let csv = generate(&[]);
    assert!(csv.status.success(), "{csv:?}");
    assert_eq!(csv.stdout, generate(&[]).stdout);
    let (corpus, flaws) = read(&csv.stdout[..], Options::default());
    assert!(flaws.is_empty(), "{flaws:?}");
    assert_eq!(corpus.examples.len(), 23);
    let lines = generate(&["--json"]);
    let (same, flaws) = read(&lines.stdout[..], Options::default());
    assert!(flaws.is_empty(), "{flaws:?}");
    let tasks = tasks();
    for ((a, b), task) in corpus.examples.iter().zip(&same.examples).zip(&tasks) {
        assert_eq!((&a.id, &a.command, &a.task, &a.pairs), (&b.id, &b.command, &b.task, &b.pairs));
        assert_eq!((a.task.as_ref(), &a.command), (Some(&task.name), &task.says[0].words));
        assert_eq!(a.pairs, draw(&tasks, &task.name, 2, 3).unwrap().pairs);
    }
    assert_eq!(answers(&lines)[0]["task"], "agent-in-red");
}

#[test]
fn the_command_builds_worlds() {
    let output = call(
        &[
            "generate",
            "--worlds",
            "3",
            "--rooms",
            "6",
            "--columns",
            "20",
            "--rows",
            "14",
            "--objects",
            "5",
            "--style",
            "hall",
            "--lock",
            "unknown",
            "--seed",
            "8",
        ],
        "",
    );
    assert!(output.status.success(), "{output:?}");
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(text.lines().count(), 3);
    let plan = Blueprint {
        style: Style::Hall,
        rooms: 6,
        columns: 20,
        rows: 14,
        objects: 5,
        lock: Lock::Unknown,
        connected: true,
    };
    for (seed, line) in (8..).zip(text.lines()) {
        assert_eq!(State::read(line).unwrap(), plan.build(seed).unwrap());
    }
}

#[test]
fn the_command_refuses_in_a_line() {
    let bad = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("bad-tasks.txt");
    std::fs::write(&bad, "task a\n").unwrap();
    let bad = bad.to_str().unwrap();
    for (arguments, expected) in [
        (&["--pairs", "3"][..], "--tasks FILE|all is missing, or --goal FORM"),
        (&["--tasks", "all", "--pairs", "0"], "--pairs 0: use 1 to 100"),
        (&["--tasks", "all", "--pairs", "x"], "--pairs needs a whole number, not x"),
        (&["--tasks", "all", "--seed", "-1"], "--seed must be at least 0, not -1"),
        (&["--tasks", "nowhere.txt"], "cannot read nowhere.txt"),
        (&["--tasks", bad], "line 1: the task `a` has no line `goal`"),
        (&["--tasks", "all", "more"], "unexpected argument"),
        (&["--tasks", "all", "--fast"], "invalid option '--fast'"),
        (
            &["--tasks", "all", "--rooms", "4"],
            "--tasks is for pairs of states and --rooms for worlds",
        ),
        (&["--rooms", "4"], "--worlds N is missing"),
        (&["--worlds", "1", "--rooms", "40"], "the world of seed 0: 40 rooms: use 3 to 12"),
        (&["--worlds", "1", "--style", "maze"], "use one of cuts, rows, hall"),
    ] {
        let output = call(&[&["generate"], arguments].concat(), "");
        let error = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{error}");
        assert!(error.contains(expected) && error.lines().count() == 1, "{error}");
    }
}
