"""The LaTeX table of what is confirmed: derived formulas, hypotheses, routes, in the letters of a paper."""
import re
import shutil
import subprocess

import pytest
from published.written_sources import written

from gyrostat.printing.formats.latex_names import Paper
from gyrostat.published import check
from gyrostat.published.latex import latex

SOURCE = r"""[source]
name = "mine"
title = "A paper of 100 % & more"

[scene.heavy]
inertia = ["I1", "I1", "I3"]
potential = "m0*k3"

[scene.any]
potential = "U(k1, k2, k3)"

[scene.top]
inertia = ["I1", "I1", "I3"]
potential = "m0*k3"
equilibrium = "E1"
spin = "omega3_0"

[scene.free]

[[formula]]
key = "rate"
where = "eq. (1)"
quantity = "dt(pi1)"
printed = "(I1 - I3)/(I1*I3)*pi2*pi3 + m0*k2"
kind = "identity"
scene = "heavy"

[[formula]]
key = "turned"
where = "eq. (2)"
quantity = "dt(vector_k)"
printed = ["k2*c - k3*pi2/I2", "k3*pi1/I1 - k1*c", "k1*pi2/I2 - k2*pi1/I1"]
let = { c = "pi3/I3" }
kind = "identity"
scene = "any"

[[formula]]
key = "bracket"
where = "eq. (3)"
quantity = "B"
printed = [["0", "-pi3", "pi2"], ["pi3", "0", "-pi1"], ["-pi2", "pi1", "0"]]
kind = "identity"
scene = "free"

[[formula]]
key = "wide"
where = "eq. (3)"
quantity = "transpose(B)"
printed = "-B"
kind = "identity"
scene = "any"

[[formula]]
key = "fast"
where = "eq. (4)"
quantity = "sufficient for stability"
printed = "(I3*omega3_0)**2 > 4*I1*m0"
given = "m0 > 0"
kind = "condition"
scene = "top"

[[formula]]
key = "digits"
where = "eq. (5)"
quantity = "q"
printed = "0.25"
at = { I1 = "1", I3 = "1", m0 = "1/2", omega3_0 = "1" }
kind = "number"
scene = "top"

[[formula]]
key = "slow"
where = "eq. (6)"
quantity = "sufficient for stability"
printed = "(I3*omega3_0)**2 > 2*I1*m0"
kind = "condition"
scene = "top"
"""


@pytest.fixture(name="findings")
def _findings(tmp_path):
    return check([written(tmp_path, SOURCE)])


def row(table, key):
    """What is derived, and the hypotheses, in the row of a statement."""
    (found,) = (line for line in table.splitlines() if rf"\textsf{{{key}}} & " in line)
    _, rest = found.split(" & ", 1)
    return rest.rsplit(" & ", 1)


def test_a_row_has_what_was_derived_under_which_hypotheses_and_how(findings):
    """In the symbols of the paper; a formula of the file is typeset, words stay words."""
    table = latex(findings, Paper({"I1": "A", "U": "V"}), full=True)
    derived, under = row(table, "rate")
    assert derived == r"$\tfrac{d}{dt} \pi_1 = \frac{\pi_2 \pi_3 (A - I_3)}{A I_3} + m_0 k_2$"
    assert r"\textbf{body} moments of inertia $A$, $A$, $I_3$, positive" in under
    assert r"\textbf{field} $V$ = $m_0 k_3$" in under
    assert r"\textbf{compared} derived from the bracket and the Hamiltonian; printed $-$ derived" in under
    derived, under = row(table, "turned")
    assert derived.startswith(r"$\tfrac{d}{dt} \mathbf{k} = (") and derived.count("$, $") == 2
    assert r"\textbf{with} $c$ = $\frac{\pi_3}{I_3}$" in under
    assert r"\textbf{field} $V$($k_1$, $k_2$, $k_3$), unspecified" in under
    derived, under = row(table, "fast")
    assert derived == r"sufficient for stability: $I_3^{2} (\omega_3^0)^{2} > 4 A m_0$"
    assert r"\textbf{given} $m_0 > 0$" in under
    derived, _ = row(table, "digits")
    assert derived == "$q = \\frac{1}{4}$"


def test_a_wide_matrix_is_listed_by_its_entries(findings):
    """One that fits the column is a matrix."""
    table = latex(findings, full=True)
    assert row(table, "bracket")[0].startswith(r"$B = \begin{pmatrix} 0 & - \pi_3 & \pi_2 \\")
    entries = row(table, "wide")[0].split(r" \newline ")
    assert entries[0] == "$B^{T}$ has the entries" and entries[-1] == "the others are 0"
    assert len(entries) == 18 + 2 and r"entry 1, 2: $\pi_3$" in entries


def test_only_confirmed_statements_are_in_the_table(findings):
    """The misprint is among the errata, which are the same without the table of what is confirmed."""
    whole, errata = latex(findings, full=True), latex(findings)
    wrong, right = whole.split(r"\caption{Confirmed statements}\label{gyrostat:confirmed}")
    keys = [re.findall(r"\\textsf\{(\w+)\}", part) for part in (wrong, right)]
    assert keys == [["slow"], ["rate", "turned", "bracket", "wide", "fast", "digits"]]
    tables = [re.findall(r"\\begin\{longtable\}.*?\\end\{longtable\}", text, re.DOTALL)
              for text in (whole, errata)]
    assert len(tables[0]) == 2 and tables[1] == tables[0][:1]


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")
@pytest.mark.parametrize("fragment", [False, True])
def test_it_compiles(findings, tmp_path, fragment):
    """Whole, and in a document that has the packages that the fragment names."""
    text = latex(findings, Paper({"I1": "A"}, fragment=fragment), full=True)
    if fragment:
        packages = re.findall(r"\w+", text.splitlines()[0].removeprefix("% needs ").replace(" and ", ", "))
        text = "\n".join([r"\documentclass{article}", *(rf"\usepackage{{{p}}}" for p in packages),
                          r"\begin{document}", text, r"\end{document}"])
    (tmp_path / "paper.tex").write_text(text, encoding="utf-8")
    said = subprocess.run(["pdflatex", "-halt-on-error", "-interaction=nonstopmode", "paper.tex"],
                          cwd=tmp_path, capture_output=True, text=True, check=False)
    assert said.returncode == 0, said.stdout[-2000:]
