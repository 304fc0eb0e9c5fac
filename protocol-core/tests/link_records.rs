//! The PC link: what is encoded comes back, what is damaged never passes for a record.

use proptest::prelude::*;
use protocol_core::link::*;
use protocol_core::states::Confinement;

fn encoded(record: &Record) -> Vec<u8> {
    let mut out = [0; MAX_FRAME];
    let len = encode(record, &mut out).expect("MAX_FRAME is always enough");
    out[..len].to_vec()
}

fn decoded(bytes: &[u8]) -> Vec<Result<Record, LinkError>> {
    let mut decoder = Decoder::new();
    bytes.iter().filter_map(|&byte| decoder.push(byte)).collect()
}

fn hello() -> Record {
    Record::Hello { version: "0.1.0".into(), vehicle: "citybus".into(), build: 0xDEAD_BEEF }
}

const LARGEST_FAULT: Fault = Fault {
    place: 255,
    fault: 255,
    stage: 255,
    code: Some(u16::MAX),
    severity: 255,
    first_ms: u64::MAX,
    times: u16::MAX,
};

/// Every field at its longest encoding.
fn largest() -> Vec<Record> {
    let worst = Sample::Value(i32::MIN);
    let m = u32::MAX;
    vec![
        Record::Hello {
            version: "v".repeat(16).as_str().into(),
            vehicle: "w".repeat(16).as_str().into(),
            build: m,
        },
        Record::Health(Health {
            uptime_ms: u64::MAX,
            frames_received: m,
            frames_dropped_short: m,
            frames_damaged: m,
            frames_unknown: m,
            overruns: m,
            ring_overflows: m,
            can_state: Some(Confinement::BusOff),
            tec: 255,
            rec: 255,
            frames_sent: m,
            spi_errors: m,
            draws: m,
            max_draw_us: m,
            idle_permille: u16::MAX,
            resets: u16::MAX,
            last_reset: ResetReason::Panic,
        }),
        Record::Values { first: 255, items: [worst; CHUNK].into_iter().collect() },
        Record::Shown(Screen {
            time_ms: u64::MAX,
            speed_kmh: worst,
            gear: 255,
            soc_percent: worst,
            pack_decivolts: worst,
            pack_deciamps: worst,
            motor_rpm: worst,
            motor_celsius: worst,
            inverter_celsius: worst,
            odometer_hectometres: m,
            page: 255,
            hv_off_s: Some(255),
            limps: true,
            limp_deciamps: Some(i32::MIN),
            plug: Some(255),
            telltales: m,
            line: Some(ScreenLine {
                fault: 255,
                stage: 255,
                code: Some(u16::MAX),
                severity: 255,
                position: 255,
                count: 255,
            }),
            unseen: Some(ScreenLine {
                fault: 255,
                stage: 255,
                code: Some(u16::MAX),
                severity: 255,
                position: 255,
                count: 255,
            }),
            below: Some(ScreenLine {
                fault: 255,
                stage: 255,
                code: Some(u16::MAX),
                severity: 255,
                position: 255,
                count: 255,
            }),
        }),
        Record::Panic { line: m, text: "p".repeat(64).as_str().into() },
        Record::Trips(Trips {
            trips: [Trip {
                hectometres: m,
                average_whkm: Some(i32::MIN),
                used_watthours: m,
                regained_watthours: m,
            }; 2],
            consumption_whkm: worst,
            range_km: worst,
            range_is_estimated: true,
        }),
        Record::Active { count: 255, fault: Some(LARGEST_FAULT) },
        Record::Active { count: 0, fault: None },
        Record::Remembered { count: 255, fault: LARGEST_FAULT, last_ms: u64::MAX },
    ]
}

#[test]
fn the_largest_records_fit_a_frame_and_come_back() {
    for record in largest() {
        let bytes = encoded(&record);
        assert!(bytes.len() <= MAX_FRAME, "{record:?}");
        assert_eq!(bytes.iter().filter(|&&byte| byte == 0).count(), 1, "a zero only at the end: {record:?}");
        assert_eq!(decoded(&bytes), [Ok(record)]);
    }
}

#[test]
fn a_buffer_of_any_length_holds_the_whole_frame_or_nothing() {
    for record in largest() {
        let whole = encoded(&record);
        for room in 0..MAX_FRAME {
            let mut out = vec![0xAA; room];
            assert_eq!(
                encode(&record, &mut out),
                (room >= whole.len()).then_some(whole.len()),
                "room for {room}"
            );
        }
    }
}

#[test]
fn chunks_of_every_length_come_back() {
    for len in 0..=CHUNK {
        let items: Chunk = (0..len).map(|n| Sample::Value(n as i32 - 8)).collect();
        assert_eq!(items.as_slice().len(), len);
        let record = Record::Values { first: 16, items };
        assert_eq!(decoded(&encoded(&record)), [Ok(record)]);
    }
}

#[test]
fn a_full_chunk_takes_no_more() {
    let mut chunk: Chunk = [Sample::Stale; CHUNK + 3].into_iter().collect();
    assert_eq!(chunk.as_slice(), [Sample::Stale; CHUNK]);
    assert!(!chunk.push(Sample::Never));
}

#[test]
fn every_single_bit_flip_is_an_error_or_harms_nothing() {
    for record in largest().into_iter().chain([hello(), Record::Health(Health::default())]) {
        let whole = encoded(&record);
        for bit in 0..whole.len() * 8 {
            let mut bytes = whole.clone();
            bytes[bit / 8] ^= 1 << (bit % 8);
            // The terminator may have been hit: the next frame's leading zero ends this one.
            bytes.push(0);
            for result in decoded(&bytes) {
                assert!(result.is_err(), "bit {bit} of {record:?} gave {result:?}");
            }
        }
    }
}

#[test]
fn every_pair_of_bit_flips_in_a_short_record_is_an_error() {
    let whole = encoded(&hello());
    let bits = whole.len() * 8;
    for first in 0..bits {
        for second in first + 1..bits {
            let mut bytes = whole.clone();
            bytes[first / 8] ^= 1 << (first % 8);
            bytes[second / 8] ^= 1 << (second % 8);
            bytes.push(0);
            for result in decoded(&bytes) {
                assert!(result.is_err(), "bits {first} and {second} gave {result:?}");
            }
        }
    }
}

#[test]
fn a_frame_cut_off_anywhere_is_an_error_and_the_next_one_is_read() {
    for record in largest() {
        let whole = encoded(&record);
        for cut in 1..whole.len() - 1 {
            let mut bytes = whole[..cut].to_vec();
            bytes.push(0);
            bytes.extend(encoded(&hello()));
            let results = decoded(&bytes);
            assert_eq!(results.len(), 2, "cut at {cut}");
            assert!(results[0].is_err(), "cut at {cut}");
            assert_eq!(results[1], Ok(hello()));
        }
    }
}

#[test]
fn a_start_in_the_middle_of_a_frame_costs_that_frame_only() {
    let whole = encoded(&largest().remove(1));
    for start in 1..whole.len() - 1 {
        let mut bytes = whole[start..].to_vec();
        bytes.extend(encoded(&hello()));
        let results = decoded(&bytes);
        assert!(results[..results.len() - 1].iter().all(Result::is_err), "start at {start}");
        assert_eq!(results.last(), Some(&Ok(hello())), "start at {start}");
    }
}

#[test]
fn zeros_between_frames_are_silent() {
    let mut bytes = vec![0, 0, 0];
    bytes.extend(encoded(&hello()));
    bytes.extend([0, 0]);
    assert_eq!(decoded(&bytes), [Ok(hello())]);
}

#[test]
fn noise_without_an_end_is_bounded_and_reported_once() {
    let mut bytes = vec![0x55; 100_000];
    bytes.push(0);
    bytes.extend(encoded(&hello()));
    assert_eq!(decoded(&bytes), [Err(LinkError::TooLong), Ok(hello())]);
}

/// CRC-16/IBM-3740, bit by bit.
fn crc(payload: &[u8]) -> u16 {
    let mut crc: u16 = 0xFFFF;
    for &byte in payload {
        crc ^= u16::from(byte) << 8;
        for _ in 0..8 {
            crc = if crc & 0x8000 != 0 { crc << 1 ^ 0x1021 } else { crc << 1 };
        }
    }
    crc
}

/// A frame built by hand: `payload` gets a right CRC.
fn framed(payload: &[u8]) -> Vec<u8> {
    let mut bytes = payload.to_vec();
    bytes.extend(crc(payload).to_le_bytes());
    // COBS by hand, for payloads without zeros and for those with.
    let mut frame = Vec::new();
    for run in bytes.split(|&byte| byte == 0) {
        frame.push(run.len() as u8 + 1);
        frame.extend(run);
    }
    frame.push(0);
    frame
}

#[test]
fn the_wire_format_is_the_one_that_the_module_page_states() {
    // Version 4, record 4 = Panic, line 7, text of 2 bytes.
    let record = Record::Panic { line: 7, text: "ab".into() };
    assert_eq!(encoded(&record), framed(&[4, 4, 7, 2, b'a', b'b']));
}

#[test]
fn another_version_is_named() {
    assert_eq!(decoded(&framed(&[9, 4, 7, 2, b'a', b'b'])), [Err(LinkError::Version(9))]);
}

#[test]
fn intact_frames_that_are_no_record_are_unknown() {
    let no_such_record = framed(&[VERSION, 200]);
    let bytes_left_over = framed(&[VERSION, 4, 7, 2, b'a', b'b', b'c']);
    let text_too_long = framed(&[&[VERSION, 0, 17][..], &[b'x'; 17], &[0, 0]].concat());
    let chunk_too_long = framed(&[&[VERSION, 2, 0, 17][..], &[0; 17]].concat());
    let not_utf8 = framed(&[VERSION, 4, 7, 1, 0xFF]);
    for bytes in [no_such_record, bytes_left_over, text_too_long, chunk_too_long, not_utf8] {
        assert_eq!(decoded(&bytes), [Err(LinkError::Unknown)]);
    }
    assert_eq!(decoded(&framed(&[])), [Err(LinkError::Malformed)], "no version byte");
}

#[test]
fn a_text_that_is_too_long_is_cut_between_characters() {
    let text: Excerpt<16> = "a绝缘电阻过低b".into();
    assert_eq!(text.as_str(), "a绝缘电阻过");
    let mut panic = Excerpt::<64>::new();
    let message = "x".repeat(100);
    assert!(core::fmt::write(&mut panic, format_args!("{message}")).is_err());
    assert_eq!(panic.as_str(), "x".repeat(64));
}

#[test]
fn the_crc_of_a_frame_is_crc_16_ibm_3740() {
    assert_eq!(crc(b"123456789"), 0x29B1, "the check value of CRC-16/IBM-3740");
}

#[test]
fn a_fault_is_the_number_of_its_row_its_stage_and_its_code() {
    let fault = Fault { place: 1, fault: 5, stage: 2, code: Some(105), severity: 3, first_ms: 9, times: 4 };
    let bytes = framed(&[4, 6, 7, 1, 1, 5, 2, 1, 105, 3, 9, 4]);
    assert_eq!(encoded(&Record::Active { count: 7, fault: Some(fault) }), bytes);
}

#[test]
fn a_reset_is_told_by_its_number_and_to_a_person_by_its_word() {
    for &reason in ResetReason::ALL {
        let record = Record::Health(Health { last_reset: reason, ..Health::default() });
        let bytes = encoded(&record);
        assert_eq!(decoded(&bytes), [Ok(record)]);
        let json = serde_json::to_value(Health { last_reset: reason, ..Health::default() });
        assert_eq!(json.expect("plain data")["last_reset"], reason.word());
    }
}

#[test]
fn records_can_be_printed_as_json() {
    let record = Record::Values { first: 0, items: [Sample::Value(7), Sample::Stale].into_iter().collect() };
    let json = serde_json::to_string(&record).expect("plain data");
    assert_eq!(json, r#"{"Values":{"first":0,"items":[{"Value":7},"Stale"]}}"#);
    assert_eq!(serde_json::from_str::<Record>(&json).expect("the same text"), record);
}

fn sample() -> impl Strategy<Value = Sample> {
    prop_oneof![
        Just(Sample::Never),
        Just(Sample::Stale),
        Just(Sample::Invalid),
        any::<i32>().prop_map(Sample::Value)
    ]
}

proptest! {
    #[test]
    fn any_values_come_back(first: u8, samples in prop::collection::vec(sample(), 0..=CHUNK)) {
        let record = Record::Values { first, items: samples.into_iter().collect() };
        prop_assert_eq!(decoded(&encoded(&record)), [Ok(record)]);
    }

    #[test]
    fn any_panic_comes_back(line: u32, text in "\\PC{0,64}") {
        let record = Record::Panic { line, text: text.as_str().into() };
        prop_assert_eq!(decoded(&encoded(&record)), [Ok(record)]);
    }

    #[test]
    fn any_bytes_end_in_records_or_errors_and_the_next_frame_is_read(
        noise in prop::collection::vec(any::<u8>(), 0..600),
    ) {
        let mut bytes = noise;
        bytes.push(0);
        bytes.extend(encoded(&hello()));
        let results = decoded(&bytes);
        prop_assert_eq!(results.last(), Some(&Ok(hello())));
    }
}
