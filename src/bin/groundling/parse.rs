//! `parse`: a command a line in, its readings as a JSON line out.

use super::arguments::Arguments;
use super::command::{Blank, Command, Done, answer_lines};
use super::corpora::speaker;
use super::failure::Failure;
use groundling::ccg::{ChartConfig, Explanation, parse, probability};
use groundling::ground::forbids_idly;
use groundling::logic::print;
use serde_json::{Value, json};
use std::path::PathBuf;

pub(crate) const COMMAND: Command = Command {
    name: "parse",
    about: "Say what commands mean to a model",
    usage: "--model MODEL [--best 10] [--explain] [FILE…]",
    details: "  --model MODEL  a model file\n\
              \x20 --best N       list so many forms (10)\n\
              \x20 --explain      say what each form's score is made of\n\
              In:  a command a line\n\
              Out: {\"command\", \"forms\": [{\"form\", \"score\"}], \"skipped\": [words], \"heard\"?: [{\"word\", \"as\"}],\n\
              \x20    \"probability\"?, \"asks\"?: true, \"reason\"?} a line;\n\
              \x20    all forms tied for best are listed even beyond --best\n\
              \x20    reason, where there is no single answer: empty, too_long, unknown_words, no_parse, tie, budget,\n\
              \x20    left_out (a word that turns round, excludes, joins or orders would have been dropped)\n\
              \x20    with --explain each form has an \"explanation\" too: {\"score\", \"parts\": [{\"feature\", \"count\",\n\
              \x20    \"weight\", \"adds\"}], \"entries\": [{\"words\", \"syntax\", \"meaning\", \"learned\"}]};\n\
              \x20    what the parts add, summed in their order, is the score",
    run,
};

fn run(mut arguments: Arguments) -> Result<Done, Failure> {
    use lexopt::Arg;
    let (mut model_file, mut files) = (None::<PathBuf>, Vec::new());
    let (mut best, mut explain) = (10usize, false);
    while let Some(argument) = arguments.next()? {
        match argument {
            Arg::Long("model") => model_file = Some(arguments.file()?),
            Arg::Long("best") => best = arguments.whole()?,
            Arg::Long("explain") => explain = true,
            Arg::Long("json") => {}
            Arg::Value(file) => files.push(file.into()),
            other => return Err(other.unexpected().into()),
        }
    }
    let path = model_file.ok_or_else(|| Failure::Usage("--model MODEL is missing".into()))?;
    let mut model = speaker(&path)?;
    let config = ChartConfig::of(&model);
    answer_lines(&files, Blank::IsALine, |command| {
        let parse = parse(&mut model, command, config);
        let shown = parse.readings.iter().take(best.max(parse.tied()));
        let forms: Vec<Value> = shown
            .map(|&reading| {
                let explanation = Explanation::of(&model, &parse, reading);
                let form = print(&model.grammar.terms, reading.form);
                let mut form = json!({ "form": form, "score": explanation.score });
                if explain {
                    form["explanation"] = json!(explanation);
                }
                form
            })
            .collect();
        let mut answer = json!({ "command": command, "forms": forms, "skipped": parse.skipped });
        if !parse.heard.is_empty() {
            let heard = parse.heard.iter().map(|((start, end), name)| {
                let words = parse.words.get(*start..*end).unwrap_or_default().join(" ");
                json!({ "word": words, "as": name })
            });
            answer["heard"] = heard.collect();
        }
        if let Some((probability, asks)) = probability(&model, &parse) {
            answer["probability"] = probability.into();
            let best = parse.answer().map(|reading| reading.form);
            if asks || best.is_some_and(|best| forbids_idly(&model.grammar.terms, best)) {
                answer["asks"] = true.into();
            }
        }
        if let Some(reason) = parse.reason {
            answer["reason"] = reason.name().into();
        }
        Ok(answer.to_string())
    })
}
