//! Reading a table of students: its text, its cells, its columns.

use std::borrow::Cow;

use encoding_rs::{EUC_KR, WINDOWS_1252};

use crate::grading::person::Person;
use crate::text::{str_without_byte_order_mark, without_byte_order_mark};
use crate::words::texts;

/// The text of a table: UTF-8, or as Korean or Western spreadsheets save it.
pub fn decoded(bytes: &[u8]) -> String {
    let bytes = without_byte_order_mark(bytes);
    if let Ok(text) = std::str::from_utf8(bytes) {
        return text.to_owned();
    }
    let korean = EUC_KR.decode_without_bom_handling_and_without_replacement(bytes);
    korean.map_or_else(|| WINDOWS_1252.decode_without_bom_handling(bytes).0.into_owned(), Cow::into_owned)
}

/// The students of a table.
///
/// # Errors
/// A quotation mark that is not closed, or a header without names and numbers: a sentence.
pub fn people(text: &str) -> Result<Vec<Person>, String> {
    let text = str_without_byte_order_mark(text);
    let first = text.lines().find(|line| !line.trim().is_empty()).unwrap_or_default();
    let separator = [',', ';', '\t'].into_iter().max_by_key(|sign| (first.matches(*sign).count(), *sign == ','));
    let rows = rows(text, separator.unwrap_or(','))?;
    let mut rows = rows.into_iter().filter(|row| row.iter().any(|cell| !cell.trim().is_empty()));
    let header = rows.next().unwrap_or_default();
    let is_canvas = header.iter().any(|name| known(name, false) == Some(Column::SisUser));
    let columns: Vec<Option<Column>> = header.iter().map(|name| known(name, is_canvas)).collect();
    if columns.iter().flatten().all(|column| *column == Column::Section) {
        return Err(texts::grade_roster_header(header.join(", ")).to_string());
    }
    let people = rows.map(|row| {
        let mut person = Person::default();
        let (mut first, mut last) = (String::new(), String::new());
        for (cell, column) in row.iter().zip(&columns) {
            let cell = cell.trim().to_owned();
            match column {
                Some(Column::Name) => person.name = cell,
                Some(Column::First) => first = cell,
                Some(Column::Last) => last = cell,
                Some(Column::Canvas) => person.canvas_id = cell,
                Some(Column::SisUser) => person.sis_user_id = cell,
                Some(Column::SisLogin) => person.sis_login_id = cell,
                Some(Column::Participant) => {
                    let digits = cell.trim_start_matches(|c: char| !c.is_ascii_digit());
                    digits.clone_into(&mut person.participant);
                }
                Some(Column::Number) => person.id_number = cell,
                Some(Column::Email) => person.email = cell,
                Some(Column::Section) => person.section = cell,
                None => {}
            }
        }
        if person.name.is_empty() {
            format!("{first} {last}").trim().clone_into(&mut person.name);
        }
        person
    });
    // Rows of Canvas's gradebook that are no students'.
    let is_student = |person: &Person| {
        let is_of_canvas = is_canvas && (person.name == "Points Possible" || person.name == "Student, Test");
        !is_of_canvas && (!person.name.is_empty() || person.ids().next().is_some())
    };
    Ok(people.filter(is_student).collect())
}

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Column {
    Name,
    First,
    Last,
    Canvas,
    SisUser,
    SisLogin,
    Participant,
    Number,
    Email,
    Section,
}

/// What the column of a name holds. `ID` is Canvas's number in its own tables, and elsewhere the school's.
fn known(name: &str, is_canvas: bool) -> Option<Column> {
    Some(match name.trim().to_lowercase().as_str() {
        "student" | "name" | "full name" | "student name" | "이름" | "성명" => Column::Name,
        "first name" | "given name" => Column::First,
        "last name" | "surname" | "family name" => Column::Last,
        "id" if is_canvas => Column::Canvas,
        "sis user id" => Column::SisUser,
        "sis login id" | "login" | "username" => Column::SisLogin,
        "identifier" => Column::Participant,
        "id" | "id number" | "student id" | "sid" | "number" | "학번" => Column::Number,
        "email" | "email address" | "e-mail" | "이메일" => Column::Email,
        "section" | "sections" | "group" | "groups" | "분반" => Column::Section,
        _ => return None,
    })
}

/// The cells of a table. A cell that begins with a quotation mark ends with one; two in it are one.
fn rows(text: &str, separator: char) -> Result<Vec<Vec<String>>, String> {
    let mut rows = vec![vec![String::new()]];
    let mut opened_in: Option<usize> = None;
    let mut line = 1;
    let mut signs = text.chars().peekable();
    while let Some(sign) = signs.next() {
        line += usize::from(sign == '\n');
        let row = rows.last_mut().expect("there is one");
        let cell = row.last_mut().expect("there is one");
        match sign {
            '"' if opened_in.is_some() && signs.next_if_eq(&'"').is_some() => cell.push('"'),
            '"' if opened_in.is_some() => opened_in = None,
            '"' if cell.trim().is_empty() => {
                cell.clear();
                opened_in = Some(line);
            }
            _ if opened_in.is_some() => cell.push(sign),
            '\n' => rows.push(vec![String::new()]),
            '\r' => {}
            _ if sign == separator => row.push(String::new()),
            _ => cell.push(sign),
        }
    }
    match opened_in {
        Some(line) => Err(texts::grade_roster_quote(line).to_string()),
        None => Ok(rows),
    }
}
