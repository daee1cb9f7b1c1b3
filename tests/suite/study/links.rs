//! Links and ends: what a link says of who comes, and where answers may go. Both are data suites.

use groundling::study::ends::{Refusal, Source, back, hosts, target};
use groundling::study::url::{decoded, encoded};
use groundling::study::{End, Link, Study};
use proptest::prelude::{any, proptest};

fn cases(text: &str) -> impl Iterator<Item = (&str, &str)> {
    text.split("=== ").skip(1).map(|case| {
        let (given, wanted) = case.trim_end().split_once("=>").unwrap();
        (given.trim(), wanted.trim())
    })
}

#[test]
fn links_say_who_comes() {
    for (query, wanted) in cases(include_str!("../../data/study/links.txt")) {
        let link = Link::of(query);
        let mut said: Vec<String> = Vec::new();
        let simulate = link.simulate.map(|seed| seed.to_string());
        for (name, value) in [
            ("study", &link.study),
            ("worker", &link.worker),
            ("hit", &link.hit),
            ("assignment", &link.assignment),
            ("submit", &link.submit_to),
            ("simulate", &simulate),
            ("language", &link.language),
        ] {
            said.extend(value.as_ref().map(|value| format!("{name}={value}")));
        }
        if link.is_preview {
            said.push("preview".to_owned());
        }
        let mut wanted: Vec<&str> = wanted.split_whitespace().collect();
        said.sort();
        wanted.sort_unstable();
        assert_eq!(said, wanted, "{query}");
    }
}

#[test]
fn an_identifier_that_is_far_too_long_is_none() {
    assert_eq!(Link::of(&format!("?workerId={}", "x".repeat(201))).worker, None);
    assert!(Link::of(&format!("?workerId={}", "x".repeat(200))).worker.is_some());
}

#[test]
fn a_study_is_a_file_beside_the_page() {
    for file in ["a.json", "studies/a.json", "my study.json", "straße.json"] {
        assert!(Link::is_beside(file), "{file}");
    }
    for file in [
        "",
        "https://evil.example/a.json",
        "//evil.example",
        "/a.json",
        "../a.json",
        "a?b",
        "x\\y",
        "data:,",
    ] {
        assert!(!Link::is_beside(file), "{file}");
    }
}

#[test]
fn answers_go_to_listed_hosts_alone() {
    let mut study = Study::new("a", Vec::new());
    study.hosts = vec!["https://panel.example".into(), "http://127.0.0.1:8099".into()];
    for (given, wanted) in cases(include_str!("../../data/study/ends.txt")) {
        let (url, how) = given.rsplit_once(' ').unwrap();
        let source = if how == "linked" { Source::Linked } else { Source::Hosted };
        let simulate = (how == "simulated").then_some(1);
        let link = Link { simulate, ..Link::default() };
        let end = End::Endpoint { url: url.to_owned(), key: String::new() };
        let said = match target(&study, source, &end, &link) {
            Ok(Some(address)) if address == url => "post".to_owned(),
            Ok(other) => panic!("{url}: {other:?}"),
            Err(Refusal::Linked) => "linked".to_owned(),
            Err(Refusal::Unsafe(_)) => "unsafe".to_owned(),
            Err(Refusal::Unlisted(host)) => format!("unlisted {host}"),
            Err(Refusal::Simulated) => "simulated".to_owned(),
            Err(Refusal::Nowhere) => "nowhere".to_owned(),
        };
        assert_eq!(said, wanted, "{given}");
    }
}

#[test]
fn a_frames_form_goes_where_its_platform_says_if_the_study_lists_it() {
    let mut study = Study::new("a", Vec::new());
    let end = End::Form { url: None };
    let of = |submit: &str| Link { submit_to: Some(submit.to_owned()), ..Link::default() };
    let asked = |study: &Study, link: &Link| target(study, Source::Hosted, &end, link);
    assert_eq!(asked(&study, &Link::default()), Err(Refusal::Nowhere));
    let mturk = of("https://www.mturk.com/");
    assert_eq!(asked(&study, &mturk), Err(Refusal::Unlisted("www.mturk.com".into())));
    study.hosts = vec!["https://www.mturk.com".into()];
    study.ends = vec![end.clone(), End::Code];
    let address = "https://www.mturk.com/mturk/externalSubmit";
    assert_eq!(asked(&study, &mturk), Ok(Some(address.to_owned())));
    assert_eq!(hosts(&study, Source::Hosted, &mturk), ["www.mturk.com"]);
    assert_eq!(hosts(&study, Source::Linked, &mturk), [""; 0]);
}

#[test]
fn the_way_back_holds_the_code() {
    let back = back("https://panel.example/done?cc={code}&who={worker}", "AB12", "a b&c");
    assert_eq!(back, "https://panel.example/done?cc=AB12&who=a%20b%26c");
}

proptest! {
    #[test]
    fn no_query_makes_a_link_panic(query in any::<String>()) {
        let _ = Link::of(&query);
    }

    #[test]
    fn what_is_encoded_is_decoded(text in any::<String>()) {
        assert_eq!(decoded(&encoded(&text)), text);
    }
}
