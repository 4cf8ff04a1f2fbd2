//! What a Python text looks like.

/// Whether a text that does not begin with a blank is Python, by its first line that is no comment.
pub(in crate::text_layouts) fn is_python(text: &[u8]) -> bool {
    let mut text = text;
    while text.starts_with(b"#") {
        let of_c = [b"#include".as_slice(), b"#define", b"#pragma", b"#if", b"#version"];
        if of_c.iter().any(|word| text.starts_with(word)) {
            return false;
        }
        let line = text.iter().position(|&byte| byte == b'\n').unwrap_or(text.len());
        text = text[line..].trim_ascii_start();
    }
    if let Some(inside) = text.strip_prefix(b"{") {
        let number = inside.trim_ascii_start();
        let digits =
            number.iter().take_while(|byte| matches!(byte, b'0'..=b'9' | b'+' | b'-' | b'.' | b'e' | b'E')).count();
        return digits > 0 && number[digits..].trim_ascii_start().starts_with(b":");
    }
    let without_prefix = text.strip_prefix(b"r").unwrap_or(text);
    if without_prefix.starts_with(b"\"\"\"") || without_prefix.starts_with(b"'''") {
        return true;
    }
    if let Some(decorated) = text.strip_prefix(b"@") {
        return name_length(decorated) > 0;
    }
    let length = name_length(text);
    let (word, after) = text.split_at(length);
    let rest = after.trim_ascii_start();
    let is_name_then = |ends: &[u8]| {
        let name = name_length(rest);
        name > 0 && rest[name..].trim_ascii_start().first().is_some_and(|byte| ends.contains(byte))
    };
    match word {
        b"" => false,
        b"import" | b"from" => true,
        b"class" => is_name_then(b"(:"),
        b"def" => is_name_then(b"("),
        b"async" => rest.starts_with(b"def"),
        b"try" => rest.starts_with(b":"),
        b"if" | b"for" | b"while" | b"with" => line_of(rest).trim_ascii_end().ends_with(b":"),
        // An assignment, also to several names or with a type, or a call.
        _ => is_call(after) || is_assigned(rest) || rest.strip_prefix(b":").is_some_and(is_typed),
    }
}

/// Whether the parentheses of a call follow, and not a labelled row of numbers, such as `Rbt(Cvec3(0, 0.25, 4)`.
fn is_call(after: &[u8]) -> bool {
    let Some(mut inside) = after.strip_prefix(b"(") else { return false };
    loop {
        let argument = inside.trim_ascii_start();
        let Some(deeper) = argument[name_length(argument)..].strip_prefix(b"(") else {
            return !argument.first().is_some_and(|byte| byte.is_ascii_digit() || matches!(byte, b'+' | b'-' | b'.'));
        };
        inside = deeper;
    }
}

/// Whether `= ` follows, after other names that are assigned too.
fn is_assigned(rest: &[u8]) -> bool {
    let mut rest = rest;
    while let Some(next) = rest.strip_prefix(b",") {
        let next = next.trim_ascii_start();
        let length = name_length(next);
        if length == 0 {
            return false;
        }
        rest = next[length..].trim_ascii_start();
    }
    rest.starts_with(b"=") && !rest.starts_with(b"==")
}

/// Whether a type follows, and then `=`.
fn is_typed(rest: &[u8]) -> bool {
    let rest = rest.trim_ascii_start();
    let length = name_length(rest);
    length > 0 && is_assigned(rest[length..].trim_ascii_start())
}

/// The length of a name, with dots, that a text begins with; 0 if it does not.
fn name_length(text: &[u8]) -> usize {
    let is_of_name = |byte: &u8| byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'.') || !byte.is_ascii();
    let length = text.iter().take_while(|byte| is_of_name(byte)).count();
    if text.first().is_some_and(|byte| byte.is_ascii_digit() || *byte == b'.') { 0 } else { length }
}

fn line_of(text: &[u8]) -> &[u8] {
    text.split(|&byte| byte == b'\n').next().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::is_python;

    #[test]
    fn the_first_line_tells_python() {
        for text in [
            "{0: 1}",
            "{ -1.5 : 1}",
            "import glfw",
            "from math import pi",
            "#!/usr/bin/env python3\n\"\"\"A viewer.\"\"\"\n",
            "'''A viewer.'''",
            "# mine\n\nclass Bird(Node):\n",
            "class Bird:\n",
            "@dataclass\nclass A:\n",
            "def main():\n",
            "if __name__ == '__main__':\n    main()\n",
            "translate_keys = {}",
            "self.keys={}",
            "a, b = 1, 2",
            "keys: dict = {}",
            "print('a')",
            "glfw.init()",
            "날개 = {0: 1}",
            "KeyFrameControlNode({0: vec(0, 0, 0)})",
        ] {
            assert!(is_python(text.as_bytes()), "{text}");
        }
        for text in [
            "",
            "0 1 2",
            "# a note\n0 1 2",
            "{\"format\": 1}",
            "{}",
            "frame [0]\n",
            "frame_num,rbt_ind,tx",
            "end",
            "key n\nkey >\n",
            "#include <map>\nclass A(",
            "class Foo {",
            "using namespace std;",
            "int main() {",
            "hello",
            "a == b",
            "Note: this is no = sign",
            "a, 1 = 2",
            ".5 = 1",
            "if it works:then",
            "Rbt(Cvec3(0, 0.25, 4), Quat(1, 0, 0, 0))",
            "vec3( -1, 0, 0)",
        ] {
            assert!(!is_python(text.as_bytes()), "{text}");
        }
    }
}
