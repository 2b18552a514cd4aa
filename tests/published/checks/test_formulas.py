"""Printed numbers against what is derived."""
import pytest
from published.written_sources import status as status_of

from gyrostat.published import check


@pytest.mark.parametrize(("quantity", "printed", "status"), [
    ("1/3", "0.333", "confirmed"), ("1/3", "0.334", "misprint"), ("2/3", "0.66", "misprint"),
    ("5/2", "2", "confirmed"), ("5/2", "3", "confirmed"), ("5/2", "4", "misprint")])
def test_a_number_rounds_to_the_printed_digits(tmp_path, quantity, printed, status):
    """Halfway between two of them either is right."""
    path = tmp_path / "mine.toml"
    path.write_text('[source]\nname = "mine"\ntitle = "t"\n[scene.s]\n[[formula]]\nkey = "a"\nwhere = "(1)"\n'
                    f'quantity = "{quantity}"\nprinted = "{printed}"\nkind = "number"\nscene = "s"\n',
                    encoding="utf-8")
    (found,) = check([path])
    assert found.status == status


@pytest.mark.parametrize(("quantity", "status"), [
    ("dt(pi1)", "misprint"), ("bracket(pi1, h)", "misprint"), ("dt(pi1) - entry(field, 1, 1)", "confirmed")])
def test_a_coordinate_gets_its_value_after_a_derivative(tmp_path, quantity, status):
    """The rate of pi1 where pi1 is 0 is not 0."""
    scene = 'potential = "c1*k1 + c3*k3"'
    assert status_of(tmp_path, scene, quantity, "0", "identity", at='{ pi1 = "0" }') == status
