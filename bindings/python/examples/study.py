"""The study of the Rust example of the same name, run with Python engines. The table is identical byte for byte.

    python study.py --seeds 1-25 --out study.csv                      # one process per core
    python study.py --engine dask --out study.csv                     # Dask, local or with --scheduler tcp://host:8786
    python study.py --shard 3/16 --out part-3.csv                     # one part, for a Slurm array or HyperQueue

An existing table is continued. `study --merge` of the crate joins parts written by either program. The progress bar needs
tqdm, and Dask needs dask[distributed].
"""

import argparse
import concurrent.futures
import contextlib
import itertools
import math
import multiprocessing
import os
import re
import sys

import stickslip as ss

STATUS = {"iteration_limit": "stopped at the iteration limit"}
KEY = ["case", "cells", "hurst", "pressure", "seed", "friction", "pull"]
NORMAL = ["contact_cells", "unresolved_spots", "contact_area", "contact_area_corrected", "mean_gap"]
TANGENTIAL = ["stick_ratio", "shift"]
REPORT = ["status", "iterations", "double_products", "single_products", "residual", "energy_error"]
COLUMNS = KEY + NORMAL + TANGENTIAL + [f"{solve}_{name}" for solve in ("normal", "tangential") for name in REPORT]


def number(value):
    """Returns the shortest decimal representation of a number, in the notation of Rust."""
    return re.sub(r"e([-+])0*", lambda sign: "e" + sign[1].strip("+"), repr(float(value)))


def report(solution_or_error):
    """Returns the columns of a report, or the reason why there was no solve."""
    if isinstance(solution_or_error, str):
        return [solution_or_error] + [""] * (len(REPORT) - 1)
    found = solution_or_error.report
    status = STATUS.get(str(found.status), str(found.status))
    counts = [found.iterations, found.double_precision_products, found.single_precision_products]
    return [status, *map(str, counts), number(found.residual), number(found.energy_error_bound)]


def solve(plan, press, frictions):
    """Returns the rows of one pressure with their keys: one surface, pressed once and sheared with each friction
    coefficient."""
    ss.set_num_threads(1)
    hurst, pressure, seed = press
    grid = ss.Grid.square(plan["cells"], 1.0)
    material = ss.Material(1.0, 0.3)
    bodies = ss.HalfSpace(grid, (material, material), boundary="periodic")
    recipe = ss.surface.SelfAffine(
        rms_slope=1.0, hurst=hurst, roll_off_wavelength=plan["roll_off"],
        cut_off_wavelength=plan["cut_off"] * grid.dx, seed=seed,
    )  # fmt: skip
    rough = recipe.generate(grid)
    force = pressure * bodies.pair.contact_modulus
    settings = {"tolerance": plan["tolerance"], "max_iterations": plan["iterations"]}
    results, contact = [""] * len(NORMAL), None
    try:
        gap = ss.surface.gap_from_heights(rough.heights)
        contact = pressed = ss.NormalProblem(bodies, gap, force=force, **settings).solve(warn=False)
    except ss.errors.NotConverged as error:
        pressed = error
    if contact is not None:
        unresolved = sum(spot.cells < 5 for spot in contact.spots)
        mean_gap = ss.Field(grid, contact.gap).integral() / grid.area / rough.rms_height
        areas = [contact.contact_area / grid.area, contact.contact_area_corrected / grid.area]
        results = [str(contact.contact_cells), str(unresolved), *map(number, areas), number(mean_gap)]
    rows = []
    for friction in frictions:
        shear, sheared = [""] * len(TANGENTIAL), "not solved"
        if contact is not None:
            try:
                problem = ss.TangentialProblem(bodies, contact, friction, force_x=plan["pull"] * force, **settings)
                sheared = problem.solve(warn=False)
                shear = [number(sheared.stick_ratio), number(sheared.shift[0] / rough.rms_height)]
            except ss.errors.NotConverged as error:
                sheared = error
            except ss.errors.BeyondFrictionCapacity:
                sheared = "beyond the friction capacity"
        rows.append(((*press, friction), results + shear + report(pressed) + report(sheared)))
    return rows


def seeds(text):
    """Parses numbers and ranges such as 1-20,25."""
    ranges = [part.partition("-") for part in text.split(",")]
    return [seed for first, _, last in ranges for seed in range(int(first), int(last or first) + 1)]


def command(plan):
    """Returns the first line of a table, a command that repeats the study."""
    runs, joined = [], lambda name: ",".join(map(number, plan[name]))
    for seed in plan["seeds"]:
        runs.append([runs.pop()[0], seed] if runs and runs[-1][1] + 1 == seed else [seed, seed])
    ranges = ",".join(str(first) if first == last else f"{first}-{last}" for first, last in runs)
    return (
        f"# stickslip {ss.__version__} study --cells {plan['cells']} --hursts {joined('hursts')} --pressures "
        f"{joined('pressures')} --seeds {ranges} --frictions {joined('frictions')} --pull {number(plan['pull'])} --roll-off "
        f"{number(plan['roll_off'])} --cut-off {number(plan['cut_off'])} --tolerance {number(plan['tolerance'])} "
        f"--iterations {plan['iterations']}"
    )


class Table:
    """File to which a single process appends complete rows."""

    def __init__(self, path, plan):
        self.file = open(path, "a+b", buffering=0)
        with contextlib.suppress(ImportError):  # available on Unix only
            import fcntl

            try:
                fcntl.flock(self.file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                sys.exit(f"{path}: another program is writing this table")
        self.file.seek(0)
        head, text = f"{command(plan)}\n{','.join(COLUMNS)}\n".encode(), self.file.read()
        self.length = text.rfind(b"\n") + 1 if len(text) >= len(head) or not head.startswith(text) else 0
        if self.length and not text.startswith(head):
            sys.exit(f"{path} is not a table of this study")
        self.file.truncate(self.length)  # removes the incomplete line of a killed program
        self.rows = set()
        for line, row in enumerate(text[: self.length].split(b"\n")[2:-1], 3):
            words = row.split(b",")
            if len(words) == len(COLUMNS):
                self.rows.add(tuple(words[: len(KEY)]))
            else:
                print(f"{path}, line {line}: not a row of this study, left out", file=sys.stderr)
        if not self.length:
            self.write(head)

    def has(self, key):
        return tuple(word.encode() for word in key) in self.rows

    def write(self, lines):
        """Writes all lines, or none if the disk is full."""
        try:
            written = self.file.write(lines)
            if written != len(lines):
                raise OSError(f"{written} of {len(lines)} bytes written: is the disk full?")
        except OSError:
            self.file.truncate(self.length)
            raise
        self.length += len(lines)
        os.fsync(self.file.fileno())


def results(jobs, engine, workers, scheduler):
    """Yields the results of the jobs as they finish."""
    if engine == "dask":
        from dask.distributed import Client, as_completed

        local = {"n_workers": workers, "threads_per_worker": 1, "dashboard_address": None}
        with Client(scheduler) if scheduler else Client(**local) as client:
            futures = [client.submit(solve, *job, pure=False) for job in jobs]
            for future in as_completed(futures):
                yield future.result()
        return
    context = multiprocessing.get_context("spawn")
    with concurrent.futures.ProcessPoolExecutor(workers, context) as pool:
        for future in concurrent.futures.as_completed([pool.submit(solve, *job) for job in jobs]):
            yield future.result()


def main():
    numbers = lambda text: [float(word) for word in text.split(",")]  # noqa: E731
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--cells", type=int, default=64)
    options.add_argument("--hursts", type=numbers, default=[0.8])
    options.add_argument("--pressures", type=numbers, default=[0.02, 0.05, 0.1])
    options.add_argument("--seeds", type=seeds, default=[1, 2, 3, 4])
    options.add_argument("--frictions", type=numbers, default=[0.2, 0.4])
    options.add_argument("--pull", type=float, default=0.1)
    options.add_argument("--roll-off", type=float, default=0.25)
    options.add_argument("--cut-off", type=float, default=8.0)
    options.add_argument("--tolerance", type=float, default=1e-6)
    options.add_argument("--iterations", type=int, default=10_000)
    options.add_argument("--shard", default="1/1", metavar="I/N")
    options.add_argument("--out", default="study.csv")
    options.add_argument("--engine", choices=["processes", "dask"], default="processes")
    options.add_argument("--workers", type=int, default=os.cpu_count())
    options.add_argument("--scheduler", help="the address of Dask's scheduler")
    plan = vars(options.parse_args())
    part, parts = map(int, plan["shard"].split("/"))

    # In the numbering of cases the friction varies fastest, then the pressure, the Hurst exponent and the seed.
    presses = [(hurst, pressure, seed) for seed, hurst, pressure in
               itertools.product(plan["seeds"], plan["hursts"], plan["pressures"])]  # fmt: skip
    # Shards are the same as in the crate: each shard contains every pressure.
    period = math.lcm(len(plan["hursts"]) * len(plan["pressures"]), parts)
    keys, jobs, table = {}, [], Table(plan["out"], plan)
    for index, press in enumerate(presses):
        if (index + index // period) % parts != part - 1:
            continue
        missing = []
        for place, friction in enumerate(plan["frictions"]):
            case = index * len(plan["frictions"]) + place + 1
            hurst, pressure, seed = press
            key = [str(case), str(plan["cells"]), number(hurst), number(pressure), str(seed), number(friction),
                   number(plan["pull"])]  # fmt: skip
            keys[(*press, friction)] = key
            if not table.has(key):
                missing.append(friction)
        if missing:
            jobs.append((plan, press, missing))

    done = results(jobs, plan["engine"], plan["workers"], plan["scheduler"]) if jobs else []
    with contextlib.suppress(ImportError):
        from tqdm import tqdm

        done = tqdm(done, total=len(jobs), unit=" presses", disable=None)
    for rows in done:
        for key, row in rows:
            table.write((",".join(keys[key] + row) + "\n").encode())
    print(f"{len(keys)} cases in {plan['out']}")


if __name__ == "__main__":
    main()
