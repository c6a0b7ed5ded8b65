"""Which channels a layer has, as scenes/layers.md promises them, and pictures read without libraries."""

import numpy

from blender_exr import read_exr


def of_letters(name, letters):
    return [f"{name}.{letter}" for letter in letters]


BEAUTY = ["R", "G", "B", "A"]
GROUPS = ("lamp", "rest", "sky")  # of layers.toml's lights
MATTES = ("crypto_object", "crypto_material", "crypto_asset")
LAYERS = {  # of layers.toml, besides the beauty
    "Z": ["Z"],
    "depth": ["depth.Z"],
    "time": ["time_proper.V", "time_world.V"],
    "doppler": ["doppler.D"],
    "N": of_letters("N", "XYZ"),
    "normal": of_letters("normal", "XYZ"),
    "P": of_letters("P", "XYZ"),
    "UV": of_letters("UV", "UVA"),
    "motion": of_letters("motion", "UVA"),
    "id": ["id_object.V", "id_material.V"],
    "variance": of_letters("variance", "RGB"),
    "samples": ["samples.V"],
    **{way: of_letters(way, "RGB") for way in
       ("emission", "direct", "indirect", "reflection", "transmission", "albedo")},
    "lights": [channel for group in GROUPS for channel in of_letters(f"light_{group}", "RGB")],
    **{layer: [channel for number in range(3) for channel in of_letters(f"{layer}{number:02}", "RGBA")]
       for layer in MATTES},
}


VIEWS = ("left", "right")  # the first is the file's default, whose R G B A Z have no name before them


def name_in_view(name, view):
    """As OpenEXR's rules for several views have it: the view before the last dot."""
    layer, dot, letter = name.rpartition(".")
    if not dot:
        return name if view == VIEWS[0] else f"{view}.{name}"
    return f"{layer}.{view}.{letter}"


def of_view(planes, view):
    """The channels of one eye, by the names that they have alone."""
    names = [name for layer in LAYERS.values() for name in layer] + BEAUTY
    return {name: planes[name_in_view(name, view)] for name in names}


def planes_of(path):
    """Channels of an uncompressed picture as arrays, by name, and the names of its objects."""
    _, _, rows, names = read_exr(path)
    return {name: numpy.array(values, dtype=numpy.float64) for name, values in rows.items()}, names


def mean_of(plane):
    """Of what is finite: nothing is infinitely far."""
    return plane[numpy.isfinite(plane)].mean()


def likeness(good):
    return "every pixel alike" if good else "pixels differ"


class Report:
    def __init__(self, who):
        self.who, self.faults = who, 0

    def say(self, good, line):
        self.faults += not good
        print(f"{'ok' if good else 'FAULT'}: {self.who}: {line}", flush=True)

    def compare(self, what, theirs, ours):
        """Pairs of planes: to the bit, and with their means."""
        good = len(theirs) == len(ours) and all(map(numpy.array_equal, theirs, ours))
        means = ", ".join(f"{mean_of(a):.6g}/{mean_of(b):.6g}" for a, b in zip(theirs, ours))
        self.say(good, f"{what}: {likeness(good)}; means theirs/ours {means}")
