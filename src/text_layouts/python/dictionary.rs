//! Which expressions of a program are dictionaries of keys.

use ruff_python_ast::Expr;

use super::functions::function;
use super::keys::Channel;
use super::names::{Hint, last_name};

/// The times and values of something that may be keys, as they stand in the program.
pub(super) struct Entries<'a> {
    /// Expressions of time and value.
    pub(super) pairs: Vec<(&'a Expr, &'a Expr)>,
    /// The first part that is no such pair.
    pub(super) other: Option<&'a Expr>,
    /// Whether they are pairs in a list or a tuple.
    pub(super) is_list: bool,
}

impl<'a> Entries<'a> {
    /// The entries of a dictionary, of a call of `dict`, or of a list or tuple of pairs; `None` for any other expression.
    pub(super) fn of(expression: &'a Expr) -> Option<Self> {
        match expression {
            Expr::Dict(dictionary) => {
                let pairs = dictionary.items.iter().map_while(|item| Some((item.key.as_ref()?, &item.value))).collect();
                // `**` takes in another dictionary.
                let other = dictionary.items.iter().find(|item| item.key.is_none()).map(|item| &item.value);
                Some(Self { pairs, other, is_list: false })
            }
            Expr::DictComp(_) => Some(Self { pairs: Vec::new(), other: Some(expression), is_list: false }),
            Expr::Call(call) if matches!(last_name(&call.func), Some("dict" | "OrderedDict")) => {
                match (&*call.arguments.args, &*call.arguments.keywords) {
                    ([], []) => Some(Self { pairs: Vec::new(), other: None, is_list: false }),
                    ([only], []) => {
                        Some(Self::of(only).map(|entries| Self { is_list: false, ..entries }).unwrap_or(Self {
                            pairs: Vec::new(),
                            other: Some(expression),
                            is_list: false,
                        }))
                    }
                    _ => None,
                }
            }
            Expr::List(list) => Self::of_pairs(&list.elts),
            Expr::Tuple(tuple) => Self::of_pairs(&tuple.elts),
            _ => None,
        }
    }

    fn of_pairs(elements: &'a [Expr]) -> Option<Self> {
        let pair = |element: &'a Expr| match elements_of(element)? {
            [time, value] => Some((time, value)),
            _ => None,
        };
        let pairs: Vec<_> = elements.iter().map(pair).collect::<Option<_>>()?;
        Some(Self { pairs, other: None, is_list: true })
    }

    /// Whether the first value is a call of a function that makes values of keys.
    pub(super) fn is_of_calls(&self) -> bool {
        self.pairs.first().is_some_and(|(_, value)| is_called(value))
    }

    /// Whether the first entry shows that these are no keys: a text as its time or its value, for example.
    pub(super) fn are_of_others(&self) -> bool {
        let is_number = |expression: &Expr| {
            matches!(
                expression,
                Expr::NumberLiteral(_)
                    | Expr::UnaryOp(_)
                    | Expr::BinOp(_)
                    | Expr::Name(_)
                    | Expr::Attribute(_)
                    | Expr::Subscript(_)
                    | Expr::Call(_)
            )
        };
        let is_value = |expression: &Expr| is_number(expression) || elements_of(expression).is_some();
        self.pairs.first().is_some_and(|(time, value)| !is_number(time) || !is_value(value))
    }

    /// The channel of the first value, as far as its function tells.
    pub(super) fn called_channel(&self) -> Option<Channel> {
        let name = called(self.pairs.first()?.1)?;
        Some(if name.starts_with("quaternion") { Channel::Rotation } else { Channel::Translation })
    }
}

/// The elements of a list or a tuple.
pub(super) fn elements_of(expression: &Expr) -> Option<&[Expr]> {
    match expression {
        Expr::Tuple(tuple) => Some(&tuple.elts),
        Expr::List(list) => Some(&list.elts),
        _ => None,
    }
}

/// Whether a value is made by a function of vectors or rotations.
pub(super) fn is_called(value: &Expr) -> bool {
    called(value).is_some()
}

/// The function that a value is made by, if it is one of vectors or rotations.
fn called(value: &Expr) -> Option<&str> {
    let Expr::Call(call) = value else { return None };
    let name = last_name(&call.func)?;
    let makes_values = name.starts_with("vec") || name.starts_with("quaternion") || name.ends_with("array");
    (makes_values && function(name).is_some()).then_some(name)
}

/// The channel of a dictionary that stands by itself.
pub(super) fn channel_by(hint: &Hint, by_value: Option<Channel>) -> Option<Channel> {
    match (hint.channel, by_value) {
        (Some(channel), _) if hint.is_exact => Some(channel),
        // Three numbers may be a scale.
        (Some(Channel::Scale), Some(Channel::Translation)) => Some(Channel::Scale),
        (channel, by_value) => by_value.or(channel),
    }
}
