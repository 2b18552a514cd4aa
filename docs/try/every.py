"""Every equilibrium at numbers, and what decides between the two conditions of one."""
from collections.abc import Mapping, Sequence
from typing import Any

import gyrostat as gs
from gyrostat.cli.answers.between_criteria import between, between_blocks
from gyrostat.errors import GyrostatError
from gyrostat.mechanics.scenes.system import System
from gyrostat.printing.blocks import Block, prose
from gyrostat.printing.results.beyond_reports import result_blocks
from gyrostat.printing.results.decision import damped_block, reason_block
from gyrostat.printing.results.normal_form import form_blocks
from gyrostat.stability.report.report import Report


def listed(scene: System, values: Mapping[str, Any]) -> list[tuple[str, list[Block]]]:
    """The verdict of each equilibrium; where it is, the reason, and what internal damping makes of it."""
    return [(found.decision.verdict.name, [*result_blocks(found), reason_block(found.decision),
                                           damped_block(found.decision, found.damped)])
            for found in gs.relative_equilibria(scene, values)]


def open_between(report: Report, values: Mapping[str, str]) -> Sequence[Block]:
    """Where gyroscopic forces may hold an equilibrium: the normal form at numbers, D4 along its family."""
    found = between(report)
    if found is None:
        return []
    try:
        form = form_blocks(report.normal_form(values))
    except GyrostatError as error:
        form = [prose(f"No normal form at these numbers: {error}.")]
    return [*form, *between_blocks(found)]
