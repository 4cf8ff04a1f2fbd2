#!/bin/bash
# Grades the submissions of a Moodle assignment, and makes the table that Moodle imports.
#
#   grade.sh RUBRIC SUBMISSIONS.zip WORKSHEET.csv RESULTS
#
# SUBMISSIONS.zip is "Download all submissions", WORKSHEET.csv is "Download grading worksheet" of the same assignment.
# RESULTS/moodle.csv goes into "Upload grading worksheet".
set -eu
if [ $# -ne 4 ]; then
  echo "usage: $0 RUBRIC SUBMISSIONS.zip WORKSHEET.csv RESULTS" >&2
  exit 2
fi
"${INBETWEEN:-inbetween}" grade "$1" "$2" --roster "$3" -o "$4" --no-images --to moodle
echo "Now upload $4/moodle.csv as the grading worksheet."
