#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Renders the stored pictures of stored_test.cpp again: where a scene has changed, or what light there is; never
# because the test fails for another reason. Estimators are the plainest: independent samples, the path tracer to read.
set -eu
[[ $# == 1 ]] || { echo "usage: $0 TWINRAY" >&2 && exit 2; }
here=$(dirname -- "$(readlink -f -- "$0")")
for scene in box.dae lights.dae spheres.dae still-life.pbrt pawns.pbrt layers.pbrt materials.pbrt table.gltf; do
  "$1" render "$here/../../scenes/$scene" -r 24 18 -m 8 -s 16384 --sampler=independent --integrator=path-reference \
    --filter=box --regularize --seed=184 --layers=variance,samples -q -o "$here/${scene%.*}.exr"
done
