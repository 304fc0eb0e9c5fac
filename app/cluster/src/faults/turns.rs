//! In which order faults take their turns: the routes of all rows, by the numbers of their turns.
//!
//! Made of the table while compiling. Refuses to know what is active.

use super::table::Order::Turn;
use super::table::{ROWS, Route, Row};

/// A fault and one of the routes by which it is reported.
#[derive(Clone, Copy)]
pub(crate) struct Reporter {
    pub(crate) row: &'static Row,
    pub(crate) route: &'static Route,
}

/// Returns how many routes take turns.
const fn count_in_turn() -> usize {
    let (mut count, mut at) = (0, 0);
    while at < ROWS.len() {
        if let Turn(_) = ROWS[at].order {
            count += ROWS[at].routes.len();
        }
        at += 1;
    }
    count
}

/// Returns the row with the lowest turn above `turn`.
const fn row_after(turn: u16) -> Option<(&'static Row, u16)> {
    let (mut found, mut at): (Option<(&'static Row, u16)>, usize) = (None, 0);
    while at < ROWS.len() {
        if let Turn(its) = ROWS[at].order
            && its > turn
        {
            match found {
                Some((_, best)) if best < its => {}
                Some((_, best)) => {
                    assert!(best != its, "two faults have the same turn");
                    found = Some((&ROWS[at], its));
                }
                None => found = Some((&ROWS[at], its)),
            }
        }
        at += 1;
    }
    found
}

const fn in_turn() -> [Reporter; count_in_turn()] {
    let mut all = [Reporter { row: &ROWS[0], route: &ROWS[0].routes[0] }; count_in_turn()];
    let (mut place, mut turn) = (0, 0);
    while let Some((row, next)) = row_after(turn) {
        let mut at = 0;
        while at < row.routes.len() {
            all[place] = Reporter { row, route: &row.routes[at] };
            (place, at) = (place + 1, at + 1);
        }
        turn = next;
    }
    all
}

/// Every route of the faults that take turns, in their order.
pub(crate) static REPORTERS: [Reporter; count_in_turn()] = in_turn();
const _: () = assert!(count_in_turn() < u8::MAX as usize, "reporters are counted in a byte");

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_go_by_their_numbers_and_leave_out_what_takes_none() {
        let turn = |row: &Row| if let Turn(turn) = row.order { turn } else { 0 };
        let all = in_turn();
        assert!(all.is_sorted_by_key(|by| turn(by.row)) && all.iter().all(|by| turn(by.row) > 0));
        let routes: usize = ROWS.iter().filter(|row| turn(row) > 0).map(|row| row.routes.len()).sum();
        assert_eq!((all.len(), REPORTERS.len(), count_in_turn()), (routes, routes, routes));
        let routes = |fault| all.iter().filter(move |by| by.row.fault == fault).map(|by| *by.route);
        for row in ROWS.iter().filter(|row| turn(row) > 0) {
            assert!(routes(row.fault).eq(row.routes.iter().copied()), "{}: in order", row.fault.key());
        }
        assert!(row_after(u16::MAX).is_none());
    }
}
