"""Formats the tables of a run as plain text."""

import itertools
import json
import pathlib
import platform
import subprocess
import sys

import codes


def report(record):
    results = record["results"]
    tables = []
    for problem, title in (("press", "Pressure"), ("shear", "Shear traction, Poisson's ratio 0")):
        for threads in sorted({row["threads"] for row in results}, reverse=True):
            rows = [r for r in results if r["problem"] == problem and r["threads"] == threads]
            if rows:
                noun = "thread" if threads == 1 else "threads"
                tables += [f"{title}, {threads} {noun}", "", *table(rows), ""]
    opening = [*header(record), "", *legend(), "", *floors(record["floors"]), ""]
    lines = ["```text", *opening, *tables, *ranges(results), "```", ""]
    return "\n".join(lines)


def machine():
    """Returns the conditions, other than the peers, on which the numbers depend."""
    return {
        "processor": processor(),
        "stickslip": commit(),
        "rustc": output("rustc", "--version"),
        "python": platform.python_version(),
    }


def header(record):
    machine, versions = record["machine"], record["versions"]
    missing = [code for code in codes.PACKAGES if code not in versions]
    listed = [package for packages in versions.values() for package in packages]
    lines = [
        f"{record['date']}, {machine['processor']}, {record['minutes']:.0f} minutes",
        f"stickslip {machine['stickslip']}, {machine['rustc']}, Python {machine['python']}",
        ", ".join(listed),
        ", ".join(codes.COMMON),
    ]
    if missing:
        lines.append(f"left out or not to be installed: {', '.join(missing)}")
    return lines


def floors(found):
    size, tolerance = codes.FLOOR_SIZE, codes.FLOOR_TOLERANCE
    lines = [f"Energy error at tolerance {tolerance:.0e} on {size} x {size} cells:"]
    for code, errors in found.items():
        listed = [f"{scene} {'-' if error is None else f'{error:.1e}'}" for scene, error in errors.items()]
        lines.append(f"{code}: {', '.join(listed)}")
    return lines


def table(rows):
    lines = [["", "", "", "peer", *[""] * 4, "stickslip", *[""] * 4, "ratio", "", ""]]
    run = ["tol", "energy", "L1", "whole, ms", "solve, ms"]
    lines.append(["scene", "N", "code", *run, *run, "whole", "solve", "n"])
    for row in rows:
        scene = row["scene"]
        start = [scene["scene"], str(scene["cells"]), name(row)]
        if "trouble" in row:
            lines.append([*start, f"not to {row['target']:.0e}: {row['trouble']}"])
            continue
        peer = run_cells(row["tolerance"], row["peer"], row.get("peer_whole"), row.get("peer_solve"))
        own = run_cells(row["own_tolerance"], row["own"], row.get("own_whole"), row.get("own_solve"))
        rounds = str(row.get("peer_whole", {}).get("rounds", 0))
        lines.append([*start, *peer, *own, ratio(row, "whole"), ratio(row, "solve"), rounds])
    full = [line for line in lines if len(line) == len(lines[1])]
    widths = [max(len(line[k]) for line in full) for k in range(len(lines[1]))]
    return [
        " ".join(
            # Names are aligned left, numbers right, and group headings above their first column.
            cell.ljust(width) if k < 3 or line is lines[0] or len(line) < len(widths) else cell.rjust(width)
            for k, (cell, width) in enumerate(zip(line, widths))
        ).rstrip()
        for line in lines
    ]


def run_cells(tolerance, answer, whole, solve):
    errors = [f"{answer[key]:.1e}" for key in ("energy", "l1")]
    return [f"{tolerance:.0e}", *errors, span(whole), span(solve)]


def letter(code, problem, setting):
    """Returns the letter of a setting, or nothing if there is only one setting."""
    names = [listed for listed, _ in codes.SETTINGS[code, problem]]
    return f" {chr(ord('A') + names.index(setting))}" if len(names) > 1 else ""


def name(row):
    if "setting" not in row:
        return row["code"]
    code = row["code"].split(",")[0]
    return code + letter(code, row["problem"], row["setting"]) + row["code"].removeprefix(code)


def legend():
    lines = []
    for (code, problem), settings in codes.SETTINGS.items():
        for setting, _ in settings:
            lines.append(f"{code + letter(code, problem, setting)}, {problem}: {setting}")
    return lines


def span(times):
    """Returns minimum and median, in milliseconds."""
    if times is None:
        return "-"
    milliseconds = [1e3 * times[key] for key in ("least", "median")]
    return " ".join(f"{time:.1f}" if time < 100 else f"{time:.0f}" for time in milliseconds)


def quotients(row, part):
    """Returns the time of the peer divided by the time of this library, for the minima and for the medians."""
    peer, own = row.get(f"peer_{part}"), row.get(f"own_{part}")
    if peer is None or own is None:
        return None
    return peer["least"] / own["least"], peer["median"] / own["median"]


def ratio(row, part):
    pair = quotients(row, part)
    return "-" if pair is None else f"{pair[0]:.1f} {pair[1]:.1f}"


def ranges(results):
    """Returns the ranges of the ratios of the minimum times. For a code that was timed in two modes, the ratios refer to the
    faster mode."""
    lines = ["Ratios of the least times (least and largest over scenes and errors):"]
    sizes = sorted({row["scene"]["cells"] for row in results})
    threads = sorted({row["threads"] for row in results}, reverse=True)
    for problem, code, scene in codes.RANGES:
        for size, number in itertools.product(sizes, threads):
            pairs = {}
            for row in results:
                place = row["scene"]
                is_meant = (
                    (row["problem"], place["cells"], row["threads"]) == (problem, size, number)
                    and row["code"] in codes.VARIANTS[code]
                    and place["scene"].startswith(scene)
                )
                found = [quotients(row, part) for part in ("whole", "solve")]
                if is_meant and None not in found:
                    key = (place["scene"], row["target"])
                    pairs.setdefault(key, []).append([pair[0] for pair in found])
            fastest = [[min(part) for part in zip(*several)] for several in pairs.values()]
            if fastest:
                whole, solve = ([pair[k] for pair in fastest] for k in (0, 1))
                lines.append(
                    f"{problem} {scene or 'all scenes':10} {size:4}, {number} thr., {code:16}: "
                    f"whole {extent(whole)}; solve alone {extent(solve)}"
                )
    return lines


def extent(ratios):
    return f"{min(ratios):.1f} to {max(ratios):.1f}"


def main():
    """Prints the report again from the stored numbers of a run."""
    print(report(json.loads(pathlib.Path(sys.argv[1]).read_text())), end="")


def output(*command):
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def commit():
    root = pathlib.Path(__file__).resolve().parent
    return output("git", "-C", str(root), "describe", "--always", "--dirty", "--tags")


def processor():
    try:
        text = pathlib.Path("/proc/cpuinfo").read_text()
    except OSError:
        return platform.processor()
    lines = [line.split(":", 1) for line in text.splitlines() if ":" in line]
    values = {key.strip(): value.strip() for key, value in lines}
    cores = sum(key.strip() == "processor" for key, _ in lines)
    family = f"family {values.get('cpu family')}, model {values.get('model')}"
    return f"{cores} cores of {values.get('model name')} ({family})"


if __name__ == "__main__":
    main()
