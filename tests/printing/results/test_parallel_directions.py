"""What a report says where two directions are parallel."""
import pytest

import gyrostat as gs

VEHICLE = gs.underwater_vehicle((2, 3, 4), (2, 3, 1), weight=(0, 0, gs.symbol("m0")))


@pytest.mark.parametrize("turning", [0, 1])
def test_it_says_of_which_motions_it_speaks(turning):
    """In text and in LaTeX; with a spin there are no sufficient conditions."""
    rising = gs.steady_motion(VEHICLE, (0, 0, 1), (0, 0, 1), omega=(0, 0, turning))
    report = gs.analyze(rising)
    for shown in (str(report), gs.to_latex(report)):
        said = " ".join(shown.split())
        assert "The two directions are parallel" in said and "are for all motions" in said
    assert ("no information" in str(report)) == bool(turning)
    assert "x = λ²" not in str(report) and "λ⁴ + p λ² + q" in str(report)
    assert "γ × ∂h/∂γ" in str(VEHICLE) and r"\gamma\times\partial h/\partial \gamma" in gs.to_latex(report)
    level = gs.analyze(gs.steady_motion(VEHICLE, (0, 1, 0), (0, 0, 1)))
    assert "are parallel" not in str(level) and "x = λ²" in str(level)
