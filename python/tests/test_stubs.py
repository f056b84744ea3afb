"""Do the type stubs agree with the module?"""

import os
import subprocess
import sys
from pathlib import Path

import stubs
import pytest

HERE = Path(__file__).parent


def is_fresh(path, text):
    """Compares the file with what it should hold, or writes it."""
    if os.environ.get("UPDATE_PYTHON_DOCS"):
        path.write_text(text)
    assert path.read_text() == text, f"run make -C python stubs, for {path.name} is old"


@pytest.mark.parametrize("module", stubs.STUBS, ids=lambda module: module.__name__)
def test_stubs_have_the_docstrings(module):
    path = stubs.STUBS[module]
    is_fresh(path, stubs.with_docstrings(module, path.read_text()))


def test_stubs_agree_with_the_module():
    subprocess.run([sys.executable, "-m", "mypy.stubtest", "atraj"], check=True, cwd=HERE)


@pytest.mark.parametrize("version", ["3.10", "3.13"])
def test_examples_and_package_are_typed(version):
    examples = [str(HERE.parent / "examples/vibration.py"), str(HERE / "typed.py")]
    subprocess.run([sys.executable, "-m", "mypy", "--strict", "--python-version", version, *examples], check=True, cwd=HERE)
