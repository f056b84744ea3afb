#!/bin/sh
# stubs.sh: writes the type stubs of atraj.f32, which are the stubs of atraj with another real type.
set -eu
cd "$(dirname "$0")/atraj"
{
    sed -e '/^from \.values/s/ as .*//' -e 's/np\.float64/np.float32/' -e '/^from \. import/d' -e '/^__version__/,$d' __init__.pyi
    sed -n '/^__all__/,$p' f32.py
} > f32.pyi
