"""Do wheel and sdist install on a bare Python, the oldest one here too, and give the golden bits? Does PyPI take them?"""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parent
DIST = HERE.parents[1] / "target/python/dist"
# Not the tests' own version of it, which needs a later Python.
PYTEST = "pytest>=8,<9"


def interpreters():
    """Every Python here that the package is for, by its version."""
    names = [f"python3.{minor}" for minor in range(10, 30)]
    pyenv = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv")) / "versions"
    found = {}
    for name in [sys.executable, *names, *map(str, pyenv.glob("*/bin/python3"))]:
        try:
            ask = [name, "-c", "import sys, venv, ensurepip; print(*sys.version_info[:2])"]
            answer = subprocess.run(ask, capture_output=True, text=True, check=True)
        except (OSError, subprocess.CalledProcessError):
            continue
        version = tuple(map(int, answer.stdout.split()))
        if version >= (3, 10):
            found.setdefault(version, name)
    return found


PYTHONS = interpreters()


def install_and_run(python, artifact, directory):
    """Installs the file in a fresh environment outside the sources and runs the golden rows there."""
    subprocess.run([python, "-m", "venv", directory], check=True)
    inside = directory / "bin/python"
    subprocess.run([inside, "-m", "pip", "--quiet", "--disable-pip-version-check", "install", artifact, PYTEST], check=True)
    tests = [str(HERE / "test_golden.py"), "-q", "-p", "no:cacheprovider"]
    ran = subprocess.run([inside, "-m", "pytest", *tests], cwd=directory, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert int(re.search(r"(\d+) passed", ran.stdout)[1]) >= 10


def artifact(pattern):
    (found,) = DIST.glob(pattern)
    return found


@pytest.mark.parametrize("version", [min(PYTHONS), max(PYTHONS)], ids=lambda version: ".".join(map(str, version)))
def test_the_wheel(version, tmp_path):
    if min(PYTHONS) != (3, 10):
        print("there is no Python 3.10 here, the oldest of the package")
    install_and_run(PYTHONS[version], artifact("*.whl"), tmp_path / "venv")


def test_the_sdist(tmp_path, monkeypatch):
    # The bits do not depend on how long the compiler works.
    monkeypatch.setenv("CARGO_PROFILE_RELEASE_LTO", "off")
    monkeypatch.setenv("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "16")
    install_and_run(sys.executable, artifact("*.tar.gz"), tmp_path / "venv")


def test_the_wheel_is_for_any_linux():
    assert re.fullmatch(r"atraj-[\d.]+-cp310-abi3-manylinux.*manylinux_2_17_\w+\.whl", artifact("*.whl").name)


def test_pypi_takes_both():
    files = [str(artifact("*.whl")), str(artifact("*.tar.gz"))]
    checked = subprocess.run([sys.executable, "-m", "twine", "check", "--strict", *files], capture_output=True, text=True)
    assert checked.returncode == 0 and checked.stdout.count("PASSED") == 2, checked.stdout + checked.stderr
