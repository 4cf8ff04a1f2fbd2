#!/bin/bash
# Gradescope runs this once, when it builds the autograder from the zip. It stops the build if the program or the rubric is wrong.
set -eu
cd "$(dirname "$0")"
chmod +x inbetween
./inbetween --version
./inbetween grade --check rubric.toml
