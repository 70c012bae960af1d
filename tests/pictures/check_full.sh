#!/bin/sh
# check_full.sh WINDOW_PROGRAM OFFSCREEN_PROGRAM
# Printing where there is no room ends with exit code 4 and a sentence, whatever the command.
set -u
fault=0

expect_refusal() { # program and arguments
  message=$("$@" 2>&1 >/dev/full)
  code=$?
  case "$code $message" in
    "4 rasterwalk"*": the output could not be written.") ;;
    *)
      echo "$*: exit code $code, '$message'" >&2
      fault=1
      ;;
  esac
}

for arguments in --help --version settings presets bugs facts lessons stats "stats --help" "rows 10,5 5,10 15,15" \
  "triangle 7" "pixel 250,400" compare "settings --json"; do
  # shellcheck disable=SC2086 # separate words
  expect_refusal "$1" $arguments
done
expect_refusal "$2" --help
expect_refusal "$2" --version
exit $fault
