"""Printed numbers against what is derived."""
import pytest

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
