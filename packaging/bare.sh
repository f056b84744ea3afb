#!/bin/sh
# bare.sh FOLDER: runs `make demo` and `make check` on a bare machine: a Debian 12 in this new folder, which has the packages of `dist` in
# debian-packages.txt and this machine's Rust, and nothing else. Needs root, debootstrap and git.
set -eu
folder=$1
cd "$(dirname "$0")"
debootstrap --variant=minbase --include="$(sed -n 's/^dist *//p' debian-packages.txt | tr ' ' ,)" bookworm "$folder"
git clone --quiet .. "$folder/atraj"
cp -a "$(rustc --print sysroot)" "$folder/rust"
# cargo fetches crates.
mkdir -p "$folder/etc/ssl/certs"
cp -L /etc/ssl/certs/ca-certificates.crt "$folder/etc/ssl/certs"
cp -L /etc/resolv.conf "$folder/etc"
for kernel in proc dev; do mount --bind "/$kernel" "$folder/$kernel"; done
trap 'umount "$folder/proc" "$folder/dev"' EXIT
chroot "$folder" /usr/bin/env -i HOME=/root PATH=/rust/bin:/usr/bin:/bin sh -ec 'cd /atraj; make demo; make check'
