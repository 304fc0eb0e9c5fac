use super::*;
use crate::can::Id;

const BYTES: [u8; 8] = [1, 2, 3, 4, 5, 6, 7, 0xAB];

fn frames(text: &str) -> Vec<(u64, Frame)> {
    let log = Log::parse("x.log", text).unwrap();
    log.entries.iter().map(|entry| (entry.at.0, entry.frame)).collect()
}

fn problem(text: &str) -> String {
    Log::parse("x.log", text).unwrap_err().to_string()
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
    assert_eq!((log.origin, log.entries[0].frame), (Nanos(1_767_225_600_000_001_000), frame));
}

#[test]
fn remote_requests_are_kept_and_error_frames_are_counted() {
    let text = "(1.0) can0 123#R4\n(2.0) can0 20000004#0000000000000000\n(3.0) can0 124#\n";
    let log = Log::parse("x.log", text).unwrap();
    assert!(log.entries[0].frame.remote && log.entries[0].frame.dlc == 4);
    assert_eq!(log.entries[1].frame.data_len(), 0);
    assert_eq!((log.entries.len(), log.error_frames), (2, 1));
}

#[test]
fn a_bad_line_is_named_by_file_and_line() {
    let good = "(1.0) can0 123#01\n";
    let cases = [
        ("(2.0) can0 123#0\n", "x.log:2: `0` is not pairs of hexadecimal digits"),
        ("(2.0) can0 123#010203040506070809\n", "x.log:2: 9 data bytes; a classic CAN frame has at most 8"),
        ("(2.0) can0 1234#01\n", "x.log:2: identifier `1234` has 4 digits; 3 for 11 bits, 8 for 29 bits"),
        ("(2.0) can0 FFF#01\n", "x.log:2: identifier FFF has more than 11 bits"),
        ("(2.x) can0 123#01\n", "x.log:2: `2.x` is not a time in seconds"),
        ("(2.0) can0 123##101\n", "x.log:2: a CAN FD frame; only classic CAN is known here"),
        ("(0.5) can0 123#01\n", "x.log:2: time goes back; sort the log by time first"),
        ("what is this\n", "x.log:2: `what` is not a time in brackets"),
    ];
    for (line, expected) in cases {
        assert_eq!(problem(&format!("{good}{line}")), expected);
    }
}

#[test]
fn a_file_that_is_no_log_is_refused() {
    assert_eq!(
        problem("hello\n"),
        "x.log:1: not a CAN log that is known here (candump, Vector ASC, GVRET CSV)"
    );
    assert!(problem("").contains("not a CAN log"));
    let missing = Log::read_file(Path::new("no/such.log")).unwrap_err().to_string();
    assert!(missing.starts_with("no/such.log: cannot read the log"), "{missing}");
}

#[test]
fn no_input_panics() {
    let alphabet =
        ["(", ")", "1.0", " can0 ", "123", "18FEF100", "#", "R", "\u{e9}", "[8]", "date ", ",", "\n", "00"];
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
