"""Tables for a terminal."""
from gyrostat.printing.formats.text_tables import Column, table_text

COLUMNS = [Column("#", ["1", "2"], number=True), Column("name", ["E1", "precession"]),
           Column("k₃", ["−5/12", "1"], number=True), Column("ω", ["2", "0.3333"], "rad/s", True),
           Column("verdict", ["stable mod π₃", "unstable"])]


def test_numbers_stand_on_the_right_and_words_on_the_left():
    """Each cell within the columns of its title."""
    title, unit, one, two = table_text(COLUMNS, ["", ""], 80).splitlines()
    right = title.index("ω") + 1
    assert title.index("verdict") == one.index("stable mod") == two.index("unstable")
    assert unit[:right].endswith("rad/s") and one[:right].endswith(" 2") and two[:right].endswith("0.3333")


def test_what_does_not_fit_goes_to_a_second_line_of_each_row():
    """Nothing is lost and nothing is wider; below its number the second line is indented."""
    lines = table_text(COLUMNS, ["", ""], 30).splitlines()
    assert max(map(len, lines)) <= 30 and len(lines) == 8
    whole = " ".join(lines)
    assert all(cell in whole for column in COLUMNS for cell in (column.title, *column.cells))
    assert lines[4].startswith("1  E1") and lines[5].startswith("   ") and "stable mod π₃" in lines[5]


def test_a_note_stands_below_its_row():
    """It is wrapped, and indented as the second line of a row is."""
    note = "every tilt from the lowest one to the highest one there is"
    lines = table_text(COLUMNS, ["", note], 50).splitlines()
    assert lines[-2:] == ["   every tilt from the lowest one to the highest", "   one there is"]
    assert lines[-3].startswith("2  precession")
