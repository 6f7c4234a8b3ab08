"""Comparison of this package with Tamaas and ContactMechanics for identical gaps: solutions and times in a table.

Needs `pip install tamaas ContactMechanics`; a missing package is skipped. The number of cells along a side may be given.
Each code uses its own definition of the tolerance of 1e-8, so times are comparable only in order of magnitude;
`benches/README.md` compares them at the same measured error.
"""

import sys
import time

import numpy as np

import stickslip as ss

FORCE = 0.05  # for a contact modulus of one and a square of side one


def own(gap, cells):
    grid = ss.Grid.square(cells, 1.0)
    bodies = ss.HalfSpace(grid, (ss.Material(1.0, 0.0), ss.Material.rigid()))
    return ss.NormalProblem(bodies, gap, force=FORCE).solve().pressure


def tamaas(gap, cells):
    import tamaas

    tamaas.set_log_level(tamaas.LogLevel.error)
    model = tamaas.Model(tamaas.model_type.basic_2d, [1.0, 1.0], [cells, cells])
    model.E, model.nu = 1.0, 0.0
    tamaas.ModelFactory.registerNonPeriodic(model, "dcfft")
    solver = tamaas.PolonskyKeerRey(model, -gap, 1e-8)
    solver.setIntegralOperator("dcfft")
    solver.solve(FORCE)
    return np.array(model.traction).reshape(cells, cells)


def contactmechanics(gap, cells):
    from ContactMechanics.Factory import make_system
    from SurfaceTopography import Topography

    system = make_system(substrate="free", surface=Topography(-gap, physical_sizes=(1.0, 1.0)), young=1.0)
    result = system.minimize_proxy(
        external_force=FORCE, pentol=1e-8 * FORCE, forcetol=1e-8 * FORCE / cells**2, thermotol=1e-8
    )
    return np.asarray(result.jac) * cells**2


def main() -> None:
    cells = int(sys.argv[1]) if len(sys.argv) > 1 else 128
    grid = ss.Grid.square(cells, 1.0)
    heights = ss.surface.SelfAffine(rms_slope=0.1, seed=2, cut_off_wavelength=16.0 / cells).generate(grid).heights
    scenes = {
        "sphere": ss.surface.sphere(grid, 1.0).array,
        "rough": ss.surface.gap_from_heights(heights).array,
    }
    print("scene    code               time, s   times ours   sum |p - ours| / sum p   area")
    for scene, gap in scenes.items():
        ours = None
        for name, code in [("stickslip", own), ("Tamaas", tamaas), ("ContactMechanics", contactmechanics)]:
            start = time.perf_counter()
            try:
                pressure = np.abs(code(np.array(gap), cells))
            except ImportError as missing:
                print(f"{scene:8} {name:16}   left out: {missing}")
                continue
            took = time.perf_counter() - start
            if ours is None:
                ours, first = pressure, took
            difference = np.abs(pressure - ours).sum() / ours.sum()
            area = np.count_nonzero(pressure > 1e-12 * pressure.max()) / cells**2
            print(f"{scene:8} {name:16} {took:9.3f}   {took / first:10.1f}   {difference:22.1e}   {area:.4f}")
            assert difference < 1e-4, "another answer"


if __name__ == "__main__":
    main()
