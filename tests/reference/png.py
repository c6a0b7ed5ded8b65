"""PNG with the standard library alone: 8-bit grey, RGB and RGBA without interlacing are read, RGB is written."""

import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def chunks(data):
    at = len(SIGNATURE)
    while at < len(data):
        (length,) = struct.unpack_from(">I", data, at)
        yield data[at + 4:at + 8], data[at + 8:at + 8 + length]
        at += 12 + length


def paeth(left, above, corner):
    guess = left + above - corner
    distances = (abs(guess - left), abs(guess - above), abs(guess - corner))
    return (left, above, corner)[distances.index(min(distances))]


def unfilter(kind, row, above, step):
    for i, value in enumerate(row):
        left = row[i - step] if i >= step else 0
        corner = above[i - step] if i >= step else 0
        row[i] = value + (0, left, above[i], (left + above[i]) // 2,
                          paeth(left, above[i], corner))[kind] & 255
    return row


def read(path):
    """Rows of (red, green, blue, alpha) in 0..255."""
    data = path.read_bytes()
    parts = list(chunks(data))
    width, height, depth, kind, _, _, interlaced = struct.unpack(">IIBBBBB", parts[0][1])
    step = {0: 1, 2: 3, 6: 4}[kind]
    assert data.startswith(SIGNATURE) and depth == 8 and not interlaced, path
    packed = zlib.decompress(b"".join(body for name, body in parts if name == b"IDAT"))
    above, rows = bytearray(width * step), []
    for y in range(height):
        begin = y * (width * step + 1)
        above = unfilter(packed[begin], bytearray(packed[begin + 1:begin + 1 + width * step]), above, step)
        values = [above[i:i + step] for i in range(0, len(above), step)]
        rows.append([(*v[:3], v[3] if step == 4 else 255) if step > 1 else (v[0], v[0], v[0], 255)
                     for v in values])
    return rows


def filtered(row, above):
    """The row by the filter that leaves the smallest differences, as the specification advises."""
    tries = []
    for kind in range(5):
        out = bytearray()
        for i, value in enumerate(row):
            left = row[i - 3] if i >= 3 else 0
            corner = above[i - 3] if i >= 3 else 0
            out.append(value - (0, left, above[i], (left + above[i]) // 2,
                                paeth(left, above[i], corner))[kind] & 255)
        tries.append((sum(min(v, 256 - v) for v in out), bytes([kind]) + out))
    return min(tries)[1]


def written(width, height, pixels, kind=2):
    """Bytes of a PNG; pixels: width x height x 3 bytes (kind 2, RGB) or x 4 (kind 6, RGBA)."""
    line = width * (3 if kind == 2 else 4)
    rows = [bytes(pixels[i:i + line]) for i in range(0, line * height, line)]
    if kind == 2:
        packed = b"".join(filtered(row, rows[y - 1] if y else bytes(line)) for y, row in enumerate(rows))
    else:
        packed = b"".join(b"\0" + row for row in rows)
    body = SIGNATURE
    for name, content in ((b"IHDR", struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0)),
                          (b"IDAT", zlib.compress(packed, 9)), (b"IEND", b"")):
        body += struct.pack(">I", len(content)) + name + content
        body += struct.pack(">I", zlib.crc32(name + content))
    return body
