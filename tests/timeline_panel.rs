//! The timeline, driven by pointer and keyboard with no window: each operation leaves the editor as its command would, and undo
//! returns the document to the same bytes.

mod common;

use common::{apply, editor_with, press, shown};
use egui::{
    CursorIcon, Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, Pos2, Role, TouchPhase, Vec2,
    pos2, vec2,
};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use inbetween::editor::keymap::{binding_for, press_from_word};
use inbetween::editor::{
    Command, Edit, Editor, Effect, PlayMode, PlaybackCommand, SelectionCommand, TimelineEdit, ViewCommand,
    WindowCommand,
};
use inbetween::keyframe::{Easing, KeyframeIndex, keyframes_to_json};
use inbetween::settings::Settings;
use inbetween::ui::{Panels, THUMBNAIL_PX, theme};

struct App {
    editor: Editor,
    ui: Panels,
    settings: Settings,
    commands: Vec<Command>,
    is_dressed: bool,
    cursor: CursorIcon,
}

impl App {
    /// What the window does with a command.
    fn apply(&mut self, command: Command) {
        for effect in apply(&mut self.editor, command.clone()) {
            if let Effect::Window(command) = effect {
                self.ui.perform(&command, &mut self.settings).expect("no keys are changed");
            }
        }
        self.commands.push(command);
    }
}

type Timeline = Harness<'static, App>;

fn timeline(editor: Editor) -> Timeline {
    let (ui, settings, commands) = (Panels::new(), Settings::default(), Vec::new());
    let app = App { editor, ui, settings, commands, is_dressed: false, cursor: CursorIcon::Default };
    let mut harness =
        Harness::builder().with_size(vec2(1280.0 + theme::SIDE, 800.0)).with_max_steps(60).build_ui_state(
            |ui, app: &mut App| {
                if !std::mem::replace(&mut app.is_dressed, true) {
                    theme::install(ui.ctx());
                }
                for command in app.ui.show(ui, &app.editor).commands {
                    app.apply(command);
                }
                app.cursor = ui.output(|output| output.cursor_icon);
            },
            app,
        );
    harness.run();
    harness
}

/// A timeline of keyframes 0 to 5; which is current is of no matter to the bytes.
fn six() -> Timeline {
    timeline(editor_with(6))
}

fn bytes(harness: &Timeline) -> String {
    let editor = &harness.state().editor;
    let document = editor.document();
    keyframes_to_json(editor.scene(), &document.keyframes, document.interpolation, document.ms_between_keyframes)
}

fn indices(places: &[usize]) -> Vec<KeyframeIndex> {
    places.iter().copied().map(KeyframeIndex::new).collect()
}

fn selected(harness: &Timeline) -> Vec<usize> {
    harness.state().editor.session().selected.iter().map(|index| index.get()).collect()
}

fn current(harness: &Timeline) -> usize {
    harness.state().editor.document().keyframes.current().expect("there are keyframes").get()
}

fn durations(harness: &Timeline) -> Vec<f64> {
    harness.state().editor.document().keyframes.as_slice().iter().map(|keyframe| keyframe.duration).collect()
}

/// From a diamond on the row of all, over the strip of pictures, up to the ruler's numbers.
const RULER: f32 = 82.0;
/// From there up to the handles of what plays.
const RANGE: f32 = 56.0;

/// Where a keyframe's diamond is.
fn at(harness: &Timeline, place: usize) -> Pos2 {
    harness.get_by_role_and_label(Role::ListBoxOption, &format!("Keyframe {place}")).rect().center()
}

fn ruler(harness: &Timeline, place: usize) -> Pos2 {
    at(harness, place) - vec2(0.0, RULER)
}

fn hold(harness: &mut Timeline, modifiers: Modifiers) {
    harness.event(Event::ModifiersChanged(modifiers));
    harness.run();
}

fn button(harness: &mut Timeline, at: Pos2, button: PointerButton, pressed: bool) {
    let modifiers = Modifiers::NONE;
    harness.event(Event::PointerButton { pos: at, button, pressed, modifiers });
    harness.run();
}

fn click_with(harness: &mut Timeline, at: Pos2, modifiers: Modifiers) {
    hold(harness, modifiers);
    harness.hover_at(at);
    harness.run();
    button(harness, at, PointerButton::Primary, true);
    button(harness, at, PointerButton::Primary, false);
    hold(harness, Modifiers::NONE);
}

fn press_and_move(harness: &mut Timeline, from: Pos2, to: Pos2) {
    harness.hover_at(from);
    harness.run();
    button(harness, from, PointerButton::Primary, true);
    for step in 1..=4u8 {
        harness.hover_at(from + (to - from) * (f32::from(step) / 4.0));
        harness.run();
    }
}

fn drag(harness: &mut Timeline, from: Pos2, to: Pos2) {
    press_and_move(harness, from, to);
    button(harness, to, PointerButton::Primary, false);
}

/// Presses a key as a script names it, as the window takes it: by the table of bindings, unless a field has the keyboard.
fn key(harness: &mut Timeline, word: &str) {
    assert!(!harness.state().ui.has_keyboard(&harness.ctx), "a field has the keyboard");
    let press = press_from_word(word).expect("it is a key");
    let binding = binding_for(harness.state().ui.keymap().bindings(), press).expect("it is bound");
    let command = binding.command.clone();
    harness.state_mut().apply(command);
    harness.run();
}

fn click(harness: &mut Timeline, label: &str) {
    harness.get_by_label(label).click();
    harness.run();
}

/// What the pointer or the keyboard does changes the document, and undo returns it to the same bytes.
#[track_caller]
fn check_undo(does: impl FnOnce(&mut Timeline)) -> Timeline {
    let mut harness = six();
    apply(&mut harness.state_mut().editor, Command::Edit(Edit::GoTo(KeyframeIndex::new(2))));
    harness.run();
    let before = bytes(&harness);
    does(&mut harness);
    let after = bytes(&harness);
    assert_ne!(after, before);
    press(&mut harness.state_mut().editor, "ctrl+z");
    assert_eq!(bytes(&harness), before, "one undo takes it back");
    press(&mut harness.state_mut().editor, "ctrl+y");
    assert_eq!(bytes(&harness), after);
    harness
}

#[test]
fn a_drag_on_the_ruler_scrubs_and_stays_there() {
    let mut harness = six();
    let before = bytes(&harness);
    let (from, to) = (ruler(&harness, 2), ruler(&harness, 3) + vec2(84.0, 0.0));
    press_and_move(&mut harness, from, to);
    assert_eq!(harness.state().cursor, CursorIcon::ResizeColumn);
    button(&mut harness, to, PointerButton::Primary, false);
    let editor = &harness.state().editor;
    assert!(editor.is_scrubbed());
    let key_time = editor.playhead().unwrap();
    assert!((key_time - 2.5).abs() < 0.01, "{key_time}");
    assert_eq!(bytes(&harness), before);
    assert!(harness.state().commands.iter().all(|command| matches!(command, Command::Playback(_))));
    // With Shift the playhead goes to keyframes.
    hold(&mut harness, Modifiers::SHIFT);
    drag(&mut harness, from, to + vec2(20.0, 0.0));
    assert_eq!(harness.state().editor.playhead(), Some(3.0));
}

#[test]
fn clicks_select_and_go_there() {
    let mut harness = six();
    let place = at(&harness, 2);
    click_with(&mut harness, place, Modifiers::NONE);
    assert_eq!((selected(&harness), current(&harness)), (vec![2], 2));
    assert_eq!(shown(&harness.state().editor), "0 1 [2] 3 4 5 | 2");
    let place = at(&harness, 4);
    click_with(&mut harness, place, Modifiers::SHIFT);
    assert_eq!((selected(&harness), current(&harness)), (vec![2, 3, 4], 2));
    let place = at(&harness, 3);
    click_with(&mut harness, place, Modifiers::CTRL);
    assert_eq!(selected(&harness), [2, 4]);
    let nothing = at(&harness, 3) + vec2(84.0, 44.0);
    click_with(&mut harness, nothing, Modifiers::NONE);
    assert!(selected(&harness).is_empty());
}

#[test]
fn a_box_selects_and_escape_takes_it_back() {
    let mut harness = six();
    let from = at(&harness, 1) + vec2(60.0, 80.0);
    let to = at(&harness, 4) + vec2(20.0, 10.0);
    press_and_move(&mut harness, from, to);
    assert_eq!(harness.state().cursor, CursorIcon::Crosshair);
    assert_eq!(selected(&harness), [2, 3, 4]);
    button(&mut harness, to, PointerButton::Primary, false);
    hold(&mut harness, Modifiers::CTRL);
    let right = at(&harness, 5) + vec2(20.0, 60.0);
    drag(&mut harness, right, to - vec2(60.0, 0.0));
    hold(&mut harness, Modifiers::NONE);
    assert_eq!(selected(&harness), [2, 3, 5]);
    press_and_move(&mut harness, from, to);
    harness.key_press(Key::Escape);
    harness.run();
    button(&mut harness, to, PointerButton::Primary, false);
    assert_eq!(selected(&harness), [2, 3, 5]);
}

#[test]
fn dragged_keyframes_move_in_the_list() {
    let harness = check_undo(|harness| {
        let (from, to) = (at(harness, 1), at(harness, 3) + vec2(60.0, 0.0));
        press_and_move(harness, from, to);
        assert_eq!(harness.state().cursor, CursorIcon::Grabbing);
        button(harness, to, PointerButton::Primary, false);
    });
    assert_eq!(shown(&harness.state().editor), "0 2 3 [1] 4 5 | 1");
    let moved = Command::Edit(Edit::Timeline(TimelineEdit::MoveKeyframes(4)));
    assert_eq!(harness.state().commands.last(), Some(&moved));
}

#[test]
fn a_drag_between_the_neighbours_retimes_a_keyframe_alone() {
    // 168 points a step of 2 s: 21 points are an eighth of a step, which is no tenth but 15 ticks.
    let harness = check_undo(|harness| {
        let from = at(harness, 3);
        drag(harness, from, from + vec2(21.0, 0.0));
    });
    assert_eq!(durations(&harness), [1.0, 1.0, 1.125, 0.875, 1.0, 1.0]);
    assert_eq!(selected(&harness), [3]);
    // Near a tenth it is the tenth; with Ctrl it is where the pointer is, to the millisecond.
    for (by, modifiers, ms) in [(35.0, Modifiers::NONE, 400.0), (35.0, Modifiers::CTRL, 417.0)] {
        let mut harness = six();
        let from = at(&harness, 3);
        press_and_move(&mut harness, from, from + vec2(by, 0.0));
        hold(&mut harness, modifiers);
        button(&mut harness, from + vec2(by, 0.0), PointerButton::Primary, false);
        assert!((durations(&harness)[2] - 1.0 - ms / 2000.0).abs() < 1e-12, "{:?}", durations(&harness));
    }
}

#[test]
fn with_shift_what_follows_moves_along() {
    let harness = check_undo(|harness| {
        let from = at(harness, 3);
        hold(harness, Modifiers::SHIFT);
        drag(harness, from, from + vec2(336.0, 0.0));
        hold(harness, Modifiers::NONE);
    });
    assert_eq!(durations(&harness), [1.0, 1.0, 3.0, 1.0, 1.0, 1.0]);
}

#[test]
fn the_first_played_keyframe_follows_the_pointer_too() {
    let mut harness = six();
    let (first, third) = (at(&harness, 1), at(&harness, 3));
    drag(&mut harness, first, first + vec2(84.0, 0.0));
    assert_eq!(durations(&harness), [1.5, 0.5, 1.0, 1.0, 1.0, 1.0]);
    assert!((at(&harness, 1) - first - vec2(84.0, 0.0)).length() < 0.5);
    assert!((at(&harness, 3) - third).length() < 0.5, "what was not dragged stays where it was");
}

#[test]
fn coming_back_from_past_a_neighbour_leaves_no_trace() {
    let mut harness = six();
    let before = bytes(&harness);
    let (from, far) = (at(&harness, 2), at(&harness, 4) + vec2(30.0, 0.0));
    press_and_move(&mut harness, from, far);
    assert_eq!(bytes(&harness), before, "the list changes when the button is released");
    for at in [from + vec2(60.0, 0.0), from] {
        harness.hover_at(at);
        harness.run();
    }
    button(&mut harness, from, PointerButton::Primary, false);
    assert_eq!(bytes(&harness), before);
    assert!(!harness.state().editor.is_dragging());
}

#[test]
fn the_edges_of_what_is_selected_scale_it() {
    let harness = check_undo(|harness| {
        apply(&mut harness.state_mut().editor, Command::Selection(SelectionCommand::Keyframes(indices(&[1, 2, 3]))));
        harness.run();
        // On the rows of nodes, beside the last selected diamond.
        let edge = at(harness, 3) + vec2(11.0, 22.0);
        harness.hover_at(edge);
        harness.run();
        assert_eq!(harness.state().cursor, CursorIcon::ResizeHorizontal);
        drag(harness, edge, edge + vec2(67.2, 0.0));
    });
    assert_eq!(durations(&harness), [1.0, 1.2, 1.2, 0.6, 1.0, 1.0]);
}

/// The numbers on the ruler, from left to right, and where each stands.
fn numbers(harness: &Timeline) -> Vec<(String, f32, f32)> {
    let ruler = harness.get_by_label("Timeline").rect();
    let mut found = Vec::new();
    for clipped in &harness.output().shapes {
        let egui::Shape::Text(text) = &clipped.shape else { continue };
        let (rect, words) = (text.visual_bounding_rect(), text.galley.text());
        // Seconds stand above.
        if (rect.center().y - ruler.top() - 20.0).abs() < 5.0 && words.parse::<usize>().is_ok() {
            found.push((words.to_owned(), rect.left(), rect.right()));
        }
    }
    found.sort_by(|a, b| a.1.total_cmp(&b.1));
    found
}

#[test]
fn numbers_on_the_ruler_never_run_into_each_other() {
    for count in [6, 200, 1200] {
        let mut harness = timeline(editor_with(count));
        for zoom in 0..3 {
            let ask = [WindowCommand::FitTimeline, WindowCommand::FitSelection][zoom % 2].clone();
            harness.state_mut().apply(Command::Window(ask));
            harness.run();
            let numbers = numbers(&harness);
            assert!(numbers.len() >= 2, "{count}: {numbers:?}");
            for pair in numbers.windows(2) {
                assert!(pair[1].1 - pair[0].2 >= 3.0, "{count}: {pair:?}");
            }
        }
    }
}

#[test]
fn copies_and_deletions_change_no_scale() {
    let mut harness = timeline(editor_with(12));
    let distance = |harness: &Timeline| (at(harness, 3) - at(harness, 2)).x;
    let before = distance(&harness);
    let place = at(&harness, 3);
    click_with(&mut harness, place, Modifiers::NONE);
    for word in ["ctrl+c", "ctrl+v", "ctrl+d", "delete", "ctrl+z", "d", "d", "d", "d", "d", "d"] {
        key(&mut harness, word);
        assert_eq!(distance(&harness), before, "after {word}");
        let first = at(&harness, 2);
        assert!((first.x - place.x + before).abs() < 0.5, "after {word}: what was seen moved");
    }
}

#[test]
fn tab_stops_once_and_arrows_move_within() {
    let mut harness = timeline(editor_with(12));
    let focused = |harness: &Timeline| {
        let mut nodes = harness.query_all_by(|node| node.is_focused() && !node.is_hidden());
        nodes.find_map(|node| node.accesskit_node().label()).unwrap_or_default()
    };
    let mut stops = Vec::new();
    for _ in 0..80 {
        harness.key_press(Key::Tab);
        harness.run();
        stops.push(focused(&harness));
    }
    let round = stops.iter().skip(1).position(|name| *name == stops[0]).expect("Tab goes around") + 1;
    let is_item = |name: &&String| name.starts_with("Keyframe ") || name.starts_with("Row of ");
    let items: Vec<_> = stops[..round].iter().filter(is_item).collect();
    assert_eq!(items, ["Keyframe 11"], "the current one alone: {stops:?}");
    while focused(&harness) != "Keyframe 11" {
        harness.key_press(Key::Tab);
        harness.run();
    }
    let go = |harness: &mut Timeline, key: Key, expected: &str| {
        harness.key_press(key);
        harness.run();
        harness.run();
        assert_eq!(focused(harness), expected, "after {key:?}");
        assert!(harness.state().ui.takes_arrows(&harness.ctx), "no hotkey has them");
    };
    for place in (0..11).rev() {
        go(&mut harness, Key::ArrowLeft, &format!("Keyframe {place}"));
    }
    go(&mut harness, Key::ArrowRight, "Keyframe 1");
    go(&mut harness, Key::ArrowDown, "Row of sky");
    go(&mut harness, Key::ArrowDown, "Row of ground");
    go(&mut harness, Key::ArrowDown, "Row of robot1");
    go(&mut harness, Key::ArrowRight, "Row of robot1");
    go(&mut harness, Key::ArrowDown, "Row of robot1/right_shoulder");
    go(&mut harness, Key::ArrowUp, "Row of robot1");
    go(&mut harness, Key::ArrowLeft, "Row of robot1");
    assert!(harness.query_by_label("Row of robot1/right_shoulder").is_none(), "it is folded again");
    for _ in 0..3 {
        harness.key_press(Key::ArrowUp);
        harness.run();
    }
    go(&mut harness, Key::ArrowRight, "Keyframe 1");
    harness.key_press(Key::Enter);
    harness.run();
    assert_eq!((selected(&harness), current(&harness)), (vec![1], 1));
}

#[test]
fn the_ruler_says_which_curve_of_a_graph_is_which() {
    let mut harness = six();
    let robot = harness.state().editor.scene().find_rbt("robot1");
    apply(&mut harness.state_mut().editor, Command::View(ViewCommand::Choose(robot)));
    click(&mut harness, "Graphs");
    let ruler = harness.get_by_label("Timeline").rect();
    let written: Vec<String> = (harness.output().shapes.iter())
        .filter_map(|clipped| match &clipped.shape {
            egui::Shape::Text(text) if clipped.clip_rect.contains(text.visual_bounding_rect().center()) => {
                let is_in_ruler = (ruler.top()..ruler.top() + 14.0).contains(&text.visual_bounding_rect().center().y);
                is_in_ruler.then(|| text.galley.text().to_owned())
            }
            _ => None,
        })
        .collect();
    assert!(written.contains(&"Linear".to_owned()) && written.contains(&"Catmull-Rom".to_owned()), "{written:?}");
}

#[test]
fn what_has_no_room_in_the_transport_is_in_a_menu() {
    let mut harness = six();
    assert!(harness.query_by_label("More of the transport").is_none());
    harness.set_size(vec2(720.0, 480.0));
    harness.run();
    assert!(harness.query_by_label("Delete keyframe 5, the current one").is_none());
    click(&mut harness, "More of the transport");
    for label in ["Speed in percent", "Update keyframe u", "Display keyframe Space", "Ghosts Shift+G"] {
        assert!(harness.query_all_by_label(label).next().is_some(), "{label}");
    }
    click(&mut harness, "Delete keyframe d");
    assert_eq!(shown(&harness.state().editor), "0 1 2 3 [4] | 4");
}

#[test]
fn what_only_steers_is_said_where_it_stands() {
    let mut harness = timeline(editor_with(4));
    let written = |harness: &Timeline, words: &str| {
        let texts = harness.output().shapes.iter().filter_map(|clipped| match &clipped.shape {
            egui::Shape::Text(text) => Some(text.galley.text().to_owned()),
            _ => None,
        });
        texts.filter(|text| text == words).count()
    };
    assert_eq!(written(&harness, "only steers"), 2, "the first and the last");
    assert!(harness.query_by_label("3 only steers").is_some(), "the transport says it of the current one");
    key(&mut harness, "<");
    assert!(harness.query_by_label("3 only steers").is_none());
    key(&mut harness, "d");
    assert_eq!(written(&harness, "only steers"), 0, "nothing plays");
}

#[test]
fn the_status_line_says_how_many_are_selected() {
    let mut harness = six();
    assert!(harness.query_by_label("·  4 selected").is_none());
    let all = Command::Selection(SelectionCommand::Keyframes(indices(&[0, 2, 3, 5])));
    apply(&mut harness.state_mut().editor, all);
    harness.run();
    assert!(harness.query_by_label("·  4 selected").is_some());
}

#[test]
fn a_move_that_escape_ends_moves_nothing() {
    let mut harness = six();
    let before = bytes(&harness);
    let (from, to) = (at(&harness, 1), at(&harness, 3) + vec2(60.0, 0.0));
    press_and_move(&mut harness, from, to);
    harness.key_press(Key::Escape);
    harness.run();
    button(&mut harness, to, PointerButton::Primary, false);
    assert_eq!(bytes(&harness), before);
}

#[test]
fn a_time_handle_retimes_one_interval() {
    let harness = check_undo(|harness| {
        let grip = at(harness, 3) - vec2(13.0, 0.0);
        harness.hover_at(grip);
        harness.run();
        assert_eq!(harness.state().cursor, CursorIcon::ResizeHorizontal);
        drag(harness, grip, grip + vec2(84.0, 0.0));
    });
    assert_eq!(durations(&harness), [1.0, 1.0, 1.5, 1.0, 1.0, 1.0]);
}

#[test]
fn with_shift_the_neighbour_gives_what_an_interval_takes() {
    let harness = check_undo(|harness| {
        let grip = at(harness, 3) - vec2(13.0, 0.0);
        press_and_move(harness, grip, grip + vec2(84.0, 0.0));
        hold(harness, Modifiers::SHIFT);
        assert_eq!(durations(harness)[2..4], [1.5, 0.5]);
        hold(harness, Modifiers::NONE);
        assert_eq!(durations(harness)[2..4], [1.5, 1.0], "without Shift the neighbour has its own again");
        hold(harness, Modifiers::SHIFT);
        button(harness, grip + vec2(84.0, 0.0), PointerButton::Primary, false);
    });
    assert_eq!(durations(&harness), [1.0, 1.0, 1.5, 0.5, 1.0, 1.0]);
}

#[test]
fn a_retiming_that_escape_ends_is_as_if_it_had_not_been() {
    let mut harness = six();
    let (before, undo) = (bytes(&harness), harness.state().editor.undo_label());
    let grip = at(&harness, 3) - vec2(13.0, 0.0);
    press_and_move(&mut harness, grip, grip + vec2(84.0, 0.0));
    assert_ne!(bytes(&harness), before);
    harness.key_press(Key::Escape);
    harness.run();
    button(&mut harness, grip, PointerButton::Primary, false);
    assert_eq!((bytes(&harness), harness.state().editor.undo_label()), (before, undo));
    assert!(!harness.state().editor.is_dragging());
}

#[test]
fn the_played_range_is_dragged_by_its_ends() {
    let mut harness = six();
    let handle = |harness: &Timeline, place| at(harness, place) - vec2(0.0, RANGE);
    let (from, to) = (handle(&harness, 1), handle(&harness, 2) + vec2(9.0, 0.0));
    drag(&mut harness, from, to);
    assert_eq!(harness.state().editor.session().play_range, Some((2, 4)));
    let (from, to) = (handle(&harness, 4), handle(&harness, 3));
    drag(&mut harness, from, to);
    assert_eq!(harness.state().editor.session().play_range, Some((2, 3)));
    let (from, to) = (handle(&harness, 2), handle(&harness, 0));
    drag(&mut harness, from, to);
    let (from, to) = (handle(&harness, 3), handle(&harness, 5));
    drag(&mut harness, from, to);
    assert_eq!(harness.state().editor.session().play_range, None);
}

#[test]
fn a_range_that_escape_ends_is_what_it_was() {
    let mut harness = six();
    let handle = |harness: &Timeline, place| at(harness, place) - vec2(0.0, RANGE);
    for before in [None, Some((2, 4))] {
        apply(&mut harness.state_mut().editor, Command::Playback(PlaybackCommand::SetRange(before)));
        harness.run();
        let (from, to) = (handle(&harness, before.map_or(1, |(first, _)| first)), handle(&harness, 3));
        press_and_move(&mut harness, from, to);
        assert_eq!(harness.state().editor.session().play_range, Some((3, 4)));
        harness.key_press(Key::Escape);
        harness.run();
        button(&mut harness, to, PointerButton::Primary, false);
        assert_eq!(harness.state().editor.session().play_range, before);
    }
}

#[test]
fn a_double_click_names_a_keyframe() {
    let harness = check_undo(|harness| {
        // Frames of a test are a quarter of a second.
        harness.ctx.options_mut(|options| options.input_options.max_double_click_delay = 10.0);
        let place = at(harness, 3);
        harness.hover_at(place);
        harness.run();
        for pressed in [true, false, true, false] {
            harness.event(Event::PointerButton {
                pos: place,
                button: PointerButton::Primary,
                pressed,
                modifiers: Modifiers::NONE,
            });
        }
        harness.run();
        assert!(harness.state().ui.has_keyboard(&harness.ctx));
        harness.event(Event::Text("jump".to_owned()));
        harness.run();
        harness.key_press(Key::Enter);
        harness.run();
    });
    assert_eq!(harness.state().editor.document().keyframes.as_slice()[3].name.as_deref(), Some("jump"));
}

#[test]
fn keys_do_what_the_menus_do() {
    for (keys, expected) in [
        ("ctrl+c ctrl+v", "0 1 2 [2] 3 4 5 | 2"),
        ("ctrl+x", "0 [1] 3 4 5 | 1"),
        ("ctrl+d", "0 1 2 [2] 3 4 5 | 2"),
        ("delete", "0 [1] 3 4 5 | 1"),
    ] {
        let harness = check_undo(|harness| {
            for word in keys.split(' ') {
                key(harness, word);
            }
        });
        assert_eq!(shown(&harness.state().editor), expected, "{keys}");
    }
    let mut harness = six();
    key(&mut harness, "shift+l");
    assert_eq!(harness.state().editor.session().play_mode, PlayMode::Loop);
    key(&mut harness, "shift+a");
    assert!(harness.state().editor.session().auto_keys);
    for word in ["left", "left", "right"] {
        key(&mut harness, word);
    }
    assert!((harness.state().editor.playhead().unwrap() - (3.0 - 1.0 / 120.0)).abs() < 1e-9);
    apply(&mut harness.state_mut().editor, Command::Playback(PlaybackCommand::Scrub(1.5)));
    let before = bytes(&harness);
    key(&mut harness, "n");
    assert_eq!(shown(&harness.state().editor), "0 1 2 [2.5] 3 4 5 | 2.5");
    key(&mut harness, "ctrl+z");
    assert_eq!(bytes(&harness), before);
}

#[test]
fn a_pose_goes_to_the_other_robot_by_keys() {
    let mut harness = six();
    let robot = |harness: &Timeline, path: &str| harness.state().editor.scene().find_rbt(path).unwrap();
    let (elbow1, elbow2) =
        (robot(&harness, "robot1/right_shoulder/right_elbow"), robot(&harness, "robot2/right_shoulder/right_elbow"));
    let turned = glam::Quat::from_rotation_y(0.7);
    apply(&mut harness.state_mut().editor, Command::Edit(Edit::SetRotation(elbow1, turned)));
    harness.run();
    click(&mut harness, "Row of robot1");
    key(&mut harness, "ctrl+shift+c");
    click(&mut harness, "Row of robot2");
    assert_eq!(harness.state().editor.session().chosen.primary(), Some(robot(&harness, "robot2")));
    let before = harness.state().editor.displayed_pose();
    key(&mut harness, "ctrl+shift+v");
    assert_eq!(harness.state().editor.displayed_pose().get(elbow2).rotation, turned);
    key(&mut harness, "ctrl+z");
    assert_eq!(harness.state().editor.displayed_pose(), before);
}

/// Auto-key by the pointer: a number that is dragged in the inspector is a drag.
#[test]
fn with_auto_key_the_end_of_a_drag_updates_the_keyframe() {
    let harness = check_undo(|harness| {
        click(harness, "Auto-key is off");
        click(harness, "Row of robot1");
        let from = harness.get_by_label("Translation y").rect().center();
        drag(harness, from, from + vec2(60.0, 0.0));
    });
    let editor = &harness.state().editor;
    let robot = editor.scene().find_rbt("robot1").unwrap();
    assert!(editor.document().keyframes.as_slice()[2].pose.get(robot).translation.y > 1.01);
}

#[test]
fn the_menu_selects_all_and_plays_all() {
    let mut harness = six();
    apply(&mut harness.state_mut().editor, Command::Playback(PlaybackCommand::SetRange(Some((2, 3)))));
    harness.run();
    let nothing = at(&harness, 3) + vec2(84.0, 44.0);
    secondary_click(&mut harness, nothing);
    click(&mut harness, "Select all keyframes");
    assert_eq!(selected(&harness), [0, 1, 2, 3, 4, 5]);
    secondary_click(&mut harness, nothing);
    click(&mut harness, "Play all keyframes");
    assert_eq!(harness.state().editor.session().play_range, None);
}

#[test]
fn diamonds_of_nodes_that_stand_still_are_looked_at_too() {
    // A click on a node's row takes the keyframe as one on the row of all does.
    let mut harness = six();
    let on_a_row = at(&harness, 4) + vec2(0.0, 22.0);
    click_with(&mut harness, on_a_row, Modifiers::NONE);
    assert_eq!((selected(&harness), current(&harness)), (vec![4], 4));
}

fn scroll(harness: &mut Timeline, at: Pos2, delta: Vec2, modifiers: Modifiers) {
    harness.hover_at(at);
    harness.run();
    hold(harness, modifiers);
    let phase = TouchPhase::Move;
    let (unit, source) = (MouseWheelUnit::Point, MouseWheelSource::Wheel);
    harness.event(Event::MouseWheel { unit, delta, modifiers, phase, source });
    harness.run_steps(30);
    hold(harness, Modifiers::NONE);
}

/// Where the first and the last keyframe stand that fit: 24 points from the ends of the tracks.
const FITTED: [f32; 2] = [216.0, 1248.0];

#[test]
fn the_wheel_zooms_about_the_pointer_and_pans() {
    let mut harness = six();
    let pointer = at(&harness, 2) + vec2(0.0, 20.0);
    let apart = at(&harness, 3).x - at(&harness, 2).x;
    scroll(&mut harness, pointer, vec2(0.0, 60.0), Modifiers::CTRL);
    let zoomed = at(&harness, 3).x - at(&harness, 2).x;
    assert!(zoomed > apart * 1.1, "{zoomed} after {apart}");
    assert!((at(&harness, 2).x - pointer.x).abs() < 0.5);
    let before = at(&harness, 2).x;
    scroll(&mut harness, pointer, vec2(0.0, -50.0), Modifiers::NONE);
    assert!((at(&harness, 2).x - (before - 50.0)).abs() < 1.0, "{} after {before}", at(&harness, 2).x);
    // The middle button pans.
    let before = at(&harness, 2).x;
    harness.hover_at(pointer);
    button(&mut harness, pointer, PointerButton::Middle, true);
    for step in 1..=5u8 {
        harness.hover_at(pointer + vec2(10.0 * f32::from(step), 0.0));
        harness.run();
    }
    button(&mut harness, pointer + vec2(50.0, 0.0), PointerButton::Middle, false);
    assert!((at(&harness, 2).x - before - 50.0).abs() < 12.0);
    click(&mut harness, "Fit all");
    assert_eq!([0, 5].map(|place| at(&harness, place).x.round()), FITTED);
    apply(&mut harness.state_mut().editor, Command::Selection(SelectionCommand::Keyframes(indices(&[1, 2, 3]))));
    click(&mut harness, "Fit selection");
    assert_eq!([1, 3].map(|place| at(&harness, place).x.round()), FITTED);
    key(&mut harness, "f");
    assert_eq!([0, 5].map(|place| at(&harness, place).x.round()), FITTED);
    key(&mut harness, "shift+f");
    assert_eq!([1, 3].map(|place| at(&harness, place).x.round()), FITTED);
}

#[test]
fn rows_unfold_scroll_and_choose() {
    let mut harness = six();
    assert!(harness.query_by_label("Row of robot1/head").is_none());
    click(&mut harness, "Unfold the row of robot1");
    assert!(harness.query_by_label("Row of robot1/right_shoulder").is_some());
    assert!(harness.query_by_label("Row of robot2").is_none(), "it is out of sight");
    let over = at(&harness, 2) + vec2(0.0, 60.0);
    scroll(&mut harness, over, vec2(0.0, -400.0), Modifiers::SHIFT);
    click(&mut harness, "Row of robot2");
    let editor = &harness.state().editor;
    assert_eq!(editor.session().chosen.primary().map(|rbt| editor.scene().rbt_path(rbt)), Some("robot2"));
}

fn secondary_click(harness: &mut Timeline, at: Pos2) {
    harness.hover_at(at);
    harness.run();
    button(harness, at, PointerButton::Secondary, true);
    button(harness, at, PointerButton::Secondary, false);
}

/// Opens the context menu of a keyframe and clicks an item.
fn choose(harness: &mut Timeline, place: usize, item: &str) {
    let centre = at(harness, place);
    secondary_click(harness, centre);
    harness.get_by_label(item).click();
    harness.run();
}

#[test]
fn the_menu_edits_keyframes() {
    for (item, expected) in [
        ("Duplicate keyframes Ctrl+D", "0 1 2 3 [3] 4 5 | 3"),
        ("Cut keyframes Ctrl+X", "0 1 [2] 4 5 | 2"),
        ("Delete 1 keyframe Delete", "0 1 [2] 4 5 | 2"),
        ("Reverse keyframes", "5 4 3 [2] 1 0 | 2"),
    ] {
        let harness = check_undo(|harness| choose(harness, 3, item));
        assert_eq!(shown(&harness.state().editor), expected, "{item}");
    }
    let harness = check_undo(|harness| {
        choose(harness, 3, "Copy keyframes Ctrl+C");
        choose(harness, 1, "Paste keyframes Ctrl+V");
    });
    assert_eq!(shown(&harness.state().editor), "0 1 [3] 2 3 4 5 | 3");
}

#[test]
fn the_menu_has_pictures_of_easings() {
    let harness = check_undo(|harness| {
        choose(harness, 3, "Easing");
        click(harness, "Easing: Bounce, out");
    });
    let keyframes = harness.state().editor.document().keyframes.as_slice();
    assert_eq!(keyframes[3].easing, Easing::from_name("bounce-out").unwrap());
    assert_eq!(keyframes.iter().filter(|keyframe| keyframe.easing != Easing::Linear).count(), 1);
}

#[test]
fn the_menu_has_a_field_for_the_duration() {
    let harness = check_undo(|harness| {
        choose(harness, 3, "Duration in steps");
        harness.key_press_modifiers(Modifiers::CTRL, Key::A);
        harness.event(Event::Text("2.25".to_owned()));
        harness.run();
        harness.key_press(Key::Enter);
        harness.run();
    });
    assert_eq!(durations(&harness)[3], 2.25);
}

#[test]
fn f2_names_the_current_keyframe() {
    let harness = check_undo(|harness| {
        key(harness, "f2");
        assert!(harness.state().ui.has_keyboard(&harness.ctx));
        harness.event(Event::Text("jump".to_owned()));
        harness.run();
        harness.key_press(Key::Enter);
        harness.run();
        assert!(!harness.state().ui.has_keyboard(&harness.ctx));
    });
    assert_eq!(harness.state().editor.document().keyframes.as_slice()[2].name.as_deref(), Some("jump"));
    // The menu leads to the same field, which Escape leaves.
    let mut harness = harness;
    let before = bytes(&harness);
    choose(&mut harness, 2, "Rename keyframe… F2");
    harness.event(Event::Text("fall".to_owned()));
    harness.run();
    harness.key_press(Key::Escape);
    harness.run();
    assert_eq!(bytes(&harness), before);
}

#[test]
fn the_keyboard_alone_reaches_every_keyframe() {
    let mut harness = six();
    harness.get_by_label("Keyframe 2").focus();
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
    assert_eq!((selected(&harness), current(&harness)), (vec![2], 2));
}

#[test]
fn hotkeys_that_leave_the_selection_drop_it() {
    let mut harness = six();
    let place = at(&harness, 2);
    click_with(&mut harness, place, Modifiers::NONE);
    press(&mut harness.state_mut().editor, ">");
    assert!(selected(&harness).is_empty());
    press(&mut harness.state_mut().editor, "delete");
    assert_eq!(shown(&harness.state().editor), "0 1 [2] 4 5 | 2");
}

#[test]
fn retiming_while_scrubbed_keeps_the_scene_and_the_live_pose() {
    let mut harness = six();
    let (from, to) = (ruler(&harness, 2), ruler(&harness, 2) + vec2(60.0, 0.0));
    drag(&mut harness, from, to);
    let live = harness.state().editor.document().live_pose.clone();
    let grip = at(&harness, 4) - vec2(13.0, 0.0);
    drag(&mut harness, grip, grip + vec2(40.0, 0.0));
    assert!(harness.state().editor.is_scrubbed());
    assert_eq!(harness.state().editor.document().live_pose, live);
}

#[test]
fn the_transport_has_all_of_playing() {
    let mut harness = six();
    click(&mut harness, "Plays once");
    assert_eq!(harness.state().editor.session().play_mode, PlayMode::Loop);
    click(&mut harness, "Plays in a loop");
    click(&mut harness, "Plays forwards and backwards");
    assert_eq!(harness.state().editor.session().play_mode, PlayMode::Once);
    click(&mut harness, "Auto-key is off");
    assert!(harness.state().editor.session().auto_keys);
    harness.get_by_label("Auto-key is on");
    let next = "Ghosts: none. A click shows one more of the neighbouring keyframes, up to 3";
    click(&mut harness, next);
    assert_eq!(harness.state().editor.session().ghosts, 1);
    key(&mut harness, "shift+g");
    assert_eq!(harness.state().editor.session().ghosts, 2);
    click(&mut harness, "Speed in percent");
    harness.key_press_modifiers(Modifiers::CTRL, Key::A);
    harness.event(Event::Text("50".to_owned()));
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
    assert_eq!(harness.state().editor.session().speed_percent, 50);
    apply(&mut harness.state_mut().editor, Command::Playback(PlaybackCommand::Scrub(1.5)));
    harness.step();
    harness.get_by_label("Play from playhead").click();
    harness.step();
    harness.step();
    assert!(harness.state().editor.is_playing());
    assert_eq!(harness.state().editor.playhead(), Some(1.5));
}

/// Robot 1 is chosen and its graphs are shown.
fn show_graphs(harness: &mut Timeline) {
    click(harness, "Row of robot1");
    click(harness, "Graphs");
    click(harness, "Graph of Speed");
}

#[test]
fn a_dot_of_a_graph_edits_its_keyframe() {
    let harness = check_undo(|harness| {
        // x runs from 0 to 5; y is 1 throughout and z is 0.
        let x = at(harness, 3).x;
        show_graphs(harness);
        let dot = (0..80)
            .map(|down| pos2(x, 614.0 + f32::from(down as u8) * 1.5))
            .find(|&place| {
                harness.hover_at(place);
                harness.run();
                harness.state().cursor == CursorIcon::ResizeVertical
            })
            .expect("there is a dot");
        drag(harness, dot + vec2(0.0, 4.0), dot + vec2(0.0, -16.0));
    });
    let editor = &harness.state().editor;
    let robot = editor.scene().find_rbt("robot1").unwrap();
    let at = |place: usize| editor.document().keyframes.as_slice()[place].pose.get(robot).translation;
    assert!(at(3).x > 3.3 && at(3).x < 4.5, "{}", at(3));
    assert_eq!((at(3).y, at(3).z, at(2).x), (1.0, 0.0, 2.0));
}

#[test]
fn graphs_scrub_and_escape_ends_the_drag_of_a_dot() {
    let mut harness = six();
    let (from, to) = (at(&harness, 2) + vec2(40.0, 60.0), at(&harness, 3) + vec2(84.0, 60.0));
    show_graphs(&mut harness);
    drag(&mut harness, from, to);
    assert!((harness.state().editor.playhead().unwrap() - 2.5).abs() < 0.02);
    harness.get_by_label("Graph of Angle");
}

/// Where a keyframe's picture stands in the strip.
fn picture(harness: &Timeline, place: usize) -> Pos2 {
    at(harness, place) - vec2(0.0, 32.0)
}

/// Pictures that the window would have made by now, all of one grey; says how many.
fn make_pictures(harness: &mut Timeline) -> usize {
    let [width, height] = THUMBNAIL_PX;
    for made in 0.. {
        let Some(pose) = harness.state().ui.wanted_thumbnail().cloned() else { return made };
        let context = harness.ctx.clone();
        harness.state_mut().ui.put_thumbnail(&context, pose, &vec![128; width * height * 4]);
        harness.run();
    }
    0
}

#[test]
fn pictures_are_wanted_for_what_is_in_sight_and_then_nothing_more() {
    let mut harness = six();
    assert_eq!(make_pictures(&mut harness), 6);
    harness.run();
    assert_eq!(harness.state().ui.wanted_thumbnail(), None, "an idle window has nothing to do");
    // An edit wants the one that it changed, undo none.
    let robot = harness.state().editor.scene().find_rbt("robot1").unwrap();
    let edit = TimelineEdit::SetTranslationInKeyframe(KeyframeIndex::new(2), robot, glam::Vec3::ONE);
    apply(&mut harness.state_mut().editor, Command::Edit(Edit::Timeline(edit)));
    harness.run();
    assert_eq!(make_pictures(&mut harness), 1);
    key(&mut harness, "ctrl+z");
    assert_eq!(make_pictures(&mut harness), 0);
    click(&mut harness, "Graphs");
    assert_eq!(make_pictures(&mut harness), 0, "graphs show none");
}

#[test]
fn ten_thousand_keyframes_want_a_few_pictures() {
    let mut editor = editor_with(5);
    for _ in 0..11 {
        apply(&mut editor, Command::Selection(SelectionCommand::Keyframes(Vec::new())));
        let all = (0..editor.document().keyframes.len()).map(KeyframeIndex::new).collect();
        apply(&mut editor, Command::Selection(SelectionCommand::Keyframes(all)));
        apply(&mut editor, Command::Edit(Edit::Timeline(TimelineEdit::DuplicateKeyframes)));
    }
    assert_eq!(editor.document().keyframes.len(), 10_240);
    let mut harness = timeline(editor);
    assert!(make_pictures(&mut harness) <= 24);
    key(&mut harness, "f");
    assert!(make_pictures(&mut harness) <= 24);
}

#[test]
fn a_picture_is_its_keyframe() {
    let mut harness = six();
    let place = picture(&harness, 2);
    click_with(&mut harness, place, Modifiers::NONE);
    assert_eq!((selected(&harness), current(&harness)), (vec![2], 2));
    let between = picture(&harness, 2) + vec2(84.0, 0.0);
    click_with(&mut harness, between, Modifiers::NONE);
    assert!(selected(&harness).is_empty());
}

#[test]
fn a_tooltip_has_the_picture_and_what_is_known_of_the_keyframe() {
    let mut harness = six();
    apply(
        &mut harness.state_mut().editor,
        Command::Edit(Edit::Timeline(TimelineEdit::RenameKeyframe(KeyframeIndex::new(2), "jump".to_owned()))),
    );
    let place = at(&harness, 2);
    harness.hover_at(place);
    for _ in 0..8 {
        harness.step();
    }
    harness.get_by_label("Keyframe 2 · jump");
    harness.get_by_label("Key time 1 · 2.00 s\nThen 1.00 steps = 2.00 s · Linear");
}

/// Keyframe 2 to 3 turns robot 2's head by 178 degrees, with everything else at rest.
fn nearly_half_a_turn() -> Timeline {
    let mut editor = editor_with(6);
    let head = editor.scene().find_rbt("robot2/head").unwrap();
    for place in 3..6 {
        let turned = glam::Quat::from_rotation_y(178_f32.to_radians());
        let edit = TimelineEdit::SetRotationInKeyframe(KeyframeIndex::new(place), head, turned);
        apply(&mut editor, Command::Edit(Edit::Timeline(edit)));
    }
    timeline(editor)
}

#[test]
fn an_interval_of_nearly_half_a_turn_is_marked_and_explained() {
    let mut harness = nearly_half_a_turn();
    let tells = |harness: &mut Timeline, place: usize| {
        let middle = at(harness, place).lerp(at(harness, place + 1), 0.5);
        harness.hover_at(middle);
        for _ in 0..8 {
            harness.step();
        }
        harness.query_by_label(&format!("Keyframe {place} to {}: nearly half a turn", place + 1)).is_some()
    };
    assert!(tells(&mut harness, 2));
    harness.get_by_label_contains("robot2/head 178.0°\nSo near to half a turn");
    assert!(!tells(&mut harness, 1) && !tells(&mut harness, 3));
    // The mark takes no drag: a box is drawn from it as from any empty place.
    let from = at(&harness, 2).lerp(at(&harness, 3), 0.5);
    let to = at(&harness, 4) + vec2(20.0, 40.0);
    drag(&mut harness, from, to);
    assert_eq!(selected(&harness), [3, 4]);
    // A keyframe between the two decides.
    apply(&mut harness.state_mut().editor, Command::Playback(PlaybackCommand::Scrub(1.5)));
    key(&mut harness, "n");
    assert!(!tells(&mut harness, 2) && !tells(&mut harness, 3));
}
