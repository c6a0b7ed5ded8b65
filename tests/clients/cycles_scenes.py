"""Scenes that Blender's Cycles and restframe both render, built by Blender.

Blender has z up: (x, y, z) there is (x, z, -y) in the GLB and in restframe's scene file.
"""

import math

import bpy
from mathutils import Vector

from blender_exr import write_exr

DEPTH = 12
SIZE = 96


def emptied():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes.clear()
    return scene


def material_of(name, kind, color, **values):
    """A material of one shader node."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    shader = nodes.new(kind)
    shader.inputs["Color"].default_value = (*color, 1.0)
    for key, value in values.items():
        if key == "distribution":
            shader.distribution = value
        else:
            shader.inputs[key].default_value = value
    output = nodes.new("ShaderNodeOutputMaterial")
    links.new(shader.outputs[0], output.inputs["Surface"])
    return material


def diffuse(name, color):
    return material_of(name, "ShaderNodeBsdfDiffuse", color)


def add_mesh(name, vertices, faces, material):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], faces)
    mesh.materials.append(material)
    mesh.update()
    thing = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def add_quad(name, corners, material):
    return add_mesh(name, corners, [(0, 1, 2, 3)], material)


def add_box(name, center, half, turn, material):
    corners = []
    for z in (-half[2], half[2]):
        for x, y in ((-half[0], -half[1]), (half[0], -half[1]), (half[0], half[1]), (-half[0], half[1])):
            corners.append((center[0] + x * math.cos(turn) - y * math.sin(turn),
                            center[1] + x * math.sin(turn) + y * math.cos(turn), center[2] + z))
    faces = [(3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
    return add_mesh(name, corners, faces, material)


def add_ball(name, center, radius, material):
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=6, radius=radius, location=center)
    ball = bpy.context.object
    ball.name = name
    bpy.ops.object.shade_smooth()
    ball.data.materials.append(material)
    return ball


def add_camera(location, aim, fov):
    data = bpy.data.cameras.new("eye")
    data.sensor_fit = "VERTICAL"
    data.angle = math.radians(fov)
    eye = bpy.data.objects.new("eye", data)
    scene = bpy.context.scene
    scene.collection.objects.link(eye)
    eye.location = location
    direction = [a - b for a, b in zip(aim, location)]
    eye.rotation_euler = Vector(direction).to_track_quat("-Z", "Y").to_euler()
    scene.camera = eye


def in_file_axes(v):
    return [v[0], v[2], -v[1]]


def camera_text(location, aim, fov):
    return (f"[camera]\nposition = {in_file_axes(location)}\n"
            f"look_at = {in_file_axes(aim)}\nfov = {fov}\n")


def settings_text(samples, seed):
    return (f"[render]\nresolution = [{SIZE}, {SIZE}]\nsamples = {samples}\nseed = {seed}\n"
            f'integrator = "path"\ndepth = {DEPTH}\nbeaming = false\n'
            '[animation]\npictures = 1\n'
            '[output]\nlayers = ["beauty"]\ncompression = "none"\npreview = false\n')


def matt(name, color):
    return (f'[[material]]\nname = "{name}"\nbase_color = {list(color)}\nmetallic = 0\nroughness = 1\n'
            "specular = 0\n")


def cornell():
    """Light of an emitting square between diffuse walls of three colours, and two boxes."""
    emptied()
    white, red, green = (0.73, 0.73, 0.73), (0.65, 0.05, 0.05), (0.12, 0.45, 0.15)
    walls = [diffuse("white", white), diffuse("red", red), diffuse("green", green)]
    lamp = material_of("lamp", "ShaderNodeEmission", (1.0, 0.85, 0.6), Strength=3.0)
    add_quad("floor", [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], walls[0])
    add_quad("ceiling", [(-1, 1, 2), (1, 1, 2), (1, -1, 2), (-1, -1, 2)], walls[0])
    add_quad("back", [(-1, 1, 0), (1, 1, 0), (1, 1, 2), (-1, 1, 2)], walls[0])
    add_quad("left", [(-1, -1, 0), (-1, 1, 0), (-1, 1, 2), (-1, -1, 2)], walls[1])
    add_quad("right", [(1, 1, 0), (1, -1, 0), (1, -1, 2), (1, 1, 2)], walls[2])
    add_quad("light", [(-0.6, 0.6, 1.98), (0.6, 0.6, 1.98), (0.6, -0.6, 1.98), (-0.6, -0.6, 1.98)], lamp)
    add_box("tall", (-0.35, 0.3, 0.6), (0.3, 0.3, 0.6), 0.3, walls[0])
    add_box("short", (0.35, -0.3, 0.3), (0.3, 0.3, 0.3), -0.3, walls[0])
    eye = ((0, -3.9, 1), (0, 0, 1), 39)
    add_camera(*eye)
    text = camera_text(*eye) + '[[object]]\nname = "room"\nasset = "cornell.glb"\n'
    text += matt("white", white) + matt("red", red) + matt("green", green)
    text += ('[[material]]\nname = "lamp"\nbase_color = "black"\nspecular = 0\nroughness = 1\nmetallic = 0\n'
             "emission = [1.0, 0.85, 0.6]\nemission_strength = 3\n")
    return text


def write_sky(path):
    """Brighter and bluer upwards, with a warm patch; latitude and longitude, up first."""
    width, height = 64, 32
    rows = {channel: [] for channel in "BGR"}
    for row in range(height):
        up = 1 - (row + 0.5) / height
        patch = [8.0 if 6 <= row < 12 and 22 <= column < 28 else 0.0 for column in range(width)]
        rows["R"].append([0.2 + 0.2 * up + p for p in patch])
        rows["G"].append([0.2 + 0.4 * up + 0.7 * p for p in patch])
        rows["B"].append([0.2 + 0.8 * up + 0.4 * p for p in patch])
    write_exr(path, rows)


def spheres(folder):
    """A rough metal, a rough glass and a diffuse ball on a plane under a sky."""
    scene = emptied()
    nodes, links = scene.world.node_tree.nodes, scene.world.node_tree.links
    texture = nodes.new("ShaderNodeTexEnvironment")
    write_sky(f"{folder}/sky.exr")
    texture.image = bpy.data.images.load(f"{folder}/sky.exr")
    background = nodes.new("ShaderNodeBackground")
    output = nodes.new("ShaderNodeOutputWorld")
    links.new(texture.outputs["Color"], background.inputs["Color"])
    links.new(background.outputs[0], output.inputs["Surface"])
    ground, clay = (0.5, 0.5, 0.5), (0.7, 0.3, 0.2)
    metal = material_of("metal", "ShaderNodeBsdfGlossy", (1, 1, 1), Roughness=0.25,
                        distribution="MULTI_GGX")
    glass = material_of("glass", "ShaderNodeBsdfGlass", (1, 1, 1), Roughness=0.15, IOR=1.5,
                        distribution="GGX")
    add_quad("ground", [(-6, -6, 0), (6, -6, 0), (6, 6, 0), (-6, 6, 0)], diffuse("ground", ground))
    add_ball("metal", (-1.1, 0, 0.5), 0.5, metal)
    add_ball("glass", (0, -0.3, 0.5), 0.5, glass)
    add_ball("clay", (1.1, 0.2, 0.5), 0.5, diffuse("clay", clay))
    eye = ((0, -6.5, 1.6), (0, 0, 0.55), 26)
    add_camera(*eye)
    text = camera_text(*eye) + '[[object]]\nname = "things"\nasset = "spheres.glb"\n'
    text += matt("ground", ground) + matt("clay", clay)
    text += '[[material]]\nname = "metal"\nbase_color = "white"\nmetallic = 1\nroughness = 0.25\n'
    text += ('[[material]]\nname = "glass"\nbase_color = "white"\nmetallic = 0\nroughness = 0.15\n'
             "ior = 1.5\ntransmission = 1\n")
    text += '[[light]]\ntype = "environment"\nfile = "sky.exr"\n'
    return text
