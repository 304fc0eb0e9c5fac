"""Reads a recording a second time and prints every classic frame; what cannot be read ends it with its error.

Usage: read_log.py FILE FORMAT, the format by the name that `cargo xtask` gives it. python-can reads the formats that it
knows; the others are read here by one regular expression each. One line per frame: microseconds since the first one,
identifier, s or x for 11 or 29 bits, d or r for data or a remote request, channel, length and data, apart by blanks.
Frames of CAN FD and errors are left out; a time that is not known is "-". Nothing here knows how the recording was read otherwise.
"""

import datetime
import re
import sys

import can

READERS = {
    "candump -l": can.CanutilsLogReader,
    "Vector ASC": lambda path: can.ASCReader(path, relative_timestamp=True),
    "PCAN trace": can.TRCReader,
    "python-can CSV": can.CSVReader,
    "Vector BLF": can.BLFReader,
}
"""What python-can reads."""

HEX = "[0-9A-Fa-f]+"
DATA = r"(?P<data>(?:[0-9A-Fa-f]{1,2}(?:[\s,]+|$))*)"

PATTERNS = {
    "GVRET CSV": (rf"(?P<time>-?\d+),(?P<id>{HEX}),(?P<bits>\w+),(?:[RT]x,)?(?P<channel>\d+),(?P<length>\d+),{DATA}", 1),
    "ParserFlags table": (
        rf"\d+\t(?P<channel>\d+)\t\d+\t[RT]X\t(?P<time>\d+)\t\t0x(?P<id>{HEX})\t(?P<length>\d+)\t0x{DATA}",
        1000,
    ),
    "USB-CAN table": (
        rf"\d+\W+\w+\W+(?P<time>[\d:]+)\W+Data frame\W+(?P<bits>\w+) frame\W+(?P<id>{HEX})\W+(?P<length>\d)\W+{DATA}",
        1,
    ),
    "CarBus Analyzer trace": (rf"(?P<time>\d+,\d+)\t(?P<channel>\d+)\t\w+\t(?P<id>{HEX})\t(?P<length>\d)\t{DATA}", 1e6),
    "OVMS CRTD": (rf"(?P<time>[\d.]+) (?P<channel>\d?)[RT](?P<bits>11|29) (?P<id>{HEX}) {DATA}", 1e6),
    "Battery-Emulator log": (rf"\((?P<time>[\d.]+)\) (?P<channel>[RT]X\d) (?P<id>{HEX}) \[(?P<length>\d)\] {DATA}", 1e6),
    "milliseconds table": (rf"(?P<time>\d+)\s+(?P<id>{HEX})\s+(?P<length>\d)\s+{DATA}$", 1000),
    "candump": (rf"\s*(?:\((?P<time>[^)]+)\))?\s+(?P<channel>\w+)\s+(?P<id>{HEX})\s+\[(?P<length>\d)\]\s+{DATA}", 1e6),
    "numbered table": (
        rf">\t\d+\t +(?P<time>[\d:.]+):\d+\.\d+\tSt\t0x(?P<id>{HEX})\t0\t(?P<length>\d)\t{DATA}.*p:(?P<channel>\d)",
        1,
    ),
}
"""The others: a frame as a regular expression, and how many microseconds a unit of its time is."""


def micros_of(text, unit):
    """A time in microseconds; None where there is none."""
    if text is None:
        return None
    if "-" in text[1:]:
        return datetime.datetime.fromisoformat(text + "+00:00").timestamp() * 1e6
    if ":" in text:
        hours, minutes, seconds, millis = map(int, re.split("[:.]", text))
        return ((hours * 60 + minutes) * 60 + seconds) * 1_000_000 + millis * 1000
    return float(text.replace(",", ".")) * unit


def adds_no_gaps_up(path, name):
    """python-can takes the gaps of a file with relative times for times."""
    return name == "Vector ASC" and "timestamps relative" in open(path, errors="replace").read(4096)


def by_python_can(path, name):
    is_clock = not adds_no_gaps_up(path, name)
    for frame in READERS[name](path):
        if not frame.is_error_frame and not frame.is_fd:
            channel = "-" if frame.channel is None else frame.channel
            kind = "r" if frame.is_remote_frame else "d"
            micros = frame.timestamp * 1e6 if is_clock else None
            # It makes lengths of CAN FD of the codes 9 to 15 in some formats.
            code = can.util.len2dlc(frame.dlc) if frame.dlc > 15 else frame.dlc
            yield micros, frame.arbitration_id, frame.is_extended_id, kind, channel, code, bytes(frame.data)


def by_pattern(path, name):
    pattern, unit = PATTERNS[name]
    pattern = re.compile(pattern)
    for line in open(path, encoding="utf-8-sig", errors="replace"):
        match = pattern.match(line.replace("\0", " ").rstrip())
        if match is None:
            continue
        got = match.groupdict()
        data = bytes(int(byte, 16) for byte in re.split(r"[\s,]+", got["data"].strip(" ,\t")) if byte)
        length = int(got.get("length") or len(data))
        identifier = int(got["id"], 16)
        if identifier > 0x1FFFFFFF:
            # candump marks an error so.
            continue
        bits = got.get("bits")
        extended = identifier > 0x7FF if bits is None else bits.lower() in ("true", "1", "29", "extended")
        channel = got.get("channel") or "-"
        if channel[:2] in ("RX", "TX"):
            # Battery-Emulator: one bus has an even number for what it hears and the odd one behind it for what it sends.
            channel = int(channel[2:]) // 2
        yield micros_of(got["time"], unit), identifier, extended, "d", channel, length, data[:length]


def main():
    path, name = sys.argv[1:]
    if name not in READERS and name not in PATTERNS:
        raise SystemExit("no second reader")
    print("python-can" if name in READERS else "pattern")
    first = None
    for micros, identifier, extended, kind, channel, length, data in (by_python_can if name in READERS else by_pattern)(
        path, name
    ):
        first = micros if first is None else first
        bits = "x" if extended else "s"
        print("-" if micros is None else round(micros - first), f"{identifier:X}", bits, kind, channel, length, data.hex() or "-")


main()
