"""Text for restframe out of plain values. Knows nothing of Blender but its axes."""

import json
import struct


def number(value):
    """The shortest text of a number; Blender keeps its properties in 32 bits."""
    if isinstance(value, int):
        return str(value)
    for digits in range(6, 18):
        text = f"{value:.{digits}g}"
        if float(text) == value or in_32_bits(float(text)) == value:
            break
    value = float(text)
    return repr(0.0 if value == 0 else value)


def in_32_bits(value):
    return struct.unpack("<f", struct.pack("<f", value))[0]


def numbers(values):
    return "[" + ", ".join(number(value) for value in values) + "]"


def text(value):
    """A string of TOML; JSON's escapes are among TOML's."""
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")


def gltf_axes(vector):
    """Blender has z up, glTF y: its x, z and -y."""
    x, y, z = vector
    return (x, z, -y)


def object_lines(motion):
    if motion.kind == "VELOCITY":
        yield f"velocity = {numbers(gltf_axes(motion.velocity))}"
    if motion.kind == "GAMMA":
        yield f"gamma = {number(motion.gamma)}"
        yield f"direction = {numbers(gltf_axes(motion.direction))}"
    if motion.time != 0:
        yield f"time = {number(motion.time)}"
    if motion.frame_clock:
        yield 'clock = "frame"'
    elif motion.clock != 0:
        yield f"clock = {number(motion.clock)}"


def camera_lines(motion):
    if any(motion.velocity):
        yield f"velocity = {numbers(gltf_axes(motion.velocity))}"
    if motion.time != 0:
        yield f"time = {number(motion.time)}"


def function_of_time(function):
    """A colour over the clock as an inline table; "" where the material's own colour holds."""
    period = [f"period = {number(function.period)}"] if function.period > 0 else []
    if function.kind == "INTERVALS":
        steps = [f"[{number(s.begin)}, {number(s.end)}, {numbers(s.color)}]" for s in function.steps]
        return inline(period + ["intervals = [" + ", ".join(steps) + "]"])
    if function.kind == "KEYS":
        steps = [f"[{number(s.begin)}, {numbers(s.color)}]" for s in function.steps]
        return inline(period + ["keys = [" + ", ".join(steps) + "]"])
    if function.kind == "FORMULA":
        ends = [f"from = {numbers(function.from_color)}", f"to = {numbers(function.to_color)}"]
        return inline([f"formula = {text(function.formula)}", *ends])
    return ""


def inline(entries):
    return "{" + ", ".join(entries) + "}"


def material_lines(look):
    for key in ("base_color", "emission"):
        function = function_of_time(getattr(look, key))
        if function:
            yield f"{key} = {function}"


def scene_lines(settings, camera):
    """Dotted keys throughout, so that the user's own lines after them may add tables."""
    if camera:
        yield f"camera = {text(camera)}"
    yield f"scene.light_speed = {number(settings.light_speed)}"
    yield f"animation.rate = {number(settings.rate)}"
    yield f"animation.start = {number(settings.start)}"
    yield f"animation.pictures = {settings.pictures}"
    yield f"render.resolution = {numbers(settings.resolution)}"
    yield f"render.samples = {settings.samples}"
    yield f"render.integrator = {text(settings.integrator.lower())}"
    for switch in ("doppler", "beaming"):
        if getattr(settings, switch):
            yield f"render.{switch} = true"
    layers = [text(name) for name in settings.layers.replace(",", " ").split()]
    yield "output.layers = [" + ", ".join(layers) + "]"


def sky_lines(settings):
    """A table, so after all plain keys."""
    if settings.sky > 0:
        yield "[[light]]"
        yield 'type = "environment"'
        yield f"color = {numbers(settings.sky_color)}"
        yield f"intensity = {number(settings.sky)}"
