"""Writes the self-made models, one a feature, into a folder: self_made.py FOLDER."""

import base64
import json
import math
import pathlib
import struct
import sys

import png

FOLDER = pathlib.Path(sys.argv[1])
QUAD = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
QUAD_UV = [(0, 1), (1, 1), (1, 0), (0, 0)]  # (0, 0) is the image's upper left corner
TWO = [0, 1, 2, 0, 2, 3]
RED, GREEN, BLUE, WHITE = (255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 255)
NEAREST = {"magFilter": 9728, "minFilter": 9728}


def data_uri(data, kind="application/octet-stream"):
    return f"data:{kind};base64," + base64.b64encode(data).decode()


class Model:
    """A glTF that is put together piece by piece; each method gives the index of what it adds."""

    def __init__(self, **top):
        self.json = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}], **top}
        self.data = b""

    def add(self, kind, **what):
        self.json.setdefault(kind, []).append(what)
        return len(self.json[kind]) - 1

    def view(self, data):
        self.data += bytes(-len(self.data) % 4)
        index = self.add("bufferViews", buffer=0, byteOffset=len(self.data), byteLength=len(data))
        self.data += data
        return index

    def accessor(self, rows, kind="f", **more):
        rows = [row if isinstance(row, (tuple, list)) else (row,) for row in rows]
        code = {"f": 5126, "H": 5123, "B": 5121, "b": 5120}[kind]
        data = b"".join(struct.pack(f"<{len(row)}{kind}", *row) for row in rows)
        bounds = {} if kind == "H" else {"min": [min(c) for c in zip(*rows)], "max": [max(c) for c in zip(*rows)]}
        return self.add("accessors", bufferView=self.view(data), componentType=code, count=len(rows),
                        type=("SCALAR", "VEC2", "VEC3", "VEC4")[len(rows[0]) - 1], **bounds, **more)

    def texture(self, width, height, pixels, **sampler):
        flat = bytes(c for pixel in pixels for c in pixel)
        data = png.written(width, height, flat, 6 if len(pixels[0]) == 4 else 2)
        image = self.add("images", uri=data_uri(data, "image/png"))
        return {"index": self.add("textures", source=image, sampler=self.add("samplers", **(NEAREST | sampler)))}

    def material(self, color=(1, 1, 1, 1), texture=None, **more):
        pbr = {"baseColorFactor": list(color), "metallicFactor": 0, "roughnessFactor": 1} | more.pop("pbr", {})
        if texture:
            pbr["baseColorTexture"] = texture
        for name in more.get("extensions", {}):
            self.use(name)
        return self.add("materials", pbrMetallicRoughness=pbr, **more)

    def use(self, name):
        if name not in self.json.setdefault("extensionsUsed", []):
            self.json["extensionsUsed"].append(name)

    def mesh(self, material, positions, indices=None, mode=4, **attributes):
        values = {"POSITION": self.accessor(positions)}
        values.update((name, v if isinstance(v, int) else self.accessor(v)) for name, v in attributes.items())
        primitive = {"attributes": values, "material": material, "mode": mode}
        if indices:
            primitive["indices"] = self.accessor(indices, "H")
        return self.add("meshes", primitives=[primitive])

    def place(self, mesh, at=(0, 0, 0), **more):
        self.json["scenes"][0]["nodes"].append(self.add("nodes", mesh=mesh, translation=list(at), **more))

    def quad(self, material, at=(0, 0, 0), uv=None, **more):
        scale = {"scale": more.pop("scale")} if "scale" in more else {}
        self.place(self.mesh(material, QUAD, TWO, TEXCOORD_0=uv or QUAD_UV, **more), at, **scale)

    def light(self, at, kind="point", intensity=100, **more):
        lights = self.json.setdefault("extensions", {}).setdefault("KHR_lights_punctual", {"lights": []})["lights"]
        lights.append({"type": kind, "intensity": intensity, **more})
        self.use("KHR_lights_punctual")
        self.json["scenes"][0]["nodes"].append(self.add("nodes", translation=list(at), extensions={
            "KHR_lights_punctual": {"light": len(lights) - 1}}))

    def write(self, name):
        if self.data:
            self.json["buffers"] = [{"byteLength": len(self.data), "uri": data_uri(self.data)}]
        (FOLDER / f"{name}.gltf").write_text(json.dumps(self.json))


def box(lower, upper):
    corners = [tuple((lower, upper)[i >> a & 1][a] for a in range(3)) for i in range(8)]
    faces = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    return [corners[i] for f in faces for i in f], [4 * f + i for f in range(6) for i in TWO]


def ball(columns=32, rows=16):
    """Closed: the ends of its rows, and the corners at its poles, are the same to the bit."""
    points = []
    for r in range(rows + 1):
        for c in range(columns + 1):
            t, p = math.pi * r / rows, 2 * math.pi * (c % columns) / columns
            width = math.sin(t) if 0 < r < rows else 0.0
            points.append((width * math.sin(p), math.cos(t), width * math.cos(p)))
    indices = []
    for r in range(rows):
        for c in range(columns):
            a, b = r * (columns + 1) + c, (r + 1) * (columns + 1) + c
            indices += ([a, b, a + 1] if r else []) + ([a + 1, b, b + 1] if r + 1 < rows else [])
    return points, [i for t in range(0, len(indices), 3) for i in indices[t:t + 3]]


def four(model, **sampler):
    return model.texture(2, 2, [RED, GREEN, BLUE, WHITE], **sampler)


def orientation():
    m = Model()
    for axis, color in enumerate(((1, 0, 0, 1), (0, 1, 0, 1), (0, 0, 1, 1))):
        lower, upper = [-0.1] * 3, [0.1] * 3
        lower[axis], upper[axis] = 0.1, 1
        m.place(m.mesh(m.material(color), *box(lower, upper)))
    m.place(m.mesh(m.material(), *box([-0.1] * 3, [0.1] * 3)))
    m.write("orientation")


def uv_origin():
    m = Model()
    m.quad(m.material(texture=four(m)))
    m.write("uv_origin")


def samplers():
    m = Model()
    wide = [(3 * u - 1, 3 * v - 1) for u, v in QUAD_UV]
    for i, wrap in enumerate((10497, 33648, 33071)):
        m.quad(m.material(texture=four(m, wrapS=wrap, wrapT=wrap)), (2.2 * i, 0, 0), wide)
    m.quad(m.material(texture=four(m, magFilter=9729)), (6.6, 0, 0))
    m.write("samplers")


def texture_transform():
    m = Model()
    for i, change in enumerate(({"offset": [0.5, 0]}, {"rotation": math.pi / 2}, {"scale": [2, 0.5]})):
        use = four(m) | {"extensions": {"KHR_texture_transform": change}}
        m.use("KHR_texture_transform")
        m.quad(m.material(texture=use), (2.2 * i, 0, 0))
    m.write("texture_transform")


def two_uv_sets():
    m = Model()
    m.quad(m.material(texture=four(m) | {"texCoord": 1}), uv=[(0, 0)] * 4, TEXCOORD_1=QUAD_UV)
    m.write("two_uv_sets")


def vertex_color():
    m = Model()
    colors = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)]
    m.quad(m.material(), COLOR_0=colors)
    m.quad(m.material((1, 0.2, 0.2, 1)), (2.2, 0, 0), COLOR_0=colors)
    m.write("vertex_color")


def srgb():
    m = Model()
    m.quad(m.material(texture=m.texture(1, 1, [(188, 188, 188)])))
    m.quad(m.material((0.5029, 0.5029, 0.5029, 1)), (2, 0, 0))
    m.write("srgb")


def alpha():
    m = Model()
    m.quad(m.material(texture=m.texture(8, 1, [(40, 60, 160), WHITE] * 4)), (2.2, 0, -1), scale=[3.4, 1.2, 1])
    pixels = [(255, 80, 0, a) for a in (0, 96, 160, 255)]
    for i, mode in enumerate(({}, {"alphaMode": "MASK", "alphaCutoff": 0.5}, {"alphaMode": "BLEND"})):
        m.quad(m.material(texture=m.texture(4, 1, pixels), **mode), (2.2 * i, 0, 0))
    m.write("alpha")


def sides():
    m = Model()
    for i, mode in enumerate(({}, {"doubleSided": True})):
        for j, turn in enumerate((0, 1)):
            positions = [(x, y, 0) for x, y, _ in QUAD]
            order = TWO[::-1] if turn else TWO
            m.place(m.mesh(m.material((1, 1 - i, 0, 1), **mode), positions, order), (2.2 * (2 * i + j), 0, 0))
    m.write("sides")


def mirrored():
    m = Model()
    for i, scale in enumerate(([1, 1, 1], [-1, 1, 1], [1, -1, 1], [-1, -1, 1])):
        m.quad(m.material(texture=four(m)), (2.2 * i, 0, 0), scale=scale)
    m.write("mirrored")


def unlit_and_emissive():
    m = Model()
    for i, more in enumerate(({}, {"extensions": {"KHR_materials_unlit": {}}}, {"emissiveFactor": [0, 0.5, 0]}, {
            "emissiveFactor": [0, 0.25, 0], "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 4}}})):
        points, indices = ball()
        m.place(m.mesh(m.material((1, 0.2, 0.2, 1), **more), points, indices, NORMAL=points), (2.2 * i, 0, 0))
    m.write("unlit_and_emissive")


def strip_and_fan():
    m = Model()
    m.place(m.mesh(m.material((1, 0, 0, 1)), [QUAD[i] for i in (0, 1, 3, 2)], mode=5))
    m.place(m.mesh(m.material((0, 1, 0, 1)), QUAD, mode=6), (2.2, 0, 0))
    m.place(m.mesh(m.material((0, 0, 1, 1)), [QUAD[i] for i in (0, 1, 2, 3)], [0, 1, 3, 2], 5), (4.4, 0, 0))
    m.write("strip_and_fan")


def sparse_and_quantized():
    m = Model(extensionsUsed=["KHR_mesh_quantization"], extensionsRequired=["KHR_mesh_quantization"])
    moved = m.accessor(QUAD)
    m.json["accessors"][moved] |= {"max": [1, 2, 0], "sparse": {
        "count": 1, "indices": {"bufferView": m.view(struct.pack("<H", 2)), "componentType": 5123},
        "values": {"bufferView": m.view(struct.pack("<3f", 1, 2, 0))}}}
    bytes_ = m.accessor([tuple(127 * c for c in p) + (0,) for p in QUAD], "b")
    m.json["accessors"][bytes_] |= {"type": "VEC3", "normalized": True, "min": [-127, -127, 0], "max": [127, 127, 0]}
    m.json["bufferViews"][m.json["accessors"][bytes_]["bufferView"]] |= {"byteStride": 4, "target": 34962}
    colors = m.accessor([RED + (255,), GREEN + (255,), BLUE + (255,), WHITE + (255,)], "B", normalized=True)
    for i, positions in enumerate((moved, bytes_)):
        primitive = {"attributes": {"POSITION": positions, "COLOR_0": colors}, "material": m.material(),
                     "indices": m.accessor(TWO, "H")}
        m.place(m.add("meshes", primitives=[primitive]), (2.2 * i, 0, 0))
    m.write("sparse_and_quantized")


def instances():
    m = Model(extensionsUsed=["EXT_mesh_gpu_instancing"], extensionsRequired=["EXT_mesh_gpu_instancing"])
    mesh = m.mesh(m.material((1, 0.6, 0.1, 1)), *box([-0.4] * 3, [0.4] * 3))
    half = math.sqrt(0.5)
    attributes = {"TRANSLATION": m.accessor([(0, 0, 0), (1.4, 0, 0), (2.8, 0, 0), (4.2, 0, 0)]),
                  "ROTATION": m.accessor([(0, 0, 0, 1), (0, 0, math.sin(math.pi / 8), math.cos(math.pi / 8)),
                                          (0, 0, half, half), (0, 0, 0, 1)]),
                  "SCALE": m.accessor([(1, 1, 1), (1, 1, 1), (1.5, 0.5, 1), (0.5, 0.5, 0.5)])}
    m.place(mesh, extensions={"EXT_mesh_gpu_instancing": {"attributes": attributes}})
    m.write("instances")


def balls(name, materials):
    """Balls of each material on a grey floor below a lamp, for the path integrator."""
    m = Model()
    points, indices = ball()
    for i, more in enumerate(materials):
        color = more.pop("color", (0.8, 0.3, 0.2, 1))
        m.place(m.mesh(m.material(color, **more), points, indices, NORMAL=points), (2.2 * i, 0, 0))
    wide = len(materials) * 2.2
    floor = [(-2, -1, 2), (wide, -1, 2), (wide, -1, -3), (-2, -1, -3)]
    m.place(m.mesh(m.material((0.5, 0.5, 0.5, 1)), floor, TWO))
    m.light((wide / 3, 4, 4), intensity=20000)
    m.write(name)


def metal_and_rough():
    balls("metal_and_rough", [{"pbr": {"metallicFactor": metal, "roughnessFactor": rough}}
                              for metal in (0, 1) for rough in (0.1, 0.4, 1)])


def glass():
    glass_of = {"extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_ior": {"ior": 1.5}},
                "pbr": {"roughnessFactor": 0}}
    tinted = json.loads(json.dumps(glass_of))
    tinted["extensions"]["KHR_materials_volume"] = {"thicknessFactor": 1, "attenuationDistance": 1,
                                                    "attenuationColor": [0.1, 0.8, 0.3]}
    clear = (1, 1, 1, 1)
    balls("glass", [{"color": clear, **glass_of}, {"color": clear, **tinted}, {}])


def lights():
    m = Model()
    m.quad(m.material(), scale=[4, 2, 1])
    m.light((-2.5, 0, 1), intensity=1600, color=[1, 0.2, 0.2])
    m.light((0, 0, 2), "spot", 4000, color=[0.2, 1, 0.2], spot={"innerConeAngle": 0.3, "outerConeAngle": 0.45})
    m.light((2.5, 0, 1), intensity=1600, color=[0.3, 0.3, 1])
    m.write("lights")


def variants():
    m = Model()
    m.use("KHR_materials_variants")
    m.json["extensions"] = {"KHR_materials_variants": {"variants": [{"name": "day"}, {"name": "night"}]}}
    m.quad(m.material((1, 0.8, 0, 1)))
    m.json["meshes"][0]["primitives"][0]["extensions"] = {"KHR_materials_variants": {
        "mappings": [{"material": m.material((0, 0, 0.5, 1)), "variants": [1]}]}}
    m.write("variants")


def obj_files():
    star = [(math.sin(i * math.pi / 5) * (1, 0.4)[i % 2], math.cos(i * math.pi / 5) * (1, 0.4)[i % 2]) for i in range(10)]
    text = "".join(f"v {x} {y} 0\n" for x, y in star)
    (FOLDER / "concave.obj").write_text(text + "f " + " ".join(str(i - 10) for i in reversed(range(10))) + "\n")
    (FOLDER / "four.png").write_bytes(png.written(2, 2, bytes(RED + GREEN + BLUE + WHITE)))
    (FOLDER / "texture.mtl").write_text("newmtl four\nKd 1 1 1\nmap_Kd -blendu off -blendv off four.png\n")
    (FOLDER / "texture.obj").write_text(
        "mtllib texture.mtl\nusemtl four\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
        "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n")
    rim = [(math.sin(i * math.pi / 4), math.cos(i * math.pi / 4)) for i in range(8)]
    text = "".join(f"v {x + shift} {y} {z}\n" for shift in (0, 2.5) for y in (-1, 1) for x, z in rim)
    for part, group in enumerate(("off", "1")):
        text += f"s {group}\n"
        for i in range(8):
            a, b = 16 * part + 1 + i, 16 * part + 1 + (i + 1) % 8
            text += f"f {a} {b} {b + 8} {a + 8}\n"
    (FOLDER / "smoothing.obj").write_text(text)


def mesh_files():
    colors = [RED, GREEN, BLUE, WHITE]
    head = ("element vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
            "property uchar green\nproperty uchar blue\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n")
    body = b"".join(struct.pack(">3f3B", *p, *c) for p, c in zip(QUAD, colors)) + struct.pack(">B4i", 4, 0, 1, 2, 3)
    (FOLDER / "colors.ply").write_bytes(b"ply\nformat binary_big_endian 1.0\n" + head.encode() + body)
    points, indices = box((-1, -1, -1), (1, 1, 1))
    stl = bytes(80) + struct.pack("<I", len(indices) // 3)
    for t in range(0, len(indices), 3):
        stl += struct.pack("<12fH", 0, 0, 0, *(c for i in indices[t:t + 3] for c in points[i]), 0)
    (FOLDER / "box.stl").write_bytes(stl)
    faces = ["3 0 1 2 255 0 0", "3 0 2 3 0 0 255"]
    (FOLDER / "face_colors.off").write_text(
        "OFF\n4 2 0\n" + "\n".join(" ".join(map(str, p)) for p in QUAD) + "\n" + "\n".join(faces) + "\n")


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    for write in (orientation, uv_origin, samplers, texture_transform, two_uv_sets, vertex_color, srgb, alpha, sides,
                  mirrored, unlit_and_emissive, strip_and_fan, sparse_and_quantized, instances, metal_and_rough,
                  glass, lights, variants, obj_files, mesh_files):
        write()


main()
