"""What the panels show, and the custom property "restframe" that is made of it."""

import bpy
from bpy.props import (BoolProperty, CollectionProperty, EnumProperty, FloatProperty,
                       FloatVectorProperty, IntProperty, IntVectorProperty, PointerProperty,
                       StringProperty)

from . import toml_text

KEY = "restframe"


def settings_of(owner):
    """The panel's values of an object, a camera, a material or a scene."""
    return owner.restframe_settings


def has_foreign_text(owner):
    """Whether somebody else wrote the custom property: it is left as it is."""
    return owner.get(KEY) not in (None, settings_of(owner).written)


def own_lines(settings):
    return settings.lines.as_string().splitlines() if settings.lines else []


def text_of(owner):
    settings = settings_of(owner)
    if isinstance(owner, bpy.types.Object):
        lines = [*toml_text.object_lines(settings), *own_lines(settings)]
    elif isinstance(owner, bpy.types.Camera):
        lines = [*toml_text.camera_lines(settings), *own_lines(settings)]
    elif isinstance(owner, bpy.types.Material):
        lines = [*toml_text.material_lines(settings), *own_lines(settings)]
    elif settings.by_panel:
        lines = [*toml_text.scene_lines(settings, camera_name(owner)), *own_lines(settings),
                 *toml_text.sky_lines(settings)]
    else:
        lines = own_lines(settings)
    return "\n".join(lines)


def camera_name(scene):
    return scene.camera.name if scene.camera and scene.camera.type == "CAMERA" else ""


def refresh(owner):
    """Writes the custom property anew."""
    if owner.library or has_foreign_text(owner):
        return
    text = text_of(owner)
    if text:
        owner[KEY] = text
    elif KEY in owner:
        del owner[KEY]
    settings_of(owner).written = text


def refresh_all():
    """Also what no panel tells of: the user's own lines, the scene's camera."""
    for owners in (bpy.data.objects, bpy.data.cameras, bpy.data.materials):
        for owner in owners:
            if not owner.library and (KEY in owner or settings_of(owner).lines):
                refresh(owner)
    for scene in bpy.data.scenes:
        if KEY in scene:
            refresh(scene)


def changed(group, context):
    refresh(group.id_data)


def vector(name, description, **more):
    return FloatVectorProperty(name=name, description=description, subtype="XYZ", precision=6,
                               update=changed, **more)


def color(name, default):
    return FloatVectorProperty(name=name, subtype="COLOR", min=0, soft_max=1, default=default,
                               update=changed)


class Shared:
    """In every group."""

    lines: PointerProperty(
        type=bpy.types.Text, name="More", update=changed,
        description="A text with further lines for restframe: any key of its scene files")
    written: StringProperty(options={"HIDDEN"})


class RestframeStep(bpy.types.PropertyGroup):
    begin: FloatProperty(name="From", precision=4, update=changed,
                         description="Seconds of the object's own clock")
    end: FloatProperty(name="To", precision=4, default=0.5, update=changed,
                       description="Seconds of the object's own clock; the colour holds until then")
    color: color("Colour", (1, 1, 1))


class RestframeFunction(bpy.types.PropertyGroup):
    kind: EnumProperty(name="Over Time", update=changed, items=(
        ("NONE", "As It Is", "The material's own colour"),
        ("INTERVALS", "Intervals", "Constant in each interval; in gaps the material's own colour"),
        ("KEYS", "Keys", "Straight from key to key, in rising time"),
        ("FORMULA", "Formula", "From one colour to another as a formula in t goes from 0 to 1")))
    period: FloatProperty(
        name="Period", min=0, precision=4, update=changed,
        description="Seconds after which it begins again; 0: never. Times are from 0 to the period")
    steps: CollectionProperty(type=RestframeStep)
    formula: StringProperty(name="Formula", default="0.5 + 0.5*sin(2*pi*t)", update=changed,
                            description="In t, seconds of the object's own clock, and pi")
    from_color: color("At 0", (0, 0, 0))
    to_color: color("At 1", (1, 1, 1))


class RestframeObject(Shared, bpy.types.PropertyGroup):
    kind: EnumProperty(name="Motion", update=changed, items=(
        ("NONE", "None", "Goes with its parent, or rests"),
        ("VELOCITY", "Velocity", "In fractions of the speed of light"),
        ("GAMMA", "Gamma and Direction", "Lorentz factor, for what is very close to that speed")))
    velocity: vector("Velocity", "Fractions of the speed of light, along Blender's axes", min=-1, max=1)
    gamma: FloatProperty(name="Gamma", min=1, max=1e8, default=2, precision=4, update=changed)
    direction: vector("Direction", "Which way it moves, of any length", default=(1, 0, 0))
    time: FloatProperty(name="Time", precision=4, update=changed,
                        description="Seconds, world time at which it is where Blender shows it")
    clock: FloatProperty(name="Clock", precision=4, update=changed,
                         description="Seconds that its own clock shows then")
    frame_clock: BoolProperty(
        name="Clock of Its Rest Frame", update=changed,
        description="Agree with everything of this velocity, as those who move along see it")


class RestframeCamera(Shared, bpy.types.PropertyGroup):
    velocity: vector("Velocity", "Fractions of the speed of light, along Blender's axes", min=-1, max=1)
    time: FloatProperty(name="Time", precision=4, update=changed,
                        description="Seconds, world time at which it is where Blender shows it "
                                    "and its own clock shows 0")


class RestframeMaterial(Shared, bpy.types.PropertyGroup):
    base_color: PointerProperty(type=RestframeFunction)
    emission: PointerProperty(type=RestframeFunction)


class RestframeScene(Shared, bpy.types.PropertyGroup):
    by_panel: BoolProperty(
        name="By These Settings", default=True, update=changed,
        description="Otherwise only the text below says what the scene is")
    light_speed: FloatProperty(
        name="Light Speed", min=1e-6, default=1, soft_max=3e8, update=changed,
        description="Blender's units that light travels in a second")
    resolution: IntVectorProperty(name="Resolution", size=2, min=1, max=32768,
                                  default=(1280, 720), update=changed)
    samples: IntProperty(name="Samples", min=1, max=65536, default=16, update=changed)
    integrator: EnumProperty(name="Integrator", update=changed, items=(
        ("PREVIEW", "Preview", "Colours by the angle they are seen at, no lights"),
        ("PATH", "Path", "Light from lamps, the sky and what glows")))
    doppler: BoolProperty(name="Doppler Shift", update=changed, description="Colours shift")
    beaming: BoolProperty(name="Beaming", update=changed,
                          description="What comes is brighter, by the fourth power of the shift")
    start: FloatProperty(name="Start", precision=4, update=changed,
                         description="Seconds of the camera's clock at the first picture")
    rate: FloatProperty(name="Rate", min=1e-6, default=10, update=changed,
                        description="Pictures a second of the camera's clock")
    pictures: IntProperty(name="Pictures", min=1, max=1000000, default=1, update=changed)
    layers: StringProperty(name="Layers", default="beauty, Z", update=changed,
                           description="Names of restframe's layers, with commas between")
    sky: FloatProperty(name="Sky", min=0, update=changed,
                       description="Radiance of a sky that is the same everywhere; 0: none")
    sky_color: color("Colour of the Sky", (1, 1, 1))
    folder: StringProperty(name="Pictures In", subtype="DIR_PATH", default="//restframe/",
                           description="Where an animation is written to")
    overwrite: BoolProperty(
        name="Overwrite", description="Replace pictures that are there; otherwise they are kept, "
                                      "and those of a changed scene are refused")


GROUPS = (RestframeStep, RestframeFunction, RestframeObject, RestframeCamera, RestframeMaterial,
          RestframeScene)
OWNERS = ((bpy.types.Object, RestframeObject), (bpy.types.Camera, RestframeCamera),
          (bpy.types.Material, RestframeMaterial), (bpy.types.Scene, RestframeScene))


def register():
    for group in GROUPS:
        bpy.utils.register_class(group)
    for owner, group in OWNERS:
        owner.restframe_settings = PointerProperty(type=group)


def unregister():
    for owner, _ in OWNERS:
        del owner.restframe_settings
    for group in reversed(GROUPS):
        bpy.utils.unregister_class(group)
