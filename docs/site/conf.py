"""Settings of Sphinx. `docs/site/build` copies this folder, runs pages.py to add the other pages, and then runs Sphinx."""

import importlib.metadata

from sphinx.util.nodes import make_refnode

project = "stickslip"
author = copyright = "the stickslip developers"
version = release = importlib.metadata.version("stickslip")
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx.ext.mathjax", "sphinx_copybutton"]
myst_enable_extensions = ["dollarmath"]
exclude_patterns = ["introduction.md", "static"]  # the first page includes introduction.md
myst_heading_anchors = 3
html_theme = "furo"
html_title = f"stickslip {version}"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_show_sphinx = False
# KaTeX renders formulas as MathML. The site contains KaTeX, so no page needs the network.
mathjax_path = "katex/katex.min.js"
html_js_files = ["formulas.js"]
pygments_style, pygments_dark_style = "friendly", "monokai"
autodoc_member_order = "groupwise"
autodoc_default_options = {"members": True, "imported-members": True}
napoleon_google_docstring = False
napoleon_use_rtype = napoleon_use_param = False  # types are plain text, not references
nitpicky = True
nitpick_ignore_regex = [("py:class", r"Axes|ArrayLike|(collections|numpy|os|pandas|xarray)\..*"), ("py:func", r"numpy\..*")]  # of other packages


def found_by_its_end(app, env, node, contnode):
    """Resolves names as a user imports them, even if the page of a different module documents them."""
    if node.get("refdomain") != "py":
        return None
    domain = env.domains["py"]
    found = domain.find_obj(env, node.get("py:module"), node.get("py:class"), node["reftarget"], None, 1)
    if len({entry.docname for _, entry in found}) != 1:
        return None
    name, entry = found[0]
    return make_refnode(app.builder, node["refdoc"], entry.docname, entry.node_id, contnode, name)


def as_meant(app, what, name, thing, options, lines):
    """Adapts docstrings written for reading without Sphinx. A magnitude such as |F| is not a substitution, and the text before
    a colon in the first line of an attribute is not its type."""
    lines[:] = [line if "``" in line else line.replace("|", r"\|") for line in lines]
    if what in {"attribute", "property"}:
        lines[:0] = ["..", ""]


def setup(app):
    app.connect("autodoc-process-docstring", as_meant, priority=400)  # before napoleon
    app.connect("missing-reference", found_by_its_end)
