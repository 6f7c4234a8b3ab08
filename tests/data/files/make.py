#!/usr/bin/env python3
"""Makes the surface files of this folder with other programs, and reads each of them back with further programs.

All files contain one surface, five points along x and four along y, in micrometres:
z(ix, iy) = ix / 4 - iy / 2 + ix * iy / 8, spacings 0.5 and 0.25. Point (3, 1) is missing,
except in files named `whole`. See README.md for versions.
"""

import hashlib
import pathlib
import struct
import zipfile

import numpy as np
import SurfaceTopography
from rsciio.digitalsurf import file_reader as rosetta_read
from rsciio.digitalsurf import file_writer as rosetta_write
from surfalize import Surface
from surfalize.file.sdf import write_sdf
from surfalize.file.sur import write_sur
from surfalize.file.x3p import write_x3p
from SurfaceTopography.IO.X3P import write_x3p as topography_write_x3p

HERE = pathlib.Path(__file__).parent
NX, NY, DX, DY = 5, 4, 0.5, 0.25
IX, IY = np.meshgrid(np.arange(NX), np.arange(NY))
WHOLE = IX / 4 - IY / 2 + IX * IY / 8
Z = WHOLE.copy()
Z[1, 3] = np.nan


def check(name, data, step_x, step_y, tolerance=1e-7, program=""):
    """Compares the data with the surface, in micrometres, up to a constant."""
    expected = (WHOLE if "whole" in name else Z) * (8 if "eighths" in name else 1)
    assert data.shape == expected.shape, (name, program, data.shape)
    assert (np.isnan(data) == np.isnan(expected)).all(), (name, program, data)
    difference = data - expected
    constant = np.nanmean(difference)
    assert np.nanmax(abs(difference - constant)) < tolerance, (name, program, data)
    assert abs(step_x - DX) < 1e-6 and abs(step_y - DY) < 1e-6, (name, program, step_x, step_y)
    print(f"{name:28} read by {program:18} constant {constant:+.3f}")


def by_surfalize(name, tolerance=1e-7):
    surface = Surface.load(HERE / name)
    check(name, surface.data, surface.step_x, surface.step_y, tolerance, "surfalize")


def by_topography(name, tolerance=1e-7, unit="um"):
    with SurfaceTopography.open_topography(str(HERE / name)) as reader:
        topography = reader.topography() if unit else reader.topography(unit="um")
    topography = topography.to_unit("µm") if topography.unit else topography
    data = np.ma.filled(np.ma.asarray(topography.heights(), dtype=float), np.nan).T
    sx, sy = topography.physical_sizes
    check(name, data, sx / NX, sy / NY, tolerance, "SurfaceTopography")


# NPY and text, by NumPy.
for name, array, version in [
    ("f8.npy", Z, (1, 0)),
    ("f4_big_fortran.npy", np.asfortranarray(Z.astype(">f4")), (2, 0)),
    ("i2_eighths_whole.npy", (8 * WHOLE).astype("<i2"), (1, 0)),
    ("u8_big_whole.npy", (8 * WHOLE + 100).astype(">u8"), (3, 0)),
    ("i1_eighths_whole.npy", (8 * WHOLE).astype("i1"), (1, 0)),
]:
    with open(HERE / name, "wb") as file:
        np.lib.format.write_array(file, array, version=version)
np.savetxt(HERE / "spaces.asc", Z, header="heights in um")
np.savetxt(HERE / "commas.csv", Z, delimiter=",", newline="\r\n")
text = "\n".join("\t".join(f"{z:.6f}".replace(".", ",") for z in row) for row in Z)
(HERE / "tabs_decimal_commas.txt").write_text(text.replace("nan", "BAD") + "\n")
order = np.random.default_rng(1).permutation(NX * NY)
columns = np.stack([IX * DX + 7, IY * DY - 1, WHOLE], axis=-1).reshape(-1, 3)
np.savetxt(HERE / "shuffled_whole.xyz", columns[order])
by_topography("shuffled_whole.xyz", unit=None)
present = columns[~np.isnan(Z).reshape(-1)]
np.savetxt(HERE / "gap.xyz", present, fmt="%.4f", delimiter=";")

# SDF: by surfalize, and by hand for the other sample types.
surface = Surface(Z, DX, DY)
for name, binary in [("f8.sdf", True), ("text.sdf", False)]:
    with open(HERE / name, "wb") as file:
        write_sdf(file, surface, binary=binary)
    by_surfalize(name)
by_topography("text.sdf")  # does not treat the least double of f8.sdf as missing
missing = {"<i2": -(2**15), "<i4": -(2**31), "<f4": np.nan}
for name, kind, code in [("i2.sdf", "<i2", 5), ("i4.sdf", "<i4", 6), ("f4.sdf", "<f4", 3)]:
    stored = np.where(np.isnan(Z), missing[kind], 8 * Z).astype(kind)
    header = struct.pack("<2H4d3B", NX, NY, DX * 1e-6, DY * 1e-6, 1e-6 / 8, -1, 0, code, 0)
    head = b"bISO-1.0" + b"by hand   " + b"010120260000" * 2 + header
    (HERE / name).write_bytes(head + stored.tobytes() + b"\r\nmade = by hand\r\n*")
    by_surfalize(name)
    by_topography(name)

# X3P: by SurfaceTopography and surfalize, and by hand for a list of data.
masked = np.ma.masked_invalid(Z.T)
topography = SurfaceTopography.Topography(masked, (NX * DX, NY * DY), unit="µm")
for kind, tolerance in [("I", 1e-4), ("L", 1e-7), ("F", 1e-7), ("D", 1e-7)]:
    name = f"{kind}.x3p"
    topography_write_x3p(topography, str(HERE / name), dtype=kind)
    by_topography(name, tolerance)  # surfalize rejects the checksums
with open(HERE / "surfalize.x3p", "wb") as file:
    write_x3p(file, surface)
by_surfalize("surfalize.x3p")
by_topography("surfalize.x3p")
with zipfile.ZipFile(HERE / "surfalize.x3p") as archive:
    main = archive.read("main.xml").decode()
link = main[main.index("<DataLink>") : main.index("</DataLink>") + len("</DataLink>")]
data = "".join(f"<Datum>{'' if np.isnan(z) else z * 1e-6}</Datum>" for z in Z.reshape(-1))
main = main.replace(link, f"<DataList>{data}</DataList>").encode()
with zipfile.ZipFile(HERE / "list.x3p", "w") as archive:
    archive.writestr("main.xml", main)
    archive.writestr("md5checksum.hex", hashlib.md5(main).hexdigest() + " *main.xml")
by_surfalize("list.x3p")


# SUR: by surfalize (32 bits) and RosettaSciIO (16 bits).
def by_rosetta(name, tolerance):
    (signal,) = rosetta_read(str(HERE / name))
    scale = [axis["scale"] for axis in signal["axes"]]
    check(name, np.asarray(signal["data"], dtype=float), scale[1], scale[0], tolerance, "RosettaSciIO")


with open(HERE / "i4.sur", "wb") as file:
    write_sur(file, surface)
axes = [
    {"size": n, "name": name, "units": "um", "scale": d, "offset": 0.0, "navigate": False, "index_in_array": i}
    for i, (n, name, d) in enumerate([(NY, "Y", DY), (NX, "X", DX)])
]
eighths = (8 * WHOLE).astype(np.int16)
signal = {"data": eighths, "axes": axes, "metadata": {"General": {}, "Signal": {"quantity": "Height (um)"}}, "original_metadata": {}}
rosetta_write(str(HERE / "i2_eighths_whole.sur"), signal, compressed=False)
by_surfalize("i4.sur", 1e-6)
by_rosetta("i4.sur", 1e-6)  # SurfaceTopography does not support the micro sign in UTF-8
by_surfalize("i2_eighths_whole.sur")
by_topography("i2_eighths_whole.sur")
