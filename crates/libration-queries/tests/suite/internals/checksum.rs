//! Checksums of rows.

use libration_queries::internals::checksum::Checksum;

#[test]
fn published_checksums_come_out() {
    // RFC 9923, appendix C.
    for (text, sum) in [("", 0xcbf29ce484222325), ("a", 0xaf63dc4c8601ec8c), ("foobar", 0x85944171f73967e8)] {
        let mut checksum = Checksum::NONE;
        text.bytes().for_each(|byte| checksum.include(&[byte]));
        assert_eq!(checksum.value(), sum, "{text}");
    }
}
