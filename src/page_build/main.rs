//! `inbetween-page-build PROGRAM.wasm FOLDER`: writes the module and the scripts that load it into a folder.

use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [program, folder] = arguments.as_slice() else {
        eprintln!("two arguments are needed: the compiled program, and a folder");
        return ExitCode::from(2);
    };
    let mut bindgen = wasm_bindgen_cli_support::Bindgen::new();
    let made = bindgen
        .input_path(program)
        .out_name("inbetween")
        .web(true)
        .and_then(|bindgen| bindgen.typescript(false).generate(folder));
    match made {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{program}: {error:?}");
            ExitCode::FAILURE
        }
    }
}
