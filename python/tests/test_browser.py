"""The page for browsers is opened or written, and its absence is explained."""

import webbrowser

import pytest

import libration as lb
from libration import browser, errors


def test_a_page_is_opened_or_written(monkeypatch, tmp_path):
    monkeypatch.setattr(browser, "answered", lambda asked, form: ("<!doctype html>\n θ₀", None))
    opened = []
    monkeypatch.setattr(webbrowser, "open", opened.append)
    written = lb.page(tmp_path / "lesson.html")
    assert written.read_bytes().decode() == "<!doctype html>\n θ₀"
    assert opened == []
    shown = lb.page()
    assert shown.read_bytes() == written.read_bytes()
    assert opened == [shown.as_uri()]


def test_the_page_is_that_of_the_build(tmp_path):
    file = tmp_path / "page.html"
    try:
        lb.page(file)
    except errors.NoAnswer as error:
        assert "web/build" in str(error)
        assert not file.exists()
    else:
        assert file.read_bytes().startswith(b"<!doctype html>")


def test_a_folder_is_refused(monkeypatch, tmp_path):
    monkeypatch.setattr(browser, "answered", lambda asked, form: ("<!doctype html>", None))
    with pytest.raises(OSError):
        lb.page(tmp_path)
