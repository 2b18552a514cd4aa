"""Lists the works that a report cites, by the short form that stands in its sentences."""

REFERENCES = {
    "Lyapunov 1892": "A. M. Lyapunov, The General Problem of the Stability of Motion (1892)",
    "Marsden, Ratiu & Weinstein 1984": "J. E. Marsden, T. Ratiu & A. Weinstein, Semidirect products and "
                                       "reduction in mechanics, "
                                       "Trans. Amer. Math. Soc. 281 (1984) 147-177",
    "Holm, Marsden, Ratiu & Weinstein 1985": "D. D. Holm, J. E. Marsden, T. Ratiu & A. Weinstein, "
                                             "Nonlinear stability of fluid and plasma "
                                             "equilibria, Phys. Rep. 123 (1985) 1-116",
    "Bloch, Krishnaprasad, Marsden & Ratiu 1994": "A. M. Bloch, P. S. Krishnaprasad, J. E. Marsden & "
                                                  "T. S. Ratiu, Dissipation induced instabilities, "
                                                  "Ann. Inst. H. Poincaré Anal. Non Linéaire 11 (1994) 37-90",
    "Hughes 1986": "P. C. Hughes, Spacecraft Attitude Dynamics (1986)",
    "Ortega & Ratiu 1999": "J.-P. Ortega & T. S. Ratiu, Stability of Hamiltonian relative equilibria, "
                           "Nonlinearity 12 (1999) 693-720",
    "Simo, Lewis & Marsden 1991": "J. C. Simo, D. Lewis & J. E. Marsden, Stability of relative equilibria. "
                                  "Part I: The reduced energy-momentum method, "
                                  "Arch. Rational Mech. Anal. 115 (1991) 15-59",
    "Staude 1894": "O. Staude, Über permanente Rotationsaxen bei der Bewegung eines schweren Körpers um "
                   "einen festen Punkt, J. reine angew. Math. 113 (1894) 318-334",
    "Vera & Viguera 2003": "J. A. Vera & A. Viguera, Soluciones de equilibrio en un problema generalizado "
                           "del de Lagrange-Poisson, "
                           "Monografías de la Real Academia de Ciencias de Zaragoza 22 (2003) 141-150",
}


def cited(texts: list[str]) -> list[str]:
    """The full references whose short forms occur in the texts."""
    return [full for short, full in REFERENCES.items() if any(short in text for text in texts)]
