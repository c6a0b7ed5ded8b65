"""The scene as one .glb, as restframe wants it."""

import bpy

from . import properties


class glTF2ExportUserExtension:  # noqa: N801, the exporter's name for it
    """Called by Blender's glTF exporter: fresh texts, and only these."""

    def __init__(self):
        properties.refresh_all()

    def gather_node_hook(self, node, blender_object, export_settings):
        drop_settings(node)

    def gather_camera_hook(self, camera, blender_camera, export_settings):
        drop_settings(camera)

    def gather_material_hook(self, material, blender_material, export_settings):
        drop_settings(material)

    def gather_scene_hook(self, scene, blender_scene, export_settings):
        drop_settings(scene)


def drop_settings(element):
    """The panels' own values are for Blender only, which exports them as custom properties, too."""
    if isinstance(element.extras, dict):
        element.extras.pop("restframe_settings", None)
        element.extras = element.extras or None


def export(path, context):
    properties.refresh(context.scene)
    bpy.ops.export_scene.gltf(
        filepath=str(path), check_existing=False, export_format="GLB", export_extras=True,
        export_cameras=True, export_lights=True, export_apply=True, export_animations=False,
        use_active_scene=True, use_renderable=True)
