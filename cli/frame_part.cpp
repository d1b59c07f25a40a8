// SPDX-License-Identifier: Apache-2.0
#include "cli/frame_part.h"

#include <fmt/format.h>

#include "io/picture/image_file.h"

namespace twinray {

std::optional<FramePart> part_shown(const std::string& path, const Image& image) {
  const std::optional<ImageFrame> frame = read_frame(path);
  if (!frame) return std::nullopt;
  const FramePart part{
      {frame->x, frame->y, frame->x + image.width, frame->y + image.height}, frame->width, frame->height};
  return part.window == PixelRect{0, 0, part.width, part.height} ? std::nullopt : std::optional(part);
}

std::string frame_part_text(const FramePart& part) {
  const PixelRect& w = part.window;
  return fmt::format("x {} to {}, y {} to {} of {} x {} pixels", w.x0, w.x1, w.y0, w.y1, part.width,
                     part.height);
}

}  // namespace twinray
