"""Do the type stubs agree with the module?"""

import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).parent


def test_stubs_agree_with_the_module():
    allowed = str(HERE / "stubtest-allowed.txt")
    subprocess.run([sys.executable, "-m", "mypy.stubtest", "atraj", "--allowlist", allowed], check=True, cwd=HERE)


def test_examples_and_package_are_typed():
    examples = [str(HERE.parent / "examples/vibration.py"), str(HERE / "typed.py")]
    subprocess.run([sys.executable, "-m", "mypy", "--strict", *examples], check=True, cwd=HERE)
