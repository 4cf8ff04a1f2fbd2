//! Commands of playing: the transport, the pace, the clock of timed keys.

use super::line::Line;
use super::row::{Binding, Changes, Group, Row};
use super::values::{double, index, number_text, one_of};
use crate::editor::{Command, Edit, Editor, PlayMode, PlaybackCommand, SPEED_PERCENT_RANGE, ViewCommand};
use crate::interpolation::Interpolation;
use crate::keyframe::{MS_BETWEEN_KEYFRAMES_RANGE, PlayRange};
use crate::words::texts;

/// The longest step, in ticks either way: an hour.
const LONGEST_STEP: i32 = 216_000;

fn binding(id: &'static str, command: Command) -> Binding {
    Binding::new(Group::Playing, id, command)
}

fn can_play(editor: &Editor, _: &Command) -> bool {
    PlayRange::new(&editor.document.keyframes).is_ok()
}

pub(super) fn rows() -> Vec<Row> {
    [transport(), pace(), playhead(), modes(), clock()].concat()
}

fn transport() -> Vec<Row> {
    let play = binding("play-or-stop", Command::Playback(PlaybackCommand::PlayOrStop));
    let pause = binding("pause-or-resume", Command::Playback(PlaybackCommand::PauseOrResume));
    vec![
        Row::listed(Changes::Document, play.hotkeys(&["y"]))
            .can(|editor, command| editor.is_playing() || can_play(editor, command)),
        Row::listed(Changes::Document, pause.hotkeys(&["Shift+P"]))
            .can(|editor, _| editor.is_playing() || editor.is_paused()),
    ]
}

fn pace() -> Vec<Row> {
    let faster = binding("faster", Command::Edit(Edit::Faster));
    let slower = binding("slower", Command::Edit(Edit::Slower));
    let next = binding("interpolation-next", Command::Edit(Edit::NextInterpolation));
    vec![
        Row::listed(Changes::Document, faster.repeating_hotkeys(&["+", "="])),
        Row::listed(Changes::Document, slower.repeating_hotkeys(&["-"])),
        Row::listed(Changes::Document, next.hotkeys(&["t"])),
        Row::of(Changes::Document, "interpolation", |command| {
            matches!(command, Command::Edit(Edit::SetInterpolation(_)))
        })
        .line(Line::new(
            "interpolation NAME",
            "`linear` or `catmull-rom`",
            |arguments| {
                let &[name] = arguments.words else { return Ok(None) };
                let all = Interpolation::ALL.into_iter().map(|interpolation| (interpolation, interpolation.name()));
                Ok(Some(Command::Edit(Edit::SetInterpolation(one_of(name, "an interpolation", all)?))))
            },
            |command, _| {
                let Command::Edit(Edit::SetInterpolation(interpolation)) = command else { return None };
                Some(interpolation.name().to_owned())
            },
        )),
        Row::of(Changes::Document, "ms", |command| matches!(command, Command::Edit(Edit::SetMsBetweenKeyframes(_))))
            .continuous()
            .line(Line::new(
                "ms MILLISECONDS",
                "between keyframes",
                |arguments| {
                    let &[ms] = arguments.words else { return Ok(None) };
                    let ms = arguments.whole_in(ms, "number of milliseconds", &MS_BETWEEN_KEYFRAMES_RANGE)?;
                    Ok(Some(Command::Edit(Edit::SetMsBetweenKeyframes(ms))))
                },
                |command, _| {
                    let Command::Edit(Edit::SetMsBetweenKeyframes(ms)) = command else { return None };
                    Some(ms.to_string())
                },
            )),
        Row::of(Changes::Session, "speed", |command| {
            matches!(command, Command::Playback(PlaybackCommand::SetSpeedPercent(_)))
        })
        .line(Line::new(
            "speed PERCENT",
            "of playing, on top of the ms between keyframes",
            |arguments| {
                let &[percent] = arguments.words else { return Ok(None) };
                let percent = arguments.whole_in(percent, "speed in percent", &SPEED_PERCENT_RANGE)?;
                Ok(Some(Command::Playback(PlaybackCommand::SetSpeedPercent(percent))))
            },
            |command, _| {
                let Command::Playback(PlaybackCommand::SetSpeedPercent(percent)) = command else { return None };
                Some(percent.to_string())
            },
        )),
    ]
}

fn playhead() -> Vec<Row> {
    let play = binding("play-from-playhead", Command::Playback(PlaybackCommand::PlayFromPlayhead));
    let step = |id, ticks, key| binding(id, Command::Playback(PlaybackCommand::Step(ticks))).repeating_hotkeys(&[key]);
    vec![
        Row::listed(Changes::Document, play.hotkeys(&["Shift+Y"])).can(can_play),
        Row::of(Changes::Session, "scrub", |command| matches!(command, Command::Playback(PlaybackCommand::Scrub(_))))
            .can(can_play)
            .line(Line::new(
                "scrub KEY_TIME",
                "shows the sample at a key time",
                |arguments| {
                    let &[key_time] = arguments.words else { return Ok(None) };
                    Ok(Some(Command::Playback(PlaybackCommand::Scrub(double(key_time)?))))
                },
                |command, _| {
                    let Command::Playback(PlaybackCommand::Scrub(key_time)) = command else { return None };
                    Some(number_text(key_time))
                },
            )),
        Row::of(Changes::Session, "step", |command| matches!(command, Command::Playback(PlaybackCommand::Step(_))))
            .refused(texts::ACT_STEP_BY_TICKS)
            .can(can_play)
            .binding(step("step-forward", 1, "Right"))
            .binding(step("step-back", -1, "Left"))
            .line(Line::new(
                "step TICKS",
                "moves the playhead by ticks of 1/60 s; below 0: back",
                |arguments| {
                    let &[ticks] = arguments.words else { return Ok(None) };
                    let ticks = arguments.whole_in(ticks, "step in ticks", &(-LONGEST_STEP..=LONGEST_STEP))?;
                    Ok(Some(Command::Playback(PlaybackCommand::Step(ticks))))
                },
                |command, _| {
                    let Command::Playback(PlaybackCommand::Step(ticks)) = command else { return None };
                    Some(ticks.to_string())
                },
            )),
    ]
}

fn modes() -> Vec<Row> {
    let next = binding("play-mode-next", Command::Playback(PlaybackCommand::NextMode));
    let auto_key = binding("auto-key", Command::View(ViewCommand::ToggleAutoKeys));
    vec![
        Row::listed(Changes::Session, next.hotkeys(&["Shift+L"])),
        Row::of(Changes::Session, "mode", |command| matches!(command, Command::Playback(PlaybackCommand::SetMode(_))))
            .line(Line::new(
                "mode once|loop|ping-pong",
                "what happens at the end of what plays",
                |arguments| {
                    let &[name] = arguments.words else { return Ok(None) };
                    let all = PlayMode::ALL.into_iter().map(|mode| (mode, mode.name()));
                    Ok(Some(Command::Playback(PlaybackCommand::SetMode(one_of(name, "a mode of playing", all)?))))
                },
                |command, _| {
                    let Command::Playback(PlaybackCommand::SetMode(mode)) = command else { return None };
                    Some(mode.name().to_owned())
                },
            )),
        Row::of(Changes::Session, "range", |command| {
            matches!(command, Command::Playback(PlaybackCommand::SetRange(_)))
        })
        .line(Line::new(
            "range FIRST LAST|all",
            "which keyframes of the list play",
            |arguments| {
                let range = match *arguments.words {
                    ["all"] => None,
                    [first, last] => Some((index(first)?, index(last)?)),
                    _ => return Ok(None),
                };
                Ok(Some(Command::Playback(PlaybackCommand::SetRange(range))))
            },
            |command, _| {
                let Command::Playback(PlaybackCommand::SetRange(range)) = command else { return None };
                Some(range.map_or_else(|| "all".to_owned(), |(first, last)| format!("{first} {last}")))
            },
        )),
        Row::listed(Changes::Session, auto_key.hotkeys(&["Shift+A"])),
        Row::of(Changes::Session, "auto-key-set", |command| {
            matches!(command, Command::View(ViewCommand::SetAutoKeys(_)))
        })
        .line(Line::new(
            "auto-key on|off",
            "whether the end of each drag updates the current keyframe",
            |arguments| {
                let &[word] = arguments.words else { return Ok(None) };
                let is_on = one_of(word, "a state", [(true, "on"), (false, "off")].into_iter())?;
                Ok(Some(Command::View(ViewCommand::SetAutoKeys(is_on))))
            },
            |command, _| {
                let Command::View(ViewCommand::SetAutoKeys(is_on)) = command else { return None };
                Some(if *is_on { "on" } else { "off" }.to_owned())
            },
        )),
    ]
}

/// The clock of timed keys; `timed_keys` has the line that sets it.
fn clock() -> Vec<Row> {
    let restart = binding("timed-keys-restart", Command::View(ViewCommand::RestartTimedKeys));
    let hold = binding("timed-keys-hold", Command::View(ViewCommand::HoldTimedKeys));
    let play = binding("timed-keys-play", Command::View(ViewCommand::PlayTimedKeys));
    vec![
        Row::listed(Changes::Session, play).can(|editor, _| editor.scene().is_timed()),
        Row::listed(Changes::Session, restart.hotkeys(&["Home"])),
        Row::listed(Changes::Session, hold.hotkeys(&["Shift+Home"])),
    ]
}
