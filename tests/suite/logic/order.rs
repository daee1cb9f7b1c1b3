//! Sorting: as the standard library does it.

use groundling::logic::order::sort_by_key;
use proptest::prelude::{any, prop, proptest};

proptest! {
    #[test]
    fn it_sorts_as_the_standard_library_does(
        items in prop::collection::vec((any::<u8>(), any::<u32>()), 0..200),
    ) {
        let (mut own, mut theirs) = (items.clone(), items);
        sort_by_key(&mut own, |item| item.0 % 16);
        theirs.sort_by_key(|item| item.0 % 16);
        assert_eq!(own, theirs);
    }
}
