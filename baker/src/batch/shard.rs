//! One part of a manifest, for job arrays.

use std::str::FromStr;

/// Part `number` of `count`, counted from one: `2/5`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    number: usize,
    count: usize,
}

impl Shard {
    /// Whether the item at this place of the whole list belongs to the part. The parts share the list out like cards:
    /// each item has one part, and two parts differ by one item at most.
    pub fn holds(self, index: usize) -> bool {
        index % self.count == self.number - 1
    }
}

impl FromStr for Shard {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let parts = text.split_once('/').and_then(|(number, count)| Some((number.parse().ok()?, count.parse().ok()?)));
        match parts {
            Some((number, count)) if (1..=count).contains(&number) => Ok(Self { number, count }),
            _ => Err("it must be I/N with I from 1 to N, such as 2/5"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_item_is_in_one_part() {
        let parts: Vec<Shard> = (1..=3).map(|number| format!("{number}/3").parse().expect("a part")).collect();
        for index in 0..10 {
            assert_eq!(parts.iter().filter(|part| part.holds(index)).count(), 1, "item {index}");
        }
    }

    #[test]
    fn parts_that_do_not_exist_are_refused() {
        for wrong in ["", "1", "0/3", "4/3", "1/0", "a/b", "-1/3"] {
            assert!(wrong.parse::<Shard>().is_err(), "{wrong}");
        }
    }
}
