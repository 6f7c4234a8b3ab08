"""Solves the contact of the tests of ranks. Run as an MPI program, each rank writes its results to a file with its
number."""

import pathlib
import pickle
import sys

import numpy as np

import stickslip as ss

# On three ranks, each rank has more rows than are solved on the calling thread.
GRID = ss.Grid(96, 264, 3e-6, 2e-6)
PAIR = ss.ElasticPair(ss.Material(213e9, 0.29), ss.Material(213e9, 0.29))


def solved(bodies):
    """Returns the fields of the cells and the results for the whole contact for normal contacts, a tangential contact and
    a history."""
    grid = bodies.grid
    x, y = np.meshgrid(grid.x, grid.y)
    gap = (x**2 + y**2) / 7e-3 + 1e-8 * np.cos(4e5 * x) * np.cos(5e5 * y)
    normal = ss.NormalProblem(bodies, gap, force=30.0).solve(warn=False)
    shear = ss.TangentialProblem(bodies, normal, 0.5, force_x=5.0, model="vector").solve(warn=False)
    history = ss.History(bodies, gap, 0.5)
    for load in ({"normal_force": 20.0}, {"force_x": 6.0}, {"force_x": -2.0, "normal_force": 25.0}):
        step = history.step(**load, warn=False)
    energy = step.energy.dissipated_energy
    history.step(force_x=1.0, warn=False)
    fields = {
        "pressure": normal.pressure,
        "traction": shear.traction[1],
        "slip": history.state().slip[0],
        "displacement": normal.displacement(bodies),
        "spots": shear.spots(normal).labels,
    }
    fields = {name: np.array(field) for name, field in fields.items()}
    known = (
        normal.approach, normal.contact_area, shear.shift, shear.stick_ratio, history.shift, energy,
        [(spot.load, spot.centroid, spot.stick_ratio) for spot in history.spots], len(normal.spots),
    )
    return fields, known


if __name__ == "__main__":
    from mpi4py import MPI

    comm = MPI.COMM_WORLD.Dup()
    found = solved(ss.HalfSpace.distributed(GRID, PAIR, comm))
    pathlib.Path(sys.argv[1], str(comm.Get_rank())).write_bytes(pickle.dumps(found))
