"""Writes filtered.csv: five surfaces filtered by the Gaussian filter of surfalize 0.19.2 (NumPy 2.4.6, SciPy 1.17.1)."""

import pathlib

import numpy as np
from surfalize import Surface
from surfalize.filter import GaussianFilter

NX, NY = 48, 36
# Cell sides, nesting index, remaining part of the surface, and its continuation beyond the edges.
CASES = [
    (1.0, 1.0, 8.0, "lowpass", "wrap"),
    (1.0, 1.0, 12.0, "highpass", "wrap"),
    (0.5, 0.75, 6.5, "lowpass", "wrap"),
    (0.5, 0.4, 5.0, "lowpass", "reflect"),
    (2.0, 1.5, 16.0, "highpass", "reflect"),
]

ix, iy = np.meshgrid(np.arange(NX), np.arange(NY))
lines = ["case,dx,dy,nesting_index,left,edges,ix,iy,filtered"]
for case, (dx, dy, index, left, edges) in enumerate(CASES):
    scatter = (7 * ix * ix + 13 * iy * iy + 5 * ix * iy + 3 * case * ix) % 17 / 17
    heights = np.sin(2 * np.pi * (2 * ix / NX + (case + 1) * iy / NY)) + scatter
    filtered = GaussianFilter(index, left, edges).apply(Surface(heights, dx, dy)).data
    for y in range(1, NY, 4):
        for x in range(2, NX, 5):
            lines.append(f"{case},{dx},{dy},{index},{left},{edges},{x},{y},{filtered[y, x]:.12g}")
(pathlib.Path(__file__).parent / "filtered.csv").write_text("\n".join(lines) + "\n")
