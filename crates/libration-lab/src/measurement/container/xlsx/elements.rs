//! A part of a workbook as a series of elements, with the prefixes of their names ignored.

use std::borrow::Cow;

use quick_xml::events::{BytesRef, BytesStart, Event};
use quick_xml::{Reader, XmlVersion, escape};

use super::super::super::MeasurementError;
use super::super::super::text::decode;
use super::super::part::ArchiveFile;
use super::damaged;

/// Next piece of a part.
pub(super) enum Piece<'a> {
    Start(Element<'a>),
    /// The end of an element of this name.
    End(String),
    Letters(Cow<'a, str>),
}

/// The beginning of an element, with its attributes.
pub(super) struct Element<'a>(BytesStart<'a>);

impl Element<'_> {
    pub(super) fn name(&self) -> &str {
        self.0.local_name().into_inner()
    }

    pub(super) fn attribute(&self, name: &str) -> Result<Option<String>, MeasurementError> {
        for attribute in self.0.attributes() {
            let attribute = attribute.map_err(|error| damaged(error.to_string()))?;
            if attribute.key.local_name().into_inner() == name {
                let value = attribute.normalized_value(XmlVersion::Implicit1_0);
                return Ok(Some(value.map_err(|error| damaged(error.to_string()))?.into_owned()));
            }
        }
        Ok(None)
    }

    /// An attribute that is a number, if it is one.
    pub(super) fn number(&self, name: &str) -> Result<Option<u16>, MeasurementError> {
        Ok(self.attribute(name)?.and_then(|value| value.trim().parse().ok()))
    }
}

/// Calls `each` with every piece of a part in order, until it has ended or `each` returns an end.
pub(super) fn walk(
    part: &ArchiveFile,
    mut each: impl FnMut(Piece<'_>) -> Result<Onward, MeasurementError>,
) -> Result<(), MeasurementError> {
    let (text, _) = decode(&part.bytes)?;
    let mut reader = Reader::from_str(&text);
    reader.config_mut().expand_empty_elements = true;
    let mut depth = 0_usize;
    loop {
        let piece = match reader.read_event().map_err(|error| damaged(error.to_string()))? {
            Event::Start(element) => {
                depth += 1;
                Piece::Start(Element(element))
            }
            Event::End(element) => {
                depth = depth.saturating_sub(1);
                Piece::End(element.local_name().into_inner().to_owned())
            }
            Event::Text(text) => Piece::Letters(text.xml10_content()),
            Event::CData(text) => Piece::Letters(text.xml10_content()),
            Event::GeneralRef(reference) => Piece::Letters(letter(&reference)?),
            Event::Eof if depth > 0 => return Err(damaged(format!("{} is cut off", part.name))),
            Event::Eof => return Ok(()),
            Event::Empty(_) | Event::Comment(_) | Event::Decl(_) | Event::PI(_) | Event::DocType(_) => {
                continue;
            }
        };
        if each(piece)? == Onward::Enough {
            return Ok(());
        }
    }
}

/// Decision to read more of a part or not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Onward {
    More,
    Enough,
}

/// Character for which `&amp;` or `&#181;` stands.
fn letter(reference: &BytesRef<'_>) -> Result<Cow<'static, str>, MeasurementError> {
    let number = reference.resolve_char_ref().map_err(|error| damaged(error.to_string()))?;
    if let Some(letter) = number {
        return Ok(letter.to_string().into());
    }
    let name = reference.xml10_content();
    let character = escape::resolve_predefined_entity(&name).map(Cow::Borrowed);
    character.ok_or_else(|| damaged(format!("`&{name};` in it is unknown")))
}
