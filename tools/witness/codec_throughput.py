"""Prints how many frames cantools decodes per second.

Usage: codec_throughput.py DBC FRAMES

FRAMES holds one frame per line: name of the message and 16 hex digits. Numbers only: words for raw values would cost
cantools time that our decoder does not spend either.
"""

import sys
import time

import cantools

# Passes over the file; the best one counts, so that a busy machine does not make cantools look slow.
PASSES = 5


def main():
    database = cantools.database.load_file(sys.argv[1], encoding="utf-8", strict=True)
    with open(sys.argv[2], encoding="ascii") as lines:
        rows = [line.split() for line in lines]
    frames = [(database.get_message_by_name(name), bytes.fromhex(digits)) for name, digits in rows]
    best = float("inf")
    for _ in range(PASSES):
        started = time.perf_counter()
        for message, data in frames:
            message.decode(data, decode_choices=False)
        best = min(best, time.perf_counter() - started)
    print(round(len(frames) / best))


main()
