import pathlib

import bpy
from bpy.props import BoolProperty, EnumProperty, IntProperty, StringProperty
from bpy_extras.io_utils import ExportHelper

from . import export, pictures, program, properties

FUNCTIONS = (("base_color", "Base Colour", ""), ("emission", "Emission", ""))
REPORT = "restframe"  # the text that holds all that restframe said


class RESTFRAME_OT_export(bpy.types.Operator, ExportHelper):
    """Export the scene as a .glb that restframe renders as it is"""
    bl_idname = "restframe.export"
    bl_label = "Export for restframe"
    filename_ext = ".glb"
    filter_glob: StringProperty(default="*.glb", options={"HIDDEN"})

    def execute(self, context):
        export.export(self.filepath, context)
        return {"FINISHED"}


class Calling:
    """An operator that exports the scene, calls restframe, and lets Blender live on meanwhile."""

    def execute(self, context):
        self.folder = program.new_folder()
        export.export(self.folder / "scene.glb", context)
        try:
            self.job = program.Job(self.arguments(context), self.folder)
        except RuntimeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if bpy.app.background:
            return self.finish(context)
        window_manager = context.window_manager
        self.timer = window_manager.event_timer_add(0.2, window=context.window)
        window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def progress(self):
        return "at work"

    def modal(self, context, event):
        if event.type == "ESC" and event.value == "PRESS":
            self.job.stop()
        if not self.job.is_done():
            context.workspace.status_text_set(f"restframe: {self.progress()}. Esc stops it")
            return {"PASS_THROUGH"}
        self.let_go(context)
        return self.finish(context)

    def cancel(self, context):
        """Blender takes another file, say."""
        self.job.stop()
        self.job.finish()
        self.let_go(context)

    def let_go(self, context):
        context.window_manager.event_timer_remove(self.timer)
        context.workspace.status_text_set(None)

    def finish(self, context):
        code, lines = self.job.finish()
        note(lines)
        if code == 130:
            self.report({"WARNING"}, "restframe was stopped")
        elif code != 0:
            self.report({"ERROR"}, program.complaint(code, lines))
        else:
            return self.done(context, lines)
        return {"CANCELLED"}


class RESTFRAME_OT_render(Calling, bpy.types.Operator):
    """Render as the camera records it, and show the first picture"""
    bl_idname = "restframe.render"
    bl_label = "Render with restframe"

    animation: BoolProperty(name="Animation", options={"SKIP_SAVE"},
                            description="All pictures, into the scene's folder; else the first, "
                                        "which is not kept")

    def arguments(self, context):
        settings = properties.settings_of(context.scene)
        self.target, self.wanted = self.folder, 1
        if self.animation:
            self.target = pathlib.Path(bpy.path.abspath(settings.folder)).absolute()
            self.wanted = settings.pictures
        arguments = ["render", "scene.glb", "--output", self.target / "picture.####.exr", "--quiet"]
        if not self.animation:
            arguments += ["--pictures", "0"]
        elif settings.overwrite:
            arguments += ["--overwrite"]
        return arguments

    def progress(self):
        made = len(list(self.target.glob("picture.*.exr")))
        return f"{made} of {self.wanted} pictures made"

    def done(self, context, lines):
        pictures.show(pictures.load(self.target / "picture.0000.exr"))
        warnings = [line for line in lines if line.startswith("warning: ")]
        if warnings:
            self.report({"WARNING"}, f"restframe: {warnings[0][len('warning: '):]} "
                                     f"({len(warnings)} in the text \"{REPORT}\")")
        return {"FINISHED"}


class RESTFRAME_OT_check(Calling, bpy.types.Operator):
    """Let restframe look for faults; renders nothing"""
    bl_idname = "restframe.check"
    bl_label = "Check for restframe"

    def arguments(self, context):
        return ["check", "scene.glb"]

    def done(self, context, lines):
        self.report({"INFO"}, "restframe finds no fault")
        return {"FINISHED"}


class RESTFRAME_OT_take_over(bpy.types.Operator):
    """Turn the custom property into a text that goes with these settings"""
    bl_idname = "restframe.take_over"
    bl_label = "Take Over"
    bl_options = {"UNDO", "INTERNAL"}
    of: EnumProperty(items=[(name, name, "") for name in ("object", "camera", "material", "scene")])

    def execute(self, context):
        owner = owner_of(context, self.of)
        settings = properties.settings_of(owner)
        lines = bpy.data.texts.new(f"restframe {owner.name}")
        lines.from_string(str(owner[properties.KEY]))
        del owner[properties.KEY]
        if self.of == "scene":
            settings.by_panel = False
        settings.lines = lines
        return {"FINISHED"}


def owner_of(context, kind):
    """What the panel shows; without one, what goes with the active object."""
    if kind in ("object", "scene"):
        return getattr(context, kind)
    shown = getattr(context, kind, None)
    return shown or (context.object.data if kind == "camera" else context.object.active_material)


def steps_of(context, function):
    material = owner_of(context, "material")
    return getattr(properties.settings_of(material), function).steps


class RESTFRAME_OT_add_step(bpy.types.Operator):
    """One more interval or key, after the last"""
    bl_idname = "restframe.add_step"
    bl_label = "Add"
    bl_options = {"UNDO", "INTERNAL"}
    of: EnumProperty(items=FUNCTIONS)

    def execute(self, context):
        steps = steps_of(context, self.of)
        begin = steps[-1].end if len(steps) else 0.0
        step = steps.add()
        step.begin, step.end = begin, begin + 0.5
        return {"FINISHED"}


class RESTFRAME_OT_remove_step(bpy.types.Operator):
    """Remove this interval or key"""
    bl_idname = "restframe.remove_step"
    bl_label = "Remove"
    bl_options = {"UNDO", "INTERNAL"}
    of: EnumProperty(items=FUNCTIONS)
    index: IntProperty()

    def execute(self, context):
        steps_of(context, self.of).remove(self.index)
        properties.refresh(owner_of(context, "material"))
        return {"FINISHED"}


class RESTFRAME_OT_from_output(bpy.types.Operator):
    """Take resolution, rate and number of pictures from Blender's own output settings"""
    bl_idname = "restframe.from_output"
    bl_label = "As in Blender's Output"
    bl_options = {"UNDO", "INTERNAL"}

    def execute(self, context):
        scene, render = context.scene, context.scene.render
        settings = properties.settings_of(scene)
        percent = render.resolution_percentage
        settings.resolution = (max(1, render.resolution_x * percent // 100),
                               max(1, render.resolution_y * percent // 100))
        settings.rate = render.fps / render.fps_base
        settings.pictures = scene.frame_end - scene.frame_start + 1
        return {"FINISHED"}


def note(lines):
    text = bpy.data.texts.get(REPORT) or bpy.data.texts.new(REPORT)
    text.from_string("\n".join(lines))


OPERATORS = (RESTFRAME_OT_export, RESTFRAME_OT_render, RESTFRAME_OT_check, RESTFRAME_OT_take_over,
             RESTFRAME_OT_add_step, RESTFRAME_OT_remove_step, RESTFRAME_OT_from_output)


def register():
    for operator in OPERATORS:
        bpy.utils.register_class(operator)


def unregister():
    for operator in reversed(OPERATORS):
        bpy.utils.unregister_class(operator)
