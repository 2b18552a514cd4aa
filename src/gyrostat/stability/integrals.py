"""What integrals that are given prove where the second variation with the Casimirs alone is indefinite."""
from collections.abc import Mapping

from sympy import Expr, ImmutableMatrix, Symbol

from ..algebra.definite import definite_combination
from ..algebra.exact import evaluate
from ..errors import EquilibriumError
from ..mechanics.equilibria import Equilibrium
from ..mechanics.orbit import critical_integrals, is_critical
from ..mechanics.system import at_numbers, names_of_scene
from .decision import Finding, settled
from .energy_casimir import pencil_of_integrals

LEVEL = "Lyapunov on its level of C1"


def decide_by_integrals(eq: Equilibrium, numbers: Mapping[Symbol, Expr]) -> Finding:
    """Whether the second variation of h + Σ α F is definite on the orbit for some α: then it is stable.

    F are the integrals given, critical there on the orbit. Where none is used, why is "" or says it.

    References
    ----------
    Arnold, Sov. Math. Dokl. 6 (1965) 331-334; Holm, Marsden, Ratiu & Weinstein, Phys. Rep. 123 (1985) 1-116.
    """
    if not eq.system.given_integrals:
        return settled(None, "")
    if missing := sorted(s.name for s in names_of_scene(eq.system) if evaluate(eq.insert(s), numbers).free_symbols):
        return settled(None, f"give {', '.join(missing)} to decide by the integrals")
    here = _at(eq, numbers)
    if here is None or critical_integrals(here)[1]:        # a flow is divided out: what is linear in π decides
        return settled(None, "")
    names = {F: f"F{n}" for n, F in enumerate(here.system.integrals, 1)}
    level, idle, used = here.system.integrals_at(here.point), [], []
    for F in here.system.integrals:
        if F not in level:
            idle.append(f"{names[F]} is conserved where M·k = 0 only")
        elif not is_critical(here, F):
            idle.append(f"{names[F]} is not critical there on the orbit")
        else:
            used.append(F)
    if not used:
        return settled(None, ", ".join(idle))
    variation = pencil_of_integrals(here, tuple(used))
    zero = dict.fromkeys(variation.free, 0)
    form = variation.matrix.xreplace(zero)
    others = [ImmutableMatrix(variation.matrix.diff(nu)) for nu in variation.free]
    found = definite_combination(form, others)
    if found is None:
        what = "no h + α F is" if len(used) == 1 else "no h + Σ α F was found that is"
        return settled(None, "; ".join([*idle, f"{what} definite, F = {', '.join(names[F] for F in used)}"]))
    taken = [(F, a) for F, a in zip(used, found) if a]
    sum_ = "".join(f" {'+' if a > 0 else '−'} {abs(a)} {names[F]}" for F, a in taken)
    notion = LEVEL if any(F in here.system.level_only for F, _ in taken) else "Lyapunov"
    return settled(True, f"the second variation of h{sum_} is definite on the orbit, "
                   + ", ".join(f"{names[F]} = {F}" for F, _ in taken), notion, True)


def _at(eq: Equilibrium, numbers: Mapping[Symbol, Expr]) -> Equilibrium | None:
    """The equilibrium at numbers; None where it is not proved to be one."""
    known = {s: evaluate(eq.insert(s), numbers) for s in names_of_scene(eq.system)}
    try:
        return Equilibrium(eq.label, at_numbers(eq.system, known),
                           tuple(evaluate(eq.insert(x), numbers) for x in eq.point))
    except EquilibriumError:
        return None
