"""Run by Blender: pictures of layers.toml through its compositor, held against our own reading of them.

    blender --background --factory-startup --python blender_layers.py -- FOLDER

FOLDER has none.exr, without compression.
"""

import pathlib
import sys

import bpy
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import cryptomatte  # noqa: E402
import layer_sense  # noqa: E402
import layer_table  # noqa: E402

FOLDER = pathlib.Path(sys.argv[sys.argv.index("--") + 1])
SOCKETS = {"Combined": layer_table.BEAUTY, "Depth": ["Z"]}  # what Blender calls otherwise
report = layer_table.Report("Blender")


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
    """A file's sockets in, a file of uncompressed channels out."""

    made = 0

    def __init__(self, path, size):
        scene = bpy.context.scene
        scene.use_nodes = True
        scene.render.resolution_x, scene.render.resolution_y = size
        scene.render.resolution_percentage = 100
        self.tree = scene.node_tree
        self.tree.nodes.clear()
        self.image = bpy.data.images.load(str(path))
        Compositor.made += 1
        self.target = FOLDER / f"composited_{Compositor.made}_"
        self.file = self.tree.nodes.new("CompositorNodeOutputFile")
        self.file.base_path = f"{self.target}#"
        settings = self.file.format
        settings.file_format, settings.color_depth, settings.exr_codec = "OPEN_EXR_MULTILAYER", "32", "NONE"
        self.file.layer_slots.clear()

    def keep(self, name, socket):
        self.file.layer_slots.new(name)
        self.tree.links.new(socket, self.file.inputs[-1])

    def add_layers(self, view=None):
        node = self.tree.nodes.new("CompositorNodeImage")
        node.image = self.image
        if view:
            node.view = view
        sockets = [socket for socket in node.outputs if socket.enabled]
        for socket in sockets:
            self.keep(socket.name, socket)
        return {socket.name for socket in sockets}

    def add_mattes(self, layer, names):
        for number, name in enumerate(names):
            node = self.tree.nodes.new("CompositorNodeCryptomatteV2")
            node.source, node.image = "IMAGE", self.image
            node.layer_name, node.matte_id = layer, name
            self.keep(f"{layer}_{number}", node.outputs["Matte"])

    def run(self):
        self.tree.nodes.new("CompositorNodeComposite")
        bpy.ops.render.render()
        return layer_table.planes_of(f"{self.target}1.exr")[0]


def check_layers(sockets, composited, ours, what=""):
    wanted = channels_of_layers()
    missing = set(wanted) - sockets
    report.say(not missing, f"{what}image node: {len(wanted) - len(missing)} of {len(wanted)} layers"
               + "".join(f", not there: {name}" for name in sorted(missing)))
    for socket, names in wanted.items():
        if socket not in missing:
            theirs = [composited[f"{socket}.{letter}"] for letter in letters_of(names)]
            report.compare(what + socket, theirs, [ours[name] for name in names])


def check_mattes(layer, names, composited, ours):
    for number, name in enumerate(names):
        theirs, wanted = composited[f"{layer}_{number}.V"], cryptomatte.matte_of(ours, layer, name)
        good = numpy.abs(theirs - wanted).max() < 1e-6 and wanted.mean() > 0.005
        report.say(good, f"{layer}: matte of \"{name}\": {layer_table.likeness(good)}; "
                         f"means theirs/ours {theirs.mean():.6f}/{wanted.mean():.6f}")


def check_one_eye(path, ours):
    compositor = Compositor(path, ours["R"].shape[::-1])
    sockets = compositor.add_layers()
    for layer, names in layer_sense.NAMES.items():
        compositor.add_mattes(layer, names)
    composited = compositor.run()
    check_layers(sockets, composited, ours)
    for layer, names in layer_sense.NAMES.items():
        check_mattes(layer, names, composited, ours)


def check_stereo(path):
    both, _ = layer_table.planes_of(path)
    for view in layer_table.VIEWS:
        compositor = Compositor(path, both["R"].shape[::-1])
        sockets = compositor.add_layers(view)
        check_layers(sockets, compositor.run(), layer_table.of_view(both, view), f"{view} eye: ")


def check_two_parts(path, ours):
    """Data without loss beside light with some."""
    compositor = Compositor(path, ours["R"].shape[::-1])
    compositor.add_layers()
    composited = compositor.run()
    good = numpy.array_equal(composited["Depth.V"], ours["Z"])
    light, own = composited["Combined.G"].mean(), ours["G"].mean()
    report.say(good and abs(light - own) < 0.02 * own,
               f"{path.stem}, of two parts: Z {layer_table.likeness(good)}; "
               f"mean of green theirs/ours {light:.6f}/{own:.6f}")


def main():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    ours, _ = layer_table.planes_of(FOLDER / "none.exr")
    check_one_eye(FOLDER / "none.exr", ours)
    check_stereo(FOLDER / "stereo.exr")
    check_two_parts(FOLDER / "dwaa.exr", ours)
    sys.exit(1 if report.faults else 0)


main()
