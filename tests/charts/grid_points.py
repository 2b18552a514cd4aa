"""What a grid holds at its points."""


def points(grid):
    """The numbers at every point, by symbol."""
    symbols = list(grid.values)
    return [dict(zip(symbols, numbers)) for numbers in grid.numbers(symbols)] if symbols else [{}]
