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


def attitudes_by_newton(moments, rotor, rate: float, starts: int = 2000) -> np.ndarray:
    """(n, r) of the equilibria of a satellite that Newton's method ends at, from many frames at once.

    t·Ir, t·(ω0 In + l) and r·(4 ω0 In + l) vanish; if the frame turns by a small θ, so that v becomes
    v + θ × v, a·Ib changes by θ·(a × Ib + b × Ia).
    """
    moments, rotor, rate = (np.array(x, float) for x in (moments, rotor, rate))
    drawn = np.random.default_rng(0).normal(size=(2, starts, 3))
    n, r = drawn / np.linalg.norm(drawn, axis=2, keepdims=True)
    for _ in range(40):
        r = r - np.sum(n * r, 1, keepdims=True) * n
        r /= np.linalg.norm(r, axis=1, keepdims=True)
        t = np.cross(n, r)
        vertical, tangent, normal = moments * r, moments * t, moments * n
        momentum, pull = rate * normal + rotor, 4 * rate * normal + rotor
        value = np.stack([np.sum(t * vertical, 1), np.sum(t * momentum, 1), np.sum(r * pull, 1)], 1)
        slopes = np.stack([np.cross(t, vertical) + np.cross(r, tangent),
                           np.cross(t, momentum) + rate * np.cross(n, tangent),
                           np.cross(r, pull) + 4 * rate * np.cross(n, vertical)], 1)
        step = _solved(slopes, value)
        n, r = n - np.cross(step, n), r - np.cross(step, r)
        n /= np.linalg.norm(n, axis=1, keepdims=True)
    return _distinct(np.concatenate([n, r], 1), np.abs(value).max(1))


def rotations_by_newton(moments, rotor, c, Q, level=None, rate=None, starts: int = 2000) -> np.ndarray:
    """(k, ω) of the rotations in U = c·k + k·Qk/2 that Newton's method ends at, from many k at once.

    c + Qk = ω l + ω² Ik + μ k and |k| = 1, where ω is the rate, or ω k·Ik + l·k = C1 is the level.
    """
    moments, rotor, c, Q = (np.array(x, float) for x in (moments, rotor, c, Q))
    rng, one = np.random.default_rng(0), np.ones((starts, 1))
    k = rng.normal(size=(starts, 3))
    k /= np.linalg.norm(k, axis=1, keepdims=True)
    w = rng.normal(size=(starts, 1)) if rate is None else rate * one
    mu = np.sum(k * (c + k @ Q - w * rotor - w * w * moments * k), 1, keepdims=True)
    for _ in range(40):
        Ik = moments * k
        force = c + k @ Q - w * rotor - w * w * Ik - mu * k
        slopes = np.zeros((starts, 5, 5))
        slopes[:, :3, :3] = Q - (w * w * moments + mu)[:, :, None] * np.eye(3)
        slopes[:, :3, 3], slopes[:, :3, 4] = -rotor - 2 * w * Ik, -k
        slopes[:, 3, :3] = 2 * k
        if rate is None:
            last = w * np.sum(k * Ik, 1, keepdims=True) + (k @ rotor)[:, None] - level
            slopes[:, 4, :3], slopes[:, 4, 3] = 2 * w * Ik + rotor, np.sum(k * Ik, 1)
        else:
            last = w - rate
            slopes[:, 4, 3] = 1
        value = np.concatenate([force, np.sum(k * k, 1, keepdims=True) - 1, last], 1)
        step = _solved(slopes, value)
        k, w, mu = k - step[:, :3], w - step[:, 3:4], mu - step[:, 4:]
    return _distinct(np.concatenate([k, w], 1), np.abs(value).max(1))


def _solved(slopes: np.ndarray, value: np.ndarray) -> np.ndarray:
    """Newton's steps, none longer than a half; a singular matrix is moved a little."""
    with np.errstate(all="ignore"):
        step = np.linalg.solve(slopes + 1e-14 * np.eye(slopes.shape[-1]), value[:, :, None])[:, :, 0]
    length = np.linalg.norm(step, axis=1, keepdims=True)
    return np.nan_to_num(step * np.minimum(1, 0.5 / (length + 1e-300)))


def _distinct(places: np.ndarray, residuals: np.ndarray) -> np.ndarray:
    """Those that were reached, each once."""
    return np.unique(places[residuals < 1e-10].round(6), axis=0)
