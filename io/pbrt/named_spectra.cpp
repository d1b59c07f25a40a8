// SPDX-License-Identifier: Apache-2.0
// The spectra that pbrt knows by name, as colors: of metals the index of refraction and the absorption (k),
// of glasses the index, of the CIE's illuminants the light. They were integrated in steps of 1 nm.
#include <algorithm>
#include <array>

#include "io/pbrt/spectrum.h"

namespace twinray {
namespace {

constexpr std::array<NamedSpectrum, 37> spectra{{
    {"metal-Ag-eta", {0.12847f, 0.12353f, 0.15089f}},  {"metal-Ag-k", {4.0649f, 3.2863f, 2.3918f}},
    {"metal-Al-eta", {1.4074f, 0.92665f, 0.58404f}},   {"metal-Al-k", {7.7404f, 6.6026f, 5.3603f}},
    {"metal-Au-eta", {0.08005f, 0.40465f, 1.5614f}},   {"metal-Au-k", {3.3905f, 2.5038f, 1.7709f}},
    {"metal-Cu-eta", {0.10449f, 0.97817f, 1.2047f}},   {"metal-Cu-k", {3.2733f, 2.5924f, 2.3692f}},
    {"metal-CuZn-eta", {0.41844f, 0.51992f, 1.1231f}}, {"metal-CuZn-k", {3.6678f, 2.6808f, 1.771f}},
    {"metal-MgO-eta", {1.7337f, 1.7409f, 1.7535f}},    {"metal-MgO-k", {0, 0, 0}},
    {"metal-TiO2-eta", {2.8604f, 2.9565f, 3.1855f}},   {"metal-TiO2-k", {8.8742e-05f, 0, 0.00055126f}},
    {"glass-BK7", {1.5184f, 1.5184f, 1.5184f}},        {"glass-BAF10", {1.6729f, 1.6729f, 1.6729f}},
    {"glass-FK51A", {1.4877f, 1.4877f, 1.4877f}},      {"glass-LASF9", {1.8556f, 1.8556f, 1.8556f}},
    {"glass-F5", {1.6769f, 1.6769f, 1.6769f}},         {"glass-F10", {1.7334f, 1.7334f, 1.7334f}},
    {"glass-F11", {1.7909f, 1.7909f, 1.7909f}},        {"stdillum-A", {1.845f, 0.82607f, 0.23337f}},
    {"stdillum-D50", {1.0866f, 0.99951f, 0.74971f}},   {"stdillum-D65", {1, 1, 1}},
    {"stdillum-F1", {0.95426f, 1.0193f, 0.94366f}},    {"stdillum-F2", {1.3401f, 0.94299f, 0.56285f}},
    {"stdillum-F3", {1.5764f, 0.89107f, 0.38089f}},    {"stdillum-F4", {1.8063f, 0.8342f, 0.26707f}},
    {"stdillum-F5", {0.9154f, 1.0362f, 0.89032f}},     {"stdillum-F6", {1.3161f, 0.95783f, 0.4865f}},
    {"stdillum-F7", {1.0003f, 1.0002f, 0.9974f}},      {"stdillum-F8", {1.1767f, 0.97571f, 0.72009f}},
    {"stdillum-F9", {1.3768f, 0.9314f, 0.56935f}},     {"stdillum-F10", {1.1776f, 0.97562f, 0.71836f}},
    {"stdillum-F11", {1.4121f, 0.92473f, 0.53156f}},   {"stdillum-F12", {1.7684f, 0.84507f, 0.27085f}},
    {"illum-acesD60", {1.0469f, 0.99457f, 0.91553f}},
}};

}  // namespace

std::optional<NamedSpectrum> named_spectrum(std::string_view name) {
  const auto found = std::find_if(spectra.begin(), spectra.end(),
                                  [&](const NamedSpectrum& spectrum) { return spectrum.name == name; });
  return found == spectra.end() ? std::nullopt : std::optional(*found);
}

std::vector<std::string_view> named_spectra() {
  std::vector<std::string_view> names;
  for (const NamedSpectrum& spectrum : spectra) names.push_back(spectrum.name);
  return names;
}

}  // namespace twinray
