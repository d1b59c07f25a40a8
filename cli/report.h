// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "accel/accelerator.h"
#include "cli/render_arguments.h"
#include "integrators/render.h"

namespace twinray {

/// The figures at the end of a render, as lines of text: those that CS184's program prints, and rays by kind.
std::string figures_text(const AccelStats& accel, const RenderResult& result, bool counted);

/// All figures as a JSON text; with `check`, itself a JSON text, as a member of that name unless empty.
std::string figures_json(const RenderArguments& arguments, const AccelStats& accel,
                         const RenderResult& result, const std::string& check = "");

/// Says how to see a rejected sample again; empty if there was none.
std::string rejection_text(const Film& film);

}  // namespace twinray
