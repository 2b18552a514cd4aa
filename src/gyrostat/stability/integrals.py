"""What integrals that are given prove where the second variation with the Casimirs alone is indefinite."""
from collections.abc import Mapping

from sympy import Expr, ImmutableMatrix, S, Symbol

from ..algebra.definite import definite_combination
from ..algebra.exact import evaluate
from ..errors import EquilibriumError
from ..mechanics.equilibria import Equilibrium
from ..mechanics.orbit import critical_integrals, is_critical, orbit_tangent
from ..mechanics.system import at_numbers, names_of_scene
from .decision import Finding, settled
from .energy_casimir import restricted

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
    known = {s: evaluate(eq.insert(s), numbers) for s in names_of_scene(eq.system)}
    if missing := sorted(s.name for s, value in known.items() if value.free_symbols):
        return settled(None, f"give {', '.join(missing)} to decide by the integrals")
    here = _at(eq, known, numbers)
    if here is None or critical_integrals(here)[1]:        # else a flow is to be divided out
        return settled(None, "")
    names = {F: f"F{n}" for n, F in enumerate(here.system.integrals, 1)}
    on_level, idle, used = here.system.integrals_at(here.point), list[str](), list[Expr]()
    for F in here.system.integrals:
        if F not in on_level:
            idle.append(f"{names[F]} is conserved where M·k = 0 only")
        elif not is_critical(here, F):
            idle.append(f"{names[F]} is not critical there on the orbit")
        else:
            used.append(F)
    if not used:
        return settled(None, ", ".join(idle))
    variation = restricted(here, (orbit_tangent(here), ()), (*used, *here.system.space.casimirs))
    others = [ImmutableMatrix(variation.matrix.diff(nu)) for nu in variation.free]
    found = definite_combination(variation.matrix.xreplace(dict.fromkeys(variation.free, S.Zero)), others)
    if found is None:
        tried = "".join(f" + α {names[F]}" for F in used)
        return settled(None, "; ".join([*idle, f"no h{tried} was found that is definite"]))
    taken = [(F, a) for F, a in zip(used, found) if a]
    terms = "".join(f" {'+' if a > 0 else '−'} {f'{abs(a)} ' if abs(a) != 1 else ''}{names[F]}"
                    for F, a in taken)
    notion = LEVEL if any(F in here.system.level_only for F, _ in taken) else "Lyapunov"
    return settled(True, f"the second variation of h{terms} is definite on the orbit, "
                   + ", ".join(f"{names[F]} = {F}" for F, _ in taken), notion, True)


def _at(eq: Equilibrium, known: Mapping[Symbol, Expr], numbers: Mapping[Symbol, Expr]) -> Equilibrium | None:
    """The equilibrium at numbers; None where it is not proved to be one."""
    try:
        return Equilibrium(eq.label, at_numbers(eq.system, known),
                           tuple(evaluate(eq.insert(x), numbers) for x in eq.point))
    except EquilibriumError:
        return None
