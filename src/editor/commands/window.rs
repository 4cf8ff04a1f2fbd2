//! Commands of the window itself. Those with parameters have no script line: a script has no window that they could change.

use super::row::{Binding, Changes, Group, Menu, Row};
use crate::editor::{Command, WindowCommand};

fn binding(id: &'static str, command: WindowCommand) -> Binding {
    Binding::new(Group::Window, id, Command::Window(command)).section(8)
}

pub(super) fn rows() -> Vec<Row> {
    [lists(), scale(), settings()].concat()
}

fn lists() -> Vec<Row> {
    let commands = binding("commands", WindowCommand::ShowCommands);
    let manual = binding("manual", WindowCommand::ShowManual);
    let hotkeys = binding("hotkeys", WindowCommand::ShowHotkeys);
    let tour = binding("tour", WindowCommand::ShowTour);
    let about = binding("about", WindowCommand::ShowAbout);
    let poses = binding("poses", WindowCommand::TogglePoses);
    let messages = binding("messages", WindowCommand::ToggleMessages);
    let statistics = binding("statistics", WindowCommand::ToggleStatistics);
    let reload = binding("reload-changed", WindowCommand::ToggleReload).menu(Menu::File);
    let recorded_eye = binding("recorded-eye-at-start", WindowCommand::ToggleRecordedEye);
    let inset = binding("inset-while-playing", WindowCommand::ToggleInsetWhilePlaying);
    let motion = binding("reduce-motion", WindowCommand::ToggleReduceMotion);
    let refine = binding("refine-at-rest", WindowCommand::ToggleRefineAtRest);
    let journal = binding("journal", WindowCommand::ToggleJournal).menu(Menu::File);
    vec![
        Row::listed(Changes::Window, commands.hotkeys(&["Ctrl+Shift+P"]).menu(Menu::Help)),
        Row::listed(Changes::Window, manual.hotkeys(&["F1"]).menu(Menu::Help)),
        Row::listed(Changes::Window, hotkeys.menu(Menu::Help)),
        Row::listed(Changes::Window, tour.menu(Menu::Help).ticked(|_, window| window.tour)),
        Row::listed(Changes::Window, about.menu(Menu::Help).section(9)),
        Row::listed(Changes::Window, poses.hotkeys(&["Ctrl+L"]).ticked(|_, window| window.poses)),
        Row::listed(Changes::Window, messages.ticked(|_, window| window.messages)),
        Row::listed(Changes::Window, statistics.ticked(|_, window| window.statistics)),
        Row::listed(Changes::Window, reload.ticked(|_, window| window.reload)),
        Row::listed(Changes::Window, recorded_eye.ticked(|_, window| window.recorded_eye)),
        Row::listed(Changes::Window, inset.ticked(|_, window| window.inset_while_playing)),
        Row::listed(Changes::Window, refine.ticked(|_, window| window.refine_at_rest)),
        Row::listed(Changes::Window, motion.ticked(|_, window| window.reduce_motion)),
        Row::listed(Changes::Window, journal.ticked(|_, window| window.journal)),
    ]
}

fn scale() -> Vec<Row> {
    let larger = binding("scale-larger", WindowCommand::Larger);
    let smaller = binding("scale-smaller", WindowCommand::Smaller);
    let usual = binding("scale-usual", WindowCommand::SetScale(100));
    vec![
        Row::listed(Changes::Window, larger.repeating_hotkeys(&["Ctrl++", "Ctrl+="])),
        Row::listed(Changes::Window, smaller.repeating_hotkeys(&["Ctrl+-"])),
        Row::of(Changes::Window, "scale", |command| matches!(command, Command::Window(WindowCommand::SetScale(_))))
            .binding(usual.hotkeys(&["Ctrl+0"])),
    ]
}

fn settings() -> Vec<Row> {
    vec![
        Row::of(Changes::Window, "begin", |command| matches!(command, Command::Window(WindowCommand::Begin(_)))),
        Row::of(Changes::Window, "tour-close", |command| matches!(command, Command::Window(WindowCommand::CloseTour))),
        Row::of(Changes::Window, "folder-show", |command| {
            matches!(command, Command::Window(WindowCommand::ShowFolder(_)))
        }),
        Row::of(Changes::Window, "theme", |command| matches!(command, Command::Window(WindowCommand::SetTheme(_)))),
        Row::of(Changes::Window, "language", |command| {
            matches!(command, Command::Window(WindowCommand::SetLanguage(_)))
        }),
        Row::of(Changes::Window, "hotkeys-set", |command| {
            matches!(command, Command::Window(WindowCommand::SetHotkeys(..)))
        }),
        Row::of(Changes::Window, "hotkeys-reset", |command| {
            matches!(command, Command::Window(WindowCommand::ResetHotkeys(_)))
        }),
        Row::of(Changes::Window, "hotkeys-reset-all", |command| {
            matches!(command, Command::Window(WindowCommand::ResetAllHotkeys))
        }),
        Row::of(Changes::Window, "recent-forget", |command| {
            matches!(command, Command::Window(WindowCommand::ForgetRecent))
        }),
    ]
}
