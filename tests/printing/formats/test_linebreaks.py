"""Widths of formulas, and where they are broken."""
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gyrostat.printing.formats.linebreaks import broken, width

SUM = (r"\left(a + b\right) \left(\frac{c + d}{2 e} - \sqrt{f + g}\right)^{2} "
       r"+ h_{1} - 3 i + \left(j k + l\right) m - n")


@pytest.mark.parametrize(("tex", "points"), [
    (r"\frac{a + b}{c}", 26), (r"x^{2}", 9), (r"\sqrt{x}", 14), (r"\text{and}", 15),
    (r"\begin{pmatrix} a & b \\ c & d \end{pmatrix}", 37),
    (r"\left(a\right)", 14), (r"a \geq 0", 24)])
def test_width(tex, points):
    """Fractions are as wide as their wider part, matrices as the widest entries of their columns."""
    # an estimate: 2 points are a fifth of a letter's em
    assert abs(width(tex) - points) <= 2


def test_width_of_a_matrix_with_gaps():
    """The vertical gap between rows has no width."""
    plain = r"\begin{pmatrix} a & b \\ c & d \end{pmatrix}"
    assert width(plain.replace(r"\\", r"\\[3pt]")) == width(plain)


@given(st.integers(min_value=90, max_value=400))
def test_broken_lines_fit_and_lose_nothing(limit):
    """Every line fits, starts with a sign, and together they are the formula; no fraction or root is torn."""
    lines = broken(SUM, limit)
    assert all(width(line) <= limit for line in lines)
    assert all(line.lstrip()[0] in "+-" for line in lines[1:])
    opened = SUM.replace(r"\left(", r"\bigl(").replace(r"\right)", r"\bigr)") if len(lines) > 1 else SUM
    assert re.sub(r"\s+", "", "".join(lines)) == re.sub(r"\s+", "", opened)
    assert all(line.count("{") == line.count("}") for line in lines)


def test_what_fits_is_left_alone():
    """No parenthesis is opened where nothing is broken."""
    assert broken(SUM, 1000) == [SUM] and len(broken(SUM, 150)) > 1
