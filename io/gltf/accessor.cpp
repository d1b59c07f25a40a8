// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/accessor.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "io/gltf/document.h"
#include "io/gltf/formats.h"

namespace twinray {
namespace {

static_assert(std::endian::native == std::endian::little, "a file's numbers are copied as they are");

/// Elements that no data stand for: zeros, as many as a small file may have.
constexpr std::size_t most_without_data = 4096;

struct Type {
  int code;
  const char* name;
  std::size_t components;
};
constexpr std::array<Type, 7> accessor_types{{{TINYGLTF_TYPE_SCALAR, "SCALAR", 1},
                                              {TINYGLTF_TYPE_VEC2, "VEC2", 2},
                                              {TINYGLTF_TYPE_VEC3, "VEC3", 3},
                                              {TINYGLTF_TYPE_VEC4, "VEC4", 4},
                                              {TINYGLTF_TYPE_MAT2, "MAT2", 4},
                                              {TINYGLTF_TYPE_MAT3, "MAT3", 9},
                                              {TINYGLTF_TYPE_MAT4, "MAT4", 16}}};

const Type& type_of(const tinygltf::Accessor& accessor) {
  return *std::find_if(accessor_types.begin(), accessor_types.end(),
                       [&](const Type& t) { return t.code == accessor.type; });
}

std::size_t component_bytes(int component_type) {
  if (component_type == TINYGLTF_COMPONENT_TYPE_BYTE ||
      component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE)
    return 1;
  if (component_type == TINYGLTF_COMPONENT_TYPE_SHORT ||
      component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT)
    return 2;
  return 4;
}

template <typename Number>
Number load(const char* at) {
  Number number;
  std::memcpy(&number, at, sizeof number);
  return number;
}

/// A whole number, or a float's bits.
std::uint32_t load_bits(const char* at, int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return std::uint32_t(load<std::int8_t>(at));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return load<std::uint8_t>(at);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return std::uint32_t(load<std::int16_t>(at));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load<std::uint16_t>(at);
    default:
      return load<std::uint32_t>(at);
  }
}

/// Of each kind of normalised integer the number that stands for 1 (section 3.11 of the specification).
float largest_of(int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return 127;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 255;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return 32767;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 65535;
    default:
      return 4294967295.0f;
  }
}

float number_of(std::uint32_t bits, const tinygltf::Accessor& accessor) {
  if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT) return std::bit_cast<float>(bits);
  const bool is_signed = accessor.componentType == TINYGLTF_COMPONENT_TYPE_BYTE ||
                         accessor.componentType == TINYGLTF_COMPONENT_TYPE_SHORT;
  const float number = is_signed ? float(std::int32_t(bits)) : float(bits);
  if (!accessor.normalized) return number;
  return std::max(number / largest_of(accessor.componentType), -1.0f);
}

/// Elements of a buffer view.
struct Span {
  std::string_view bytes;  ///< From the first element on.
  std::size_t stride = 0;

  const char* at(std::size_t row) const { return bytes.data() + row * stride; }
};

/// A run of elements that a buffer view must hold.
struct Extent {
  std::size_t view, offset, count, element_bytes;
  std::size_t component_bytes;
};

/// Numbers begin at multiples of their size. What was compressed begins where its view does.
void check_alignment(const GltfDocument& document, const Extent& extent, const std::string& pointer) {
  const tinygltf::BufferView& view = document.model().bufferViews[extent.view];
  const bool is_packed = view.extensions.count("EXT_meshopt_compression") > 0;
  const std::size_t begin = (is_packed ? 0 : view.byteOffset) + extent.offset;
  if (begin % extent.component_bytes != 0)
    document.context().fail(pointer,
                            fmt::format("the numbers begin at byte {} of the buffer (with the byteOffset of "
                                        "/bufferViews/{}); it must be a multiple of their {} bytes",
                                        begin, extent.view, extent.component_bytes));
}

Span span_of(GltfDocument& document, const Extent& extent, const std::string& pointer) {
  const tinygltf::BufferView& view = document.model().bufferViews[extent.view];
  const std::string_view bytes = document.buffer_view(extent.view);
  const std::size_t stride = view.byteStride > 0 ? view.byteStride : extent.element_bytes;
  if (stride < extent.element_bytes)
    document.context().fail(
        fmt::format("/bufferViews/{}/byteStride", extent.view),
        fmt::format("is {}, and {} has elements of {} bytes", stride, pointer, extent.element_bytes));
  const bool is_within = extent.offset <= bytes.size() &&
                         extent.element_bytes <= bytes.size() - extent.offset &&
                         (extent.count - 1) <= (bytes.size() - extent.offset - extent.element_bytes) / stride;
  if (!is_within)
    document.context().fail(
        pointer,
        fmt::format("{} elements of {} bytes, {} apart, from byte {} on reach beyond the {} bytes of "
                    "/bufferViews/{}",
                    extent.count, extent.element_bytes, stride, extent.offset, bytes.size(), extent.view));
  check_alignment(document, extent, pointer);
  return {bytes.substr(extent.offset), stride};
}

/// Gives each component's bits to take(row, component, bits).
template <typename Take>
class ComponentReader {
 public:
  ComponentReader(GltfDocument& document, int index, const Take& take)
      : document_(document),
        accessor_(document.model().accessors[std::size_t(index)]),
        pointer_(accessor_pointer(index)),
        components_(type_of(accessor_).components),
        bytes_(component_bytes(accessor_.componentType)),
        take_(take) {}

  void read() {
    if (accessor_.bufferView >= 0) read_all();
    if (accessor_.sparse.isSparse) read_sparse();
  }

 private:
  std::size_t element_bytes() const { return components_ * bytes_; }

  void take_row(std::size_t row, const char* at) {
    for (std::size_t c = 0; c < components_; ++c)
      take_(row, c, load_bits(at + c * bytes_, accessor_.componentType));
  }

  void read_all() {
    const Span span = span_of(
        document_,
        {std::size_t(accessor_.bufferView), accessor_.byteOffset, accessor_.count, element_bytes(), bytes_},
        pointer_);
    for (std::size_t row = 0; row < accessor_.count; ++row) take_row(row, span.at(row));
  }

  void read_sparse() {
    const auto& sparse = accessor_.sparse;
    const auto count = std::size_t(sparse.count);
    if (count > accessor_.count)
      document_.context().fail(pointer_ + "/sparse/count",
                               fmt::format("{} elements of {} are replaced", count, accessor_.count));
    const Span indices = span_of(
        document_,
        {std::size_t(sparse.indices.bufferView), std::size_t(sparse.indices.byteOffset), count,
         component_bytes(sparse.indices.componentType), component_bytes(sparse.indices.componentType)},
        pointer_ + "/sparse/indices");
    const Span values = span_of(document_,
                                {std::size_t(sparse.values.bufferView), std::size_t(sparse.values.byteOffset),
                                 count, element_bytes(), bytes_},
                                pointer_ + "/sparse/values");
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t row = load_bits(indices.at(i), sparse.indices.componentType);
      if (row >= accessor_.count)
        document_.context().fail(pointer_ + "/sparse/indices",
                                 fmt::format("the index {} (number {}) is out of range; valid are 0 to {}",
                                             row, i, accessor_.count - 1));
      take_row(row, values.at(i));
    }
  }

  GltfDocument& document_;
  const tinygltf::Accessor& accessor_;
  std::string pointer_;
  std::size_t components_, bytes_;
  const Take& take_;
};

/// Throws Error where the accessor has more elements than data may stand for, or these are not there.
void check_data(GltfDocument& document, int index) {
  const tinygltf::Accessor& accessor = document.model().accessors[std::size_t(index)];
  const std::size_t most = document.byte_count() + most_without_data;
  if (accessor.bufferView < 0 && accessor.count > most)
    document.context().fail(
        accessor_pointer(index) + "/count",
        fmt::format("{} zeros without a buffer view; at most {} are read here", accessor.count, most));
  if (accessor.bufferView >= 0)  // Before memory is taken.
    span_of(document,
            {std::size_t(accessor.bufferView), accessor.byteOffset, accessor.count,
             type_of(accessor).components * component_bytes(accessor.componentType),
             component_bytes(accessor.componentType)},
            accessor_pointer(index));
}

bool has_word(std::string_view words, std::string_view word) {
  return fmt::format(" {} ", words).find(fmt::format(" {} ", word)) != std::string::npos;
}

void require_type(const GltfDocument& document, int index, std::string_view wanted) {
  const char* name = type_of(document.model().accessors[std::size_t(index)]).name;
  if (!has_word(wanted, name))
    document.context().fail(accessor_pointer(index),
                            fmt::format("the type is {}; what names this accessor takes {}", name, wanted));
}

/// As formats have it.
std::string component_of(const tinygltf::Accessor& accessor) {
  const bool is_float = accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
  return fmt::format("{}{}", accessor.componentType, accessor.normalized && !is_float ? "n" : "");
}

/// "5126, 5121 normalized and 5123 normalized" of a format's components.
std::string describe(std::string_view components) {
  std::vector<std::string> words;
  while (!components.empty()) {
    const std::size_t space = std::min(components.find(' '), components.size());
    const std::string_view word = components.substr(0, space);
    words.push_back(word.ends_with('n') ? fmt::format("{} normalized", word.substr(0, word.size() - 1))
                                        : std::string(word));
    components.remove_prefix(std::min(space + 1, components.size()));
  }
  const std::string last = words.back();
  words.pop_back();
  return words.empty() ? last : fmt::format("{} and {}", fmt::join(words, ", "), last);
}

bool uses(const GltfDocument& document, std::string_view extension) {
  const auto& used = document.model().extensionsUsed;
  return std::find(used.begin(), used.end(), extension) != used.end();
}

}  // namespace

std::string accessor_pointer(int accessor) { return fmt::format("/accessors/{}", accessor); }

void require_format(const GltfDocument& document, int index, const GltfFormat& format) {
  const tinygltf::Accessor& accessor = document.model().accessors[std::size_t(index)];
  require_type(document, index, format.types);
  const std::string own = component_of(accessor);
  if (has_word(format.components, own)) return;
  const bool is_quantized = uses(document, "KHR_mesh_quantization");
  if (is_quantized && has_word(format.quantized, own)) return;
  std::string valid = describe(format.components);
  if (!format.quantized.empty())
    valid += fmt::format("{}{}", is_quantized ? ", and " : "; with KHR_mesh_quantization also ",
                         describe(format.quantized));
  document.context().fail(
      accessor_pointer(index) + "/componentType",
      fmt::format("this is {}; valid for {} {} {}", describe(own), format.use,
                  format.components.find(' ') == std::string_view::npos ? "is" : "are", valid));
}

void require_finite(const GltfDocument& document, int index, const GltfFormat& format,
                    const GltfNumbers& numbers) {
  if (!format.is_finite) return;
  const auto found = std::find_if(numbers.values.begin(), numbers.values.end(),
                                  [](float number) { return !std::isfinite(number); });
  if (found == numbers.values.end()) return;
  document.context().fail(
      accessor_pointer(index),
      fmt::format("element {} holds {}; {} must be finite",
                  std::size_t(found - numbers.values.begin()) / numbers.components, *found, format.use));
}

float accessor_number(std::uint32_t bits, const GltfDocument& document, int accessor) {
  const tinygltf::Accessor& described = document.model().accessors[std::size_t(accessor)];
  const bool is_float = described.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
  return is_float ? float(std::int32_t(bits)) : number_of(bits, described);
}

std::size_t accessor_count(const GltfDocument& document, int accessor) {
  return document.model().accessors[std::size_t(accessor)].count;
}

GltfNumbers read_numbers(GltfDocument& document, int index, const GltfFormat& format) {
  require_format(document, index, format);
  check_data(document, index);
  const tinygltf::Accessor& accessor = document.model().accessors[std::size_t(index)];
  GltfNumbers numbers{accessor.count, type_of(accessor).components, {}};
  numbers.values.resize(numbers.count * numbers.components);
  const auto take = [&](std::size_t row, std::size_t component, std::uint32_t bits) {
    numbers.values[row * numbers.components + component] = number_of(bits, accessor);
  };
  ComponentReader(document, index, take).read();
  require_finite(document, index, format, numbers);
  return numbers;
}

std::vector<std::uint32_t> read_indices(GltfDocument& document, int index) {
  require_type(document, index, "SCALAR");
  const tinygltf::Accessor& accessor = document.model().accessors[std::size_t(index)];
  const int type = accessor.componentType;
  if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
      type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
    document.context().fail(accessor_pointer(index) + "/componentType",
                            fmt::format("this is {}; valid for indices are 5121, 5123 and 5125", type));
  check_data(document, index);
  std::vector<std::uint32_t> integers(accessor.count);
  const auto take = [&](std::size_t row, std::size_t, std::uint32_t bits) { integers[row] = bits; };
  ComponentReader(document, index, take).read();
  return integers;
}

std::uint32_t largest_index(const GltfDocument& document, int index) {
  const int type = document.model().accessors[std::size_t(index)].componentType;
  return std::uint32_t((1ull << (8 * component_bytes(type))) - 1);
}

}  // namespace twinray
