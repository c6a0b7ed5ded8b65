"""Run by Blender: installs the add-on of this checkout, and does with it what its users do.

    blender --background --factory-startup --python addon_check.py -- PROGRAM

Builds a scene by the panels' settings, exports it, has it checked and rendered, loads the picture, and
compares: velocities in the file's axes, colours over time, means of pixels.
"""

import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

import bpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
from blender_exr import read_attributes, read_exr  # noqa: E402

ADDON = HERE.parent.parent / "importers" / "blender"
PROGRAM = sys.argv[sys.argv.index("--") + 1]
RESOLUTION = (96, 32)
faults = []


def expect(what, found, wanted, tolerance=0.0):
    pairs = list(zip(found, wanted)) if isinstance(wanted, (list, tuple)) else [(found, wanted)]
    good = all(abs(a - b) <= tolerance if isinstance(b, float) else a == b for a, b in pairs)
    if not good or isinstance(wanted, (list, tuple)) and len(found) != len(wanted):
        faults.append(f"{what} is {found}, must be {wanted}")


def report(line):
    """What was seen; faults come at the end."""
    print("add-on:", line)


def install():
    """As from a file that is handed on: one folder, zipped."""
    folder = tempfile.mkdtemp()
    packed = shutil.make_archive(f"{folder}/restframe_addon", "zip", ADDON, "restframe_addon")
    bpy.ops.preferences.addon_install(filepath=packed)
    bpy.ops.preferences.addon_enable(module="restframe_addon")
    shutil.rmtree(folder)
    bpy.context.preferences.addons["restframe_addon"].preferences.program = PROGRAM


def add_ball(name, x):
    bpy.ops.mesh.primitive_uv_sphere_add(segments=32, ring_count=16, radius=1, location=(x, 10, 0))
    ball = bpy.context.object
    ball.name = name
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    material.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (0, 0, 0, 1)
    ball.data.materials.append(material)
    return ball, ball.restframe_settings, material.restframe_settings


def add_step(of, begin, end, color):
    bpy.ops.restframe.add_step(of=of)
    step = bpy.context.object.active_material.restframe_settings.emission.steps[-1]
    step.begin, step.end, step.color = begin, end, color


def build():
    _, motion, look = add_ball("away", -2.5)
    motion.kind, motion.velocity, motion.time = "VELOCITY", (0.1, 0.55, 0.2), -10
    look.emission.kind, look.emission.period = "INTERVALS", 2
    add_step("emission", 0, 1, (0, 0.25, 0))
    add_step("emission", 1, 2, (0, 0, 0.5))
    _, motion, look = add_ball("up", 0)
    motion.kind, motion.gamma, motion.direction = "GAMMA", 2, (0, 0, 3)
    motion.time, motion.clock = -10, 0.75
    look.emission.kind = "KEYS"
    add_step("emission", -4, 0, (0, 0, 0))
    add_step("emission", 4, 0, (1, 0.5, 0.25))
    _, motion, look = add_ball("still", 2.5)
    motion.frame_clock = True
    look.emission.kind, look.emission.formula = "FORMULA", "0.5 + 0.25*sin(t)"
    look.emission.from_color, look.emission.to_color = (0, 0, 0), (0.5, 0, 1)
    add_camera()
    describe_scene(bpy.context.scene.restframe_settings)


def add_camera():
    data = bpy.data.cameras.new("eye")
    camera = bpy.data.objects.new("eye", data)
    camera.rotation_euler = (1.5707963267948966, 0, 0)
    bpy.context.collection.objects.link(camera)
    bpy.context.scene.camera = camera
    render = bpy.context.scene.render
    render.resolution_x, render.resolution_y, render.resolution_percentage = 192, 64, 50
    data.angle = 1.2


def describe_scene(settings):
    bpy.ops.restframe.from_output()
    settings.pictures, settings.samples, settings.layers = 2, 1, "beauty, Z"
    more = bpy.data.texts.new("more")
    more.from_string('output.compression = "none"\noutput.preview = false')
    settings.lines = more


def info_of(path):
    said = subprocess.run([PROGRAM, "info", "--json", path], stdout=subprocess.PIPE, check=True)
    return json.loads(said.stdout)


def check_export(folder):
    path = str(folder / "scene.glb")
    bpy.ops.restframe.export(filepath=path)
    found = {thing["name"]: (frame["velocity"], frame["gamma"], thing["position"])
             for frame in info_of(path)["scene"]["rest_frames"] for thing in frame["objects"]}
    expect("objects", sorted(found), ["away", "still", "up"])
    expect("away: velocity", found["away"][0], [0.1, 0.2, -0.55], 1e-7)
    expect("up: velocity", found["up"][0], [0.0, 0.75 ** 0.5, 0.0], 1e-7)
    expect("up: gamma", found["up"][1], 2.0, 1e-12)
    expect("still: position", found["still"][2], [2.5, 0.0, -10.0], 1e-6)
    extras = extras_of(path)
    expect("names of custom properties", sorted({key for e in extras for key in e}), ["restframe"])
    report(f"velocity (0.1, 0.55, 0.2) of Blender is {found['away'][0]} in the file")


def extras_of(path):
    data = pathlib.Path(path).read_bytes()
    document = json.loads(data[20:20 + int.from_bytes(data[12:16], "little")])
    elements = [e for key in ("nodes", "materials", "cameras", "scenes") for e in document[key]]
    return [e["extras"] for e in elements if "extras" in e]


def check_first_picture():
    bpy.ops.restframe.check()
    bpy.ops.restframe.render()
    image = bpy.data.images[-1]
    path = bpy.path.abspath(image.filepath)
    width, height, rows, _ = read_exr(path)
    expect("size of the picture", [width, height], list(RESOLUTION))
    expect("size in Blender", list(image.size), list(RESOLUTION))
    pixels = list(image.pixels)
    for index, channel in enumerate("RGBA"):
        ours = sum(map(sum, rows[channel])) / (width * height)
        loaded = sum(pixels[index::4]) / (width * height)
        expect(f"mean of {channel}", loaded, ours, 1e-6)
        report(f"first picture: mean of {channel} theirs/ours {loaded:.6f}/{ours:.6f}")


def color_of(name, clock):
    """What the settings ask for; None beside an edge."""
    if name == "away":
        phase = clock % 2
        if min(phase % 1, 1 - phase % 1) < 0.02:
            return None
        return (0, 0.25, 0) if phase < 1 else (0, 0, 0.5)
    if name == "up":
        share = min(max((clock + 4) / 8, 0), 1)
        return (share, 0.5 * share, 0.25 * share)
    share = 0.5 + 0.25 * math.sin(clock)
    return (0.5 * share, 0, share)


def check_animation(folder):
    settings = bpy.context.scene.restframe_settings
    settings.folder, settings.layers = str(folder / "film"), "beauty Z time id"
    bpy.ops.restframe.render(animation=True)
    expect("pictures", sorted(p.name for p in (folder / "film").iterdir() if p.suffix == ".exr"),
           ["picture.0000.exr", "picture.0001.exr"])
    width, height, rows, names = read_exr(folder / "film" / "picture.0001.exr")
    compared = dict.fromkeys(names, 0)
    for y in range(height):
        for x in range(width):
            index = int(rows["id_object.V"][y][x])
            name = names[index - 1] if index else None
            wanted = color_of(name, rows["time_proper.V"][y][x]) if name else None
            if wanted is None:
                continue
            compared[name] += 1
            found = [rows[channel][y][x] for channel in "RGB"]
            if max(abs(a - b) for a, b in zip(found, wanted)) > 2e-3:
                faults.append(f"pixel {x},{y}: {name} is {found}, must be {wanted}")
    report(f"colours over time: pixels compared: {compared}")
    if sorted(compared) != ["away", "still", "up"] or min(compared.values()) < 3:
        faults.append(f"too few pixels to compare: {compared}")


def failure_of(operator, **arguments):
    """What an operator that must fail says."""
    try:
        operator(**arguments)
    except RuntimeError as error:
        return str(error).strip()
    return "nothing"


def check_errors():
    motion = bpy.data.objects["away"].restframe_settings
    motion.velocity = (1, 1, 0)
    for operator in (bpy.ops.restframe.check, bpy.ops.restframe.render):
        said = failure_of(operator)
        report(f"it says: {said}")
        if 'node "away": |velocity| is 1.41421' not in said:
            faults.append(f"too fast a velocity: says {said}")
    motion.velocity = (0, 0, 0)
    preferences = bpy.context.preferences.addons["restframe_addon"].preferences
    preferences.program = "/nowhere/restframe"
    said = failure_of(bpy.ops.restframe.render)
    if 'there is no program "/nowhere/restframe"' not in said:
        faults.append(f"a program that is missing: says {said}")
    preferences.program = PROGRAM


def check_camera(folder):
    settings = bpy.data.cameras["eye"].restframe_settings
    settings.velocity, settings.time = (0, 0.5, 0.25), 1.5
    settings = bpy.context.scene.restframe_settings
    settings.folder, settings.pictures = str(folder / "flown"), 1
    bpy.ops.restframe.render(animation=True)
    found = read_attributes(folder / "flown" / "picture.0000.exr")["cameraVelocity"]
    expect("camera's velocity", found, [0.0, 0.25, -0.5], 1e-12)
    report(f"camera: velocity (0, 0.5, 0.25) of Blender is {found} in the picture")


def check_custom_property():
    """The panels keep their own text fresh, and leave one alone that somebody else wrote."""
    thing = bpy.data.objects["still"]
    bpy.context.view_layer.objects.active = thing
    settings = thing.restframe_settings
    settings.frame_clock = False
    expect("text of what says nothing", thing.get("restframe"), None)
    settings.kind, settings.velocity = "VELOCITY", (0.9, -0.1, 0)
    expect("text", thing["restframe"], "velocity = [0.9, 0.0, 0.1]")
    thing["restframe"] = "clock = 2.5"
    settings.velocity = (0, 0, 0.5)
    expect("foreign text", thing["restframe"], "clock = 2.5")
    bpy.ops.restframe.take_over(of="object")
    expect("text taken over", thing["restframe"], "velocity = [0.0, 0.5, 0.0]\nclock = 2.5")


def main():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    install()
    folder = pathlib.Path(tempfile.mkdtemp())
    build()
    check_export(folder)
    check_first_picture()
    check_animation(folder)
    check_errors()
    check_camera(folder)
    check_custom_property()
    bpy.ops.preferences.addon_disable(module="restframe_addon")
    shutil.rmtree(folder)
    for fault in faults[:10]:
        print("FAULT: add-on:", fault)
    sys.exit(1 if faults else 0)


main()
