"""Run by Blender: the same scenes by Cycles and by restframe, each twice, and how they differ.

    blender --background --factory-startup --python cycles.py -- PROGRAM FOLDER TABLE.csv

Pictures are compared by the means of square blocks. The noise of a block's mean follows from the two
renderings of each program; a difference beyond the noise is an error (a z-test over all blocks and
channels, Sidak-corrected).
"""

import pathlib
import statistics
import subprocess
import sys

import bpy
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cycles_scenes as scenes  # noqa: E402

BLOCK = 8
CYCLES_SAMPLES, OWN_SAMPLES = 256, 256
CHANCE = 1e-3  # that equal renderers fail


def read_picture(path):
    image = bpy.data.images.load(str(path))
    width, height = image.size
    pixels = numpy.empty(width * height * 4, dtype=numpy.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return pixels.reshape(height, width, 4)[:, :, :3].astype(float)


def by_cycles(path, seed):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples, cycles.seed = CYCLES_SAMPLES, seed
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = scenes.DEPTH
    cycles.transmission_bounces = cycles.transparent_max_bounces = scenes.DEPTH
    cycles.caustics_reflective = cycles.caustics_refractive = True
    cycles.blur_glossy = cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.light_sampling_threshold = 0
    # restframe's is a tent of radius 1; this one has its second moment.
    cycles.pixel_filter_type, cycles.filter_width = "BLACKMAN_HARRIS", 1.47
    render = scene.render
    render.resolution_x = render.resolution_y = scenes.SIZE
    render.resolution_percentage = 100
    render.threads_mode, render.threads = "FIXED", 2
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_depth = "32"
    scene.view_settings.view_transform = "Standard"
    render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    return read_picture(path)


def by_restframe(program, folder, name, text, seed):
    file = folder / f"{name}.toml"
    file.write_text(text + scenes.settings_text(OWN_SAMPLES, seed))
    output = folder / f"{name}_own_{seed}.exr"
    subprocess.run([program, "render", str(file), "--output", str(output), "--quiet", "--overwrite"],
                   check=True, timeout=600, stdin=subprocess.DEVNULL)
    return read_picture(output)


def block_means(picture):
    n = picture.shape[0] // BLOCK
    return picture.reshape(n, BLOCK, n, BLOCK, 3).mean(axis=(1, 3))


def compared(cycles, own):
    """Relative difference of the whole, largest z of a block's mean, its bound, largest relative difference."""
    a, b = [block_means(p) for p in cycles], [block_means(p) for p in own]
    mean_a, mean_b = (a[0] + a[1]) / 2, (b[0] + b[1]) / 2
    # Two renderings tell a block's noise badly; all blocks together tell how noise goes with brightness.
    def noise(pair, mean):
        floor = 1e-4 * mean.mean()
        relative = numpy.abs(pair[0] - pair[1]) / numpy.sqrt(mean * mean.mean() + floor)
        typical = numpy.sqrt((relative ** 2).mean() / 4)
        return numpy.maximum(typical * numpy.sqrt(mean * mean.mean() + floor),
                             numpy.abs(pair[0] - pair[1]) / 2)
    sigma = numpy.sqrt(noise(a, mean_a) ** 2 + noise(b, mean_b) ** 2)
    z = (mean_b - mean_a) / sigma
    bound = statistics.NormalDist().inv_cdf((1 + (1 - CHANCE) ** (1 / z.size)) / 2)
    whole = mean_b.mean() / mean_a.mean() - 1
    worst = numpy.abs(mean_b - mean_a).max() / mean_a.mean()
    return whole, numpy.abs(z).max(), bound, worst


def main():
    program, folder, table = sys.argv[sys.argv.index("--") + 1:]
    folder = pathlib.Path(folder)
    rows, failed = ["scene,whole over Cycles' - 1,largest z,its bound,largest difference over mean"], []
    for name, build in (("cornell", scenes.cornell), ("spheres", lambda: scenes.spheres(folder))):
        text = build()
        bpy.ops.export_scene.gltf(filepath=str(folder / f"{name}.glb"), export_apply=True)
        own = [by_restframe(program, folder, name, text, seed) for seed in (1, 2)]
        cycles = [by_cycles(folder / f"{name}_cycles_{seed}.exr", seed) for seed in (1, 2)]
        whole, z, bound, worst = compared(cycles, own)
        rows.append(f"{name},{whole:.5f},{z:.2f},{bound:.2f},{worst:.4f}")
        if z > bound:
            failed.append(name)
    pathlib.Path(table).write_text("\n".join(rows) + "\n")
    print("\n".join(rows))
    if failed:
        sys.exit(f"error: beyond the noise: {', '.join(failed)}")


main()
