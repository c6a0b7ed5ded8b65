"""Renders the models of models.csv, puts the pictures on sheets and writes down how each came out.

Usage: sheets.py RESTFRAME MODELS SELF_MADE
MODELS is the folder of assimp-testmodels, SELF_MADE that of self_made.py. Pictures are numbered on their
sheet as in the table; the columns that a person fills in stay as they are.
"""

import csv
import pathlib
import subprocess
import sys
import tempfile

import png

HERE = pathlib.Path(__file__).resolve().parent
WIDTH, HEIGHT, COLUMNS, LIMIT = 160, 120, 8, 300_000
KINDS = (".glb", ".gltf", ".obj", ".ply", ".stl", ".off")
FONT = ("111101101101111", "010110010010111", "111001111100111", "111001111001111", "101101111001001",
        "111100111001111", "111100111101111", "111001001001001", "111101111101111", "111101111001111")
PATH = '[render]\nintegrator = "path"\nsamples = 64\n'
SKY = '[[light]]\ntype = "environment"\nintensity = 0.3\n'


def scene_of(model, view):
    """A scene file for the path integrator, with the model's own lights, and maybe those of a white sky."""
    return f'[[object]]\nasset = "{model}"\n' + PATH + (SKY if "sky" in view else "")


def render(program, model, view, folder):
    """(exit code, first error, warnings, rows of the picture or None)"""
    shown = model
    options = ["--samples", "16"]
    if view.startswith("path"):
        shown, options = folder / "scene.toml", []
        shown.write_text(scene_of(model, view))
    elif view.startswith("variant"):
        options += ["--variant", view.split()[1]]
    run = subprocess.run([program, "render", shown, "--size", f"{WIDTH}x{HEIGHT}", "--output",
                          folder / "picture.exr", "--overwrite", "--quiet", *options],
                         capture_output=True, text=True, timeout=20, check=False)
    lines = run.stderr.splitlines()
    errors = [line for line in lines if line.startswith("error:")]
    warnings = [line for line in lines if line.startswith("warning:")]
    picture = png.read(folder / "picture.png") if run.returncode == 0 else None
    return run.returncode, errors[0] if errors else "", warnings, picture


def outcome_of(model, code, error, warnings):
    if code == 0:
        return f"rendered, warnings: {len(warnings)}" if warnings else "rendered"
    name = str(model)
    text = error.removeprefix("error: ")
    at = text.find(name)
    return ("refused: " if code == 2 else f"exit code {code}: ") + (
        text[at + len(name):].lstrip(": ") if at >= 0 else text)


def number_onto(rows, number):
    for place, digit in enumerate(str(number)):
        for i, bit in enumerate(FONT[int(digit)]):
            for dy in range(2):
                for dx in range(2):
                    x, y = 3 + 8 * place + 2 * (i % 3) + dx, 3 + 2 * (i // 3) + dy
                    rows[y][3 * x:3 * x + 3] = b"\xff\xff\x60" if bit == "1" else b"\0\0\0"


def sheet_of(pictures):
    columns = min(COLUMNS, len(pictures))
    height = -(-len(pictures) // columns) * HEIGHT
    rows = [bytearray(columns * WIDTH * 3) for _ in range(height)]
    for i, picture in enumerate(pictures):
        left, top = i % columns * WIDTH, i // columns * HEIGHT
        for y, line in enumerate(picture):
            rows[top + y][3 * left:3 * (left + WIDTH)] = line
    return png.written(columns * WIDTH, height, b"".join(rows))


def report(rows, models):
    """What a person must look at: models that the table lacks, and what neither rendered nor was refused."""
    listed = {row["file"] for row in rows}
    for path in sorted(models.rglob("*")):
        name = path.relative_to(models).as_posix()
        if path.suffix.lower() in KINDS and name not in listed:
            print(f"models.csv lacks {name}")
    for row in rows:
        if not row["outcome"].startswith(("rendered", "refused")):
            print(row["file"], row["outcome"])
    rendered = sum(row["outcome"].startswith("rendered") for row in rows)
    print(f"{rendered} pictures, {len(rows) - rendered} refused")


def main():
    program, models, self_made = (pathlib.Path(word).resolve() for word in sys.argv[1:])
    with (HERE / "models.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    sheets = {}
    with tempfile.TemporaryDirectory() as folder:
        for row in rows:
            model = (self_made if row["sheet"] == "self_made" else models) / row["file"]
            code, error, warnings, picture = render(program, model, row["view"], pathlib.Path(folder))
            row["outcome"] = outcome_of(model, code, error, warnings)
            row["number"] = ""
            if picture:
                pictures = sheets.setdefault(row["sheet"], [])
                row["number"] = len(pictures) + 1
                pictures.append([bytearray(c for pixel in row for c in pixel[:3]) for row in picture])
                number_onto(pictures[-1], row["number"])
    for name, pictures in sheets.items():
        data = sheet_of(pictures)
        assert len(data) < LIMIT, f"{name}.png has {len(data)} bytes"
        (HERE / f"{name}.png").write_bytes(data)
    with (HERE / "models.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    report(rows, models)


main()
