// SPDX-License-Identifier: Apache-2.0
// The one door to tinyxml2. It parses; places, texts and numbers are taken from the file's own bytes, because
// tinyxml2 knows only lines, and its numbers accept "1,5", "nan" and "1e400".
//
// After parsing, the text is scanned once more for start tags. They come in the order of the elements, so
// each element learns the offset of its tag, from which lines, columns and contents follow. Names in the
// namespace of the root lose their prefix then: <c:node> is <node>; others keep theirs.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/diagnostic.h"

namespace tinyxml2 {
class XMLDocument;
class XMLElement;
}  // namespace tinyxml2

namespace twinray {

class XmlDocument;

/// An element of a document, a small value; the document must live as long.
class XmlElement {
 public:
  XmlElement(const XmlDocument& document, const tinyxml2::XMLElement& element)
      : document_(&document), element_(&element) {}

  std::string name() const;
  bool is(std::string_view name) const;

  const XmlDocument& document() const { return *document_; }
  /// Nothing for the root.
  std::optional<XmlElement> parent() const;
  std::vector<XmlElement> children() const;
  std::vector<XmlElement> children(std::string_view name) const;
  /// The first child of this name.
  std::optional<XmlElement> child(std::string_view name) const;
  /// Throws Error where there is none.
  XmlElement required_child(std::string_view name) const;

  std::vector<std::string> attribute_names() const;
  std::optional<std::string> attribute(const char* name) const;
  /// Throws Error where there is none, or it is empty.
  std::string required_attribute(const char* name) const;
  /// A count or an offset; `fallback` where the attribute is missing. Throws Error for anything but [0, 2^32
  /// - 1].
  std::uint32_t index_attribute(const char* name, std::uint32_t fallback) const;
  std::uint32_t required_index_attribute(const char* name) const;

  /// The text within the element, without white space at its ends.
  std::string text() const;
  /// The numbers within the element (io/number_list.h says which are valid). Throws Error at the place of the
  /// token.
  std::vector<double> doubles() const;
  std::vector<float> floats() const;
  /// NaN for numbers that are not finite.
  std::vector<float> floats_or_nan() const;
  std::vector<std::uint32_t> indices() const;
  /// The same, where there must be `count` of them.
  std::vector<double> doubles(std::size_t count) const;
  double number() const { return doubles(1)[0]; }

  Place place() const;
  Place attribute_place(std::string_view name) const;
  /// The place of the number with this index.
  Place number_place(std::size_t index) const;
  /// Throws the error with this element's place.
  [[noreturn]] void fail(const std::string& message) const;

  /// The same element of the same document.
  friend bool operator==(const XmlElement& a, const XmlElement& b) { return a.element_ == b.element_; }
  /// Some order, for lookups; within a document that of the start tags.
  friend bool operator<(const XmlElement& a, const XmlElement& b) {
    return a.document_ != b.document_ ? std::less<>()(a.document_, b.document_) : a.offset() < b.offset();
  }

 private:
  /// What stands between an element's start tag and its next one.
  struct Content {
    std::size_t offset;
    std::string_view raw;
    std::string blanked;  ///< Where there is markup in it: the same without.
    std::string_view text() const { return blanked.empty() ? raw : blanked; }
  };
  std::size_t offset() const;
  Content content() const;
  template <typename Parse>
  auto parse_numbers(const Parse& parse) const;

  const XmlDocument* document_;
  const tinyxml2::XMLElement* element_;
};

/// A parsed XML file. It is neither copied nor moved: its elements point to it.
class XmlDocument {
 public:
  /// Reads a file. Throws Error where it does not exist, is a directory, is empty, has more than
  /// max_input_bytes (io/input_file.h), or is not XML in UTF-8 (with or without a byte order mark).
  static std::unique_ptr<XmlDocument> load(const std::string& path);
  /// Parses a text; `name` stands for the file in messages.
  static std::unique_ptr<XmlDocument> parse(std::string text, const std::string& name);

  ~XmlDocument();
  XmlDocument(const XmlDocument&) = delete;
  XmlDocument& operator=(const XmlDocument&) = delete;

  XmlElement root() const;
  /// The namespace of the root; "" where it declares none.
  const std::string& root_namespace() const { return root_namespace_; }
  /// The encoding that the file declares, where it is not UTF-8 and a letter beyond ASCII occurs; else "".
  std::string foreign_encoding() const;
  const std::string& file() const { return file_; }
  const std::string& text() const { return text_; }

 private:
  XmlDocument(std::string text, std::string file);
  void parse_elements();
  [[noreturn]] void fail_parse() const;
  void index_tags();

  std::string text_;
  std::string file_;
  std::string root_namespace_;
  std::unique_ptr<tinyxml2::XMLDocument> document_;
};

}  // namespace twinray
