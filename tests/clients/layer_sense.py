"""What the numbers of a picture of layers.toml mean: held against geometry, physics and each other.

Pictures come as channels by name (arrays), however they were read.
"""

import numpy

import cryptomatte

EYE, AIM = numpy.array([1, 0.5, 6]), numpy.array([0.2, 0, 0])
AT_REST = {"veil": (1.1, 0.3, 0.4), "bühne": (0, -1, -1)}  # where they are
FLYING, VELOCITY = "flying ball", numpy.array([0.6, 0, 0.1])
RATE, TIME = 12, 0.25
NAMES = {  # in the manifests
    "crypto_object": ["bühne", "flying ball", "veil"],
    "crypto_material": ["default", "red paint", "veil"],
    "crypto_asset": ["bühne", "flying ball", "veil"],
}
WAYS = ("emission", "direct", "indirect", "reflection", "transmission")


def vectors(planes, layer, at, letters="XYZ"):
    return numpy.stack([planes[f"{layer}.{letter}"][at] for letter in letters], axis=1)


def where(planes, names, name):
    return numpy.nonzero(planes["id_object.V"] == names.index(name) + 1)


class Camera:
    """As the picture's header has it: matrices for rows."""

    def __init__(self, to_camera, to_film, shape):
        self.to_camera, self.to_film = (numpy.array(m, dtype=float).reshape(4, 4)
                                        for m in (to_camera, to_film))
        self.height, self.width = shape

    def in_camera(self, points):
        return (numpy.column_stack([points, numpy.ones(len(points))]) @ self.to_camera)[:, :3]

    def pixels(self, points):
        """Right and down from the picture's upper left corner."""
        film = numpy.column_stack([points, numpy.ones(len(points))]) @ self.to_film
        return film[:, :2] / film[:, 3:] * (self.width, self.height)


def check_camera(report, camera):
    """The eye at the origin, the aim straight ahead: x to the right, z away from the viewer."""
    eye, aim = camera.in_camera(numpy.stack([EYE, AIM]))
    distance = numpy.linalg.norm(AIM - EYE)
    error = max(numpy.abs(eye).max(), numpy.abs(aim - [0, 0, distance]).max())
    report.say(error < 1e-5, f"worldToCamera: the aim is {aim[2]:.6f} ahead, must be {distance:.6f}")


def check_places(report, planes, names, camera, what=""):
    """Points of what rests: seen where the matrix says, as far away as they are."""
    off, far_off, deep_off, count = 0.0, 0.0, 0.0, 0
    for name, place in AT_REST.items():
        at = where(planes, names, name)
        points = vectors(planes, "P", at) + place
        off = max(off, numpy.abs(camera.pixels(points) - numpy.column_stack(at[::-1]) - 0.5).max())
        inside = camera.in_camera(points)
        far_off = max(far_off, numpy.abs(numpy.linalg.norm(inside, axis=1) - planes["Z"][at]).max())
        deep_off = max(deep_off, numpy.abs(inside[:, 2] - planes["depth.Z"][at]).max())
        count += len(points)
    report.say(count > 500 and off < 2e-3 and max(far_off, deep_off) < 1e-4,
               f"{what}worldToNDC: {count} points of P at their pixels, off by {off:.2g} at most; "
               f"Z is their distance, by {far_off:.2g}; depth along the view, by {deep_off:.2g}")


def check_normals(report, planes, names, camera):
    """Of what rests, the apparent normal is the normal, turned into the camera's axes: z backwards."""
    at = where(planes, names, "bühne")
    axes = camera.to_camera[:3, :3] * [1, 1, -1]
    error = numpy.abs(vectors(planes, "N", at) @ axes - vectors(planes, "normal", at)).max()
    report.say(error < 1e-5, f"normal is N in the camera's axes, off by {error:.2g} at most")


def check_motion(report, planes, names, camera):
    """Where the flying ball's points are seen at the next picture, by their worldlines' light."""
    at = where(planes, names, FLYING)
    centers = numpy.column_stack(at[::-1]) + 0.5
    depth = planes["depth.Z"][at]
    points = unprojected(camera, centers, depth)
    seen = TIME - planes["Z"][at]
    # |x + v (t - seen) - eye| = TIME + 1 / RATE - t, for s = t - seen
    ray, late = points - EYE, TIME + 1 / RATE - seen
    a, b, c = VELOCITY @ VELOCITY - 1, ray @ VELOCITY + late, (ray * ray).sum(axis=1) - late ** 2
    later = (-b + numpy.sqrt(b * b - a * c)) / a
    moved = camera.pixels(points + VELOCITY * later[:, None]) - centers
    found = vectors(planes, "motion", at, "UV")
    error = numpy.abs(found - moved * [1, -1]).max()
    report.say(error < 1e-3 and len(centers) > 100,
               f"motion: {found[:, 0].mean():.3f} pixels to the right on average, off by {error:.2g} at most")
    still = numpy.abs(vectors(planes, "motion", where(planes, names, "bühne"), "UV")).max()
    report.say(still < 1e-4, f"motion of what rests is {still:.2g} at most")


def unprojected(camera, centers, depth):
    """Points by their pixels and depth along the view."""
    width, height = camera.width, camera.height
    columns = camera.to_film[:, (0, 1, 3)]  # of x w, y w and w
    film = numpy.column_stack([centers / (width, height) * depth[:, None], depth])
    return (film - columns[3]) @ numpy.linalg.inv(columns[:3])


def check_sums(report, planes):
    groups = sorted({name[:-2] for name in planes if name.startswith("light_")})
    for what, layers in (("the ways of light", WAYS), ("the groups of lights", groups)):
        error = max(numpy.abs(sum(planes[f"{layer}.{c}"] for layer in layers) - planes[c]).max()
                    for c in "RGB")
        means = " + ".join(f"{planes[f'{layer}.G'].mean():.4f}" for layer in layers)
        report.say(error < 1e-5 and len(layers) > 2,
                   f"{what} ({', '.join(layers)}) are the beauty's {planes['G'].mean():.4f} = {means}, "
                   f"off by {error:.2g} at most")


def check_mattes(report, planes, names):
    """Where an object fills a pixel and its neighbours, and nothing moves before it, its matte is 1."""
    mattes = {name: cryptomatte.matte_of(planes, "crypto_object", name) for name in names}
    whole = numpy.abs(sum(mattes.values())).max()
    report.say(whole < 1 + 1e-6, f"mattes of all objects together are {whole:.6f} at most")
    inside = planes["id_object.V"] == names.index("bühne") + 1
    for axis in (0, 1):
        inside = inside & numpy.roll(inside, 1, axis) & numpy.roll(inside, -1, axis)
    inside &= mattes[FLYING] == 0
    least = mattes["bühne"][inside].min()
    report.say(inside.sum() > 1000 and least == 1,
               f"matte of \"bühne\" is {least:.6f} at least in the {inside.sum()} pixels that it fills")
