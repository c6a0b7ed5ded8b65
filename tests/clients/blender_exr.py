"""Reads and writes uncompressed single-part EXRs of scan lines, without libraries."""

import struct

SIZES = {0: ("I", 4), 1: ("e", 2), 2: ("f", 4)}  # uint, half, float


def text_at(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode(), end + 1


class Attribute(bytes):
    """A value's bytes, and which type they are of."""


def read_header(data):
    """Attributes by name, and where they end."""
    magic, version = struct.unpack_from("<ii", data)
    if magic != 20000630 or version & ~0x400 != 2:  # 0x400: long names
        raise SystemExit("error: not a single-part EXR of scan lines")
    attributes, at = {}, 8
    while data[at] != 0:
        name, at = text_at(data, at)
        kind, at = text_at(data, at)
        (size,) = struct.unpack_from("<i", data, at)
        attributes[name] = Attribute(data[at + 4 : at + 4 + size])
        attributes[name].kind = kind
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


NUMBERS = {"v3d": "<3d", "v2f": "<2f", "double": "<d", "float": "<f", "int": "<i", "m44f": "<16f"}


def read_attributes(path):
    """Those of numbers and texts, by name; lists of what has several."""
    with open(path, "rb") as file:
        data = file.read()
    attributes, _ = read_header(data)
    read = {}
    for name, value in attributes.items():
        kind = value.kind
        if kind in NUMBERS:
            numbers = list(struct.unpack(NUMBERS[kind], value))
            read[name] = numbers if len(numbers) > 1 else numbers[0]
        elif kind == "string":
            read[name] = value.decode()
    return read


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


def attribute_bytes(name, kind, value):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value


def write_exr(path, rows):
    """rows: numbers by channel (names in order), from the top."""
    height, width = len(next(iter(rows.values()))), len(next(iter(rows.values()))[0])
    channels = b"".join(name.encode() + b"\0" + struct.pack("<iiii", 2, 0, 1, 1) for name in rows)
    window = struct.pack("<iiii", 0, 0, width - 1, height - 1)
    head = struct.pack("<ii", 20000630, 2)
    for name, kind, value in (
            ("channels", "chlist", channels + b"\0"), ("compression", "compression", b"\0"),
            ("dataWindow", "box2i", window), ("displayWindow", "box2i", window),
            ("lineOrder", "lineOrder", b"\0"), ("pixelAspectRatio", "float", struct.pack("<f", 1)),
            ("screenWindowCenter", "v2f", struct.pack("<ff", 0, 0)),
            ("screenWindowWidth", "float", struct.pack("<f", 1))):
        head += attribute_bytes(name, kind, value)
    head += b"\0"
    size = 4 * width * len(rows)
    with open(path, "wb") as file:
        file.write(head)
        for y in range(height):
            file.write(struct.pack("<Q", len(head) + 8 * height + y * (8 + size)))
        for y in range(height):
            file.write(struct.pack("<ii", y, size))
            for name in rows:
                file.write(struct.pack(f"<{width}f", *rows[name][y]))
