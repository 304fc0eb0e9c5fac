//! The formats that are read: one row each, and a recording's format found by its first lines.

use super::line::{EachLine, ReadLine};
use super::{asc, busmaster, candump, crtd, gvret, kvaser, pcan, python_csv, tables, terminals};

/// A text format that is read.
pub struct Format {
    /// What it is called in notes and errors.
    pub name: &'static str,
    /// What writes it.
    pub written_by: &'static str,
    /// What its times count from, and in which unit.
    pub times: &'static str,
    /// Channels, remote requests and errors, as far as the format has them.
    pub holds: &'static str,
    /// A head and two frames in it, 20 ms apart: `123` with 01 02, then `18FEF100` with 01 02 03 04 05 06 07 AB.
    pub sample: &'static str,
    looks_like: fn(&str) -> bool,
    reader: fn() -> Box<dyn ReadLine>,
}

/// The name of the one format that is not text.
pub const BLF: &str = "Vector BLF";

/// Every text format that is read, in the order in which they are tried: those with a head first.
pub const FORMATS: &[Format] = &[
    Format {
        name: "GVRET CSV",
        written_by: "SavvyCAN, ESP32RET and others of the family",
        times: "microseconds since any moment, below zero too",
        holds: "channels, classic data frames",
        sample: "Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8\n\
                 166064000,00000123,false,Rx,0,2,01,02,\n\
                 166084000,18FEF100,true,Rx,0,8,01,02,03,04,05,06,07,AB,\n",
        looks_like: gvret::looks_like,
        reader: || Box::new(gvret::Gvret::default()),
    },
    Format {
        name: "python-can CSV",
        written_by: "python-can",
        times: "seconds since 1970",
        holds: "remote requests, errors",
        sample: "timestamp,arbitration_id,extended,remote,error,dlc,data\n\
                 1436509052.25,0x123,0,0,0,2,AQI=\n\
                 1436509052.27,0x18fef100,1,0,0,8,AQIDBAUGB6s=\n",
        looks_like: python_csv::looks_like,
        reader: || Box::new(EachLine(python_csv::read)),
    },
    Format {
        name: "PCAN trace",
        written_by: "PCAN-View, PCAN-Explorer (.trc 1.0 to 2.1)",
        times: "milliseconds since the start of the trace",
        holds: "channels from 1.2 on, remote requests, errors",
        sample: ";$FILEVERSION=1.1\n;$STARTTIME=44548.6028595139\n;\n\
                 \x20    1)     17535.4  Rx         0123  2  01 02\n\
                 \x20    2)     17555.4  Rx     18FEF100  8  01 02 03 04 05 06 07 AB\n",
        looks_like: pcan::looks_like,
        reader: || Box::new(pcan::Pcan::default()),
    },
    Format {
        name: "BUSMASTER log",
        written_by: "BUSMASTER",
        times: "time of day, or as the head says",
        holds: "channels, remote requests",
        sample: "***BUSMASTER Ver 2.4.0***\n***PROTOCOL CAN***\n***[START LOGGING SESSION]***\n***HEX***\n\
                 ***SYSTEM MODE***\n***<Time><Tx/Rx><Channel><CAN ID><Type><DLC><DataBytes>***\n\
                 23:59:59:9900 Rx 1 0x123 s 2 01 02\n\
                 00:00:00:0100 Rx 1 0x18FEF100 x 8 01 02 03 04 05 06 07 AB\n",
        looks_like: busmaster::looks_like,
        reader: || Box::new(busmaster::Busmaster::default()),
    },
    Format {
        name: "Kvaser CanKing log",
        written_by: "Kvaser CanKing",
        times: "seconds since the start",
        holds: "channels, remote requests, errors",
        sample: "Chn Identifier Flg   DLC  D0...1...2...3...4...5...6..D7       Time     Dir\n\
                 \x200    00000123         2  01  02                               154.250000 R\n\
                 \x200    18FEF100 X       8  01  02  03  04  05  06  07  AB     154.270000 R\n",
        looks_like: kvaser::looks_like,
        reader: || Box::new(EachLine(kvaser::read)),
    },
    Format {
        name: "ParserFlags table",
        written_by: "a program whose tables begin with ParserFlags, Ch, Counter",
        times: "milliseconds since any moment",
        holds: "channels, data frames",
        sample: "ParserFlags\tCh\tCounter\tT/R\tTime\tFlags\tCAN ID\tLen\tData\tParser Name\tdefault\n\
                 1\t0\t1\tRX\t7551684\t\t0x00000123\t2\t0x01 02 \tDefault Parser\t\n\
                 1\t0\t2\tRX\t7551704\t\t0x18fef100\t8\t0x01 02 03 04 05 06 07 ab \tDefault Parser\t\n",
        looks_like: tables::looks_like_parser_flags,
        reader: || Box::new(EachLine(tables::read_parser_flags)),
    },
    Format {
        name: "USB-CAN table",
        written_by: "the program of many USB-CAN adapters (NO, Direction, Time Scale)",
        times: "time of day",
        holds: "remote requests",
        sample: "NO    Direction  Time Scale        Frame Type      Frame Format        Frame ID    Length   Data\n\
                 0     Receive     21:11:45:171     Data frame     Standard frame     00000123     2     01 02\n\
                 1     Receive     21:11:45:191     Data frame     Extended frame     18fef100     8     01 02 03 04 \
                 05 06 07 ab\n",
        looks_like: tables::looks_like_usb_can,
        reader: || Box::new(EachLine(tables::read_usb_can)),
    },
    Format {
        name: "CarBus Analyzer trace",
        written_by: "CarBus Analyzer",
        times: "seconds since the start",
        holds: "channels, data frames",
        sample: "@ TEXT @ 3 @ 64 @ 0 @ 930 @ 1500 @ 00:00:01.500 @\n# $LocalTime=10:51:34.569\n\
                 55,038000\t1\t00000004\t123\t2\t01 02\t00000000\t\n\
                 55,058000\t1\t00000004\t18FEF100\t8\t01 02 03 04 05 06 07 AB\t00000000\t\n",
        looks_like: tables::looks_like_carbus,
        reader: || Box::new(EachLine(tables::read_carbus)),
    },
    Format {
        name: "numbered table",
        written_by: "a program whose tables begin with `CAN speed 1:`",
        times: "time of day",
        holds: "channels, data frames of 11 bits",
        sample: "",
        looks_like: tables::looks_like_numbered,
        reader: || Box::new(EachLine(tables::read_numbered)),
    },
    Format {
        name: "OVMS CRTD",
        written_by: "OVMS",
        times: "seconds since 1970",
        holds: "channels, data frames, errors",
        sample: "1632426775.935928 CXX OVMS CRTD\n1632426775.935928 CVR 3.0\n\
                 1632426782.045940 1R11 123 01 02\n\
                 1632426782.065940 1R29 18FEF100 01 02 03 04 05 06 07 ab\n",
        looks_like: crtd::looks_like,
        reader: || Box::new(EachLine(crtd::read)),
    },
    Format {
        name: "Battery-Emulator log",
        written_by: "Battery-Emulator, by way of a terminal",
        times: "seconds since the start, to hundredths or thousandths",
        holds: "channels, data frames",
        sample: "=~=~=~= PuTTY log 2025.05.22 15:02:22 =~=~=~=\n\
                 (683.70) RX0 123 [2] 01 02\n\
                 (683.72) TX1 18FEF100 [8] 01 02 03 04 05 06 07 AB\n",
        looks_like: terminals::looks_like_battery_emulator,
        reader: || Box::new(EachLine(terminals::read_battery_emulator)),
    },
    Format {
        name: "candump -l",
        written_by: "candump -l, candump -L, python-can, `cargo xtask run --record`",
        times: "seconds since 1970, or as -t says; dates are taken as UTC",
        holds: "channels, remote requests, errors, length codes of 9 to 15",
        sample: "(1436509052.249713) can0 123#0102\n(1436509052.269713) can0 18FEF100#01020304050607AB\n",
        looks_like: candump::looks_logged,
        reader: || Box::new(EachLine(candump::read_logged)),
    },
    Format {
        name: "Vector ASC",
        written_by: "CANoe, CANalyzer, loggers of several makers, can-utils, python-can",
        times: "seconds, as the head says: absolute or relative",
        holds: "channels, remote requests, errors, length codes of 9 to 15",
        sample: "date Sun Nov 22 10:00:00.000 am 2026\nbase hex  timestamps absolute\nno internal events logged\n\
                 Begin Triggerblock Sun Nov 22 10:00:00.000 am 2026\n\
                 \x20  0.000000 Start of measurement\n\
                 \x20  0.100000 1  123             Rx   d 2 01 02\n\
                 \x20  0.120000 1  18FEF100x       Rx   d 8 01 02 03 04 05 06 07 AB\nEnd TriggerBlock\n",
        looks_like: asc::looks_like,
        reader: || Box::new(asc::Asc::default()),
    },
    Format {
        name: "candump",
        written_by: "candump on the screen, with -a, -c, -e, -t, -x, -8",
        times: "as -t says; without it there are none",
        holds: "channels, remote requests, errors, length codes of 9 to 15",
        sample: " (1436509052.249713)  can0  123   [2]  01 02\n \
                 (1436509052.269713)  can0  18FEF100   [8]  01 02 03 04 05 06 07 AB\n",
        looks_like: candump::looks_shown,
        reader: || Box::new(candump::Shown::default()),
    },
    Format {
        name: "milliseconds table",
        written_by: "loggers on small boards: milliseconds, identifier, length, bytes",
        times: "milliseconds since the start",
        holds: "data frames",
        sample: "176487  123  2  1 2\n176507  18FEF100  8  1 2 3 4 5 6 7 AB\n",
        looks_like: terminals::looks_like_millis,
        reader: || Box::new(EachLine(terminals::read_millis)),
    },
];

/// A format that is told by the first bytes and not read.
struct Refused {
    name: &'static str,
    starts_with: &'static [u8],
    remedy: &'static str,
}

const REFUSED: &[Refused] = &[
    Refused {
        name: "ASAM MDF (MF4)",
        starts_with: b"MDF ",
        remedy: "convert it: `python3 -m can.logconvert IN.mf4 OUT.log`",
    },
    Refused { name: "a gzip archive", starts_with: b"\x1F\x8B", remedy: "unpack it: `gunzip`" },
    Refused { name: "a zip archive", starts_with: b"PK\x03\x04", remedy: "unpack it: `unzip`" },
    Refused {
        name: "a packet capture (pcapng)",
        starts_with: b"\x0A\x0D\x0D\x0A",
        remedy: "record with candump -l instead",
    },
];

impl Format {
    /// Returns the row of the format that a line is of, if it is of one.
    pub(super) fn of(line: &str) -> Option<&'static Self> {
        FORMATS.iter().find(|format| (format.looks_like)(line))
    }

    /// Returns what reads its lines.
    pub(super) fn reader(&self) -> Box<dyn ReadLine> {
        (self.reader)()
    }
}

/// Returns what to say of a file whose first bytes show a format that is not read.
pub(super) fn refusal(start: &[u8]) -> Option<String> {
    let refused = REFUSED.iter().find(|refused| start.starts_with(refused.starts_with))?;
    Some(format!("{}, which is not read here; {}", refused.name, refused.remedy))
}

/// Returns what to say of a file of no format that is known.
pub(super) fn unknown() -> String {
    let names: Vec<&str> = FORMATS.iter().map(|format| format.name).chain([BLF]).collect();
    format!("not a CAN log that is known here ({})", names.join(", "))
}
