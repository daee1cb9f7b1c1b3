//! Mechanical Turk's batch-results CSV, in and out, with the quirks of real files: columns in any order and
//! found by name, rows without their last cells, answers of crowd-html forms as JSON in one cell.

use super::admit::{EMPTY, Options, check_command, not_a_corpus};
use super::cell::{self, Moment};
use super::example::{Corpus, Example, Flaw, MAX_CELL_BYTES, MAX_PAIRS, MAX_ROWS, Row};
use super::record::{Fault, Record, Records};
use std::collections::BTreeMap;
use std::io::{Read, Write};

const TASK: &str = "Input.task";
const COMMAND: &str = "Answer.command";
const FORM: &str = "Answer.taskAnswers";
const PRE: &str = "Input.pre_";
const POST: &str = "Input.post_";

/// The columns of a batch-results file before those of the task's own inputs and answers.
const PLATFORM: [&str; 27] = [
    "HITId",
    "HITTypeId",
    "Title",
    "Description",
    "Keywords",
    "Reward",
    "CreationTime",
    "MaxAssignments",
    "RequesterAnnotation",
    "AssignmentDurationInSeconds",
    "AutoApprovalDelayInSeconds",
    "Expiration",
    "NumberOfSimilarHITs",
    "LifetimeInSeconds",
    "AssignmentId",
    "WorkerId",
    "AssignmentStatus",
    "AcceptTime",
    "SubmitTime",
    "AutoApprovalTime",
    "ApprovalTime",
    "RejectionTime",
    "RequesterFeedback",
    "WorkTimeInSeconds",
    "LifetimeApprovalRate",
    "Last30DaysApprovalRate",
    "Last7DaysApprovalRate",
];

/// What a column is to us.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Role {
    Task,
    Pre(usize),
    Post(usize),
    Command,
    Other,
}

/// A reader of a batch-results file, row by row.
pub struct Reader<R> {
    records: Records<R>,
    options: Options,
    columns: Vec<String>,
    roles: Vec<Role>,
    /// The columns of each demonstration, before and after.
    pairs: Vec<(usize, usize)>,
    rows: usize,
    ended: bool,
}

impl<R: Read> Reader<R> {
    /// Reads the header.
    ///
    /// # Errors
    /// Why the file is not a batch-results file: empty, not text, not CSV, a column missing.
    pub fn new(source: R, options: Options) -> Result<Self, Flaw> {
        let fault = |fault: Fault| Flaw::of_file(fault.to_string());
        let mut records = Records::new(source).map_err(fault)?;
        if let Some(reason) = not_a_corpus(records.head()) {
            return Err(Flaw::of_file(reason));
        }
        let header = match records.next_record() {
            None => return Err(Flaw::of_file(EMPTY)),
            Some(header) => header.map_err(fault)?,
        };
        let header_flaw = |message: String| Flaw { line: header.line, ..Flaw::of_file(message) };
        let columns: Vec<String> = header.cells.iter().map(|name| name.trim().to_owned()).collect();
        if header.not_text.is_some() || header.cut.is_some() {
            return Err(header_flaw(
                "the header is not text; save the file as CSV in UTF-8".into(),
            ));
        }
        let (roles, pairs) = roles(&columns).map_err(header_flaw)?;
        Ok(Reader { records, options, columns, roles, pairs, rows: 0, ended: false })
    }

    /// All columns, in the file's order.
    pub fn columns(&self) -> &[String] {
        &self.columns
    }

    /// Bytes read so far, for progress.
    pub fn bytes(&self) -> u64 {
        self.records.bytes()
    }

    fn column(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| column == name)
    }

    fn row(&mut self, record: &Record) -> Row {
        if let Some(flaw) = self.misshapen(record) {
            if record.lines > 1 {
                self.records.resume_at_second_line();
            }
            return Row::bad(flaw);
        }
        let cell = |name: &str| {
            let text = self.column(name).and_then(|at| record.cells.get(at));
            text.map(|text| text.trim()).filter(|text| !text.is_empty())
        };
        let status = cell("AssignmentStatus").is_some_and(|s| s.eq_ignore_ascii_case("rejected"));
        if !self.options.with_rejected && (status || cell("Reject").is_some()) {
            return Row { rejected: true, ..Row::default() };
        }
        let mut flaws = Vec::new();
        let mut flaw = |column: &str, message: String| {
            flaws.push(Flaw::of_row(record.line, Some(column), message));
        };
        let name_of = |at: usize| self.columns.get(at).map_or("?", String::as_str);
        if let Some(at) = record.not_text {
            flaw(name_of(at), "the cell is not UTF-8 text; save the file as CSV in UTF-8".into());
        }
        if let Some(at) = record.cut {
            flaw(name_of(at), format!("the cell is larger than {} MB", MAX_CELL_BYTES >> 20));
        }
        let mut good = record.not_text.is_none() && record.cut.is_none();
        let command = match self.command(record) {
            Ok(command) => command,
            Err((column, message)) => {
                flaw(column, message);
                good = false;
                String::new()
            }
        };
        let mut pairs = Vec::new();
        for &(pre, post) in &self.pairs {
            let at = |at: usize| record.cells.get(at).map(|text| text.trim()).unwrap_or_default();
            if at(pre).is_empty() && at(post).is_empty() && !pairs.is_empty() {
                continue; // a row may have fewer demonstrations than the file has columns
            }
            if record.cells.len() <= pre.max(post) {
                let (got, want) = (record.cells.len(), self.columns.len());
                flaw(name_of(pre.max(post)), format!("the row ends after {got} of {want} cells"));
                good = false;
                continue;
            }
            let found = cell::demonstration(at(pre), at(post), |moment, message| {
                flaw(name_of(if moment == Moment::Before { pre } else { post }), message);
            });
            good &= found.is_some();
            pairs.extend(found);
        }
        flaws.iter_mut().for_each(|flaw| flaw.kept = good);
        let example = good.then(|| Example {
            id: cell("AssignmentId").map_or_else(|| format!("line {}", record.line), str::to_owned),
            line: record.line,
            command,
            task: cell(TASK).map(str::to_owned),
            worker: cell("WorkerId").map(str::to_owned),
            pairs,
            rest: self.rest(record),
        });
        Row { example, rejected: false, flaws }
    }

    /// Why a record is not this table's: its quotes or commas are wrong.
    fn misshapen(&self, record: &Record) -> Option<Flaw> {
        let (got, want) = (record.cells.len(), self.columns.len());
        if let Some(at) = record.stray {
            let message = "text follows a closing quote; a quote is missing, or stands in the text \
                           and must be doubled";
            let column = self.columns.get(at).map(String::as_str);
            return Some(Flaw::of_row(record.line, column, message));
        }
        (got > want).then(|| {
            let message = format!(
                "the row has {got} cells, the header {want}; quote the cells that hold a comma"
            );
            Flaw::of_row(record.line, None, message)
        })
    }

    /// The command of a row; else the column to blame and the reason.
    fn command(&self, record: &Record) -> Result<String, (&'static str, String)> {
        let text = |name: &str| {
            let text = self.column(name).and_then(|at| record.cells.get(at));
            text.map(|text| text.trim().to_owned()).filter(|text| !text.is_empty())
        };
        let (column, command) = match (text(COMMAND), text(FORM)) {
            (Some(command), _) => (COMMAND, command),
            (None, Some(form)) => (FORM, form_command(&form).map_err(|e| (FORM, e))?),
            (None, None) if self.column(COMMAND).is_some() => (COMMAND, String::new()),
            (None, None) => (FORM, String::new()),
        };
        check_command(&command).map_err(|message| (column, message))?;
        Ok(command)
    }

    fn rest(&self, record: &Record) -> Vec<String> {
        let cells = record.cells.iter().map(Some).chain(std::iter::repeat(None));
        let pairs = self.roles.iter().zip(cells).filter(|(role, _)| **role == Role::Other);
        pairs.map(|(_, cell)| cell.cloned().unwrap_or_default()).collect()
    }
}

impl<R: Read> Iterator for Reader<R> {
    type Item = Row;

    fn next(&mut self) -> Option<Row> {
        if self.ended {
            return None;
        }
        let record = match self.records.next_record() {
            Some(Ok(record)) => record,
            Some(Err(fault)) => {
                self.ended = fault.is_final();
                let message = fault.to_string();
                return Some(Row::bad(match fault {
                    Fault::Unclosed { line } => Flaw::of_row(line, None, message),
                    _ => Flaw::of_file(message),
                }));
            }
            None => {
                self.ended = true;
                let none = "the file has a header and no rows";
                return (self.rows == 0).then(|| Row::bad(Flaw::of_file(none)));
            }
        };
        self.rows += 1;
        if self.rows > MAX_ROWS {
            self.ended = true;
            let message = format!("more than {MAX_ROWS} rows; the rest was not read");
            return Some(Row::bad(Flaw::of_file(message)));
        }
        Some(self.row(&record))
    }
}

/// Writes a corpus as a batch-results file: its own columns if it has any, otherwise the platform's.
/// Every cell is quoted, lines end in CR LF, as the platform writes them.
///
/// # Errors
/// Those of `out`.
pub fn write(corpus: &Corpus, out: impl Write) -> std::io::Result<()> {
    let standard;
    let columns = if corpus.columns.is_empty() {
        standard = standard_columns(corpus);
        &standard
    } else {
        &corpus.columns
    };
    let mut out = csv::WriterBuilder::new()
        .quote_style(csv::QuoteStyle::Always)
        .terminator(csv::Terminator::CRLF)
        .from_writer(out);
    out.write_record(columns)?;
    for example in &corpus.examples {
        let mut rest = example.rest.iter();
        for column in columns {
            let state = |n: usize, pick: fn(&super::Pair) -> &crate::domain::State| {
                example.pairs.get(n - 1).map(|pair| pick(pair).write()).unwrap_or_default()
            };
            let cell = match role(column) {
                Role::Task => example.task.clone().unwrap_or_default(),
                Role::Pre(n) => state(n, |pair| &pair.pre),
                Role::Post(n) => state(n, |pair| &pair.post),
                Role::Command => example.command.clone(),
                Role::Other => match (rest.next(), column.as_str()) {
                    (Some(kept), _) => kept.clone(),
                    (None, "AssignmentId") => example.id.clone(),
                    (None, "WorkerId") => example.worker.clone().unwrap_or_default(),
                    (None, "AssignmentStatus") => "Approved".to_owned(),
                    (None, "Approve") => "x".to_owned(),
                    (None, _) => String::new(),
                },
            };
            out.write_field(cell)?;
        }
        out.write_record(None::<&[u8]>)?;
    }
    out.flush()
}

fn role(column: &str) -> Role {
    let number = |prefix: &str| {
        let digits = column.strip_prefix(prefix)?;
        let canonical = !digits.starts_with(['0', '+']);
        digits.parse::<usize>().ok().filter(|n| canonical && *n <= MAX_PAIRS)
    };
    match (column, number(PRE), number(POST)) {
        (TASK, ..) => Role::Task,
        (COMMAND, ..) => Role::Command,
        (_, Some(n), _) => Role::Pre(n),
        (_, _, Some(n)) => Role::Post(n),
        _ => Role::Other,
    }
}

/// What each column is to us, and the columns of the demonstrations in the order of their numbers.
#[expect(clippy::type_complexity, reason = "used in one place")]
fn roles(columns: &[String]) -> Result<(Vec<Role>, Vec<(usize, usize)>), String> {
    let roles: Vec<Role> = columns.iter().map(|column| role(column)).collect();
    let mut states: BTreeMap<usize, (Option<usize>, Option<usize>)> = BTreeMap::new();
    for (at, (role, column)) in roles.iter().zip(columns).enumerate() {
        let again = columns.iter().take(at).any(|other| other == column);
        if again && (*role != Role::Other || column == FORM) {
            return Err(format!("the column {column} stands twice in the header; delete one"));
        }
        match *role {
            Role::Pre(n) => states.entry(n).or_default().0 = Some(at),
            Role::Post(n) => states.entry(n).or_default().1 = Some(at),
            _ => {}
        }
    }
    if states.is_empty() {
        return Err(missing(&format!("{PRE}1"), columns));
    }
    let mut pairs = Vec::new();
    for (n, both) in states {
        match both {
            (Some(pre), Some(post)) => pairs.push((pre, post)),
            (None, _) => return Err(missing(&format!("{PRE}{n}"), columns)),
            (_, None) => return Err(missing(&format!("{POST}{n}"), columns)),
        }
    }
    if !columns.iter().any(|column| column == COMMAND || column == FORM) {
        return Err(missing(COMMAND, columns));
    }
    Ok((roles, pairs))
}

fn missing(name: &str, columns: &[String]) -> String {
    if let [only] = columns
        && let Some(separator) =
            [(';', "semicolons"), ('\t', "tabs")].iter().find(|s| only.contains(s.0))
    {
        return format!("the cells are separated by {}; save the file with commas", separator.1);
    }
    let strangers = columns.iter().map(String::as_str).filter(|column| role(column) == Role::Other);
    let hint = cell::did_you_mean(name, strangers)
        .map_or_else(String::new, |near| format!("; rename {near}?"));
    let mut found: Vec<String> =
        columns.iter().take(40).map(|column| column.chars().take(40).collect()).collect();
    if columns.len() > found.len() {
        found.push("…".to_owned());
    }
    format!("the column {name} is missing{hint} (found: {})", found.join(", "))
}

/// The command in the JSON that crowd-html forms answer with: `[{"command": "…"}]`.
fn form_command(text: &str) -> Result<String, String> {
    use serde_json::Value;
    let answers: Value = cell::json(text)?;
    let forms = match &answers {
        Value::Array(forms) => forms.as_slice(),
        form => std::slice::from_ref(form),
    };
    let fields = || forms.iter().filter_map(Value::as_object).flatten();
    let named = fields().find(|(name, _)| *name == "command").and_then(|(_, value)| value.as_str());
    let mut texts = fields().filter_map(|(_, value)| value.as_str());
    match (named, texts.next(), texts.next()) {
        (Some(command), ..) | (None, Some(command), None) => Ok(command.trim().to_owned()),
        _ => {
            let names: Vec<&str> = fields().map(|(name, _)| name.as_str()).collect();
            Err(format!("no answer is called command (found: {})", names.join(", ")))
        }
    }
}

fn standard_columns(corpus: &Corpus) -> Vec<String> {
    let n = corpus.examples.iter().map(|example| example.pairs.len()).max().unwrap_or(1);
    let mut columns: Vec<String> = PLATFORM.iter().map(|&name| name.to_owned()).collect();
    columns.push(TASK.to_owned());
    for i in 1..=n {
        columns.push(format!("{PRE}{i}"));
        columns.push(format!("{POST}{i}"));
    }
    columns.extend([COMMAND, "Approve", "Reject"].map(str::to_owned));
    columns
}
