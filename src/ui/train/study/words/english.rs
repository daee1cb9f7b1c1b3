//! Studies in English; what each word is for stands here for all languages.

use super::table::Text;
use crate::study::Flag;
use crate::study::file::{Again, Order};
use crate::ui::train::study::action::{Place, Saved, Value, Way};

/// The words.
pub(super) static ENGLISH: Text = Text {
    make_title: "Make a study",
    make_help: "People see pairs of pictures and write one command for all of them. Pairs are drawn for every task; the study is one file, to be put beside collect.html.",
    name: "Name",
    german: "In German",
    pairs: "Pairs of a task",
    shown: "Pairs shown",
    asked: "Tasks each (0: all)",
    seed: "Seed",
    cents: "Pay an answer (cents)",
    has_ways: "Show the robot’s way in place of before and after",
    checks: "Checks: tasks to see whether people look",
    checks_help: "Everybody is asked these besides. An answer must have each of the words; of words with a stroke between them, such as red/crimson, one.",
    check: "A task that checks",
    must: "Words that an answer must have",
    stop: "Stop",
    words: "Words of your own",
    says: |place| match place {
        Place::Welcome => "Welcome (empty: the page’s own)",
        Place::Consent => "Consent (empty: the page’s own)",
        Place::Instructions => "Instructions (empty: the page’s own)",
        Place::Example => "The example’s command (empty: the page’s own)",
        Place::Thanks => "Thanks (empty: the page’s own)",
    },
    order: "Order of the tasks",
    orders: |order| match order {
        Order::Shuffled => "another one for everybody",
        Order::Fixed => "as they stand in the file",
    },
    again: "Who comes again after breaking off",
    agains: |again| match again {
        Again::Resume => "goes on",
        Again::Restart => "begins anew",
        Again::Refuse => "is thanked and sent away",
    },
    hosts: "Hosts that answers may go to",
    ends: "How it ends (JSON)",
    tasks: "Tasks, as a file of them (empty: the 23 of the corpus)",
    make: "Draw it",
    making: "Drawing pairs",
    open_study: "Open a study",
    bad_ends: |error| format!("The ends are no JSON of ends: {error}."),
    made: |items| format!("The study has {items} tasks."),
    study_is: |name, items, mark| format!("“{name}”, {items} tasks, fingerprint {mark}"),
    no_study: "There is no study yet: draw one, or open one.",
    open: "What the pairs leave open",
    host_it: "Put the file beside collect.html and send people to collect.html?study=study.json; with &preview you see it as they do.",

    way: "Usual ends",
    ways: |way| match way {
        Way::File => "a code, and a file to send",
        Way::Endpoint => "a receiver of your own, and a code",
        Way::Prolific => "a receiver of your own, and back to Prolific",
        Way::Frame => "the form of a frame, as on Mechanical Turk",
    },
    preview: "See it as a participant",
    link: "A link that holds all of it",

    review_title: "Review answers",
    review_help: "Bring the files that people sent, what an endpoint received, or batch results, in any order. jsPsych’s and psiTurk’s files are mapped first.",
    bring: "Bring answers",
    counts: |all, [open, approved, rejected], [doubles, others]| {
        let more = match (doubles, others) {
            (0, 0) => String::new(),
            (doubles, others) => {
                format!(" {doubles} came again, {others} are answers to another study.")
            }
        };
        format!("{all} answers: {open} open, {approved} approved, {rejected} rejected.{more}")
    },
    flaws: "What is wrong with the files",
    bringing: "Reading files (kB)",
    unfit: |n| {
        format!(
            "{n} left out: a corpus takes no command of more than 2,000 characters or without a word."
        )
    },
    judge: "Ask the robot’s model",
    judge_by: "Ask a model of a file",
    judging: "Reading the answers",
    judged: |n| format!("The model has read {n} answers."),
    no_model: "There is no model yet.",
    only: "Only answers with",
    all: "any flag or none",
    flag: |flag| match flag {
        Flag::Unseen => "pairs not looked at",
        Flag::Fast => "too fast",
        Flag::Pasted => "pasted",
        Flag::Copied => "the example’s words",
        Flag::Same => "the same for every task",
        Flag::Foreign => "another language",
        Flag::Missed => "missed a check",
        Flag::SomePairs => "holds on some pairs only",
        Flag::NoPair => "holds on no pair",
        Flag::Unread => "the model cannot read it",
        Flag::Twin => "same as another person",
        Flag::Again => "took part more than once",
        Flag::Simulated => "simulated",
        Flag::Unfit => "too long, or no word",
    },
    reason: |flag| match flag {
        Flag::Unseen => "not all pairs were looked at",
        Flag::Fast => "the answer came too fast",
        Flag::Pasted => "the command was pasted",
        Flag::Copied => "the command is the example's",
        Flag::Same => "the same command stands for every task",
        Flag::Foreign => "the command is in another language",
        Flag::Missed => "a task that checks attention was missed",
        Flag::SomePairs | Flag::NoPair => "the command does not hold in all pairs",
        Flag::Unread => "the command cannot be understood",
        Flag::Twin => "the commands are those of another participant",
        Flag::Again => "the participant took part more than once",
        Flag::Simulated => "the participant is simulated",
        Flag::Unfit => "the command is too long, or has no word",
    },
    answer: "Answer",
    task: "Task",
    person: "Person",
    flags: "Flags",
    decision: "Decision",
    decisions: ["open", "approved", "rejected"],
    approve: "Approve",
    reject: "Reject",
    reopen: "Reopen",
    steps: |n| format!("→ {n} steps →"),
    look: "Pairs",
    before: |at| format!("Before {at}"),
    after: |at| format!("After {at}"),
    why: "Reason for rejecting",
    rule_title: "Decide what is open",
    rule: "Reject what has one of these flags, approve the rest:",
    decide: "Decide",
    decided: |approved, rejected| {
        format!("{approved} approved, {rejected} rejected. Each can be decided otherwise.")
    },
    range: |from, to, all| format!("{from} to {to} of {all}"),
    earlier: "Earlier",
    later: "Later",

    coverage: "By task",
    items: "Items",
    answers: "Answers",
    approved: "Approved",
    rejected: "Rejected",
    valid: "Hold on all pairs",
    agreement: "Agreement",
    wanted: "Answers wanted of each",
    enough: "Every task has enough answers.",
    out_title: "Take them out",
    key: "Pseudonyms made of (empty: names as they are)",
    approved_only: "Approved only",
    saved: |saved| match saved {
        Saved::Study => "Save the study",
        Saved::Table => "Batch results (CSV)",
        Saved::Lines => "JSON lines",
        Saved::Pay => "Pay sheet",
        Saved::TopUp => "Top-up study",
        Saved::Mapping => "Save the mapping",
    },
    train: "Train on them",

    survey_title: "Another program’s file",
    survey_help: |rows| {
        format!(
            "{rows} trials. Say which value is what; trials without a command and states are left out."
        )
    },
    value: |value| match value {
        Value::Command => "Command".to_owned(),
        Value::Worker => "Person".to_owned(),
        Value::Task => "Task".to_owned(),
        Value::Pre(at) => format!("Before {}", at + 1),
        Value::Post(at) => format!("After {}", at + 1),
    },
    none: "–",
    convert: "Take the answers",
    open_mapping: "Open a mapping",
    converted: |answers, others, unfinished| {
        format!(
            "{answers} answers. {others} trials without one; {unfinished} of people who did not finish left out."
        )
    },
};
