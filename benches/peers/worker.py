"""Runs a peer in a separate process: reads requests and writes answers, each as a line of JSON.

Lengths are in units of the side of the grid, pressures in units of the contact modulus, as in the files
that all codes read. Every answer contains the total time for the user (operators, memory, solve) and the
time of the solve alone, if the peer permits this distinction.
"""

import json
import os
import sys
import time

import numpy


def aspher_press(request, gap):
    """Presses with ASPHER. The nested solve creates its operators and reports the time for this."""
    import aspher

    start = time.perf_counter()
    result = aspher.solve_nested(
        grid_size=request["cells"],
        gap=gap.ravel(),
        p_nominal=request["pressure"],
        tol=request["tolerance"],
        light_result=True,
        **request["setting"],
    )
    whole = time.perf_counter() - start
    answer = {
        "whole": whole,
        "solve": whole - result.timings["build"],
        "status": result.status,
        "products": result.matvec_count,
    }
    return answer, result.pressure


def aspher_shear(request, gap):
    """Shears with ASPHER. Poisson's ratio is zero, because above zero the tangential solver does not always converge."""
    import aspher

    friction, pressure = request["friction"], request["pressure"]
    start = time.perf_counter()
    solver = aspher.FrictionSolver(
        grid_size=request["cells"], nu=0.0, model=aspher.CoulombFriction(friction)
    )
    solver.set_gap(gap.ravel())
    normal = solver.step(p_bar=pressure, tol_normal=request["setting"]["tol_normal"])
    middle = time.perf_counter()
    shear = solver.step(
        q_bar=(request["loading"] * friction * pressure, 0.0),
        tol_tangential=request["tolerance"],
    )
    end = time.perf_counter()
    converged = normal.normal_converged and shear.converged
    answer = {
        "whole": end - start,
        "solve": end - middle,
        "status": "converged" if converged else f"not converged: {shear.status_reason}",
        "products": shear.tangential_iters,
    }
    return answer, shear.qx


def tamaas_press(request, gap):
    """Presses with Tamaas. The modulus must be set before the operator that depends on it, and the operator must be
    selected explicitly, because the solver would use the periodic operator by default."""
    import tamaas

    tamaas.set_log_level(tamaas.LogLevel.error)
    cells = request["cells"]
    start = time.perf_counter()
    model = tamaas.Model(tamaas.model_type.basic_2d, [1.0, 1.0], [cells, cells])
    model.E, model.nu = 1.0, 0.0
    tamaas.ModelFactory.registerNonPeriodic(model, "dcfft")
    solver = tamaas.PolonskyKeerRey(model, -gap, request["tolerance"])
    solver.setIntegralOperator("dcfft")
    solver.max_iter = 100_000
    middle = time.perf_counter()
    error = solver.solve(request["pressure"])
    end = time.perf_counter()
    answer = {
        "whole": end - start,
        "solve": end - middle,
        "status": "converged" if error <= request["tolerance"] else f"error {error:.1e}",
    }
    return answer, model.traction


def contactmechanics_press(request, gap):
    """Presses with ContactMechanics. Its tolerances are absolute. They are given as fractions of the mean pressure, of
    the displacement that this pressure causes over the side of the grid, and of the force on a cell."""
    from ContactMechanics.Factory import make_system
    from SurfaceTopography import Topography

    cells, pressure, tolerance = (request[key] for key in ("cells", "pressure", "tolerance"))
    start = time.perf_counter()
    surface = Topography(-gap, physical_sizes=(1.0, 1.0))
    system = make_system(substrate="free", surface=surface, young=1.0)
    middle = time.perf_counter()
    result = system.minimize_proxy(
        external_force=pressure,
        pentol=tolerance * pressure,
        forcetol=tolerance * pressure / cells**2,
        thermotol=tolerance,
    )
    end = time.perf_counter()
    answer = {
        "whole": end - start,
        "solve": end - middle,
        "status": "converged" if result.success else str(result.message),
        "products": result.nfev,
    }
    return answer, result.jac * cells**2


SOLVERS = {
    ("aspher", "press"): aspher_press,
    ("aspher", "shear"): aspher_shear,
    ("tamaas", "press"): tamaas_press,
    ("ContactMechanics", "press"): contactmechanics_press,
}


def main():
    # The output of the libraries must not mix with the answers.
    answers = os.fdopen(os.dup(1), "w", buffering=1)
    os.dup2(2, 1)
    print(json.dumps({"ready": True}), file=answers)
    for line in sys.stdin:
        request = json.loads(line)
        cells = request["cells"]
        gap = numpy.fromfile(request["gap"]).reshape(cells, cells)
        try:
            solver = SOLVERS[request["code"], request["problem"]]
            answer, field = solver(request, gap)
            numpy.ascontiguousarray(field, dtype=float).tofile(request["output"])
        except Exception as error:  # A failure of a peer becomes a line in the report.
            answer = {"status": f"failed: {error}"}
        print(json.dumps(answer), file=answers)


main()
