# SPDX-License-Identifier: Apache-2.0
"""One of many lights, chosen and sampled in lanes."""
from mutant import Mutant

WAVE_BITS = "waves of paths have the bits and the rays of paths one after the other"
TREE = "integrators/wave/light_tree-inl.h"
LAMPS = "integrators/wave/lamps-inl.h"
BY_POWER = "waves have the bits of paths that choose from many lights by power, and from lights without any"

MUTANTS = [
    Mutant("lanes go to the other child of a light tree", TREE,
           "hn::RebindMask(WordTag(), is_first), first, second)",
           "hn::RebindMask(WordTag(), is_first), second, first)", "test_integrators", WAVE_BITS),
    Mutant("lanes choose all the way down a light tree by one draw", TREE,
           "hn::Div(draw, first)", "draw", "test_integrators", WAVE_BITS),
    Mutant("lanes take a node from within for one from outside", TREE,
           "select(hn::Gt(squared, squared_radius), outside, within)", "outside", "test_integrators",
           WAVE_BITS),
    Mutant("lanes choose lamps behind an opaque surface, too", TREE,
           "select(receiver.lets_light_through, hn::Abs(cos_normal), cos_normal)", "hn::Abs(cos_normal)",
           "test_integrators", WAVE_BITS),
    Mutant("lanes choose by importance where power is asked for", TREE,
           "tree.choice() == LightTree::Choice::power", "tree.nodes().empty()", "test_integrators", BY_POWER),
    Mutant("lanes that have arrived in a light tree go on choosing", TREE,
           "select(walks, share, splat(1))", "share", "test_integrators", WAVE_BITS),
    Mutant("the rest of a choice's draw is the draw", "core/light_tree.cpp",
           "rest = is_first ? rest / first : (rest - first) / (1 - double(first));",
           "rest = is_first ? rest : (rest - first) / (1 - double(first));", "test_core",
           "what a choice leaves of a draw is a draw, and as even as the draws were"),
    Mutant("a light tree without lights has a root", TREE, "if (nodes.empty()) continue;", "",
           "test_integrators", BY_POWER),
    Mutant("lamps that are chosen from emit on one side", LAMPS,
           "select(side.both, hn::Abs(cos_front), select(", "select(side.both, cos_front, select(",
           "test_integrators", WAVE_BITS),
    Mutant("a lamp's sample forgets how likely the lamp is", LAMPS,
           "hn::Mul(load(samples.pdf, i), load(picks.probability, i))", "load(samples.pdf, i)",
           "test_integrators", WAVE_BITS),
    Mutant("a lamp of one triangle is taken for a parallelogram", LAMPS,
           "select(is_triangle, hn::Sub(x, half), one_of", "select(is_triangle, x, one_of",
           "test_integrators", WAVE_BITS),
    Mutant("of lamps of several patches that are chosen from, the first is sampled",
           "integrators/wave/shape_table.cpp", "patches.size() != 1", "patches.empty()", "test_integrators",
           WAVE_BITS),
    Mutant("a lamp whose sample is made in lanes has no source", "integrators/wave/light_choice.cpp",
           "light_.source[i] = picks.light[i];", "light_.source[i] = 0;", "test_integrators",
           "waves have the groups of the path tracer for lamps that are chosen from"),
]
