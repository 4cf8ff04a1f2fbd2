//! Numbers of frames as text: `0-59`, `60-119:2`, `0,7,12-14`.

/// The numbers that a text names, in its order. `None`: it is not written like this, or names more than `most`.
pub fn frame_numbers(text: &str, most: usize) -> Option<Vec<usize>> {
    let number = |text: &str| -> Option<usize> {
        text.bytes().all(|byte| byte.is_ascii_digit()).then(|| text.parse().ok()).flatten()
    };
    let mut numbers = Vec::new();
    for part in text.split(',').map(str::trim) {
        let (range, step) = match part.split_once(':') {
            Some((range, step)) if range.contains('-') => (range, number(step).filter(|&step| step > 0)?),
            Some(_) => return None,
            None => (part, 1),
        };
        let (first, last) = range.split_once('-').unwrap_or((range, range));
        let (first, last) = (number(first)?, number(last)?);
        if first > last || (last - first) / step >= most - numbers.len().min(most) {
            return None;
        }
        numbers.extend((first..=last).step_by(step));
    }
    Some(numbers)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_ranges() {
        let read = |text| frame_numbers(text, 10);
        assert_eq!(read("7"), Some(vec![7]));
        assert_eq!(read("0-4"), Some(vec![0, 1, 2, 3, 4]));
        assert_eq!(read("0-10:5, 3"), Some(vec![0, 5, 10, 3]));
        assert_eq!(read("0-9"), Some((0..10).collect()));
        for bad in [
            "",
            "-1",
            "3-1",
            "1-",
            "5:2",
            "0-4:0",
            "0-4:",
            "a",
            "1,,2",
            "+1",
            "0-10",
            "0-8,9-10",
            "0-99999999999999999999",
        ] {
            assert_eq!(read(bad), None, "{bad}");
        }
    }
}
