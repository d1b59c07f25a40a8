#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How bench/peers compares pictures, and what it makes of errors and seconds."""
import random
import sys
import unittest
from array import array
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench" / "peers"))
import compare  # noqa: E402
import measure  # noqa: E402
import page  # noqa: E402
import peers  # noqa: E402
import renderers  # noqa: E402


class Comparison(unittest.TestCase):
    def noisy(self, rng, sigma, level=1.0, count=3 * 160 * 120):
        return array("f", (level + rng.gauss(0, sigma) for _ in range(count)))

    def test_the_noise_of_references_is_no_error(self):
        rng = random.Random(3)
        picture, one, other = self.noisy(rng, 0.1), self.noisy(rng, 0.2), self.noisy(rng, 0.2)
        found = compare.error(picture, one, other, [True] * (160 * 120))
        self.assertAlmostEqual(found, 0.01, delta=0.001)  # each reference alone would add 0.04

    def test_a_bias_is_an_error(self):
        rng = random.Random(4)
        picture, one, other = (self.noisy(rng, 0.1, level) for level in (1.3, 1, 1))
        self.assertAlmostEqual(compare.error(picture, one, other, [True] * (160 * 120)), 0.1, delta=0.003)

    def test_pixels_beside_a_light_are_left_out(self):
        picture = array("f", [0.1] * 3 * 25)
        picture[3 * 7 + 1] = 10  # x 2, y 1
        mask = compare.without_lights([picture], 5, 5, 2)
        self.assertEqual([i for i, kept in enumerate(mask) if not kept], [1, 2, 3, 6, 7, 8, 11, 12, 13])

    def test_pictures_agree_unless_the_mean_or_a_tile_differs(self):
        rng = random.Random(5)
        mask = [True] * (160 * 120)
        one = self.noisy(rng, 0.01)
        self.assertTrue(compare.agreement(self.noisy(rng, 0.01), one, mask, 160, 120).is_good())
        brighter = compare.agreement(self.noisy(rng, 0.01, 1.01), one, mask, 160, 120)
        self.assertAlmostEqual(brighter.mean_ratio, 1.01, delta=0.001)
        self.assertFalse(brighter.is_good())
        spotted = self.noisy(rng, 0.01)
        for y in range(20, 30):
            for i in range(3 * (160 * y + 30), 3 * (160 * y + 40)):
                spotted[i] += 0.04
        self.assertFalse(compare.agreement(spotted, one, mask, 160, 120).is_good())
        spotted_mean = compare.agreement(spotted, one, mask, 160, 120).mean_ratio
        self.assertAlmostEqual(spotted_mean, 1, delta=0.001)

    def test_a_dark_tile_may_differ_by_a_share_of_the_whole_picture(self):
        mask = [True] * (160 * 120)
        one, other = (array("f", [1.0] * (3 * 160 * 120)) for _ in range(2))
        for y in range(10):
            for i in range(3 * 160 * y, 3 * (160 * y + 10)):
                one[i], other[i] = 0.02, 0.01
        found = compare.agreement(one, other, mask, 160, 120)
        self.assertAlmostEqual(found.tile_difference, 0.01 / 0.25, delta=0.001)

    def test_a_picture_is_taken_out_of_a_mean(self):
        pictures = [array("f", [1, 2]), array("f", [3, 6]), array("f", [5, 1])]
        mean = compare.mean_picture(pictures)
        self.assertEqual(list(compare.mean_without(mean, 3, pictures[2])), [2, 4])


class References(unittest.TestCase):
    def entry(self, family, *numbers):
        """Of a renderer whose pictures have one number each, half of them by default roulette."""
        pictures = [array("f", [number]) for number in numbers]
        half = len(pictures) // 2
        return peers.Entry(renderers.Renderer(family, family, None),
                           equal=peers.Series(4, [], pictures[:half]),
                           usual=peers.Series(4, [], pictures[half:]))

    def values(self, references, picture):
        return [list(reference) for reference in references.without(picture)]

    def test_references_are_two_peers_without_the_picture_itself(self):
        ours, one, other = self.entry("twinray", 90, 92), self.entry("one", 1, 3), self.entry("other", 10, 30)
        references = peers.References([ours, one, self.entry("one", 5, 7), other])
        self.assertEqual(sorted(self.values(references, ours.equal.pictures[0])), [[4], [20]])
        self.assertEqual(sorted(self.values(references, one.equal.pictures[0])), [[5], [20]])
        self.assertEqual(sorted(self.values(references, other.usual.pictures[0])), [[4], [10]])

    def test_with_one_peer_our_pictures_are_the_other_reference(self):
        ours, one = self.entry("twinray", 90, 92), self.entry("one", 1, 3)
        references = peers.References([ours, one])
        self.assertEqual(sorted(self.values(references, ours.equal.pictures[0])), [[2], [92]])


class Page(unittest.TestCase):
    def entry(self, *series):
        """Of a renderer that starts in 1 CPU second, and these (samples, CPU seconds, error)."""
        entry = peers.Entry(None, [measure.Cost(1, 1, "")])
        entry.equal, entry.usual = (
            peers.Series(samples, [measure.Cost(seconds, 1, "")], [], [error])
            for samples, seconds, error in series)
        return entry

    def test_seconds_to_an_error_follow_how_fast_it_falls(self):
        random_numbers = self.entry((64, 9, 4e-4), (64, 5, 8e-4))
        self.assertAlmostEqual(page.seconds_to(random_numbers, random_numbers.equal, 0.01), 1 + 8 * 4)
        self.assertAlmostEqual(page.seconds_to(random_numbers, random_numbers.usual, 0.01), 1 + 4 * 8)
        faster = self.entry((64, 9, 1e-4), (16, 3, 8e-4))
        self.assertAlmostEqual(page.rate(faster), 1.5)
        self.assertAlmostEqual(page.seconds_to(faster, faster.usual, 0.01), 1 + 2 * 4)
        slower = self.entry((64, 9, 1e-4), (16, 3, 2e-4))
        self.assertEqual(page.rate(slower), 1)
        lucky = self.entry((64, 9, 1e-6), (16, 3, 8e-4))
        self.assertEqual(page.rate(lucky), 2)


if __name__ == "__main__":
    unittest.main()
