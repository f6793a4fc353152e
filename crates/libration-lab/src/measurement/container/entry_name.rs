//! The name of a file in a ZIP archive.

use rawzip::ZipFileHeaderRecord;
use rawzip::extra_fields::ExtraFieldId;

/// The upper half of the code page 437, in which names are encoded that are not in UTF-8.
const UPPER_HALF: &str = "ÇüéâäàåçêëèïîìÄÅÉæÆôöòûùÿÖÜ¢£¥₧ƒáíóúñÑªº¿⌐¬½¼¡«»░▒▓│┤╡╢╖╕╣║╗╝╜╛┐└┴┬├─┼╞╟╚╔╩╦╠═╬╧╨╤╥╙╘╒╓╫╪┘┌█▄▌▐▀αßΓπΣσµτΦΘΩδ∞φε∩≡±≥≤⌠⌡÷≈°∙·√ⁿ²■\u{a0}";

/// The name with its folders. A second name in Unicode takes precedence over one of a code page.
pub(super) fn entry_name(entry: &ZipFileHeaderRecord<'_>) -> String {
    let path = entry.file_path();
    let (fields, name) = (entry.extra_fields(), path.as_bytes());
    let unicode = fields.into_iter().find(|(id, _)| *id == ExtraFieldId::INFO_ZIP_UNICODE_PATH);
    match unicode.and_then(|(_, field)| unicode_path(field, name)) {
        Some(better) => better.to_owned(),
        None => std::str::from_utf8(name).map_or_else(|_| of_code_page(name), str::to_owned),
    }
}

/// The name in a field of version 1 that belongs to this other name, by its checksum.
fn unicode_path<'a>(field: &'a [u8], name: &[u8]) -> Option<&'a str> {
    let [1, checksum @ ..] = field else { return None };
    let (checksum, path) = checksum.split_first_chunk()?;
    let belongs = u32::from_le_bytes(*checksum) == rawzip::crc32(name);
    std::str::from_utf8(path).ok().filter(|_| belongs)
}

fn of_code_page(name: &[u8]) -> String {
    let letter = |byte: u8| match byte {
        0..0x80 => char::from(byte),
        _ => UPPER_HALF.chars().nth(usize::from(byte - 0x80)).unwrap_or(char::REPLACEMENT_CHARACTER),
    };
    name.iter().map(|&byte| letter(byte)).collect()
}
