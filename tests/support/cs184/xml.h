// SPDX-License-Identifier: Apache-2.0
// XML in as few lines as CS184's files need: for the reference, which uses nothing of the project.
#pragma once
#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace twinray::test::cs184 {

struct Element {
  std::string name, text;
  std::map<std::string, std::string> attributes;
  std::vector<std::unique_ptr<Element>> children;

  const Element* child(const std::string& wanted) const {
    for (const auto& each : children)
      if (each->name == wanted) return each.get();
    return nullptr;
  }
  const Element* at(std::initializer_list<const char*> path) const {
    const Element* here = this;
    for (const char* step : path) here = here ? here->child(step) : nullptr;
    return here;
  }
};

/// A document; its text must outlive it.
class Xml {
 public:
  explicit Xml(const std::string& text) : text_(text) {
    document_ = std::make_unique<Element>();
    read_content(*document_);
  }
  const Element& root() const { return *document_->child("COLLADA"); }

 private:
  bool starts(const char* mark) const {
    return text_.compare(at_, std::char_traits<char>::length(mark), mark) == 0;
  }
  void skip_past(const char* mark) { at_ = text_.find(mark, at_) + std::char_traits<char>::length(mark); }

  void read_content(Element& parent) {
    while (at_ < text_.size() && !starts("</")) {
      if (starts("<!--")) {
        skip_past("-->");
      } else if (starts("<?")) {
        skip_past("?>");
      } else if (text_[at_] == '<') {
        read_element(parent);
      } else {
        const std::size_t end = std::min(text_.find('<', at_), text_.size());
        parent.text.append(text_, at_, end - at_);
        at_ = end;
      }
    }
  }

  void read_element(Element& parent) {
    const std::size_t end = text_.find('>', at_);
    if (end == std::string::npos) throw std::runtime_error("a tag has no end");
    std::string tag = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    const bool is_empty = tag.back() == '/';
    if (is_empty) tag.pop_back();
    Element& element = *parent.children.emplace_back(std::make_unique<Element>());
    const std::size_t name_end = std::min(tag.find_first_of(" \t\r\n"), tag.size());
    element.name = tag.substr(0, name_end);
    read_attributes(tag.substr(name_end), element);
    if (is_empty) return;
    read_content(element);
    skip_past(">");
  }

  static void read_attributes(const std::string& text, Element& element) {
    for (std::size_t at = 0; (at = text.find('=', at)) != std::string::npos;) {
      const std::size_t begin = text.find_last_of(" \t\r\n", at) + 1;
      const std::size_t quote = text.find_first_of("\"'", at), close = text.find(text[quote], quote + 1);
      element.attributes[text.substr(begin, at - begin)] = text.substr(quote + 1, close - quote - 1);
      at = close + 1;
    }
  }

  const std::string& text_;
  std::size_t at_ = 0;
  std::unique_ptr<Element> document_;
};

inline std::vector<double> numbers(const Element& element) {
  std::vector<double> result;
  const char* at = element.text.c_str();
  for (char* end = nullptr;; at = end) {
    const double value = std::strtod(at, &end);
    if (end == at) return result;
    result.push_back(value);
  }
}

}  // namespace twinray::test::cs184
