"""Joins the bench's bus as python-can joins any serial adapter's, and says as JSON what it heard.

Usage: join_bus.py TERMINAL DBC BITRATE FRAMES COUNT MESSAGE SIGNAL=VALUE...

Hears FRAMES frames and decodes them with cantools; then sends MESSAGE, encoded by cantools, COUNT times; a signal called
`life` counts up. Nothing here knows how our codecs or our adapter work.
"""

import json
import sys
import time

import can
import cantools

# Only ends a wait that would never end.
PATIENCE = 120


def main():
    terminal, dbc, bitrate, wanted, count, name, *assignments = sys.argv[1:]
    database = cantools.database.load_file(dbc, encoding="utf-8", strict=True)
    messages = {(m.frame_id, m.is_extended_frame): m for m in database.messages}
    bus = can.Bus(interface="slcan", channel=terminal, bitrate=int(bitrate), sleep_after_open=0)
    version, serial = bus.get_version(PATIENCE), bus.get_serial_number(PATIENCE)

    heard, counts, frames = {}, {}, 0
    end = time.monotonic() + PATIENCE
    while frames < int(wanted) and time.monotonic() < end:
        frame = bus.recv(timeout=1)
        if frame is None:
            continue
        frames += 1
        message = messages[(frame.arbitration_id, frame.is_extended_id)]
        counts[message.name] = counts.get(message.name, 0) + 1
        for signal, value in message.decode(bytes(frame.data), decode_choices=False).items():
            heard[f"{message.name}.{signal}"] = value

    message = database.get_message_by_name(name)
    values = {signal.name: 0 for signal in message.signals}
    values.update((signal, float(value)) for signal, value in (text.split("=") for text in assignments))
    for life in range(int(count)):
        if "life" in values:
            values["life"] = life % 256
        data = message.encode(values, scaling=True, strict=True)
        bus.send(can.Message(arbitration_id=message.frame_id, is_extended_id=message.is_extended_frame, data=data))
    bus.shutdown()
    json.dump({"version": version, "serial": serial, "frames": frames, "counts": counts, "heard": heard}, sys.stdout)


main()
