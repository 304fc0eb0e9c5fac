use super::placer::CHOOSE;
use super::times::UNDECIDED;
use super::*;
use crate::can::Id;

const BYTES: [u8; 8] = [1, 2, 3, 4, 5, 6, 7, 0xAB];

fn frames(text: &str) -> Vec<(u64, Frame)> {
    let log = Log::parse("x.log", text).unwrap();
    log.entries.iter().map(|entry| (entry.at.0, entry.frame)).collect()
}

/// Returns what is said of a text that cannot be read, without the column and the name of the format.
fn problem(text: &str) -> String {
    let error = Log::parse("x.log", text).unwrap_err();
    let names = FORMATS.iter().map(|format| format!(" ({})", format.name));
    let bare = names.filter_map(|name| error.problem.strip_suffix(&name)).next().unwrap_or(&error.problem);
    LogError { column: 0, problem: bare.to_owned(), ..error.clone() }.to_string()
}

#[test]
fn every_format_gives_the_same_frames() {
    let standard = Frame::new(Id::standard(0x123).unwrap(), &BYTES[..2]).unwrap();
    let extended = Frame::new(Id::extended(0x18FE_F100).unwrap(), &BYTES).unwrap();
    let expected = [(0, standard), (1_500_000, extended)];
    let logged = "(1436509052.249713) can0 123#0102\n\n(1436509052.251213) can0 18FEF100#01020304050607AB\n";
    let shown =
        " (10.000000)  can0  123   [2]  01 02\n (10.001500)  can0  18FEF100   [8]  01 02 03 04 05 06 07 AB\n";
    let asc = "date Sun Nov 22 10:00:00 am 2026\nbase hex  timestamps absolute\nno internal events logged\n\
               Begin Triggerblock\n   0.100000 1  123             Rx   d 2 01 02\n   0.101000 1  Statistic: D 0\n   \
               0.101500 1  18FEF100x       Rx   d 8 01 02 03 04 05 06 07 AB\nEnd TriggerBlock\n";
    let gvret = "Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8\n166064000,00000123,false,Rx,0,2,01,02,\n\
                 166065500,18FEF100,true,Rx,0,8,01,02,03,04,05,06,07,AB,\n";
    for text in [logged, shown, asc, gvret] {
        assert_eq!(frames(text), expected, "{text}");
    }
}

#[test]
fn a_line_written_is_the_line_read() {
    let frame = Frame::new(Id::extended(0x0CF1_01A7).unwrap(), &BYTES).unwrap();
    let line = candump_line(Nanos(1_767_225_600_000_001_000), "can0", &frame);
    assert_eq!(line, "(1767225600.000001) can0 0CF101A7#01020304050607AB");
    let log = Log::parse("x.log", &line).unwrap();
    assert_eq!((log.origin, log.entries[0].frame), (1_767_225_600_000_001_000, frame));
}

#[test]
fn remote_requests_are_kept_and_error_frames_are_counted() {
    let text = "(1.0) can0 123#R4\n(2.0) can0 20000004#0000000000000000\n(3.0) can0 124#\n";
    let log = Log::parse("x.log", text).unwrap();
    assert!(log.entries[0].frame.remote && log.entries[0].frame.dlc == 4);
    assert_eq!(log.entries[1].frame.data_len(), 0);
    assert_eq!((log.entries.len(), log.error_frames), (2, 1));
}

/// A remote request or a data frame with a length code of its own.
fn coded(frame: Frame, dlc: u8) -> Frame {
    Frame { dlc, ..frame }
}

#[test]
fn every_frame_that_is_written_is_read_back() {
    for id in [Id::standard(0x7FF).unwrap(), Id::extended(0x1FFF_FFFF).unwrap()] {
        for dlc in 0..16 {
            let data = coded(Frame::new(id, &BYTES[..usize::from(dlc.min(8))]).unwrap(), dlc);
            for frame in [data, Frame::new_remote(id, dlc)] {
                let line = candump_line(Nanos::ZERO, "can0", &frame) + "\n";
                assert_eq!(frames(&line), [(0, frame)], "{line}");
            }
        }
    }
}

#[test]
fn a_bad_line_is_named_by_file_and_line() {
    let good = "(1.0) can0 123#01\n";
    let cases = [
        ("(2.0) can0 123#0\n", "x.log:2: `0` is not pairs of hexadecimal digits"),
        ("(2.0) can0 123#+1+2\n", "x.log:2: `+1+2` is not pairs of hexadecimal digits"),
        ("(2.0) can0 123#010203040506070809\n", "x.log:2: 9 data bytes; a classic CAN frame has at most 8"),
        ("(2.0) can0 123#0102_F\n", "x.log:2: 2 data bytes where the length says 8"),
        ("(2.0) can0 123#0102030405060708_8\n", "x.log:2: `8` is not a length code of 9 to F"),
        ("(2.0) can0 123#R255\n", "x.log:2: `R255` is not a remote request: R, R0 to R8, R8_9 to R8_F"),
        ("(2.0) can0 1234#01\n", "x.log:2: identifier `1234` has 4 digits; 3 for 11 bits, 8 for 29 bits"),
        ("(2.0) can0 +12#01\n", "x.log:2: `+12` is not an identifier"),
        ("(2.0) can0 FFF#01\n", "x.log:2: identifier `FFF` has more than 11 bits"),
        ("(2.x) can0 123#01\n", "x.log:2: `2.x` is not a time in seconds"),
        ("(-2.0) can0 123#01\n", "x.log:2: `-2.0` is not a time in seconds"),
        ("(2.0) can0 can1 123#01\n", "x.log:2: expected `(seconds) interface id#data`"),
        ("2.0) can0 123#01\n", "x.log:2: expected `(seconds) interface id#data`"),
        (
            "(2026-13-31 15:16:25.481000) can0 123#01\n",
            "x.log:2: `2026-13-31 15:16:25.481000` is neither seconds nor a date",
        ),
    ];
    for (line, expected) in cases {
        assert_eq!(problem(&format!("{good}{line}")), expected);
    }
}

#[test]
fn a_bad_line_of_the_screen_is_named_with_what_it_looks_like() {
    let good = " (1.0)  can0  123   [1]  01\n";
    let cases = [
        (
            "  can0  123   [2]  00000010 00000001\n",
            "x.log:2: `00000010` is binary, as candump -i writes it; record without -i",
        ),
        (
            "  can0  123   [2]  01`02\n",
            "x.log:2: the bytes stand in reverse, as candump -S writes them; record without -S",
        ),
        ("  can0  123   [2]  +1 02\n", "x.log:2: `+1` is not a data byte"),
        ("  can0  123   [2]  01\n", "x.log:2: 1 data bytes where the length says 2"),
        ("  can0  123   [255]  remote request\n", "x.log:2: `255` is not a length of 0 to 8"),
        ("  can0  7E   [1]  01\n", "x.log:2: identifier `7E` has 2 digits"),
        ("  can0  12G   [1]  01\n", "x.log:2: `12G` is not an identifier"),
        ("  can0  RX  123   [1]  01\n", "x.log:2: `RX` between interface and identifier"),
        ("  123   [1]  01\n", "x.log:2: no interface before the identifier"),
        (" (1.0)  can0  123\n", "x.log:2: expected `interface id [length] data`"),
        (" (1.0  can0  123   [1]  01\n", "x.log:2: the time has no closing bracket"),
        ("  can0  123   [1]  01\n", "x.log:2: a line without a time, and those above have one"),
        ("(1.0) can0 123#01\n", "x.log:2: a line of candump -l among lines of the screen"),
    ];
    for (line, expected) in cases {
        let said = problem(&format!("{good}{line}"));
        assert!(said.starts_with(expected), "{said}\n{expected}");
    }
}

#[test]
fn options_of_the_screen_are_read() {
    let plain = Frame::new(Id::standard(0x123).unwrap(), &BYTES).unwrap();
    let cases = [
        (" (1.0)  can0  RX - -  123   [8]  01 02 03 04 05 06 07 AB\n", plain),
        (" (1.0)  can0  TX B E  123   [8]  01 02 03 04 05 06 07 AB\n", plain),
        (" (1.0)  can0  123   [8]  01 02 03 04 05 06 07 AB   '..[1]..'\n", plain),
        (" (1.0)  can0  123   {F}  01 02 03 04 05 06 07 AB\n", coded(plain, 15)),
        (" (1.0)  can0  123   [0]  remote request\n", Frame::new_remote(plain.id, 0)),
    ];
    for (line, frame) in cases {
        assert_eq!(frames(line), [(0, frame)], "{line}");
    }
}

#[test]
fn what_candump_explains_of_an_error_frame_is_no_line_of_its_own() {
    let text = " (1.0)  can0  123   [1]  01\n \
                (1.1)  can0  20000088   [8]  00 00 08 00 00 00 00 00   ERRORFRAME\n\
                \tprotocol-violation{{tx-dominant-bit-error}{}}\n\tbus-error\n \
                (1.2)  can0  123   [1]  02\n";
    let log = Log::parse("x.log", text).unwrap();
    assert_eq!((log.entries.len(), log.error_frames, &log.notes[..]), (2, 1, &[][..]));
}

#[test]
fn lines_that_are_no_frames_are_counted_and_said() {
    let screen = "user@host:~$ candump -ta can0\n (1.0)  can0  123   [1]  01\n^Z\n[1]+  Stopped   candump can0\n\n \
                  (2.0)  can0  123   [1]  02\n";
    let logged = "$ cat x.log\n(1.0) can0 123#01\n(2.0) can0 123#02\n";
    let asc = "base hex  timestamps absolute\n0.0 Start of measurement\n0.1 1 123 Rx d 1 01\n0.2 1 Statistic: D 0\n\
               0.2 1 18FEF1x J1939TP FEF1p 6 0 0 - Rx d 2 01 02\n0.2 Li 3c Rx 8 00\n1.1 1 123 Rx d 1 02\n";
    let gvret = "made with SavvyCAN\nTime Stamp,ID,Extended,Dir,Bus,LEN,D1\n1,123,false,Rx,0,1,01\n2,123,false,Rx,0,1,02\n";
    for (text, note) in [
        (screen, "3 lines are no frames, the first is line 1"),
        (logged, "1 line is no frame: line 1"),
        (asc, "3 lines are no frames, the first is line 4"),
        (gvret, "1 line is no frame: line 1"),
    ] {
        let log = Log::parse("x.log", text).unwrap();
        assert_eq!((log.entries.len(), &log.notes[..]), (2, &[note.to_owned()][..]), "{text}");
    }
}

/// A file of Vector ASC with this base and kind of times.
fn asc(base: &str, times: &str, events: &str) -> String {
    format!("date Thu Apr 28 10:44:52.480 am 2022\nbase {base}  timestamps {times}\n{events}")
}

#[test]
fn asc_frames_of_other_tools_are_read() {
    let plain = Frame::new(Id::extended(0x0CF1_01A7).unwrap(), &BYTES).unwrap();
    let bytes = "01 02 03 04 05 06 07 AB";
    let cases = [
        (format!("1.0 1 0CF101A7x Rx D 8 {bytes}"), plain),
        (format!("1.0 300 CF101A7x Tx d 8 {bytes}"), plain),
        (format!("1.0 can1 CF101A7X Rx d 8 {bytes} Length = 244016 BitCount = 125 ID = 217121191x"), plain),
        (format!("1.0 CAN 1 CF101A7x Rx d 8 {bytes}"), plain),
        (format!("1.0 1 CF101A7x Rx d D {bytes}"), coded(plain, 13)),
        ("1.0 1 CF101A7x Tx r".into(), Frame::new_remote(plain.id, 0)),
        ("1.0 1 CF101A7x Tx r 4".into(), Frame::new_remote(plain.id, 4)),
        (
            "1.0 1 CF101A7x Tx r Length = 1704000 BitCount = 145 ID = 256".into(),
            Frame::new_remote(plain.id, 0),
        ),
        ("1.0 1 CF101A7x Tx r 8 Length=1704000".into(), Frame::new_remote(plain.id, 8)),
    ];
    for (line, frame) in cases {
        assert_eq!(frames(&asc("hex", "absolute", &line)), [(0, frame)], "{line}");
    }
    let decimal = asc("dec", "absolute", "770.592543 7  217121191x  Rx D 8 1   2   3  4  5 6 7   171\n");
    assert_eq!(frames(&decimal), [(0, plain)]);
}

#[test]
fn an_asc_frame_that_cannot_be_read_is_named() {
    let cases = [
        ("1.0 1 123 Rx x 8 00", "`x` behind Rx or Tx; d is data, r a remote request"),
        ("1.0 1 EngineData Rx d 1 00", "`EngineData` is not an identifier"),
        ("1.0 1 123 Rx d ffffffffffffffff 00", "`ffffffffffffffff` is not a length code of 0 to 15"),
        ("1.0 1 123 Rx d 2 00", "fewer than 2 data bytes"),
        ("1.0 1 123 Rx d 1 00000001", "`00000001` is not a data byte"),
        ("1.0 1 +12 Rx d 1 00", "`+12` is not an identifier"),
        ("1.0 1 123 Rx r soon", "`soon` is not a length code of 0 to 15"),
        ("1.x 1 123 Rx d 1 00", "`1.x` is not a time in seconds"),
    ];
    for (line, expected) in cases {
        assert_eq!(problem(&asc("hex", "absolute", line)), format!("x.log:3: {expected}"));
    }
    assert_eq!(problem("base oct timestamps absolute\n"), "x.log:1: neither `base hex` nor `base dec`");
    let unknown = "x.log:1: expected `timestamps absolute` or `timestamps relative` here";
    assert_eq!(problem("base hex timestamps soon\n"), unknown);
}

fn times(text: &str) -> Vec<u64> {
    frames(text).iter().map(|(at, _)| at / 1_000).collect()
}

#[test]
fn relative_asc_times_are_added_up_over_every_event() {
    let events = "0.0 Start of measurement\n0.1 1 123 Rx d 1 01\n0.1 1 123 Rx d 1 02\n0.05 1 Statistic: D 0\n\
                  0.05 1 ErrorFrame\n0.1 1 123 Rx d 1 03\n0.0999 1 123 Rx d 1 04\n";
    assert_eq!(times(&asc("hex", "relative", events)), [0, 100_000, 300_000, 399_900]);
}

/// Lines of candump's screen with these times.
fn screen(times: &[&str]) -> String {
    times.iter().map(|time| format!(" ({time})  can0  123   [1]  01\n")).collect()
}

#[test]
fn times_that_may_count_from_the_line_before_are_decided_by_proof_only() {
    // candump -td and -tz write the same form.
    let growing: Vec<String> = (0..9).map(|n| format!("000.{:06}", n * 20_000)).collect();
    let growing: Vec<&str> = growing.iter().map(String::as_str).collect();
    let clock = screen(&growing);
    assert_eq!(times(&clock).last(), Some(&160_000), "eight rises are a clock");
    let late = clock + " (000.159000)  can0  123   [1]  01\n";
    assert_eq!(times(&late).last(), Some(&160_000), "a clock that was read late once is still one");
    let undecided = format!("x.log:1: {}", UNDECIDED);
    assert_eq!(problem(&screen(&growing[..8])), undecided);
    let constant = screen(&["000.000000", "000.020000", "000.020000", "000.020001"]);
    assert_eq!(problem(&constant), undecided);
    // Only the tools that write both fill up with zeros.
    assert_eq!(times(&screen(&["123.000000", "123.020000"])), [0, 20_000]);
    let jitter = screen(&["000.000000", "000.020012", "000.019988", "000.020001"]);
    let said = problem(&jitter);
    assert!(said.starts_with("x.log:3: time goes back: ") && said.contains("`--times delta`"), "{said}");
    assert!(!said.contains("sort"), "{said}");

    let said = |times, text: &str| {
        let reading = Reading { times: Some(times), ..Reading::default() };
        let log = reading.text("x.log", text).unwrap();
        log.entries.iter().map(|entry| entry.at.as_micros()).collect::<Vec<_>>()
    };
    assert_eq!(said(Times::Delta, &jitter), [0, 20_012, 40_000, 60_001]);
    assert_eq!(said(Times::Delta, &constant), [0, 20_000, 40_000, 60_001]);
    assert_eq!(said(Times::Absolute, &constant), [0, 20_000, 20_000, 20_001]);
}

#[test]
fn an_asc_file_without_a_head_needs_the_same_proof() {
    let line = |time: u32| format!("{time}.0 1 123 Rx d 1 01\n");
    let clock: String = (1..10).map(line).collect();
    assert_eq!(times(&clock).last(), Some(&8_000_000));
    assert!(problem(&line(1)).contains("`--times absolute` or `--times delta`"));
}

#[test]
fn a_small_step_back_keeps_its_place_and_is_said() {
    let text = "(1597294762.404524) can0 123#01\n(1597294762.409544) can0 123#02\n(1597294762.409540) can0 123#03\n\
                (1597294762.409541) can0 123#04\n(1597294762.500000) can0 123#05\n";
    let log = Log::parse("x.log", text).unwrap();
    assert_eq!(times(text), [0, 5_020, 5_020, 5_020, 95_476]);
    assert_eq!(log.entries[2].frame.data[0], 3);
    assert_eq!(log.notes, ["2 frames are dated up to 0.000004 s before the one above and take its time"]);
    let large = "(1597294762.5) can0 123#01\n(1597294762.3) can0 123#02\n";
    assert_eq!(
        problem(large),
        "x.log:2: time goes back by 0.200000 s; cut the log here, or sort its lines by time"
    );
}

#[test]
fn gvret_times_below_zero_are_times() {
    let text = "Time Stamp,ID,Extended,Dir,Bus,LEN,D1\n-1769872318259854,123,false,Rx,0,1,01\n\
                -1769872318239852,123,false,Rx,0,1,0A\n";
    assert_eq!(times(text), [0, 20_002]);
    assert_eq!(Log::parse("x.csv", text).unwrap().origin, -1_769_872_318_259_854_000);
}

#[test]
fn an_older_gvret_file_has_no_direction_and_short_bytes() {
    let head = "\u{FEFF}Time Stamp,ID,Extended,Bus,DLC,D1,D2,D3,D4,D5,D6,D7,D8\n";
    let frame = Frame::new(Id::standard(0x337).unwrap(), &[0xFF, 0]).unwrap();
    assert_eq!(frames(&format!("{head}2124377,337,0,1,2,ff,0,0,0,0,0,0,0\n")), [(0, frame)]);
    let cases = [
        ("+1,337,0,1,1,ff", "`+1` is not a time in microseconds"),
        ("1,+37,0,1,1,ff", "`+37` is not an identifier"),
        ("1,2.00E+06,0,1,1,ff", "`2.00E+06` is not an identifier: a spreadsheet has rewritten it"),
        ("1,0CF101A7,false,Rx,0,1,ff", "identifier `0CF101A7` has more than 11 bits"),
        ("1,337,0,x,1,ff", "`x` in column Bus; a number"),
        ("1,337,0,1,1,+f", "`+f` is not a data byte"),
        ("1,337,0,1,1,00f", "`00f` is not a data byte"),
        ("1,337,0,1,2,ff", "fewer than 2 data bytes"),
        ("1,337,0,1,99999999999999999999,ff", "`99999999999999999999` is not a length"),
        ("1,337", "column 3 is missing"),
    ];
    for (line, expected) in cases {
        assert_eq!(problem(&format!("{head}{line}\n")), format!("x.log:2: {expected}"));
    }
}

/// The same two frames on two channels, in every format that names channels.
const TWO_CHANNELS: [(&str, &str, &str); 3] = [
    ("(1.0) can0 123#01\n(2.0) can1 123#02\n(3.0) can1 123#02\n", "can0", "can1"),
    (
        "base hex  timestamps absolute\n1.0 1 123 Rx d 1 01\n2.0 2 123 Rx d 1 02\n3.0 2 123 Rx d 1 02\n",
        "1",
        "2",
    ),
    (
        "Time Stamp,ID,Extended,Dir,Bus,LEN,D1\n1000000,123,false,Rx,0,1,01\n2000000,123,false,Rx,1,1,02\n\
         3000000,123,false,Rx,1,1,02\n",
        "0",
        "1",
    ),
];

#[test]
fn channels_are_never_mixed_unasked() {
    for (text, first, second) in TWO_CHANNELS {
        let expected = format!(
            "x.log: the log has 2 channels ({first}: 1 frames, {second}: 2 frames); identifier 123 is on more than one \
             of them; {CHOOSE}"
        );
        assert_eq!(problem(text), expected);
        let of = |channel| {
            let reading = Reading { channel: Some(channel), ..Reading::default() };
            reading.text("x.log", text)
        };
        let one = of(Channel::Named(second.into())).unwrap();
        assert_eq!(one.entries.iter().map(|entry| entry.at.0).collect::<Vec<_>>(), [0, 1_000_000_000]);
        assert!(one.entries.iter().all(|entry| entry.frame.data[0] == 2), "{text}");
        assert_eq!(one.notes, ["1 frames of other channels are left out"]);
        assert_eq!(of(Channel::All).unwrap().entries.len(), 3);
        let none = of(Channel::Named("can7".into())).unwrap_err().to_string();
        assert!(none.contains(&format!("no frame is of channel can7 ({first}: 1 frames")), "{none}");
    }
}

#[test]
fn gaps_are_added_up_over_the_channels_that_are_left_out() {
    let text = " (000.000000)  can0  123   [1]  01\n (000.020000)  can1  123   [1]  02\n (000.030000)  can0  123   [1]  03\n";
    let channel = Some(Channel::Named("can0".into()));
    let reading = Reading { channel, times: Some(Times::Delta), ..Reading::default() };
    let log = reading.text("x.log", text).unwrap();
    assert_eq!(log.entries.iter().map(|entry| entry.at.as_micros()).collect::<Vec<_>>(), [0, 50_000]);
}

#[test]
fn frames_without_times_are_refused_spaced_or_taken_as_they_are() {
    let text = "  can0  123   [1]  01\n  can0  123   [1]  02\n  can0  123   [1]  03\n";
    let said = problem(text);
    assert!(
        said.starts_with("x.log:1: the log has no times: ") && said.contains("`--spacing-ms N`"),
        "{said}"
    );
    let spaced = Reading { spacing: Some(Nanos::from_millis(20)), ..Reading::default() };
    let log = spaced.text("x.log", text).unwrap();
    assert_eq!(log.entries.iter().map(|entry| entry.at.as_micros()).collect::<Vec<_>>(), [0, 20_000, 40_000]);
    assert!(log.timed);
    let untimed = Reading { untimed: true, ..Reading::default() }.text("x.log", text).unwrap();
    assert!(!untimed.timed && untimed.entries.len() == 3);
    let both = spaced.text("x.log", "(1.0) can0 123#01\n").unwrap_err().to_string();
    assert_eq!(both, "x.log:1: the log has times of its own; leave `--spacing-ms` out");
    let late = Reading { untimed: true, ..Reading::default() }
        .text("x.log", "  can0  123   [1]  01\n (1.0)  can0  123   [1]  02\n");
    assert_eq!(late.unwrap_err().to_string(), "x.log:2: a line with a time, and those above have none");
}

#[test]
fn a_last_line_that_is_cut_off_costs_itself_only() {
    let logged = "(1.0) can0 0CF101A7#0102030405060708\n(2.0) can0 0CF101A7#0102030405060708";
    let shown = "  (1.0)  can0  123   [2]  01 02\n (2.0)  can0  123   [2]  01 02";
    let asc =
        "base hex  timestamps absolute\n1.000000 1  123  Rx   d 2 01 02\n2.000000 1  123  Rx   d 2 01 02";
    let gvret = "Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2\n1000,123,false,Rx,0,2,01,02,\n2000,123,false,Rx,0,2,01,02,";
    for text in [logged, shown, asc, gvret] {
        let start = text.rfind('\n').unwrap() + 1;
        for end in start + 2..text.len() {
            let log = Log::parse("x.log", &text[..end]).unwrap();
            let said = &log.notes;
            let is_whole = log.entries.len() == 2 && text[end..].trim_matches(',').is_empty();
            let is_said = said.len() == 1
                && (said[0] == "the last line is cut off; 1 frames before it were read"
                    || said[0].contains("no frame"));
            assert!(is_whole || log.entries.len() == 1 && is_said, "{:?}: {said:?}", &text[start..end]);
        }
        assert_eq!(Log::parse("x.log", text).unwrap().entries.len(), 2, "the end of line alone is no loss");
    }
    let inside = "(1.0) can0 123#01\n(2.0) can0 12\n(3.0) can0 123#01\n";
    assert!(problem(inside).starts_with("x.log:2: "), "only the very last line may be cut off");
    assert!(problem("(1.0) can0 12").starts_with("x.log:"), "nothing was read before it");
}

/// Two frames 20 ms apart, which each format's sample holds.
fn sample_frames() -> [(u64, Frame); 2] {
    let standard = Frame::new(Id::standard(0x123).unwrap(), &BYTES[..2]).unwrap();
    let extended = Frame::new(Id::extended(0x18FE_F100).unwrap(), &BYTES).unwrap();
    [(0, standard), (20_000_000, extended)]
}

/// Reads a recording, all of its channels as one.
fn all(text: &str) -> Recording {
    let reading = Reading { channel: Some(Channel::All), ..Reading::default() };
    reading.bytes("x.log", text.as_bytes()).unwrap()
}

#[test]
fn the_sample_of_every_format_is_known_by_its_name_and_read() {
    for format in FORMATS.iter().filter(|format| !format.sample.is_empty()) {
        let recording = all(format.sample);
        assert_eq!(recording.format(), format.name);
        let log = recording.log().unwrap();
        let frames: Vec<_> = log.entries.iter().map(|entry| (entry.at.0, entry.frame)).collect();
        assert_eq!(frames, sample_frames(), "{}", format.name);
        assert!(log.timed, "{}", format.name);
        // Windows's ends of lines, an old Macintosh's, and the two encodings of Windows's editor change nothing.
        for end in ["\r\n", "\r"] {
            assert_eq!(all(&format.sample.replace('\n', end)).log().unwrap().entries, log.entries);
        }
        let wide = |to_bytes: fn(u16) -> [u8; 2]| {
            let marked = format!("\u{FEFF}{}", format.sample);
            let bytes: Vec<u8> = marked.encode_utf16().flat_map(to_bytes).collect();
            let reading = Reading { channel: Some(Channel::All), ..Reading::default() };
            reading.bytes("x.log", &bytes).unwrap().log().unwrap().entries
        };
        assert_eq!(wide(u16::to_le_bytes), log.entries, "{}", format.name);
        assert_eq!(wide(u16::to_be_bytes), log.entries, "{}", format.name);
    }
}

#[test]
fn the_table_whose_head_names_can_speeds_is_read() {
    let text = "CAN speed 1: 500k CAN speed 2: 500k Id format: HEX | Data format: HEX | Id29 format: 29 \n\t\n\
                >\t0\t   17:18:39.303:4446.00\tSt\t0x197\t0\t2\t64\tE0\t \t \t \t \t \t \tp:1\n\
                >\t1\t   17:18:39.334:2993.00\tSt\t0x112\t0\t8\tFF\t01\tFF\tFF\tFF\tFF\tFF\tFF\tp:2\n";
    assert!(problem(text).contains("2 channels"), "{}", problem(text));
    let other = text.replace("\tSt\t0x112", "\tEx\t0x112");
    assert_eq!(problem(&other), "x.log:4: `Ex` is not a kind of frame that is known");
    let log = all(text).log().unwrap();
    let said: Vec<_> =
        log.entries.iter().map(|entry| (entry.at.as_micros(), entry.frame.to_string())).collect();
    assert_eq!(said, [(0, "197#64E0".to_owned()), (31_000, "112#FF01FFFFFFFFFFFF".to_owned())]);
    assert_eq!(log.entries[1].channel, 1);
}

/// A line that each format counts as a frame of CAN FD, and how many of them are in the text.
const FD_FRAMES: &[(&str, usize)] = &[
    ("(1.0) can0 123#01\n(1.1) can0 123##1010203\n(1.2) can0 123#02\n", 1),
    (" (1.0)  can0  123   [1]  01\n (1.1)  can0  123  [12]  01 02 03 04 05 06 07 08 09 0A 0B 0C\n", 1),
    ("base hex timestamps absolute\n1.0 1 123 Rx d 1 01\n1.1 CANFD 1 Rx 123 1 0 8 8 00\n", 1),
    (";$FILEVERSION=2.0\n;$COLUMNS=N,O,T,I,d,l,D\n 1 1.0 DT 0123 Rx 1 01\n 2 2.0 FB 0123 Rx 12 01 02\n", 1),
    ("(1.00) RX0 123 [1] 01\n(1.01) RX0 123 [12] 01 02 03 04 05 06 07 08 09 0A 0B 0C\n", 1),
];

#[test]
fn frames_of_can_fd_are_counted_said_and_refused_if_asked() {
    for (text, count) in FD_FRAMES {
        let log = Log::parse("x.log", text).unwrap();
        assert_eq!(log.notes, [format!("{count} frames of CAN FD are left out")], "{text}");
        assert!(log.entries.iter().all(|entry| entry.frame.id.raw() == 0x123));
        let strict = Reading { strict: true, ..Reading::default() };
        let said = strict.text("x.log", text).unwrap_err().to_string();
        assert!(
            said.ends_with("a CAN FD frame, which is not read, and `--strict` leaves nothing out"),
            "{said}"
        );
    }
    assert_eq!(
        problem("(1.0) can0 123##101\n"),
        "x.log: the log holds 1 frames of CAN FD and no classic one"
    );
}

#[test]
fn strict_refuses_what_is_otherwise_counted() {
    let strict = Reading { strict: true, ..Reading::default() };
    let said = |text: &str| strict.text("x.log", text).unwrap_err().to_string();
    assert_eq!(
        said("(1.0) can0 123#01\n$ ls\n(2.0) can0 123#01\n"),
        "x.log:2: the line is no frame, and `--strict` leaves nothing out"
    );
    assert!(said("(1.0) can0 123#0102\n(2.0) can0 123#01").contains("x.log:2: the last line is cut off"));
    assert_eq!(strict.text("x.log", "(1.0) can0 123#01\n\n# note\n").unwrap().entries.len(), 1);
}

#[test]
fn a_line_that_cannot_be_read_is_named_with_its_column_and_the_format_recognised() {
    let cases = [
        ("(1.0) can0 123#0Z\n", "x.log:1:16: `0Z` is not pairs of hexadecimal digits (candump -l)"),
        (" (1.0)  can0  123   [2]  01 0Z\n", "x.log:1:29: `0Z` is not a data byte (candump)"),
        (
            "base hex timestamps absolute\n1.0 1  FFFF  Rx d 1 00\n",
            "x.log:2:8: identifier `FFFF` has more than 11 bits (Vector ASC)",
        ),
        (
            "Time Stamp,ID,Extended,Dir,Bus,LEN,D1\n1,123,maybe,Rx,0,1,01\n",
            "x.log:2:7: `maybe` in column Extended; true or false (GVRET CSV)",
        ),
        (
            ";$FILEVERSION=1.1\n  1)  17.4  Rx  123  8  D0\n",
            "x.log:2:17: identifier `123` has 3 digits; 4 for 11 bits, 5 to 8 for 29 bits (PCAN trace)",
        ),
        (";$FILEVERSION=9.9\n", "x.log:1:15: `9.9` is not a version that is known (1.0 to 2.1) (PCAN trace)"),
        (
            "***BUSMASTER Ver 2.4.0***\n22:20:14:9920 Rx 1 0x123 q 1 D0\n",
            "x.log:2:26: `q` is not s, x, sr or xr (BUSMASTER log)",
        ),
        ("(683.70) RX0 7E0 [2] D0 Z0\n", "x.log:1:25: `Z0` is not a data byte (Battery-Emulator log)"),
        ("1632426782.045940 1R11 12G 00\n", "x.log:1:24: `12G` is not an identifier (OVMS CRTD)"),
    ];
    for (text, expected) in cases {
        assert_eq!(Log::parse("x.log", text).unwrap_err().to_string(), expected);
    }
}

#[test]
fn every_version_of_pcan_traces_is_read() {
    let bytes = "01 02 03 04 05 06 07 AB";
    let [(_, standard), (_, extended)] = sample_frames();
    let cases = [
        (";   Message Number\n".to_owned(), format!("1)  10 0123  2  01 02\n 2)  30 18FEF100  8  {bytes}\n")),
        (
            ";$FILEVERSION=1.2\n".into(),
            format!("1)  10.1 1  Rx 0123  2  01 02\n 2)  30.1 1  Tx 18FEF100  8  {bytes}\n"),
        ),
        (
            ";$FILEVERSION=1.3\n".into(),
            format!("1)  10.1 1  Rx 0123 -  2  01 02\n 2)  30.1 1  Rx 18FEF100 -  8  {bytes}\n"),
        ),
        (
            ";$FILEVERSION=2.0\n;$COLUMNS=N,O,T,I,d,l,D\n".into(),
            format!(
                "1  10.100 DT 0123 Rx 2  01 02\n 2  20.0 ST Rx 00 00 00 08\n 3  30.100 DT 18FEF100 Rx 8  {bytes}\n"
            ),
        ),
        (
            ";$FILEVERSION=2.1\n;$COLUMNS=N,O,T,B,I,d,R,L,D\n".into(),
            format!("1  10.100 DT 1 0123 Rx - 2  01 02\n 2  30.100 DT 1 18FEF100 Rx - 8  {bytes}\n"),
        ),
    ];
    for (head, lines) in cases {
        assert_eq!(frames(&format!("{head}{lines}")), [(0, standard), (20_000_000, extended)], "{head}");
    }
    let others = ";$FILEVERSION=1.1\n1) 1.0 Rx 0123 2 01 02\n2) 2.0 Warng FFFFFFFF 4 00 00 00 08 BUSHEAVY\n\
                  3) 3.0 Rx 0123 4 RTR\n";
    let log = Log::parse("x.trc", others).unwrap();
    assert_eq!((log.error_frames, log.entries[1].frame), (1, Frame::new_remote(standard.id, 4)));
}

#[test]
fn times_of_day_go_on_over_midnight_and_modes_of_busmaster_are_kept_apart() {
    let log = |mode: &str, clock: [&str; 3]| {
        let frame = |time: &str| format!("{time} Rx 1 0x123 s 1 01\n");
        let lines: String = clock.into_iter().map(frame).collect();
        times(&format!("***BUSMASTER Ver 2.4.0***\n***{mode}***\n{lines}"))
    };
    assert_eq!(
        log("SYSTEM MODE", ["23:59:59:5000", "0:00:00:5000", "0:00:01:5000"]),
        [0, 1_000_000, 2_000_000]
    );
    assert_eq!(
        log("RELATIVE MODE", ["0:00:00:0000", "0:00:00:5000", "0:00:00:5000"]),
        [0, 500_000, 1_000_000]
    );
    assert_eq!(log("ABSOLUTE MODE", ["0:00:00:0000", "0:00:00:5000", "0:00:00:5000"]), [0, 500_000, 500_000]);
    for wrong in ["24:00:00:0000", "1:60:00:0000", "1:00:60:0000", "001:00:00:0000", "1:00:00", "+1:00:00:0"]
    {
        let text = format!("***BUSMASTER Ver 2.4.0***\n{wrong} Rx 1 0x123 s 1 01\n");
        assert_eq!(problem(&text), format!("x.log:2: `{wrong}` is not a time of day"));
    }
}

#[test]
fn dates_and_colours_of_candumps_screen_are_read() {
    let dates = " (2026-01-31 15:16:25.481000)  can0  123   [1]  01\n (2026-01-31 15:16:25.501000)  can0  123   [1]  01\n";
    assert_eq!(times(dates), [0, 20_000]);
    assert_eq!(Log::parse("x.log", dates).unwrap().origin, 1_769_872_585_481_000_000);
    let coloured =
        "\u{1b}[31m (1.0)  can0  123   [1]  01\u{1b}[0m\n\u{1b}[1;32m (1.02)  can0  123   [1]  01\u{1b}[0m\n";
    assert_eq!(times(coloured), [0, 20_000]);
}

#[test]
fn identifiers_on_several_channels_are_said() {
    let text = "(1.0) can0 123#01\n(2.0) can1 123#02\n(3.0) can1 124#02\n";
    assert!(
        problem(text).contains("; identifier 123 is on more than one of them; choose one"),
        "{}",
        problem(text)
    );
    let log = all(text).log().unwrap();
    assert_eq!(log.notes, ["channels are mixed: identifier 123 is on more than one of them"]);
    let apart = "(1.0) can0 123#01\n(2.0) can1 124#02\n";
    assert!(!problem(apart).contains("more than one"));
    assert!(all(apart).log().unwrap().notes.is_empty());
}

#[test]
fn formats_that_are_not_read_are_refused_by_name() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.bin");
    for (start, expected) in [
        (&b"MDF     4.10"[..], "ASAM MDF (MF4), which is not read here; convert it: "),
        (b"\x1F\x8B\x08", "a gzip archive, "),
        (b"PK\x03\x04", "a zip archive, "),
    ] {
        std::fs::write(&path, start).unwrap();
        let said = Log::read_file(&path).unwrap_err().problem;
        assert!(said.starts_with(expected), "{said}");
    }
}

#[test]
fn what_is_written_in_every_form_is_read_back() {
    let frame = |dlc| Frame { dlc, ..sample_frames()[1].1 };
    let standard = sample_frames()[0].1;
    let kinds =
        [standard, frame(8), frame(13), Frame::new_remote(standard.id, 4), Frame::new_remote(frame(8).id, 0)];
    let entries: Vec<Entry> = (0..)
        .zip(kinds)
        .map(|(n, frame)| Entry { at: Nanos(n * 1_234_000), frame, line: 0, channel: (n % 2) as usize })
        .collect();
    for form in Form::ALL {
        for origin in [1_769_872_585_481_000_000, 0, -5] {
            let mut bytes = Vec::new();
            let mut writer = Writer::new(&mut bytes, form, &["can0", "can1"]);
            entries.iter().for_each(|entry| writer.write(origin, entry).unwrap());
            writer.finish().unwrap();
            let text = String::from_utf8(bytes).unwrap();
            let recording = all(&text);
            let log = recording.log().unwrap();
            let key =
                |entry: &Entry| (entry.at, entry.frame, if form == Form::Csv { 0 } else { entry.channel });
            assert_eq!(
                log.entries.iter().map(key).collect::<Vec<_>>(),
                entries.iter().map(key).collect::<Vec<_>>(),
                "{text}"
            );
            let expected: &[&str] = match form {
                Form::Candump => &["can0", "can1"],
                Form::Asc => &["1", "2"],
                Form::Csv => &[""],
            };
            assert_eq!(recording.channels().collect::<Vec<_>>(), expected);
            assert_eq!(log.origin, if form == Form::Asc { 0 } else { origin.max(0) });
        }
    }
}

#[test]
fn the_head_of_an_asc_file_has_the_date() {
    let mut bytes = Vec::new();
    let mut writer = Writer::new(&mut bytes, Form::Asc, &["0"]);
    let entry = Entry { at: Nanos::ZERO, frame: sample_frames()[0].1, line: 0, channel: 0 };
    writer.write(1_769_872_585_481_000_000, &entry).unwrap();
    writer.finish().unwrap();
    let text = String::from_utf8(bytes).unwrap();
    assert!(
        text.starts_with("date Sat Jan 31 03:16:25.481 pm 2026\nbase hex  timestamps absolute\n"),
        "{text}"
    );
}

#[test]
fn what_a_file_says_cannot_steer_the_terminal() {
    let said = problem("(1.0) can0 123#01\n(2.0) can0 123#\u{1b}[2J\u{202e}\n");
    assert_eq!(said, "x.log:2: `\\u{1b}[2J\\u{202e}` is not pairs of hexadecimal digits");
    let channel = "(1.0) can0 123#01\n(2.0) \u{1b}[2J 123#01\n";
    assert!(!problem(channel).contains('\u{1b}'));
    let long = problem(&format!("(1.0) can0 123#{}\n", "x".repeat(100_000)));
    assert!(long.len() < 200, "{} bytes", long.len());
}

#[test]
fn a_file_that_is_no_log_is_refused() {
    let said = problem("\nhello\n");
    assert!(said.starts_with("x.log:2: not a CAN log that is known here (GVRET CSV, "), "{said}");
    assert!(said.ends_with(", Vector BLF)"), "{said}");
    assert!(problem("").contains("holds no frame"));
    assert!(problem(&"hello\n".repeat(2_000)).starts_with("x.log:1: not a CAN log"));
    let missing = Log::read_file(Path::new("no/such.log")).unwrap_err().to_string();
    assert!(missing.starts_with("no/such.log: cannot read the log"), "{missing}");
}

#[test]
fn the_encoding_of_a_file_is_no_hindrance_unless_it_is_binary() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.log");
    let read = |bytes: &[u8]| {
        std::fs::write(&path, bytes).unwrap();
        Log::read_file(&path).map(|log| log.entries.len()).map_err(|error| error.problem)
    };
    assert_eq!(read(b"\xEF\xBB\xBF(1.000000) can0 123#01\n(1.020000) can0 123#02\n"), Ok(2));
    assert_eq!(
        read(b"date Die M\xE4r 1 2022\r\nbase hex timestamps absolute\r\n1.0 1 123 Rx d 1 00\r\n"),
        Ok(1)
    );
    assert!(read(&[0xFF; 100_000]).unwrap_err().contains("a line of more than 65536 bytes: not a text log"));
    assert_eq!(read(b"LOGG\x90\x00\x00\x00"), Err("object 1: the head is cut off (Vector BLF)".into()));
}

/// Reads lines as they come and returns what was said at the first error, or the times and frames.
fn live(reading: &Reading, lines: &[&str]) -> Result<Vec<(u64, String)>, String> {
    let mut live = Live::new("stdin", reading);
    let mut entries = Vec::new();
    for line in lines {
        entries.extend(live.read(line).map_err(|error| error.to_string())?);
    }
    live.finish().map_err(|error| error.to_string())?;
    Ok(entries.iter().map(|entry| (entry.at.as_micros(), entry.frame.to_string())).collect())
}

#[test]
fn every_format_is_read_line_by_line() {
    let logged: &[&str] = &["(1.0) can0 0CF101A7#01\n", "\n", "(1.02) can0 123#0203\n"];
    let shown = &[" (1.0)  can0  0CF101A7   [1]  01\n", " (1.02)  can0  123   [2]  02 03\n"];
    let gvret = &[
        "Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2\n",
        "1000000,0CF101A7,true,Rx,0,1,01\n",
        "1020000,00000123,false,Rx,0,2,02,03\n",
    ];
    let asc = &[
        "base hex  timestamps relative\n",
        "   1.000000 1  0CF101A7x       Rx   d 1 01\n",
        "   0.020000 1  123             Rx   d 2 02 03\n",
    ];
    for lines in [logged, shown, gvret, asc] {
        let read = live(&Reading::default(), lines).unwrap();
        assert_eq!(read, [(0, "0CF101A7#01".to_owned()), (20_000, "123#0203".to_owned())], "{lines:?}");
    }
}

#[test]
fn a_live_bus_with_errors_goes_on_and_its_end_may_be_cut_off() {
    let mut live = Live::new("stdin", &Reading::default());
    let lines = [
        " (1.0)  can0  123   [1]  01\n",
        " (1.1)  can0  20000088   [8]  00 00 08 00 00 00 00 00   ERRORFRAME\n",
        "\tprotocol-violation{{tx-dominant-bit-error}{}}\n",
        "\tbus-error\n",
        "user@host\n",
        " (1.2)  can0  123   [1]  02\n",
        " (1.3)  can0  123   [1",
    ];
    let heard = lines.iter().filter_map(|line| live.read(line).unwrap()).count();
    assert_eq!((heard, live.error_frames()), (2, 1));
    let expected = ["1 line is no frame: line 5", "the last line is cut off; 2 frames before it were read"];
    assert_eq!(live.notes(), expected);
}

#[test]
fn a_live_bus_is_refused_where_it_leaves_open_what_is_meant() {
    let short = [" (000.000000)  can0  123   [1]  01\n", " (000.020000)  can0  123   [1]  01\n"];
    assert_eq!(live(&Reading::default(), &short), Err(format!("stdin:1: {}", UNDECIDED)));
    let delta = Reading { times: Some(Times::Delta), ..Reading::default() };
    assert_eq!(live(&delta, &short).unwrap()[1].0, 20_000);
    let two = ["(1.0) can0 123#01\n", "(2.0) can1 123#02\n"];
    let said = live(&Reading::default(), &two).unwrap_err();
    assert_eq!(said, format!("stdin:2: a frame of can1 after frames of can0; {CHOOSE}"));
    let named = Reading { channel: Some(Channel::Named("can1".into())), ..Reading::default() };
    assert_eq!(live(&named, &two).unwrap(), [(0, "123#02".to_owned())]);
    let all = Reading { channel: Some(Channel::All), ..Reading::default() };
    assert_eq!(live(&all, &two).unwrap().len(), 2);
    let bad = live(&Reading::default(), &["(1.0) can0 123#00\n", "(2.0) can0 123#0\n"]).unwrap_err();
    assert_eq!(bad, "stdin:2:16: `0` is not pairs of hexadecimal digits (candump -l)");
    assert_eq!(live(&Reading::default(), &[]).unwrap_err(), "stdin: the log holds no frame");
}

#[test]
fn no_input_panics() {
    let alphabet = [
        "(", ")", "1.0", " can0 ", "123", "18FEF100", "#", "R", "\u{e9}", "[8]", "date ", ",", "\n", "00",
        " Rx ", " d ",
    ];
    let mut state = 1u32;
    for _ in 0..20_000 {
        let mut text = String::new();
        for _ in 0..12 {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            text.push_str(alphabet[(state >> 24) as usize % alphabet.len()]);
        }
        let _ = Log::parse("x.log", &text);
    }
}

/// An object of BLF: its type, its flags and its time, then its own bytes.
fn blf_object(kind: u32, flags: u32, stamp: u64, body: &[u8]) -> Vec<u8> {
    let mut object = b"LOBJ".to_vec();
    object.extend(32_u16.to_le_bytes().iter().chain(&1_u16.to_le_bytes()));
    object.extend((32 + body.len() as u32).to_le_bytes().iter().chain(&kind.to_le_bytes()));
    object.extend(flags.to_le_bytes().iter().chain(&[0; 4]).chain(&stamp.to_le_bytes()));
    object.extend(body);
    object.resize(object.len().next_multiple_of(4), 0);
    object
}

/// A container of BLF, packed if `method` is 2.
fn blf_container(method: u16, content: &[u8]) -> Vec<u8> {
    use std::io::Write;
    let mut packed = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
    packed.write_all(content).unwrap();
    let packed = if method == 2 { packed.finish().unwrap() } else { content.to_vec() };
    let mut container = b"LOBJ".to_vec();
    container.extend([16, 0, 1, 0]);
    container.extend((32 + packed.len() as u32).to_le_bytes().iter().chain(&10_u32.to_le_bytes()));
    container.extend(method.to_le_bytes().iter().chain(&[0; 6]));
    container.extend((content.len() as u32).to_le_bytes().iter().chain(&[0; 4]));
    container.extend(&packed);
    container.resize(container.len() + packed.len() % 4, 0);
    container
}

/// A BLF of these containers.
fn blf(containers: &[Vec<u8>]) -> Vec<u8> {
    let mut file = b"LOGG".to_vec();
    file.extend(144_u32.to_le_bytes());
    file.resize(144, 0);
    file.extend(containers.concat());
    file
}

/// Channel, flags, length code, identifier and data of a classic message.
fn blf_message(channel: u16, flags: u8, code: u8, id: u32, data: &[u8]) -> Vec<u8> {
    let mut body = channel.to_le_bytes().to_vec();
    body.extend([flags, code].iter().chain(&id.to_le_bytes()).chain(data));
    body.resize(16, 0);
    body
}

#[test]
fn vector_blf_is_read_over_the_borders_of_its_containers() {
    let [(_, standard), (_, extended)] = sample_frames();
    let fd = |flags: u8, code: u8| {
        let mut body = blf_message(1, 0, code, 0x123, &[]);
        body.resize(20, 0);
        body[13] = flags;
        body.extend([1, 2].iter().chain(&[0; 62]));
        body
    };
    let mut fd_64 = vec![1, 2, 2, 0, 0x23, 1, 0, 0];
    fd_64.resize(40, 0);
    fd_64.extend([1, 2, 0, 0, 0, 0, 0, 0]);
    let objects = [
        blf_object(65, 2, 0, &[0; 8]),
        blf_object(1, 2, 5_000_000, &blf_message(1, 0, 2, 0x123, &BYTES[..2])),
        blf_object(86, 1, 2_500, &blf_message(1, 0, 8, 0x98FE_F100, &BYTES)),
        blf_object(100, 2, 26_000_000, &fd(1, 9)),
        blf_object(100, 2, 27_000_000, &fd(0, 2)),
        blf_object(101, 2, 28_000_000, &fd_64),
        blf_object(73, 2, 28_500_000, &[1; 16]),
        blf_object(1, 2, 29_000_000, &blf_message(1, 0x80, 4, 0x123, &[])),
        blf_object(1, 2, 30_000_000, &blf_message(1, 0, 13, 0x123, &BYTES)),
    ]
    .concat();
    let eight = Frame { dlc: 13, ..Frame::new(standard.id, &BYTES).unwrap() };
    let expected = [
        (0, standard),
        (20_000_000, extended),
        (22_000_000, standard),
        (23_000_000, standard),
        (24_000_000, Frame::new_remote(standard.id, 4)),
        (25_000_000, eight),
    ];
    for method in [0, 2] {
        // Containers end wherever they are full, in the middle of an object too.
        for cut in (1..objects.len()).step_by(7) {
            let parts: Vec<Vec<u8>> = objects.chunks(cut).map(|part| blf_container(method, part)).collect();
            let log = Reading::default().bytes("x.blf", &blf(&parts)).unwrap();
            assert_eq!(log.format(), BLF);
            let log = log.log().unwrap();
            let frames: Vec<_> = log.entries.iter().map(|entry| (entry.at.0, entry.frame)).collect();
            assert_eq!(frames, expected, "cut every {cut}");
            assert_eq!(
                (log.error_frames, &log.notes[..]),
                (1, &["1 frames of CAN FD are left out".to_owned()][..])
            );
        }
    }
}

#[test]
fn a_damaged_blf_is_named_and_a_cut_one_read_up_to_there() {
    let one = blf_object(1, 2, 0, &blf_message(1, 0, 1, 0x123, &[1]));
    let whole = blf(&[blf_container(2, &one), blf_container(2, &one)]);
    let read = |bytes: &[u8]| Reading::default().bytes("x.blf", bytes).and_then(|recording| recording.log());
    for end in whole.len() - 40..whole.len() - 4 {
        let log = read(&whole[..end]).unwrap();
        assert_eq!(log.entries.len(), 1, "{end}");
        assert_eq!(log.notes, ["the last line is cut off; 1 frames before it were read"]);
    }
    let said = |bytes: &[u8]| read(bytes).unwrap_err().to_string();
    assert_eq!(
        said(&blf(&[blf_container(7, &one)])),
        "x.blf: object 1: a container packed by method 7 (Vector BLF)"
    );
    let mut damaged = whole.clone();
    damaged[144 + 36] ^= 0xFF;
    assert!(said(&damaged).contains("object 1: a container: "), "{}", said(&damaged));
    damaged[144] = b'X';
    assert!(said(&damaged).contains("no object where one has to begin"), "{}", said(&damaged));
    for at in 0..whole.len() {
        for value in [0, 0x7F, 0xFF] {
            let mut noise = whole.clone();
            noise[at] = value;
            let _ = read(&noise);
        }
    }
}

#[test]
fn a_damaged_sample_of_any_format_is_read_or_refused_and_never_read_as_more() {
    for format in FORMATS {
        let sample = format.sample.as_bytes();
        for at in 0..sample.len() {
            for sign in [b'+', b'-', b'0', b'x', b' ', b'\t', b'\n', b'(', b'#', 0xFF, 0] {
                let mut damaged = sample.to_vec();
                damaged[at] = sign;
                let reading = Reading { channel: Some(Channel::All), untimed: true, ..Reading::default() };
                let read = reading.bytes("x.log", &damaged).and_then(|recording| recording.log());
                assert!(read.map_or(true, |log| log.entries.len() <= 2), "{}", format.name);
            }
        }
    }
}
