//! `review`: answers to a study in, merged, flagged and decided; tables of them out.

use super::arguments::Arguments;
use super::command::{Command, Done};
use super::corpora::{speaker, text};
use super::failure::Failure;
use super::output::{self, Output, outputs};
use groundling::corpus::Decision;
use groundling::study::coverage::{coverage, top_up};
use groundling::study::export::{Style, write};
use groundling::study::judge::Judging;
use groundling::study::pay::sheet;
use groundling::study::survey::{SurveyMapping, convert, trials};
use groundling::study::{Flag, Merged, Review, Study, merge};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};
use std::path::PathBuf;

pub(crate) const COMMAND: Command = Command {
    name: "review",
    about: "Merge, flag and decide the answers to a study",
    usage: "[--study STUDY] --answers FILE… [OPTIONS]",
    details: "  --study STUDY       the study's file; without one every answer counts\n\
              \x20 --answers FILE…     what the study's page made, an endpoint received, or batch results\n\
              \x20 --survey MAPPING    the files are jsPsych's or psiTurk's, and this says what is what;\n\
              \x20                     `propose` prints a mapping and ends\n\
              \x20 --model MODEL       ask a model whether each command holds on all the pairs that were shown\n\
              \x20 --reject FLAGS      decide what is open: reject what has one of these, separated by commas\n\
              \x20                     (unseen fast pasted copied same foreign missed some_pairs no_pair unread twin again\n\
              \x20                     simulated unfit), approve the rest\n\
              \x20 --out FILE          the answers as batch results, decisions in Approve and Reject\n\
              \x20 --json-lines        as lines of JSON instead\n\
              \x20 --pseudonyms KEY    with pseudonyms for people\n\
              \x20 --approved-only     without what is not approved\n\
              \x20 --pay FILE          what is owed to whom, as a table\n\
              \x20 --top-up N FILE     a study of what has fewer than N answers that were not rejected\n\
              \x20 --json              print one JSON object",
    run,
};

#[derive(Default)]
struct Options {
    study: Option<PathBuf>,
    answers: Vec<PathBuf>,
    survey: Option<PathBuf>,
    model: Option<PathBuf>,
    reject: Option<BTreeSet<Flag>>,
    out: Option<PathBuf>,
    style: Style,
    pay: Option<PathBuf>,
    top_up: Option<(usize, PathBuf)>,
    json: bool,
}

fn run(mut arguments: Arguments) -> Result<Done, Failure> {
    use lexopt::Arg::Long;
    let mut options = Options::default();
    while let Some(argument) = arguments.next()? {
        match argument {
            Long("study") => options.study = Some(arguments.file()?),
            Long("answers") => options.answers.extend(arguments.files()?),
            Long("survey") => options.survey = Some(arguments.file()?),
            Long("model") => options.model = Some(arguments.file()?),
            Long("reject") => options.reject = Some(wanted(&arguments.text()?)?),
            Long("out") => options.out = Some(arguments.file()?),
            Long("json-lines") => options.style.is_json = true,
            Long("pseudonyms") => options.style.pseudonyms = Some(arguments.text()?),
            Long("approved-only") => options.style.approved_only = true,
            Long("pay") => options.pay = Some(arguments.file()?),
            Long("top-up") => {
                options.top_up = Some((arguments.count()?, arguments.one_more()?.into()));
            }
            Long("json") => options.json = true,
            other => return Err(other.unexpected().into()),
        }
    }
    if options.answers.is_empty() {
        return Err(Failure::Usage("--answers FILE is missing".to_owned()));
    }
    let outputs = places(&options)?;
    let study = match &options.study {
        Some(path) => Study::read(&text(path)?)
            .map_err(|e| Failure::Usage(format!("{}: {e}", path.display())))?,
        None => Study::new("answers", Vec::new()),
    };
    let Some(merged) = merged(&options)? else { return Ok(Done::Well) };
    let Merged { answers, doubles, flaws, left_out } = merged;
    let rows = answers.len() + doubles + left_out;
    let (mut review, others) = Review::new(&study, answers);
    if let Some(path) = &options.model {
        let mut judging = Judging::new(speaker(path)?);
        review.answers().for_each(|answer| judging.step(answer));
        review.judged(&study, judging.end());
    }
    let before = review.clone();
    if let Some(flags) = &options.reject {
        review.decide_by(flags, |flag| flag.name().to_owned());
    }
    save(&options, &outputs, &study, &review)?;
    for (name, flaw) in flaws.iter().take(20) {
        // Nobody may be listening there.
        let _ = writeln!(io::stderr(), "{name}: {flaw}");
    }
    let mut report = report(&study, &review);
    report["rows"] = rows.into();
    report["left_out"] = left_out.into();
    report["doubles"] = doubles.into();
    report["other_studies"] = others.len().into();
    report["flaws"] = flaws.len().into();
    if let Some(flags) = &options.reject {
        report["told_apart"] = told_apart(&before, flags);
    }
    let outputs = outputs.iter().flatten();
    output::report(outputs, &if options.json { report.to_string() } else { told(&report) })?;
    Ok(Done::Well)
}

fn wanted(names: &str) -> Result<BTreeSet<Flag>, Failure> {
    let flag = |name: &str| {
        Flag::of(name.trim())
            .ok_or_else(|| Failure::Usage(format!("--reject {name}: no flag is called so")))
    };
    names.split(',').map(flag).collect()
}

/// The answers of all files; nothing when a mapping was only to be proposed.
fn merged(options: &Options) -> Result<Option<Merged>, Failure> {
    let mut texts = Vec::new();
    for path in &options.answers {
        texts.push((path.display().to_string(), text(path)?));
    }
    let files = || texts.iter().map(|(name, text)| (name.as_str(), text.as_str()));
    let Some(path) = &options.survey else { return Ok(Some(merge(files()))) };
    let trials = trials(files());
    if path.as_os_str() == "propose" {
        let mapping = SurveyMapping::propose(&trials).write();
        io::stdout().write_all(mapping.as_bytes()).map_err(Failure::Output)?;
        return Ok(None);
    }
    let wrong = |e: groundling::corpus::Wrong| Failure::Usage(format!("{}: {e}", path.display()));
    let mapping = SurveyMapping::read(&text(path)?).map_err(wrong)?;
    let found = convert(&trials, &mapping).map_err(wrong)?;
    if found.answers.is_empty() {
        let first =
            trials.flaws.first().map_or(String::new(), |(name, flaw)| format!(": {name}: {flaw}"));
        return Err(Failure::Usage(format!("no trial has a command and states{first}")));
    }
    // Nobody may be listening there.
    let _ = writeln!(
        io::stderr(),
        "{} answers; {} trials without one; {} of participants that did not finish left out",
        found.answers.len(),
        found.others,
        found.unfinished
    );
    let name = path.display().to_string();
    let n_rows = trials.rows.len() - found.others;
    let left_out = n_rows - found.answers.len();
    let flaws = found.flaws.into_iter().map(|flaw| (name.clone(), flaw));
    let open = found.answers.into_iter().map(|answer| (answer, Decision::Open));
    Ok(Some(Merged {
        answers: open.collect(),
        doubles: 0,
        left_out,
        flaws: trials.flaws.into_iter().chain(flaws).collect(),
    }))
}

/// The places of answers, pay and top-up.
fn places(options: &Options) -> Result<[Option<Output>; 3], Failure> {
    let others = [&options.study, &options.survey, &options.model];
    let inputs = options.answers.iter().chain(others.into_iter().flatten());
    let top_up = options.top_up.as_ref().map(|(_, path)| path.as_path());
    let named = [
        ("--out", options.out.as_deref()),
        ("--pay", options.pay.as_deref()),
        ("--top-up", top_up),
    ];
    outputs(named, inputs)
}

/// Writes the files that are wanted.
fn save(
    options: &Options,
    [out, pay, more]: &[Option<Output>; 3],
    study: &Study,
    review: &Review,
) -> Result<(), Failure> {
    if let Some(out) = out {
        let mut bytes = Vec::new();
        write(review, &options.style, &mut bytes).map_err(Failure::Output)?;
        out.write(&String::from_utf8_lossy(&bytes))?;
    }
    if let Some(pay) = pay {
        pay.write(&sheet(study, review))?;
    }
    if let (Some((wanted, _)), Some(more)) = (&options.top_up, more) {
        match top_up(study, review, *wanted) {
            Some(study) => more.write(&study.write())?,
            None => {
                // Nobody may be listening there.
                let _ =
                    writeln!(io::stderr(), "every task has {wanted} answers: no top-up is needed");
            }
        }
    }
    Ok(())
}

fn report(study: &Study, review: &Review) -> Value {
    let mut flags: BTreeMap<&str, usize> = BTreeMap::new();
    for flag in review.rows.iter().flat_map(|row| &row.flags) {
        *flags.entry(flag.name()).or_default() += 1;
    }
    let n = |is: fn(&Decision) -> bool| review.rows.iter().filter(|row| is(&row.decision)).count();
    let tasks = coverage(study, review).into_iter().map(|found| {
        json!({
            "task": found.task, "items": found.items, "answers": found.answers, "approved": found.approved,
            "rejected": found.rejected, "valid": review.is_judged().then_some(found.valid),
            "agreement": found.agreement,
        })
    });
    json!({
        "answers": review.rows.len(),
        "open": n(|d| *d == Decision::Open),
        "approved": n(|d| *d == Decision::Approved),
        "rejected": n(|d| matches!(d, Decision::Rejected(_))),
        "flags": flags,
        "tasks": tasks.collect::<Vec<_>>(),
    })
}

/// How the flags tell apart what is known of answers from elsewhere: what a file says was decided of them, or whom a
/// rehearsal played.
fn told_apart(review: &Review, flags: &BTreeSet<Flag>) -> Value {
    let (mut careless, mut caught, mut good, mut touched) = (0, 0, 0, 0);
    for row in &review.rows {
        let is_flagged = !row.flags.is_disjoint(flags);
        match (row.answer.simulated, &row.decision) {
            (Some(true), _) | (None, Decision::Rejected(_)) => {
                careless += 1;
                caught += usize::from(is_flagged);
            }
            (Some(false), _) | (None, Decision::Approved) => {
                good += 1;
                touched += usize::from(is_flagged);
            }
            (None, Decision::Open) => {}
        }
    }
    json!({ "careless": careless, "caught": caught, "good": good, "touched": touched })
}

fn told(report: &Value) -> String {
    let mut lines = vec![format!(
        "{} rows, {} left out: {} answers ({} open, {} approved, {} rejected), {} came again, {} to other studies",
        report["rows"],
        report["left_out"],
        report["answers"],
        report["open"],
        report["approved"],
        report["rejected"],
        report["doubles"],
        report["other_studies"]
    )];
    for (flag, n) in report["flags"].as_object().into_iter().flatten() {
        lines.push(format!("  {n:>5}  {flag}"));
    }
    for task in report["tasks"].as_array().into_iter().flatten() {
        let name = task["task"].as_str().unwrap_or_default();
        let (answers, agreement) = (&task["answers"], &task["agreement"]);
        // Fewer than two have nothing to agree on.
        let agreement = match answers.as_u64() {
            Some(2..) => format!(", agreement {:.2}", agreement.as_f64().unwrap_or_default()),
            _ => String::new(),
        };
        lines.push(format!("{name}: {answers} answers{agreement}"));
    }
    if let Some(found) = report.get("told_apart") {
        lines.push(format!(
            "flagged: {} of {} careless, {} of {} good",
            found["caught"], found["careless"], found["touched"], found["good"]
        ));
    }
    lines.join("\n")
}
