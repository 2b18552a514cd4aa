"""Finds the permanent rotations of a free body or gyrostat: every equilibrium on a momentum sphere."""
from collections.abc import Iterator, Mapping
from typing import Any

from sympy import Add, Expr, ImmutableMatrix, Matrix, S, eye, sqrt

from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.precision import own_precision
from ...algebra.pencils.exact_points import points_on_sphere
from ...algebra.reals.exact import proved_sign
from ...algebra.solving.roots import real_roots
from ...mechanics.scenes.system import System, at_numbers
from ...notation import symbol
from ...stability.criteria.amended_form import dot
from ...stability.form import PRECISION
from .free_form import FreeForm
from .rate_level_tilt import LENGTH, numbers_of_rotations, without_pi

NU = symbol("nu")


def free_forms(scene: System, values: Mapping[str, Any]) -> list[FreeForm]:
    """Return every permanent rotation of a scene without a field, at numbers for its names and M."""
    numbers = numbers_of_rotations(scene, values)
    return rotations_on_sphere(at_numbers(scene, numbers), numbers[LENGTH])


def rotations_on_sphere(scene: System, radius: Expr) -> list[FreeForm]:
    """Return every equilibrium of a free gyrostat on abs(M) = radius, at numbers; complete, by energy.

    M (1 − ν I) = l: ν is a root of the secular equation Σ l²/(1 − ν I)² = abs(M)², or 1/I of axes without a
    rotor. If Δ > 0, the energy is an extremum, hence the rotation stable; if Δ < 0, a saddle, hence it is
    not. If Δ = 0, the energy is an extremum where Mᵢ = 0 = dᵢ and dⱼ dₖ > 0 for some i (three rotations
    meet), or about the axis of a body of revolution that carries l; else it is not.

    Parameters
    ----------
    scene : System
        at given numbers
    radius : Expr
        not negative

    References
    ----------
    Hughes, Spacecraft Attitude Dynamics (1986), chapter 6; docs/explanation/derivations/conditions.md,
    section 8; where rotations meet, docs/explanation/derivations/boundaries.md, section 6.

    Examples
    --------
    >>> import gyrostat as gs
    >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)))
    >>> for form in rotations_on_sphere(scene, S.One)[::2]:
    ...     print(form.M, form.signs, form.frequencies)
    (0, 0, -1) (1, 1) (1/3,)
    (0, -1, 0) (1, -1) ()
    (-1, 0, 0) (-1, 1) (sqrt(3)/3,)
    """
    if proved_sign(radius) == 0:
        return [FreeForm(scene, (S.Zero,) * 3, None)]
    body = scene.body
    if isinstance(body.inertia, ImmutableMatrix):
        inside, size, unit = without_pi(Matrix(body.gyrostatic_momentum), radius)
        found = [FreeForm(scene, tuple(unit * x for x in M), nu, axis)
                 for (nu, *M), axis in points_on_sphere(eye(3) - NU * body.tensor, inside, size, NU)]
    else:
        found = list(_about_axes(scene, radius))
    return sorted(found, key=energy_and_momentum)


def _about_axes(scene: System, radius: Expr) -> Iterator[FreeForm]:
    """Yield the rotations of a body in principal axes."""
    inertia, rotor = scene.body.moments, scene.body.gyrostatic_momentum
    inside, size, _ = without_pi(Matrix(rotor), radius)
    secular = Add(*(l**2 / (1 - NU * moment) ** 2 for l, moment in zip(inside, inertia))) - size**2
    for nu in real_roots(secular, NU) or ():
        M = [l / (1 - nu * moment) if l else S.Zero for l, moment in zip(rotor, inertia)]
        yield FreeForm(scene, tuple(M), nu)
    for moment in dict.fromkeys(inertia):
        axes = [n for n in range(3) if inertia[n] == moment]
        if any(rotor[n] for n in axes):
            continue
        M = [S.Zero if n in axes else rotor[n] / (1 - inertia[n] / moment) for n in range(3)]
        rest = radius**2 - Add(*(m**2 for m in M))
        if proved_sign(rest) != 1:
            continue
        about = tuple(S.Zero if n in axes else S.One for n in range(3)) if len(axes) > 1 else None
        for side in (1, -1) if about is None else (1,):
            M[axes[0]] = side * sqrt(rest)
            yield FreeForm(scene, tuple(M), 1 / moment, about)


def energy_and_momentum(form: FreeForm) -> list[float]:
    """Return the energy and M in doubles, from enclosures; rotations are sorted by them."""
    with own_precision(PRECISION):
        inverse, M, _ = form.enclosed
        pi = [m - ball(l, PRECISION) for m, l in zip(M, form.scene.body.gyrostatic_momentum)]
        energy = dot(pi, [dot(row, pi) for row in inverse]) / 2
    return [float(x.mid()) for x in (energy, *M)]
