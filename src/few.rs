//! Handling a handful.

/// Sorts by what is before what; equals keep their order. The standard library's sort is made for many, and costs more than
/// a kilobyte of the module.
pub(crate) fn sort_few<T>(values: &mut [T], before: impl Fn(&T, &T) -> bool) {
    for end in 1..values.len() {
        for i in (0..end).rev() {
            if !before(&values[i + 1], &values[i]) {
                break;
            }
            values.swap(i, i + 1);
        }
    }
}

/// The values in an array of their own, and `rest` where it has room for more.
pub(crate) fn padded<const N: usize>(values: &[f64], rest: f64) -> [f64; N] {
    std::array::from_fn(|i| values.get(i).copied().unwrap_or(rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sorts_as_the_standard_library_does_and_keeps_the_order_of_equals() {
        // Digits of π, each with its place.
        let digits = [3, 1, 4, 1, 5, 9, 2, 6, 5, 3, 5, 8, 9, 7, 9, 3];
        let mut ours: Vec<(usize, i32)> = digits.into_iter().enumerate().collect();
        let mut theirs = ours.clone();
        sort_few(&mut ours, |a, b| a.1 > b.1);
        theirs.sort_by_key(|(_, digit)| -digit);
        assert_eq!(ours, theirs);
        sort_few::<f64>(&mut [], |_, _| unreachable!("there is nothing to compare"));
    }
}
