# SPDX-License-Identifier: Apache-2.0
"""Defects in core/lobes/ and what they stand on."""
from mutant import Mutant

MITSUBA_CONDUCTORS = "rough conductors are Mitsuba's, but for light that meets several facets"
COATED_FURNACE = "a coated white surface passes the furnace"
BRUSHED = "what facets of two alphas lose along a direction is tabulated within the stated error"
BRUSHED_BOUNDARY = ("what a boundary's facets of two alphas lose is nearer to the integral than that of "
                    "one alpha")
WAVES = "waves of paths have the bits and the rays of paths one after the other"

MUTANTS = [
    Mutant("a conductor's Fresnel reflectance forgets what it absorbs", "core/fresnel.cpp",
           "const float difference = eta * eta - k * k - sin2;", "const float difference = eta * eta - sin2;",
           "test_core", "a conductor reflects by Fresnel's equations"),
    Mutant("light from within glass is never reflected totally", "core/fresnel.h",
           "if (cos_t == 0) return 1;", "if (cos_t == 0) return 0;", "test_core",
           "total internal reflection begins at the critical angle, Brewster's angle has half a reflection"),
    Mutant("visible normals lack their cosine", "core/microfacet.h",
           "masking(w) * std::max(0.0f, dot(w, m)) * density(m) / w.z", "masking(w) * density(m) / w.z",
           "test_core", "the facets that a direction sees have its projected area"),
    Mutant("facets are hidden as if their alphas were exchanged", "core/microfacet.h",
           "const float x = x_ * w.x, y = y_ * w.y;", "const float x = y_ * w.x, y = x_ * w.y;",
           "test_core", MITSUBA_CONDUCTORS),
    Mutant("rough metal loses what meets several facets", "core/lobes/rough_conductor.cpp",
           "{single_scattering(facets) + more,", "{single_scattering(facets),", "test_core",
           "a rough white metal passes the furnace"),
    Mutant("refracted radiance is not compressed", "core/lobes/dielectric_facets.cpp",
           "const float geometry = cos_o * cos_i /", "const float geometry = eta_ * eta_ * cos_o * cos_i /",
           "test_core", "a rough dielectric is reciprocal, by eta squared where it transmits"),
    Mutant("the inside of rough glass is taken for its outside", "core/bsdf.cpp",
           "side == Side::outside ? ior : 1 / ior", "ior",
           "test_core", "a rough boundary is seen from the side that the viewer is on"),
    Mutant("a coat lets light out as from a medium like the outside", "core/lobes/coat.cpp",
           "return r / ((1", "return r * spread / ((1", "test_core", COATED_FURNACE),
    Mutant("light below a coat leaves at the first try", "core/lobes/coat.cpp",
           "(1 - r) * spread + r * out", "spread", "test_core", COATED_FURNACE),
    Mutant("a metal's density is that within its coat", "core/lobes/coated_conductor.cpp",
           "below_coat.pdf * narrower", "below_coat.pdf", "test_core",
           "a coated conductor is sampled with its density, and is reciprocal"),
    Mutant("a rough diffuse surface scatters light once only", "core/lobes/rough_diffuse.cpp",
           "once + multiple_ * (missing / std::max(least, 1 - average_))", "once", "test_core",
           "a rough white diffuse surface passes the furnace"),
    Mutant("CS184's masking has the root of pi", "core/lobes/cs184_microfacet.cpp",
           "exp_of(-a * a) / (a * pi)", "exp_of(-a * a) / (a * 1.77245385f)", "test_core",
           "CS184's microfacets have the values of the course's formulas"),
    Mutant("in lanes all coats reflect as the first of the list", "integrators/wave/coats-inl.h",
           "row_(indices(at.row, k, at.size))", "row_(hn::Zero(IndexTag()))", "test_integrators", WAVES),
    Mutant("in lanes rough coats are mirrors", "integrators/wave/coats-inl.h",
           "is_delta = hn::And(reflects, is_smooth_)", "is_delta = reflects", "test_integrators", WAVES),
    Mutant("in lanes metals lose light as seen from the viewer alone", "integrators/wave/metals-inl.h",
           "hn::Mul(loss_, loss(facets_, alpha_, wi))", "hn::Mul(loss_, loss_)", "test_integrators", WAVES),
    Mutant("in lanes brushed metal loses the same all around", "integrators/wave/facets-inl.h",
           "if (hn::AllFalse(FloatTag(), has_two)) return one_alpha;", "return one_alpha;",
           "test_integrators", WAVES),
    Mutant("in lanes brushed metal has no skew", "integrators/wave/facets-inl.h",
           "return hn::Add(along, hn::Mul(added, azimuth.skew2));", "return along;", "test_integrators",
           WAVES),
    Mutant("brushed metal loses the same all around", "core/ggx_albedo.cpp",
           "return facets_.has_one_alpha() ? loss : part_of_light(loss + ggx_loss_change(facets_, w));",
           "return loss;", "test_core", BRUSHED),
    Mutant("brushed metal loses on average as metal of one alpha", "core/ggx_albedo.cpp",
           "if (!facets.has_one_alpha()) average_loss_ =", "if (false) average_loss_ =", "test_core",
           "facets of two alphas lose on average what they lose along all directions"),
    Mutant("what rough glass loses out of it is tabulated as into it", "core/ggx_directions.cpp",
           "is_out(eta < 1)", "is_out(false)", "test_core", BRUSHED_BOUNDARY),
    Mutant("facets of two alphas have no skew", "core/microfacet.h", "skew * skew};", "0};", "test_core",
           BRUSHED_BOUNDARY),
    Mutant("below a coat facets of two alphas scatter as those of their mean",
           "core/lobes/coated_conductor.cpp", "alpha_of_tilts(metal_.facets(), coat.ior())",
           "metal_.facets().mean_alpha()", "test_core",
           "a coated white metal of two alphas passes the furnace as one without direction does"),
    Mutant("in lanes no light is shared with rough surfaces", "integrators/wave/lobes-inl.h",
           "if (mis.is_shared) {", "if (false) {", "test_integrators", WAVES),
    Mutant("in lanes light leaks between the two normals of rough surfaces", "integrators/wave/lobes-inl.h",
           "hn::And(is_not_black(radiance), is_consistent(surfaces, surface, wi, local.z))",
           "is_not_black(radiance)", "test_integrators", WAVES),
    Mutant("what is in glass scatters in lanes as if nothing were absorbed", "integrators/wave/path_wave.cpp",
           """    scatter_light_at_lobes(mis);
    if (context_.has_interiors && !context_.transport.passages) absorb_light();
""",
           """    if (context_.has_interiors && !context_.transport.passages) absorb_light();
    scatter_light_at_lobes(mis);
""", "test_integrators", WAVES),
]
