# SPDX-License-Identifier: GPL-3.0-or-later
"""What `flair-dev bench` measured, as tables for people."""

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass


def quantile(values: Iterable[float], share: float) -> float:
    """The value at `share` of the way through the sorted values, the upper one between two; 0 when there are none."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))] if ordered else 0


def mean(values: Iterable[float]) -> float:
    listed = list(values)
    return sum(listed) / len(listed) if listed else 0


def counted(count: int, thing: str) -> str:
    return f"{count} {thing}" if count == 1 else f"{count} {thing}s"


class Table:
    """Rows in columns, the first set to the left, the others to the right."""

    def __init__(self, titles: list[str], first_width: int, least_width: int = 6) -> None:
        self.titles = titles
        self.widths = [max(least_width, len(title)) for title in titles]
        self.widths[0] = max(first_width, len(titles[0]))

    def header(self) -> str:
        return self.row(self.titles) + "-" * (sum(self.widths) + len(self.widths) - 1) + "\n"

    def row(self, cells: list[str]) -> str:
        first = f"{cells[0][:self.widths[0]]:<{self.widths[0]}}"
        return " ".join([first, *(f"{cell:>{width}}" for cell, width in zip(cells[1:], self.widths[1:]))]) + "\n"


def at(record: dict, path: str) -> float | None:
    """The number at "ours/held"; None when the record does not have it."""
    value = record
    for name in path.split("/"):
        value = value.get(name) if isinstance(value, dict) else None
    return value


def numbers(records: list[dict], path: str, factor: float = 1) -> list[float]:
    return [factor * number for record in records if (number := at(record, path)) is not None]


@dataclass(frozen=True)
class Figure:
    """A column of a table of records."""

    title: str
    path: str
    digits: int = 0
    factor: float = 1

    def cell(self, record: dict) -> str:
        number = at(record, self.path)
        return "-" if number is None else f"{self.factor * number:.{self.digits}f}"


# ---- Solves

_SOLVE = [Figure("objs", "objects"), Figure("CPU ms", "cpu_s", 0, 1e3), Figure("runs", "restarts"),
          Figure("evals k", "evaluations", 0, 1e-3), Figure("primary", "stages/primary/cost", 3),
          Figure("second", "stages/secondary/cost", 3), Figure("polish", "stages/polish/cost", 3),
          Figure("tertiary", "stages/tertiary/cost", 3), Figure("OOB %", "ours/oob_percent", 4),
          Figure("OOR %", "ours/oor_percent", 4), Figure("deep mm", "ours/deepest_overlap_m", 3, 1e3),
          Figure("floor", "ours/reachable_floor_share", 3), Figure("fronts", "ours/reachable_front_share", 3),
          Figure("path m3", "ours/pathway_cost_m3", 4), Figure("held", "ours/held"), Figure("missed", "ours/missed"),
          Figure("rec path", "recorded/pathway_cost_m3", 4), Figure("rec held", "recorded/held")]

_SOLVE_LEGEND = """\
CPU ms    of a solve, all threads; runs and evals k: its restarts and thousands of evaluations
primary.. cost at the end of each stage, of the branch that won
OOB, OOR  area outside the room and in other things or door swings, percent of the room; deep: deepest overlap
floor     share of the free floor that can be reached from the door; fronts: share of the objects' fronts
path m3   pathway cost: how much stands in the ways; held, missed: constraints
rec       the same of the layout that the problem was recorded with

"""

# Measures beside those of the recorded layouts; of the first, less is better.
_LESS = {"oob_percent": "OOB, % of the room", "oor_percent": "OOR, % of the room",
         "deepest_overlap_m": "deepest overlap, m", "oob_3d_percent": "OOB in 3D, % of the volume",
         "oor_3d_percent": "OOR in 3D, % of the volume"}
_MORE = {"reachable_floor_share": "reachable floor, share", "reachable_front_share": "reachable fronts, share"}


def _beside_recorded(solves: list[dict]) -> str:
    """The measures beside those of the recorded layouts, over the rooms that have one."""
    paired = [solve for solve in solves if "recorded" in solve]
    if not paired:
        return ""
    table = Table([f"mean over {counted(len(paired), 'room')} with a recorded layout", "ours", "recorded", "ratio",
                   "ours no worse in"], 46, 9)

    def row(name: str, sign: int, of: Callable[[dict], float]) -> str:
        ours, theirs = [of(solve["ours"]) for solve in paired], [of(solve["recorded"]) for solve in paired]
        no_worse = sum(sign * (mine - other) >= -1e-9 for mine, other in zip(ours, theirs))
        ratio = f"{mean(ours) / mean(theirs):.3f}" if mean(theirs) > 0 else ""
        return table.row([name, f"{mean(ours):.4f}", f"{mean(theirs):.4f}", ratio, counted(no_worse, "room")])

    text = table.header() + row("share of constraints that hold, by our terms", 1,
                                lambda quality: quality["held"] / max(1, quality["held"] + quality["missed"]))
    for name, title in (_LESS | _MORE | {"pathway_cost_m3": "pathway cost, m3"}).items():
        text += row(title, 1 if name in _MORE else -1, lambda quality, name=name: quality[name])
    return text


def _stages(solves: list[dict]) -> str:
    table, text = Table(["stage", "CPU ms", "share", "runs", "evals k"], 10, 8), "mean per room\n"
    text += table.header()
    for name in solves[0]["stages"]:
        cpu_s, runs, evaluations = (mean(numbers(solves, f"stages/{name}/{of}"))
                                    for of in ("cpu_s", "restarts", "evaluations"))
        share = cpu_s / max(1e-9, mean(numbers(solves, "cpu_s")))
        text += table.row([name, f"{1e3 * cpu_s:.1f}", f"{100 * share:.0f} %", f"{runs:.1f}",
                           f"{1e-3 * evaluations:.0f}"])
    return text


def solve_summary(solves: list[dict]) -> str:
    cpu_s = numbers(solves, "cpu_s")
    held = int(sum(numbers(solves, "ours/held")))
    judged = held + int(sum(numbers(solves, "ours/missed")))
    memory = [solves[0]["memory_mib"]["before"], solves[-1]["memory_mib"]["after"]]
    return (f"\n{counted(len(solves), 'room')}: CPU median {quantile(cpu_s, 0.5):.3f} s, mean {mean(cpu_s):.3f} s, "
            f"95th percentile {quantile(cpu_s, 0.95):.3f} s, most {quantile(cpu_s, 1):.3f} s\n"
            f"restarts {mean(numbers(solves, 'restarts')):.1f}, evaluations "
            f"{mean(numbers(solves, 'evaluations', 1e-3)):.0f} k a room; {held} of {judged} constraints hold "
            f"({100 * held / max(1, judged):.1f} %)\n"
            f"memory of the process: {memory[0]:.1f} MiB before the first solve, {memory[1]:.1f} MiB at most\n\n"
            f"{_stages(solves)}\n{_beside_recorded(solves)}")


def show_solves(records: Iterator[dict], _: bool) -> Iterator[str]:
    """A line a room, each as soon as it is measured."""
    table, solves = Table(["room", *(figure.title for figure in _SOLVE)], 28), []
    for solve in records:
        if not solves:
            yield _SOLVE_LEGEND + table.header()
        solves.append(solve)
        yield table.row([solve["name"], *(figure.cell(solve) for figure in _SOLVE)])
    if solves:
        yield solve_summary(solves)


# ---- Edits

def show_edits(records: Iterator[dict], each: bool) -> Iterator[str]:
    """Medians and 95th percentiles by room and by kind of edit."""
    edits, by_room, by_kind = [], {}, {}
    for edit in records:
        edits.append(edit)
        by_room.setdefault(edit["room"], []).append(edit)
        by_kind.setdefault("all: " + edit["edit"].split(" ")[0], []).append(edit)
        if each:
            yield (f"{edit['room']:<28}{edit['edit']:<60}{1e3 * edit['cpu_s']:>8.1f} ms {edit['moved']:>3} moved, "
                   f"{edit['held_before']} -> {edit['held_after']}\n")
    if not edits:
        return
    width = max(12, *(len(room) for room in by_room))
    table = Table(["edits of", "edits", "CPU ms", "95 %", "most", "moved", "held", "after", "deep mm"], width, 7)

    def row(name: str, some: list[dict]) -> str:
        times = [f"{quantile(numbers(some, 'cpu_s', 1e3), share):.1f}" for share in (0.5, 0.95, 1)]
        means = [f"{mean(numbers(some, path)):.2f}" for path in ("moved", "held_before", "held_after")]
        deepest = quantile(numbers(some, "deepest_overlap_m", 1e3), 1)
        return table.row([name, str(len(some)), *times, *means, f"{deepest:.3f}"])

    yield ("CPU ms    of one edit: median, 95th percentile, most\n"
           "moved     objects; held, after: constraints that hold before and after it; means\n"
           "deep mm   deepest overlap; what a person moves or pins into something stays there\n\n")
    yield table.header() + "".join(row(room, by_room[room]) for room in sorted(by_room)) + "\n"
    yield table.header() + "".join(row(kind, by_kind[kind]) for kind in sorted(by_kind)) + row("all", edits)


# ---- Restarts

def hits(room: dict) -> list[bool]:
    """Which restarts ended within 1 % of the best (or 0.001, if that is more)."""
    best = min(room["scores"])
    return [score <= best + max(1e-3, 0.01 * abs(best)) for score in room["scores"]]


def restarts_curve(rooms: list[dict]) -> str:
    """Of each room after its first 1, 2, 4 ... restarts: whether one of them hit, how far the best of them is above the
    best of all, and what they took."""
    table = Table(["restarts", "rooms at their best %", "mean cost above it", "median CPU ms"], 8, 9)
    most = max(len(room["scores"]) for room in rooms)
    text = table.header()
    for count in [2 ** k for k in range(math.ceil(math.log2(most)))] + [most]:
        found = mean(any(hits(room)[:count]) for room in rooms)
        gap = mean(min(room["scores"][:count]) - min(room["scores"]) for room in rooms)
        cpu_ms = quantile((1e3 * sum(room["cpu_s"][:count]) for room in rooms), 0.5)
        text += table.row([str(count), f"{100 * found:.1f}", f"{gap:.4f}", f"{cpu_ms:.1f}"])
    return text


def show_restarts(records: Iterator[dict], _: bool) -> Iterator[str]:
    """How soon restarts find the best primary layout."""
    table, rooms = Table(["room", "best", "first hit", "hits %", "ms each"], 28, 9), []
    for room in records:
        if not rooms:
            yield ("best       least cost of the primary stage over all restarts; first hit: number of the first one "
                   "within 1 % of it\n"
                   "hits       share of the restarts within 1 % of it; ms each: CPU time of one restart, mean\n\n"
                   + table.header())
        rooms.append(room)
        yield table.row([room["name"], f"{min(room['scores']):.4f}", str(hits(room).index(True)),
                         f"{100 * mean(hits(room)):.1f}", f"{1e3 * mean(room['cpu_s']):.2f}"])
    if rooms:
        share = mean(mean(hits(room)) for room in rooms)
        yield f"\n{counted(len(rooms), 'room')}; {100 * share:.1f} % of single restarts reach the best\n\n"
        yield restarts_curve(rooms)


# ---- Pictures and scenes

def show_renders(records: Iterator[dict], each: bool) -> Iterator[str]:
    """Median, 95th percentile and the slowest room of every kind of picture."""
    rooms = []
    for room in records:
        rooms.append(room)
        if each:
            times = "".join(f"{1e3 * made['cpu_s']:>9.1f} ms" for made in room.values() if isinstance(made, dict))
            yield f"{room['room']:<34}{room['object_count']:>4} objects{times}\n"
    if not rooms:
        return
    yield f"{counted(len(rooms), 'room')}\n"
    yield f"{'CPU':<12}{'median ms':>14}{'p95 ms':>14}{'most ms':>14}{'KiB':>12}  slowest\n"
    for kind in [name for name, made in rooms[0].items() if isinstance(made, dict)]:
        cpu_ms = [1e3 * room[kind]["cpu_s"] for room in rooms]
        slowest = rooms[cpu_ms.index(max(cpu_ms))]["room"]
        times = "".join(f"{quantile(cpu_ms, share):>14.1f}" for share in (0.5, 0.95, 1))
        size_kib = quantile((room[kind]["bytes"] / 1024 for room in rooms), 0.5)
        yield f"{kind:<12}{times}{size_kib:>12.0f}  {slowest}\n"


SHOW = {"solve": show_solves, "resolve": show_edits, "restarts": show_restarts, "render": show_renders}
