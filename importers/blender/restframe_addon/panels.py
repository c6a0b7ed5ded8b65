import math

import bpy

from . import properties


class Panel:
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_label = "restframe"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        return cls.owner(context) is not None

    @classmethod
    def owner(cls, context):
        return getattr(context, cls.bl_context_owner)

    def draw(self, context):
        owner = self.owner(context)
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        if properties.has_foreign_text(owner):
            layout.label(text='The custom property "restframe" was not written here', icon="INFO")
            if isinstance(owner[properties.KEY], str):
                layout.operator("restframe.take_over").of = self.bl_context_owner
            return
        settings = properties.settings_of(owner)
        self.draw_settings(layout, settings)
        layout.prop(settings, "lines")


def draw_velocity(layout, settings):
    layout.prop(settings, "velocity")
    speed = math.sqrt(sum(v * v for v in settings.velocity))
    if speed >= 1:
        layout.label(text=f"Is {speed:.4f}, must be below 1", icon="ERROR")


class OBJECT_PT_restframe(Panel, bpy.types.Panel):
    bl_context = "object"
    bl_context_owner = "object"

    @classmethod
    def poll(cls, context):
        return super().poll(context) and context.object.type != "CAMERA"

    def draw_settings(self, layout, settings):
        layout.prop(settings, "kind")
        if settings.kind == "VELOCITY":
            draw_velocity(layout, settings)
        elif settings.kind == "GAMMA":
            layout.prop(settings, "gamma")
            layout.prop(settings, "direction")
        layout.prop(settings, "time")
        layout.prop(settings, "frame_clock")
        row = layout.row()
        row.active = not settings.frame_clock
        row.prop(settings, "clock")


class DATA_PT_restframe_camera(Panel, bpy.types.Panel):
    bl_context = "data"
    bl_context_owner = "camera"

    def draw_settings(self, layout, settings):
        draw_velocity(layout, settings)
        layout.prop(settings, "time")


class MATERIAL_PT_restframe(Panel, bpy.types.Panel):
    bl_context = "material"
    bl_context_owner = "material"

    def draw_settings(self, layout, settings):
        self.draw_function(layout.box(), settings, "base_color", "Base Colour")
        self.draw_function(layout.box(), settings, "emission", "Emission")

    def draw_function(self, layout, settings, of, name):
        function = getattr(settings, of)
        layout.prop(function, "kind", text=name)
        if function.kind == "FORMULA":
            for key in ("formula", "from_color", "to_color"):
                layout.prop(function, key)
        elif function.kind != "NONE":
            layout.prop(function, "period")
            self.draw_steps(layout, function, of)

    def draw_steps(self, layout, function, of):
        for index, step in enumerate(function.steps):
            row = layout.row(align=True)
            row.use_property_split = False
            row.prop(step, "begin", text="" if function.kind == "INTERVALS" else "At")
            if function.kind == "INTERVALS":
                row.prop(step, "end", text="")
            row.prop(step, "color", text="")
            remove = row.operator("restframe.remove_step", text="", icon="X")
            remove.of, remove.index = of, index
        layout.operator("restframe.add_step", icon="ADD").of = of


class SCENE_PT_restframe(Panel, bpy.types.Panel):
    bl_context = "scene"
    bl_context_owner = "scene"

    def draw_settings(self, layout, settings):
        layout.prop(settings, "by_panel")
        if settings.by_panel:
            for keys in (("light_speed",), ("resolution", "rate", "start", "pictures"),
                         ("samples", "integrator", "doppler", "beaming"), ("sky", "sky_color"),
                         ("layers",)):
                column = layout.column(align=True)
                for key in keys:
                    column.prop(settings, key)
            layout.operator("restframe.from_output")
        for key in ("folder", "overwrite"):
            layout.prop(settings, key)

    def draw(self, context):
        super().draw(context)
        row = self.layout.row()
        row.operator("restframe.render", text="Render First Picture", icon="RENDER_STILL")
        animation = row.operator("restframe.render", text="Render Animation", icon="RENDER_ANIMATION")
        animation.animation = True
        row = self.layout.row()
        row.operator("restframe.check", text="Check")
        row.operator("restframe.export", text="Export")


PANELS = (OBJECT_PT_restframe, DATA_PT_restframe_camera, MATERIAL_PT_restframe, SCENE_PT_restframe)


def draw_in_render_menu(menu, context):
    menu.layout.separator()
    menu.layout.operator("restframe.render", icon="RENDER_STILL")


def register():
    for panel in PANELS:
        bpy.utils.register_class(panel)
    bpy.types.TOPBAR_MT_render.append(draw_in_render_menu)


def unregister():
    bpy.types.TOPBAR_MT_render.remove(draw_in_render_menu)
    for panel in reversed(PANELS):
        bpy.utils.unregister_class(panel)
