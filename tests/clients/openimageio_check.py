"""OpenImageIO reads pictures of layers.toml; what it says is held against our own reading of them.

    python3 openimageio_check.py FOLDER

FOLDER has none.exr, without compression, and the same picture as rle.exr, zips.exr and so on.
"""

import pathlib
import sys

import numpy
import OpenImageIO as oiio

import cryptomatte
import layer_sense
import layer_table

FOLDER = pathlib.Path(sys.argv[1])
WIDTH, HEIGHT = 96, 64
LOSSLESS = ("none", "rle", "zips", "zip", "piz")
LOSSY = {"pxr24": 1e-4, "dwaa": 0.05, "dwab": 0.05}  # of a mean, relative
CROP = (8, 10, 64, 40)  # left, top, width, height
report = layer_table.Report("OpenImageIO")


def read_part(file, number):
    spec = file.spec(number, 0)
    pixels = file.read_image(number, 0, 0, spec.nchannels, "float").astype(numpy.float64)
    return spec, dict(zip(spec.channelnames, numpy.moveaxis(pixels, 2, 0)))


def read_parts(name):
    file = oiio.ImageInput.open(str(FOLDER / f"{name}.exr"))
    if not file:
        raise SystemExit(f"error: OpenImageIO: {oiio.geterror()}")
    parts = []
    while file.seek_subimage(len(parts), 0):
        parts.append(read_part(file, len(parts)))
    file.close()
    return parts


def read(name):
    (part,) = read_parts(name)
    return part


def windows_of(spec):
    return [(spec.x, spec.y, spec.width, spec.height),
            (spec.full_x, spec.full_y, spec.full_width, spec.full_height)]


def attributes_of(spec):
    return {a.name: a.value for a in spec.extra_attribs}


def check_channels(spec, ours):
    wanted = {name for names in layer_table.LAYERS.values() for name in names} | set(layer_table.BEAUTY)
    found = set(spec.channelnames)
    odd = sorted(found ^ wanted) + sorted(set(ours) ^ wanted)
    report.say(not odd, f"{len(found)} channels of {len(wanted)}"
               + "".join(f", not alike: {name}" for name in odd))
    types = {str(kind) for kind in spec.channelformats} or {str(spec.format)}
    report.say(types == {"float"}, f"with beaming every channel is {types}")
    report.say(spec.channelnames[:5] == ("R", "G", "B", "A", "Z") and spec.alpha_channel == 3
               and spec.z_channel == 4, "knows red, green, blue, alpha and depth by name")
    windows = windows_of(spec)
    report.say(windows == [(0, 0, WIDTH, HEIGHT)] * 2, f"data and display window {windows}")


def check_pixels(theirs, ours):
    for layer, names in {"beauty": layer_table.BEAUTY, **layer_table.LAYERS}.items():
        report.compare(layer, [theirs[name] for name in names], [ours[name] for name in names])


def check_compressions(ours):
    for name in LOSSLESS:
        spec, theirs = read(name)
        good = spec.getattribute("compression") == name
        good = good and all(numpy.array_equal(theirs[channel], ours[channel]) for channel in ours)
        report.say(good, f"{spec.getattribute('compression')}: {layer_table.likeness(good)}")
    for name, tolerance in LOSSY.items():
        (light_spec, light), (data_spec, data) = read_parts(name)
        said = [spec.getattribute(key) for spec in (light_spec, data_spec)
                for key in ("oiio:subimagename", "compression")]
        worst = max(abs(light[c].mean() - ours[c].mean()) / max(1e-3, ours[c].mean()) for c in light)
        good = all(numpy.array_equal(data[channel], ours[channel]) for channel in data)
        report.say(said == ["light", name, "data", "zip"] and good and worst < tolerance
                   and set(light) | set(data) == set(ours),
                   f"{name}: parts {said}: data {layer_table.likeness(good)}, means of light within {worst:.2g}")


def check_split(ours):
    """A file for each layer."""
    for layer, names in {"beauty": layer_table.BEAUTY, **layer_table.LAYERS}.items():
        theirs = read(f"split.{layer}")[1]
        good = set(theirs) == set(names) and all(numpy.array_equal(theirs[n], ours[n]) for n in names)
        report.say(good, f"split.{layer}: {len(theirs)} channels of {len(names)}, "
                         f"{layer_table.likeness(good)}")


def check_crop(ours):
    spec, theirs = read("crop")
    left, top, width, height = CROP
    windows = windows_of(spec)
    good = all(numpy.array_equal(theirs[name], ours[name][top:top + height, left:left + width])
               for name in ours)
    report.say(good and windows == [CROP, (0, 0, WIDTH, HEIGHT)],
               f"crop: data and display window {windows}, {layer_table.likeness(good)}")


def check_stereo():
    """Both eyes: names by OpenEXR's rules; what rests is where each eye's own matrix says."""
    spec, planes = read("stereo")
    said = attributes_of(spec)
    report.say(said.get("multiView") == layer_table.VIEWS and len(planes) == 2 * len(read("none")[1]),
               f"stereo: multiView is {said.get('multiView')}, {len(planes)} channels")
    for view, before in zip(layer_table.VIEWS, ("", "right.")):
        camera = layer_sense.Camera(said[before + "worldToCamera"], said[before + "worldToNDC"], (HEIGHT, WIDTH))
        own = layer_table.of_view(planes, view)
        layer_sense.check_places(report, own, list(said["objectNames"]), camera, f"{view} eye: ")


def check_metadata(said):
    wanted = {"framesPerSecond": (layer_sense.RATE, 1), "pictureNumber": 0,
              "cameraTime": layer_sense.TIME, "cameraVelocity": (0, 0, 0), "depthType": "distance",
              "timeOrigin": "0 0", "objectNames": ("flying ball", "veil", "bühne"), "samples": "16"}
    for name, value in wanted.items():
        report.say(said.get(name) == value, f"{name} is {said.get(name)}")
    report.say(str(said.get("software", "")).startswith("restframe "), f"software is {said.get('software')}")
    report.say("seed" in said and "restframeSettings" in said and "restframeSources" in said,
               "settings, sources and seed are there")
    for layer, names in layer_sense.NAMES.items():
        faults = cryptomatte.faults_of(said, layer, names)
        report.say(not faults, f"{layer}: " + ("; ".join(faults) or f"a manifest of {', '.join(names)}"))


def check_sense(said, planes):
    camera = layer_sense.Camera(said["worldToCamera"], said["worldToNDC"], planes["R"].shape)
    names = list(said["objectNames"])
    layer_sense.check_camera(report, camera)
    for check in (layer_sense.check_places, layer_sense.check_normals, layer_sense.check_motion):
        check(report, planes, names, camera)
    layer_sense.check_sums(report, planes)
    layer_sense.check_mattes(report, planes, names)


def main():
    ours, _ = layer_table.planes_of(FOLDER / "none.exr")
    spec, theirs = read("none")
    said = attributes_of(spec)
    check_channels(spec, ours)
    check_pixels(theirs, ours)
    check_metadata(said)
    check_sense(said, theirs)
    check_compressions(ours)
    check_split(ours)
    check_crop(ours)
    check_stereo()
    return 1 if report.faults else 0


sys.exit(main())
