"""Run by Blender: the bench lattice under a white sky, by Cycles.

    blender --background --factory-startup --python lattice_in_cycles.py -- LATTICE.glb SAMPLES SEED OUT.exr
"""

import math
import sys
import time

import bpy
import numpy

numpy.bool = bool  # Debian 12's importer of glTF asks for this old name

lattice, samples, seed, output = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
scene.world = bpy.data.worlds.new("sky")
scene.world.use_nodes = True
scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (1, 1, 1, 1)
bpy.ops.import_scene.gltf(filepath=lattice)
clay = bpy.data.materials.new("clay")
clay.use_nodes = True
nodes, links = clay.node_tree.nodes, clay.node_tree.links
nodes.clear()
shader, out = nodes.new("ShaderNodeBsdfDiffuse"), nodes.new("ShaderNodeOutputMaterial")
shader.inputs["Color"].default_value = (0.8, 0.8, 0.8, 1)
links.new(shader.outputs[0], out.inputs["Surface"])
for mesh in bpy.data.meshes:
    for i in range(len(mesh.materials)):
        mesh.materials[i] = clay

data = bpy.data.cameras.new("eye")
data.sensor_fit, data.angle = "VERTICAL", math.radians(60)
eye = bpy.data.objects.new("eye", data)
scene.collection.objects.link(eye)
eye.location, eye.rotation_euler = (0.3, -12, 0.4), (math.pi / 2, 0, 0)  # (0.3, 0.4, 12) with y up
scene.camera = eye

scene.render.engine = "CYCLES"
cycles, render = scene.cycles, scene.render
cycles.device, cycles.samples, cycles.seed = "CPU", int(samples), int(seed)
cycles.use_adaptive_sampling = cycles.use_denoising = False
cycles.max_bounces = cycles.diffuse_bounces = 4
cycles.pixel_filter_type = "BOX"
render.resolution_x, render.resolution_y, render.resolution_percentage = 1280, 720, 100
render.threads_mode, render.threads = "FIXED", 2
render.image_settings.file_format, render.image_settings.color_depth = "OPEN_EXR", "32"
render.image_settings.exr_codec = "NONE"
render.filepath = output
begin = time.monotonic()
bpy.ops.render.render(write_still=True)
print(f"rendering took {time.monotonic() - begin:.3f}")
