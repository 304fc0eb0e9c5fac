"""Says what cantools makes of a DBC file: every signal's row, and raw values of many frames, as one binary stream.

Usage: decode_witness.py DBC [RANDOM_FRAMES] [SEED]

First line: JSON with the rows of all messages; fractions are texts "numerator/denominator". Then blocks, little-endian:
u32 message index, u32 number of frames, u8 kind (0 = random bytes decoded, 1 = raw values encoded), and per frame the
8 bytes (cut frames are filled with zeros) and one i64 per signal; a signal that is not in the frame is ABSENT.

Kind 1 sweeps: all signals of a message step at once, each through its whole range in its own order, so that 65536
frames hold every raw value of every signal of up to 16 bits. Nothing here knows how our decoder works.
"""

import json
import random
import struct
import sys
from fractions import Fraction

import cantools

ABSENT = -(2**63)


def fraction(number):
    """The decimal that stands in the file: repr gives the shortest text that reads back as the same float."""
    exact = Fraction(repr(number)) if isinstance(number, float) else Fraction(number)
    return f"{exact.numerator}/{exact.denominator}"


def row(signal):
    return {
        "name": signal.name,
        "start": signal.start,
        "length": signal.length,
        "intel": signal.byte_order == "little_endian",
        "signed": signal.is_signed,
        "scale": fraction(signal.scale),
        "offset": fraction(signal.offset),
        "minimum": None if signal.minimum is None else fraction(signal.minimum),
        "maximum": None if signal.maximum is None else fraction(signal.maximum),
        "unit": signal.unit or "",
        "selector": signal.is_multiplexer,
        "when": signal.multiplexer_ids[0] if signal.multiplexer_ids else None,
        "words": sorted((raw, str(word)) for raw, word in (signal.choices or {}).items()),
    }


def decoded(message, names, data):
    """Raw values in the order of names, or None where cantools knows no such multiplex value."""
    try:
        values = message.decode(data[: message.length], decode_choices=False, scaling=False)
    except cantools.database.errors.DecodeError:
        return None
    return [values.get(name, ABSENT) for name in names]


def sweep(message, signals, random_source):
    """Yields raw values: every signal of up to 16 bits meets each of its raw values."""
    longest = max((min(signal.length, 16) for signal in signals), default=0)
    # An odd step is a bijection of 0 .. 2**length - 1.
    steps = [(random_source.randrange(1, 2**16, 2), random_source.randrange(2**16)) for _ in signals]
    selector = next((signal for signal in signals if signal.is_multiplexer), None)
    known = sorted({signal.multiplexer_ids[0] for signal in signals if signal.multiplexer_ids})
    for count in range(max(2**longest, 256)):
        values = {}
        for signal, (step, first) in zip(signals, steps):
            if signal.length > 16:
                raw = random_source.getrandbits(signal.length)
            else:
                raw = (count * step + first) % 2**signal.length
            values[signal.name] = raw - 2**signal.length if signal.is_signed and raw >> signal.length - 1 else raw
        if selector is not None:
            values[selector.name] = known[count % len(known)]
            carried = [None, known[count % len(known)]]
            for signal in signals:
                if (signal.multiplexer_ids or [None])[0] not in carried:
                    del values[signal.name]
        yield values


def block(out, index, kind, frames):
    if frames:
        out.write(struct.pack("<IIB", index, len(frames), kind) + b"".join(frames))


def main():
    database = cantools.database.load_file(sys.argv[1], encoding="utf-8", strict=True)
    budget = int(sys.argv[2]) if len(sys.argv) > 2 else 1_000_000
    random_source = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 20221122)
    out = sys.stdout.buffer
    rows = [
        {
            "name": message.name,
            "id": message.frame_id,
            "extended": message.is_extended_frame,
            "length": message.length,
            "sender": message.senders[0] if message.senders else "",
            "cycle": message.cycle_time or 0,
            "signals": [row(signal) for signal in message.signals],
        }
        for message in database.messages
    ]
    out.write(json.dumps(rows).encode() + b"\n")
    for index, message in enumerate(database.messages):
        signals = message.signals
        names = [signal.name for signal in signals]
        pack = struct.Struct(f"<8s{len(names)}q").pack
        frames = []
        for _ in range(budget // len(database.messages)):
            data = random_source.randbytes(8)
            values = decoded(message, names, data)
            if values is not None:
                frames.append(pack(data, *values))
        block(out, index, 0, frames)
        frames = []
        for values in sweep(message, signals, random_source):
            data = message.encode(values, scaling=False, strict=False)
            back = decoded(message, names, data)
            if back != [values.get(name, ABSENT) for name in names]:
                raise SystemExit(f"{message.name}: cantools does not read back what it wrote: {values}")
            frames.append(pack(data, *back))
        block(out, index, 1, frames)


main()
