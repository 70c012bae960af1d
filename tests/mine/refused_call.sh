#!/usr/bin/env bash
# refused_call.sh ROOT: runs refused_call.cpp on this processor and, where a compiler and qemu-user are installed, on
# 64-bit ARM. Exit codes: 0 the handler works, else it does not.
set -eu
cd "$1"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
source=tests/mine/refused_call.cpp
g++ -std=c++20 -Isrc "$source" -o "$folder/here"
"$folder/here"
qemu=$(command -v qemu-aarch64-static || command -v qemu-aarch64 || true)
if [ -z "$qemu" ] || ! command -v aarch64-linux-gnu-g++ >/dev/null; then
    echo "aarch64-linux-gnu-g++ or qemu-aarch64 is not installed: only on this processor."
    exit 0
fi
aarch64-linux-gnu-g++ -std=c++20 -Isrc -static "$source" -o "$folder/arm"
"$qemu" "$folder/arm"
