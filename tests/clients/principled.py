"""Run by Blender: balls of Principled materials and an imported asset, by Cycles and by restframe.

    blender --background --factory-startup --python principled.py -- PROGRAM FOLDER TABLE.csv PICTURE.png

Each ball is exported to glTF, which is not the same model as Cycles' Principled BSDF: the table says by how
much the mean of each ball differs, the picture shows Cycles above restframe.
"""

import pathlib
import subprocess
import sys

import bpy
import numpy

numpy.bool = bool  # Debian 12's importer of glTF asks for this old name

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cycles_scenes as scenes  # noqa: E402

FOV = 22
WIDTH, HEIGHT, SAMPLES = 640, 320, 64
ENGINE = "/usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb"
CLAY = (0.8, 0.35, 0.2)
BALLS = [  # name, base colour, Principled's inputs; Blender's clear coat and sheen are others than glTF's
    ("plastic, roughness 0.1", CLAY, {"Roughness": 0.1}),
    ("plastic, roughness 0.5", CLAY, {"Roughness": 0.5}),
    ("plastic, roughness 1", CLAY, {"Roughness": 1.0}),
    ("plastic, specular 0", CLAY, {"Roughness": 0.5, "Specular": 0.0}),
    ("metal, roughness 0.1", CLAY, {"Metallic": 1.0, "Roughness": 0.1}),
    ("metal, roughness 0.5", CLAY, {"Metallic": 1.0, "Roughness": 0.5}),
    ("metal, roughness 1", CLAY, {"Metallic": 1.0, "Roughness": 1.0}),
    ("half metal", CLAY, {"Metallic": 0.5, "Roughness": 0.3}),
    ("clear coat", CLAY, {"Roughness": 0.6, "Clearcoat": 1.0, "Clearcoat Roughness": 0.05}),
    ("rough clear coat", CLAY, {"Roughness": 0.6, "Clearcoat": 1.0, "Clearcoat Roughness": 0.4}),
    ("glowing", CLAY, {"Roughness": 0.5, "Emission": (0.2, 0.3, 0.1, 1.0), "Emission Strength": 1.0}),
    ("thin glass", (1, 1, 1), {"Roughness": 0.0, "Transmission": 1.0}),
]


def principled(name, color, inputs):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*color, 1.0)
    for key, value in inputs.items():
        shader.inputs[key].default_value = value
    return material


def add_sky(folder):
    scenes.write_sky(f"{folder}/sky.exr")
    nodes = bpy.context.scene.world.node_tree.nodes
    links = bpy.context.scene.world.node_tree.links
    texture = nodes.new("ShaderNodeTexEnvironment")
    texture.image = bpy.data.images.load(f"{folder}/sky.exr")
    background, output = nodes.new("ShaderNodeBackground"), nodes.new("ShaderNodeOutputWorld")
    links.new(texture.outputs["Color"], background.inputs["Color"])
    links.new(background.outputs[0], output.inputs["Surface"])


def center_of(number):
    return (-2.75 + 1.1 * (number % 6), 0.0, 0.6 - 1.2 * (number // 6))


def by_cycles(path):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    cycles, render = scene.cycles, scene.render
    cycles.device, cycles.samples, cycles.use_denoising = "CPU", SAMPLES, False
    cycles.use_adaptive_sampling = False
    cycles.pixel_filter_type, cycles.filter_width = "BLACKMAN_HARRIS", 1.47
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.blur_glossy = 0
    render.resolution_x, render.resolution_y, render.resolution_percentage = WIDTH, HEIGHT, 100
    render.image_settings.file_format, render.image_settings.color_depth = "OPEN_EXR", "32"
    render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    return pixels_of(path)


def pixels_of(path):
    image = bpy.data.images.load(str(path))
    pixels = numpy.empty(WIDTH * HEIGHT * 4, dtype=numpy.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return pixels.reshape(HEIGHT, WIDTH, 4)[:, :, :3].astype(float)


def by_restframe(program, folder, name, asset, eye):
    file, output = folder / f"{name}.toml", folder / f"{name}_own.exr"
    file.write_text(
        scenes.camera_text(*eye) +
        f'[render]\nresolution = [{WIDTH}, {HEIGHT}]\nsamples = {SAMPLES}\nintegrator = "path"\ndepth = 12\n'
        '[animation]\npictures = 1\n[output]\nlayers = ["beauty"]\ncompression = "none"\npreview = false\n'
        f'[[object]]\nname = "asset"\nasset = "{asset}"\n'
        '[[light]]\ntype = "environment"\nfile = "sky.exr"\n')
    subprocess.run([program, "render", str(file), "--output", str(output), "--quiet", "--overwrite"],
                   check=True, timeout=600, stdin=subprocess.DEVNULL)
    return pixels_of(output)


def balls(program, folder):
    scenes.emptied()
    add_sky(folder)
    for number, (name, color, inputs) in enumerate(BALLS):
        scenes.add_ball(name, center_of(number), 0.5, principled(name, color, inputs))
    eye = ((0, -9, 0), (0, 0, 0), FOV)
    scenes.add_camera(*eye)
    bpy.ops.export_scene.gltf(filepath=str(folder / "balls.glb"), export_apply=True)
    return by_cycles(folder / "balls_cycles.exr"), by_restframe(program, folder, "balls", "balls.glb", eye)


def engine(program, folder):
    scenes.emptied()
    add_sky(folder)
    bpy.ops.import_scene.gltf(filepath=ENGINE)
    for thing in [t for t in bpy.data.objects if t.type == "CAMERA"]:
        bpy.data.objects.remove(thing)
    eye = ((350, -1100, 320), (0, 0, -40), 21)
    scenes.add_camera(*eye)
    bpy.data.cameras["eye"].clip_end = 1e5
    return by_cycles(folder / "engine_cycles.exr"), by_restframe(program, folder, "engine", ENGINE, eye)


# Where ball `number` is in the picture of balls, rows from the bottom.
def place_of(number):
    x, _, z = center_of(number)
    scale = HEIGHT / (2 * 9 * numpy.tan(numpy.radians(FOV) / 2))
    across, up = WIDTH / 2 + x * scale, HEIGHT / 2 + z * scale
    half = int(0.3 * scale)
    return slice(int(up) - half, int(up) + half), slice(int(across) - half, int(across) + half)


def encoded(linear):
    c = numpy.clip(linear, 0, 1)
    return numpy.where(c <= 0.0031308, 12.92 * c, 1.055 * c ** (1 / 2.4) - 0.055)


def write_png(path, rows):
    height, width, _ = rows.shape
    image = bpy.data.images.new("sheet", width, height)
    image.colorspace_settings.name = "Raw"
    pixels = numpy.ones((height, width, 4), dtype=numpy.float32)
    pixels[:, :, :3] = rows
    image.pixels.foreach_set(pixels.ravel())
    image.filepath_raw, image.file_format = path, "PNG"
    image.save()


def main():
    program, folder, table, picture = sys.argv[sys.argv.index("--") + 1:]
    folder = pathlib.Path(folder)
    cycles, own = balls(program, folder)
    rows = ["what,restframe over Cycles: red,green,blue"]
    for number, (name, _, _) in enumerate(BALLS):
        at = place_of(number)
        ratio = own[at].mean(axis=(0, 1)) / cycles[at].mean(axis=(0, 1))
        rows.append(f'"{name}",' + ",".join(f"{r:.3f}" for r in ratio))
    engines = engine(program, folder)
    ratio = engines[1].mean(axis=(0, 1)) / engines[0].mean(axis=(0, 1))
    rows.append('"two-cylinder engine, whole picture",' + ",".join(f"{r:.3f}" for r in ratio))
    pathlib.Path(table).write_text("\n".join(rows) + "\n")
    sheet = numpy.concatenate([numpy.concatenate([own, cycles]), numpy.concatenate(engines[::-1])], axis=1)
    write_png(picture, encoded(sheet)[::2, ::2])
    print("\n".join(rows))


main()
