//! A second way to normal forms, to hold the arena against: trees with named variables, normalised by evaluation
//! (Berger and Schwichtenberg 1991). Nothing is shared with the engine: no ids, no substitution, no memo.

use std::cmp::Ordering;
use std::rc::Rc;

/// A simple type.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Ty {
    /// `e`, `t` or `n`
    Base(char),
    /// `<from,to>`
    Function(Rc<Ty>, Rc<Ty>),
}

impl Ty {
    pub(super) fn text(&self) -> String {
        match self {
            Ty::Base(name) => name.to_string(),
            Ty::Function(from, to) => format!("<{},{}>", from.text(), to.text()),
        }
    }
}

/// A well-typed term as a person may write it. Variables are numbers, each bound once.
#[derive(Clone, Debug)]
pub(super) enum Tree {
    Constant(&'static str, Ty),
    Variable(u32),
    Lambda(u32, Ty, Box<Tree>),
    Apply(Box<Tree>, Box<Tree>),
    /// `and` or `or` of any number of truth values.
    Join(&'static str, Vec<Tree>),
}

impl Tree {
    /// The text, with the name that `name` gives each variable.
    pub(super) fn text(&self, name: &impl Fn(u32) -> String) -> String {
        match self {
            Tree::Constant(constant, ty) => format!("{constant}:{}", ty.text()),
            Tree::Variable(id) => name(*id),
            Tree::Lambda(id, ty, body) => {
                format!("(lambda {}:{} {})", name(*id), ty.text(), body.text(name))
            }
            Tree::Apply(function, argument) => {
                format!("({} {})", function.text(name), argument.text(name))
            }
            Tree::Join(connective, parts) => {
                let parts: String = parts.iter().map(|p| format!(" {}", p.text(name))).collect();
                format!("({connective}:<t*,t>{parts})")
            }
        }
    }
}

/// A normal form. A variable is the depth of its binder from the root.
#[derive(Clone, PartialEq)]
enum Form {
    Constant(String),
    Variable(usize),
    Apply(Box<Form>, Vec<Form>),
    Lambda(String, usize, Box<Form>),
}

impl Form {
    fn text(&self) -> String {
        match self {
            Form::Constant(text) => text.clone(),
            Form::Variable(level) => format!("${level}"),
            Form::Apply(head, args) => {
                let args: String = args.iter().map(|arg| format!(" {}", arg.text())).collect();
                format!("({}{args})", head.text())
            }
            Form::Lambda(ty, level, body) => format!("(lambda ${level}:{ty} {})", body.text()),
        }
    }

    /// The canonical order; a nearer binder has the larger level and the smaller index.
    fn order(&self, other: &Form) -> Ordering {
        let rank = |form: &Form| match form {
            Form::Constant(_) => 0,
            Form::Variable(_) => 1,
            Form::Apply(..) => 2,
            Form::Lambda(..) => 3,
        };
        match (self, other) {
            // No name here has two types, and none contains a byte below a colon.
            (Form::Constant(a), Form::Constant(b)) => a.cmp(b),
            (Form::Variable(a), Form::Variable(b)) => b.cmp(a),
            (Form::Apply(f, xs), Form::Apply(g, ys)) => f.order(g).then_with(|| {
                let each = xs.iter().zip(ys).map(|(x, y)| x.order(y));
                let first = each.into_iter().find(|order| order.is_ne());
                first.unwrap_or(xs.len().cmp(&ys.len()))
            }),
            (Form::Lambda(s, _, x), Form::Lambda(t, _, y)) => s.cmp(t).then_with(|| x.order(y)),
            (x, y) => rank(x).cmp(&rank(y)),
        }
    }
}

/// A meaning: a function, or what can be written down once the depth is known.
#[derive(Clone)]
enum Value {
    Function(Rc<dyn Fn(Value) -> Value>),
    Written(Rc<dyn Fn(usize) -> Form>),
}

type Scope = Vec<(u32, Value)>;

/// The text of the normal form of a closed term of that type.
pub(super) fn normal_form(tree: &Tree, ty: &Ty) -> String {
    write(ty, &evaluate(tree, &Vec::new()), 0).text()
}

fn evaluate(tree: &Tree, scope: &Scope) -> Value {
    match tree {
        Tree::Constant("not", _) => Value::Function(Rc::new(|inner| {
            Value::Written(Rc::new(move |depth| negation(write(&Ty::Base('t'), &inner, depth))))
        })),
        Tree::Constant(name, ty) => {
            let text = format!("{name}:{}", ty.text());
            stand_for(ty, Rc::new(move |_| Form::Constant(text.clone())))
        }
        Tree::Variable(id) => scope.iter().rfind(|(bound, _)| bound == id).unwrap().1.clone(),
        Tree::Lambda(id, _, body) => {
            let (id, body, scope) = (*id, body.clone(), scope.clone());
            Value::Function(Rc::new(move |value| {
                let mut scope = scope.clone();
                scope.push((id, value));
                evaluate(&body, &scope)
            }))
        }
        Tree::Apply(function, argument) => {
            match (evaluate(function, scope), evaluate(argument, scope)) {
                (Value::Function(function), argument) => function(argument),
                (Value::Written(_), _) => panic!("{function:?} is no function"),
            }
        }
        Tree::Join(connective, parts) => {
            let parts: Vec<Value> = parts.iter().map(|part| evaluate(part, scope)).collect();
            let connective = *connective;
            Value::Written(Rc::new(move |depth| {
                let parts = parts.iter().map(|part| write(&Ty::Base('t'), part, depth));
                joined(connective, parts.collect())
            }))
        }
    }
}

/// The value that a head of a type stands for.
fn stand_for(ty: &Ty, head: Rc<dyn Fn(usize) -> Form>) -> Value {
    let Ty::Function(from, to) = ty.clone() else { return Value::Written(head) };
    Value::Function(Rc::new(move |argument| {
        let (head, from) = (head.clone(), from.clone());
        let applied = move |depth| match (head(depth), write(&from, &argument, depth)) {
            (Form::Apply(head, mut args), last) => {
                args.push(last);
                Form::Apply(head, args)
            }
            (head, only) => Form::Apply(Box::new(head), vec![only]),
        };
        stand_for(&to, Rc::new(applied))
    }))
}

fn write(ty: &Ty, value: &Value, depth: usize) -> Form {
    match (ty, value) {
        (Ty::Function(from, to), Value::Function(function)) => {
            let bound = stand_for(from, Rc::new(move |_| Form::Variable(depth)));
            Form::Lambda(from.text(), depth, Box::new(write(to, &function(bound), depth + 1)))
        }
        (_, Value::Written(form)) => form(depth),
        (Ty::Base(_), Value::Function(_)) => panic!("a function where {} was wanted", ty.text()),
    }
}

fn negation(inner: Form) -> Form {
    let not = Form::Constant("not:<t,t>".to_owned());
    match inner {
        Form::Apply(head, mut args) if *head == not => args.remove(0),
        inner => Form::Apply(Box::new(not), vec![inner]),
    }
}

fn joined(connective: &str, parts: Vec<Form>) -> Form {
    let head = Form::Constant(format!("{connective}:<t*,t>"));
    let [yes, no] = ["true:t", "false:t"].map(|text| Form::Constant(text.to_owned()));
    let (unit, absorber) = if connective == "and" { (yes, no) } else { (no, yes) };
    let mut flat: Vec<Form> = Vec::new();
    for part in parts {
        match part {
            Form::Apply(inner, args) if *inner == head => flat.extend(args),
            part if part == unit => {}
            part => flat.push(part),
        }
    }
    if flat.contains(&absorber) {
        return absorber;
    }
    flat.sort_by(Form::order);
    flat.dedup();
    match flat.len() {
        0 => unit,
        1 => flat.remove(0),
        _ => Form::Apply(Box::new(head), flat),
    }
}
