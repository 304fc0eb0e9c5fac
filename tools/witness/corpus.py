"""Says what cantools makes of any DBC file, for `cargo xtask corpus`: one JSON object per line.

Usage: corpus.py ENCODING FRAMES < list of paths. cantools is asked leniently (strict=False). First line of a file: `{"file", "error"}`
with the first line of its complaint, or null. Then one line per frame: identifier, 29 bits or not, bytes, and of each signal
that is in the frame its raw value (of a float: its value) and its physical value. Frames are random bytes, and for each
multiplexer each value that a signal names. Nothing here knows how our decoder works.
"""

import json
import random
import sys

import cantools


def pages(message):
    """Multiplexer values that signals name, by name of the multiplexer."""
    named = {}
    for signal in message.signals:
        for value in signal.multiplexer_ids or []:
            named.setdefault(signal.multiplexer_signal, set()).add(value)
    return {name: sorted(values) for name, values in named.items() if name}


def frames(message, count, source):
    known = pages(message)
    for number in range(max(count, 3 * max((len(values) for values in known.values()), default=0))):
        data = bytearray(source.randbytes(message.length))
        if number == 0:
            data = bytearray(message.length)
        if number == 1:
            data = bytearray(b"\xff" * message.length)
        for name, values in known.items():
            selector = message.get_signal_by_name(name)
            put(selector, data, values[number % len(values)])
        yield bytes(data)


def put(signal, data, raw):
    """Writes the bits of a multiplexer; the bit numbers are those of the DBC."""
    bit = signal.start
    for place in range(signal.length) if signal.byte_order == "little_endian" else reversed(range(signal.length)):
        mask = 1 << bit % 8
        data[bit // 8] = data[bit // 8] | mask if raw >> place & 1 else data[bit // 8] & ~mask
        if signal.byte_order == "little_endian":
            bit += 1
        else:
            bit = bit + 15 if bit % 8 == 0 else bit - 1


def decoded(message, data):
    try:
        raws = message.decode(data, decode_choices=False, scaling=False)
        values = message.decode(data, decode_choices=False)
    except Exception:  # cantools knows no such multiplexer value, or cannot read a signal beyond the frame
        return None
    # A NaN or an infinity is no JSON.
    plain = lambda number: number if number == number and abs(number) != float("inf") else str(number)
    return {name: [plain(raw), plain(values[name])] for name, raw in raws.items()}


def main():
    count = int(sys.argv[2])
    source = random.Random(20221122)
    for path in sys.stdin.read().splitlines():
        try:
            database = cantools.database.load_file(path, encoding=sys.argv[1], strict=False)
        except Exception as error:
            print(json.dumps({"file": path, "error": str(error).splitlines()[0]}))
            continue
        print(json.dumps({"file": path, "error": None}))
        for message in database.messages:
            if message.length > 8:
                continue
            for data in frames(message, count, source):
                signals = decoded(message, data)
                if signals is not None:
                    row = {"id": message.frame_id, "extended": message.is_extended_frame}
                    print(json.dumps({**row, "name": message.name, "data": data.hex(), "signals": signals}))


main()
