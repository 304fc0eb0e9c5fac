"""Decodes a log of the virtual vehicle strictly with cantools and prints every value; the first fault ends it.

Usage: vehicle_log.py DBC LOG. One line per value: number of the frame from 0, message, signal and physical value, apart
by tabs; "-" = not available. A frame must be known, of full length, every raw value within [minimum|maximum] or the raw
value of SigInvalidRaw, every bit that no signal uses 0, or of the byte FillByte where a whole byte is free; and each
message must come at its GenMsgCycleTime. Nothing here knows how the vehicle encodes.
"""

import sys

import can
import cantools

LATE = 0.002
"""How much later than its cycle a frame may come, in seconds."""


def fill_of(database, message):
    own = message.dbc.attributes.get("FillByte")
    return database.dbc.attribute_definitions["FillByte"].default_value if own is None else own.value


def is_valid(signal, value):
    """The limits are decimals, the value is a float: half a unit in the ninth place is no difference."""
    return signal.minimum - 1e-9 <= value <= signal.maximum + 1e-9


def is_unavailable(signal, raw):
    invalid = signal.dbc.attributes.get("SigInvalidRaw")
    return invalid is not None and invalid.value >= 0 and invalid.value == raw


def check_fill(message, raws, data, fill, where):
    """Bits that differ between zero and one padding belong to no signal."""
    bare = message.encode(raws, scaling=False, strict=False, padding=False)
    padded = message.encode(raws, scaling=False, strict=False, padding=True)
    if message.is_multiplexed():
        # What the other multiplexer values use is not free.
        used = 0
        for signal in message.signals:
            used |= ((1 << signal.length) - 1) << signal.start if signal.byte_order == "little_endian" else 0
        free_bytes = [~(used >> 8 * place) & 0xFF for place in range(8)]
    else:
        free_bytes = [a ^ b for a, b in zip(bare, padded)]
    for place, (byte, free) in enumerate(zip(data, free_bytes)):
        expected = fill if free == 0xFF else 0
        if byte & free != expected & free:
            raise SystemExit(f"{where}: byte {place} is {byte:02X}, its free bits {free:02X}")
        if byte & ~free & 0xFF != bare[place] & ~free & 0xFF:
            raise SystemExit(f"{where}: byte {place} is {byte:02X}, cantools writes {bare[place]:02X}")


def main():
    database = cantools.database.load_file(sys.argv[1], encoding="utf-8", strict=True)
    messages = {(m.frame_id, m.is_extended_frame): m for m in database.messages}
    last = {}
    out = []
    for number, frame in enumerate(can.LogReader(sys.argv[2])):
        message = messages.get((frame.arbitration_id, frame.is_extended_id))
        if message is None:
            raise SystemExit(f"frame {number}: {frame.arbitration_id:08X} is not in {sys.argv[1]}")
        where = f"frame {number}: {message.name} {frame.data.hex()}"
        data = bytes(frame.data)
        if len(data) != message.length:
            raise SystemExit(f"{where}: {len(data)} bytes, not {message.length}")
        raws = message.decode(data, decode_choices=False, scaling=False, allow_truncated=False)
        values = message.decode(data, decode_choices=False, allow_truncated=False)
        for name, raw in raws.items():
            signal = message.get_signal_by_name(name)
            missing = is_unavailable(signal, raw)
            if not missing and not is_valid(signal, values[name]):
                raise SystemExit(f"{where}: {name} = {values[name]} is not within its limits")
            out.append(f"{number}\t{message.name}\t{name}\t{'-' if missing else repr(float(values[name]))}")
        check_fill(message, raws, data, fill_of(database, message), where)
        gap = frame.timestamp - last.get(message.name, frame.timestamp)
        if gap > message.cycle_time / 1000 + LATE:
            raise SystemExit(f"{where}: {gap:.4f} s after the last, not {message.cycle_time} ms")
        last[message.name] = frame.timestamp
    print("\n".join(out))


main()
