"""Writes the same frames with every writer of python-can. Usage: write_logs.py FOLDER."""

import sys

import can

FRAMES = [
    can.Message(timestamp=1_700_000_000 + n * 0.0125, arbitration_id=id, is_extended_id=extended, channel=0, **rest)
    for n, (id, extended, rest) in enumerate(
        [
            (0x123, False, {"data": b"\1\2"}),
            (0x18FEF100, True, {"data": b"\1\2\3\4\5\6\7\xab"}),
            (0x7FF, False, {"is_remote_frame": True, "dlc": 4}),
            (0x1, True, {"data": b""}),
            (0x124, False, {"is_fd": True, "data": bytes(12)}),
        ]
        + [(0x200 + n % 0x100, n % 3 == 0, {"data": n.to_bytes(2, "big") * (n % 5)}) for n in range(20_000)]
    )
]


def main():
    for ending in ("asc", "blf", "csv", "log", "trc"):
        with can.Logger(f"{sys.argv[1]}/python.{ending}") as logger:
            for frame in FRAMES:
                # Its CSV says nothing of CAN FD, its traces hold none.
                if not frame.is_fd or ending in ("asc", "blf", "log"):
                    logger(frame)


main()
