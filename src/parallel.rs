//! A parallel map with results in the order of the items.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// Maps items on all cores. Results are in the order of the items.
///
/// Each thread takes the next item when it has finished one, so items may take different times. The calling thread works too, so a single
/// item starts no thread. A panic in `map` is passed on after all threads have ended.
pub fn map_in_order<T: Sync, R: Send>(items: &[T], map: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut done = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(item) = items.get(index) else { return done };
            done.push((index, map(item)));
        }
    };
    let threads = thread::available_parallelism().map_or(1, usize::from).min(items.len()).max(1);
    let mut done = thread::scope(|scope| {
        let helpers: Vec<_> = (1..threads).map(|_| scope.spawn(work)).collect();
        let mut done = work();
        for helper in helpers {
            done.extend(helper.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
        }
        done
    });
    done.sort_unstable_by_key(|&(index, _)| index);
    done.into_iter().map(|(_, result)| result).collect()
}

/// Does work that recurses on a thread with a stack of its own, of so many bytes. A panic is passed on.
pub fn with_stack<R: Send>(bytes: usize, work: impl FnOnce() -> R + Send) -> R {
    if cfg!(target_arch = "wasm32") {
        // A page has one thread, whose stack is large.
        return work();
    }
    thread::scope(|scope| {
        let worker = thread::Builder::new().stack_size(bytes).spawn_scoped(scope, work);
        worker.expect("the system has a thread left").join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })
}

#[cfg(test)]
mod tests {
    use super::map_in_order;

    #[test]
    fn results_are_in_order_whatever_takes_longer() {
        let items: Vec<u64> = (0..200).collect();
        // The first items take longest.
        let sums = map_in_order(&items, |&item| (0..(200 - item) * 500).fold(item, |sum, n| sum ^ n.wrapping_mul(n)));
        let expected: Vec<u64> =
            items.iter().map(|&item| (0..(200 - item) * 500).fold(item, |sum, n| sum ^ n.wrapping_mul(n))).collect();
        assert_eq!(sums, expected);
        assert_eq!(map_in_order(&[], |item: &u8| *item), [0_u8; 0]);
    }

    #[test]
    #[should_panic(expected = "the third")]
    fn panics_are_passed_on() {
        map_in_order(&[1, 2, 3, 4], |&item| assert!(item != 3, "the third"));
    }
}
