"""Decodes a candump log with cantools and prints the last value of every signal as JSON.

Usage: last_values.py DBC LOG [SECONDS]: only frames up to SECONDS after the first one count.
Physical values are scaled by cantools itself; nothing here knows how our decoder works.
"""

import json
import sys

import can
import cantools


def main():
    database = cantools.database.load_file(sys.argv[1], encoding="utf-8", strict=True)
    until = float(sys.argv[3]) if len(sys.argv) > 3 else float("inf")
    messages = {(m.frame_id, m.is_extended_frame): m for m in database.messages}
    values, first = {}, None
    for frame in can.LogReader(sys.argv[2]):
        first = frame.timestamp if first is None else first
        if frame.timestamp - first > until:
            break
        message = messages.get((frame.arbitration_id, frame.is_extended_id))
        if message is None:
            continue
        decoded = message.decode(bytes(frame.data), decode_choices=False)
        for signal, value in decoded.items():
            values[f"{message.name}.{signal}"] = value
    json.dump(values, sys.stdout)


main()
