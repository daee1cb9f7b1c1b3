//! `experiment demonstration`: learn from six sentences, then do what a seventh asks that none of them names
//! (Williams et al., Section VII).

use super::options::Common;
use crate::arguments::Arguments;
use crate::corpora::{Rows, text};
use crate::failure::Failure;
use crate::figures::{report_json, report_text};
use crate::parallel::run_one;
use groundling::ccg::{ChartConfig, Model, parse};
use groundling::corpus::{Example, Options, read};
use groundling::domain::{Rules, State, text as drawing};
use groundling::ground::{Goal, Task};
use groundling::learn::DEMONSTRATION_LEXICON;
use groundling::learn::experiment::{Run, Selection};
use groundling::logic::{TermId, Terms, print, print_human};
use groundling::mdp::{Outcome, Settings, Solver};
use groundling::plan::AStar;
use serde_json::json;
use std::sync::Arc;

const SIX: &str = include_str!("../../../../assets/corpus/six.csv");
const WORLD: &str = include_str!("../../../../assets/worlds/three-rooms.txt");

/// What came of the command that was never heard.
#[derive(Default)]
struct Seventh {
    form: Option<String>,
    human: Option<String>,
    /// Why there is no form, or no plan.
    reason: Option<String>,
    plan: Vec<&'static str>,
    /// Whether the goal holds where the plan ends.
    reached: bool,
}

pub(super) fn run(mut given: Arguments) -> Result<String, Failure> {
    let mut common = Common::new();
    let (mut corpus, mut world) = (Vec::new(), None);
    let mut command = "go to the blue room".to_owned();
    while let Some(name) = given.option()? {
        match name.as_str() {
            "corpus" => corpus.extend(given.files()?),
            "command" => command = given.text()?,
            "world" => world = Some(given.file()?),
            _ => common.take(&name, &mut given)?,
        }
    }
    let rows: Arc<[Example]> = if corpus.is_empty() {
        let (six, _) = read(SIX.as_bytes(), Options::default());
        common.rows = Rows::of(&six);
        six.examples.into()
    } else {
        common.rows(&corpus)?
    };
    let place = world.as_ref().map_or("the world".to_owned(), |path| path.display().to_string());
    let own = world.as_deref().map(text).transpose()?;
    let world = match own {
        Some(own) => State::read(&own).map_err(|error| error.to_string()),
        None => drawing::read_legal(WORLD).map_err(|error| error.to_string()),
    };
    let world = world.map_err(|error| Failure::Usage(format!("{place}: {error}")))?;
    let all = Selection::all(&rows);
    let config = common.config.clone();
    let run = Run {
        name: "demonstration".to_owned(),
        train: all.clone(),
        test: all,
        config,
        paper_f1: None,
    };
    let learned = run_one(&run, common.seed(DEMONSTRATION_LEXICON)?);
    let (done, mut model) =
        learned.ok_or_else(|| Failure::Usage("the run ended without a model".into()))?;
    let seventh = obey(&mut model, &command, &world);
    Ok(if common.json {
        let Seventh { form, human, reason, plan, reached } = seventh;
        common.report(json!({
            "experiment": "demonstration", "heard": report_json(&done.outcome.report),
            "paper": PAPER, "command": command, "form": form, "human": human, "reason": reason,
            "plan": plan, "reached": reached,
            "seconds": done.learning.wall, "cpu_seconds": done.learning.cpu,
        }))
    } else {
        let mut lines = vec![format!(
            "learned {} commands in {:.3} s; asked the same again:",
            done.outcome.examples, done.learning.wall
        )];
        lines.push(report_text(&done.outcome.report));
        lines.push(format!("\nnever heard: {command}"));
        lines.extend(seventh.human.map(|human| format!("  means       {human}")));
        lines.extend(seventh.form.map(|form| format!("  form        {form}")));
        if seventh.reached {
            let plan = seventh.plan.join(" ");
            lines.push(format!("  plan        {plan}\n  it ends there: the goal holds"));
        }
        lines.extend(seventh.reason.map(|reason| format!("  not done    {reason}")));
        lines.push(format!("paper: {PAPER}"));
        common.told(&lines.join("\n"))
    })
}

/// What the paper reports.
const PAPER: &str = "the unseen “go to the blue room” was carried out (Section VII)";

/// Parses, grounds and plans a command in a world.
fn obey(model: &mut Model, command: &str, world: &State) -> Seventh {
    let parse = parse(model, command, ChartConfig::of(model));
    let terms = &model.grammar.terms;
    let mut seventh = Seventh::default();
    let Some(answer) = parse.answer() else {
        seventh.reason = parse.reason.map(|reason| reason.name().to_owned());
        return seventh;
    };
    seventh.form = Some(print(terms, answer.form));
    seventh.human = Some(print_human(terms, answer.form));
    match carry_out(terms, answer.form, world) {
        Ok((plan, reached)) => (seventh.plan, seventh.reached) = (plan, reached),
        Err(reason) => seventh.reason = Some(reason),
    }
    seventh
}

/// A shortest plan, and whether the goal holds where it ends; or why there is none.
fn carry_out(
    terms: &Terms,
    form: TermId,
    world: &State,
) -> Result<(Vec<&'static str>, bool), String> {
    let goal = Goal::new(terms, form, world).map_err(|e| e.to_string())?;
    let task = Task::new(&goal, world, Rules::default()).map_err(|e| e.to_string())?;
    if task.is_impossible() && !goal.failures().is_empty() {
        return Err("no_referent".to_owned());
    }
    let mut search = AStar::new(&task, Settings::default());
    match (search.run(), search.plan()) {
        (Outcome::Solved, Some(found)) => {
            let reached = task.replay(&found.actions).last().is_some_and(|last| goal.holds(last));
            Ok((found.actions.iter().map(|action| action.name()).collect(), reached))
        }
        (Outcome::Unreachable, _) => Err("unreachable".to_owned()),
        _ => Err("budget".to_owned()),
    }
}
