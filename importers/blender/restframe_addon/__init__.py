"""restframe in Blender: panels for what its glTF reader finds in custom properties, and pictures.

The panels keep one custom property, a text called "restframe", on objects, cameras, materials and the
scene. Every glTF export with Custom Properties ticked carries it, with or without this add-on.
"""

bl_info = {
    "name": "restframe",
    "description": "Velocities, clocks and colours over time; renders them as they are seen",
    "author": "restframe contributors",
    "version": (1, 0, 0),
    "blender": (3, 4, 0),
    "location": "Properties: Object, Material, Camera and Scene; Render menu",
    "category": "Render",
}

import atexit

from . import operators, panels, preferences, program, properties
from .export import glTF2ExportUserExtension  # Blender's exporter looks for it here

__all__ = ["glTF2ExportUserExtension", "register", "unregister"]

MODULES = (preferences, properties, operators, panels)


def register():
    for module in MODULES:
        module.register()
    atexit.register(program.stop_all)


def unregister():
    atexit.unregister(program.stop_all)
    program.stop_all()
    for module in reversed(MODULES):
        module.unregister()
