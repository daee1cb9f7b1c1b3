//! Reads terms from the field's s-expressions: `(lambda $0:e (and:<t*,t> (red:<e,t> $0) (room:<e,t> $0)))`.
//! What is read comes out β-normal and η-long; errors carry the column (in characters, from 1).

use super::term::{LogicError, TermId, Terms};
use super::ty::{TyId, Type};

/// Bytes that a term's text may have.
pub const MAX_TEXT: usize = 65_536;
/// Brackets that may be open at once.
pub const MAX_DEPTH: u32 = 128;

/// What is wrong with a text, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("column {column}: {kind}")]
pub struct ReadError {
    /// Where, in characters from 1.
    pub column: usize,
    /// What.
    pub kind: ReadErrorKind,
}

/// What can be wrong with a term's text.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[expect(missing_docs, reason = "each says itself what it is")]
pub enum ReadErrorKind {
    #[error("there is no term here")]
    Empty,
    #[error("the text is longer than {MAX_TEXT} bytes")]
    TooLong,
    #[error("brackets nest deeper than {MAX_DEPTH}")]
    TooDeep,
    #[error("a bracket that opens here is never closed")]
    Unclosed,
    #[error("nothing is open that this bracket could close")]
    Unopened,
    #[error("the term has ended, but the text goes on")]
    TrailingText,
    #[error("the variable {0} is bound nowhere around here")]
    Unbound(String),
    #[error("a constant is written name:type, such as red:<e,t>; {0:?} is not")]
    BadConstant(String),
    #[error("{0:?} is not a type such as e, <e,t> or <t*,t>")]
    BadType(String),
    #[error("after lambda comes a variable with its type, such as $0:e, then one body")]
    BadLambda,
    #[error("an application needs at least one argument")]
    NoArgument,
    #[error("{0}")]
    Logic(LogicError),
}

/// Reads one term; free variables are an error.
///
/// # Errors
/// With the column and what is wrong there. Nothing but unused nodes is left behind in the arena.
pub fn read(terms: &mut Terms, text: &str) -> Result<TermId, ReadError> {
    if text.len() > MAX_TEXT {
        return Err(ReadError { column: 1, kind: ReadErrorKind::TooLong });
    }
    let mut reader = Reader { terms, tokens: tokens(text), next: 0, scope: Vec::new(), depth: 0 };
    let term = reader.term()?;
    match reader.peek() {
        None => Ok(term),
        Some((column, ")")) => Err(ReadError { column, kind: ReadErrorKind::Unopened }),
        Some((column, _)) => Err(ReadError { column, kind: ReadErrorKind::TrailingText }),
    }
}

/// Columns and texts of the brackets and words of a text.
fn tokens(text: &str) -> Vec<(usize, &str)> {
    let mut tokens = Vec::new();
    let mut word: Option<(usize, usize)> = None;
    for (column, (at, c)) in (1..).zip(text.char_indices()) {
        let bracket = c == '(' || c == ')';
        if bracket || c.is_whitespace() {
            if let Some((column, start)) = word.take() {
                tokens.push((column, &text[start..at]));
            }
            if bracket {
                tokens.push((column, &text[at..at + 1]));
            }
        } else if word.is_none() {
            word = Some((column, at));
        }
    }
    if let Some((column, start)) = word {
        tokens.push((column, &text[start..]));
    }
    tokens
}

struct Reader<'a> {
    terms: &'a mut Terms,
    tokens: Vec<(usize, &'a str)>,
    next: usize,
    /// The variables in scope, outermost first.
    scope: Vec<(&'a str, TyId)>,
    depth: u32,
}

/// What an application begins with: a term, or a variadic constant, which is no term by itself.
enum Head<'a> {
    Term(TermId),
    Variadic(&'a str, TyId),
}

impl<'a> Reader<'a> {
    fn peek(&self) -> Option<(usize, &'a str)> {
        self.tokens.get(self.next).copied()
    }

    fn term(&mut self) -> Result<TermId, ReadError> {
        let column = self.peek().map_or(1, |(column, _)| column);
        match self.head()? {
            Head::Term(term) => Ok(term),
            Head::Variadic(..) => Err(error(column, LogicError::BareVariadic)),
        }
    }

    fn head(&mut self) -> Result<Head<'a>, ReadError> {
        let Some((column, token)) = self.peek() else {
            let column =
                self.tokens.last().map_or(1, |&(column, text)| column + text.chars().count());
            return Err(ReadError { column, kind: ReadErrorKind::Empty });
        };
        self.next += 1;
        match token {
            "(" => self.bracket(column).map(Head::Term),
            ")" => Err(ReadError { column, kind: ReadErrorKind::Unopened }),
            _ if token.starts_with('$') => self.variable(column, token).map(Head::Term),
            _ => self.constant(column, token),
        }
    }

    fn bracket(&mut self, opened: usize) -> Result<TermId, ReadError> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(ReadError { column: opened, kind: ReadErrorKind::TooDeep });
        }
        let term = match self.peek() {
            Some((_, "lambda")) => {
                self.next += 1;
                self.lambda(opened)
            }
            Some((_, ")")) => Err(ReadError { column: opened, kind: ReadErrorKind::Empty }),
            Some(_) => self.application(opened),
            None => Err(ReadError { column: opened, kind: ReadErrorKind::Unclosed }),
        }?;
        self.depth -= 1;
        Ok(term)
    }

    fn lambda(&mut self, opened: usize) -> Result<TermId, ReadError> {
        let bad = |column| ReadError { column, kind: ReadErrorKind::BadLambda };
        let (column, binder) = self.peek().ok_or_else(|| bad(opened))?;
        self.next += 1;
        let (name, ty) = binder.split_once(':').ok_or_else(|| bad(column))?;
        if !name.starts_with('$') || name.len() < 2 {
            return Err(bad(column));
        }
        let ty = self.ty(column + name.chars().count() + 1, ty)?;
        if let Some((column, ")")) = self.peek() {
            return Err(bad(column));
        }
        self.scope.push((name, ty));
        let body = self.term()?;
        self.scope.pop();
        match self.peek() {
            Some((_, ")")) => self.next += 1,
            Some((column, _)) => return Err(bad(column)),
            None => return Err(ReadError { column: opened, kind: ReadErrorKind::Unclosed }),
        }
        self.terms.lambda(ty, body).map_err(|e| error(column, e))
    }

    fn application(&mut self, opened: usize) -> Result<TermId, ReadError> {
        let (at, _) = self.peek().unwrap_or((opened, ""));
        let head = self.head()?;
        let mut args = Vec::new();
        loop {
            match self.peek() {
                Some((_, ")")) => break self.next += 1,
                Some((column, _)) => args.push((column, self.term()?)),
                None => return Err(ReadError { column: opened, kind: ReadErrorKind::Unclosed }),
            }
        }
        match head {
            Head::Variadic(name, ty) => {
                let args: Vec<TermId> = args.into_iter().map(|(_, arg)| arg).collect();
                self.terms.apply_variadic(name, ty, &args).map_err(|e| error(at, e))
            }
            Head::Term(_) if args.is_empty() => {
                Err(ReadError { column: opened, kind: ReadErrorKind::NoArgument })
            }
            Head::Term(function) => {
                args.into_iter().try_fold(function, |function, (column, argument)| {
                    self.terms.apply(function, argument).map_err(|e| error(column, e))
                })
            }
        }
    }

    fn variable(&mut self, column: usize, name: &str) -> Result<TermId, ReadError> {
        let unbound = || ReadError { column, kind: ReadErrorKind::Unbound(name.to_owned()) };
        let place = self.scope.iter().rposition(|&(bound, _)| bound == name).ok_or_else(unbound)?;
        let index = (self.scope.len() - 1 - place) as u32;
        let ty = self.scope[place].1;
        self.terms.variable(index, ty).map_err(|e| error(column, e))
    }

    fn constant(&mut self, column: usize, token: &'a str) -> Result<Head<'a>, ReadError> {
        let Some((name, ty)) = token.split_once(':').filter(|(name, _)| !name.is_empty()) else {
            let kind = ReadErrorKind::BadConstant(token.to_owned());
            return Err(ReadError { column, kind });
        };
        let ty = self.ty(column + name.chars().count() + 1, ty)?;
        match self.terms.types.get(ty) {
            Type::Variadic(each, to)
                if !self.terms.types.has_variadic(each) && !self.terms.types.has_variadic(to) =>
            {
                Ok(Head::Variadic(name, ty))
            }
            _ if self.terms.types.has_variadic(ty) => Err(error(column, LogicError::BareVariadic)),
            _ => self.terms.constant_term(name, ty).map(Head::Term).map_err(|e| error(column, e)),
        }
    }

    fn ty(&mut self, column: usize, text: &str) -> Result<TyId, ReadError> {
        self.terms
            .types
            .read(text)
            .ok_or_else(|| ReadError { column, kind: ReadErrorKind::BadType(text.to_owned()) })
    }
}

fn error(column: usize, kind: LogicError) -> ReadError {
    ReadError { column, kind: ReadErrorKind::Logic(kind) }
}
