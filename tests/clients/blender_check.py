"""Compares a picture of blender_scene.py's scene with what its custom properties ask for.

    python3 blender_check.py picture.exr

Everything follows from a pixel's direction and the object's velocity (c = 1, camera at rest at the
origin, its clock at 0): light that travelled Z left at time -Z from direction * Z.
"""

import math
import sys

from blender_exr import read_exr

FIELD_OF_VIEW = math.radians(30)

# Velocity; reference event (t, x, y, z); what the clock shows there, or None for "frame".
SQRT_3_4 = math.sqrt(0.75)  # the speed of gamma = 2
OBJECTS = {
    "away": ((0, 0, -0.6), (0, -2.5, 0, -10), 0),
    "towards": ((0, 0, 0.6), (0, 0, 0, -10), None),
    "across": ((0, SQRT_3_4, 0), (-10, 2.5, 0, -10), 0),
}
MOON = (0, 1.5, 0)  # of "away", from its origin


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def direction_of(x, y, width, height):
    """Unit vector from the camera through the pixel's centre."""
    up = math.tan(FIELD_OF_VIEW / 2)
    v = (up * (2 * x + 1 - width) / height, up * (height - 2 * y - 1) / height, -1.0)
    length = math.sqrt(dot(v, v))
    return tuple(c / length for c in v)


def boosted(beta, t, x):
    """The event (t, x) in the rest frame of beta."""
    square = dot(beta, beta)
    gamma = 1 / math.sqrt(1 - square)
    along = dot(beta, x)
    factor = (gamma - 1) * along / square - gamma * t
    return gamma * (t - along), tuple(a + factor * b for a, b in zip(x, beta))


class Checker:
    def __init__(self, path):
        self.width, self.height, self.rows, self.names = read_exr(path)
        self.faults = 0
        self.seen = {name: 0 for name in OBJECTS}
        self.moon = 0

    def expect(self, what, found, wanted, tolerance, x, y):
        if abs(found - wanted) <= tolerance * max(1.0, abs(wanted)):
            return
        self.faults += 1
        if self.faults <= 10:
            print(f"pixel {x},{y}: {what} is {found}, must be {wanted}")

    def check_color(self, name, x, y, cosine, clock):
        value = {c: self.rows[c][y][x] for c in "RGBA"}
        wanted = {"R": 0.0, "G": 0.0, "B": 0.0, "A": 1.0}
        if name == "away":
            wanted["R"] = cosine
        if name == "towards":
            phase = clock % 2.0
            if min(phase % 1.0, 1 - phase % 1.0) < 0.01:
                return  # at an edge, which is a thousandth of the light's way
            wanted["G" if phase < 1 else "B"] = 0.25 if phase < 1 else 0.5
        for channel in "RGBA":
            self.expect(f"{name}: {channel}", value[channel], wanted[channel], 2e-3, x, y)

    def check_pixel(self, x, y):
        index = int(self.rows["id_object.V"][y][x])
        if index == 0:
            return
        name = self.names[index - 1]
        beta, (t0, *x0), shown = OBJECTS[name]
        self.seen[name] += 1
        n, z = direction_of(x, y, self.width, self.height), self.rows["Z"][y][x]
        gamma = 1 / math.sqrt(1 - dot(beta, beta))
        doppler = 1 / (gamma * (1 + dot(beta, n)))
        self.expect(f"{name}: doppler.D", self.rows["doppler.D"][y][x], doppler, 1e-5, x, y)
        self.expect(f"{name}: world time", self.rows["time_world.V"][y][x], -z, 1e-5, x, y)
        time, place = boosted(beta, -z, tuple(z * c for c in n))
        time_0, place_0 = boosted(beta, t0, x0)
        clock = time if shown is None else time - time_0 + shown
        self.expect(f"{name}: clock", self.rows["time_proper.V"][y][x], clock, 1e-4, x, y)
        at = tuple(a - b for a, b in zip(place, place_0))
        for axis, letter in enumerate("XYZ"):
            found = self.rows[f"P.{letter}"][y][x]
            self.expect(f"{name}: P.{letter}", found, at[axis], 1e-4, x, y)
        self.check_shape(name, at, x, y)
        ray = boosted(beta, -1.0, n)[1]  # not of length one there
        normal = tuple(self.rows[f"N.{letter}"][y][x] for letter in "XYZ")
        self.check_color(name, x, y, -dot(ray, normal) / math.sqrt(dot(ray, ray)), clock)

    def check_shape(self, name, at, x, y):
        from_moon = math.dist(at, MOON)
        if name == "away" and from_moon < 0.21:
            self.moon += 1
            self.expect("moon: radius", from_moon, 0.2, 0.02, x, y)
        else:
            self.expect(f"{name}: radius", math.dist(at, (0, 0, 0)), 1, 0.01, x, y)

    def run(self):
        for y in range(self.height):
            for x in range(self.width):
                self.check_pixel(x, y)
        for name, count in {**self.seen, "moon": self.moon}.items():
            print(f"{name}: {count} pixels")
            if count < 3:
                self.faults += 1
        print(f"{self.faults} faults" if self.faults else "as the custom properties ask")
        return 1 if self.faults else 0


sys.exit(Checker(sys.argv[1]).run())
