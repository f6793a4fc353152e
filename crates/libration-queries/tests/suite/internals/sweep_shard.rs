//! Shards of a sweep.

use libration_queries::internals::sweep_shard::{Shard, shard};

#[test]
fn shards_share_all_chunks() {
    for (of, all) in [(1, 7), (3, 7), (9, 7), (7, 7)] {
        let mut chunks: Vec<usize> = (1..=of).flat_map(|number| Shard { of, number }.chunks(all)).collect();
        chunks.sort_unstable();
        assert_eq!(chunks, (0..all).collect::<Vec<_>>());
    }
}

#[test]
fn shards_are_read_as_they_are_written() {
    let third = Shard { of: 64, number: 3 };
    assert_eq!((shard("3/64"), Shard::of_note(&third.note())), (Ok(third), Some(third)));
    for text in ["3", "0/4", "5/4", "a/4", "1/0", "-1/4", ""] {
        assert!(shard(text).is_err(), "{text}");
    }
}
