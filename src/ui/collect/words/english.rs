//! Taking part in English; what each word is for stands here for all languages.

use super::table::Text;
use crate::study::ends::Refusal;
use crate::ui::collect::action::Trouble;
use crate::ui::page::grammar::English;
use crate::ui::page::keep::fault::Fault;

/// The words.
pub(super) static ENGLISH: Text = Text {
    grammar: &English,
    loading: "The study is being loaded …",
    no_study: "There is no study here",
    trouble: |trouble| match trouble {
        Trouble::Unnamed => {
            "The link names no study. Ask for the whole link: it ends with ?study= and a name."
                .to_owned()
        }
        Trouble::Elsewhere => {
            "The link names a study of another site, which this page does not open.".to_owned()
        }
        Trouble::Absent(why) => {
            format!("The study could not be loaded ({why}). Load the page again in a moment.")
        }
        Trouble::Bad(why) => format!("The study cannot be used: {why}."),
    },
    other_language: "Deutsch",

    welcome: "You will see a robot in some rooms, before and after it has done something. Say in your own words what it was told to do.",
    consent: "Taking part is voluntary. You can stop at any time, and what you have answered is then deleted. What you type is used for research, and how long it took.",
    consent_title: "Before you begin",
    posts_to: |hosts| {
        format!(
            "Your answers go to {} at the end, and nowhere else. Until then they stay in this browser.",
            hosts.join(", ")
        )
    },
    posts_nowhere: "Nothing is sent from this page: your answers stay in this browser until you hand them over yourself.",
    preview: "This is a preview: nothing is recorded or sent.",
    simulated: "This participant is simulated.",
    agree: "I agree, and take part",
    instructions_title: "What to do",
    instructions: "Each task shows the same command being carried out in several places, with a picture before and one after. Find out what all of them have in common, and write one command that would make the robot do it in every one of them. Look at all of them: one alone may mislead.",
    instructions_runs: "Each task shows the same command being carried out in several places. Play each of them to its end. Find out what all of them have in common, on the way as well, and write one command that would make the robot do it in every one of them. Watch all of them: one alone may mislead.",
    example: "An example",
    example_said: "A good command for this:",
    begin: "Begin",

    item: |at, of| format!("Task {at} of {of}"),
    ask: |n| match n {
        1 => "Write a command that makes the robot do this.".to_owned(),
        n => format!("Write one command that makes the robot do this in all {n} places."),
    },
    showing: |at| format!("Place {at}"),
    before: "Before",
    after: "After",
    show_change: "Show what changed",
    hide_change: "Hide what changed",
    play: "Play",
    pause: "Pause",
    one_step: "One step",
    step: |gone, of| format!("Step {gone} of {of}"),
    command: "Your command to the robot",
    hint: "One sentence, as you would say it to somebody.",
    next: "Next",
    kept: "Your answers are kept in this browser: you can close the page and come back.",
    keeping: "Keeping …",
    fault: |fault| {
        match fault {
        Fault::None => "This browser keeps nothing for this page, as in a private window: stay on the page until the end.".to_owned(),
        Fault::Full => "There is no room left in this browser: stay on the page until the end, or make room.".to_owned(),
        Fault::Newer | Fault::Older => "Another version of this page is open in another tab. Close it and load this one again.".to_owned(),
        Fault::Damaged => "What was kept of your answers is damaged.".to_owned(),
        Fault::Elsewhere => "Another tab goes on with this.".to_owned(),
        Fault::Other(words) => format!("Nothing is kept (the browser says “{words}”): stay on the page until the end."),
    }
    },

    elsewhere: "You have this open in another tab. Go on there, or here with what you have answered so far.",
    take: "Go on here",
    refused: "You began this before and left. This study can only be done in one go.",

    end_title: "You are nearly done",
    sending: |host| format!("Sending your answers to {host} …"),
    not_sent: |why, tries| {
        format!(
            "Your answers are not sent yet ({why}; tried {tries} times). They stay here, and it is tried again by itself. Leave the page open, or come back to it later."
        )
    },
    try_again: "Try again now",
    form: |host| format!("Send your answers to {host}."),
    submit: "Send",
    code: "This is your code. Copy it to where you were asked for it.",
    copy: "Copy the code",
    copied: "Copied.",
    go_on: "I have it, go on",
    file: "Save your answers as a file, and send it to whoever asked you to take part.",
    save: "Save the file",
    file_sent: "I have sent it",
    back: |host| format!("Go back to {host}, which will know that you are done."),
    go_back: "Go back and finish",
    refusal: |refusal| {
        match refusal {
        Refusal::Linked => "This study came inside its link, and may send nothing. Save your answers as a file instead.".to_owned(),
        Refusal::Unsafe(url) => format!("{url} is no address to send answers to: others could read them. Save your answers as a file instead."),
        Refusal::Unlisted(host) => format!("The study does not list {host}, so nothing is sent there. Save your answers as a file instead."),
        Refusal::Simulated => "Answers of a simulated participant are not sent to anybody else’s machine.".to_owned(),
        Refusal::Nowhere => "The link does not say where the answers are to go. Save them as a file instead.".to_owned(),
    }
    },
    end_preview: "Here your answers would be handed over.",

    thanks: "Thank you! You are done.",
    over_code: "Your code:",
    over_form: "Your answers were sent by a form. Whether they arrived only the other page can tell: if it did not take them, send them again. They are kept here until you delete them.",
    erased: "Nothing of it is kept in this browser any more.",
    delete: "Delete what is kept here",
    withdraw: "Withdraw",
    sure: "Delete all that you have answered here?",
    withdraw_yes: "Yes, delete it",
    withdraw_no: "No, go on",
    withdrawn: "You have withdrawn. What you had answered is deleted.",
};
