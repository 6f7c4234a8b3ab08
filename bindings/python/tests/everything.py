"""Calls every function, method, property and constructor that the package exports, from the list of its items.

Arguments are chosen by their names, so that a new item is also called, or fails for lack of a value. Run as a program
with a number of cells, the script makes all calls, repeats them in a forked process, and counts threads:

    python everything.py CELLS [THREADS]
"""

import inspect
import os
import pickle
import select
import signal
import sys
import tempfile
import time

import numpy as np

import stickslip as ss
from stickslip import _stickslip

# Time limit of a forked process (s).
TIMEOUT = 120

# Items that are not called, with the reason.
LEFT_OUT = {
    "set_num_threads": "it is called by the program",
}
# Functions that are called with bytes of a different format and reject them.
REFUSED = {"asc_parse", "asc_read", "sur_parse", "sur_read", "x3p_parse", "x3p_read"}


class Alone:
    """Communicator of a single rank."""

    def Get_rank(self):
        return 0

    def Get_size(self):
        return 1


class Scene:
    """Objects of all kinds on a grid with the given number of cells per side, and the values of arguments."""

    def __init__(self, cells):
        self.grid = grid = ss.Grid.square(cells, 0.3e-3)
        self.folder = tempfile.mkdtemp()
        steel, glass = ss.Material(213e9, 0.29), ss.Material(70e9, 0.22)
        pair = ss.ElasticPair(steel, steel)
        self.bodies = bodies = ss.HalfSpace(grid, pair)
        self.dissimilar = ss.HalfSpace(grid, (steel, glass))
        self.ball = ball = ss.surface.sphere(grid, 3.5e-3)
        self.few = ss.HalfSpace(ss.Grid.square(8, 0.3e-3), pair)
        self.normal = normal = ss.NormalProblem(bodies, ball, force=100.0).solve()
        light = ss.NormalProblem(bodies, ball, force=30.0).solve()
        self.shear = shear = ss.TangentialProblem(bodies, normal, 0.5, force_x=20.0).solve()
        self.load = load = ss.LoadStep(normal_force=100.0, force_x=20.0)
        self.still = ss.TangentialLoad(force_x=20.0)
        self.history = history = ss.History(bodies, ball, 0.5)
        history.step(normal_force=100.0)
        history.step(load)
        self.cycle = cycle = ss.history.Cycle(history)
        for force in (-20.0, 20.0):
            history.step(force_x=force)
            cycle.add(history)
        hertz = ss.analytical.HertzSphere(pair, radius=3.5e-3, load=100.0)
        ellipse = ss.analytical.HertzEllipse(pair, radius_x=3e-3, radius_y=4e-3, load=100.0)
        line = ss.analytical.HertzLine(pair, radius=3.5e-3, load=1e4)
        wavy = ss.analytical.Westergaard(pair, amplitude=1e-6, wavelength=1e-3, mean_pressure=1e8)
        slope = 1e-2
        rough = ss.surface.SelfAffine(rms_height=1e-7, seed=3)
        operator = bodies.operator("zz")
        strain = ss.tangential.RelativeDisplacement.bulk_strain(grid, ((1e-6, 0.0), (0.0, 0.0)))
        problem = ss.CoupledProblem(self.dissimilar, ball, 0.5, normal_force=100.0, force_x=20.0)
        planes = ss.subsurface.Planes(bodies, [0.0, 1e-5], displacements=True)
        plane = planes.solve(1, "one", normal)
        points = [(0.0, 0.0, 1e-5)] * 5
        responses = ss.subsurface.at_points(bodies, "one", normal, points)
        response = responses[0]
        rolling = ss.rolling.RollingProblem(bodies, normal, 0.5, creepage_x=1e-3)
        # Both bodies have the stiffness of steel, so that the grid extends beyond the contact.
        rollers = ss.HalfSpace(grid, (steel, ss.Material(213e9, 0.45)))
        pressed = {"normal_force": 100.0, "creepage_x": 1e-3}
        coupled_rolling = ss.rolling.CoupledRollingProblem(rollers, ball, 0.5, **pressed)
        presser = ss.NormalSolver(bodies, ball, force=100.0)
        roller = rolling.solver()
        roller.set_normal_solver(presser)
        creep_forces = rolling.solver().creep_forces([(1e-3, 0.0, 0.0), (2e-3, 0.0, 0.0)])
        adaptive = ss.history.AdaptiveSteps(history, 0.05)
        contact_stiffness = ss.stiffness.ContactStiffness(bodies, normal, 0.5, shear)
        rectangle = ss.influence.Rectangle(1.0, 2.0)
        coupled = problem.solve()
        functional = ss.sensitivity.Functional.tangential_force("x")
        shearer = ss.TangentialProblem(bodies, normal, 0.5, shift_x=1e-7).solver()
        sensitivity = shearer.sensitivity(shearer.solve(), functional)
        dense = ss.dense.DenseOperator.of_half_space(self.few, "zz")
        linear = -np.ones(64)
        extent = (-0.15e-3, 0.15e-3)
        region = ss.adaptive.Region.rectangle(extent, extent)
        # The samples are too far apart for a smaller error.
        chosen = {"friction": 0.5, "first_step": load, "target": 0.2}
        accurate = ss.adaptive.AdaptiveProblem(pair, ball, region, force=100.0, **chosen).solve(warn=False)
        layer = ss.layers.Layer(400e9, 0.25, thickness=2e-6)

        # Objects of classes that no other call returns, by the name of the class.
        self.objects = {
            "Boundary": bodies.boundary,
            "SpencePressing": ss.analytical.SpencePressing.round(self.dissimilar.pair, 0.5),
            "Field": ss.Field(grid, ball, unit="mm"),
            "Convolution": ss.fft.Convolution(grid, pair, "zz"),
            "LinearOperator": operator,
            "TensorOperator": bodies.tensor_operator(),
            "DenseOperator": dense,
            "DenseMinimum": dense.minimise(linear, lower=np.zeros(64)),
            "Minimum": ss.cgm.minimise(operator, -np.ones(cells * cells), lower=np.zeros(cells * cells)),
            "NormalSolution": normal,
            "NormalSolver": ss.NormalProblem(bodies, ball, force=100.0).solver(),
            "TangentialSolution": shear,
            "TangentialSolver": ss.TangentialProblem(bodies, normal, 0.5, force_x=20.0).solver(),
            "CoupledProblem": problem,
            "CoupledSolver": problem.solver(),
            "CoupledSolution": coupled,
            "CoupledReport": coupled.report,
            "ErrorEstimate": coupled.report.error_estimate,
            "CoupledRollingProblem": coupled_rolling,
            "CoupledRollingSolver": coupled_rolling.solver(),
            "CoupledRollingSolution": coupled_rolling.solve(),
            "CoupledRollingReport": coupled_rolling.solve().report,
            "RollingProblem": rolling,
            "RollingSolver": roller,
            "RollingSolution": rolling.solve(),
            "CreepForce": creep_forces[0],
            "CreepForces": creep_forces,
            "History": history,
            "State": history.state(),
            "StepResult": history.last_step.keep(),
            "EnergyBalance": history.last_step.energy,
            # The history has no last step after this call.
            "StepErrorEstimate": adaptive.error(history, load),
            "Cycle": cycle,
            "LoopPoint": cycle.points[0],
            "Plane": plane,
            "Planes": planes,
            "PointResult": response,
            "Stress": response.stress,
            "Principal": response.stress.principal,
            "ContactStiffness": contact_stiffness,
            "NormalStiffness": contact_stiffness.normal,
            "Functional": functional,
            "Sensitivity": sensitivity,
            "TangentialStiffness": contact_stiffness.tangential,
            "Edges": normal.edges(),
            "TangentialEdges": shear.edges(normal, 0.5),
            "ContactSpots": normal.spots,
            "Spot": normal.spots[0],
            "Report": normal.report,
            "Iteration": normal.report.history[0] if normal.report.history else None,
            "Warning": next(iter(light.warnings), None),
            "RelativeDisplacement": strain,
            "RoughSurface": rough.generate(grid),
            "SelfAffine": ss.surface.SelfAffine(rms_height=1e-7, seed=3, skewness=0.3, cropped=True),
            "Filled": ss.surface.fill_missing(ball),
            "Filtered": ss.surface.gaussian_filter(ball, s=1e-4, l=2e-4),
            "Levelled": ss.surface.level(ball, "plane"),
            "WithoutOutliers": ss.surface.remove_outliers(ball),
            "Tensor": rectangle.pair_tensor(pair, 0.5, 0.5),
            "Hardness": ss.Hardness(1e10) if hasattr(ss, "Hardness") else ss.normal.Hardness(1e10),
            "Settings": ss.Settings(),
            "TangentialLoad": self.still,
            "LoadStep": load,
            "Layer": layer,
            "WaveResponse": pair.response(1e3),
            "Kernel": ss.Kernel.tabulated(pair, (grid.dx, grid.dy), {"zz": np.eye(2)}),
            "LoadPath": ss.history.LoadPath.sine((1e-7, 0.0), 4),
            "AdaptiveSteps": adaptive,
            "AdaptiveSolution": accurate,
            "GridRecord": accurate.grids[0],
            "Region": region,
        }
        # Sequences with their own class.
        for sequence in (cycle.points, normal.report.history, responses):
            self.objects.setdefault(type(sequence).__name__, sequence)
        grid_bytes = b"0 0 1.0\n1 0 2.0\n0 1 3.0\n1 1 4.0\n"
        # Values of arguments by name.
        self.values = {
            "a": 1.0, "b": 2.0, "accumulated": ball, "along_x": ball, "along_y": ball, "amplitude": 1e-6,
            "amplitudes": (1e-7, 2e-7), "approach": 1e-6, "area_coefficient": 2.0, "axis": "x", "bodies": bodies,
            "body": "one", "body_1": steel, "body_2": steel, "bytes": grid_bytes, "cells": 9, "coefficient": 1e-13,
            "column": 1, "columns": (0, 8), "comm": Alone(), "component": "zz", "cone": ss.analytical.Cone(pair, slope=slope, load=100.0),
            "contact": normal, "contact_radius": 1e-4, "count": 2, "creepage": 1e-3,
            "curvatures": (1.0, 0.0, 1.0), "cycle": cycle, "datum": 1.0, "depth": ball, "depths": [0.0, 1e-5],
            "dx": 1e-6, "dy": 1e-6, "energy": ball, "exponent": 4.0, "field": ball,
            "fields": {"gap": ball}, "finer": accurate, "flat": 5e-5, "force": 20.0, "form": 3, "friction": 0.5, "full": normal,
            "functional": ss.sensitivity.Functional.normal_force(), "functionals": [ss.sensitivity.Functional.normal_force()],
            "gap": ball, "grid": grid, "heights": ball, "hertz": hertz, "histories": [history], "history": history,
            "i": 1, "index": 0, "ix": 0, "iy": 0, "j": 1, "k": 1e3, "layers": [layer], "limit": 1e10, "linear": -np.ones(cells * cells),
            "load": 100.0, "loads": [load], "lower": ball, "height": 0.0, "material": steel, "material_ratio": 0.3, "mean_pressure": 1e8,
            "mean_traction": 1e7, "n": 8, "near": pair, "response": lambda k: (1.0 / k, 1.0 / k, 1.0 / k, 0.0),
            "operators": {"z": lambda x: 1e-11 * x}, "coefficients": {"zz": np.eye(2)}, "sides": (1.0, 1.0), "thickness": 1e-5, "normal": normal, "nx": 8, "ny": 9, "operator": operator, "pair": pair,
            "path": f"{self.folder}/file", "pattern": strain, "phase": 0.5, "points": points, "poisson_ratio": 0.3,
            "pressure": normal, "quantity": "pressure", "r": [0.0, 1e-4], "radius": 3.5e-3, "radius_x": 3e-3, "radius_y": 4e-3, "ratio": 0.5,
            "recess": 1e-3, "region": region,
            "reduced_pressure": 0.1, "relative": strain, "rms_slope": slope, "row": 1, "rows": (0, 8), "samples": ball,
            "sensitivities": [sensitivity],
            "settings": ss.Settings(), "shear": shear, "shear_modulus": 80e9, "side": 1e-3, "slip_distance": ball,
            "slope": slope, "spots": normal.spots, "springs": (1e7, 1e7), "state": history.state(), "steps": 8, "stick": light,
            "stick_radius": 5e-5, "strain": ((1e-6, 0.0), (0.0, 0.0)), "stress": 1e8, "threshold": 0.0,
            "time": 1.0, "tolerance": 0.05, "tractions": normal, "twist": 1e-4, "unit": "m", "upper": ball, "wavelength": 1e-4,
            "wavelengths": (1e-4, 1e-4), "x": 1e-5, "y": 1e-5, "youngs_modulus": 213e9, "stresses": ball,
        }
        vector = np.ones(cells * cells)
        # Arguments of individual calls: names with a different meaning, and options without which a call would do
        # nothing.
        self.special = {
            "AdaptiveProblem": {"force": 100.0, "target": 0.2},
            "AdaptiveSteps.error": {"load": load},
            "AdaptiveSteps.step": {"load": load},
            "BentallJohnson": {"hertz": line},
            "Carter": {"hertz": line},
            "CattaneoMindlinEllipse": {"hertz": ellipse},
            "CattaneoMindlinLine": {"hertz": line, "force": 1e3},
            "CattaneoMindlinLine.stress": {"depth": 1e-5},
            "CattaneoMindlinLine.with_bulk_stress": {"stress": (1e6, 0.0)},
            "CattaneoMindlinLine.with_strain": {"strain": 1e-6},
            "Convolution.apply": {"x": vector},
            "CoupledProblem": {"bodies": self.dissimilar, "normal_force": 100.0, "force_x": 20.0},
            "CoupledSolution.stiffness": {"bodies": self.dissimilar},
            "CoupledSolver.sensitivities": {"solution": coupled},
            "CoupledSolver.sensitivity": {"solution": coupled},
            "CoupledSolver.set_loads": {"load": self.still, "normal_force": 100.0},
            "CycleJump": {"max_residual": 0.9},
            "DenseOperator": {"rows": np.eye(3)},
            "DenseOperator.apply": {"x": np.ones(64)},
            "DenseOperator.minimise": {"linear": linear, "lower": np.zeros(64)},
            "DenseOperator.of_half_space": {"bodies": self.few},
            "FlatPunch": {"radius": 1e-4},
            "Functional.weighted": {"pressure": ball},
            "Friction.limit": {"pressure": 1e8},
            "History.from_bytes": {"bytes": history.to_bytes()},
            "History.sensitivities": {"load": load},
            "History.sensitivity": {"load": load},
            "History.press": {"normal_force": 100.0},
            "History.step": {"normal_force": 100.0, "force_x": 20.0},
            "HertzLine": {"load": 1e4},
            "HertzLine.stress": {"depth": 1e-5},
            "LinearOperator.apply": {"x": vector},
            "LoadPath": {"steps": [(0.0, 1e-7), (0.0, 0.0)]},
            "LoadPath.sine": {"amplitude": (1e-7, 0.0)},
            "LoadPath.triangle": {"amplitude": (1e-7, 0.0)},
            "LoadStep.of": {"load": self.still},
            "MindlinDeresiewicz": {"path": [20.0, -20.0]},
            "NoSlipPunch": {"radius": 1e-4},
            "NormalProblem": {"force": 100.0},
            "NormalSolver": {"force": 100.0},
            "NormalSolver.chain": {"solution": normal},
            "NormalSolver.sensitivities": {"solution": normal},
            "NormalSolver.sensitivity": {"solution": normal},
            "NormalSolver.set_load": {"force": 100.0},
            "NormalSolver.solve": {"force": 100.0},
            "Planes.write_vti": {"path": f"{self.folder}/planes.vti"},
            "CoupledRollingProblem": {"normal_force": 100.0, "creepage_x": 1e-3},
            "CoupledRollingSolver.set_normal_load": {"normal_force": 100.0},
            "CoupledRollingSolver.solve": {"creepage_x": 1e-3},
            "Region.line": {"x": extent},
            "Region.periodic": {"x": extent, "y": extent},
            "Region.rectangle": {"x": extent, "y": extent},
            "RollingProblem": {"creepage_x": 1e-3},
            "RollingSolver.creep_forces": {"points": [(1e-3, 0.0, 0.0), (2e-3, 0.0, 0.0)]},
            "RollingSolver.set_normal_load": {"normal_force": 100.0},
            "RollingSolver.set_normal_solver": {"solver": presser},
            "RollingSolver.solve": {"creepage_x": 1e-3},
            "RoundedPunch": {"radius": 3.5e-3},
            "SelfAffine": {"rms_height": 1e-7, "seed": 3},
            "PvdWriter": {"path": f"{self.folder}/series.pvd"},
            "State.from_bytes": {"bytes": history.state().to_bytes()},
            "TangentialLoad": {"force_x": 20.0},
            "TangentialProblem": {"force_x": 20.0},
            "TangentialSolver.sensitivities": {"solution": shear},
            "TangentialSolver.sensitivity": {"solution": shear},
            "TangentialSolver.solve": {"force_x": 20.0},
            "TensorOperator.apply": {"tractions": [vector] * 3},
            "VermeulenJohnson": {"hertz": ellipse, "creepage": (1e-3, 0.0)},
            "Westergaard": {"wavelength": 1e-3},
            "WestergaardPartialSlip": {"contact": wavy},
            "asc_read": {"path": self.file("a.asc", b"nothing")},
            "csv_parse": {"bytes": b"1.0,2.0\n3.0,4.0\n", "cell": (1.0, 1.0)},
            "csv_read": {"path": self.file("a.csv", b"1.0,2.0\n3.0,4.0\n"), "cell": (1.0, 1.0)},
            "gaussian_filter": {"s": 1e-4},
            "flat_punch": {"radius": 1e-4},
            "minimise": {"lower": np.zeros(cells * cells)},
            "npy_grid": {"path": self.file("a.npy", ss.io.npy.to_bytes(ball)), "cell": (1.0, 1.0)},
            "npy_parse": {"bytes": ss.io.npy.to_bytes(ball), "cell": (1.0, 1.0)},
            "npy_read": {"path": f"{self.folder}/a.npy", "cell": (1.0, 1.0)},
            "read": {"path": self.file("a.sdf", ss.io.sdf.to_bytes(ball, unit="m"))},
            "sdf_parse": {"bytes": ss.io.sdf.to_bytes(ball, unit="m")},
            "sdf_to_bytes": {"unit": "m"},
            "sdf_write": {"unit": "m"},
            "sdf_read": {"path": f"{self.folder}/a.sdf"},
            "vti_write": {"path": f"{self.folder}/fields.vti"},
            "sum": {"fields": [ball, ball]},
            "sur_read": {"path": self.file("a.sur", b"nothing")},
            "x3p_read": {"path": self.file("a.x3p", b"nothing")},
            "xyz_read": {"path": self.file("a.xyz", grid_bytes)},
            "History.load": {"path": self.file("history", history.to_bytes())},
            "History.save": {"path": f"{self.folder}/saved"},
            "archard": {"pressure": ball},
        }

    def file(self, name, content):
        path = f"{self.folder}/{name}"
        with open(path, "wb") as file:
            file.write(content)
        return path

    def arguments(self, name, function):
        """Returns positional and keyword arguments of a call from the names of its parameters."""
        special = dict(self.special.get(name, {}))
        positional = []
        for parameter in inspect.signature(function).parameters.values():
            if parameter.name == "self" or parameter.kind is parameter.VAR_KEYWORD:
                continue
            if parameter.default is parameter.empty or parameter.name in special:
                value = special.pop(parameter.name) if parameter.name in special else self.values[parameter.name]
                if parameter.kind is parameter.KEYWORD_ONLY or positional is None:
                    special[f"={parameter.name}"] = value
                else:
                    positional.append(value)
        return positional, {name.lstrip("="): value for name, value in special.items()}

    def call(self, name, function):
        positional, keywords = self.arguments(name, function)
        if name in {"Cycle.add", "CycleJump"}:
            # The added step is the first step after the start of the cycle. A jump requires a cycle with steps.
            self.cycle.begin(self.history)
            self.history.step(self.load)
        if name == "CycleJump":
            self.cycle.add(self.history)
        try:
            result = function(*positional, **keywords)
            if name == "Cycle.begin":
                # The results of a cycle require a step.
                self.history.step(self.load)
                self.cycle.add(self.history)
            return result
        except ss.StickslipError:
            if name not in REFUSED:
                raise


def members(kind):
    """Returns the public members of a class with their declarations."""
    return [(name, inspect.getattr_static(kind, name)) for name in dir(kind) if not name.startswith("_")]


def calls(scene):
    """Calls every item and yields its name."""
    for name, item in vars(_stickslip).items():
        if name.startswith("_") or name in LEFT_OUT or not callable(item):
            continue
        if not inspect.isclass(item):
            yield name, lambda name=name, item=item: scene.call(name, item)
            continue
        # Call the constructor if there is one.
        if item.__text_signature__ is not None:
            yield name, lambda name=name, item=item: scene.call(name, item)
        target = scene.objects[name] if name in scene.objects else scene.call(name, item)
        if target is None:
            continue
        for member, declared in members(item):
            path = f"{name}.{member}"
            if isinstance(declared, staticmethod) or callable(declared):
                yield path, lambda path=path, target=target, member=member: scene.call(path, getattr(target, member))
            else:
                yield path, lambda target=target, member=member: getattr(target, member)
        yield f"repr({name})", lambda target=target: repr(target)
        yield f"{name} == itself", lambda target=target: target == target
        if "__reduce__" in vars(item):
            yield f"pickle({name})", lambda target=target: kept(target)
    field = scene.ball
    yield "Field arithmetic", lambda: (2.0 * field + field - field / 2.0) * field
    yield "array of Field", lambda: (np.asarray(field), field[1:3, 2], np.abs(field))
    yield "a loop", lambda: ss.history.FrettingLoop(
        ss.history.LoadPath.sine((1e-7, 0.0), 4), lambda shift: ss.LoadStep(shift=shift, normal_force=100.0)
    ).run(scene.history, 1)
    yield "a wear run with a threshold", lambda: ss.wear.run(
        scene.history,
        ss.history.FrettingLoop(
            ss.history.LoadPath.sine((1e-7, 0.0), 4), lambda shift: ss.LoadStep(shift=shift, normal_force=100.0)
        ),
        ss.wear.ThresholdEnergyLaw(1e-15, 1.0),
        20,
        max_residual=0.99,
    )


def kept(target):
    """Pickles and unpickles an object. Results of a history are copied by `keep` first."""
    return pickle.loads(pickle.dumps(target.keep() if hasattr(target, "keep") else target))


def threads():
    """Returns the numbers of Python threads and of other threads of this process."""
    return len(os.listdir("/proc/self/task"))


def sweep(cells, told=lambda name: None):
    scene = Scene(cells)
    count = 0
    for name, call in calls(scene):
        told(name)
        try:
            call()
        except Exception as error:
            raise RuntimeError(f"{name}: {type(error).__name__}: {error}") from error
        count += 1
    return count


def in_a_forked_process(cells):
    """Runs the work in a forked process and reports its result. Kills the process after the time limit."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        status = 1
        try:
            sweep(cells, lambda name: os.write(writing, name.encode() + b"\n"))
            status = 0
        finally:
            os._exit(status)
    os.close(writing)
    last, end = b"nothing", time.monotonic() + TIMEOUT
    while True:
        ready, _, _ = select.select([reading], [], [], max(0.0, end - time.monotonic()))
        if not ready:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
            sys.exit(f"the forked process hangs in {last.decode()}")
        text = os.read(reading, 65536)
        if not text:
            break
        last = text.split()[-1]
    _, status = os.waitpid(child, 0)
    if status != 0:
        sys.exit(f"the forked process failed in {last.decode()}")


def main(cells, own=None):
    before = threads()
    if own is not None:
        ss.set_num_threads(own)
    count = sweep(cells)
    grown = threads() - before
    allowed = 0 if own == 1 else ss.num_threads()
    if grown > allowed:
        sys.exit(f"{grown} threads were started, of {allowed}")
    in_a_forked_process(cells)
    print(count)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
