# SPDX-License-Identifier: Apache-2.0
"""Defects in what measures the error of pictures."""
from mutant import Mutant

FOUND = "no bias is found where there is none, and one of 1 % is found"
NOISE = "the converged picture's noise counts where it is known, else it is taken for bias"
UNIFORM = "p-values of tiles without bias are uniformly distributed"
SUBTRACTED = "the noise of a reference that is rendered here is not counted as error, nor as bias"

MUTANTS = [
    Mutant("p-values are one-sided", "check/welch.cpp",
           "std::min(1.0, 2 * cdf(", "std::min(1.0, cdf(",
           "test_check", "p-values of Student's distribution are those of another program"),
    Mutant("the degrees of freedom are those of the first sample alone", "check/welch.cpp",
           "freedom_of(variance, share(a) + share(b))", "freedom_of(a.variance, share(a))",
           "test_check", "Welch's test of two samples is that of another program"),
    Mutant("a tile's variance is that of a pixel", "check/welch.cpp",
           "variances_ / (n * n)", "variances_ / n",
           "test_check", FOUND),
    Mutant("the variance of the mean is that of one picture", "check/bias.cpp",
           "pixels_[index].squares / (n - 1) / n", "pixels_[index].squares / (n - 1)",
           "test_check", UNIFORM),
    Mutant("the converged picture counts as exact", "check/bias.cpp",
           "one.variance = noise * noise;", "one.variance = 0 * noise;",
           "test_check", NOISE),
    Mutant("p-values are not corrected for the number of tiles", "check/bias.cpp",
           "corrected_p_value(least, result.tiles.size() + 1)", "corrected_p_value(least, 1)",
           "test_check", "the p-value of a picture is corrected for all its tiles and the whole"),
    Mutant("the power law between two points is a straight line", "check/convergence.cpp",
           "a.cost * exp2_of(part * log2_of(b.cost / a.cost))", "a.cost + part * (b.cost - a.cost)",
           "test_check", "between two points the error follows the power law through both"),
    Mutant("an error counts as reached at the first point below it", "check/convergence.cpp",
           "std::size_t reached = valid.size();",
           "std::size_t reached = valid.size(); if (valid[0].mse <= mse) reached = 0;",
           "test_check", "an error counts as reached where it is not passed again"),
    Mutant("emitters alone count", "check/visible_emitters.cpp",
           "mask.push_back(is_black(seen))", "mask.push_back(!is_black(seen))",
           "test_check", "pixels that see an emitter are those that its light reaches the camera in"),
    Mutant("the reference's own error is part of every error", "cli/error/summary.cpp",
           "mean(mses) - own.mse", "mean(mses)",
           "test_cli", SUBTRACTED),
    Mutant("both halves of the reference have the same seed", "cli/error/measurement.cpp",
           "{seed, seed + 1}", "{seed, seed}",
           "test_cli", SUBTRACTED),
    Mutant("all pictures of a point have the same seed", "cli/error/measurement.cpp",
           "rounds.first_seed + std::uint64_t(round)", "rounds.first_seed",
           "test_cli", "errors are those of the pictures that render makes with the same options and seeds"),
    Mutant("a set's options are those common to all", "cli/error/option_set.cpp",
           "read_alone(set.options,", "read_alone({},",
           "test_cli", "errors are those of the pictures that render makes with the same options and seeds"),
    Mutant("textures are converted in place of an error", "cli/error/options.cpp",
           "if (set.arguments.convert_textures)", "if (false)", "test_cli",
           "wrong command lines of error are refused with what would be valid"),
]
