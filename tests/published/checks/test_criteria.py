"""Conditions that are no inequality of a report, against what is derived."""
import pytest

from gyrostat.published import check

LOW, HIGH, APART = "2*E*I1 < L2", "L2 < 2*E*I3", "(L2 - 2*E*I2)**2 > 0"


@pytest.mark.parametrize("printed", [
    (LOW, HIGH, APART), (LOW, HIGH), (LOW, APART), (HIGH, APART), (LOW, "L2 > 2*E*I3", APART),
    ("2*E*I1 > L2", HIGH, APART)], ids=lambda parts: " and ".join(parts))
def test_a_free_rigid_body_moves_periodically(tmp_path, printed):
    """Between the limits of L² on an energy surface, and not on the separatrix."""
    path = tmp_path / "mine.toml"
    path.write_text('[source]\nname = "mine"\ntitle = "t"\n[scene.s]\nparameters = ["E", "L2"]\n'
                    'given = "I1 < I2 < I3"\n[[formula]]\nkey = "a"\nwhere = "(1)"\n'
                    f'quantity = "sufficient for periodic motion"\nprinted = "{" and ".join(printed)}"\n'
                    'given = "E > 0 and I1 < I2 < I3"\nkind = "condition"\nscene = "s"\n', encoding="utf-8")
    (found,) = check([path])
    assert (found.status == "confirmed") == (printed == (LOW, HIGH, APART))
