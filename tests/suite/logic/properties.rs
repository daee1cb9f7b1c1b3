//! What holds of every term over the constants of Cleanup World: terms are drawn at random, with abstractions,
//! applications and connectives wherever types allow, and held against [`super::reference`].

use super::reference::{Tree, Ty, normal_form};
use groundling::logic::{LogicError, TermId, Terms, print, read};
use proptest::prelude::{Just, Strategy, any, prop, prop_oneof};
use proptest::test_runner::TestCaseError;
use proptest::{prop_assert, prop_assert_eq, prop_assume, proptest};
use std::rc::Rc;

/// Constants of Cleanup World; three of a kind are enough.
const CONSTANTS: [(&str, &str); 15] = [
    ("agent", "<e,t>"),
    ("red", "<e,t>"),
    ("room", "<e,t>"),
    ("size", "<e,n>"),
    ("in", "<e,<e,t>>"),
    ("near", "<e,<e,t>>"),
    ("eq", "<e,<e,t>>"),
    ("the", "<<e,t>,e>"),
    ("argmax", "<<e,t>,<<e,n>,e>>"),
    ("argmin", "<<e,t>,<<e,n>,e>>"),
    ("exists", "<<e,t>,t>"),
    ("not", "<t,t>"),
    ("true", "t"),
    ("false", "t"),
    ("box", "<e,t>"),
];

fn base(name: char) -> Rc<Ty> {
    Rc::new(Ty::Base(name))
}

fn function(from: &Rc<Ty>, to: &Rc<Ty>) -> Rc<Ty> {
    Rc::new(Ty::Function(from.clone(), to.clone()))
}

/// The types that variables have.
fn types() -> Vec<Rc<Ty>> {
    let (e, t, n) = (base('e'), base('t'), base('n'));
    let property = function(&e, &t);
    let relation = function(&e, &property);
    let modifier = function(&property, &property);
    let truths = function(&t, &t);
    let measure = function(&e, &n);
    vec![e, t, property, relation, modifier, truths, measure]
}

fn read_ty(text: &str) -> Rc<Ty> {
    let mut all = types();
    let property = all[2].clone();
    all.push(function(&property, &base('e')));
    all.push(function(&property, &base('t')));
    let measured = function(&all[6], &base('e'));
    all.push(function(&property, &measured));
    all.into_iter().find(|ty| ty.text() == text).unwrap()
}

/// Draws terms from a list of numbers, which can be made smaller until a failure is easy to read.
struct Drawing {
    choices: std::vec::IntoIter<u8>,
    bound: u32,
    constants: Vec<(&'static str, Rc<Ty>)>,
}

type Scope = Vec<(u32, Rc<Ty>)>;

impl Drawing {
    fn new(choices: Vec<u8>) -> Self {
        let constants = CONSTANTS.iter().map(|&(name, ty)| (name, read_ty(ty))).collect();
        Drawing { choices: choices.into_iter(), bound: 0, constants }
    }

    /// A number below `n`; 0 once the list is used up.
    fn choose(&mut self, n: usize) -> usize {
        usize::from(self.choices.next().unwrap_or(0)) % n
    }

    /// A term of a type, in a scope.
    fn term(&mut self, ty: &Rc<Ty>, scope: &Scope, depth: u32) -> Tree {
        let simple = depth == 0 || self.choices.len() == 0;
        match (simple, self.choose(6)) {
            (false, 0) => {
                let all = types();
                let argument = all[self.choose(all.len())].clone();
                let function = self.lambda(&argument, ty, scope, depth - 1);
                let argument = self.term(&argument, scope, depth - 1);
                Tree::Apply(Box::new(function), Box::new(argument))
            }
            (false, 1 | 2) if **ty == Ty::Base('t') => {
                let connective = ["and", "or"][self.choose(2)];
                let n = self.choose(4);
                Tree::Join(connective, (0..n).map(|_| self.term(ty, scope, depth - 1)).collect())
            }
            (false, 1 | 2) | (true, _) => match &**ty {
                Ty::Function(from, to) => self.lambda(from, to, scope, depth.saturating_sub(1)),
                Ty::Base(_) => self.headed(ty, scope, depth),
            },
            (false, _) => self.headed(ty, scope, depth),
        }
    }

    fn lambda(&mut self, from: &Rc<Ty>, to: &Rc<Ty>, scope: &Scope, depth: u32) -> Tree {
        self.bound += 1;
        let id = self.bound;
        let mut scope = scope.clone();
        scope.push((id, from.clone()));
        Tree::Lambda(id, (**from).clone(), Box::new(self.term(to, &scope, depth)))
    }

    /// A variable or a constant, applied until it has the type.
    fn headed(&mut self, ty: &Rc<Ty>, scope: &Scope, depth: u32) -> Tree {
        let variables = scope.iter().map(|(id, ty)| (Tree::Variable(*id), ty.clone()));
        let constants = self.constants.iter();
        let constants =
            constants.map(|(name, ty)| (Tree::Constant(name, (**ty).clone()), ty.clone()));
        let mut heads: Vec<_> =
            variables.chain(constants).filter(|(_, own)| arguments(own, ty).is_some()).collect();
        if let (Ty::Function(from, to), true) = (&**ty, heads.is_empty()) {
            return self.lambda(from, to, scope, depth.saturating_sub(1));
        }
        if depth == 0 && heads.iter().any(|(_, own)| own == ty) {
            heads.retain(|(_, own)| own == ty);
        }
        let (mut tree, own) = heads.swap_remove(self.choose(heads.len()));
        for argument in arguments(&own, ty).unwrap() {
            let argument = match depth {
                0 => self.smallest(&argument, scope),
                _ => self.term(&argument, scope, depth - 1),
            };
            tree = Tree::Apply(Box::new(tree), Box::new(argument));
        }
        tree
    }

    /// A term of a type without further choice: an end to recursion.
    fn smallest(&mut self, ty: &Rc<Ty>, scope: &Scope) -> Tree {
        if let Some((id, _)) = scope.iter().find(|(_, own)| own == ty) {
            return Tree::Variable(*id);
        }
        match &**ty {
            Ty::Function(from, to) => {
                self.bound += 1;
                let id = self.bound;
                let mut scope = scope.clone();
                scope.push((id, from.clone()));
                Tree::Lambda(id, (**from).clone(), Box::new(self.smallest(to, &scope)))
            }
            Ty::Base('t') => Tree::Constant("true", Ty::Base('t')),
            Ty::Base(name) => {
                let text = if *name == 'n' { "size" } else { "the" };
                let (_, own) = self.constants.iter().find(|(name, _)| *name == text).unwrap();
                let own = own.clone();
                let argument = arguments(&own, ty).unwrap().remove(0);
                let argument = self.smallest(&argument, scope);
                let constant = Tree::Constant(text, (*own).clone());
                Tree::Apply(Box::new(constant), Box::new(argument))
            }
        }
    }
}

/// What a head of type `own` must be applied to until it has type `wanted`.
fn arguments(own: &Rc<Ty>, wanted: &Rc<Ty>) -> Option<Vec<Rc<Ty>>> {
    let (mut own, mut found) = (own.clone(), Vec::new());
    while own != *wanted {
        let Ty::Function(from, to) = &*own else { return None };
        found.push(from.clone());
        own = to.clone();
    }
    Some(found)
}

fn choices() -> impl Strategy<Value = Vec<u8>> {
    prop::collection::vec(any::<u8>(), 0..80)
}

/// A closed term of one of the types, with its type.
fn draw(choices: Vec<u8>, ty: &Rc<Ty>) -> Tree {
    Drawing::new(choices).term(ty, &Vec::new(), 6)
}

fn plain(id: u32) -> String {
    format!("$v{id}")
}

/// The id of a tree's text; refused cases are those too large to write.
fn id(terms: &mut Terms, tree: &Tree) -> Result<TermId, TestCaseError> {
    let text = tree.text(&plain);
    let too_large = || TestCaseError::reject("too large");
    read(terms, &text).map_err(|error| match error.kind {
        groundling::logic::read::ReadErrorKind::Logic(LogicError::TooLarge) => too_large(),
        groundling::logic::read::ReadErrorKind::TooDeep => too_large(),
        _ => TestCaseError::fail(format!("{text}: {error}")),
    })
}

/// The same meaning written otherwise: conjuncts turned round, nested, doubled, with units among them.
fn rewritten(tree: &Tree, how: &mut impl FnMut() -> u8) -> Tree {
    let mut again = |tree: &Tree| Box::new(rewritten(tree, how));
    let (connective, mut parts) = match tree {
        Tree::Constant(..) | Tree::Variable(_) => return tree.clone(),
        Tree::Lambda(id, ty, body) => return Tree::Lambda(*id, ty.clone(), again(body)),
        Tree::Apply(function, argument) => return Tree::Apply(again(function), again(argument)),
        Tree::Join(connective, parts) => {
            (*connective, parts.iter().map(|part| *again(part)).collect::<Vec<Tree>>())
        }
    };
    let n_parts = parts.len();
    parts.rotate_left(usize::from(how()) % n_parts.max(1));
    if how() < 128 {
        parts.reverse();
    }
    match how() % 4 {
        0 => parts.extend_from_within(..1.min(n_parts)),
        1 => {
            let unit = if connective == "and" { "true" } else { "false" };
            parts.push(Tree::Constant(unit, Ty::Base('t')));
        }
        2 => {
            let rest = parts.split_off(usize::from(how()) % (parts.len() + 1));
            parts.push(Tree::Join(connective, rest));
        }
        _ => {}
    }
    Tree::Join(connective, parts)
}

fn any_type() -> impl Strategy<Value = Rc<Ty>> {
    prop_oneof![Just(base('t')), prop::sample::select(types())]
}

proptest! {
    #[test]
    fn normal_forms_are_those_of_the_reference(choices in choices(), ty in any_type()) {
        let tree = draw(choices, &ty);
        let mut terms = Terms::new();
        let term = id(&mut terms, &tree)?;
        let printed = print(&terms, term);
        prop_assert_eq!(&printed, &normal_form(&tree, &ty), "of {}", tree.text(&plain));
        prop_assert_eq!(terms.types.print(terms.ty(term)), ty.text());
        prop_assert_eq!(terms.free(term), 0);
        prop_assert_eq!(read(&mut terms, &printed), Ok(term), "{} read again", printed);
    }

    #[test]
    fn names_and_the_order_of_conjuncts_do_not_matter(
        choices in choices(), how in prop::collection::vec(any::<u8>(), 1..20), shift in 0..100u32,
    ) {
        let tree = draw(choices, &base('t'));
        let mut terms = Terms::new();
        let term = id(&mut terms, &tree)?;
        let mut how = how.into_iter().cycle();
        let other = rewritten(&tree, &mut || how.next().unwrap_or(0));
        let text = other.text(&|id| format!("$other{}", id + shift));
        prop_assert_eq!(read(&mut terms, &text), Ok(term), "{} is {}", tree.text(&plain), text);
    }

    #[test]
    fn ids_are_equal_exactly_when_normal_forms_are(
        a in prop::collection::vec(any::<u8>(), 0..8),
        b in prop::collection::vec(any::<u8>(), 0..8),
        ty in any_type(),
    ) {
        let (a, b) = (draw(a, &ty), draw(b, &ty));
        let mut terms = Terms::new();
        let same_id = id(&mut terms, &a)? == id(&mut terms, &b)?;
        let (x, y) = (normal_form(&a, &ty), normal_form(&b, &ty));
        prop_assert_eq!(same_id, x == y, "{} and {}", x, y);
    }

    #[test]
    fn applying_is_what_the_text_says(
        f in choices(), x in choices(), from in any_type(), to in any_type(),
    ) {
        let (f, x) = (draw(f, &function(&from, &to)), draw(x, &from));
        let mut terms = Terms::new();
        let (function, argument) = (id(&mut terms, &f)?, id(&mut terms, &x)?);
        let both = id(&mut terms, &Tree::Apply(Box::new(f), Box::new(x)))?;
        let applied = terms.apply(function, argument);
        prop_assert_eq!(applied, Ok(both));
        prop_assert_eq!(terms.types.print(terms.ty(both)), to.text());
        prop_assert_eq!(terms.apply(function, argument), applied, "asked again");
    }

    #[test]
    fn composing_is_applying_one_after_the_other(
        f in choices(), g in choices(), x in choices(),
        a in any_type(), b in any_type(), c in any_type(),
    ) {
        let mut terms = Terms::new();
        let f = id(&mut terms, &draw(f, &function(&b, &c)))?;
        let g = id(&mut terms, &draw(g, &function(&a, &b)))?;
        let x = id(&mut terms, &draw(x, &a))?;
        let composed = terms.compose(f, g);
        prop_assume!(composed != Err(LogicError::TooLarge));
        let composed = composed.unwrap();
        prop_assert_eq!(terms.types.print(terms.ty(composed)), function(&a, &c).text());
        let one = terms.apply(composed, x);
        let other = terms.apply(g, x).and_then(|inner| terms.apply(f, inner));
        prop_assume!(![one, other].contains(&Err(LogicError::TooLarge)));
        prop_assert_eq!(one, other);
    }

    #[test]
    fn what_an_arena_did_before_leaves_no_trace(
        before in prop::collection::vec(choices(), 1..6), choices in choices(), ty in any_type(),
    ) {
        let tree = draw(choices, &ty);
        let mut fresh = Terms::new();
        let wanted = id(&mut fresh, &tree)?;
        let mut used = Terms::new();
        for choices in before {
            let earlier = id(&mut used, &draw(choices, &base('t')))?;
            used.conjoin(&[earlier]).unwrap();
        }
        let found = id(&mut used, &tree)?;
        prop_assert_eq!(print(&used, found), print(&fresh, wanted));
        prop_assert!(used.size(found) == fresh.size(wanted));
    }
}
