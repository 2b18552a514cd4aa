"""Says why a tilted equilibrium is stable modulo a flow, and not as a point."""
from ...algebra.rings.readable import readable
from ...stability.report.report import Report
from ...stability.theorems.drift import Drift
from ..blocks import Block, Display, Word, sentence
from ..letters import letter, letters_of, word


def drift_blocks(report: Report) -> list[Block]:
    """Say why a tilted equilibrium is not Lyapunov stable as a point."""
    drift, blocks = report.drift, list[Block]()
    eq = drift.equilibrium
    letters = letters_of(eq.system)
    if report.recognised:
        axis = "and that axis is the third here."
        blocks.append(sentence(f"The scene is {report.recognised.sentence}, {axis}"))
    *rates, defect = drift_displays(drift)
    spin = word(letters, "ω ⟨vector_k⟩ + σ ⟨e3⟩", "⟨omega⟩ ⟨vector_k⟩ + ⟨sigma⟩ ⟨e3⟩")
    blocks += [sentence("The point itself is not Lyapunov stable: near it there are relative equilibria ",
                        spin, " that turn about the axis of the body and leave the point, at a rate ",
                        Word("σ", "⟨sigma⟩"),
                        " with" if drift.omega else " that is free."),
               *rates,
               sentence("If ", letter(letters, "p"), " and ", letter(letters, "D"), " are not 0, the "
                        "linearised flow grows too, because the eigenvalue 0 has a Jordan block:"),
               defect]
    if drift.omega:
        (I1, _, I3), l = eq.system.body.moments, eq.system.body.gyrostatic_momentum[2]
        rate = Word("ω ≠ 0", r"⟨omega⟩ \neq 0")
        blocks.append(sentence("The only exception is ", I1, " = ", I3, ", ", l, " = 0, ", rate,
                               " and a constant ", letter(letters, "U"), "."))
    return blocks


def drift_displays(drift: Drift) -> list[Block]:
    """Write D and the rates of the relative equilibria nearby, unless every rate occurs."""
    at, letters = drift.equilibrium.at, letters_of(drift.equilibrium.system)
    names = (Word("∂σ/∂k₃", r"\partial⟨sigma⟩/\partial ⟨k3⟩"),
             Word("∂σ/∂ω", r"\partial⟨sigma⟩/\partial ⟨omega⟩"))
    blocks: list[Block] = []
    if drift.omega:
        blocks += [Display(name, readable(rate), at, label="drift") for name, rate in zip(names, drift.rates)]
    return [*blocks, Display(letter(letters, "D"), readable(drift.defect), at, label="jordan")]
