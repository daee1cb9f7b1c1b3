//! The page's side of the workbench: fetched when it is wanted, given files that are corpora, and heard.

use super::{Page, model};
use groundling::ui::app::Action;
use groundling::ui::app::action::View;
use groundling::ui::app::state::Bench;
use groundling::ui::page::document::Origin;
use groundling::ui::page::effect::Effect;
use groundling::ui::page::files::{self, Fault, Given, Kind};
use groundling::ui::page::news::News;
use groundling::worker::protocol::{Event, Program, Request};

#[test]
fn it_is_fetched_once_when_its_page_is_opened() {
    let mut page = Page::ready();
    assert_eq!(page.state.bench, Bench::Absent);
    page.act(Action::Go(View::Train));
    assert_eq!(page.others, [Effect::LoadWorkbench]);
    page.others.clear();
    page.act(Action::Go(View::Talk));
    page.act(Action::Go(View::Train));
    assert!(page.others.is_empty(), "it is on its way");

    page.act(Action::Loaded(Err("no network".to_owned())));
    assert_eq!(page.state.bench, Bench::Lost("no network".to_owned()));
    assert!(page.state.shared.announcement.contains("no network"));
    page.act(Action::Go(View::Train));
    assert_eq!(
        (&page.state.bench, &page.others[..]),
        (&Bench::Coming, &[Effect::LoadWorkbench][..])
    );
    page.others.clear();
    page.act(Action::Loaded(Ok(())));
    page.act(Action::Go(View::Talk));
    page.act(Action::Go(View::Train));
    assert!(page.others.is_empty() && page.state.bench == Bench::Here);
}

#[test]
fn what_it_learned_is_used_and_can_be_undone() {
    let mut page = Page::ready();
    let origin = |page: &Page| page.state.shared.document.model.as_ref().map(|m| m.origin.clone());
    let news = News::Use { text: "trained here".to_owned(), corpus: "six.csv".to_owned() };
    page.act(Action::Bench(news));
    assert_eq!(page.asked(), &Request::OpenModel { text: "trained here".to_owned() });
    page.answer(Event::Opened(model("trained here")));
    assert_eq!(origin(&page), Some(Origin::Trained("six.csv".to_owned())));
    page.act(Action::Undo);
    assert_eq!(page.asked(), &Request::OpenModel { text: "the model".to_owned() });
    assert_eq!(origin(&page), Some(Origin::Shipped));
}

#[test]
fn models_that_are_opened_at_once_each_know_where_they_come_from() {
    let mut page = Page::new();
    page.hear(Program::Talker, 0, Event::Ready);
    page.act(Action::Fetched(Ok("shipped".to_owned())));
    let news = News::Use { text: "trained here".to_owned(), corpus: "six.csv".to_owned() };
    page.act(Action::Bench(news));
    let origin = |page: &Page| page.state.shared.document.base.as_ref().map(|m| m.origin.clone());
    page.answer(Event::Opened(model("shipped")));
    assert_eq!(origin(&page), Some(Origin::Shipped));
    page.answer(Event::Opened(model("trained here")));
    assert_eq!(origin(&page), Some(Origin::Trained("six.csv".to_owned())));
}

#[test]
fn a_model_in_use_that_is_opened_from_a_file_comes_from_there() {
    let mut page = Page::ready();
    let origin = |page: &Page| page.state.shared.document.model.as_ref().map(|m| m.origin.clone());
    assert_eq!(origin(&page), Some(Origin::Shipped));
    page.act(Action::Given(Given::Model("the model".to_owned())));
    page.answer(Event::Opened(model("the model")));
    assert_eq!(origin(&page), Some(Origin::File));
}

#[test]
fn what_it_says_is_said_and_what_it_gives_is_opened() {
    let mut page = Page::ready();
    page.act(Action::Bench(News::Say("six commands".to_owned())));
    assert_eq!(page.state.shared.announcement, "six commands");
    page.act(Action::Bench(News::Give(Given::Model("a model".to_owned()))));
    assert_eq!(page.asked(), &Request::OpenModel { text: "a model".to_owned() });
    page.answer(Event::Refused { message: "not a model".to_owned() });
    assert_eq!(page.state.shared.model_notice.as_deref(), Some("not a model"));
}

#[test]
fn its_news_crosses_as_words() {
    let text = || "text".to_owned();
    for news in [
        News::Say(text()),
        News::Give(Given::Model(text())),
        News::Give(Given::Session(text())),
        News::Use { text: text(), corpus: "a.csv".to_owned() },
    ] {
        let [kind, text, corpus] = news.words().map(str::to_owned);
        assert_eq!(News::of(&kind, text, corpus), Some(news));
    }
    assert_eq!(News::of("else", text(), text()), None);
}

#[test]
fn a_file_is_what_it_says() {
    for (name, text, kind) in [
        ("a.csv", "x,y", Kind::Corpus),
        ("a.model", "anything", Kind::Model),
        ("a.txt", "groundling model 1", Kind::Model),
        ("a.json", "{\"groundling-session\":1}", Kind::Session),
        ("a.jsonl", "{\"command\":\"go\"}", Kind::Corpus),
    ] {
        assert_eq!(files::kind(name, text.as_bytes()), kind, "{name}");
    }
    assert_eq!(files::admit(0.0), Err(Fault::Empty));
    assert_eq!(files::admit(1e9), Err(Fault::TooLarge));
    assert_eq!(files::admit(1e6), Ok(()));
}
