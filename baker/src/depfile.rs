//! Dependency files, as Make and Ninja read them: what an output was made from.

use std::path::{Path, PathBuf};
use thiserror::Error;

/// A path that the syntax of Make cannot express.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{} cannot stand in a dependency file: {problem}", path.display())]
pub struct PathError {
    /// The path.
    pub path: PathBuf,
    /// What is wrong with it.
    pub problem: &'static str,
}

/// One rule without a recipe: `output` depends on `inputs`, in their order.
///
/// # Errors
/// A path is not UTF-8, or holds a line break, which Make has no escape for.
pub fn rule(output: &Path, inputs: &[PathBuf]) -> Result<String, PathError> {
    let mut text = format!("{}:", escaped(output)?);
    for input in inputs {
        text += " \\\n  ";
        text += &escaped(input)?;
    }
    text.push('\n');
    Ok(text)
}

/// As GCC escapes: a backslash before blanks and `#`, backslashes doubled before those alone, `$` doubled.
fn escaped(path: &Path) -> Result<String, PathError> {
    let fail = |problem| PathError { path: path.to_owned(), problem };
    let text = path.to_str().ok_or_else(|| fail("it is not UTF-8"))?;
    if text.contains(['\n', '\r']) {
        return Err(fail("it holds a line break"));
    }

    let mut escaped = String::new();
    let mut backslashes = 0;
    for letter in text.chars() {
        match letter {
            ' ' | '\t' | '#' => {
                escaped.extend(std::iter::repeat_n('\\', backslashes + 1));
                escaped.push(letter);
            }
            '$' => escaped.push_str("$$"),
            _ => escaped.push(letter),
        }
        backslashes = if letter == '\\' { backslashes + 1 } else { 0 };
    }
    Ok(escaped)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_input_is_named_and_escaped() {
        let inputs = ["plain.obj", "two words.bin", "cost$.obj", "no#1.obj"].map(PathBuf::from);
        let rule = rule(Path::new("out/a b.nfd"), &inputs).expect("a rule");
        assert_eq!(rule, "out/a\\ b.nfd: \\\n  plain.obj \\\n  two\\ words.bin \\\n  cost$$.obj \\\n  no\\#1.obj\n");
    }

    #[test]
    fn backslashes_double_before_blanks_alone() {
        assert_eq!(escaped(Path::new("a\\b")).expect("text"), "a\\b");
        assert_eq!(escaped(Path::new("a\\ b")).expect("text"), "a\\\\\\ b");
    }

    #[test]
    fn a_line_break_is_refused() {
        assert!(rule(Path::new("field.nfd"), &[PathBuf::from("two\nlines.obj")]).is_err());
    }
}
