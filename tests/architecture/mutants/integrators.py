# SPDX-License-Identifier: Apache-2.0
"""Defects in integrators/."""
from mutant import Mutant

MUTANTS = [
    Mutant("a sample's point in the pixel is always its centre", "integrators/render.cpp",
           "options_.samples == 1 ? Vec2{0.5f, 0.5f}", "options_.samples >= 1 ? Vec2{0.5f, 0.5f}",
           "test_integrators"),
]
