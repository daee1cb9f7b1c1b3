//! What the engine says of training.

use super::curve::{self, Point};
use super::state::{Pace, Run, State};
use super::words::Text;
use crate::ui::page::news::News;
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use crate::worker::protocol::{Event, Request, TrainReport};
use std::rc::Rc;

/// Milliseconds between two checkpoints: what a run may lose.
const CHECKPOINT_MS: f64 = 4_000.0;

/// How far the run is.
pub fn progressed(state: &mut State, desk: &mut Desk, event: Event) {
    let Some(run) = &mut state.run else { return };
    match event {
        Event::Progress(progress) => {
            run.clock.tick(desk.clock, &progress);
            curve::progressed(Rc::make_mut(&mut run.points), progress.clone());
            run.progress = Some(progress);
            run.is_retried = false;
            // By its events and not by a timer, which a browser holds back in a hidden tab.
            let last = run.checkpoint.as_ref().map_or(0.0, |(_, at)| *at);
            if desk.clock - last >= CHECKPOINT_MS && !desk.is_asking(&Request::Checkpoint) {
                desk.ask(Request::Checkpoint);
            }
        }
        Event::HeldOut { epoch, judgement } => {
            let points: &mut Vec<Point> = Rc::make_mut(&mut run.points);
            curve::judged(points.as_mut_slice(), epoch, *judgement);
        }
        Event::Paused => {
            run.pace = Pace::Rests;
            run.clock.rest();
            desk.say(Text::of(desk.language).rests);
            desk.ask(Request::Look);
        }
        _ => {}
    }
}

/// Something that was asked besides has been answered.
pub fn answered(state: &mut State, desk: &mut Desk, event: Event) {
    let Some(run) = &mut state.run else { return };
    match event {
        Event::Look(look) => run.look = look.map(|look| Rc::new(*look)),
        Event::Checkpoint(checkpoint) => run.checkpoint = Some((checkpoint.text, desk.clock)),
        Event::Trained(report) => used(run, desk, report),
        Event::Decisions { text } if run.decisions.is_none() => run.decisions = Some(text),
        _ => {}
    }
}

/// The run has ended.
pub fn ended(state: &mut State, desk: &mut Desk, event: Event) {
    let text = Text::of(desk.language);
    let Some(run) = &mut state.run else { return };
    run.clock.rest();
    match event {
        Event::Trained(report) => {
            run.pace = Pace::Over;
            run.model = Some(Rc::from(report.model.as_str()));
            desk.say((text.trained)(report.valid, report.examples));
            used(run, desk, report);
            desk.ask(Request::Checkpoint);
        }
        Event::Cancelled => {
            run.pace = Pace::Stopped;
            state.notice = Some(text.stopped.to_owned());
            desk.say(text.stopped);
            desk.ask(Request::Checkpoint);
        }
        Event::Refused { message } => {
            run.pace = Pace::Stopped;
            run.checkpoint = None;
            desk.say(message.clone());
            state.notice = Some(message);
        }
        _ => {}
    }
}

/// The robot uses a run's model from now on.
fn used(run: &Run, desk: &mut Desk, report: TrainReport) {
    let news = News::Use { text: report.model, corpus: run.corpus.clone() };
    desk.want(Effect::Tell(news));
}
