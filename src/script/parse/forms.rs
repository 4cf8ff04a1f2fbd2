//! The lines of a script: one table, from which they are read, and from which errors and the README list them.

#![expect(clippy::unnecessary_wraps, reason = "what a line means is what a form's reading gives, which may fail")]

use std::fmt::Write as _;
use std::path::PathBuf;

use glam::{Quat, Vec3};

use super::values::{
    axis, double, duration, keyframe, keyframes, listed, number_in, numbers, one_of, place, radians, whole_in,
};
use super::{Action, LineProblem, Parser, scene_lines};
use crate::editor::keymap::{binding_for, press_from_word};
use crate::editor::{
    Command, Edit, FileCommand, GestureCommand, PlayMode, PlaybackCommand, SPEED_PERCENT_RANGE, TimelineEdit,
    ViewCommand,
};
use crate::frame::MOST_GHOSTS;
use crate::interpolation::Interpolation;
use crate::keyframe::{DURATION_RANGE, Easing, MS_BETWEEN_KEYFRAMES_RANGE};
use crate::pose::RbtIndex;
use crate::rbt::Rbt;

/// The longest step, in ticks either way: an hour.
const LONGEST_STEP: u32 = 216_000;

/// What stands after a line's first word.
#[derive(Clone, Copy)]
pub struct Rest<'a> {
    /// As it is written, without outer blanks.
    pub text: &'a str,
    /// Its words.
    pub words: &'a [&'a str],
}

/// What a line means; `None`: it is not written like this.
type Read = fn(&Parser, Rest<'_>) -> Result<Option<Action>, LineProblem>;

/// One kind of line.
pub struct Form {
    /// Its first word.
    pub name: &'static str,
    /// How it is written.
    pub usage: &'static str,
    /// What it does, for the README.
    pub does: &'static str,
    /// Whether it ends with a node's path, which may hold what elsewhere starts a comment.
    pub ends_with_path: bool,
    /// What it means.
    pub read: Read,
}

pub(super) const fn form(name: &'static str, usage: &'static str, does: &'static str, read: Read) -> Form {
    Form { name, usage, does, ends_with_path: false, read }
}

pub(super) const fn with_path(name: &'static str, usage: &'static str, does: &'static str, read: Read) -> Form {
    Form { name, usage, does, ends_with_path: true, read }
}

fn edit(edit: Edit) -> Result<Option<Action>, LineProblem> {
    Ok(Some(Action::Apply(Command::Edit(edit))))
}

fn timeline(change: TimelineEdit) -> Result<Option<Action>, LineProblem> {
    edit(Edit::Timeline(change))
}

fn play(command: PlaybackCommand) -> Result<Option<Action>, LineProblem> {
    Ok(Some(Action::Apply(Command::Playback(command))))
}

fn view(command: ViewCommand) -> Result<Option<Action>, LineProblem> {
    Ok(Some(Action::Apply(Command::View(command))))
}

fn gesture(command: GestureCommand) -> Result<Option<Action>, LineProblem> {
    Ok(Some(Action::Apply(Command::Gesture(command))))
}

/// A command that stands alone.
fn alone(rest: Rest<'_>, command: Command) -> Result<Option<Action>, LineProblem> {
    Ok(rest.words.is_empty().then_some(Action::Apply(command)))
}

fn timeline_alone(rest: Rest<'_>, change: TimelineEdit) -> Result<Option<Action>, LineProblem> {
    alone(rest, Command::Edit(Edit::Timeline(change)))
}

/// All but those about control nodes, in the README's order.
#[rustfmt::skip]
static FORMS: &[Form] = &[
    with_path("select", "select PATH", "chooses the node to move: any path that `inbetween nodes` prints, or `none`", select),
    form("rotate", "rotate AXIS DEGREES", "turns the chosen node about its own `x`, `y` or `z`", |_, rest| {
        let &[about, degrees] = rest.words else { return Ok(None) };
        edit(Edit::RotateChosen { axis_in_node: axis(about)?, radians: radians(degrees)? })
    }),
    form("translate", "translate X Y Z", "moves the chosen node, in its parent's space", |_, rest| {
        let Ok(words) = rest.words.try_into() else { return Ok(None) };
        edit(Edit::TranslateChosen(Vec3::from(numbers::<3>(words)?)))
    }),
    form("key", "key K", "a hotkey: the character itself, or a name such as `space`, `home`, `ctrl+d`", hotkey),
    form("do", "do NAME", "a command by its English name in the list of commands (Ctrl+Shift+P), as in `do Reverse keyframes`", by_name),
    form("wait", "wait TIME", "so much time for the animation clock: `500ms`, `2s`", |_, rest| {
        let &[time] = rest.words else { return Ok(None) };
        duration(time).map(|time| Some(Action::Wait(time)))
    }),
    form("undo", "undo", "takes back the last edit", |_, rest| alone(rest, Command::Undo)),
    form("redo", "redo", "brings it again", |_, rest| alone(rest, Command::Redo)),
    form("screenshot", "screenshot PATH", "writes a picture of the scene", |_, rest| {
        let picture = FileCommand::Screenshot(Some(PathBuf::from(rest.text)));
        Ok((!rest.words.is_empty()).then_some(Action::Apply(Command::File(picture))))
    }),
    form("go", "go KEYFRAME", "makes a keyframe current and copies it to the scene", |_, rest| {
        let &[index] = rest.words else { return Ok(None) };
        edit(Edit::GoTo(keyframe(index)?))
    }),
    form("select-keyframes", "select-keyframes KEYFRAME…|none", "selects keyframes for the lines below: `1 2`, `1-4 7`", |_, rest| match rest.words {
        [] => Ok(None),
        ["none"] => view(ViewCommand::SelectKeyframes(Vec::new())),
        words => view(ViewCommand::SelectKeyframes(keyframes(words)?)),
    }),
    form("move", "move PLACE", "moves the selected keyframes (or the current one, here and below) to before the keyframe in this place", |_, rest| {
        let &[to] = rest.words else { return Ok(None) };
        timeline(TimelineEdit::MoveKeyframes(place(to)?))
    }),
    form("copy", "copy", "copies them", |_, rest| alone(rest, Command::View(ViewCommand::CopyKeyframes))),
    form("cut", "cut", "copies and deletes them", |_, rest| timeline_alone(rest, TimelineEdit::CutKeyframes)),
    form("paste", "paste", "inserts what was copied after the last of them", |_, rest| timeline_alone(rest, TimelineEdit::PasteKeyframes)),
    form("duplicate", "duplicate", "inserts copies after them", |_, rest| timeline_alone(rest, TimelineEdit::DuplicateKeyframes)),
    form("delete", "delete", "deletes them", |_, rest| timeline_alone(rest, TimelineEdit::DeleteKeyframes)),
    form("reverse", "reverse", "reverses their order; with fewer than two selected, of all", |_, rest| timeline_alone(rest, TimelineEdit::ReverseKeyframes)),
    form("easing", "easing NAME", "how the intervals run that begin at them: `linear`, `hold`, `sine-in-out` and so on", |_, rest| {
        let &[name] = rest.words else { return Ok(None) };
        let all = Easing::all().map(|easing| (easing, easing.name()));
        timeline(TimelineEdit::SetEasing(one_of(name, "an easing", all)?))
    }),
    form("rename", "rename KEYFRAME [NAME]", "names a keyframe; a name with `#` stands in double quotes", rename),
    form("duration", "duration KEYFRAME STEPS [ripple-free]", "the length of the interval that begins at a keyframe, in units of the ms between keyframes; with `ripple-free` the next interval gives what it takes", |_, rest| {
        let (index, steps, ripple_free) = match *rest.words {
            [index, steps] => (index, steps, false),
            [index, steps, "ripple-free"] => (index, steps, true),
            _ => return Ok(None),
        };
        let (keyframe, duration) = (keyframe(index)?, number_in(steps, "duration", &DURATION_RANGE)?);
        timeline(TimelineEdit::SetDuration { keyframe, duration, ripple_free })
    }),
    form("copy-pose", "copy-pose", "copies what is on screen of the chosen node and all below it", |_, rest| alone(rest, Command::View(ViewCommand::CopyPose))),
    form("paste-pose", "paste-pose", "gives it to the chosen node, of the other robot, say", |_, rest| timeline_alone(rest, TimelineEdit::PastePose)),
    with_path("set-translation", "set-translation X Y Z PATH", "places a node, in its parent's space", |parser, rest| {
        let Some((words, rbt)) = then_path(parser, rest)? else { return Ok(None) };
        edit(Edit::SetTranslation(rbt, Vec3::from(numbers::<3>(&words)?)))
    }),
    with_path("set-rotation", "set-rotation X Y Z W PATH", "turns a node: a quaternion, which is normalised", |parser, rest| {
        let Some((words, rbt)) = then_path(parser, rest)? else { return Ok(None) };
        edit(Edit::SetRotation(rbt, Quat::from_array(numbers::<4>(&words)?)))
    }),
    with_path("set-keyframe-translation", "set-keyframe-translation KEYFRAME X Y Z PATH", "places a node in a keyframe of the list", |parser, rest| {
        let Some(([index, x, y, z], rbt)) = then_path(parser, rest)? else { return Ok(None) };
        timeline(TimelineEdit::SetTranslationInKeyframe(keyframe(index)?, rbt, Vec3::from(numbers(&[x, y, z])?)))
    }),
    with_path("set-keyframe-rotation", "set-keyframe-rotation KEYFRAME X Y Z W PATH", "turns a node in a keyframe of the list", |parser, rest| {
        let Some(([index, x, y, z, w], rbt)) = then_path(parser, rest)? else { return Ok(None) };
        timeline(TimelineEdit::SetRotationInKeyframe(keyframe(index)?, rbt, Quat::from_array(numbers(&[x, y, z, w])?)))
    }),
    form("drag", "drag begin|end|cancel|move X Y Z|turn AXIS DEGREES", "what comes between `begin` and `end` is one step of undo, as with the mouse; `move` and `turn` go along the view's axes", drag),
    form("wheel", "wheel UNITS", "moves the chosen node, or the eye, forward along the view, in scene units", |_, rest| {
        let &[units] = rest.words else { return Ok(None) };
        let [forward] = numbers(&[units])?;
        edit(Edit::Wheel(Rbt::from_translation(Vec3::new(0.0, 0.0, -forward))))
    }),
    form("interpolation", "interpolation NAME", "`linear` or `catmull-rom`", |_, rest| {
        let &[name] = rest.words else { return Ok(None) };
        let all = Interpolation::ALL.into_iter().map(|interpolation| (interpolation, interpolation.name()));
        edit(Edit::SetInterpolation(one_of(name, "an interpolation", all)?))
    }),
    form("ms", "ms MILLISECONDS", "between keyframes", |_, rest| {
        let &[ms] = rest.words else { return Ok(None) };
        edit(Edit::SetMsBetweenKeyframes(whole_in(ms, "number of milliseconds", &MS_BETWEEN_KEYFRAMES_RANGE)?))
    }),
    form("scrub", "scrub KEY_TIME", "shows the sample at a key time", |_, rest| {
        let &[key_time] = rest.words else { return Ok(None) };
        play(PlaybackCommand::Scrub(double(key_time)?))
    }),
    form("step", "step TICKS", "moves the playhead by ticks of 1/60 s; below 0: back", step),
    form("mode", "mode once|loop|ping-pong", "what happens at the end of what plays", |_, rest| {
        let &[name] = rest.words else { return Ok(None) };
        let all = PlayMode::ALL.into_iter().map(|mode| (mode, mode.name()));
        play(PlaybackCommand::SetMode(one_of(name, "a mode of playing", all)?))
    }),
    form("range", "range FIRST LAST|all", "which keyframes of the list play", |_, rest| match *rest.words {
        ["all"] => play(PlaybackCommand::SetRange(None)),
        [first, last] => play(PlaybackCommand::SetRange(Some((place(first)?, place(last)?)))),
        _ => Ok(None),
    }),
    form("speed", "speed PERCENT", "of playing, on top of the ms between keyframes", |_, rest| {
        let &[percent] = rest.words else { return Ok(None) };
        play(PlaybackCommand::SetSpeedPercent(whole_in(percent, "speed in percent", &SPEED_PERCENT_RANGE)?))
    }),
    form("auto-key", "auto-key on|off", "whether the end of each drag updates the current keyframe", |_, rest| {
        let &[word] = rest.words else { return Ok(None) };
        view(ViewCommand::SetAutoKeys(one_of(word, "a state", [(true, "on"), (false, "off")].into_iter())?))
    }),
    form("ghosts", "ghosts COUNT", "how many neighbouring keyframes on each side are shown, 0 to 20", |_, rest| {
        let &[count] = rest.words else { return Ok(None) };
        let count = whole_in(count, "number of ghosts", &(0..=u32::from(MOST_GHOSTS)))?;
        view(ViewCommand::SetGhosts(u8::try_from(count).unwrap_or(MOST_GHOSTS)))
    }),
    with_path("eye", "eye PATH", "looks from an eye of the scene", eye),
];

/// These, and those about control nodes.
fn all() -> impl Iterator<Item = &'static Form> {
    FORMS.iter().chain(scene_lines::FORMS)
}

/// The form of a first word.
pub fn form_of(name: &str) -> Option<&'static Form> {
    all().find(|form| form.name == name)
}

/// Every first word, in a sentence.
pub fn names_sentence() -> String {
    let names: Vec<&str> = all().map(|form| form.name).collect();
    listed(&names).replace(" or ", " and ")
}

/// The table as Markdown, for the README.
#[must_use]
pub fn markdown() -> String {
    let mut text = String::from("| line | does |\n|---|---|\n");
    for form in all() {
        let _ = writeln!(text, "| `{}` | {} |", form.usage.replace('|', "\\|"), form.does);
    }
    text
}

fn select(parser: &Parser, rest: Rest<'_>) -> Result<Option<Action>, LineProblem> {
    match rest.words {
        [] => Ok(None),
        ["none"] => view(ViewCommand::Choose(None)),
        _ => view(ViewCommand::Choose(Some(parser.rbt(rest.text)?))),
    }
}

/// So many words, and the path after them.
fn then_path<'a, const N: usize>(
    parser: &Parser,
    rest: Rest<'a>,
) -> Result<Option<([&'a str; N], RbtIndex)>, LineProblem> {
    let mut words = [""; N];
    let mut text = rest.text;
    for place in &mut words {
        let Some((word, after)) = text.split_once(char::is_whitespace) else { return Ok(None) };
        (*place, text) = (word, after.trim_start());
    }
    if text.is_empty() { Ok(None) } else { Ok(Some((words, parser.rbt(text)?))) }
}

fn hotkey(parser: &Parser, rest: Rest<'_>) -> Result<Option<Action>, LineProblem> {
    let &[word] = rest.words else { return Ok(None) };
    let press = press_from_word(word);
    let binding = press.and_then(|press| binding_for(&parser.bindings, press));
    let binding = binding.ok_or_else(|| LineProblem::Hotkey { word: word.to_owned() })?;
    Ok(Some(Action::Apply(binding.command.clone())))
}

fn by_name(parser: &Parser, rest: Rest<'_>) -> Result<Option<Action>, LineProblem> {
    if rest.words.is_empty() {
        return Ok(None);
    }
    let binding = parser.bindings.iter().find(|binding| binding.name.eq_ignore_ascii_case(rest.text));
    let binding = binding.ok_or_else(|| LineProblem::Name { name: rest.text.to_owned() })?;
    Ok(Some(Action::Apply(binding.command.clone())))
}

fn rename(_: &Parser, rest: Rest<'_>) -> Result<Option<Action>, LineProblem> {
    let (index, name) = rest.text.split_once(char::is_whitespace).unwrap_or((rest.text, ""));
    if index.is_empty() {
        return Ok(None);
    }
    let name = name.trim();
    let name = serde_json::from_str(name).unwrap_or_else(|_| name.to_owned());
    timeline(TimelineEdit::RenameKeyframe(keyframe(index)?, name))
}

fn drag(_: &Parser, rest: Rest<'_>) -> Result<Option<Action>, LineProblem> {
    match *rest.words {
        ["begin"] => gesture(GestureCommand::Begin),
        ["end"] => gesture(GestureCommand::Commit),
        ["cancel"] => gesture(GestureCommand::Abort),
        ["move", x, y, z] => gesture(GestureCommand::Move(Rbt::from_translation(Vec3::from(numbers(&[x, y, z])?)))),
        ["turn", about, degrees] => {
            let rotation = Quat::from_axis_angle(axis(about)?, radians(degrees)?);
            gesture(GestureCommand::Move(Rbt::from_rotation(rotation)))
        }
        _ => Ok(None),
    }
}

fn step(_: &Parser, rest: Rest<'_>) -> Result<Option<Action>, LineProblem> {
    let &[word] = rest.words else { return Ok(None) };
    let high = f64::from(LONGEST_STEP);
    let wrong =
        || LineProblem::Range { word: word.to_owned(), what: "step in ticks", kind: "whole number", low: -high, high };
    let ticks = word.parse().ok().filter(|ticks: &i32| ticks.unsigned_abs() <= LONGEST_STEP).ok_or_else(wrong)?;
    play(PlaybackCommand::Step(ticks))
}

fn eye(parser: &Parser, rest: Rest<'_>) -> Result<Option<Action>, LineProblem> {
    if rest.words.is_empty() {
        return Ok(None);
    }
    let rbt = parser.rbt(rest.text)?;
    let eyes = parser.scene.eyes();
    let place = eyes.iter().position(|&eye| eye == rbt).ok_or_else(|| LineProblem::Eye {
        path: rest.text.to_owned(),
        expected: listed(&eyes.iter().map(|&eye| parser.scene.rbt_path(eye)).collect::<Vec<_>>()),
    })?;
    view(ViewCommand::SetEye(place))
}
