"""Cryptomatte 1.2 as its specification has it, from the name of a thing to its matte."""

import json
import struct

import numpy

MASK = 0xFFFFFFFF


def rotated(x, by):
    return ((x << by) | (x >> (32 - by))) & MASK


def murmur3(data):
    """MurmurHash3_x86_32 of bytes, seed 0 (Austin Appleby's algorithm)."""
    def scrambled(block):
        return rotated(block * 0xCC9E2D51 & MASK, 15) * 0x1B873593 & MASK

    state, whole = 0, len(data) // 4 * 4
    for at in range(0, whole, 4):
        state ^= scrambled(int.from_bytes(data[at:at + 4], "little"))
        state = (rotated(state, 13) * 5 + 0xE6546B64) & MASK
    if data[whole:]:
        state ^= scrambled(int.from_bytes(data[whole:], "little"))
    state ^= len(data)
    for shift, factor in ((16, 0x85EBCA6B), (13, 0xC2B2AE35)):
        state = (state ^ (state >> shift)) * factor & MASK
    return state ^ (state >> 16)


assert murmur3(b"bunny") == 0x13851A76  # in a manifest of the specification


def id_of(name):
    """The hash, kept from being a denormal, an infinity or no number as a float."""
    value = murmur3(name.encode())
    return value ^ (1 << 23) if (value >> 23) & 255 in (0, 255) else value


def as_float(value):
    return struct.unpack("<f", struct.pack("<I", value))[0]


def key_of(layer):
    """What the layer's attributes begin with."""
    return f"cryptomatte/{murmur3(layer.encode()):08x}"[:len("cryptomatte/") + 7] + "/"


def ranks_of(planes, layer):
    """Pairs of ids and coverages."""
    number = 0
    while f"{layer}{number:02}.R" in planes:
        for id_letter, coverage_letter in ("RG", "BA"):
            yield planes[f"{layer}{number:02}.{id_letter}"], planes[f"{layer}{number:02}.{coverage_letter}"]
        number += 1


def matte_of(planes, layer, name):
    value = as_float(id_of(name))
    return sum(numpy.where(ids == value, coverage, 0) for ids, coverage in ranks_of(planes, layer))


def faults_of(attributes, layer, names):
    """What is not as the specification wants it."""
    key, faults = key_of(layer), []
    for attribute, wanted in (("name", layer), ("hash", "MurmurHash3_32"),
                              ("conversion", "uint32_to_float32")):
        if attributes.get(key + attribute) != wanted:
            faults.append(f"{key}{attribute} is {attributes.get(key + attribute)}, must be {wanted}")
    manifest = json.loads(attributes.get(key + "manifest", "{}"))
    wanted = {name: f"{id_of(name):08x}" for name in names}
    if manifest != wanted:
        faults.append(f"the manifest is {manifest}, must be {wanted}")
    return faults
