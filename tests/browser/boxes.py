"""What of a page of the site is wider than the place that it has: code and outputs, formulas, tables."""
WIDE = """() => {
  const inside = (one) => one.closest('article').getBoundingClientRect().right;
  const kinds = {
    code: ['article pre', (one) => one.scrollWidth - one.clientWidth],
    formula: ['article mjx-container', (one) => one.hasAttribute('display')
      ? one.scrollWidth - one.clientWidth : one.getBoundingClientRect().right - inside(one)],
    table: ['article table', (one) => one.getBoundingClientRect().right - inside(one)],
  };
  const found = [];
  for (const [kind, [selector, excess]] of Object.entries(kinds))
    for (const one of document.querySelectorAll(selector))
      if (one.checkVisibility())
        found.push([kind, excess(one) > 1, one.textContent]);   // 1 pixel: a fraction of one is rounded
  const page = document.scrollingElement;
  found.push(['page', page.scrollWidth > page.clientWidth, document.title]);
  return found;
}"""


def opened(tab, address, width, height=900):
    """A page of the site in a tab, with its formulas typeset."""
    tab.set_viewport_size({"width": width, "height": height})
    tab.goto(address)
    tab.evaluate("async () => { if (window.MathJax) await MathJax.startup.promise; }")


def measured(tab):
    """(kind, whether it is too wide, its text) of each box of the page in a tab, and of the page itself."""
    return [tuple(each) for each in tab.evaluate(WIDE)]
