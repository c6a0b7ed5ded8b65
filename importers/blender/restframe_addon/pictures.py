import bpy


def load(path):
    """The picture as Blender's image, read anew if it is there already."""
    image = bpy.data.images.load(str(path), check_existing=True)
    image.reload()
    return image


def show(context, image):
    """In every image editor that is open, or in a new window."""
    if bpy.app.background:
        return
    editors = [area for window in context.window_manager.windows for area in window.screen.areas
               if area.type == "IMAGE_EDITOR"]
    if not editors:
        bpy.ops.wm.window_new()
        area = context.window_manager.windows[-1].screen.areas[0]
        area.type = "IMAGE_EDITOR"
        editors = [area]
    for area in editors:
        area.spaces.active.image = image
