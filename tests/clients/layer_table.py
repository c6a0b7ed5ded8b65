"""Which channels a layer has, as scenes/layers.md promises them, and pictures read without libraries."""

import numpy

from blender_exr import read_exr

LAYERS = {  # besides the beauty, which is half unless `beaming`; all of these are float
    "Z": ["Z"],
    "time": ["time_proper.V", "time_world.V"],
    "doppler": ["doppler.D"],
    "N": ["N.X", "N.Y", "N.Z"],
    "P": ["P.X", "P.Y", "P.Z"],
    "UV": ["UV.U", "UV.V", "UV.A"],
    "id": ["id_object.V", "id_material.V"],
    "variance": ["variance.R", "variance.G", "variance.B"],
    "samples": ["samples.V"],
}
BEAUTY = ["R", "G", "B", "A"]
MATTES = ()  # Cryptomatte's layers


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
    def __init__(self):
        self.faults = 0

    def say(self, good, line):
        self.faults += not good
        print(f"{'ok' if good else 'FAULT'}: {line}", flush=True)
