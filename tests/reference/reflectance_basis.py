#!/usr/bin/env python3
"""Makes src/physics/reflectance_table.inc: reflectances of the three primaries of Rec. 709.

Mallett and Yuksel 2019, "Spectral Primary Decomposition for Rendering with sRGB Reflectance", with
our own numbers: of all triples of functions within 0..1 that sum to 1 at every wavelength, and that
are seen as red, green and blue under D65 by the CIE 1931 observer, the smoothest one (least sum of
squared differences of neighbours). Then any colour within 0..1 is an affine mix of them, and any
expression affine in a colour is upsampled by upsampling the colour.

usage: reflectance_basis.py > src/physics/reflectance_table.inc      (Debian: python3-numpy)

Reads the CIE's tables out of src/physics/cie_tables.inc and integrates as src/physics/spectrum.cpp
does: matching functions by Lagrange's cubic to 1 nm, illuminant and basis straight in between.
"""
import pathlib
import re

import numpy as np

FIRST, LAST, STEP = 360, 830, 5
NODES = np.arange(FIRST, LAST + 1, STEP)
FINE = np.arange(FIRST, LAST + 1)
# Rec. ITU-R BT.709, item 1.2
PRIMARIES = np.array([[0.640, 0.330], [0.300, 0.600], [0.150, 0.060]])


def table(name):
    source = pathlib.Path(__file__).parents[2] / "src/physics/cie_tables.inc"
    body = re.search(name + r"\[\] = \{(.*?)\};", source.read_text(), re.S).group(1)
    return np.array([float(x) for x in re.findall(r"[-+.0-9e]+", body)])


def cubic(values):
    """Lagrange's polynomial through the four neighbours, as CIE 15 recommends."""
    padded = np.concatenate([[0], values, [0]])
    k = np.minimum((FINE - FIRST) // STEP, len(values) - 2)
    f = (FINE - FIRST) / STEP - k
    weights = [-f * (f - 1) * (f - 2) / 6, (f + 1) * (f - 1) * (f - 2) / 2,
               -(f + 1) * f * (f - 2) / 2, (f + 1) * f * (f - 1) / 6]
    return np.maximum(0, sum(w * padded[k + i] for i, w in enumerate(weights)))


def hats():
    """Row k: the function that is 1 at node k and falls straight to its neighbours."""
    return np.array([np.interp(FINE, NODES, np.eye(len(NODES))[k]) for k in range(len(NODES))])


def rgb_of_nodes():
    """3 x nodes: linear Rec. 709 of D65 light that a surface reflects at one node only."""
    xyz = np.array([cubic(table(f"matching_{c}")) for c in "xyz"])
    daylight = np.interp(FINE, NODES, table("d65"))
    white = xyz @ daylight
    by_primary = np.array([[x / y, 1, (1 - x - y) / y] for x, y in PRIMARIES]).T
    xyz_from_rgb = by_primary * np.linalg.solve(by_primary, white)
    return np.linalg.solve(xyz_from_rgb, xyz * daylight) @ hats().T


def kkt(hessian, rows, target):
    n, m = len(hessian), len(rows)
    system = np.block([[hessian, rows.T], [rows, np.zeros((m, m))]])
    solution = np.linalg.lstsq(system, np.concatenate([np.zeros(n), target]), rcond=1e-13)[0]
    return solution[:n]


def smoothest():
    n = len(NODES)
    rgb = rgb_of_nodes()
    differences = np.diff(np.eye(n), axis=0)
    hessian = np.kron(np.eye(3), differences.T @ differences)
    rows = np.vstack([np.kron(np.ones((1, 3)), np.eye(n)), np.kron(np.eye(3), rgb)])
    target = np.concatenate([np.ones(n), np.eye(3).flatten()])
    # Alternating directions (ADMM): equalities exactly, then bounds exactly; a step finds which
    # bounds hold, and what is left is one linear system.
    rho = 0.02
    system = np.linalg.pinv(np.block([[hessian + rho * np.eye(3 * n), rows.T],
                                      [rows, np.zeros((len(rows), len(rows)))]]), rcond=1e-13)
    z, u = np.full(3 * n, 1 / 3), np.zeros(3 * n)
    for _ in range(60000):
        x = (system @ np.concatenate([rho * (z - u), target]))[:3 * n]
        z = np.clip(x + u, 0, 1)
        u += x - z
    at_zero = z < 1e-9
    active = np.eye(3 * n)[at_zero]
    solved = kkt(hessian, np.vstack([rows, active]), np.concatenate([target, np.zeros(len(active))]))
    return solved.reshape(3, n), rgb


def main():
    basis, rgb = smoothest()
    assert basis.min() > -1e-7 and basis.max() < 1 + 1e-7, (basis.min(), basis.max())
    basis = np.clip(basis, 0, 1)
    basis /= basis.sum(axis=0)
    assert np.abs(rgb @ basis.T - np.eye(3)).max() < 1e-6, rgb @ basis.T
    print("// Made by tests/reference/reflectance_basis.py: red, green, blue at 360, 365 ... 830 nm.")
    print("constexpr double reflectances[][3] = {")
    for r, g, b in basis.T:
        print(f"    {{{r:.9f}, {g:.9f}, {b:.9f}}},")
    print("};")


if __name__ == "__main__":
    main()
