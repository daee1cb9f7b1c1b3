//! Work that rests and goes on, whatever it is.

use super::sheets::{care, sheet};
use super::{SIX, file, learn, next};
use groundling::worker::protocol::{Event, Half, Request, Verdict};

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
