//! The options of all commands, as their help lists them: one that takes a value is given once, a number is a number, and
//! what is wrong is told with the option's name.

use super::command::call;

/// An option, behind what calls its command.
#[derive(Debug)]
struct Offered {
    call: Vec<String>,
    name: String,
    /// What its values are called.
    values: Vec<String>,
}

impl Offered {
    /// Whether it takes any number of values, or may be given again.
    fn is_list(&self) -> bool {
        let again = self.call == ["calibrate"] && self.name == "--model";
        again || self.values.iter().any(|value| value.ends_with('…'))
    }

    /// It, with values of their kind.
    fn sample(&self) -> Vec<&str> {
        let sample = |value: &String| match value.trim_end_matches('…') {
            "N" | "X" | "P" | "K" | "STATES" => "1",
            "STYLE" => "cuts",
            "LOCK" => "locked",
            "FLAGS" => "fast",
            "JSON" => "\"once\"",
            _ => "x",
        };
        [self.name.as_str()].into_iter().chain(self.values.iter().map(sample)).collect()
    }

    /// What is said when it is called with more.
    #[track_caller]
    fn refused(&self, more: &[&str]) -> String {
        let call_words = self.call.iter().map(String::as_str);
        let all: Vec<&str> = call_words.chain(more.iter().copied()).collect();
        let output = call(&all, "");
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{all:?}: {said}");
        assert_eq!(said.lines().count(), 1, "{all:?}: {said}");
        said
    }
}

fn help(arguments: &[&str]) -> String {
    String::from_utf8(call(&[arguments, &["--help"]].concat(), "").stdout).unwrap()
}

/// Every option with a value that the help lists at the beginning of a line.
fn offered() -> Vec<Offered> {
    let overview = help(&[]);
    let commands = overview.lines().filter_map(|line| line.strip_prefix("  "));
    commands.filter_map(|line| line.split(' ').next()).flat_map(of_command).collect()
}

fn of_command(name: &str) -> Vec<Offered> {
    let mut call = vec![name.to_owned()];
    let mut found = Vec::new();
    for line in help(&[name]).lines() {
        let head = line.trim_start().split("  ").next().unwrap_or_default();
        match (name, head.strip_prefix("All:")) {
            // What all experiments take one of them takes.
            ("experiment", Some(_)) => call = vec![name.to_owned(), "cross".to_owned()],
            ("experiment", None) if line.starts_with("  ") && !line.starts_with("   ") => {
                call = vec![name.to_owned(), head.to_owned()];
            }
            _ => {}
        }
        let mut words = head.split([' ', '[', ']']).filter(|word| !word.is_empty()).peekable();
        while let Some(option) = words.next_if(|word| word.starts_with("--")) {
            let mut values = Vec::new();
            while let Some(value) = words.next_if(|word| !word.starts_with("--")) {
                values.push(value.to_owned());
            }
            let name = option.to_owned();
            found.push(Offered { call: call.clone(), name, values });
        }
    }
    found.retain(|option| !option.values.is_empty());
    found
}

#[test]
fn an_option_that_takes_a_value_is_given_once() {
    let all = offered();
    let single: Vec<&Offered> = all.iter().filter(|option| !option.is_list()).collect();
    assert!(single.len() > 50, "{}", single.len());
    for option in single {
        let said = option.refused(&[option.sample(), option.sample()].concat());
        let twice = format!("{} is given twice: leave one out", option.name);
        assert!(said.contains(&twice), "{option:?}: {said}");
    }
}

#[test]
fn an_option_that_takes_a_number_says_so() {
    let (mut whole, mut real) = (0, 0);
    for option in offered() {
        let said = |value: &str| option.refused(&[&option.name, value]);
        let is = |value: &str, what: &str| {
            let (found, name) = (said(value), &option.name);
            assert!(found.contains(&format!("{name} {what}")), "{option:?} {value}: {found}");
        };
        match option.values[0].as_str() {
            "N" | "STATES" | "K…" => {
                whole += 1;
                is("x", "needs a whole number, not x");
                is("1.5", "needs a whole number, not 1.5");
                is("", "needs a whole number, not nothing");
                is("99999999999999999999", "99999999999999999999 is too large: give at most ");
                if !option.is_list() {
                    is("-1", "must be at least ");
                }
            }
            "X" | "P" => {
                real += 1;
                is("x", "needs a number, not x");
                is("nan", "must be from 0 to 1");
                is("-1", "must be from 0 to 1");
            }
            _ => {}
        }
    }
    assert!(whole > 20 && real == 2, "{whole} and {real}");
}

#[test]
fn what_belongs_together_is_told_apart() {
    let said = |arguments: &[&str]| {
        let output = call(arguments, "");
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        String::from_utf8(output.stderr).unwrap()
    };
    let large = said(&["train", "--epochs", "99999999999999"]);
    assert!(large.contains("--epochs 99999999999999 is too large: give at most 4294967295"));
    let both = said(&["generate", "--tasks", "all", "--pairs", "1", "--runs", "1"]);
    assert!(both.contains("--pairs and --runs are the same: leave one out"), "{both}");
    let wrong = said(&["train", "--epochs", "1", "--epochs", "x"]);
    assert!(wrong.contains("--epochs needs a whole number, not x"), "{wrong}");
    // A list goes on where it is given again.
    let six = "assets/corpus/six.csv";
    let train = ["train", "--corpus", six, "--epochs", "1", "--out", "-"];
    let output = call(&[&train[..], &["--without", "pair", "--without", "head"]].concat(), "");
    assert!(String::from_utf8(output.stdout).unwrap().contains("fact\twithout\tpair head\n"));
}
