"""The page for browsers: the moving pendulum with instruments, and every other room."""

from __future__ import annotations

import pathlib
import tempfile
import webbrowser

from ._ask import Asked, Path, answered

__all__ = ["page"]


def page(output: Path | None = None) -> pathlib.Path:
    """Opens the page for browsers, one file that needs no network, or writes it to a file.

    Parameters
    ----------
    output : str or path, optional
        The file to write, which is not opened. Without it, a file in a temporary folder is
        written and opened in the browser.

    Returns
    -------
    pathlib.Path
        The file.

    Raises
    ------
    NoAnswer
        The package was built without the page. In the sources, ``web/build`` makes it, and
        ``LIBRATION_PAGE=web/dist/libration.html pip install .`` puts it into the package.

    Examples
    --------
    >>> import libration as lb
    >>> lb.page("lesson.html")  # doctest: +SKIP
    PosixPath('lesson.html')
    """
    content, _ = answered(Asked(("page", "--output=-"), None), [])
    folder = tempfile.mkdtemp(prefix="libration-") if output is None else ""
    file = pathlib.Path(folder, "libration.html" if output is None else output)
    file.write_bytes(content.encode())
    if output is None:
        webbrowser.open(file.as_uri())
    return file
