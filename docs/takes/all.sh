#!/bin/sh
# all.sh FACE TAKES OUT [OPTION...]: every take of a folder on this machine, as many at a time as there are cores, by GNU
# parallel. OUT/log has a line for each with its time and exit status; run again, it does what failed and what is missing.
# OPTION... goes to parallel, such as --jobs 2 or --bar.
set -eu
face=$1 takes=$2 out=$3
shift 3
mkdir -p "$out"
# One core a take: a picture drawn without a graphics card would take all of them.
export LP_NUM_THREADS=0
# A take is known by its name without the ending.
twice=$(for take in "$takes"/*; do name=${take##*/}; echo "${name%.*}"; done | sort | uniq -d | head -n 1)
[ -z "$twice" ] || { echo "$takes: two takes are called $twice; rename one of them" >&2; exit 1; }
exec parallel -q --will-cite --joblog "$out/log" --resume-failed "$@" sh "$(dirname "$0")/take.sh" "$face" '{}' "$out" ::: "$takes"/*
