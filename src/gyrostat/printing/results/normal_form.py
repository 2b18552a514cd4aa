"""Writes a normal form, and D4 along a family."""
from sympy import Mul, Pow, S

from ...algebra.rings.polynomials import lowest_terms
from ...algebra.rings.readable import readable
from ...notation import symbol
from ...stability.normal_forms.d4_along_family import Window
from ...stability.normal_forms.normal_form import NormalForm
from ..blocks import Block, Display, Word, sentence
from ..letters import letter, letters_in, word
from ..numbers import number
from .inequalities import polynomial_of

_DIGITS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_POWERS = ("", "", "²", "³")


def form_blocks(form: NormalForm) -> list[Block]:
    """Write h in the actions J1 and J2, with its coefficients, D4 and D6, and resonances."""
    highest = max(m + n for m, n, _ in form.coefficients)
    terms = [_term(_named("ω", "⟨omega⟩", "1"), 1, 0), _term(_named("ω", "⟨omega⟩", "2"), 0, 1),
             *(_term(_coefficient(m, n), m, n) for m, n, _ in form.coefficients)]
    energy = Word("h = h₀ + " + " + ".join(t.text for t in terms) + " + …",
                  "⟨h⟩ = ⟨h⟩_{0} + " + " + ".join(t.latex for t in terms) + r" + \dots")
    actions = Word("J₁, J₂ ≥ 0", r"J_{1}, J_{2} \geq 0")
    blocks: list[Block] = [sentence("On the orbit, in the actions ", actions, ", the energy is ", energy,
                                    ", with:")]
    blocks += [Display(_named("ω", "⟨omega⟩", str(n)), number(omega))
               for n, omega in enumerate(form.frequencies, 1)]
    blocks += [Display(_coefficient(m, n), number(c)) for m, n, c in form.coefficients]
    where = Word("J₁ = ω₂, J₂ = −ω₁", r"J_{1} = ⟨omega⟩_{2}, J_{2} = -⟨omega⟩_{1}")
    parts = "the part of degree 2 is" if highest == 2 else "the parts of degree 2 and 3 are"
    blocks.append(sentence("At ", where, f" {parts}:"))
    blocks += [Display(_named("D", "D", str(2 * n)), number(D)) for n, D in enumerate(form.twists, 2)]
    if form.resonances:
        pairs = " and ".join(f"{m} to {n}" for m, n in form.resonances)
        blocks.append(sentence(f"The frequencies are in the ratio {pairs}, which is a resonance."))
    return blocks


def window_blocks(window: Window) -> list[Block]:
    """Say when a gyroscopically stabilised equilibrium is stable: resonances, D4 and what has its sign."""
    letters = letters_in([window.p, window.q, window.D4])
    p, q, N, P = (symbol(letters.of(name)) for name in "pqNP")
    D4 = letter(letters, "D4")
    positive = word(letters, "⟨p⟩, ⟨q⟩, ⟨p⟩² − 4⟨q⟩ > 0", r"⟨p⟩, ⟨q⟩, ⟨p⟩^{2} - 4 ⟨q⟩ > 0")
    blocks: list[Block] = [
        sentence("The eigenvalues are the zeros of ", polynomial_of(letters), ", with:"),
        Display(p, readable(window.p), window.at), Display(q, readable(window.q), window.at),
        sentence("If ", positive, " and the second variation has both signs, the equilibrium is "
                 "gyroscopically stabilised. Then it is Lyapunov stable (Arnold 1961) if there is no "
                 "resonance 1:2 or 1:3, that is if")]
    blocks += [Display(readable(margin), S.Zero, window.at, "≠") for _, _, margin in window.resonances]
    if window.margin.is_number:
        said = "" if window.zeros else f", which is {'positive' if window.margin > 0 else 'negative'} there"
        return [*blocks, sentence("and if ", D4, f" ≠ 0{said}:"), Display(D4, readable(window.D4), window.at)]
    top, bottom = lowest_terms(window.D4 / window.margin).as_numer_denom()
    if top.could_extract_minus_sign():
        top, bottom = -top, -bottom
    return [*blocks, sentence("and if ", D4, " ≠ 0, which has the sign of ", N, " there:"),
            Display(D4, Mul(readable(top), N, Pow(P, -1)), window.at),
            Display(N, readable(window.margin), window.at), Display(P, readable(bottom), window.at)]


def _named(text: str, latex: str, index: str) -> Word:
    return Word(text + index.translate(_DIGITS), f"{latex}_{{{index}}}")


def _coefficient(m: int, n: int) -> Word:
    return _named("c", "c", f"{m}{n}")


def _term(factor: Word, m: int, n: int) -> Word:
    """Write factor J1^m J2^n."""
    text, latex = factor.text, factor.latex
    for index, power in (("1", m), ("2", n)):
        if power:
            action = _named("J", "J", index)
            text += f" {action.text}{_POWERS[power]}"
            latex += f" {action.latex}" + (f"^{{{power}}}" if power > 1 else "")
    return Word(text, latex)
