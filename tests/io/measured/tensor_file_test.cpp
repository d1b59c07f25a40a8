// SPDX-License-Identifier: Apache-2.0
#include "io/measured/tensor_file.h"

#include <cstring>

#include "tests/support/catch.h"
#include "tests/support/error_text.h"
#include "tests/support/text.h"

namespace twinray::test {
namespace {

std::string some_tensors() {
  TensorFileWriter file;
  file.add("grid", {2, 3}, {1, 2, 3, 4, 5, 6});
  file.add("flag", std::string_view("\1", 1));
  return file.bytes();
}

std::string tensor_error(const std::string& bytes) {
  return error_text([&] { TensorFile(bytes, "a.bsdf"); });
}

/// With a number in place of that at an offset.
template <typename T>
std::string with_number(std::string bytes, std::size_t offset, T number) {
  std::memcpy(bytes.data() + offset, &number, sizeof number);
  return bytes;
}

/// Of "grid", the first field: behind the header, where its parts begin.
constexpr std::size_t length_at = 18, dimensions_at = length_at + 2 + 4, type_at = dimensions_at + 2,
                      offset_at = type_at + 1, shape_at = offset_at + 8;

}  // namespace

TEST_CASE("a tensor file has the fields that were written") {
  const std::string bytes = some_tensors();
  const TensorFile file(bytes, "a.bsdf");
  CHECK(file.has("grid"));
  CHECK_FALSE(file.has("rgb"));
  CHECK(file.shape("grid", 2) == TensorFile::Shape{2, 3});
  CHECK(file.floats("grid") == std::vector<float>{1, 2, 3, 4, 5, 6});
  CHECK(file.byte("flag") == 1);
}

TEST_CASE("the layout of a tensor file is that of the measured materials") {
  // Header, version, one field: name, dimensions, type (1 is a byte), where it begins, its shape; the byte.
  TensorFileWriter file;
  file.add("ab", std::string_view("x", 1));
  CHECK(file.bytes() ==
        std::string("tensor_file\0\1\0\1\0\0\0\2\0ab\1\0\1\x29\0\0\0\0\0\0\0\1\0\0\0\0\0\0\0x", 42));
}

TEST_CASE("what is not as asked is named") {
  const std::string bytes = some_tensors();
  const TensorFile file(bytes, "a.bsdf");
  CHECK(error_text([&] { file.shape("grid", 3); }) ==
        "a.bsdf: the field \"grid\" has 2 dimensions; it needs 3");
  CHECK(error_text([&] { file.floats("rgb"); }) == "a.bsdf: the field \"rgb\" is missing");
  CHECK(error_text([&] { file.floats("flag"); }) ==
        "a.bsdf: the field \"flag\" must have numbers of the type float, of 32 bits");
  CHECK(error_text([&] { file.byte("grid"); }) == "a.bsdf: the field \"grid\" must be one byte");
  const std::string empty = with_number(bytes, shape_at, std::uint64_t(0));
  CHECK(error_text([&] { TensorFile(empty, "a.bsdf").shape("grid", 2); }) ==
        "a.bsdf: the field \"grid\" is empty");
}

TEST_CASE("a tensor file that cannot be is refused with what is wrong") {
  const std::string bytes = some_tensors();
  CHECK(tensor_error("") == "a.bsdf: is not a tensor file, as measured materials are");
  CHECK(tensor_error("NanoVDB0 and so on") == "a.bsdf: is not a tensor file, as measured materials are");
  CHECK(tensor_error(with_number(bytes, 12, std::uint8_t(2))) ==
        "a.bsdf: is a tensor file of version 2.0; only version 1.0 is read");
  CHECK(tensor_error(bytes.substr(0, 14)) == "a.bsdf: the tensor file is cut off in its header");
  CHECK(tensor_error(bytes.substr(0, 30)) == "a.bsdf: the tensor file is cut off in its list of fields");
  CHECK(tensor_error(bytes.substr(0, bytes.size() - 1)) ==
        "a.bsdf: the field \"flag\" reaches beyond the end of the file");
  CHECK(tensor_error(with_number(bytes, type_at, std::uint8_t(12))) ==
        "a.bsdf: the field \"grid\" has no type 12");
  CHECK(tensor_error(with_number(bytes, type_at, std::uint8_t(0))) ==
        "a.bsdf: the field \"grid\" has no type 0");
  CHECK(tensor_error(with_number(bytes, dimensions_at, std::uint16_t(17))) ==
        "a.bsdf: the field \"grid\" has 17 dimensions; at most 16 are read");
  CHECK(tensor_error(with_number(bytes, offset_at, std::uint64_t(1) << 63)) ==
        "a.bsdf: the field \"grid\" reaches beyond the end of the file");
  CHECK(tensor_error(with_number(bytes, offset_at, std::uint64_t(0) - 8)) ==
        "a.bsdf: the field \"grid\" reaches beyond the end of the file");
  // Sizes whose product overflows, too.
  for (const std::uint64_t size : {std::uint64_t(1) << 62, std::uint64_t(1000)})
    CHECK(contains(tensor_error(with_number(bytes, shape_at, size)), "numbers is larger than the file"));
  CHECK(tensor_error(with_number(bytes, 14, std::uint32_t(0xffffffff))).starts_with("a.bsdf: "));
  std::string twice = bytes;
  twice.replace(twice.find("flag"), 4, "grid");
  CHECK(tensor_error(twice) == "a.bsdf: the field \"grid\" is there twice");
}

TEST_CASE("a tensor file that is cut off anywhere is refused") {
  const std::string bytes = some_tensors();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    CAPTURE(size);
    CHECK(tensor_error(bytes.substr(0, size)) != "");
  }
}

}  // namespace twinray::test
