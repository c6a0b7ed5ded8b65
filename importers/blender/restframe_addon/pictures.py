import functools

import bpy


def load(path):
    """The picture as Blender's image, read anew if it is there already."""
    image = bpy.data.images.load(str(path), check_existing=True)
    image.reload()
    return image


def show(image):
    """Soon, when the operator that made it is over: a new window hands out events meanwhile."""
    if not bpy.app.background:
        bpy.app.timers.register(functools.partial(show_now, image.name), first_interval=0.01)


def show_now(name):
    """In every image editor that is open, or in a new window."""
    windows = bpy.context.window_manager.windows
    editors = [area for window in windows for area in window.screen.areas
               if area.type == "IMAGE_EDITOR"]
    for area in editors or [new_editor(windows)]:
        area.spaces.active.image = bpy.data.images.get(name)


def new_editor(windows):
    with bpy.context.temp_override(window=windows[0]):
        bpy.ops.wm.window_new()
    area = windows[-1].screen.areas[0]
    area.type = "IMAGE_EDITOR"
    return area
