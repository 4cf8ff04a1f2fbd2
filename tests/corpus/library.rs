//! What only the window shows: sentences of settings and hotkeys, and the editor's where no script can lead to them.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use glam::Vec3;
use inbetween::editor::keymap::{Chord, Keymap, by_id};
use inbetween::editor::{
    Command, Edit, Editor, Eye, PlaybackCommand, SceneEdit, TimelineEdit, ViewCommand, WorkEye, Written,
};
use inbetween::film::ExportEnd;
use inbetween::flip::Scores;
use inbetween::keyframe::KeyframeIndex;
use inbetween::pose::RbtIndex;
use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
use inbetween::settings::Settings;
use inbetween::words::{Message, texts};

/// What a settings file gives: itself as the program writes it, or what is wrong with it.
pub fn settings(bytes: &[u8]) -> String {
    match Settings::from_json(bytes) {
        Ok(settings) => settings.to_json().lines().map(|line| format!("| {line}\n")).collect(),
        Err(error) => format!("> {error}\n"),
    }
}

/// Tells the editor how the writing of a file ended, and where the file's former content is kept.
type Effect = fn(&mut Editor, &Path, Result<Written, Message>);

/// What the editor says to commands that no script line can give, and of effects that only a window has.
pub fn editor() -> String {
    let scene = Arc::new(built_in_scene(DEFAULT_SCENE).expect("it is built in"));
    let mut editor = Editor::new(scene, PathBuf::from("animation.json"));
    let mut text = String::new();
    let robot = RbtIndex::new(2);
    let beyond = RbtIndex::new(99);
    let nan = Vec3::splat(f32::NAN);
    for _ in 0..4 {
        let _ = editor.apply(Command::Edit(Edit::CreateKeyframe));
    }
    let first = KeyframeIndex::new(0);
    let commands = [
        Command::View(ViewCommand::SetEye(Eye::Recorded(9))),
        Command::View(ViewCommand::SetWorkEye(WorkEye { distance: f32::NAN, ..WorkEye::default() })),
        Command::View(ViewCommand::Choose(Some(beyond))),
        Command::Edit(Edit::SetTranslation(beyond, Vec3::ZERO)),
        Command::Edit(Edit::SetTranslation(robot, nan)),
        Command::Edit(Edit::Timeline(TimelineEdit::SetTranslationInKeyframe(first, beyond, Vec3::ZERO))),
        Command::Edit(Edit::Timeline(TimelineEdit::SetTranslationInKeyframe(first, robot, nan))),
        Command::Edit(Edit::Timeline(TimelineEdit::SetDuration {
            keyframe: first,
            duration: f64::NAN,
            ripple_free: false,
        })),
        Command::Playback(PlaybackCommand::Scrub(f64::NAN)),
        Command::View(ViewCommand::ScrubSeconds(f64::INFINITY)),
        Command::Edit(Edit::Scene(SceneEdit::DeleteKeys(Vec::new()))),
        Command::Edit(Edit::Scene(SceneEdit::MoveKeys { keys: Vec::new(), by: 1.0 })),
        Command::Edit(Edit::Scene(SceneEdit::AddKeys(Vec::new()))),
    ];
    for command in commands {
        let shown = format!("{command:?}");
        let _ = editor.apply(command);
        let _ = writeln!(text, "{shown}\t{}", editor.message_text());
    }
    let path = Path::new("folder/walk.json");
    let kept = || Ok(Written { kept: Some(PathBuf::from("folder/walk.json~")), ..Written::default() });
    let linked = || Ok(Written { other_links: 2, ..Written::default() });
    let kept_meshes = || Ok(Written { kept_meshes: Some(PathBuf::from("folder/walk.glb~")), ..Written::default() });
    let failed = || texts::foreign("No space left on device");
    let effects: [(&str, Effect); 2] = [
        ("keyframes written", |editor, path, outcome| drop(editor.keyframes_written(path, outcome))),
        ("scene written", |editor, path, outcome| drop(editor.scene_written(path, outcome))),
    ];
    for (name, effect) in effects {
        for outcome in [Ok(Written::default()), kept(), linked(), kept_meshes(), Err(failed())] {
            effect(&mut editor, path, outcome);
            let _ = writeln!(text, "{name}\t{}", editor.message_text());
        }
    }
    for outcome in [Ok(()), Err(failed())] {
        let _ = editor.screenshot_taken(Path::new("folder/shot.png"), outcome);
        let _ = writeln!(text, "screenshot\t{}", editor.message_text());
    }
    let ends = [
        ExportEnd::Written(1),
        ExportEnd::Written(25),
        ExportEnd::Cancelled(0),
        ExportEnd::Cancelled(7),
        ExportEnd::Failed(texts::foreign("there is no ffmpeg")),
    ];
    for end in ends {
        let shown = match &end {
            ExportEnd::Failed(reason) => format!("Failed({:?})", reason.to_string()),
            end => format!("{end:?}"),
        };
        editor.exported(Path::new("folder/walk.gif"), end);
        let _ = writeln!(text, "{shown}\t{}", editor.message_text());
    }
    text
}

/// What is wrong with changes of hotkeys, and the sentences that name another key then.
pub fn keymap() -> String {
    let changes = [
        ("New keyframe", "y"),
        ("New keyframe", "Ctrl+K"),
        ("Arcball", "Hyper+q"),
        ("Fly", "f"),
        ("Cancel", "x"),
        ("Undo", ""),
    ];
    let mut text = String::new();
    for (name, chord) in changes {
        let chords: Vec<String> =
            Some(chord).filter(|chord| !chord.is_empty()).map(str::to_owned).into_iter().collect();
        let (keymap, errors) = Keymap::with_changes(&BTreeMap::from([(name.to_owned(), chords)]));
        let errors: Vec<String> = errors.iter().map(ToString::to_string).collect();
        let scene = Arc::new(built_in_scene(DEFAULT_SCENE).expect("it is built in"));
        let mut editor = Editor::new(scene, PathBuf::from("animation.json"));
        editor.set_keymap(keymap.clone());
        let _ = editor.apply(Command::Edit(Edit::DisplayCurrent));
        let _ = writeln!(text, "{name} {chord:?}\t{}\t{}", errors.join(" "), editor.message_text());
        if let Some(chord) = Chord::parse(chord) {
            let ids = by_id(&BTreeMap::from([(name.to_owned(), Vec::new())]));
            let set = ids.keys().find_map(|id| keymap.clone().set(id, vec![chord]).err());
            let _ = writeln!(
                text,
                "set {name} {}\t{}",
                chord.label(),
                set.map_or_else(String::new, |error| error.to_string())
            );
        }
    }
    text
}

/// The sentences that only the window says, and those of failures that a test cannot bring about on every machine.
#[expect(clippy::too_many_lines, reason = "it is a list")]
pub fn window_and_failures() -> String {
    let path = || "folder/walk.json";
    let reason = || texts::foreign("it broke");
    let times = [1_usize, 2]
        .map(|count| [texts::journal_minutes(count), texts::journal_hours(count), texts::journal_days(count)]);
    let messages = [
        texts::FILE_EXPORT_BEGUN_ALREADY.into(),
        texts::reach_ball("robot1/left_hip/left_knee"),
        texts::no_file_manager("/home/me/films"),
        texts::SHARE_NOT_EMPTY.into(),
        texts::SHARE_REPORT.into(),
        texts::share_written("page"),
        texts::page_other_site("https://example.org/walk.json"),
        texts::page_refused("walk.json", "404 Not Found"),
        texts::page_silent("walk.json"),
        texts::page_compare_alone("walk.json"),
        texts::file_model_not_written("walk.glb"),
        texts::gltf_buffers_too_large(1024),
        texts::count_joints(1_usize),
        texts::count_channels(1_usize),
        texts::gltf_note_weights_normalised("/meshes/0/primitives/0", 1_usize),
        texts::gltf_in_timed(2_usize),
        texts::HOTKEYS_RESET.into(),
        texts::hotkeys_removed("Play or stop"),
        texts::settings_not_understood(path(), reason()),
        texts::settings_copied(path()),
        texts::settings_not_kept(reason()),
        texts::SCENE_MESHES_APART.into(),
        texts::SCENE_MESHES_OUTSIDE.into(),
        texts::scene_moves_skin("\"arm\"", "\"arm/skin\""),
        texts::gltf_out_no_shapes(1_usize),
        texts::gltf_out_no_colours(1_usize, "robot/ball"),
        texts::gltf_too_many_triangles(5_000_000, 4_194_304),
        texts::gltf_too_many_joints(300, 256),
        texts::GLTF_FILE_ALONE.into(),
        texts::gltf_note_without_coordinates("/meshes/0/primitives/0"),
        texts::gltf_note_picture_large(9000, 10, 8192, 64),
        texts::gltf_note_pictures_large(1024),
        texts::GLTF_IN_NOT_FINITE.into(),
        texts::gltf_in_too_many_samples(900_000, 8000),
        texts::gltf_in_too_large(200, 128),
        texts::gltf_in_no_folder("data.bin"),
        texts::gltf_in_outside("data.bin"),
        texts::STORAGE_READ_ONLY.into(),
        texts::STORAGE_PERMISSION_DENIED.into(),
        texts::STORAGE_IN_USE.into(),
        texts::JOURNAL_NO_FILES.into(),
        texts::refused_squeezed_limb("robot/arm"),
        texts::refused_no_pole("robot/arm"),
        texts::POSES_NO_FOLDER.into(),
        texts::pose_file_twice(path()),
        texts::pose_file_turned(path(), 2.0),
        texts::pose_file_moved(path()),
        texts::pose_mirrored_but("body", texts::count_nodes(2)),
        texts::refused_no_other_side("\"fin\""),
        texts::JOURNAL_NO_PLACE.into(),
        texts::journal_not_kept(reason()),
        texts::JOURNAL_PANICKED.into(),
        texts::journal_offer(path(), texts::journal_count(1), texts::JOURNAL_NOW),
        texts::journal_offer(path(), texts::journal_count(2), texts::JOURNAL_NOW),
        texts::JOURNAL_RESTORE.into(),
        texts::JOURNAL_LATER.into(),
        texts::JOURNAL_DISCARD.into(),
        texts::journal_restored(path(), texts::journal_count(2)),
        texts::journal_restored_part(path(), texts::journal_count(2)),
        texts::journal_unreadable(reason()),
        texts::storage_stream_too_large(5),
        texts::refused_keyframes_too_large("1024"),
        texts::refused_scene_too_large("256"),
        texts::STORAGE_READ_TWICE.into(),
        // Shards are of the build that made them.
        texts::GRADE_SHARD_BROKEN.into(),
        texts::GRADE_SHARD_OTHER_PROGRAM.into(),
        texts::grade_shards_programs(path(), path()),
        texts::grade_shards_rubrics(path(), path()),
        texts::grade_shards_scenes(path(), path()),
        texts::grade_shards_images(path(), path()),
        texts::grade_shards_overrides(path(), path()),
        texts::DECODE_BAD_KEY.into(),
        texts::DECODE_NOT_JSON.into(),
        texts::PICTURE_DAMAGED.into(),
        texts::decode_no_fields("x"),
        texts::man_written(18, path()),
        texts::retarget_short(texts::count_frames(3)),
        texts::model_too_large(1024),
        texts::BVH_TURNED.into(),
        texts::DECODE_OTHER.into(),
        texts::decode_expected(texts::DECODE_KIND_OTHER),
        texts::timed_not_finite(f64::NAN),
        // A score depends on the driver that draws.
        Scores { score: 0.75, mean: 0.01, largest: 1.0 }.sentence(0.5),
        texts::EXPORT_TOO_MANY_FRAMES.into(),
        texts::EXPORT_FRAME_GONE.into(),
        texts::export_ffmpeg_lost("it broke"),
        texts::ended_by_signal("12"),
        texts::EXPORT_FFMPEG_EARLY.into(),
        texts::export_ffmpeg_hung("60"),
        texts::export_ffmpeg_said(reason(), "no such codec"),
        texts::gpu_no_threads("it broke"),
        texts::gpu_driver_hangs("18"),
        texts::gpu_adapter_hangs("Adapter", "18"),
        texts::gpu_loaded(reason(), "libvulkan.so.1"),
        texts::STORAGE_IN_THE_WAY.into(),
        texts::export_picture_not_encoded("it broke"),
        texts::EXPORT_INTERRUPTED.into(),
        texts::EXPORT_PROGRAM_FAILED.into(),
        texts::export_one_image(texts::foreign("PNG")),
        texts::film_too_large(70_000, 2),
        texts::film_size(1, 2, 3, 4),
        texts::film_not_encoded("it broke"),
        texts::gpu_no_device("Adapter", "it broke"),
        texts::gpu_no_surface(reason()),
        texts::GPU_CANNOT_DRAW_ON_SURFACE.into(),
        texts::gpu_not_read_back("Adapter", "it broke"),
        texts::SCREENSHOT_NO_WINDOW.into(),
        texts::refused_no_example("walk"),
        texts::readout_turn("+32.5", "z"),
        texts::readout_turn_in_view("45|"),
        texts::readout_move("+0.25", "x"),
        texts::readout_move_in_plane("+0.25", "x", "-0.10", "y"),
        texts::readout_move_in_view("+0.25", "-0.10"),
    ];
    messages.into_iter().chain(times.into_iter().flatten()).map(|message: Message| format!("{message}\n")).collect()
}
