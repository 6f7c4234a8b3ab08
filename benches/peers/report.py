"""The tables of a run, as plain text."""

import pathlib
import platform
import subprocess

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
    lines = ["```text", *header(record), "", *tables, *verdicts(results), "```", ""]
    return "\n".join(lines)


def machine():
    """What the numbers depend on beside the peers."""
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


def table(rows):
    head = ["scene", "N", "code: setting", "tol", "energy", "L1", "whole, s", "solve, s"]
    head += ["stickslip tol", "energy", "L1", "whole, s", "solve, s", "ratio whole", "ratio solve", "rounds"]
    lines = [head]
    for row in rows:
        scene = row["scene"]
        start = [scene["scene"], str(scene["cells"])]
        if "trouble" in row:
            reason = f"{row['code']}: not to {row['target']:.0e}: {row['trouble']}"
            lines.append([*start, reason, *[""] * (len(head) - 3)])
            continue
        peer, own = row["peer"], row["own"]
        lines.append(
            [
                *start,
                f"{row['code']}: {row['setting']}",
                f"{row['tolerance']:.0e}",
                f"{peer['energy']:.1e}",
                f"{peer['l1']:.1e}",
                span(row.get("peer_whole")),
                span(row.get("peer_solve")),
                f"{row['own_tolerance']:.0e}",
                f"{own['energy']:.1e}",
                f"{own['l1']:.1e}",
                span(row.get("own_whole")),
                span(row.get("own_solve")),
                ratio(row, "whole"),
                ratio(row, "solve"),
                str(row.get("peer_whole", {}).get("rounds", 0)),
            ]
        )
    widths = [max(len(line[k]) for line in lines) for k in range(len(head))]
    left = 3
    return [
        "  ".join(
            cell.ljust(width) if k < left else cell.rjust(width)
            for k, (cell, width) in enumerate(zip(line, widths))
        ).rstrip()
        for line in lines
    ]


def span(times):
    """Least and median."""
    if times is None:
        return "-"
    return f"{times['least']:.3g} {times['median']:.3g}"


def quotients(row, part):
    """The peer's time over this library's: of the least times, and of the medians."""
    peer, own = row.get(f"peer_{part}"), row.get(f"own_{part}")
    if peer is None or own is None:
        return None
    return peer["least"] / own["least"], peer["median"] / own["median"]


def ratio(row, part):
    pair = quotients(row, part)
    return "-" if pair is None else f"{pair[0]:.1f} {pair[1]:.1f}"


def verdicts(results):
    """Each aim against the least ratio of the least times: for a code that was timed in two ways, the
    ratio to its faster one."""
    lines = ["Aims, by the least times (whole, solve alone):"]
    for problem, code, scene, aim in codes.AIMS:
        for size in sorted({row["scene"]["cells"] for row in results}):
            for threads in sorted({row["threads"] for row in results}, reverse=True):
                pairs = {}
                for row in results:
                    place = row["scene"]
                    if (row["problem"], place["cells"], row["threads"]) != (problem, size, threads):
                        continue
                    if row["code"] not in codes.VARIANTS[code] or not place["scene"].startswith(scene):
                        continue
                    found = [quotients(row, part) for part in ("whole", "solve")]
                    if None not in found:
                        key = (place["scene"], row["target"])
                        pairs.setdefault(key, []).append([pair[0] for pair in found])
                fastest = [[min(part) for part in zip(*several)] for several in pairs.values()]
                if fastest:
                    whole, solve = ([pair[k] for pair in fastest] for k in (0, 1))
                    met = "met" if min(*whole, *solve) >= aim else "missed" if max(*whole, *solve) < aim else "met in part"
                    name = f"{problem} {scene or 'all scenes'}".strip()
                    lines.append(
                        f"{name} {size}, {threads} thr., against {code}: aim {aim}, "
                        f"whole {min(whole):.1f} to {max(whole):.1f}, solve {min(solve):.1f} to {max(solve):.1f}: {met}"
                    )
    return lines


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
    return f"{cores} cores of {values.get('model name')} (family {values.get('cpu family')}, model {values.get('model')})"
