"""Times restframe, Cycles and Embree's path tracer on the bench lattice; writes a table.

    compare.py PROGRAM COUNTER.so FOLDER TABLE.csv

The error of n samples against a converged picture is told by two independent pictures of n samples: they
differ by sqrt(2) times as much. Time for a given error: time per sample times the squared error of one.
"""

import itertools
import os
import pathlib
import re
import subprocess
import sys
import time

import numpy

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parent.parent / "clients"))
from blender_exr import read_exr  # noqa: E402

PROGRAM, COUNTER, FOLDER, TABLE = sys.argv[1:]
FOLDER = pathlib.Path(FOLDER)
FEW, MANY = 4, 12
ROUNDS = 5

SCENE = """[camera]
position = [0.3, 0.4, {z}]
look_at = [0.3, 0.4, {aim}]
fov = 60
[animation]
pictures = 1
[render]
resolution = [1280, 720]
integrator = "path"
depth = 4
doppler = {doppler}
[output]
layers = ["beauty"]
compression = "none"
preview = false
[[object]]
name = "lattice"
asset = "lattice.glb"
velocity = [0, 0, {beta}]
[[material]]
name = "*"
base_color = [0.8, 0.8, 0.8]
metallic = 0
roughness = 1
specular = 0
[[light]]
type = "environment"
color = "white"
intensity = 1
"""
SCENES = {
    "rest": dict(z=12.0, aim=0.0, beta=0.0, doppler="false"),
    "spectral": dict(z=12.0, aim=0.0, beta=0.0, doppler="true"),
    "inside": dict(z=1.0, aim=-11.0, beta=0.0, doppler="false"),
    "moving": dict(z=1.0, aim=-11.0, beta=0.99, doppler="false"),
}


def run(command, **more):
    begin = time.monotonic()
    done = subprocess.run(command, check=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, **more)
    return time.monotonic() - begin, done.stdout


def restframe(scene, samples, seed, **more):
    output = FOLDER / f"{scene}_{samples}_{seed}.exr"
    file = FOLDER / f"{scene}_{seed}.toml"
    file.write_text(SCENE.format(**SCENES[scene]).replace("[render]", f"[render]\nseed = {seed}"))
    seconds, said = run([PROGRAM, "render", file, "--samples", str(samples), "--threads", "2",
                         "--output", output, "--overwrite", "--quiet"], **more)
    return seconds, output, said


def rays_of(scene, samples):
    said = restframe(scene, samples, 1, env={**os.environ, "LD_PRELOAD": COUNTER})[2]
    return int(re.search(r"rays (\d+)", said).group(1))


def cycles(samples, seed):
    output = FOLDER / f"cycles_{samples}_{seed}.exr"
    seconds, said = run(["blender", "--background", "--factory-startup", "--python-exit-code", "1", "--python",
                         HERE / "lattice_in_cycles.py", "--", FOLDER / "lattice.glb", str(samples), str(seed),
                         output])
    return seconds, output, float(re.search(r"rendering took ([\d.]+)", said).group(1))


def embree():
    said = run(["pathtracer", "--threads", "2", "-i", FOLDER / "lattice.obj", "--ambientlight", "1", "1", "1",
                "--spp", "1", "--max-path-length", "5", "--size", "1280", "720", "--vp", "0.3", "0.4", "12",
                "--vi", "0.3", "0.4", "0", "--vu", "0", "1", "0", "--fov", "60", "--accumulate", "0",
                "--benchmark", "2", "8"])[1]
    return float(re.search(r"MRAYPS_MAX ([\d.]+)", said).group(1))


def squared_error(first, second):
    pictures = []
    for path in (first, second):
        _, _, rows, _ = read_exr(path)
        pictures.append(numpy.array([rows[name] for name in "RGB"], dtype=float))
    return float(((pictures[0] - pictures[1]) ** 2).mean() / 2)


def least_seconds():
    """Of each scene and number of samples. They take turns: a slow moment of the machine meets all of them."""
    least = {}
    for _ in range(ROUNDS):
        for key in itertools.product(SCENES, (FEW, MANY)):
            seconds = restframe(*key, 1)[0]
            least[key] = min(seconds, least.get(key, seconds))
    return least


def main():
    for name in ("lattice.glb", "lattice.obj"):
        run([PROGRAM, "lattice", "-o", FOLDER / name, "--instances", "none"])
    least = least_seconds()
    # A sample, without what does not depend on their number.
    own = {scene: (least[scene, MANY] - least[scene, FEW]) / (MANY - FEW) for scene in SCENES}
    rays = {scene: (rays_of(scene, MANY) - rays_of(scene, FEW)) / (MANY - FEW) for scene in SCENES}
    own_whole = least["rest", MANY]
    own_error = squared_error(*(restframe("rest", MANY, seed)[1] for seed in (1, 2)))
    theirs = [cycles(MANY, seed) for seed in (1, 2)]
    theirs_whole, theirs_render = (min(picture[i] for picture in theirs) for i in (0, 2))
    theirs_error = squared_error(*(picture for _, picture, _ in theirs))
    theirs_rays = max(embree() for _ in range(ROUNDS))
    pixels = 1280 * 720
    rows = ["quantity,value,goal"]

    def row(name, value, goal=""):
        rows.append(f"{name},{value:.4g},{goal}")

    row("samples a second (millions)", pixels / own["rest"] / 1e6)
    row("Cycles' samples a second (millions)", pixels * MANY / theirs_render / 1e6)
    row(f"root of mean squared error at {MANY} samples", own_error ** 0.5)
    row(f"Cycles' root of mean squared error at {MANY} samples", theirs_error ** 0.5)
    row("Cycles' time to equal error over ours: rendering",
        theirs_render * theirs_error / (own["rest"] * MANY * own_error))
    row("Cycles' time to equal error over ours: whole program",
        (theirs_whole - theirs_render + theirs_render * theirs_error / own_error) / own_whole, "at least 4")
    row("rays a second (millions)", rays["rest"] / own["rest"] / 1e6)
    row("Embree's path tracer's rays a second (millions)", theirs_rays)
    row("rays a second over Embree's path tracer's", rays["rest"] / own["rest"] / 1e6 / theirs_rays, "at least 1.5")
    row("time a ray at 0.99c over at rest (camera inside)",
        (own["moving"] / rays["moving"]) / (own["inside"] / rays["inside"]), "at most 1.15")
    row("doppler on over off", own["spectral"] / own["rest"], "at most 1.3")
    pathlib.Path(TABLE).write_text("\n".join(rows) + "\n")
    print("\n".join(rows))


main()
