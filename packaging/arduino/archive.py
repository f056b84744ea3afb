"""For PlatformIO: links the archive that fits the compiler's flags. PlatformIO runs it in the tests, with boards of theirs."""
from pathlib import Path

Import("env")  # noqa: F821, PlatformIO gives it


def folder(flags, mcu):
    """The folder of the archive in src, or None: by -mcpu, -mfpu and -mfloat-abi on Arm, by the name of the chip elsewhere."""
    values = dict(flag.split("=", 1) for flag in flags if flag.startswith("-m") and "=" in flag)
    processor = values.get("-mcpu", "").split("+")[0]
    if not processor:
        return mcu
    if values.get("-mfloat-abi", "soft") == "soft":
        return processor if processor.startswith(("cortex-m0", "cortex-m3")) else None
    return f"{processor}/{values.get('-mfpu')}-{values['-mfloat-abi']}"


flags = [str(flag) for name in ("ASFLAGS", "CCFLAGS", "LINKFLAGS") for flag in env.get(name, [])]  # noqa: F821
place = folder(flags, env.get("BOARD_MCU", ""))  # noqa: F821
source = Path(env.Dir(".").srcnode().abspath) / "src"  # noqa: F821
if place is None or not (source / place / "libatraj-float.a").is_file():
    env.Exit(f"atraj has no archive for {place or 'these compiler flags'}")  # noqa: F821
env.Append(LIBPATH=[str(source / place)], LIBS=["atraj-float", "m"])  # noqa: F821
