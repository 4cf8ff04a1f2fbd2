use std::io::Cursor;

use serde_json::{Value, json};

use crate::sandbox::{Outcome, Sandbox, keyframe_file};

#[track_caller]
fn done(outcome: &Outcome) {
    assert_eq!((outcome.status, outcome.stdout.as_str()), (0, ""), "{}", outcome.stderr);
}

fn bytes(sandbox: &Sandbox, name: &str) -> Vec<u8> {
    std::fs::read(sandbox.path(name)).unwrap()
}

/// Five keyframes of half a second, in which a head moves.
fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new();
    let mut file = keyframe_file(5);
    file["ms_between_keyframes"] = json!(500);
    sandbox.write("a.json", file.to_string());
    sandbox
}

fn render(sandbox: &Sandbox, arguments: &[&str]) -> Outcome {
    sandbox.run(&[&["render", "--size", "64x48"], arguments].concat())
}

/// A GIF's whole pictures, with their times in hundredths of a second.
fn gif(bytes: &[u8]) -> Vec<(image::RgbaImage, u32)> {
    use image::AnimationDecoder as _;
    let decoder = image::codecs::gif::GifDecoder::new(Cursor::new(bytes)).unwrap();
    let frames = decoder.into_frames().collect_frames().unwrap();
    let hundredths = |delay: image::Delay| delay.numer_denom_ms().0 / delay.numer_denom_ms().1 / 10;
    frames.into_iter().map(|frame| (frame.buffer().clone(), hundredths(frame.delay()))).collect()
}

#[test]
fn a_gif_is_the_playing_range_and_the_same_bytes_each_time() {
    let sandbox = sandbox();
    done(&render(&sandbox, &["a.json", "-o", "a.gif"]));
    done(&render(&sandbox, &["a.json", "-o", "b.gif", "--fps", "25"]));
    assert_eq!(bytes(&sandbox, "a.gif"), bytes(&sandbox, "b.gif"));
    let frames = gif(&bytes(&sandbox, "a.gif"));
    assert_eq!(frames.len(), 26);
    assert!(frames.iter().all(|(picture, delay)| picture.dimensions() == (64, 48) && *delay == 4));
    // As the PNG frames, but for the colours' number.
    done(&render(&sandbox, &["a.json", "-o", "frames/", "--fps", "25"]));
    for place in [0, 13, 25] {
        let name = format!("frames/frame-{place:05}.png");
        let drawn = image::load_from_memory(&bytes(&sandbox, &name)).unwrap().to_rgba8();
        let pairs = drawn.as_raw().iter().zip(frames[place].0.as_raw());
        let sum: u64 = pairs.map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
        assert!(sum < 6 * drawn.as_raw().len() as u64, "frame {place} differs by {sum} levels");
    }
    assert_eq!(sandbox.names(), ["a.gif", "a.json", "b.gif", "frames"]);
}

#[test]
fn an_apng_and_a_y4m_have_as_many_frames() {
    let sandbox = sandbox();
    done(&render(&sandbox, &["a.json", "-o", "a.apng", "--fps", "10"]));
    let reader = png::Decoder::new(Cursor::new(bytes(&sandbox, "a.apng"))).read_info().unwrap();
    assert_eq!(reader.info().animation_control.map(|control| control.num_frames), Some(11));
    done(&render(&sandbox, &["a.json", "-o", "a.y4m", "--fps", "10"]));
    let y4m = bytes(&sandbox, "a.y4m");
    let header = y4m.iter().position(|byte| *byte == b'\n').unwrap() + 1;
    assert!(y4m.starts_with(b"YUV4MPEG2 W64 H48 F10:1 "));
    assert_eq!(y4m.len(), header + 11 * (6 + 64 * 48 * 3 / 2));
}

#[test]
fn a_part_of_the_range() {
    let sandbox = sandbox();
    done(&render(&sandbox, &["a.json", "-o", "part/", "--fps", "10", "--from", "0.5", "--to", "1.5"]));
    done(&render(&sandbox, &["a.json", "-o", "start.png", "--at", "0.5"]));
    done(&render(&sandbox, &["a.json", "-o", "end.png", "--at", "1.5"]));
    assert_eq!(bytes(&sandbox, "part/frame-00000.png"), bytes(&sandbox, "start.png"));
    assert_eq!(bytes(&sandbox, "part/frame-00005.png"), bytes(&sandbox, "end.png"));
    assert!(!sandbox.path("part/frame-00006.png").exists());
    let outcome = render(&sandbox, &["a.json", "-o", "x.gif", "--to", "2.5"]);
    assert_eq!((outcome.status, outcome.stderr.trim_end()), (1, "a.json: key time 2.5 is outside 0 to 2"));
    render(&sandbox, &["a.json", "-o", "x.gif", "--from", "1", "--to", "0.5"]).misuses();
    assert!(!sandbox.path("x.gif").exists());
}

#[test]
fn scenes_that_move_by_themselves_and_the_turntable() {
    let sandbox = sandbox();
    let frames = |name: &str| gif(&bytes(&sandbox, name));
    done(&render(&sandbox, &["--scene", "cylinder", "-o", "own.gif", "--fps", "5"]));
    assert!(frames("own.gif").windows(2).any(|pair| pair[0].0 != pair[1].0));
    done(&render(&sandbox, &["-o", "round.gif", "--fps", "5", "--camera", "turntable"]));
    assert_eq!(frames("round.gif").len(), 20);
    let outcome = render(&sandbox, &["-o", "still.gif"]);
    assert_eq!(
        (outcome.status, outcome.stderr.trim_end()),
        (1, "scene \"two-robots\": nothing moves: name a keyframe file, or --camera turntable")
    );
    assert!(!sandbox.path("still.gif").exists());
}

#[test]
fn a_contact_sheet_is_one_image() {
    let sandbox = sandbox();
    done(&render(&sandbox, &["a.json", "-o", "sheet.png", "--sheet", "3x2"]));
    done(&render(&sandbox, &["a.json", "-o", "first.png"]));
    done(&render(&sandbox, &["a.json", "-o", "last.png", "--at", "2"]));
    let open = |name: &str| image::open(sandbox.path(name)).unwrap().to_rgb8();
    let sheet = open("sheet.png");
    // Under each picture stands its caption, eleven pixels high.
    assert_eq!(sheet.dimensions(), (3 * 68 + 4, 2 * 63 + 4));
    let crop = |column: u32, top: u32, height: u32| {
        image::imageops::crop_imm(&sheet, 4 + 68 * column, top, 64, height).to_image()
    };
    assert_eq!(crop(0, 4, 48), open("first.png"));
    assert_eq!(crop(2, 67, 48), open("last.png"));
    let captions: Vec<_> = (0..6).map(|place| crop(place % 3, 52 + 63 * (place / 3), 11)).collect();
    for (place, caption) in captions.iter().enumerate() {
        assert!(caption.pixels().any(|pixel| pixel.0 == [0xd7, 0xda, 0xe0]), "{place}");
        assert!(!captions[..place].contains(caption), "{place}");
    }
    // Where the time does not fit beside the key time, it is left out; wider pictures have both, in larger letters.
    done(&sandbox.run(&["render", "a.json", "-o", "wide.png", "--sheet", "1x2", "--size", "240x48"]));
    assert_eq!(open("wide.png").dimensions(), (248, 2 * 74 + 4));
    done(&render(&sandbox, &["a.json", "-o", "again.png", "--sheet", "3x2"]));
    assert_eq!(bytes(&sandbox, "sheet.png"), bytes(&sandbox, "again.png"));
}

#[test]
fn cameras_backgrounds_and_ghosts_change_the_picture() {
    let sandbox = sandbox();
    let arguments: [&[&str]; 7] = [
        &[],
        &["--camera", "robot1"],
        &["--camera", "turntable"],
        &["--background", "#ff0000"],
        &["--background", "transparent"],
        &["--ghosts", "1"],
        &["--id"],
    ];
    let pictures = arguments.map(|more| {
        done(&render(&sandbox, &[&["a.json", "--at", "0.5", "-o", "x.png"], more].concat()));
        bytes(&sandbox, "x.png")
    });
    for (place, picture) in pictures.iter().enumerate() {
        assert!(!pictures[..place].contains(picture), "{:?}", arguments[place]);
    }
    let pixel = |place: usize| image::load_from_memory(&pictures[place]).unwrap().to_rgba8().get_pixel(32, 2).0;
    assert_eq!(pixel(3), [255, 0, 0, 255]);
    assert_eq!(pixel(4), [0, 0, 0, 0]);
    let outcome = render(&sandbox, &["-o", "y.png", "--camera", "ground"]);
    assert_eq!(outcome.status, 1);
    assert!(outcome.stderr.contains("the scene's eyes are sky, robot1, robot2; or: turntable"), "{}", outcome.stderr);
}

#[test]
fn an_identity_picture_is_made_of_nodes() {
    let sandbox = sandbox();
    done(&render(&sandbox, &["-o", "id.png", "--id"]));
    let picture = image::open(sandbox.path("id.png")).unwrap();
    assert_eq!(picture.color(), image::ColorType::L16);
    let picture = picture.to_luma16();
    let scene = inbetween::scene::built_in_scene("two-robots").unwrap();
    let count = u16::try_from(scene.nodes().len()).unwrap();
    assert!(picture.pixels().all(|pixel| pixel[0] <= count));
    assert_eq!(picture.get_pixel(32, 2)[0], 0);
    let path = |x: u32, y: u32| &scene.nodes()[usize::from(picture.get_pixel(x, y)[0]) - 1].path;
    assert!(path(32, 46).starts_with("ground/"), "{}", path(32, 46));
    assert!(path(11, 10).starts_with("robot1/"), "{}", path(11, 10));
    assert!(path(53, 10).starts_with("robot2/"), "{}", path(53, 10));
}

#[test]
fn a_manifest_names_the_adapter_and_each_files_hash() {
    let sandbox = sandbox();
    done(&render(&sandbox, &["a.json", "-o", "x.png", "--manifest", "one.json"]));
    done(&render(&sandbox, &["a.json", "-o", "frames", "--fps", "2", "--manifest", "many.json"]));
    let one = sandbox.json("one.json");
    assert!(one["adapter"]["name"].as_str().is_some_and(|name| !name.is_empty()));
    assert!(one["files"][0]["sha256"].as_str().is_some_and(|hash| hash.len() == 64));
    let many = sandbox.json("many.json");
    assert_eq!(many["files"].as_array().map(Vec::len), Some(3));
    assert_eq!(many["files"][0]["sha256"], one["files"][0]["sha256"]);
    assert_ne!(many["files"][0]["sha256"], many["files"][1]["sha256"]);
    assert_eq!(one["version"], Value::from(1));
}

#[test]
fn films_that_cannot_be_are_wrong_usage() {
    let sandbox = sandbox();
    for arguments in [
        &["a.json", "-o", "x.gif", "--fps", "60"][..],
        &["a.json", "-o", "x.gif", "--at", "0"],
        &["a.json", "-o", "x.gif", "--id"],
        &["a.json", "-o", "x.webm"],
        &["a.json", "-o", "x.png", "--from", "0"],
        &["a.json", "-o", "x.y4m", "--background", "transparent"],
        &["a.json", "-o", "x.png", "--background", "red"],
        &["a.json", "-o", "x.png", "--sheet", "0x3"],
        &["a.json", "-o", "x.mp4", "--size", "65x48"],
    ] {
        println!("{arguments:?}");
        sandbox.run(&[&["render"], arguments].concat()).misuses();
    }
    assert_eq!(sandbox.names(), ["a.json"]);
}

#[cfg(unix)]
mod with_a_made_ffmpeg {
    use std::os::unix::fs::PermissionsExt as _;

    use super::*;

    /// Runs `render` with a folder of programs alone on the PATH.
    fn render_with(sandbox: &Sandbox, ffmpeg: Option<&str>) -> Outcome {
        std::fs::create_dir_all(sandbox.path("bin")).unwrap();
        if let Some(script) = ffmpeg {
            sandbox.write("bin/ffmpeg", script);
            std::fs::set_permissions(sandbox.path("bin/ffmpeg"), std::fs::Permissions::from_mode(0o755)).unwrap();
        }
        run_with(sandbox, &["render", "a.json", "--size", "64x48", "--fps", "10", "-o", "x.mp4"])
    }

    fn run_with(sandbox: &Sandbox, arguments: &[&str]) -> Outcome {
        let mut command = sandbox.command(arguments);
        command.env("PATH", sandbox.path("bin"));
        Sandbox::outcome(command)
    }

    #[test]
    fn without_ffmpeg_an_mp4_is_refused_with_what_to_do() {
        let sandbox = sandbox();
        let outcome = render_with(&sandbox, None);
        assert_eq!((outcome.status, outcome.stdout.as_str()), (1, ""));
        assert!(outcome.stderr.contains("install ffmpeg"), "{}", outcome.stderr);
        assert_eq!(sandbox.names(), ["a.json", "bin"]);
    }

    #[test]
    fn ffmpeg_gets_the_frames_and_its_output_takes_the_films_place() {
        let sandbox = sandbox();
        let script = "#!/bin/sh\n[ \"$1\" = -version ] && exit 0\necho \"$@\" > \"${0%/*}/arguments\"\nfor last; do :; done\n\
                      exec /bin/cat > \"$last\"\n";
        done(&render_with(&sandbox, Some(script)));
        done(&render(&sandbox, &["a.json", "-o", "x.y4m", "--fps", "10"]));
        // The same stream, in the matrix that ffmpeg is told of.
        let [stream, file] = ["x.mp4", "x.y4m"].map(|name| bytes(&sandbox, name));
        assert!(stream.len() == file.len() && stream != file && stream[..20] == file[..20]);
        let arguments = String::from_utf8(bytes(&sandbox, "bin/arguments")).unwrap();
        for told in [
            "-vf setparams=range=tv:color_primaries=bt709:color_trc=bt709:colorspace=bt709",
            "-colorspace bt709 -color_primaries bt709 -color_trc bt709 -color_range tv",
        ] {
            assert!(arguments.contains(told), "{arguments}");
        }
        done(&render(&sandbox, &["a.json", "-o", "frames", "--fps", "10"]));
        done(&run_with(&sandbox, &["join", "frames", "--fps", "10", "-o", "joined.mp4"]));
        assert_eq!(bytes(&sandbox, "joined.mp4"), bytes(&sandbox, "x.mp4"));
        assert_eq!(sandbox.names(), ["a.json", "bin", "frames", "joined.mp4", "x.mp4", "x.y4m"]);
        // A stream cannot be gone back in, as ffmpeg does: it gets the whole film at the end.
        let script = format!("{script}[ -f \"$last\" ] || exit 9\n").replace("exec /bin/cat", "/bin/cat");
        sandbox.write("bin/ffmpeg", script);
        for arguments in [
            &["render", "a.json", "--size", "64x48", "--fps", "10", "-o", "-", "--format", "mp4"][..],
            &["join", "frames", "--fps", "10", "-o", "-", "--format", "mp4"],
        ] {
            let mut command = sandbox.command(arguments);
            command.env("PATH", sandbox.path("bin")).env("TMPDIR", sandbox.path("temporary"));
            std::fs::create_dir_all(sandbox.path("temporary")).unwrap();
            let output = command.output().unwrap();
            assert!(output.status.success() && output.stdout == bytes(&sandbox, "x.mp4"), "{output:?}");
            assert_eq!(std::fs::read_dir(sandbox.path("temporary")).unwrap().count(), 0);
        }
    }

    #[test]
    fn a_failing_ffmpeg_leaves_nothing() {
        let sandbox = sandbox();
        let outcome = render_with(&sandbox, Some("#!/bin/sh\n[ \"$1\" = -version ] && exit 0\nexit 7\n"));
        assert_eq!(outcome.status, 1);
        assert!(outcome.stderr.contains("x.mp4: ffmpeg ended with exit status: 7"), "{}", outcome.stderr);
        assert_eq!(sandbox.names(), ["a.json", "bin"]);
        for (end, said) in [
            (
                "echo first >&2; echo 'no such encoder' >&2; exit 1",
                "ended with exit status: 1; it said: no such encoder",
            ),
            ("kill -9 $$", "ended with signal: 9 (SIGKILL)"),
            ("exit 0", "ended before it had read all pictures"),
        ] {
            let script = format!("#!/bin/sh\n[ \"$1\" = -version ] && exit 0\n{end}\n");
            let outcome = render_with(&sandbox, Some(&script));
            assert_eq!((outcome.status, outcome.stderr), (1, format!("x.mp4: ffmpeg {said}\n")));
            assert_eq!(sandbox.names(), ["a.json", "bin"]);
        }
    }
}

#[cfg(unix)]
#[test]
fn ctrl_c_leaves_a_clean_file_or_none() {
    use std::time::Duration;
    let sandbox = sandbox();
    sandbox.write("x.gif", "what stood there before");
    let arguments = ["render", "a.json", "--size", "640x480", "--fps", "50", "-o", "x.gif"];
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_inbetween"))
        .current_dir(sandbox.path(""))
        .args(arguments)
        .stderr(std::process::Stdio::null())
        .spawn()
        .unwrap();
    // The file beside it is there as soon as the film is begun.
    while sandbox.names().len() < 3 {
        assert!(child.try_wait().unwrap().is_none(), "it ended before it was interrupted");
        std::thread::sleep(Duration::from_millis(2));
    }
    let pid = rustix::process::Pid::from_raw(child.id().cast_signed()).unwrap();
    rustix::process::kill_process(pid, rustix::process::Signal::INT).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert_eq!(sandbox.names(), ["a.json", "x.gif"]);
    assert_eq!(sandbox.read("x.gif"), "what stood there before");
}

/// The frames of a film or picture, opaque: a GIF's and an animated PNG's all, else one.
fn frames(name: &str, bytes: &[u8]) -> Vec<image::RgbImage> {
    use image::AnimationDecoder as _;
    let whole = |frames: image::Frames<'_>| -> Vec<image::RgbImage> {
        let frames = frames.collect_frames().unwrap();
        frames.into_iter().map(|frame| image::DynamicImage::from(frame.into_buffer()).to_rgb8()).collect()
    };
    let ending = name.rsplit('.').next();
    if ending == Some("gif") {
        whole(image::codecs::gif::GifDecoder::new(Cursor::new(bytes)).unwrap().into_frames())
    } else if ending == Some("apng") {
        let decoder = image::codecs::png::PngDecoder::new(Cursor::new(bytes)).unwrap();
        whole(decoder.apng().unwrap().into_frames())
    } else {
        vec![image::load_from_memory(bytes).unwrap().to_rgb8()]
    }
}

#[test]
fn the_manuals_films_are_made_by_the_commands_that_it_shows() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = std::fs::read_to_string(root.join("assets/manual/films.md")).unwrap();
    let sandbox = Sandbox::new();
    let commands: Vec<&str> = page.lines().filter(|line| line.contains(" -o assets/manual/pictures/")).collect();
    assert_eq!(commands.len(), 13);
    for command in commands {
        let words = command.strip_prefix("$ inbetween ").unwrap().split(' ');
        let mut name = "";
        let arguments: Vec<String> = words
            .map(|word| match word.strip_prefix("assets/manual/pictures/") {
                Some(output) => {
                    name = output;
                    output.to_owned()
                }
                None if word.starts_with("assets/") => root.join(word).to_str().unwrap().to_owned(),
                None => word.trim_matches('\'').to_owned(),
            })
            .collect();
        done(&sandbox.run(&arguments.iter().map(String::as_str).collect::<Vec<_>>()));
        assert!(page.contains(&format!("](pictures/{name})")), "{name} is not shown");
        let shown = frames(name, &std::fs::read(root.join("assets/manual/pictures").join(name)).unwrap());
        let made = frames(name, &bytes(&sandbox, name));
        assert_eq!(shown.len(), made.len(), "{name}");
        for (place, (shown, made)) in shown.iter().zip(&made).enumerate() {
            assert_eq!(shown.dimensions(), made.dimensions(), "{name}");
            // Another driver's edges and palette may differ a little.
            let pairs = shown.as_raw().iter().zip(made.as_raw());
            let sum: u64 = pairs.map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
            assert!(sum < 3 * shown.as_raw().len() as u64, "{name}: frame {place} differs by {sum} levels");
        }
    }
}

#[test]
fn a_webp_film_is_smaller_than_the_gif_and_has_its_frames() {
    use image::AnimationDecoder as _;
    let sandbox = sandbox();
    let large = |arguments: &[&str]| {
        sandbox.run(&[&["render", "a.json", "--size", "256x192", "--fps", "10"], arguments].concat())
    };
    for name in ["a.webp", "again.webp", "a.gif", "frames/"] {
        done(&large(&["-o", name]));
    }
    let film = bytes(&sandbox, "a.webp");
    assert_eq!(film, bytes(&sandbox, "again.webp"));
    let gif = bytes(&sandbox, "a.gif").len();
    assert!(film.len() < gif, "{} bytes of WebP, {gif} of GIF", film.len());
    // The same frames by the other ways.
    done(&sandbox.run(&["join", "frames", "--fps", "10", "-o", "joined.webp"]));
    assert_eq!(bytes(&sandbox, "joined.webp"), film);
    let printed = sandbox.command(&["join", "frames", "--fps", "10", "-o", "-", "--format", "webp"]).output().unwrap();
    assert_eq!(printed.stdout, film);
    let decoder = image::codecs::webp::WebPDecoder::new(Cursor::new(&film)).unwrap();
    let frames = decoder.into_frames().collect_frames().unwrap();
    // A picture that stays is one that lasts longer: the times say which is shown when.
    let mut ends = Vec::new();
    for frame in &frames {
        let (numerator, denominator) = frame.delay().numer_denom_ms();
        ends.push(ends.last().unwrap_or(&0) + numerator / denominator);
    }
    assert_eq!(ends.last(), Some(&1100));
    for place in [0, 5, 10] {
        let shown = ends.iter().position(|end| 100 * place < *end).unwrap();
        let name = format!("frames/frame-{place:05}.png");
        let drawn = image::load_from_memory(&bytes(&sandbox, &name)).unwrap().to_rgba8();
        let pairs = drawn.as_raw().iter().zip(frames[shown].buffer().as_raw());
        let sum: u64 = pairs.map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
        assert!(sum < 2 * drawn.as_raw().len() as u64, "frame {place} differs by {sum} levels");
    }
}

#[test]
fn a_webp_holds_a_picture_to_the_bit() {
    let sandbox = sandbox();
    let pixels = |name: &str| image::load_from_memory(&bytes(&sandbox, name)).unwrap().to_rgba8();
    for more in [&["--at", "0.5"][..], &["--background", "transparent"], &["--sheet", "2x1"]] {
        done(&render(&sandbox, &[&["a.json", "-o", "x.png"], more].concat()));
        done(&render(&sandbox, &[&["a.json", "-o", "x.webp"], more].concat()));
        done(&render(&sandbox, &[&["a.json", "-o", "again.webp"], more].concat()));
        assert!(bytes(&sandbox, "x.webp").starts_with(b"RIFF"));
        assert_eq!(bytes(&sandbox, "x.webp"), bytes(&sandbox, "again.webp"));
        assert_eq!(pixels("x.webp"), pixels("x.png"), "{more:?}");
    }
    done(&render(&sandbox, &["a.json", "-o", "frames/", "--frame-format", "webp", "--fps", "2"]));
    done(&render(&sandbox, &["a.json", "-o", "frames/", "--fps", "2"]));
    assert_eq!(pixels("frames/frame-00002.webp"), pixels("frames/frame-00002.png"));
    for arguments in [
        &["a.json", "-o", "x.webp", "--id"][..],
        &["a.json", "-o", "x.webp", "--fps", "10", "--at", "0.5"],
        &["a.json", "-o", "x.webp", "--fps", "91"],
        &["a.json", "-o", "x.webp", "--frame-format", "webp"],
        &["a.json", "-o", "x.gif", "--frame-format", "webp"],
    ] {
        render(&sandbox, arguments).misuses();
    }
}

#[test]
fn an_old_films_frames_are_named_and_not_left_behind_unseen() {
    let sandbox = Sandbox::new();
    sandbox.write("a.json", keyframe_file(4).to_string());
    let shorter = ["a.json", "-o", "frames/", "--fps", "1"];
    done(&render(&sandbox, &["a.json", "-o", "frames/", "--fps", "2"]));
    let names = || {
        let mut names: Vec<_> =
            std::fs::read_dir(sandbox.path("frames")).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        names.sort();
        names
    };
    std::fs::write(sandbox.path("frames/notes.txt"), "mine").unwrap();
    let before = names();
    let Outcome { status, stderr, .. } = render(&sandbox, &shorter);
    assert_eq!(status, 1, "{stderr}");
    assert!(
        stderr.contains("images of an earlier film are in the way, frame-00003.png to frame-00004.png"),
        "{stderr}"
    );
    assert_eq!(names(), before);
    done(&render(&sandbox, &[&shorter[..], &["--clean"]].concat()));
    assert_eq!(names(), ["frame-00000.png", "frame-00001.png", "frame-00002.png", "notes.txt"]);
    let twice = ["a.json", "-o", "x.png", "--manifest", "./x.png"];
    assert_eq!(render(&sandbox, &twice).status, 2);
    assert_eq!(render(&sandbox, &["a.json", "-o", "x.png", "--clean"]).status, 2);
}
