# SPDX-License-Identifier: GPL-3.0-or-later
"""What became of each wish, and tables of it."""

from collections import Counter
from dataclasses import dataclass

import checks
from plan import Plan
from wishes import Brief, remark_on

OBEYED, REPORTED, SILENT, FAILED = "obeyed", "reported", "silent", "failed"
OUTCOMES = (OBEYED, REPORTED, SILENT, FAILED)


@dataclass(frozen=True)
class Verdict:
    """`outcome`: the plan meets the wish; a remark names it; it was lost without a word; there is no plan."""

    brief: Brief
    wish: checks.Wish
    outcome: str
    remark: str = ""


def judge(brief: Brief, plan: Plan | None) -> list[Verdict]:
    """One for each wish; no plan: the design failed."""
    if plan is None:
        return [Verdict(brief, wish, FAILED) for wish in brief.wishes]
    return [_judge_wish(brief, wish, plan) for wish in brief.wishes]


def _judge_wish(brief: Brief, wish: checks.Wish, plan: Plan) -> Verdict:
    if checks.holds(plan, wish):
        return Verdict(brief, wish, OBEYED)
    remark = remark_on(plan, wish)
    return Verdict(brief, wish, REPORTED if remark else SILENT, remark)


def totals(verdicts: list[Verdict]) -> Counter[str]:
    return Counter(verdict.outcome for verdict in verdicts)


def table(verdicts: list[Verdict]) -> str:
    """A row for each check that was asked for, and the sum with the share that was obeyed."""
    rows = []
    for check in checks.CHECKS:
        counts = totals([verdict for verdict in verdicts if verdict.wish["check"] == check])
        if counts:
            rows.append((check, counts))
    rows.append(("all", totals(verdicts)))
    lines = [f"{'wish':<18}{'asked':>7}" + "".join(f"{outcome:>10}" for outcome in OUTCOMES)]
    for name, counts in rows:
        lines.append(f"{name:<18}{counts.total():>7}" + "".join(f"{counts[outcome]:>10}" for outcome in OUTCOMES))
    share = 100 * totals(verdicts)[OBEYED] / len(verdicts)
    return "\n".join(lines) + f"\n{share:.0f} % obeyed"


def misses(verdicts: list[Verdict], outcome: str) -> str:
    """The wishes of that outcome, a line each, with the brief below the first of its own."""
    lines, told = [], set()
    for verdict in verdicts:
        if verdict.outcome != outcome:
            continue
        if verdict.brief.id not in told:
            told.add(verdict.brief.id)
            lines.append(f"  {verdict.brief.id}: {verdict.brief.text}")
        lines.append(f"      {verdict.wish['wish']} ({verdict.wish['check']})"
                     + (f": {verdict.remark}" if verdict.remark else ""))
    return "\n".join(lines)
