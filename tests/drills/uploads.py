"""The drill of files that need far more memory or time than their size suggests."""

import asyncio
from contextlib import closing

from drills.bomb_effects import LONGEST_ANSWER, MOST_GROWTH, memory, send_bomb
from drills.bombs import BOMBS
from drills.results import Result, Watcher
from processes.served_demo import Demo


async def upload_bombs(runs, dice):
    """C26: files that are bombs, while somebody else uses the pages."""
    result = Result("uploads that are bombs (pictures, objects, drawings, recordings)", None)
    names = dice.sample(list(BOMBS), len(BOMBS))
    await asyncio.to_thread(_send_bombs, [names[run % len(names)] for run in range(runs)], result)
    return result


def _send_bombs(names, result):
    with closing(Watcher()) as watcher, Demo.running() as demo:
        before = memory(demo.process.pid, "VmRSS")
        slowest = growth = 0.0
        for name in names:
            effect = send_bomb(demo, BOMBS[name](), watcher, before)
            slowest, growth = max(slowest, *effect.answers), max(growth, effect.growth)
            if effect.status not in {413, 415, 422}:
                result.violations.append(f"{name}: answered with {effect.status}")
            if max(effect.answers) > LONGEST_ANSWER:
                result.violations.append(f"{name}: another answer took {1e3 * max(effect.answers):.0f} ms")
            if effect.growth >= MOST_GROWTH:
                result.violations.append(f"{name}: the web process grew by {effect.growth / 1e6:.0f} MB")
            result.add(None)
    result.remark = (
        f"{len(set(names))} kinds, all refused and none kept; other answers took at most {1e3 * slowest:.0f} ms "
        f"(limit {1e3 * LONGEST_ANSWER:.0f}), "
        f"the web process grew by {growth / 1e6:.0f} MB (limit {MOST_GROWTH / 1e6:.0f})"
    )
