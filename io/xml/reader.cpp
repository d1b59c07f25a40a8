// SPDX-License-Identifier: Apache-2.0
#include "io/xml/reader.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "io/byte_order_mark.h"
#include "io/input_file.h"
#include "io/lower_case.h"
#include "io/number_list.h"
#include "io/xml/lexer.h"
#include "io/xml/skeleton.h"

namespace twinray {
namespace {

constexpr std::size_t npos = std::string_view::npos;

Place whole_file(const std::string& file) {
  Place place;
  place.file = file;
  return place;
}

/// The format of bytes that are not text in UTF-8, by how they start; "" where they may be.
std::string other_format(std::string_view text) {
  const auto starts = [&](std::string_view bytes) { return text.substr(0, bytes.size()) == bytes; };
  if (starts(std::string_view("\xff\xfe\0\0", 4)) || starts(std::string_view("\0\0\xfe\xff", 4)))
    return "text in UTF-32";
  if (starts("\xff\xfe") || starts("\xfe\xff") || starts(std::string_view("<\0", 2)) ||
      starts(std::string_view("\0<", 2)))
    return "text in UTF-16";
  if (starts("\x1f\x8b")) return "compressed (gzip)";
  if (starts("PK\x03\x04")) return "a zip archive";
  return "";
}

/// Throws Error for bytes that are not text in UTF-8, as far as their start and zeros tell.
void check_encoding(const std::string& file, std::string_view text) {
  if (trimmed(text).empty()) throw error_at(whole_file(file), "the file is empty");
  if (const std::string format = other_format(text); !format.empty())
    throw error_at(whole_file(file), fmt::format("the file is {}; valid is XML in UTF-8", format));
  if (const std::size_t zero = text.find('\0'); zero != npos)
    throw error_at(whole_file(file), fmt::format("not XML in UTF-8: byte {} is zero", zero));
}

/// Whether the root element has a start, but no end.
bool is_cut_off(std::string_view text) {
  const std::size_t start = next_start_tag(text, 0);
  if (start == npos) return false;
  const std::string_view name = text.substr(start + 1, text.find_first_of(" \t\r\n/>", start) - start - 1);
  const std::string_view to_end_of_tag = text.substr(0, behind_tag(text, start));
  return text.rfind(fmt::format("</{}", name)) == npos && !to_end_of_tag.ends_with("/>");
}

std::size_t trimmed_end(std::string_view text) {
  const std::string_view inner = trimmed(text);
  return std::size_t(inner.data() - text.data()) + inner.size();
}

/// The element after this one in the order of their start tags.
tinyxml2::XMLElement* next_element(tinyxml2::XMLElement* element) {
  if (element->FirstChildElement()) return element->FirstChildElement();
  while (element && !element->NextSiblingElement())
    element = element->Parent() ? element->Parent()->ToElement() : nullptr;
  return element ? element->NextSiblingElement() : nullptr;
}

/// The part of a name before its colon; "" without one.
std::string_view prefix_of(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == npos ? "" : name.substr(0, colon);
}

/// The namespace that the root declares for its own name; "" where it does not.
std::string namespace_of(const tinyxml2::XMLElement& root) {
  const std::string_view prefix = prefix_of(root.Name());
  const char* found = root.Attribute(prefix.empty() ? "xmlns" : fmt::format("xmlns:{}", prefix).c_str());
  return found ? found : "";
}

/// The prefixes that stand for one namespace.
class Prefixes {
 public:
  explicit Prefixes(const std::string& name) : namespace_(name) {}

  /// To be called for each element, in the order of their start tags.
  void drop_prefix(tinyxml2::XMLElement& element) {
    for (auto* a = element.FirstAttribute(); a; a = a->Next()) {
      const std::string_view name = a->Name();
      if (name.rfind("xmlns:", 0) == 0 && namespace_ == a->Value()) prefixes_.emplace(name.substr(6));
    }
    const char* name = element.Name();
    const std::string_view prefix = prefix_of(name);
    // The new name is a part of the old one, which lives as long as the document.
    if (!prefix.empty() && prefixes_.count(prefix) > 0) element.SetName(name + prefix.size() + 1, true);
  }

 private:
  const std::string& namespace_;
  std::set<std::string, std::less<>> prefixes_;
};

void blank(std::string& text, std::size_t begin, std::size_t end) {
  std::fill(text.begin() + std::ptrdiff_t(begin), text.begin() + std::ptrdiff_t(end), ' ');
}

/// Comments and the brackets of CDATA sections become spaces, so that every offset stays.
void blank_markup(std::string& text) {
  std::size_t i = 0;
  while ((i = text.find('<', i)) != npos) {
    if (starts_at(text, i, "<![CDATA[")) {
      const std::size_t end = std::min(text.find("]]>", i), text.size());
      blank(text, i, i + 9);
      blank(text, end, std::min(end + 3, text.size()));
      i = end;
    } else if (starts_at(text, i, "<!--")) {
      const std::size_t end = behind(text, i, "-->");
      blank(text, i, end);
      i = end;
    } else {
      ++i;
    }
  }
}

/// References to white space, such as "&#13;", become spaces, as many as they have characters.
void blank_space_references(std::string& text) {
  constexpr std::size_t longest = 16;  // However many zeros it begins with; so the time stays linear.
  for (std::size_t i = text.find("&#"); i != npos; i = text.find("&#", i + 1)) {
    const std::size_t length = std::string_view(text).substr(i, longest).find(';');
    if (length == npos) continue;
    const std::size_t end = i + length;
    const bool is_hex = text[i + 2] == 'x';
    unsigned code = 0;
    const char *const digits = text.data() + i + (is_hex ? 3 : 2), *const behind_digits = text.data() + end;
    const auto [stop, error] = std::from_chars(digits, behind_digits, code, is_hex ? 16 : 10);
    const bool is_space = code == ' ' || code == '\t' || code == '\n' || code == '\r';
    if (error == std::errc{} && stop == behind_digits && is_space) blank(text, i, end + 1);
  }
}

/// What the element says before its first child, its references decoded.
std::string decoded_text(const tinyxml2::XMLElement& element) {
  std::string text;
  for (auto* node = element.FirstChild(); node && !node->ToElement(); node = node->NextSibling())
    text += node->ToText() ? node->Value() : " ";
  return text;
}

/// The end of the contents that start at `begin`: the next tag that is neither a comment nor CDATA.
std::size_t content_end(std::string_view text, std::size_t begin) {
  std::size_t i = begin;
  while ((i = text.find('<', i)) != npos) {
    if (starts_at(text, i, "<!--"))
      i = behind(text, i, "-->");
    else if (starts_at(text, i, "<![CDATA["))
      i = behind(text, i, "]]>");
    else
      return i;
  }
  return text.size();
}

}  // namespace

XmlDocument::XmlDocument(std::string text, std::string file)
    : text_(std::move(text)), file_(std::move(file)), document_(std::make_unique<tinyxml2::XMLDocument>()) {}

XmlDocument::~XmlDocument() = default;

std::unique_ptr<XmlDocument> XmlDocument::load(const std::string& path) {
  return parse(read_input_file(path, "scene file"), path);
}

std::unique_ptr<XmlDocument> XmlDocument::parse(std::string text, const std::string& name) {
  check_encoding(name, text);
  text.erase(0, mark_size(text));
  std::unique_ptr<XmlDocument> document(new XmlDocument(std::move(text), name));
  document->parse_elements();
  if (!document->document_->RootElement())
    throw error_at(whole_file(name), "not XML: there is no element in it");
  document->index_tags();
  return document;
}

void XmlDocument::parse_elements() {
  std::string skeleton = xml_skeleton(text_);
  const bool is_worth_it = skeleton.size() < text_.size() / 2;
  if (!is_worth_it) skeleton = {};  // at once: the parser makes a copy of its own
  const std::string_view text = is_worth_it ? skeleton : text_;
  if (document_->Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) fail_parse();
}

void XmlDocument::fail_parse() const {
  const int line = std::max(document_->ErrorLineNum(), 1);
  std::size_t offset = 0;
  for (int i = 1; i < line && offset < text_.size(); ++i) offset = behind(text_, offset, "\n");
  while (offset < text_.size() && (text_[offset] == ' ' || text_[offset] == '\t')) ++offset;
  const Place place = place_of(file_, text_, offset);
  switch (document_->ErrorID()) {
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      // tinyxml2 counts the document and the end tag of the innermost element, too.
      throw error_at(place, fmt::format("elements are nested more than {} deep, the most that is read",
                                        TINYXML2_MAX_ELEMENT_DEPTH - 2));
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      throw error_at(
          place, "not XML: an element that starts here or before it is not closed, or in the wrong order");
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      throw error_at(place, "not XML: an attribute of this element is not of the form name=\"value\"");
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      throw error_at(place, "not XML: a comment that starts here is not closed by -->");
    case tinyxml2::XML_ERROR_PARSING_CDATA:
      throw error_at(place, "not XML: a CDATA section that starts here is not closed by ]]>");
    default:
      if (is_cut_off(text_))
        throw error_at(place_of(file_, text_, trimmed_end(text_)),
                       "not XML: the file is cut off; its root element does not end");
      throw error_at(place, "not XML: what stands here is neither an element nor text within one");
  }
}

void XmlDocument::index_tags() {
  std::size_t offset = 0;
  root_namespace_ = namespace_of(*document_->RootElement());
  Prefixes prefixes(root_namespace_);
  for (tinyxml2::XMLElement* e = document_->RootElement(); e; e = next_element(e)) {
    offset = next_start_tag(text_, offset);
    if (offset == npos || !starts_at(text_, offset + 1, e->Name()))
      throw error_at(place_of(file_, text_, offset), "not XML: this tag cannot be read");
    e->SetUserData(reinterpret_cast<void*>(offset));
    offset = behind_tag(text_, offset);
    prefixes.drop_prefix(*e);
  }
}

std::string XmlDocument::foreign_encoding() const {
  const tinyxml2::XMLNode* first = document_->FirstChild();
  const auto* declaration = first ? first->ToDeclaration() : nullptr;
  const std::string_view text = declaration ? declaration->Value() : "";
  const std::size_t begin = text.find("encoding=");
  if (begin == npos || begin + 10 >= text.size()) return "";
  const std::size_t end = text.find(text[begin + 9], begin + 10);
  const std::string name(text.substr(begin + 10, end == npos ? end : end - begin - 10));
  const std::string lower = lower_case(name);
  const bool is_ascii = std::none_of(text_.begin(), text_.end(), [](char c) { return (c & 0x80) != 0; });
  return lower == "utf-8" || lower == "utf8" || is_ascii ? "" : name;
}

XmlElement XmlDocument::root() const { return XmlElement(*this, *document_->RootElement()); }

std::string XmlElement::name() const { return element_->Name(); }
bool XmlElement::is(std::string_view name) const { return name == element_->Name(); }

std::optional<XmlElement> XmlElement::parent() const {
  const auto* found = element_->Parent() ? element_->Parent()->ToElement() : nullptr;
  return found ? std::optional(XmlElement(*document_, *found)) : std::nullopt;
}

std::vector<XmlElement> XmlElement::children() const {
  std::vector<XmlElement> result;
  for (auto* e = element_->FirstChildElement(); e; e = e->NextSiblingElement())
    result.emplace_back(*document_, *e);
  return result;
}

std::vector<XmlElement> XmlElement::children(std::string_view name) const {
  std::vector<XmlElement> result;
  for (const XmlElement& e : children())
    if (e.is(name)) result.push_back(e);
  return result;
}

std::optional<XmlElement> XmlElement::child(std::string_view name) const {
  for (auto* e = element_->FirstChildElement(); e; e = e->NextSiblingElement())
    if (name == e->Name()) return XmlElement(*document_, *e);
  return std::nullopt;
}

XmlElement XmlElement::required_child(std::string_view wanted) const {
  if (const auto found = child(wanted)) return *found;
  fail(fmt::format("<{}> has no <{}>, which it needs", name(), wanted));
}

std::vector<std::string> XmlElement::attribute_names() const {
  std::vector<std::string> names;
  for (auto* a = element_->FirstAttribute(); a; a = a->Next()) names.emplace_back(a->Name());
  return names;
}

std::optional<std::string> XmlElement::attribute(const char* wanted) const {
  const char* value = element_->Attribute(wanted);
  return value ? std::optional<std::string>(value) : std::nullopt;
}

std::string XmlElement::required_attribute(const char* wanted) const {
  const auto value = attribute(wanted);
  if (!value) fail(fmt::format("<{}> has no attribute \"{}\", which it needs", name(), wanted));
  if (value->empty())
    throw error_at(attribute_place(wanted), fmt::format("the attribute \"{}\" is empty", wanted));
  return *value;
}

std::uint32_t XmlElement::index_attribute(const char* wanted, std::uint32_t fallback) const {
  return attribute(wanted) ? required_index_attribute(wanted) : fallback;
}

std::uint32_t XmlElement::required_index_attribute(const char* wanted) const {
  const std::string value = required_attribute(wanted);
  try {
    const auto numbers = parse_indices(value);
    if (numbers.size() == 1) return numbers[0];
    throw NumberError{0, fmt::format("the attribute \"{}\" must be one whole number", wanted)};
  } catch (const NumberError& error) {
    throw error_at(attribute_place(wanted), error.message);
  }
}

std::string XmlElement::text() const { return std::string(trimmed(decoded_text(*element_))); }

template <typename Parse>
auto XmlElement::parse_numbers(const Parse& parse) const {
  const Content all = content();
  try {
    return parse(all.text());
  } catch (const NumberError& error) {
    throw error_at(place_of(document_->file(), document_->text(), all.offset + error.offset), error.message);
  }
}

std::vector<double> XmlElement::doubles() const { return parse_numbers(parse_doubles); }
std::vector<float> XmlElement::floats() const { return parse_numbers(parse_floats); }
std::vector<float> XmlElement::floats_or_nan() const { return parse_numbers(parse_floats_or_nan); }
std::vector<std::uint32_t> XmlElement::indices() const { return parse_numbers(parse_indices); }

std::vector<double> XmlElement::doubles(std::size_t count) const {
  std::vector<double> values = doubles();
  if (values.size() != count)
    fail(fmt::format("<{}> needs {} number{}, and has {}", name(), count, count == 1 ? "" : "s",
                     values.size()));
  return values;
}

Place XmlElement::place() const { return place_of(document_->file(), document_->text(), offset()); }

Place XmlElement::attribute_place(std::string_view wanted) const {
  const std::string_view text = document_->text();
  const std::string_view tag = text.substr(offset(), behind_tag(text, offset()) - offset());
  std::size_t i = tag.find(wanted);
  const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
  while (i != npos &&
         !(i > 0 && is_space(tag[i - 1]) && tag.find_first_of("= \t\r\n", i) == i + wanted.size()))
    i = tag.find(wanted, i + 1);
  return i == npos ? place() : place_of(document_->file(), text, offset() + i);
}

Place XmlElement::number_place(std::size_t index) const {
  const Content all = content();
  return place_of(document_->file(), document_->text(), all.offset + token_offset(all.text(), index));
}

void XmlElement::fail(const std::string& message) const { throw error_at(place(), message); }

std::size_t XmlElement::offset() const { return reinterpret_cast<std::size_t>(element_->GetUserData()); }

XmlElement::Content XmlElement::content() const {
  const std::string_view text = document_->text();
  const std::size_t begin = behind_tag(text, offset());
  if (begin >= 2 && text[begin - 2] == '/') return {begin, {}, {}};
  Content result{begin, text.substr(begin, content_end(text, begin) - begin), {}};
  if (result.raw.find_first_of("<&") != npos) {
    result.blanked = result.raw;
    blank_markup(result.blanked);
    blank_space_references(result.blanked);
  }
  return result;
}

}  // namespace twinray
