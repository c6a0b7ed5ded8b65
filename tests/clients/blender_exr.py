"""Reads an uncompressed single-part EXR of scan lines, without libraries."""

import struct

SIZES = {0: ("I", 4), 1: ("e", 2), 2: ("f", 4)}  # uint, half, float


def text_at(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode(), end + 1


def read_header(data):
    """Attributes by name, and where they end."""
    magic, version = struct.unpack_from("<ii", data)
    if magic != 20000630 or version & ~0x400 != 2:  # 0x400: long names
        raise SystemExit("error: not a single-part EXR of scan lines")
    attributes, at = {}, 8
    while data[at] != 0:
        name, at = text_at(data, at)
        _, at = text_at(data, at)
        (size,) = struct.unpack_from("<i", data, at)
        attributes[name] = data[at + 4 : at + 4 + size]
        at += 4 + size
    return attributes, at + 1


def channels_of(attribute):
    channels, at = [], 0
    while attribute[at] != 0:
        name, at = text_at(attribute, at)
        channels.append((name, struct.unpack_from("<i", attribute, at)[0]))
        at += 16
    return channels


def strings_of(attribute):
    strings, at = [], 0
    while at < len(attribute):
        (size,) = struct.unpack_from("<i", attribute, at)
        strings.append(attribute[at + 4 : at + 4 + size].decode())
        at += 4 + size
    return strings


def read_exr(path):
    """Width, height, channels (rows of numbers from the top, by name), and the objects' names."""
    with open(path, "rb") as file:
        data = file.read()
    attributes, at = read_header(data)
    if attributes["compression"] != b"\0":
        raise SystemExit("error: the EXR is compressed")
    left, top, right, bottom = struct.unpack("<iiii", attributes["dataWindow"])
    width, height = right - left + 1, bottom - top + 1
    channels = channels_of(attributes["channels"])
    rows = {name: [None] * height for name, _ in channels}
    for offset in struct.unpack_from(f"<{height}Q", data, at):
        y = struct.unpack_from("<i", data, offset)[0] - top
        offset += 8
        for name, kind in channels:
            letter, size = SIZES[kind]
            rows[name][y] = struct.unpack_from(f"<{width}{letter}", data, offset)
            offset += size * width
    return width, height, rows, strings_of(attributes.get("objectNames", b""))
