//! Traversal of the elements of an XML document.

use quick_xml::Reader;
use quick_xml::escape::resolve_predefined_entity;
use quick_xml::events::Event;

use super::{FORMAT, MAIN};
use crate::error::Result;

/// Maximum depth of nested elements.
const DEEPEST: usize = 16;

/// Calls `visit` with the path and the trimmed text of each element when it ends. A path consists of names without
/// prefixes and starts at the child of the root, as in `Record1/Axes/CX/TangentialIncrement`.
pub(super) fn elements(xml: &[u8], mut visit: impl FnMut(&str, &str) -> Result<()>) -> Result<()> {
    let broken = |problem: String| FORMAT.in_entry(MAIN, problem);
    let xml = std::str::from_utf8(xml)
        .map_err(|error| broken(format!("the text is not UTF-8: {error}")))?;
    let mut reader = Reader::from_str(xml);
    reader.config_mut().expand_empty_elements = true;
    // The path contains the names of the open elements below the root, each after a slash. `starts` contains the
    // positions of the names.
    let (mut path, mut starts) = (String::new(), Vec::new());
    let mut text = String::new();
    loop {
        let event = reader.read_event();
        match event.map_err(|error| broken(error.to_string()))? {
            Event::Start(element) => {
                if starts.len() == DEEPEST {
                    return Err(broken(format!(
                        "the elements are nested more than {DEEPEST} levels deep"
                    )));
                }
                let is_root = starts.is_empty();
                starts.push(path.len());
                // The name of the root is arbitrary and can be as long as the file, so it is not stored.
                if !is_root {
                    path.push('/');
                    path.push_str(&String::from_utf8_lossy(element.local_name().as_ref()));
                }
                text.clear();
            }
            Event::Text(content) => {
                text.push_str(
                    &content
                        .decode()
                        .map_err(|error| broken(error.to_string()))?,
                );
            }
            Event::CData(content) => {
                text.push_str(
                    &content
                        .decode()
                        .map_err(|error| broken(error.to_string()))?,
                );
            }
            // A reference that does not represent a character is kept verbatim. It is neither a number nor a name, so
            // later parsing rejects it.
            Event::GeneralRef(reference) => {
                let name = reference
                    .decode()
                    .map_err(|error| broken(error.to_string()))?;
                let resolved = reference
                    .resolve_char_ref()
                    .map_err(|error| broken(error.to_string()))?;
                match (resolved, resolve_predefined_entity(&name)) {
                    (Some(character), _) => text.push(character),
                    (None, Some(predefined)) => text.push_str(predefined),
                    (None, None) => text.extend(["&", &*name, ";"]),
                }
            }
            Event::End(_) => {
                visit(path.get(1..).unwrap_or_default(), text.trim())?;
                path.truncate(starts.pop().unwrap_or(0));
                text.clear();
            }
            Event::Eof if starts.is_empty() => return Ok(()),
            Event::Eof => return Err(broken("the document ends within an element".into())),
            _ => {}
        }
    }
}
