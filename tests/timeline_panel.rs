//! The timeline, driven by pointer and keyboard with no window: each operation leaves the editor as its command would, and undo
//! returns the document to the same bytes.

mod common;

use common::{apply, editor_with, press, shown};
use egui::{
    CursorIcon, Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, Pos2, Role, TouchPhase, Vec2,
    pos2, vec2,
};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use inbetween::editor::{Command, Edit, Editor, PlayMode, PlaybackCommand, TimelineEdit, ViewCommand};
use inbetween::keyframe::{Easing, KeyframeIndex, keyframes_to_json};
use inbetween::ui::{Ui, theme};

struct App {
    editor: Editor,
    ui: Ui,
    commands: Vec<Command>,
    is_dressed: bool,
    cursor: CursorIcon,
}

type Timeline = Harness<'static, App>;

fn timeline(editor: Editor) -> Timeline {
    let app = App { editor, ui: Ui::new(), commands: Vec::new(), is_dressed: false, cursor: CursorIcon::Default };
    let mut harness = Harness::builder().with_size(vec2(1280.0, 800.0)).with_max_steps(60).build_ui_state(
        |ui, app: &mut App| {
            if !std::mem::replace(&mut app.is_dressed, true) {
                theme::install(ui.ctx());
            }
            for command in app.ui.show(ui, &app.editor).commands {
                apply(&mut app.editor, command.clone());
                app.commands.push(command);
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

/// Where a keyframe's diamond is.
fn at(harness: &Timeline, place: usize) -> Pos2 {
    harness.get_by_role_and_label(Role::ListBoxOption, &format!("Keyframe {place}")).rect().center()
}

fn ruler(harness: &Timeline, place: usize) -> Pos2 {
    at(harness, place) - vec2(0.0, 40.0)
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
    let handle = |harness: &Timeline, place| at(harness, place) - vec2(0.0, 14.0);
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
    apply(&mut harness.state_mut().editor, Command::View(ViewCommand::SelectKeyframes(indices(&[1, 2, 3]))));
    click(&mut harness, "Fit selection");
    assert_eq!([1, 3].map(|place| at(&harness, place).x.round()), FITTED);
    harness.hover_at(pointer);
    harness.run();
    harness.key_press(Key::F);
    harness.run();
    assert_eq!([0, 5].map(|place| at(&harness, place).x.round()), FITTED);
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
    assert_eq!(editor.session().chosen.map(|rbt| editor.scene().rbt_path(rbt)), Some("robot2"));
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
        ("Delete keyframes Delete", "0 1 [2] 4 5 | 2"),
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
        click(harness, "Easing: bounce, out");
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
        harness.key_press(Key::F2);
        harness.run();
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
    choose(&mut harness, 2, "Rename… F2");
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
            .map(|down| pos2(x, 660.0 + f32::from(down as u8) * 1.5))
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
