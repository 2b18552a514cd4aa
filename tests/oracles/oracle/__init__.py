"""Independent oracle: equilibria and their motions by other means. Imports nothing of gyrostat."""
from .equilibria import (
    axial_field,
    axial_integrals,
    axial_slope,
    characteristic,
    exact,
    field,
    free_field,
    growth,
    inclined,
    jacobian,
    orbit_basis,
    rank,
    reduced,
    verdict_inclined,
    verdict_inclined_margin,
    verdict_vertical,
    vertical,
)
from .polynomials import (
    count_roots,
    expand,
    level_slope,
    moves_away,
    polynomial,
    product,
    quotient,
    rate_slope,
    reduced_motion,
    slope,
    taylor,
    whole_motion,
)
from .series import (
    Series,
    constant,
    taylor_motion,
)

__all__ = ["Series", "axial_field", "axial_integrals", "axial_slope", "characteristic", "constant",
           "count_roots", "exact", "expand", "field", "free_field", "growth", "inclined", "jacobian",
           "level_slope", "moves_away", "orbit_basis", "polynomial", "product", "quotient", "rank",
           "rate_slope", "reduced", "reduced_motion", "slope", "taylor", "taylor_motion",
           "verdict_inclined", "verdict_inclined_margin", "verdict_vertical", "vertical", "whole_motion"]
