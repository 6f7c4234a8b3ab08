#!/usr/bin/env python3
"""Times stickslip beside its peers, on the same gaps, to the same measured error, in one run.

    python3 benches/peers/run.py            all of it
    python3 benches/peers/run.py --quick    256 x 256 cells only

Installs the peers in a virtual environment of its own (in target/peers), builds the small crate here and
writes target/peers/report.md. benches/README.md says what is measured.
"""

import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import time
import venv

import codes
import report
from workers import Ours, Peer

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="256 x 256 cells, three rounds")
    parser.add_argument("--sizes", type=int, nargs="+", default=[512, 1024])
    parser.add_argument("--threads", type=int, nargs="+", default=[2, 1])
    parser.add_argument("--repeats", type=int, default=5, help="rounds, of which least and median")
    parser.add_argument("--skip", nargs="*", default=[], help="peers to leave out")
    parser.add_argument("--scenes", nargs="*", help="only these")
    parser.add_argument("--patience", type=float, default=120, help="seconds that a solve may take")
    parser.add_argument("--slow", type=float, default=8, help="seconds from which one solve must do")
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "target" / "peers")
    chosen = parser.parse_args()
    if chosen.quick:
        chosen.sizes, chosen.repeats = [256], 3
    chosen.folder = chosen.folder.resolve()
    return chosen


def install(folder, skip):
    """The Python of the environment, and the versions of the peers that could be installed."""
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
    return str(target / "release" / "stickslip-peer")


def reached(answer, target):
    return answer.get("status") == "converged" and answer.get("energy", 1) <= target


class Scan:
    """Looks for the fastest way of every code to every error."""

    def __init__(self, ours, peers, slow):
        self.ours, self.peers, self.slow = ours, peers, slow
        self.known = {}
        # Where the last smaller grid found its tolerance: the search starts there.
        self.first = {}

    def peer(self, code, problem, scene, target):
        """`(name, options, tolerance, answer)`, or a line that says why there is none."""
        best, trouble = None, "no tolerance reached it"
        tolerances = codes.TOLERANCES[code, problem]
        for name, options in codes.SETTINGS[code, problem]:
            key = (code, problem, name, scene["scene"], target)
            for index in range(self.first.get(key, 0), len(tolerances)):
                answer = self.measured(code, problem, scene, name, options, tolerances[index])
                if "whole" not in answer:
                    trouble = answer["status"]
                    break
                # A little slower may be noise; the rounds will tell only what the scan lets through.
                if best and answer["whole"] > 1.3 * best[3]["whole"]:
                    break
                if reached(answer, target):
                    self.first[key] = index
                    if not best or answer["whole"] < best[3]["whole"]:
                        best = (name, options, tolerances[index], answer)
                    break
                if answer["status"] != "converged":
                    trouble = answer["status"]
                    break
        return best or trouble

    def measured(self, code, problem, scene, name, options, tolerance):
        key = (code, problem, name, scene["scene"], scene["cells"], tolerance)
        if key not in self.known:
            worker = self.peers[codes.VARIANTS[code][-1]]
            answer = worker.measured(problem, scene, options, tolerance, self.ours)
            if answer.get("whole", self.slow) < self.slow:
                # The first call may have paid for loading the library.
                again = worker.solve(problem, scene, options, tolerance)
                answer["whole"] = min(answer["whole"], again.get("whole", answer["whole"]))
            show("scan", scene, problem, code, name, tolerance, answer)
            self.known[key] = answer
        return self.known[key]

    def own(self, problem, scene, error):
        """The largest tolerance at which this library's own error is not above the peer's."""
        for tolerance in codes.HALF_DECADES:
            key = (problem, scene["scene"], scene["cells"], tolerance)
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
    """Every peer's best way to every target, with this library's match."""
    found = []
    for target in codes.TARGETS:
        for code in available:
            if (code, problem) not in codes.SETTINGS:
                continue
            best = scan.peer(code, problem, scene, target)
            if isinstance(best, str):
                found.append({"code": code, "target": target, "trouble": best})
                continue
            name, options, tolerance, answer = best
            own_tolerance, own = scan.own(problem, scene, answer["energy"])
            for variant in codes.VARIANTS[code]:
                found.append(
                    {
                        "code": variant,
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


def run_rounds(found, ours, peers, repeats, slow):
    """A, B, C, .. then A, B, C, .. again; this library after every peer, at the tolerance of that race."""
    times = [{key: [] for key in ("peer_whole", "peer_solve", "own_whole", "own_solve")} for _ in found]
    for number in range(repeats):
        for race, kept in zip(found, times):
            if "trouble" in race or (number > 0 and race["peer"]["whole"] >= slow):
                continue
            problem, scene = race["problem"], race["scene"]
            # Where a spinning code was caught by other work once, it is not waited for again and again.
            if not kept["peer_whole"] or min(kept["peer_whole"]) < slow:
                answer = peers[race["code"]].solve(problem, scene, race["options"], race["tolerance"])
                for key in ("whole", "solve"):
                    if key in answer:
                        kept[f"peer_{key}"].append(answer[key])
            answer = ours.solve(problem, scene, race["own_tolerance"])
            for key in ("whole", "solve"):
                kept[f"own_{key}"].append(answer[key])
    for race, kept in zip(found, times):
        for key, values in kept.items():
            if values:
                race[key] = {"least": min(values), "median": statistics.median(values), "rounds": len(values)}


def main():
    chosen = arguments()
    chosen.folder.mkdir(parents=True, exist_ok=True)
    python, versions = install(chosen.folder, chosen.skip)
    binary = build(chosen.folder)
    fields = chosen.folder / "fields"
    # References are made anew: they are this library's.
    for path in fields.glob("*.f64"):
        path.unlink()
    start = time.monotonic()
    sizes = [str(size) for size in sorted(chosen.sizes)]
    written = subprocess.run([binary, "write", str(fields), *sizes], check=True, capture_output=True, text=True)
    scenes = [json.loads(line) for line in written.stdout.splitlines()]
    scenes = [scene for scene in scenes if not chosen.scenes or scene["scene"] in chosen.scenes]

    results, choice = [], None
    for threads in chosen.threads:
        ours = Ours(binary, threads, chosen.patience, fields)
        peers = {
            variant: Peer(code, python, threads, chosen.patience, fields, codes.ENVIRONMENT.get(variant))
            for code in versions
            for variant in codes.VARIANTS[code]
        }
        if choice is None:
            scan = Scan(ours, peers, chosen.slow)
            choice = [
                race
                for problem in ("press", "shear")
                for scene in scenes
                if problem == "press" or scene["cells"] <= codes.LARGEST_SHEAR
                for race in races(scan, problem, scene, versions)
            ]
        # With fewer threads the same settings are timed again, but nothing slow twice.
        again = [
            dict(race)
            for race in choice
            if not results or ("peer" in race and race["peer"]["whole"] < chosen.slow)
        ]
        run_rounds(again, ours, peers, chosen.repeats, chosen.slow)
        results += [{**race, "threads": threads} for race in again]
        for worker in [ours, *peers.values()]:
            worker.worker.close()
        text = report.report(results, versions, chosen, time.monotonic() - start)
        (chosen.folder / "report.md").write_text(text)
        (chosen.folder / "report.json").write_text(json.dumps(results, indent=1))
    print(text)


if __name__ == "__main__":
    sys.exit(main())
