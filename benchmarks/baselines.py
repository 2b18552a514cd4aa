"""What the speeds of the library are compared with: kernels and programs written by hand, without it.

Each is the same kind of work as what it is compared with, so that their ratio is about the same on another
machine: arrays in compiled loops, small rational numbers in Python, matrices in flint, pictures, a start of
Python.
"""
import io
import random
import subprocess
import sys
from collections.abc import Callable
from fractions import Fraction
from functools import cache, partial

import numba
import numpy as np
from flint import fmpq, fmpq_mat
from matplotlib.figure import Figure
from scipy.special import ellipj

EVERY = 4000                                               # matrices of a call of eigvals


@numba.njit(error_model="numpy")
def margins(spins, rotors, I1, m0, out):
    """The sign of (π3 + l)² − 4 I1 m0 on a grid."""
    for i in range(spins.size):
        for j in range(rotors.size):
            P = spins[i] + rotors[j]
            out[i, j] = (P * P - 4.0 * I1 * m0 > 0) * 2 - 1


@cache
def margin_grid(n: int) -> Callable[[], object]:
    """The margin of E1 on an n × n grid."""
    axis = np.linspace(-4, 4, n)
    return partial(margins, axis, axis, 1.0, 1.0, np.empty((n, n), np.int8))


@cache
def eigenvalues() -> Callable[[], object]:
    """NumPy's eigenvalues of 4 × 4 matrices."""
    return partial(np.linalg.eigvals, np.random.default_rng(1).normal(size=(EVERY, 4, 4)))


def upright(values: dict[str, Fraction]) -> str:
    """The verdict on E1 at given numbers off its boundary, by its inequality."""
    I1, dU, l, pi3 = (fmpq(x.numerator, x.denominator)
                      for x in map(values.__getitem__, ("I1", "dU", "l", "pi3_0")))
    if I1 <= 0:
        raise ValueError(f"I1 = {I1} is not positive")
    margin = (pi3 + l) ** 2 - 4 * I1 * dU
    return "STABLE" if margin > 0 else "UNSTABLE" if margin < 0 else "UNDECIDED"


@cache
def characteristic_polynomials(size: int = 6, count: int = 10) -> Callable[[], object]:
    """Characteristic polynomials of rational matrices and their roots in balls, by flint."""
    draw = random.Random(4)
    matrices = [fmpq_mat(size, size, [fmpq(draw.randint(-99, 99), draw.randint(1, 99))
                                      for _ in range(size * size)]) for _ in range(count)]

    def roots() -> None:
        for matrix in matrices:
            matrix.charpoly().numer().complex_roots()
    return roots


def image(codes: np.ndarray) -> bytes:
    """A plain picture of an array, as PNG."""
    figure, file = Figure(), io.BytesIO()
    figure.subplots().imshow(codes, origin="lower", aspect="auto", interpolation="nearest")
    figure.savefig(file, format="png", dpi=150)
    return file.getvalue()


def start_with_sympy() -> None:
    """A new Python that imports SymPy."""
    subprocess.run([sys.executable, "-c", "import sympy"], check=True)


@cache
def elliptic_functions(count: int) -> Callable[[], object]:
    """SciPy's elliptic functions at many times."""
    return partial(ellipj, np.linspace(0, 400, count), 0.6)
