"""What a visitor does on the page, and what it then shows."""


def shown(page):
    """The word of the verdict and what is refused, when the page has answered."""
    page.wait_for_selector("body[aria-busy=false]")
    return page.inner_text(".badge").split()[-1], page.inner_text("#error") + page.inner_text("#wrong")


def picked(page, number):
    """An example."""
    page.select_option("#example", str(number))
    return shown(page)


def typed(page, field, text):
    """A text in a field of the scene, or of a number."""
    page.fill(f"#{field}", text)
    return shown(page)


def latex(page, place):
    """The formulas shown there, as they are written."""
    return page.eval_on_selector_all(f"#{place} annotation", "all => all.map(one => one.textContent)")
