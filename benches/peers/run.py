#!/usr/bin/env python3
"""Compares the times of stickslip and its peers in one run, for the same gaps and the same measured error.

    python3 benches/peers/run.py            the whole comparison
    python3 benches/peers/run.py --quick    256 x 256 cells only

Installs the peers in a separate virtual environment (in target/peers), builds the small crate in this folder and
writes target/peers/report.md. benches/README.md describes the measured quantities.
"""

import argparse
import datetime
import json
import os
import pathlib
import statistics
import subprocess
import sys
import time
import venv

sys.dont_write_bytecode = True  # Avoid cache files in the source tree.

import codes
import report
from workers import Ours, Peer

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="256 x 256 cells, three rounds")
    parser.add_argument("--sizes", type=int, nargs="+", default=[512, 1024])
    parser.add_argument("--shear-sizes", type=int, nargs="*", default=codes.SHEAR_SIZES)
    parser.add_argument("--threads", type=int, nargs="+", default=[2, 1])
    parser.add_argument("--repeats", type=int, default=5, help="rounds, of which least and median")
    parser.add_argument("--skip", nargs="*", default=[], help="peers to leave out")
    parser.add_argument("--scenes", nargs="*", help="only these")
    parser.add_argument("--patience", type=float, default=180, help="seconds that a solve may take")
    parser.add_argument("--budget", type=float, default=8, help="seconds for all rounds of one race")
    parser.add_argument("--readme", action="store_true", help="put the output into benches/README.md")
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "target" / "peers")
    chosen = parser.parse_args()
    if chosen.quick:
        chosen.sizes, chosen.shear_sizes, chosen.repeats = [256], [256], 3
    chosen.folder = chosen.folder.resolve()
    return chosen


def install(folder, skip):
    """Returns the Python of the environment and the versions of the peers that could be installed."""
    home = folder / "venv"
    python = home / "bin" / "python"
    if not python.exists():
        venv.create(home, with_pip=True)
    pip = [str(python), "-m", "pip", "--disable-pip-version-check"]
    subprocess.run([*pip, "install", "-q", *codes.COMMON], check=True)
    versions = {}
    for code, packages in codes.PACKAGES.items():
        if code in skip:
            continue
        listed = subprocess.run([*pip, "freeze"], check=True, capture_output=True, text=True).stdout
        if all(package in listed.splitlines() for package in packages):
            versions[code] = packages
            continue
        print(f"installing {' '.join(packages)}", flush=True)
        command = [*pip, "install", "-q", *codes.OPTIONS.get(code, []), *packages]
        if subprocess.run(command).returncode == 0:
            versions[code] = packages
        else:
            print(f"{code} cannot be installed here: left out", flush=True)
    return str(python), versions


def build(folder):
    target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", folder / "build")).resolve()
    manifest = str(HERE / "Cargo.toml")
    command = ["cargo", "build", "--release", "--manifest-path", manifest, "--target-dir", str(target)]
    subprocess.run(command, check=True)
    return str(target / "release" / "stickslip-bench-peers")


def reached(answer, target):
    return answer.get("status") == "converged" and answer.get("energy", 1) <= target


class Scan:
    """Search for the fastest setting and tolerance of every code for every error."""

    def __init__(self, ours, peers):
        self.ours, self.peers = ours, peers
        self.known = {}
        # Index of the tolerance found on the previous, smaller grid, where the search starts.
        self.first = {}
        # Settings that were too slow on a smaller grid and are not tried on larger grids.
        self.lost = set()

    def look(self, code, problem, scene, target):
        """Tries settings and tolerances, the loosest first, until each setting reaches the target or is too
        slow. Returns the reason why a setting did not reach the target."""
        best, trouble = None, "no tolerance reached it"
        tolerances = codes.TOLERANCES[code, problem]
        for name, options in codes.SETTINGS[code, problem]:
            key = (code, problem, name, scene["scene"], target)
            if key in self.lost:
                continue
            for index in range(max(self.first.get(key, 0) - 1, 0), len(tolerances)):
                answer = self.measured(code, problem, scene, name, options, tolerances[index])
                if "whole" not in answer:
                    trouble = answer["status"]
                    break
                # A setting that is slightly slower may be slower only by noise.
                if best and answer["whole"] > 1.3 * best:
                    if answer["whole"] > 2 * best:
                        self.lost.add(key)
                    break
                if reached(answer, target):
                    self.first[key] = index
                    best = min(best or answer["whole"], answer["whole"])
                    break
                if answer["status"] != "converged":
                    trouble = answer["status"]
                    break
        return trouble

    def peer(self, code, problem, scene, target):
        """Returns the fastest `(name, options, tolerance, answer)` that reached the target, or None."""
        options = dict(codes.SETTINGS[code, problem])
        place = (code, problem, scene["scene"], scene["cells"])
        found = [
            (name, options[name], tolerance, answer)
            for (*where, name, tolerance), answer in self.known.items()
            if tuple(where) == place and reached(answer, target)
        ]
        return min(found, key=lambda way: way[3]["whole"], default=None)

    def measured(self, code, problem, scene, name, options, tolerance):
        key = (code, problem, scene["scene"], scene["cells"], name, tolerance)
        if key not in self.known:
            worker = self.peers[codes.VARIANTS[code][-1]]
            answer = worker.measured(problem, scene, options, tolerance, self.ours)
            if answer.get("whole", 1) < 1:
                # The first call may include the time for loading the library.
                again = worker.solve(problem, scene, options, tolerance)
                answer["whole"] = min(answer["whole"], again.get("whole", answer["whole"]))
            show("scan", scene, problem, code, name, tolerance, answer)
            self.known[key] = answer
        return self.known[key]

    def floors(self, scenes, available):
        """Returns the energy errors at the tightest tolerance on a small grid."""
        found = {}
        for code in available:
            name, options = codes.SETTINGS[code, "press"][0]
            for scene in scenes:
                answer = self.measured(code, "press", scene, name, options, codes.FLOOR_TOLERANCE)
                found.setdefault(code, {})[scene["scene"]] = answer.get("energy")
        return found

    def own(self, problem, scene, error):
        """Returns the largest tolerance at which the error of this library does not exceed the error of the peer."""
        for tolerance in codes.HALF_DECADES:
            key = ("stickslip", problem, scene["scene"], scene["cells"], "", tolerance)
            if key not in self.known:
                self.known[key] = self.ours.measured(problem, scene, tolerance)
                show("scan", scene, problem, "stickslip", "", tolerance, self.known[key])
            if reached(self.known[key], error):
                return tolerance, self.known[key]
        raise SystemExit(f"stickslip does not reach {error} on {scene}")


def show(*words):
    *words, answer = words
    scene = words[1]
    numbers = " ".join(f"{key} {answer[key]:.3g}" for key in ("whole", "solve", "energy", "l1") if key in answer)
    place = f"{scene['scene']} {scene['cells']}"
    print(words[0], place, *words[2:], answer["status"], numbers, flush=True)


def races(scan, problem, scene, available):
    """Returns the fastest setting of every peer for every target, with the corresponding tolerance of this library."""
    tried = [
        (target, code)
        for target in codes.TARGETS
        for code in available
        if codes.is_tried(code, problem, scene, target)
    ]
    troubles = {(target, code): scan.look(code, problem, scene, target) for target, code in tried}
    found = []
    for target, code in tried:
        best = scan.peer(code, problem, scene, target)
        if best is None:
            found.append({"code": code, "target": target, "trouble": troubles[target, code]})
            continue
        name, options, tolerance, answer = best
        own_tolerance, own = scan.own(problem, scene, answer["energy"])
        for variant in codes.VARIANTS[code]:
            found.append(
                {
                    "code": variant,
                    "is_as_scanned": variant == codes.VARIANTS[code][-1],
                    "target": target,
                    "setting": name,
                    "options": options,
                    "tolerance": tolerance,
                    "peer": answer,
                    "own_tolerance": own_tolerance,
                    "own": own,
                }
            )
    return [{**race, "problem": problem, "scene": scene} for race in found]


def run_rounds(found, ours, peers, repeats, budget):
    """Runs all races in turn, in several rounds. In each race this library runs after the peer, at the tolerance of
    the race. A race ends when its peer has used up its budget. If a peer used it up in the scan, the time of the scan
    is used."""
    parts = [f"{who}_{part}" for who in ("peer", "own") for part in ("whole", "solve")]
    times = [{part: [] for part in parts} for _ in found]
    for race, kept in zip(found, times):
        if race.get("is_as_scanned") and race["peer"]["whole"] >= budget:
            for part in ("whole", "solve"):
                kept[f"peer_{part}"].append(race["peer"][part])
    for number in range(repeats):
        for race, kept in zip(found, times):
            if "trouble" in race:
                continue
            problem, scene, peer = race["problem"], race["scene"], race["code"]
            if sum(kept["peer_whole"]) < budget:
                answer = peers[peer].solve(problem, scene, race["options"], race["tolerance"])
                keep(kept, "peer", answer)
            elif number >= 3:
                continue
            keep(kept, "own", ours.solve(problem, scene, race["own_tolerance"]))
        print(f"round {number + 1} done", flush=True)
    for race, kept in zip(found, times):
        for part, values in kept.items():
            if values:
                least, median = min(values), statistics.median(values)
                race[part] = {"least": least, "median": median, "rounds": len(values)}


def is_timed_again(race, budget):
    """Returns whether a race is repeated with a different number of threads. Races on large grids and slow races
    are excluded. A slow peer without threads is included, because its known times are valid for any number of threads.
    Only one of the waiting modes is repeated."""
    return (
        "peer" in race
        and (race["peer"]["whole"] < budget or race["code"] in codes.SINGLE_THREADED)
        and race["scene"]["cells"] <= codes.SECOND_PASS_TO
        and race["code"] != codes.CALM
    )


def keep(kept, who, answer):
    for part in ("whole", "solve"):
        if part in answer:
            kept[f"{who}_{part}"].append(answer[part])


def main():
    chosen = arguments()
    chosen.folder.mkdir(parents=True, exist_ok=True)
    python, versions = install(chosen.folder, chosen.skip)
    binary = build(chosen.folder)
    fields = chosen.folder / "fields"
    # References are recomputed, because they are solutions of this library.
    for path in fields.glob("*.f64"):
        path.unlink()
    start = time.monotonic()
    sizes = {"press": chosen.sizes, "shear": chosen.shear_sizes}
    needed = sorted({codes.FLOOR_SIZE, *chosen.sizes, *chosen.shear_sizes})
    command = [binary, "write", str(fields), *map(str, needed)]
    written = subprocess.run(command, check=True, capture_output=True, text=True)
    scenes = [json.loads(line) for line in written.stdout.splitlines()]
    scenes = [scene for scene in scenes if not chosen.scenes or scene["scene"] in chosen.scenes]

    results, choice, floors = [], None, {}
    for threads in chosen.threads:
        ours = Ours(binary, threads, chosen.patience, fields)
        peers = {
            variant: Peer(code, python, threads, chosen.patience, fields, codes.ENVIRONMENT.get(variant))
            for code in versions
            for variant in codes.VARIANTS[code]
        }
        if choice is None:
            scan = Scan(ours, peers)
            floors = scan.floors([s for s in scenes if s["cells"] == codes.FLOOR_SIZE], versions)
            choice = [
                race
                for problem in ("press", "shear")
                for scene in scenes
                if scene["cells"] in sizes[problem]
                for race in races(scan, problem, scene, versions)
            ]
        again = [dict(race) for race in choice if not results or is_timed_again(race, chosen.budget)]
        run_rounds(again, ours, peers, chosen.repeats, chosen.budget)
        results += [{**race, "threads": threads} for race in again]
        for worker in [ours, *peers.values()]:
            worker.worker.close()
        record = {
            "date": str(datetime.date.today()),
            "minutes": (time.monotonic() - start) / 60,
            "machine": report.machine(),
            "versions": versions,
            "floors": floors,
            "results": results,
        }
        (chosen.folder / "report.json").write_text(json.dumps(record, indent=1))
        text = report.report(record)
        (chosen.folder / "report.md").write_text(text)
    print(text)
    if chosen.readme:
        readme = HERE.parent / "README.md"
        before, heading, _ = readme.read_text().partition("### Output of the day\n")
        readme.write_text(f"{before}{heading}\n{text}")


if __name__ == "__main__":
    sys.exit(main())
