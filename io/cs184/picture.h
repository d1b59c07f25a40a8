// SPDX-License-Identifier: Apache-2.0
// Pictures as the program of Berkeley's course CS184 writes them: its tone curve, the picture of its sample
// rates, and how it counts the pixels of a part of the frame.
#pragma once
#include <cstdint>
#include <string>

#include "core/film.h"
#include "core/image.h"

namespace twinray {

/// CS184's tone curve: (sqrt(2) L)^(1 / 2.2), clipped at 1, times 255, cut off to a whole number. What is
/// negative or not a number gives 0.
std::uint8_t encode_cs184(float linear);
ByteImage encode_cs184(const Image& image);

/// How many samples each pixel took, in sample_rate_image's colours, of the whole frame: pixels outside of
/// the film's window took none.
ByteImage cs184_rate_image(const Film& film, std::uint32_t most);

/// The name of that picture: the last four characters of the picture's own name are replaced by "_rate.png".
/// A name of fewer characters, folders not counted, is kept whole: "a/bc" -> "a/bc_rate.png".
std::string cs184_rate_name(const std::string& picture);

/// A part of a frame of this height whose pixels are counted from the bottom left: width x height pixels, of
/// which (x, y) is the left one in the lowest row. It may lie outside of the frame.
PixelRect cs184_cell(int x, int y, int width, int height, int frame_height);

}  // namespace twinray
