"""Do the type stubs agree with the module?"""

import subprocess
import sys
from pathlib import Path

import atraj

HERE = Path(__file__).parent
PACKAGE = Path(atraj.__file__).parent


def test_stubs_agree_with_the_module():
    allowed = str(HERE / "stubtest-allowed.txt")
    subprocess.run([sys.executable, "-m", "mypy.stubtest", "atraj", "--allowlist", allowed], check=True, cwd=HERE)


def test_both_real_types_have_the_same_stubs():
    def classes(stub):
        return stub.split("_Real: TypeAlias = ")[1].split("\n", 1)[1].split("\n__")[0].rstrip()

    binary64, binary32 = ((PACKAGE / name).read_text() for name in ["__init__.pyi", "f32.pyi"])
    assert "_Real: TypeAlias = np.float64\n" in binary64 and "_Real: TypeAlias = np.float32\n" in binary32
    assert classes(binary64) == classes(binary32)


def test_examples_and_package_are_typed():
    examples = [str(HERE.parent / "examples/vibration.py"), str(HERE / "typed.py")]
    subprocess.run([sys.executable, "-m", "mypy", "--strict", *examples], check=True, cwd=HERE)
