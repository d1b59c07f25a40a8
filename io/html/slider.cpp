// SPDX-License-Identifier: Apache-2.0
#include "io/html/slider.h"

#include <fmt/format.h>

#include "io/html/page.h"

namespace twinray::html {
namespace {

/// A picture of fewer pixels is enlarged where it fills a column of the page.
constexpr int small_width = 800;

std::string image(const Picture& picture, const std::string& more) {
  return fmt::format("<img class=\"{}{}\" alt=\"{}\" src=\"{}\">", picture.width < small_width ? "fine" : "",
                     more, escaped(picture.caption), picture.address);
}

}  // namespace

std::string slider(const Picture& left, const Picture& right) {
  return fmt::format(
      "<figure class=\"slider\"><figcaption><span>{}</span><span>{}</span></figcaption>"
      "<div class=\"pair\">{}{}<i></i><input type=\"range\" min=\"0\" max=\"100\" step=\"0.1\" value=\"50\" "
      "aria-label=\"where one picture ends and the other begins\" "
      "oninput=\"this.parentNode.style.setProperty('--at', this.value + '%')\"/></div></figure>\n",
      escaped(left.caption), escaped(right.caption), image(right, ""), image(left, " left"));
}

}  // namespace twinray::html
