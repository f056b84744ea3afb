#!/bin/sh
# Builds Ruckig's C++ library for the benchmark, and prints the path of the shared library. Needs curl, a C++ compiler and the network.
# The source comes from PyPI. Other bytes than those of this checksum are refused. `make bench` runs this script.
set -eu
version=0.19.4
checksum=71d003bf0ff9aa0031d4520b0290a5ffa6458149f5afce8be3ed6d6fba49ea64
packages=https://files.pythonhosted.org/packages/4a/2a/d1c1639bf76699ab1c3c1281101372f2b749d0ad8aee4c19200947b92785
directory=target/ruckig
archive=$directory/ruckig-$version.tar.gz
library=$PWD/$directory/libruckig.so

mkdir -p $directory
is_right() { echo "$checksum  $archive" | sha256sum --check --status 2> /dev/null; }
is_right || curl --fail --silent --show-error --location --max-time 120 --output $archive $packages/ruckig-$version.tar.gz
is_right || { echo "$archive has other bytes than Ruckig $version" >&2; exit 1; }
if ! test "$library" -nt "$0" || ! test "$library" -nt tests/oracle/c/ruckig.cpp; then
    tar -xzf $archive -C $directory
    source=$directory/ruckig-$version
    # The client of a remote planner is the one part that needs the network.
    ${CXX:-c++} -std=c++20 -O3 -DNDEBUG -fPIC -shared -I$source/include tests/oracle/c/ruckig.cpp \
        $(ls $source/src/ruckig/*.cpp | grep -v cloud_client) -o "$library"
fi
echo "$library"
