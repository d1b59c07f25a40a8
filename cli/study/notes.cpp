// SPDX-License-Identifier: Apache-2.0
#include "cli/study/notes.h"

#include <cmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>

#include "core/error.h"
#include "io/html/picture_address.h"
#include "io/input_file.h"

namespace twinray::study {
namespace {

/// Of the headings within a section: parts have the second level.
constexpr int least_level = 3, most_level = 6;

constexpr int markdown_options = CMARK_OPT_SMART | CMARK_OPT_VALIDATE_UTF8;

struct FreeNode {
  void operator()(cmark_node* node) const { cmark_node_free(node); }
};
using Node = std::unique_ptr<cmark_node, FreeNode>;
struct FreeIterator {
  void operator()(cmark_iter* iterator) const { cmark_iter_free(iterator); }
};

/// Calls `visit` for every node below and including this one, as it is entered.
template <class Visit>
void for_each_node(cmark_node* root, const Visit& visit) {
  const std::unique_ptr<cmark_iter, FreeIterator> iterator(cmark_iter_new(root));
  for (cmark_event_type event = cmark_iter_next(iterator.get()); event != CMARK_EVENT_DONE;
       event = cmark_iter_next(iterator.get()))
    if (event == CMARK_EVENT_ENTER) visit(cmark_iter_get_node(iterator.get()));
}

std::string text_of(cmark_node* node) {
  std::string text;
  for_each_node(node, [&](cmark_node* part) {
    const cmark_node_type type = cmark_node_get_type(part);
    if (type == CMARK_NODE_TEXT || type == CMARK_NODE_CODE) text += cmark_node_get_literal(part);
  });
  return text;
}

/// 3 of "Part 3: direct light"; nothing of any other text.
std::optional<int> part_number(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  if (!text.starts_with("part ")) return std::nullopt;
  int number = 0;
  const std::errc error = std::from_chars(text.data() + 5, text.data() + text.size(), number).ec;
  if (error == std::errc::invalid_argument) return std::nullopt;
  return error == std::errc() ? number : std::numeric_limits<int>::max();
}

/// "my%20picture.png" -> "my picture.png".
std::string without_percent(std::string_view address) {
  std::string path;
  for (std::size_t i = 0; i < address.size(); ++i) {
    unsigned code = 0;
    const char* const digits = address.data() + i + 1;
    if (address[i] == '%' && i + 2 < address.size() &&
        std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
      path += char(code);
      i += 2;
    } else {
      path += address[i];
    }
  }
  return path;
}

/// The file's words, taken apart.
class Sections {
 public:
  explicit Sections(const std::string& path) : path_(path), document_(parse(path)) {
    for_each_node(document_.get(), [&](cmark_node* node) { prepare(node); });
    cmark_node* next = nullptr;
    for (cmark_node* node = cmark_node_first_child(document_.get()); node; node = next) {
      next = cmark_node_next(node);
      if (!opens_section(node)) place(node);
    }
  }

  Notes html() const {
    Notes notes{html_of(head_.get()), {}, html_of(end_.get()), warnings_};
    for (std::size_t i = 0; i < parts_.size(); ++i) notes.parts[i] = html_of(parts_[i].get());
    return notes;
  }

 private:
  static Node parse(const std::string& path) {
    const std::string text = read_input_file(path, "Markdown file");
    return Node(cmark_parse_document(text.data(), text.size(), markdown_options));
  }
  static Node empty_document() { return Node(cmark_node_new(CMARK_NODE_DOCUMENT)); }
  static std::string html_of(cmark_node* document) {
    const std::unique_ptr<char, decltype(&std::free)> html(cmark_render_html(document, markdown_options),
                                                           &std::free);
    return html.get();
  }
  std::string place_of(cmark_node* node) const {
    while (node && cmark_node_get_start_line(node) == 0) node = cmark_node_parent(node);
    return fmt::format("{}:{}", path_, node ? cmark_node_get_start_line(node) : 1);
  }

  /// Makes pictures part of the page, and says what will be left out.
  void prepare(cmark_node* node) {
    const cmark_node_type type = cmark_node_get_type(node);
    if (type == CMARK_NODE_HTML_BLOCK || type == CMARK_NODE_HTML_INLINE) {
      const std::string_view literal = cmark_node_get_literal(node);
      if (!literal.starts_with("<!--"))
        warnings_.push_back(fmt::format("{}: HTML is left out; Markdown alone is read", place_of(node)));
    } else if (type == CMARK_NODE_IMAGE) {
      embed(node);
    }
  }
  void embed(cmark_node* image) {
    const std::string address = cmark_node_get_url(image);
    if (address.starts_with("data:")) return;
    if (address.find("://") != address.npos || address.starts_with("//"))
      throw Error(
          fmt::format("{}: the page must be whole by itself, so it shows no picture of another place: "
                      "{}; save it beside this file and write its name",
                      place_of(image), address));
    const auto file = std::filesystem::path(path_).parent_path() / without_percent(address);
    try {
      cmark_node_set_url(image, html::picture_address(file.string()).c_str());
    } catch (const Error& error) {
      throw Error(fmt::format("{}: {}", place_of(image), error.what()));
    }
  }

  /// Whether the node is the heading of a part; what follows then goes there.
  bool opens_section(cmark_node* node) {
    if (cmark_node_get_type(node) != CMARK_NODE_HEADING) return false;
    const int level = cmark_node_get_heading_level(node);
    const std::optional<int> number = part_number(text_of(node));
    if (!number) {
      if (part_level_ > 0 && level <= part_level_) current_ = end_.get();
      return false;
    }
    if (*number < 1 || *number > int(parts_.size()))
      throw Error(
          fmt::format("{}: there is no part {}; valid are 1 to {}", place_of(node), *number, parts_.size()));
    part_level_ = level;
    current_ = parts_[std::size_t(*number - 1)].get();
    return true;
  }
  void place(cmark_node* node) {
    if (cmark_node_get_type(node) == CMARK_NODE_HEADING) {
      const int deeper = cmark_node_get_heading_level(node) + 2 - std::max(1, part_level_);
      cmark_node_set_heading_level(node, std::clamp(deeper, least_level, most_level));
    }
    cmark_node_unlink(node);
    cmark_node_append_child(current_, node);
  }

  std::string path_;
  Node document_, head_ = empty_document(), end_ = empty_document();
  std::array<Node, 5> parts_{empty_document(), empty_document(), empty_document(), empty_document(),
                             empty_document()};
  cmark_node* current_ = head_.get();
  int part_level_ = 0;  ///< Of the last heading of a part; 0: none yet.
  std::vector<std::string> warnings_;
};

}  // namespace

Notes read_notes(const std::string& path) { return Sections(path).html(); }

}  // namespace twinray::study
