// What unfolds a part of the navigation has a name for readers of screens, which the theme leaves out.
for (const summary of document.querySelectorAll("details > summary:has(.toctree-toggle)"))
  summary.setAttribute("aria-label", `Pages below ${summary.closest("li").querySelector("a").textContent.trim()}`);
