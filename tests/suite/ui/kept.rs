//! What is kept: the session comes back, is kept when it has changed, never over another's, and every fault is told.

use super::Page;
use groundling::ui::app::Action;
use groundling::ui::page::effect::{Effect, Timer};
use groundling::ui::page::keep::ask::{Ask, News, Place};
use groundling::ui::page::keep::copies::{Entry, items, newest_first, next};
use groundling::ui::page::keep::fault::Fault;
use groundling::ui::page::keep::state::{Origin, Stage};
use groundling::ui::talk;
use groundling::ui::talk::past::state::Outcome;
use groundling::ui::talk::share::also::Also;
use groundling::ui::talk::share::session::Session;

fn own() -> Place {
    Place::new("session", "own")
}

/// What is wanted of the store, and forgotten here.
fn wanted(page: &mut Page) -> Vec<Ask> {
    let all = std::mem::take(&mut page.others).into_iter();
    all.filter_map(|effect| match effect {
        Effect::Keep(ask) => Some(ask),
        _ => None,
    })
    .collect()
}

/// A page whose store is open, with what there was of the session.
fn opened(mut page: Page, ours: bool, found: Option<Vec<u8>>) -> Page {
    page.act(Action::Stored(News::Open));
    let claim = Ask::Claim { name: "own".to_owned(), steal: false };
    assert_eq!(wanted(&mut page), [claim]);
    page.act(Action::Stored(News::Claimed(ours)));
    assert_eq!(wanted(&mut page), [Ask::Read(own())]);
    page.act(Action::Stored(News::Read(own(), found.map(|packed| (Ok(packed), false)))));
    page
}

/// The session that a page keeps, once its timer rings.
fn kept(page: &mut Page) -> Option<(Place, Vec<u8>)> {
    page.act(Action::Rang(Timer::Keep));
    wanted(page).into_iter().find_map(|ask| match ask {
        Ask::Write(place, packed) => Some((place, packed)),
        _ => None,
    })
}

fn session() -> Vec<u8> {
    let mut page = opened(Page::told(3), true, None);
    while page.play_on() {}
    kept(&mut page).unwrap().1
}

#[test]
fn a_session_is_kept_once_it_has_changed_and_comes_back() {
    let mut page = opened(Page::ready(), true, None);
    assert_eq!(page.state.shared.keep.origin, None, "there was none");
    page.act(talk::Action::Typed("go".to_owned()));
    assert_eq!(page.timers.iter().filter(|timer| **timer == Timer::Keep).count(), 1);
    let (place, text) = kept(&mut page).unwrap();
    assert_eq!(place, own());
    assert_eq!(kept(&mut page), None, "nothing has changed since");
    let mut again = opened(Page::ready(), true, Some(text));
    assert_eq!(again.state.shared.keep.origin, Some(Origin::Last));
    assert_eq!(again.state.talk.command.input, "go");
    again.act(Action::Afresh);
    assert_eq!(again.state.talk.command.input, "");
    assert_eq!(again.state.shared.keep.origin, None);
}

#[test]
fn what_was_said_comes_back_as_it_ended() {
    let mut page = opened(Page::ready(), true, Some(session()));
    let lines = &page.state.talk.past.lines;
    assert_eq!((lines.len(), lines[0].outcome), (1, Outcome::Done(3)));
    let start = page.shown().clone();
    page.answer(groundling::worker::protocol::Event::Answer(Box::new(super::understood(
        "go",
        Some(super::plan(&start, 3)),
    ))));
    assert!(!page.play_on(), "it was seen before");
    assert_eq!(page.shown().agent.x, start.agent.x + 3);
    assert_eq!(page.state.talk.past.lines.len(), 1, "it was not said again");
}

#[test]
fn what_was_said_stands_in_its_order_when_it_comes_back() {
    let mut page = opened(Page::told(3), true, None);
    while page.play_on() {}
    page.act(talk::Action::AskExample("where are you?".to_owned()));
    let text = kept(&mut page).unwrap().1;
    let mut page = opened(Page::ready(), true, Some(text));
    let start = page.shown().clone();
    page.answer(groundling::worker::protocol::Event::Answer(Box::new(super::understood(
        "go",
        Some(super::plan(&start, 3)),
    ))));
    let said: Vec<&str> =
        page.state.talk.past.lines.iter().map(|line| line.command.as_str()).collect();
    assert_eq!(said, ["go", "where are you?"]);
}

#[test]
fn what_another_build_kept_besides_is_left_and_the_rest_comes_back() {
    let mut kept = Session::unpack(&session()).unwrap();
    let also = kept.also.clone().unwrap();
    assert_eq!(Also::unpack(&also).unwrap().pack(), also);
    let other = also.replacen('\u{1}', "\u{7f}", 1);
    assert_eq!(Also::unpack(&other), None);
    kept.also = Some(other);
    let page = opened(Page::ready(), true, Some(kept.pack()));
    assert_eq!(page.state.shared.keep.origin, Some(Origin::Last));
    assert_eq!(page.state.talk.command.input, "go");
    assert!(page.state.talk.past.lines.is_empty());
}

#[test]
fn what_is_kept_and_is_no_session_is_told_and_the_page_begins() {
    let mut page = opened(Page::ready(), true, None);
    page.act(Action::GoBack);
    wanted(&mut page);
    let before = page.state.shared.document.clone();
    page.act(Action::Stored(News::Read(own(), Some((Err("it is odd".to_owned()), false)))));
    assert!(page.state.shared.announcement.contains("it is odd"));
    page.act(Action::Stored(News::Read(own(), Some((Ok(vec![1, 2, 3]), false)))));
    assert!(page.state.shared.announcement.contains("another build"));
    assert_eq!(page.state.shared.document, before);
}

#[test]
fn nothing_is_kept_of_a_visit_on_which_nothing_was_done() {
    let mut page = opened(Page::ready(), true, None);
    page.act(talk::Action::Touched);
    assert!(!page.timers.contains(&Timer::Keep));
    assert_eq!(kept(&mut page), None);
}

#[test]
fn what_was_begun_before_is_not_lost_to_what_was_kept() {
    let mut page = Page::ready();
    page.act(talk::Action::Typed("enter".to_owned()));
    let mut page = opened(page, true, Some(session()));
    assert_eq!(page.state.shared.keep.origin, Some(Origin::New));
    let aside = Place::new("session", "before");
    // As it is, unread: what this build cannot read is not lost either.
    assert_eq!(wanted(&mut page), [Ask::Copy(own(), aside)]);
    assert_eq!(page.state.talk.command.input, "enter");
    page.act(Action::GoBack);
    assert_eq!(wanted(&mut page).last(), Some(&Ask::Read(Place::new("session", "before"))));
}

#[test]
fn a_link_has_a_place_of_its_own() {
    let mut page = Page::ready();
    page.act(Action::Linked("s=abc".to_owned()));
    page.act(Action::Stored(News::Open));
    let Some(Ask::Claim { name, .. }) = wanted(&mut page).pop() else { panic!() };
    assert!(name.starts_with("link "), "{name}");
    page.act(Action::Stored(News::Claimed(true)));
    assert_eq!(wanted(&mut page), [Ask::Read(own())]);
    page.act(Action::Stored(News::Read(own(), Some((Ok(session()), false)))));
    let link = Place::new("session", &name);
    assert_eq!(wanted(&mut page), [Ask::Read(link.clone())]);
    page.act(Action::Stored(News::Read(link.clone(), None)));
    assert_eq!(page.state.shared.keep.origin, Some(Origin::Link));
    page.act(talk::Action::Typed("go".to_owned()));
    assert_eq!(kept(&mut page).unwrap().0, link, "never over one’s own");
}

#[test]
fn a_second_tab_keeps_nothing_until_it_is_told_to() {
    let mut page = opened(Page::ready(), false, Some(session()));
    assert_eq!(page.state.shared.keep.fault, Some(Fault::Elsewhere));
    page.act(talk::Action::Typed("enter".to_owned()));
    assert_eq!(kept(&mut page), None);
    page.act(Action::KeepHere);
    let asks = wanted(&mut page);
    assert!(matches!(asks[0], Ask::Copy(..)), "what the other kept is put aside: {asks:?}");
    page.act(Action::Stored(News::Claimed(true)));
    assert!(kept(&mut page).is_some());
    page.act(Action::Stored(News::Failed(None, Fault::Elsewhere)));
    page.act(talk::Action::Typed("go".to_owned()));
    assert_eq!(kept(&mut page), None, "another tab took it");
}

#[test]
fn every_fault_has_its_words_and_the_page_goes_on() {
    let faults = [
        Fault::None,
        Fault::Newer,
        Fault::Older,
        Fault::Full,
        Fault::Damaged,
        Fault::Elsewhere,
        Fault::Other("odd".to_owned()),
    ];
    let mut words = Vec::new();
    for fault in faults {
        assert_eq!(Fault::of(fault.name()), fault);
        let mut page = opened(Page::ready(), true, None);
        page.act(Action::Stored(News::Failed(None, fault.clone())));
        assert_eq!(page.state.shared.keep.fault, Some(fault));
        words.push(page.state.shared.announcement.clone());
    }
    words.sort();
    words.dedup();
    assert_eq!(words.len(), 7);
    let mut page = opened(Page::ready(), true, None);
    page.act(talk::Action::Typed("go".to_owned()));
    let (place, text) = kept(&mut page).unwrap();
    page.act(Action::Stored(News::Failed(Some(place), Fault::Full)));
    assert_eq!(page.state.shared.keep.stage, Stage::Keeping);
    assert_eq!(kept(&mut page).map(|(_, again)| again), Some(text), "it is tried again");
    page.act(Action::Stored(News::Written));
    assert_eq!(page.state.shared.keep.fault, None);
}

#[test]
fn the_older_copy_is_written_over() {
    let entry = |copy, number| Entry {
        kind: "session".to_owned(),
        name: "own".to_owned(),
        copy,
        number,
        bytes: 10,
        sum: String::new(),
        at: f64::from(number),
    };
    assert_eq!(next(&[]), (0, 1));
    assert_eq!(next(&[entry(0, 1)]), (1, 2));
    assert_eq!(next(&[entry(0, 3), entry(1, 2)]), (1, 4));
    assert_eq!(newest_first(vec![entry(1, 2), entry(0, 3)])[0].number, 3);
    let items = items(vec![entry(0, 3), entry(1, 2)]);
    assert_eq!((items.len(), items[0].bytes, items[0].at), (1, 20, 3.0));
}
