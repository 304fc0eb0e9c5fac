"""Decodes every frame of a candump log with cantools and prints one JSON object per frame.

Usage: decode_log.py DBC LOG. Each object holds the identifier and, per signal, the raw value, the physical value, whether
it is valid and the word of the value table. All scaling is cantools' own; valid means within [minimum|maximum] and not the
raw value of the attribute SigInvalidRaw. Nothing here knows how our decoder works.
"""

import json
import sys

import can
import cantools


def is_valid(signal, raw, value):
    """The limits are decimals, the value is a float: half a unit in the ninth place is no difference."""
    invalid = signal.dbc.attributes.get("SigInvalidRaw")
    if invalid is not None and invalid.value >= 0 and invalid.value == raw:
        return False
    return signal.minimum - 1e-9 <= value <= signal.maximum + 1e-9


def main():
    database = cantools.database.load_file(sys.argv[1], encoding="utf-8", strict=True)
    messages = {(m.frame_id, m.is_extended_frame): m for m in database.messages}
    for frame in can.LogReader(sys.argv[2]):
        message = messages.get((frame.arbitration_id, frame.is_extended_id))
        if message is None:
            continue
        data = bytes(frame.data)
        raws = message.decode(data, decode_choices=False, scaling=False)
        values = message.decode(data, decode_choices=False)
        signals = {}
        for name, raw in raws.items():
            signal = message.get_signal_by_name(name)
            word = (signal.choices or {}).get(raw)
            signals[name] = {
                "raw": raw,
                "value": values[name],
                "valid": is_valid(signal, raw, values[name]),
                "word": None if word is None else str(word),
            }
        digits = 8 if frame.is_extended_id else 3
        print(json.dumps({"id": f"{frame.arbitration_id:0{digits}X}", "message": message.name, "signals": signals}))


main()
