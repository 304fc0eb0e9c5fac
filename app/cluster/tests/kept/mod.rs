//! What an instrument keeps over power-off, with a shelf of bytes for the flash.

use cluster::kept::{Bytes, Distance, KeptFault, Starts};
use cluster::own::Restart;
use cluster::{FaultId, Inputs, Instrument, Memory, Options, Part};
use protocol_core::generated::citybus;
use protocol_core::{CanFrame, CanId, Millis};
use std::collections::BTreeMap;

/// What is kept, by number.
type Shelf = BTreeMap<u8, Vec<u8>>;

struct Run {
    instrument: Instrument,
    shelf: Shelf,
    now: u64,
    life: u8,
    /// Each part in the order in which it was saved.
    saves: Vec<Part>,
}

impl Run {
    /// Switches an instrument on with what was kept.
    fn start(shelf: Shelf, memory: Memory) -> Self {
        Self::restart(shelf, memory, None)
    }

    fn restart(shelf: Shelf, memory: Memory, restart: Option<Restart>) -> Self {
        let mut instrument = Instrument::fixed(&citybus::VEHICLE, Options::default());
        instrument.restarted(restart);
        for (number, bytes) in &shelf {
            if let Some(part) = Part::from_number(*number) {
                instrument.restore(part, bytes);
            }
        }
        instrument.resume(memory);
        Self { instrument, shelf, now: 0, life: 0, saves: Vec::new() }
    }

    /// Lets `ms` pass at a speed, saving one part a tick.
    fn drive(&mut self, kmh: u16, ms: u64) {
        for _ in 0..ms / 10 {
            let now = Millis(self.now);
            if self.now.is_multiple_of(50) {
                // VCU1: gear D and the speed in 1/256 km/h.
                self.life = self.life.wrapping_add(1);
                self.instrument.hear(&speed(kmh, self.life), now);
            }
            self.instrument.tick(&Inputs::default(), now);
            if let Some((part, bytes)) = self.instrument.due(now) {
                self.save(part, &bytes, now);
            }
            self.now += 10;
        }
    }

    fn save(&mut self, part: Part, bytes: &Bytes, now: Millis) {
        self.shelf.insert(part.number(), bytes.to_vec());
        self.instrument.saved(part, bytes, now);
        self.saves.push(part);
    }

    fn metres(&self) -> u64 {
        u64::from(self.instrument.cluster().odometer_km8()) * 125
    }

    fn kept_metres(&self) -> u64 {
        Distance::from_bytes(&self.shelf[&Part::Distance.number()]).expect("a distance").metres()
    }
}

/// VCU1 with gear D, a speed and a life counter.
fn speed(kmh: u16, life: u8) -> CanFrame {
    let [low, high] = (kmh * 256).to_le_bytes();
    CanFrame::full(CanId::extended(0x0CF1_01A7), [0, 0, low, high, 0, 0xFF, 0, life])
}

#[test]
fn an_hour_is_kept_to_the_last_hundred_metres_and_to_the_metre_once_it_stands() {
    let mut run = Run::start(Shelf::new(), Memory::New);
    for _ in 0..360 {
        run.drive(60, 10_000);
        let (driven, kept) = (run.metres(), run.kept_metres());
        assert!(kept <= driven + 125 && driven < kept + 225, "{driven} m driven, {kept} m kept");
    }
    run.drive(0, 1_000);
    let kept = run.kept_metres();
    assert!((59_900..=60_000).contains(&kept), "{kept}");
    let mut again = Run::start(run.shelf.clone(), Memory::Kept);
    again.drive(0, 200);
    assert_eq!(again.shelf[&1], run.shelf[&1], "to the last count");
    assert_eq!(
        again.instrument.view(Millis(again.now)).journeys,
        run.instrument.view(Millis(run.now)).journeys
    );
}

#[test]
fn a_drive_of_many_starts_never_goes_backwards_and_loses_less_than_a_saving_distance_each() {
    let (mut shelf, mut driven_m, mut shown) = (Shelf::new(), 0, 0);
    for start in 0..200_u64 {
        let memory = if start == 0 { Memory::New } else { Memory::Kept };
        let mut run = Run::start(shelf, memory);
        assert!(run.metres() + 125 + 100 >= shown, "start {start}");
        let before = run.metres();
        let seconds = 5 + start * 7 % 40;
        run.drive(72, seconds * 1_000);
        driven_m += seconds * 20;
        shown = run.metres();
        assert!(shown >= before);
        shelf = run.shelf;
    }
    let kept = Distance::from_bytes(&shelf[&1]).expect("a distance").metres();
    assert!(kept <= driven_m && driven_m - kept <= 200 * 110, "{kept} of {driven_m} m");
}

#[test]
fn what_the_driver_chose_is_kept_at_once() {
    let mut run = Run::start(Shelf::new(), Memory::New);
    run.drive(0, 200);
    run.saves.clear();
    let mut inputs = Inputs::default();
    inputs.buttons.menu = true;
    for _ in 0..20 {
        run.instrument.tick(&inputs, Millis(run.now));
        run.now += 10;
    }
    run.drive(0, 100);
    assert_eq!(run.saves, [Part::Settings]);
    let again = Run::start(run.shelf.clone(), Memory::Kept);
    let of = |run: &Run| {
        let view = run.instrument.view(Millis(run.now));
        (view.language, view.theme)
    };
    assert_eq!(of(&again), of(&run));
    assert_ne!(of(&again), of(&Run::start(Shelf::new(), Memory::New)));
}

#[test]
fn nothing_is_due_before_what_was_kept_is_known() {
    let mut instrument = Instrument::fixed(&citybus::VEHICLE, Options::default());
    instrument.tick(&Inputs::default(), Millis(0));
    assert_eq!(instrument.due(Millis(0)), None);
    assert_eq!(instrument.cluster().known_odometer_km8(), None);
    instrument.resume(Memory::New);
    assert_eq!(instrument.cluster().known_odometer_km8(), Some(0));
    assert!(instrument.due(Millis(0)).is_some());
}

#[test]
fn a_lost_distance_stays_unknown_and_is_said_once() {
    let mut run = Run::start(Shelf::new(), Memory::Damaged);
    run.drive(60, 60_000);
    assert_eq!(run.instrument.cluster().known_odometer_km8(), None);
    let mut again = Run::start(run.shelf, Memory::Kept);
    again.drive(60, 1_000);
    assert_eq!(
        again.instrument.cluster().known_odometer_km8(),
        None,
        "what was counted since is not the distance"
    );
    let line = |run: &Run| run.instrument.view(Millis(run.now)).line.map(|line| line.named.fault);
    assert_ne!(line(&again), Some(FaultId::Memory));
    let mut damaged = Run::start(again.shelf, Memory::Damaged);
    damaged.drive(0, 1_000);
    assert_eq!(line(&damaged), Some(FaultId::Memory));
    damaged.drive(0, 10_000);
    assert_ne!(line(&damaged), Some(FaultId::Memory));
}

#[test]
fn starts_are_counted_by_their_cause() {
    let mut shelf = Shelf::new();
    let causes =
        [None, Some(Restart::Watchdog), Some(Restart::Panic(Some(7))), None, Some(Restart::Watchdog)];
    for restart in causes {
        let mut run = Run::restart(shelf, Memory::Kept, restart);
        run.drive(0, 200);
        shelf = run.shelf;
    }
    assert_eq!(Starts::from_bytes(&shelf[&5]), Starts { power_ons: 2, watchdogs: 2, panics: 1, last: 1 });
}

fn faults_of(run: &Run) -> Vec<KeptFault> {
    (32..64).filter_map(|number| KeptFault::from_bytes(run.shelf.get(&number)?)).collect()
}

#[test]
fn faults_outlive_power_off_with_their_counts_and_their_odometer() {
    let mut run = Run::start(Shelf::new(), Memory::New);
    // Silence of every other node is a fault each.
    run.drive(60, 60_000);
    let kept = faults_of(&run);
    assert!(kept.len() >= 3, "{kept:?}");
    assert!(kept.iter().all(|fault| fault.first_start == 1 && fault.last_start == 1));
    let mut again = Run::start(run.shelf, Memory::Kept);
    let count =
        |run: &Run| run.instrument.cluster().history().map(|entry| u32::from(entry.count)).sum::<u32>();
    assert_eq!(again.instrument.cluster().history().count(), kept.len(), "they are there before any comes");
    let before = count(&again);
    again.drive(60, 120_000);
    assert_eq!(count(&again), 2 * before, "each has come once more");
    let later = faults_of(&again);
    assert_eq!(later.len(), kept.len());
    let is_later =
        |fault: &KeptFault| (fault.first_start, fault.last_start) == (1, 2) && fault.hectometres >= 9;
    assert!(later.iter().all(is_later), "{later:?}");
}

#[test]
fn a_part_of_an_older_or_a_later_version_is_taken_as_far_as_it_goes() {
    let mut run = Run::start(Shelf::new(), Memory::New);
    run.drive(60, 120_000);
    run.drive(0, 1_000);
    let journeys = run.instrument.view(Millis(run.now)).journeys;
    let mut older = run.shelf.clone();
    // Version before: trip A alone, the language alone, starts without their cause.
    for (number, len) in [(2, 32), (3, 1), (5, 12)] {
        older.get_mut(&number).expect("it is kept").truncate(len);
    }
    let mut run = Run::start(older, Memory::Kept);
    assert_eq!(run.instrument.view(Millis(0)).journeys[0], journeys[0]);
    assert_eq!(run.instrument.view(Millis(0)).journeys[1].hectometres, 0);
    run.drive(0, 1_000);
    assert_eq!(run.shelf[&3].len(), 2, "saved anew, whole");
    let mut later = run.shelf.clone();
    later.values_mut().for_each(|bytes| bytes.extend([0x5A; 3]));
    let run = Run::start(later, Memory::Kept);
    assert_eq!(run.instrument.view(Millis(0)).journeys[0], journeys[0]);
    assert!(run.instrument.cluster().known_odometer_km8().is_some());
}

#[test]
fn a_button_that_resets_a_trip_is_kept_at_once() {
    let mut run = Run::start(Shelf::new(), Memory::New);
    run.drive(60, 120_000);
    run.saves.clear();
    // Turn to trip A, then hold: the page shows it, the trip goes to zero.
    let press = |run: &mut Run, ticks: u64| {
        let mut inputs = Inputs::default();
        inputs.buttons.next = true;
        for held in 0..ticks + 5 {
            inputs.buttons.next = held < ticks;
            run.instrument.tick(&inputs, Millis(run.now));
            run.now += 10;
        }
    };
    for _ in 0..8 {
        press(&mut run, 10);
        press(&mut run, 150);
        if run.instrument.view(Millis(run.now)).journeys[0].hectometres == 0 {
            break;
        }
    }
    run.drive(0, 200);
    assert!(run.saves.contains(&Part::Trips), "{:?}", run.saves);
}
