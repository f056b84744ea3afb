"""Do the type stubs and the API page agree with the module?"""

import os
import subprocess
import sys
from pathlib import Path

import pages
import pytest

HERE = Path(__file__).parent


def is_fresh(path, text):
    """Compares the file with what it should hold, or writes it."""
    if os.environ.get("UPDATE_PYTHON_DOCS"):
        path.write_text(text)
    assert path.read_text() == text, f"run make python-update, for {path.name} is old"


@pytest.mark.parametrize("module", pages.STUBS, ids=lambda module: module.__name__)
def test_stubs_have_the_docstrings(module):
    path = pages.STUBS[module]
    is_fresh(path, pages.with_docstrings(module, path.read_text()))


def test_the_page_has_the_docstrings():
    is_fresh(pages.PAGE, pages.page())


def test_the_page_has_every_member():
    page = pages.PAGE.read_text()
    for module in pages.STUBS:
        for name in module.__all__:
            item = getattr(module, name)
            assert f"\n### {name}\n" in page, name
            # The fields of a named tuple are in its signature, and the members of a set in a list.
            shown = {*getattr(item, "_fields", ()), *getattr(item, "__members__", ())}
            for member in vars(item) if isinstance(item, type) else ():
                assert member.startswith("_") or member in shown or f"\n#### {name}.{member}\n" in page, f"{name}.{member}"


def test_stubs_agree_with_the_module():
    subprocess.run([sys.executable, "-m", "mypy.stubtest", "atraj"], check=True, cwd=HERE)


@pytest.mark.parametrize("version", ["3.10", "3.13"])
def test_examples_and_package_are_typed(version):
    examples = [str(HERE.parent / "examples/vibration.py"), str(HERE / "typed.py")]
    subprocess.run([sys.executable, "-m", "mypy", "--strict", "--python-version", version, *examples], check=True, cwd=HERE)
