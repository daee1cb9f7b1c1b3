//! Study files: what is read is written, what is wrong is said, and what each participant is shown is a function of the
//! study and of who they are.

use groundling::corpus::Pair;
use groundling::study::file::{Again, Order};
use groundling::study::make::{Making, of_corpus};
use groundling::study::plan::plan;
use groundling::study::rehearse::script;
use groundling::study::{End, Item, Showing, Study, TASKS, read_tasks};
use std::collections::BTreeSet;

/// A pair in which the robot goes a step.
pub(crate) fn showing(step: i32) -> Showing {
    let pre = groundling::domain::State::read(crate::corpus::PRE).unwrap();
    let mut post = pre.clone();
    post.agent.x += step;
    Showing::from(Pair::of(pre, post))
}

/// A run from where the pairs begin, with a step north as its contrast.
pub(crate) fn run(actions: &str) -> Showing {
    let start = showing(1).states().0.clone();
    Showing::from(groundling::corpus::run::of(start, actions, &["n".into()]).unwrap())
}

/// An item of so many showings.
pub(crate) fn item(id: &str, shows: usize) -> Item {
    let shows = vec![showing(1); shows];
    Item {
        id: id.to_owned(),
        task: Some(format!("task-{id}")),
        shows,
        must: Vec::new(),
        rehearsed: Vec::new(),
    }
}

/// A study of so many items.
pub(crate) fn study(items: usize) -> Study {
    Study::new("A study", (0..items).map(|n| item(&format!("i{n}"), 5)).collect())
}

#[test]
fn what_is_written_is_read() {
    let mut all = study(3);
    all.language = "de".to_owned();
    all.asked = Some(2);
    all.order = Order::Fixed;
    all.again = Again::Refuse;
    all.hosts = vec!["https://panel.example".to_owned()];
    all.ends = vec![
        End::Endpoint { url: "https://panel.example/in".into(), key: "k".into() },
        End::Form { url: None },
        End::Code,
        End::File,
        End::Return { url: "https://elsewhere.example/?cc={code}".into() },
    ];
    all.words.consent = Some("=1+1 \u{202e}right to left\n".to_owned());
    assert_eq!(Study::read(&all.write()).unwrap(), all);
    assert_eq!(Study::read(&all.write()).unwrap().fingerprint(), all.fingerprint());
    assert_ne!(study(3).fingerprint(), all.fingerprint());
    let short = r#"{"format":"groundling study","version":1,"name":"a","items":ITEMS}"#;
    let items = serde_json::to_string(&study(1).items).unwrap();
    let read = Study::read(&short.replace("ITEMS", &items)).unwrap();
    assert_eq!((read.shown, read.ends), (3, vec![End::File]));
}

#[test]
fn a_bad_study_is_refused_in_words() {
    let edit = |change: &dyn Fn(&mut Study)| {
        let mut study = study(2);
        change(&mut study);
        Study::read(&study.write()).unwrap_err().to_string()
    };
    let to = |url: &str| End::Endpoint { url: url.to_owned(), key: String::new() };
    for (said, wanted) in [
        (edit(&|s| s.items.clear()), "a study has 1 to 5000 items"),
        (edit(&|s| s.version = 2), "version 2, and no study"),
        (edit(&|s| s.shown = 0), "shown is 0"),
        (edit(&|s| s.items[1].id = "i0".into()), "two items are called i0"),
        (edit(&|s| s.items[0].shows.clear()), "the item i0 shows nothing"),
        (edit(&|s| s.ends.clear()), "the study has no end"),
        (edit(&|s| s.hosts = vec!["panel.example".into()]), "is no host to send answers to"),
        (edit(&|s| s.hosts = vec!["http://panel.example".into()]), "is no host to send answers to"),
        (edit(&|s| s.ends = vec![to("https://a.example/")]), "hosts does not list; add it"),
        (edit(&|s| s.ends = vec![End::Return { url: "javascript:x".into() }]), "no address to end at"),
        (Study::read("{").unwrap_err().to_string(), "not JSON"),
        (Study::read("{\"format\":\"groundling study\",\"version\":1,\"name\":\"a\",\"items\":[],\"more\":1}").unwrap_err().to_string(), "unknown field `more`"),
    ] {
        assert!(said.contains(wanted), "{said}\n{wanted}");
    }
    let mut outside = study(1);
    let (pre, post) = outside.items[0].shows[2].states();
    let (mut pre, post) = (pre.clone(), post.clone());
    pre.agent.x = 900;
    outside.items[0].shows[2] = Showing::from(Pair::of(pre, post));
    assert!(Study::read(&outside.write()).unwrap_err().to_string().contains("the item i0: "));
}

#[test]
fn a_run_takes_a_pairs_place() {
    let mut all = study(1);
    let start = showing(1).states().0.clone();
    all.items[0].shows = vec![run("ewe"), showing(1), run("e"), showing(1)];
    all.shown = 4;
    let text = all.write();
    assert!(text.contains("\"actions\":\"ewe\",\"contrast\":[\"n\"]"), "{text}");
    let read = Study::read(&text).unwrap();
    assert_eq!(read, all);
    let shown = &read.items[0].shows[0];
    assert_eq!((shown.steps(), showing(1).steps()), (Some(3), None));
    assert_eq!([0, 1, 2, 3].map(|steps| shown.behind(steps).agent.x - start.agent.x), [0, 1, 0, 1]);
    assert_eq!(shown.behind(9), *shown.states().1);
    for (bad, why) in [
        (text.replace("ewe", "exe"), "no action is called 'x'"),
        (
            text.replace("\"actions\":\"ewe\",", ""),
            "a pair is {pre, post}, a run is {start, actions}",
        ),
    ] {
        let said = Study::read(&bad).unwrap_err().to_string();
        assert!(said.contains(why), "{said}");
    }
    for person in ["a", "b", "c", "d"] {
        let [turn] = &plan(&read, person)[..] else { panic!("one turn") };
        let runs: Vec<bool> =
            turn.shows.iter().map(|&at| read.items[0].shows[at].steps().is_some()).collect();
        assert_eq!(runs, [false, false, true, true], "pairs stand before runs, as in an answer");
    }
}

#[test]
fn everybody_is_shown_their_own_and_the_same_again() {
    let mut all = study(8);
    all.asked = Some(4);
    all.items[7].must = vec![vec!["red".to_owned()]];
    let first = plan(&all, "anna");
    assert_eq!(first, plan(&all, "anna"));
    assert_eq!(first.len(), 5, "four, and the one that checks");
    let mut seen = BTreeSet::new();
    for n in 0..60 {
        let turns = plan(&all, &format!("p{n}"));
        let items: BTreeSet<usize> = turns.iter().map(|turn| turn.item).collect();
        assert!(items.len() == 5 && items.contains(&7));
        for turn in &turns {
            let shown: BTreeSet<usize> = turn.shows.iter().copied().collect();
            assert!(shown.len() == 3 && shown.iter().all(|&at| at < 5));
            seen.insert((turn.item, shown));
        }
    }
    assert!(seen.len() > 40, "of eight items, ten ways to show each: {}", seen.len());
    all.order = Order::Fixed;
    let items: Vec<usize> = plan(&all, "anna").iter().map(|turn| turn.item).collect();
    assert!(items.is_sorted());
}

#[test]
fn a_study_of_tasks_is_drawn_with_a_worked_example() {
    let tasks: Vec<_> = read_tasks(TASKS).unwrap().into_iter().take(2).collect();
    let mut making = Making::new(Study::new("two", Vec::new()), tasks.clone(), 4);
    let made = loop {
        if let Some(made) = making.step() {
            break made.unwrap();
        }
    };
    assert_eq!(making.progress(), (2, 2));
    let study = Study::read(&made.study.write()).unwrap();
    let ids: Vec<&str> = study.items.iter().map(|item| item.id.as_str()).collect();
    assert_eq!(ids, ["agent-in-red", "agent-in-green"]);
    assert!(study.items.iter().all(|item| item.shows.len() == 4));
    let example = study.words.example.unwrap();
    assert_eq!(
        (example.shows.len(), example.command.as_str()),
        (3, "Go and stand next to the green bag.")
    );
}

#[test]
fn a_rehearsal_says_what_people_said() {
    let text = std::fs::read_to_string("assets/corpus/six.csv").unwrap();
    let options = groundling::corpus::Options { with_rejected: true, ..Default::default() };
    let (mut corpus, _) = groundling::corpus::read(text.as_bytes(), options);
    corpus.examples[0].decision = groundling::corpus::Decision::Rejected("".into());
    let study = of_corpus(Study::new("six", Vec::new()), &corpus.examples, true);
    let careless = study.items[0].rehearsed[0].words.clone();
    let mut share = 0;
    for seed in 0..400 {
        let script = script(&study, seed);
        assert_eq!(script, groundling::study::rehearse::script(&study, seed));
        share += usize::from(script.careless);
        for (turn, act) in script.turns.iter().zip(&script.acts) {
            assert_eq!(act.words == careless, script.careless);
            assert_eq!(study.items[turn.item].rehearsed[0].words, act.words, "of its own row");
        }
    }
    assert!((20..=45).contains(&share), "about 8 %: {share} of 400");
    let plain = of_corpus(Study::new("six", Vec::new()), &corpus.examples, false);
    assert!(
        !plain.write().contains(&careless),
        "nobody who takes part finds an answer in the file"
    );
}
