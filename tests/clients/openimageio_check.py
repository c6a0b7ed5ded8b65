"""OpenImageIO reads pictures of layers.toml; what it says is held against our own reading of them.

    python3 openimageio_check.py FOLDER

FOLDER has none.exr, without compression, and the same picture as rle.exr, zips.exr and so on.
"""

import pathlib
import sys

import numpy
import OpenImageIO as oiio

import layer_table

FOLDER = pathlib.Path(sys.argv[1])
WIDTH, HEIGHT = 96, 64
LOSSLESS = ("none", "rle", "zips", "zip", "piz")
LOSSY = {"pxr24": 1e-4, "dwaa": 0.05, "dwab": 0.05}  # of a mean, relative
EYE, AIM = numpy.array([1, 0.5, 6]), numpy.array([0.2, 0, 0])
AT_REST = {"veil": (1.1, 0.3, 0.4), "bühne": (0, -1, -1)}  # where they are
report = layer_table.Report()


def read(name):
    file = oiio.ImageInput.open(str(FOLDER / f"{name}.exr"))
    if not file:
        raise SystemExit(f"error: OpenImageIO: {oiio.geterror()}")
    spec = file.spec()
    pixels = file.read_image("float").astype(numpy.float64)
    file.close()
    return spec, dict(zip(spec.channelnames, numpy.moveaxis(pixels, 2, 0)))


def check_channels(spec, ours):
    wanted = {name for names in layer_table.LAYERS.values() for name in names} | set(layer_table.BEAUTY)
    found = set(spec.channelnames)
    report.say(found == wanted == set(ours),
               f"OpenImageIO: {len(found)} channels of {len(wanted)}"
               + "".join(f", not alike: {name}" for name in sorted(found ^ wanted)))
    types = {str(kind) for kind in spec.channelformats} or {str(spec.format)}
    report.say(types == {"float"}, f"OpenImageIO: with beaming every channel is {types}")
    report.say(spec.channelnames[:5] == ("R", "G", "B", "A", "Z") and spec.alpha_channel == 3
               and spec.z_channel == 4, "OpenImageIO: knows red, green, blue, alpha and depth by name")
    windows = [(spec.x, spec.y, spec.width, spec.height),
               (spec.full_x, spec.full_y, spec.full_width, spec.full_height)]
    report.say(windows == [(0, 0, WIDTH, HEIGHT)] * 2, f"OpenImageIO: data and display window {windows}")


def check_pixels(theirs, ours):
    for layer, names in {"beauty": layer_table.BEAUTY, **layer_table.LAYERS}.items():
        good = all(numpy.array_equal(theirs[name], ours[name]) for name in names)
        means = ", ".join(f"{layer_table.mean_of(theirs[n]):.6g}/{layer_table.mean_of(ours[n]):.6g}"
                          for n in names)
        report.say(good, f"OpenImageIO: {layer}: {layer_table.likeness(good)}; means theirs/ours {means}")


def check_compressions(ours):
    for name in LOSSLESS:
        spec, theirs = read(name)
        good = spec.getattribute("compression") == name
        good = good and all(numpy.array_equal(theirs[channel], ours[channel]) for channel in ours)
        report.say(good, f"OpenImageIO: {spec.getattribute('compression')}: same to the bit")
    for name, tolerance in LOSSY.items():
        spec, theirs = read(name)
        worst = max(abs(layer_table.mean_of(theirs[c]) - layer_table.mean_of(ours[c]))
                    / max(1e-3, abs(layer_table.mean_of(ours[c]))) for c in ours)
        report.say(spec.getattribute("compression") == name and worst < tolerance,
                   f"OpenImageIO: {spec.getattribute('compression')}: means within {worst:.2g}")


def check_metadata(spec):
    said = {a.name: a.value for a in spec.extra_attribs}
    wanted = {"framesPerSecond": (12, 1), "pictureNumber": 0, "cameraTime": 0.25,
              "cameraVelocity": (0, 0, 0), "depthType": "distance", "timeOrigin": "0 0",
              "objectNames": ("flying ball", "veil", "bühne"), "samples": "16"}
    for name, value in wanted.items():
        report.say(said.get(name) == value, f"OpenImageIO: {name} is {said.get(name)}")
    report.say(str(said.get("software", "")).startswith("restframe "),
               f"OpenImageIO: software is {said.get('software')}")
    report.say("seed" in said and "restframeSettings" in said and "restframeSources" in said,
               "OpenImageIO: settings, sources and seed are there")


def matrix_of(spec, name):
    return numpy.array(spec.getattribute(name), dtype=numpy.float64).reshape(4, 4)


def check_camera(spec):
    """The eye at the origin, the aim straight ahead: x to the right, z away from the viewer."""
    matrix = matrix_of(spec, "worldToCamera")
    eye, aim = (numpy.append(p, 1) @ matrix for p in (EYE, AIM))
    distance = numpy.linalg.norm(AIM - EYE)
    error = max(numpy.abs(eye[:3]).max(), numpy.abs(aim[:3] - [0, 0, distance]).max())
    report.say(error < 1e-5, f"OpenImageIO: worldToCamera: the aim is {aim[2]:.6f} ahead, "
                             f"must be {distance:.6f}")


def world_points(planes, names):
    """Of what rests: P from its place, and the pixels where it is."""
    for name, place in AT_REST.items():
        rows, columns = numpy.nonzero(planes["id_object.V"] == names.index(name) + 1)
        yield columns, rows, numpy.stack([planes[f"P.{c}"][rows, columns] for c in "XYZ"], axis=1) + place


def check_projection(spec, planes, names):
    """Points of resting things, by the picture's own matrix, at the pixels' centres; Z their distance."""
    matrix, off, depth_off, count = matrix_of(spec, "worldToNDC"), 0.0, 0.0, 0
    for columns, rows, points in world_points(planes, names):
        film = numpy.column_stack([points, numpy.ones(len(points))]) @ matrix
        film = film[:, :2] / film[:, 3:]
        off = max(off, numpy.abs(film[:, 0] * WIDTH - columns - 0.5).max(),
                  numpy.abs(film[:, 1] * HEIGHT - rows - 0.5).max())
        depth_off = max(depth_off, numpy.abs(numpy.linalg.norm(points - EYE, axis=1)
                                             - planes["Z"][rows, columns]).max())
        count += len(points)
    report.say(count > 500 and off < 2e-3,
               f"OpenImageIO: worldToNDC: {count} points of P at their pixels, off by {off:.2g} at most")
    report.say(depth_off < 1e-4, f"OpenImageIO: Z is their distance, off by {depth_off:.2g} at most")


def main():
    ours, names = layer_table.planes_of(FOLDER / "none.exr")
    spec, theirs = read("none")
    check_channels(spec, ours)
    check_pixels(theirs, ours)
    check_metadata(spec)
    check_camera(spec)
    check_projection(spec, theirs, names)
    check_compressions(ours)
    return 1 if report.faults else 0


sys.exit(main())
