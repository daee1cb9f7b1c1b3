//! Work that rests and goes on, whatever it is.

use super::sheets::{care, sheet};
use super::{SIX, file, learn, learner, next};
use groundling::worker::protocol::{Event, Half, Request, Verdict};
use groundling::worker::reports::{REPORT_MS, Reports};
use groundling::worker::{Engine, Learner};

#[test]
fn what_is_at_work_rests_wherever_it_may() {
    let mut engine = sheet();
    care(&mut engine, Request::Decide { rows: vec![11], verdict: Verdict::Put(Half::HeldOut) });
    // While a model is judged, too, and reading rests like any job.
    engine.start(3, Request::OpenSheet { files: vec![file("six.csv", SIX)], with_rejected: false });
    engine.start(4, Request::Pause);
    assert_eq!(next(&mut engine), (4, Event::Heard));
    assert_eq!(next(&mut engine), (3, Event::Paused));
    assert!(!engine.busy());
    engine.start(5, Request::Cancel);
    assert_eq!(next(&mut engine), (3, Event::Cancelled));
    engine.start(6, Request::Resume);
    assert_eq!(next(&mut engine), (6, Event::Heard));
    assert!(!engine.busy(), "nothing is at work");
    engine.start(7, learn(1));
    engine.start(8, Request::Pause);
    while engine.busy() {
        next(&mut engine);
    }
    // Another request begins at its own pace.
    engine.start(9, learn(1));
    let mut last = None;
    while engine.busy() {
        last = Some(next(&mut engine));
    }
    assert!(matches!(last, Some((9, Event::Trained(_)))), "{last:?}");
}

#[test]
fn what_rests_or_ends_has_said_how_far_it_came() {
    // The page steps through examples faster than progress is told.
    let (mut engine, mut reports) = (learner(), Reports::new());
    let mut now = 0.0;
    let mut told = |engine: &mut Engine<Learner>, id, request| {
        engine.start(id, request);
        let mut told = Vec::new();
        while engine.busy() {
            now += REPORT_MS / 100.0;
            told.extend(
                engine.step().into_iter().flat_map(|(id, event)| reports.tell(now, id, event)),
            );
        }
        told
    };
    let seen = |told: &[(u32, Event)]| {
        let seen = told.iter().filter_map(|(_, event)| match event {
            Event::Progress(progress) => Some(progress.example),
            _ => None,
        });
        seen.collect::<Vec<usize>>()
    };
    engine.start(1, learn(9));
    for example in 1..=4 {
        let said = told(&mut engine, 2, Request::StepExample);
        assert_eq!(seen(&said), [example]);
        assert_eq!(said.last(), Some(&(1, Event::Paused)), "and then that it rests");
    }
    // What is asked besides leaves what is held where it is.
    let said = told(&mut engine, 9, Request::Look);
    assert!(matches!(&said[..], [(9, Event::Look(_))]), "{said:?}");
    let said = told(&mut engine, 10, Request::Resume);
    assert!(matches!(said.last(), Some((1, Event::Trained(_)))), "{said:?}");
    assert!(seen(&said).len() < 9 * 6, "not every example is told: {said:?}");
}
