//! Evaluates expressions of numbers. Nothing of a program is run: an expression has a value if it consists of numbers, of constants that were
//! assigned before, of arithmetic and of calls of [`functions`](super::functions).

use ruff_python_ast::{Expr, ExprBinOp, ExprCall, ExprSubscript, Number, Operator, UnaryOp};

use super::fault::Fault;
use super::functions::{Arguments, Numbers, Term, function, takes_one};
use super::names::{dotted_name, last_name};
use crate::words::texts;

/// The value of a constant.
pub(super) enum Constant {
    /// It is known.
    Known(Term),
    /// A name of the program whose value is known only when it runs.
    Unknown,
    /// The program does not assign it.
    Foreign,
}

/// What was met in expressions, for the report.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Met {
    /// `quaternion` with components.
    pub(super) quaternions: bool,
    /// `quaternion_from_euler`.
    pub(super) euler_angles: bool,
}

/// Evaluates expressions.
pub(super) struct Evaluator<'a, F> {
    /// The text.
    pub(super) source: &'a str,
    /// Looks up a name with dots.
    pub(super) constant: F,
    /// What was met.
    pub(super) met: Met,
}

impl<F: Fn(&str) -> Constant> Evaluator<'_, F> {
    /// The value of an expression.
    ///
    /// # Errors
    /// The part that has no value, or not the expected kind of value.
    pub(super) fn term(&mut self, expression: &Expr) -> Result<Term, Fault> {
        let term = match expression {
            Expr::NumberLiteral(literal) => match &literal.value {
                Number::Int(whole) => whole.to_string().parse().ok().map(Term::Number),
                Number::Float(number) => Some(Term::Number(*number)),
                Number::Complex { .. } => None,
            },
            Expr::Name(_) | Expr::Attribute(_) => return self.name(expression),
            Expr::UnaryOp(operation) => {
                let operand = self.operand(&operation.operand, expression)?;
                match (operation.op, operand) {
                    (UnaryOp::UAdd, term) => Some(term),
                    (UnaryOp::USub, Term::Number(number)) => Some(Term::Number(-number)),
                    (UnaryOp::USub, Term::Numbers(numbers)) if numbers.is_array => {
                        Some(Term::Numbers(numbers.map(|number| -number)))
                    }
                    (UnaryOp::USub, Term::Rotation(rotation)) => Some(Term::Rotation(-rotation)),
                    _ => None,
                }
            }
            Expr::BinOp(operation) => self.operation(operation, expression)?,
            Expr::Tuple(tuple) => return self.numbers(expression, &tuple.elts),
            Expr::List(list) => return self.numbers(expression, &list.elts),
            Expr::Call(call) => return self.call(call),
            Expr::Subscript(subscript) => self.element(subscript, expression)?,
            _ => None,
        };
        let term = term.ok_or_else(|| Fault::unknown(self.source, expression))?;
        let is_finite = match term {
            Term::Number(number) => number.is_finite(),
            Term::Numbers(numbers) => numbers.as_slice().iter().all(|number| number.is_finite()),
            Term::Rotation(rotation) => rotation.is_finite(),
        };
        if is_finite { Ok(term) } else { Err(Fault::not_finite(self.source, expression)) }
    }

    /// A part of an operation: what is not known is the operation, as in `camera.x + 3`.
    fn operand(&mut self, part: &Expr, whole: &Expr) -> Result<Term, Fault> {
        self.term(part).map_err(|fault| match fault.problem {
            crate::text_layouts::TextProblem::Unknown { .. } => Fault::unknown(self.source, whole),
            _ => fault,
        })
    }

    fn name(&self, expression: &Expr) -> Result<Term, Fault> {
        let name = dotted_name(expression).ok_or_else(|| Fault::unknown(self.source, expression))?;
        match (self.constant)(&name) {
            Constant::Known(term) => return Ok(term),
            Constant::Unknown => return Err(Fault::unknown(self.source, expression)),
            Constant::Foreign => {}
        }
        // Any module may be before the dot: numpy has many names.
        match name.rsplit('.').next().unwrap_or_default() {
            "pi" => Ok(Term::Number(std::f64::consts::PI)),
            "tau" => Ok(Term::Number(std::f64::consts::TAU)),
            "nan" | "NaN" | "inf" | "Inf" | "infinity" | "Infinity" => Err(Fault::not_finite(self.source, expression)),
            _ => Err(Fault::unknown(self.source, expression)),
        }
    }

    fn operation(&mut self, operation: &ExprBinOp, whole: &Expr) -> Result<Option<Term>, Fault> {
        let left = self.operand(&operation.left, whole)?;
        let right = self.operand(&operation.right, whole)?;
        let combine: fn(f64, f64) -> f64 = match operation.op {
            Operator::Add => |a, b| a + b,
            Operator::Sub => |a, b| a - b,
            Operator::Mult => |a, b| a * b,
            Operator::Div => |a, b| a / b,
            Operator::FloorDiv => |a, b| (a / b).floor(),
            Operator::Mod => |a, b| a - b * (a / b).floor(),
            Operator::Pow => f64::powf,
            _ => return Ok(None),
        };
        Ok(match (left, right) {
            (Term::Number(a), Term::Number(b)) => Some(Term::Number(combine(a, b))),
            // Tuples and lists are joined or repeated, which gives no vector.
            (Term::Numbers(a), Term::Number(b)) if a.is_array => Some(Term::Numbers(a.map(|a| combine(a, b)))),
            (Term::Number(a), Term::Numbers(b)) if b.is_array => Some(Term::Numbers(b.map(|b| combine(a, b)))),
            (Term::Numbers(a), Term::Numbers(b)) => a.zip(b, combine).map(Term::Numbers),
            _ => None,
        })
    }

    /// A tuple or a list of numbers.
    fn numbers(&mut self, whole: &Expr, elements: &[Expr]) -> Result<Term, Fault> {
        let mut numbers = Numbers::default();
        for element in elements {
            let added = match self.term(element)? {
                Term::Number(number) => numbers.push(number),
                _ => return Err(Fault::unexpected(self.source, element, texts::TEXT_EXPECTED_NUMBER)),
            };
            added.ok_or_else(|| Fault::unexpected(self.source, whole, texts::TEXT_EXPECTED_FOUR_NUMBERS))?;
        }
        Ok(Term::Numbers(numbers))
    }

    /// An element of a vector, by a whole number.
    fn element(&mut self, subscript: &ExprSubscript, whole: &Expr) -> Result<Option<Term>, Fault> {
        let (Term::Numbers(numbers), Term::Number(place)) =
            (self.operand(&subscript.value, whole)?, self.operand(&subscript.slice, whole)?)
        else {
            return Ok(None);
        };
        let numbers = numbers.as_slice();
        Ok((0..numbers.len()).find(|&whole| whole as f64 == place).map(|place| Term::Number(numbers[place])))
    }

    fn call(&mut self, call: &ExprCall) -> Result<Term, Fault> {
        let name = last_name(&call.func).ok_or_else(|| Fault::unknown(self.source, call))?;
        let (function, expected) = function(name).ok_or_else(|| Fault::unknown(self.source, call))?;
        let mut arguments = Arguments::default();
        let given = if takes_one(name) {
            &call.arguments.args[..call.arguments.args.len().min(1)]
        } else {
            &call.arguments.args
        };
        for argument in given {
            if let Expr::Starred(starred) = argument {
                let Term::Numbers(numbers) = self.term(&starred.value)? else {
                    return Err(Fault::unexpected(self.source, argument, expected));
                };
                arguments.terms.extend(numbers.as_slice().iter().map(|&number| (None, Term::Number(number))));
            } else {
                let term = self.term(argument)?;
                arguments.terms.push((None, term));
            }
        }
        if !takes_one(name) {
            for keyword in &call.arguments.keywords {
                let name = keyword.arg.as_ref().ok_or_else(|| Fault::unknown(self.source, call))?;
                let term = self.term(&keyword.value)?;
                arguments.terms.push((Some(name.as_str()), term));
            }
        }
        self.met.quaternions |= name == "quaternion" && !arguments.terms.is_empty();
        self.met.euler_angles |= name == "quaternion_from_euler";
        let term = function(&arguments).ok_or_else(|| Fault::unexpected(self.source, call, expected))?;
        match term {
            Term::Number(number) if !number.is_finite() => Err(Fault::not_finite(self.source, call)),
            Term::Numbers(numbers) if !numbers.as_slice().iter().all(|number| number.is_finite()) => {
                Err(Fault::not_finite(self.source, call))
            }
            _ => Ok(term),
        }
    }
}
