//! The interpreter of the tools against the generated code of the images: every vehicle, every message, count for count.

use protocol_core::codec::MessageInfo;
use protocol_core::generated::{MESSAGES, VEHICLES};
use protocol_core::model::Reading;
use protocol_core::{CanId, Readings, Value, Vehicle};
use vehicle_compiler::RunTime;
use vehicle_compiler::network::Message;

// What the generated files name as parts of their own crate.
use protocol_core::{checksum, codec, frame, model, stream, vehicle};

macro_rules! made_up {
    ($($name:ident $path:literal)*) => {
        $(
            #[path = $path]
            #[rustfmt::skip]
            #[allow(clippy::all, clippy::cast_lossless, dead_code, missing_docs, unreachable_pub, unused_imports)]
            mod $name;
        )*
    };
}

made_up! {
    hostile "../../protocol-core/tests/hostile/hostile.rs"
    torture "../../protocol-core/tests/codec_torture/torture.rs"
    wide "../../protocol-core/tests/wide/wide.rs"
}

/// Every vehicle with its messages and its files at run time.
fn all() -> Vec<(&'static Vehicle, &'static [MessageInfo], RunTime)> {
    let root = surroundings::root();
    let read =
        |folder: String| RunTime::of_folder(&root.join(&folder)).unwrap_or_else(|error| panic!("{error}"));
    let known = VEHICLES.iter().map(|vehicle| {
        let (_, messages) = MESSAGES.iter().find(|(name, _)| *name == vehicle.name).expect("its messages");
        (*vehicle, *messages, read(format!("vehicles/{}", vehicle.name)))
    });
    let made_up = [
        (&hostile::VEHICLE, hostile::MESSAGES, read("protocol-core/tests/hostile".into())),
        (&torture::VEHICLE, torture::MESSAGES, read("protocol-core/tests/codec_torture".into())),
        (&wide::VEHICLE, wide::MESSAGES, read("protocol-core/tests/wide".into())),
    ];
    known.chain(made_up).collect()
}

/// The numbers of Marsaglia's xorshift, the same in every run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }
}

/// Frames around each limit of each signal, on each of its pages, and some that mean nothing.
fn frames(message: &Message, numbers: &mut Numbers) -> Vec<[u8; 8]> {
    let mut frames = vec![[0; 8], [0xFF; 8], [0x80; 8], [0x7F; 8]];
    frames.extend((0..500).map(|_| numbers.next().to_le_bytes()));
    for signal in &message.signals {
        let (lowest, highest) = signal.span();
        let (low, high) = signal.range();
        let floats = [
            0.0f32,
            -0.0,
            0.1,
            -0.1,
            499.99,
            500.25,
            1000.0,
            1000.1,
            f32::NAN,
            f32::INFINITY,
            f32::MIN,
            1e-40,
        ];
        let mut raws: Vec<i128> =
            vec![lowest, highest, low, high, low - 1, high + 1, low + 1, high - 1, 0, 1, -1];
        raws.extend(floats.iter().map(|float| i128::from(float.to_bits())));
        raws.extend(floats.iter().map(|float| i128::from(f64::from(*float).to_bits())));
        raws.extend(signal.values.iter().map(|(raw, _)| i128::from(*raw)));
        // Dense where the whole signal is not long, every one of them.
        raws.extend((0..256).map(|step| lowest + (highest - lowest) / 255 * step));
        for raw in raws.into_iter().filter(|raw| (lowest..=highest).contains(raw)) {
            let mut data = numbers.next().to_le_bytes();
            signal.set_raw(&mut data, raw);
            frames.push(data);
            for condition in &signal.when {
                let (first, last) =
                    condition.ranges[(numbers.next() % condition.ranges.len() as u64) as usize];
                let page = first + i128::from(numbers.next()) % (last - first + 1);
                message.signals[condition.selector].set_raw(&mut data, page);
            }
            frames.push(data);
        }
    }
    frames
}

fn readings(readings: &Readings) -> Vec<Option<(Reading, u8)>> {
    Value::ALL.iter().map(|value| readings.get(*value)).collect()
}

#[test]
fn received_values_are_those_of_the_generated_code() {
    let (mut numbers, mut seen) = (Numbers(0x2022_1122), 0);
    for (vehicle, _, known) in all() {
        assert_eq!(known.received(), vehicle.rx.len(), "{}", vehicle.name);
        for (index, row) in vehicle.rx.iter().enumerate() {
            let message = known.network.message_of(row.id).expect("the message");
            let message = &known.network.messages[message];
            for data in frames(message, &mut numbers) {
                let (mut generated, mut interpreted) = (Readings::new(), Readings::new());
                (vehicle.decode)(index as u8, &data, &mut generated);
                known.decode(index as u8, &data, &mut interpreted);
                let [generated, interpreted] = [generated, interpreted].map(|values| readings(&values));
                assert_eq!(interpreted, generated, "{}: {} {data:02X?}", vehicle.name, message.name);
                seen += generated.iter().flatten().count();
            }
        }
    }
    assert!(seen > 100_000, "{seen} values");
}

#[test]
fn sent_frames_are_those_of_the_generated_code() {
    let mut numbers = Numbers(0x2022_1122);
    for (vehicle, _, known) in all() {
        for (index, row) in vehicle.tx.iter().enumerate() {
            for round in 0..2_000 {
                let mut values = Readings::new();
                for value in Value::ALL {
                    let number = numbers.next();
                    let wide = if round % 2 == 0 { number as i32 } else { (number % 300) as i32 };
                    match number >> 60 {
                        0 => {}
                        1 => values.set(0, *value, Reading::Invalid),
                        _ => values.set(0, *value, Reading::Valid(wide.max(-i32::MAX))),
                    }
                }
                let (generated, interpreted) =
                    ((vehicle.encode)(index as u8, &values), known.encode(index as u8, &values));
                assert_eq!(interpreted, generated, "{}: {}", vehicle.name, row.name);
            }
        }
    }
}

#[test]
fn rows_of_every_message_are_those_of_the_generated_code() {
    let mut numbers = Numbers(0x2022_1122);
    for (vehicle, messages, known) in all() {
        for row in messages {
            let index = known.network.message_of(row.id).expect("the message");
            let message = &known.network.messages[index];
            for data in frames(message, &mut numbers) {
                for (at, signal) in row.signals.iter().enumerate() {
                    let own = message.signal(signal.name).expect("the signal");
                    let (raw, counts) = (row.get)(at, data).expect("the row");
                    let ours = &message.signals[own];
                    let place = format!("{}: {}.{} {data:02X?}", vehicle.name, message.name, signal.name);
                    assert_eq!(ours.raw(&data), i128::from(raw), "{place}");
                    assert_eq!(ours.is_valid(raw.into()), counts.is_some(), "{place}");
                    assert_eq!(message.carries(own, &data), row.carries(signal, &data), "{place}");
                    let Some(counts) = counts else { continue };
                    let value: f64 = ours.value(raw.into()).parse().expect("a number");
                    let exact = counts as f64 / f64::from(signal.scale.den);
                    assert!(
                        (value - exact).abs() <= 1e-12 * exact.abs().max(1.0),
                        "{place}: {value} {exact}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_j1939_group_is_found_in_an_image_from_any_source() {
    let vehicle = &wide::VEHICLE;
    let row =
        |id: u32| vehicle.index_of(CanId::extended(id)).map(|index| vehicle.rx[usize::from(index)].name);
    for id in [0x0CF0_0400, 0x18F0_0417, 0x0CF0_04FE] {
        assert_eq!(row(id), Some("EEC1"), "{id:08X}");
        assert!(vehicle.has_id(CanId::extended(id)));
    }
    assert_eq!((row(0x0CF0_0500), vehicle.has_id(CanId::extended(0x0DF0_0400))), (None, false));
}
