# SPDX-License-Identifier: Apache-2.0
"""Defects of packets: of the rays that run close together through the eight-wide tree."""
from mutant import Mutant

TARGET = "test_accel"
RAYS = "accel/canonical/ray_packet-inl.h"
TEST = "accel/canonical/packet_test-inl.h"
TREE = "accel/wide/packets-inl.h"

ALONE = "each ray of a packet has the hit that it has alone"
EDGES = "packets along edges, through corners and beside boxes miss nothing"
BOUNDS = "the bounds of equal rays are those of one"
STEPS = "a packet of equal rays takes the steps of one"
LEFT = "what is no packet is left alone"
PARTED = "a packet whose rays part is given up"

MUTANTS = [
    Mutant("a packet enters boxes by the latest origin", RAYS,
           "of.near_origin = of.is_negative ? backward : forward;",
           "of.near_origin = of.is_negative ? forward : backward;",
           TARGET, ALONE),
    Mutant("a packet leaves boxes by the earliest origin", RAYS,
           "of.far_origin = of.is_negative ? forward : backward;",
           "of.far_origin = of.is_negative ? backward : forward;",
           TARGET, ALONE),
    Mutant("a packet knows one end of its near reciprocals", TREE,
           "hn::Min(hn::Mul(distance, near_inverse_[axis][0]), hn::Mul(distance, near_inverse_[axis][1]))",
           "hn::Mul(distance, near_inverse_[axis][0])",
           TARGET, ALONE),
    Mutant("a packet knows one end of its far reciprocals", TREE,
           "hn::Max(hn::Mul(distance, far_inverse_[axis][0]), hn::Mul(distance, far_inverse_[axis][1]))",
           "hn::Mul(distance, far_inverse_[axis][0])",
           TARGET, ALONE),
    Mutant("a packet's boxes have no margin for its origins", RAYS,
           "const float reach = sizes.largest() * slab_margin;", "const float reach = 0;",
           TARGET, BOUNDS),
    Mutant("a packet's float test leaves no doubt", TEST,
           "hn::Set(Floats(), edge_margin)", "hn::Set(Floats(), -edge_margin)",
           TARGET, EDGES),
    Mutant("of a packet's ties the last one wins", TEST,
           "hits &= ~(left & -left)", "hits &= hits",
           TARGET, ALONE),
    Mutant("of a packet's ties the first one wins", TEST,
           "if (ids_[first + std::size_t(std::countr_zero(left))] < id) ", "",
           TARGET, ALONE),
    Mutant("a packet's boxes are culled by its first t_max alone", TEST,
           "        test_triangle(rays, block, std::countr_zero(left));\n    }\n    find_latest();\n",
           "        test_triangle(rays, block, std::countr_zero(left));\n    }\n",
           TARGET, STEPS),
    Mutant("the least origin of a packet is its first one", RAYS,
           "      least_ = first == 0 ? lanes : hn::Min(least_, lanes);\n",
           "      if (first == 0) least_ = lanes;\n",
           TARGET, "a packet knows of each ray what it is alone, and bounds of all"),
    Mutant("a packet may have directions of other signs", RAYS,
           "lanes_of(hn::MaskFromVec(hn::BitCast(Floats(), sign))) != signs", "signs > all_lanes",
           TARGET, LEFT),
    Mutant("a packet may have other dominant axes", RAYS,
           "lanes_of(is_less) != all_lanes ||", "lanes_of(is_less) > all_lanes ||",
           TARGET, LEFT),
    Mutant("a packet may have a t_max that is not a number", RAYS,
           "hn::And(hn::Le(begin, end), hn::Le(begin, most))", "hn::Le(begin, most)",
           TARGET, LEFT),
    Mutant("a packet may have a t_min that is not finite", RAYS,
           "hn::And(hn::Le(begin, end), hn::Le(begin, most))", "hn::Le(begin, end)",
           TARGET, LEFT),
    Mutant("a packet may have directions too short", RAYS,
           "hn::Ge(size, hn::Set(Floats(), min_direction))", "hn::Ge(size, hn::Zero(Floats()))",
           TARGET, LEFT),
    Mutant("a packet is never given up", TREE,
           "      if (tested > most_primitives) return false;\n", "",
           TARGET, PARTED),
    Mutant("a packet's spheres are tested without what was found before", TEST,
           "      best.other = hit(i);\n      best.t = best.other.t;\n", "",
           TARGET, ALONE),
]
