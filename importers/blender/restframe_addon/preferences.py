import bpy


class RestframePreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    program: bpy.props.StringProperty(
        name="Program", subtype="FILE_PATH", default="restframe",
        description="The restframe program: its path, or its name where the system finds programs")

    def draw(self, context):
        self.layout.prop(self, "program")


def program_name():
    addon = bpy.context.preferences.addons.get(__package__)
    return addon.preferences.program if addon and addon.preferences else "restframe"


def register():
    bpy.utils.register_class(RestframePreferences)


def unregister():
    bpy.utils.unregister_class(RestframePreferences)
