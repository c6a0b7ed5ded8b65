#!/usr/bin/env python3
"""Makes stars.glb: 900 stars in seven classes of temperature, more of them along a band.

    scenes/starfield/make_stars.py stars.glb

A class is a node that places one octahedron many times (EXT_mesh_gpu_instancing), with a material of its
own; scene.toml says how hot each is.
"""

import json
import math
import random
import struct
import sys

CLASSES = "OBAFGKM"  # of falling temperature
SHARE = [0.03, 0.14, 0.2, 0.17, 0.16, 0.2, 0.1]  # as the eye sees the sky: hot ones are seen from afar
COUNT = 900
DISTANCE = 1000.0


def direction(dice):
    """Two thirds of the stars within a band that leans across the sky."""
    turn = dice.uniform(0, 2 * math.pi)
    height = dice.uniform(-1, 1) if dice.random() < 0.35 else max(-1, min(1, dice.gauss(0, 0.2)))
    around = math.sqrt(1 - height * height)
    x, y, z = around * math.cos(turn), height, around * math.sin(turn)
    lean = 0.9
    return x * math.cos(lean) - y * math.sin(lean), x * math.sin(lean) + y * math.cos(lean), z


def octahedron():
    corners = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    faces = [(a, b, c) if (a + b + c) % 2 == 0 else (a, c, b)
             for a in (0, 1) for b in (2, 3) for c in (4, 5)]
    outwards = []
    for face in faces:
        p, q, r = (corners[i] for i in face)
        middle = [sum(v) for v in zip(p, q, r)]
        u, w = [b - a for a, b in zip(p, q)], [b - a for a, b in zip(p, r)]
        cross = (u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0])
        outwards.append(face if sum(a * b for a, b in zip(cross, middle)) > 0 else face[::-1])
    return corners, outwards


def main():
    dice = random.Random(1990)
    data, views, accessors = bytearray(), [], []

    def add(values, kind, component, letter):
        flat = [v for value in values for v in value]
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": struct.calcsize(letter) * len(flat)})
        accessors.append({"bufferView": len(views) - 1, "componentType": component, "count": len(values),
                          "type": kind})
        data.extend(struct.pack(f"<{len(flat)}{letter}", *flat))
        data.extend(b"\0" * (-len(data) % 4))
        return len(accessors) - 1

    corners, faces = octahedron()
    places = add(corners, "VEC3", 5126, "f")
    accessors[places].update(min=[-1, -1, -1], max=[1, 1, 1])
    indices = add([(i,) for face in faces for i in face], "SCALAR", 5123, "H")
    meshes, nodes, materials = [], [], []
    for number, (name, share) in enumerate(zip(CLASSES, SHARE)):
        stars = [direction(dice) for _ in range(round(COUNT * share))]
        # Their brightness, by size: for each magnitude there are about three times as many.
        sizes = [0.55 * dice.random() ** (-1 / 2.6) for _ in stars]
        at = add([tuple(DISTANCE * v for v in star) for star in stars], "VEC3", 5126, "f")
        scale = add([(min(s, 5.0),) * 3 for s in sizes], "VEC3", 5126, "f")
        materials.append({"name": f"class {name}", "pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1]}})
        meshes.append({"name": name, "primitives": [
            {"attributes": {"POSITION": places}, "indices": indices, "material": number}]})
        nodes.append({"name": f"class {name}", "mesh": number, "extensions": {
            "EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": at, "SCALE": scale}}}})
    asset = {"asset": {"version": "2.0"}, "extensionsUsed": ["EXT_mesh_gpu_instancing"],
             "extensionsRequired": ["EXT_mesh_gpu_instancing"], "scene": 0,
             "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes, "meshes": meshes,
             "materials": materials, "accessors": accessors, "bufferViews": views,
             "buffers": [{"byteLength": len(data)}]}
    text = json.dumps(asset, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    with open(sys.argv[1], "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text)
        file.write(struct.pack("<I4s", len(data), b"BIN\0") + bytes(data))


main()
