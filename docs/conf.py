"""How the pages of this folder are made; `scripts/docs` builds them."""

import sys
from pathlib import Path

import libration

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


def setup(app):
    """Has all pages made anew when a file of the package or of the examples has changed, since notebooks show what these answer."""
    examples = Path(__file__).parents[1] / "examples"
    files = [it for folder in (Path(libration.__file__).parent, examples) for it in folder.rglob("*") if it.is_file() and it.suffix != ".pyc"]
    app.add_config_value("files_of_notebooks", sorted((str(it), it.stat().st_mtime_ns) for it in files), "env")
