"""Run by Blender: builds a scene whose custom properties speak to restframe, and exports it.

    blender --background --factory-startup --python blender_scene.py -- scene.glb

Blender has z up: what is at (x, y, z) there is at (x, z, -y) in the file. The texts in custom
properties are not turned; their vectors are in the file's axes.
"""

import sys

import bpy

# Which way each ball moves, in the file's axes, and what blender_check.py looks for.
BALLS = {
    "away": ((-2.5, 10, 0), "velocity = [0, 0, -0.6]"),
    "towards": ((0, 10, 0), 'velocity = [0, 0, 0.6]\nclock = "frame"'),
    "across": ((2.5, 10, 0), "gamma = 2.0\ndirection = [0, 1, 0]\ntime = -10"),
}
MATERIALS = {
    "away": 'base_color = "red"',
    "towards": "[emission]\nperiod = 2.0\nintervals = [[0.0, 1.0, [0.0, 0.25, 0.0]], "
               "[1.0, 2.0, [0.0, 0.0, 0.5]]]",
    "across": "emission = [0.0, 0.0, 0.0]",
}
SCENE = """
[animation]
start = 0.0
[render]
resolution = [192, 64]
samples = 1
[output]
layers = ["beauty", "Z", "time", "doppler", "N", "P", "id"]
compression = "none"
preview = false
"""


def add_material(name):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (0.0, 0.0, 0.0, 1.0)
    material["restframe"] = MATERIALS[name]
    return material


def add_ball(name, location, said):
    bpy.ops.mesh.primitive_uv_sphere_add(segments=64, ring_count=32, radius=1, location=location)
    ball = bpy.context.object
    ball.name = name
    bpy.ops.object.shade_smooth()
    ball.data.materials.append(add_material(name))
    ball["restframe"] = said
    return ball


def add_camera():
    """At the origin, looking along Blender's +y, which is the file's -z."""
    data = bpy.data.cameras.new("eye")
    data["restframe"] = "fov = 30"
    camera = bpy.data.objects.new("eye", data)
    camera.rotation_euler = (1.5707963267948966, 0, 0)
    bpy.context.collection.objects.link(camera)


def add_moon(planet):
    """A child without words: it goes with its parent."""
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=3, radius=0.2, location=(-2.5, 10, 1.5))
    moon = bpy.context.object
    moon.name = "moon"
    moon.data.materials.append(planet.data.materials[0])
    moon.parent = planet
    moon.matrix_parent_inverse = planet.matrix_world.inverted()


def main():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    for name, (location, said) in BALLS.items():
        add_ball(name, location, said)
    bpy.context.view_layer.update()
    add_moon(bpy.data.objects["away"])
    add_camera()
    bpy.context.scene["restframe"] = SCENE
    target = sys.argv[sys.argv.index("--") + 1]
    bpy.ops.export_scene.gltf(filepath=target, export_format="GLB", export_extras=True,
                              export_cameras=True, export_lights=True)


main()
