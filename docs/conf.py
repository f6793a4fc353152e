"""Configuration of the pages in this folder; `scripts/docs` builds them."""

import os
import shutil
import sys
from pathlib import Path

import libration
from docutils import nodes
from sphinx.addnodes import pending_xref

sys.path.append(str(Path(__file__).parent / "_extensions"))

project = "libration"
author = "the authors of libration"
release = libration.__version__

extensions = ["myst_nb", "sphinx.ext.autodoc", "numpydoc", "sphinx-mathjax-offline", "reference"]
myst_enable_extensions = ["colon_fence", "dollarmath"]
myst_heading_anchors = 3
nb_execution_mode = "force"
nb_execution_show_tb = True
nb_execution_timeout = 600
nb_merge_streams = True
nb_output_stderr = "warn"

# Records for developers, which are read in the repository.
exclude_patterns = ["decisions"]

default_role = "py:obj"
numpydoc_show_class_members = False
autodoc_member_order = "bysource"
autodoc_typehints = "none"
python_use_unqualified_type_names = True
maximum_signature_line_length = 88

html_theme = "furo"
html_title = f"libration {release}"
html_static_path = ["_static"]
html_css_files = ["pages.css"]
html_copy_source = False
html_show_copyright = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#0072B2", "color-brand-content": "#0072B2", "color-brand-visited": "#0072B2"},
}


# The page for browsers, which is copied to page/ of the documentation, and what stands there without it.
page = Path(os.environ.get("LIBRATION_PAGE", Path(__file__).parents[1] / "web" / "dist" / "libration.html"))
WITHOUT_PAGE = """<!doctype html><html lang="en"><meta charset="utf-8"><title>The page is missing</title><p>This documentation was built without the page.
In the sources, <code>web/build</code> makes <code>web/dist/libration.html</code>; <code>scripts/docs</code> then puts it here.</p></html>
"""


def put_page(app, exception):
    """Puts the page, or how to get it, into the built documentation."""
    place = Path(app.outdir) / "page" / "libration.html"
    if exception is not None or app.builder.name != "html":
        return
    place.parent.mkdir(exist_ok=True)
    if page.is_file():
        shutil.copyfile(page, place)
    else:
        place.write_text(WITHOUT_PAGE, encoding="utf-8")


def link_page(_app, doctree):
    """Makes links to the page, a file that is not in this folder, plain links."""
    for link in list(doctree.findall(pending_xref)):
        if "page/libration.html" in link["reftarget"]:
            link.replace_self(nodes.reference("", "", *link.children, refuri=link["reftarget"]))


def setup(app):
    """Has all pages made anew when a file of the package or of the examples has changed, since notebooks show what these answer."""
    examples = Path(__file__).parents[1] / "examples"
    files = [it for folder in (Path(libration.__file__).parent, examples) for it in folder.rglob("*") if it.is_file() and it.suffix != ".pyc"]
    app.connect("build-finished", put_page)
    app.connect("doctree-read", link_page)
    app.add_config_value("files_of_notebooks", sorted((str(it), it.stat().st_mtime_ns) for it in files), "env")
