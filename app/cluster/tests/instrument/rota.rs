//! Which faults are reported in one round.

use cluster::instrument::rota::Rota;
use protocol_core::Millis;

/// Reports a list of faults, each with the time at which it came; returns the places that were reported.
fn round(rota: &mut Rota, now: u64, came: &[u64]) -> Vec<usize> {
    let mut reported = Vec::new();
    let entry = |place: usize| came.get(place).map(|&at| (place, Millis(at)));
    let has_any = rota.round(Millis(now), entry, |place| reported.push(*place));
    assert_eq!(has_any, !came.is_empty());
    reported
}

#[test]
fn an_empty_list_has_nothing_to_report() {
    assert_eq!(round(&mut Rota::new(), 200, &[]), [0; 0]);
}

#[test]
fn a_new_fault_is_reported_at_once_wherever_it_stands() {
    let mut rota = Rota::new();
    assert_eq!(round(&mut rota, 200, &[100]), [0]);
    assert_eq!(round(&mut rota, 400, &[300, 100]), [0]);
    assert_eq!(
        round(&mut rota, 600, &[300, 100, 400]),
        [1, 2],
        "one that comes while the round runs is new in the next"
    );
}

#[test]
fn every_fault_has_its_turn_again_and_again() {
    let mut rota = Rota::new();
    let came = [10, 20, 30];
    round(&mut rota, 200, &came);
    let turns: Vec<Vec<usize>> = (2..8).map(|n| round(&mut rota, n * 200, &came)).collect();
    assert_eq!(turns, [[1], [2], [0], [1], [2], [0]]);
}

#[test]
fn of_a_burst_four_are_reported_and_the_rest_wait_for_their_turn() {
    let mut rota = Rota::new();
    let came = [100; 9];
    assert_eq!(round(&mut rota, 200, &came), [0, 1, 2, 3]);
    let later: Vec<usize> = (2..10).flat_map(|n| round(&mut rota, n * 200, &came)).collect();
    assert_eq!(later, [1, 2, 3, 4, 5, 6, 7, 8]);
}

#[test]
fn a_list_that_has_become_shorter_starts_its_turns_anew() {
    let mut rota = Rota::new();
    for n in 1..4 {
        round(&mut rota, n * 200, &[10, 20, 30, 40, 50]);
    }
    assert_eq!(round(&mut rota, 800, &[10, 20]), [0; 0], "its turn was beyond the end");
    assert_eq!(round(&mut rota, 1_000, &[10, 20]), [0]);
}
