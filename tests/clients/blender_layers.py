"""Run by Blender: pictures of layers.toml through its compositor, held against our own reading of them.

    blender --background --factory-startup --python blender_layers.py -- FOLDER

FOLDER has none.exr, without compression.
"""

import json
import pathlib
import sys

import bpy
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import cryptomatte  # noqa: E402
import layer_table  # noqa: E402
from blender_exr import read_attributes  # noqa: E402

FOLDER = pathlib.Path(sys.argv[sys.argv.index("--") + 1])
SOCKETS = {"Combined": layer_table.BEAUTY, "Depth": ["Z"]}  # what Blender calls otherwise
report = layer_table.Report()


def letters_of(names):
    """Blender's sockets hold one number, or colours whose letters stand for any three or four."""
    return "V" if len(names) == 1 else "RGBA"[:len(names)]


def channels_of_layers():
    """Names of channels by that of Blender's socket: what is before the last dot."""
    sockets = dict(SOCKETS)
    for names in layer_table.LAYERS.values():
        for name in names:
            if "." in name:
                sockets.setdefault(name.rsplit(".", 1)[0], []).append(name)
    return sockets


class Compositor:
    """Sockets in, a file of uncompressed channels out."""

    def __init__(self, image, size):
        scene = bpy.context.scene
        scene.use_nodes = True
        scene.render.resolution_x, scene.render.resolution_y = size
        scene.render.resolution_percentage = 100
        self.tree, self.image = scene.node_tree, image
        self.tree.nodes.clear()
        self.file = self.tree.nodes.new("CompositorNodeOutputFile")
        self.file.base_path = str(FOLDER / "composited#")
        settings = self.file.format
        settings.file_format, settings.color_depth, settings.exr_codec = "OPEN_EXR_MULTILAYER", "32", "NONE"
        self.file.layer_slots.clear()

    def keep(self, name, socket):
        self.file.layer_slots.new(name)
        self.tree.links.new(socket, self.file.inputs[-1])

    def run(self):
        self.tree.nodes.new("CompositorNodeComposite")
        bpy.ops.render.render()
        return layer_table.planes_of(FOLDER / "composited1.exr")[0]


def add_layers(compositor):
    node = compositor.tree.nodes.new("CompositorNodeImage")
    node.image = compositor.image
    sockets = [socket for socket in node.outputs if socket.enabled]
    for socket in sockets:
        compositor.keep(socket.name, socket)
    return {socket.name for socket in sockets}


def add_mattes(compositor, layer, names):
    for number, name in enumerate(names):
        node = compositor.tree.nodes.new("CompositorNodeCryptomatteV2")
        node.source, node.image = "IMAGE", compositor.image
        node.layer_name = layer
        node.matte_id = name
        compositor.keep(f"{layer}_{number}", node.outputs["Matte"])


def check_layers(sockets, composited, ours):
    wanted = channels_of_layers()
    missing = set(wanted) - sockets
    report.say(not missing, f"Blender: image node: {len(wanted) - len(missing)} of {len(wanted)} layers"
               + "".join(f", not there: {name}" for name in sorted(missing)))
    for socket, names in wanted.items():
        if socket in missing:
            continue
        theirs = [composited[f"{socket}.{letter}"] for letter in letters_of(names)]
        good = all(numpy.array_equal(a, ours[name]) for a, name in zip(theirs, names))
        means = ", ".join(f"{layer_table.mean_of(a):.6g}/{layer_table.mean_of(ours[name]):.6g}"
                          for a, name in zip(theirs, names))
        report.say(good, f"Blender: {socket}: {layer_table.likeness(good)}; means theirs/ours {means}")


def check_mattes(layer, names, composited, ours):
    for number, name in enumerate(names):
        theirs, wanted = composited[f"{layer}_{number}.V"], cryptomatte.matte_of(ours, layer, name)
        good = numpy.abs(theirs - wanted).max() < 1e-6 and wanted.mean() > 0.005
        report.say(good, f"Blender: {layer}: matte of \"{name}\": {layer_table.likeness(good)}; "
                         f"means theirs/ours {theirs.mean():.6f}/{wanted.mean():.6f}")


def names_in(layer, path):
    manifest = read_attributes(path).get(cryptomatte.key_of(layer) + "manifest", "{}")
    return sorted(json.loads(manifest))


def main():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    path = FOLDER / "none.exr"
    ours, _ = layer_table.planes_of(path)
    image = bpy.data.images.load(str(path))
    height, width = ours["R"].shape
    compositor = Compositor(image, (width, height))
    sockets = add_layers(compositor)
    mattes = {layer: names_in(layer, path) for layer in layer_table.MATTES}
    for layer, names in mattes.items():
        add_mattes(compositor, layer, names)
    composited = compositor.run()
    check_layers(sockets, composited, ours)
    for layer, names in mattes.items():
        check_mattes(layer, names, composited, ours)
    sys.exit(1 if report.faults else 0)


main()
