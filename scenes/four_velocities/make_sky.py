#!/usr/bin/env python3
"""Makes evening.exr: a clear sky with a low sun over dark ground, latitude and longitude.

    scenes/four_velocities/make_sky.py evening.exr

Radiance is linear Rec. 709, about 1 at the horizon. Rows go from +y (up) to -y.
"""

import math
import struct
import sys
import zlib

WIDTH, HEIGHT = 512, 256
SUN_HEIGHT, SUN_COLUMN = math.radians(9), 0.68  # above the horizon; fraction of the width
ZENITH, HORIZON, GROUND = (0.09, 0.2, 0.55), (1.0, 0.78, 0.55), (0.07, 0.055, 0.045)
GLOW, SUN = (1.3, 0.62, 0.22), (900.0, 640.0, 330.0)


def mixed(a, b, t):
    return [x + (y - x) * t for x, y in zip(a, b)]


def step(x):
    """From 0 to 1 around 0."""
    return 0.5 + 0.5 * math.tanh(0.5 * x)


def radiance(row, column):
    height = math.pi * (0.5 - (row + 0.5) / HEIGHT)
    turn = 2 * math.pi * ((column + 0.5) / WIDTH - SUN_COLUMN)
    cosine = (math.sin(height) * math.sin(SUN_HEIGHT)
              + math.cos(height) * math.cos(SUN_HEIGHT) * math.cos(turn))
    away = math.acos(max(-1.0, min(1.0, cosine)))
    sky = mixed(HORIZON, ZENITH, 1 - (1 - max(0.0, math.sin(height))) ** 4)
    color = mixed(GROUND, sky, step(height / 0.006))
    for i in range(3):
        color[i] += GLOW[i] * (math.exp(-away / 0.35) + 4 * math.exp(-away / 0.06)) * (height > 0)
        color[i] += SUN[i] * step((0.022 - away) / 0.003)
    return color


def scan_lines(first):
    """Up to 16 rows as EXR holds them: a row's channels one after another, B G R, in half floats."""
    data = bytearray()
    for row in range(first, min(first + 16, HEIGHT)):
        line = [radiance(row, column) for column in range(WIDTH)]
        for channel in (2, 1, 0):
            data += struct.pack(f"<{WIDTH}e", *(color[channel] for color in line))
    return bytes(data)


def zipped(data):
    """OpenEXR's ZIP: bytes of even places first, differences, then zlib."""
    parted = data[0::2] + data[1::2]
    coded = bytearray(parted)
    for i in range(len(parted) - 1, 0, -1):
        coded[i] = (parted[i] - parted[i - 1] + 128) & 255
    packed = zlib.compress(bytes(coded), 9)
    return packed if len(packed) < len(data) else data


def attribute(name, kind, value):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value


def header():
    channels = b"".join(name + b"\0" + struct.pack("<iiii", 1, 0, 1, 1) for name in (b"B", b"G", b"R"))
    window = struct.pack("<iiii", 0, 0, WIDTH - 1, HEIGHT - 1)
    return b"".join([
        struct.pack("<ii", 20000630, 2),
        attribute("channels", "chlist", channels + b"\0"),
        attribute("compression", "compression", b"\3"),
        attribute("dataWindow", "box2i", window),
        attribute("displayWindow", "box2i", window),
        attribute("lineOrder", "lineOrder", b"\0"),
        attribute("pixelAspectRatio", "float", struct.pack("<f", 1.0)),
        attribute("screenWindowCenter", "v2f", struct.pack("<ff", 0.0, 0.0)),
        attribute("screenWindowWidth", "float", struct.pack("<f", 1.0)),
        b"\0"])


def main():
    head = header()
    blocks = [(first, zipped(scan_lines(first))) for first in range(0, HEIGHT, 16)]
    place = len(head) + 8 * len(blocks)
    offsets = b""
    for _, data in blocks:
        offsets += struct.pack("<Q", place)
        place += 8 + len(data)
    with open(sys.argv[1], "wb") as file:
        file.write(head + offsets)
        for first, data in blocks:
            file.write(struct.pack("<ii", first, len(data)) + data)


main()
