// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/io/safetensors.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A file with this header and this many bytes of numbers.
std::string fileText(const std::string& header, std::size_t bytes) {
  const std::uint64_t length = header.size();
  std::string text(8, '\0');
  std::memcpy(text.data(), &length, 8);
  return text + header + std::string(bytes, '\0');
}

std::string complaint(const std::string& header, std::size_t bytes) {
  const TemporaryFolder folder;
  writeText(folder / "w.safetensors", fileText(header, bytes));
  const std::string message =
      messageOf<InputError>([&] { SafetensorsFile::read(folder / "w.safetensors"); });
  EXPECT_THAT(message, StartsWith((folder / "w.safetensors").string()));
  EXPECT_EQ(message.find('\n'), std::string::npos);
  return message;
}

template <typename Number>
StoredTensor store(TensorType type, std::vector<std::int64_t> shape,
                   const std::vector<Number>& numbers) {
  return {type, std::move(shape), std::as_bytes(std::span(numbers))};
}

template <typename Number>
std::vector<Number> numbersOf(const StoredTensor& tensor) {
  std::vector<Number> numbers(tensor.bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), tensor.bytes.data(), tensor.bytes.size());
  return numbers;
}

TEST(Safetensors, ComesBackAsItWasWritten) {
  const TemporaryFolder folder;
  const std::vector<float> floats = {1.5f, -2, 3, 4, 5, 6};
  const std::vector<std::uint16_t> halves = {0x3c00, 0xc000, 0x7bff};
  const std::vector<std::int64_t> longs = {-7};
  writeSafetensors(folder / "a.safetensors",
                   {{"a.weight", store(TensorType::kF32, {2, 3}, floats)},
                    {"b", store(TensorType::kF16, {3}, halves)},
                    {"c", store(TensorType::kBf16, {3, 1}, halves)},
                    {"count", store(TensorType::kI64, {}, longs)},
                    {"empty", store(TensorType::kF32, {0, 4}, std::vector<float>())}},
                   {{"licence", "MIT"}});
  const SafetensorsFile file = SafetensorsFile::read(folder / "a.safetensors");
  ASSERT_EQ(file.tensors().size(), 5u);
  EXPECT_EQ(file.metadata().at("licence"), "MIT");
  EXPECT_THAT(file.tensors().at("a.weight").shape, ElementsAre(2, 3));
  EXPECT_EQ(numbersOf<float>(file.tensors().at("a.weight")), floats);
  EXPECT_EQ(file.tensors().at("b").type, TensorType::kF16);
  EXPECT_EQ(numbersOf<std::uint16_t>(file.tensors().at("c")), halves);
  EXPECT_TRUE(file.tensors().at("count").shape.empty());
  EXPECT_EQ(numbersOf<std::int64_t>(file.tensors().at("count")), longs);
  EXPECT_THAT(file.tensors().at("empty").shape, ElementsAre(0, 4));
}

TEST(Safetensors, HasTheBytesOfTheLayout) {
  const TemporaryFolder folder;
  const std::vector<std::uint8_t> numbers = {7, 9};
  writeSafetensors(folder / "a", {{"x", store(TensorType::kU8, {2}, numbers)}});
  const std::string header = R"({"x":{"dtype":"U8","shape":[2],"data_offsets":[0,2]}})";
  EXPECT_EQ(header.size(), 53u);  // padded to 56
  EXPECT_EQ(readText(folder / "a"),
            std::string("\x38\0\0\0\0\0\0\0", 8) + header + "   " + "\x07\x09");
}

TEST(Safetensors, ReadsTensorsThatStandInAnotherOrder) {
  const TemporaryFolder folder;
  std::string text = fileText(R"({"a":{"dtype":"U8","shape":[1],"data_offsets":[1,2]},)"
                              R"("b":{"dtype":"U8","shape":[1],"data_offsets":[0,1]}})",
                              0);
  writeText(folder / "a", text + "bA");
  const SafetensorsFile file = SafetensorsFile::read(folder / "a");
  EXPECT_EQ(numbersOf<char>(file.tensors().at("a")), std::vector<char>{'A'});
  EXPECT_EQ(numbersOf<char>(file.tensors().at("b")), std::vector<char>{'b'});
}

TEST(Safetensors, MissingFileIsNamed) {
  EXPECT_THAT(messageOf<InputError>([] { SafetensorsFile::read("/no/such/w.safetensors"); }),
              HasSubstr("/no/such/w.safetensors"));
}

TEST(Safetensors, FileCutShortIsRefused) {
  const TemporaryFolder folder;
  const std::string header = R"({"x":{"dtype":"F32","shape":[2],"data_offsets":[0,8]}})";
  const std::string text = fileText(header, 8);
  for (std::size_t size = 0; size < text.size(); ++size) {
    writeText(folder / "w", std::string_view(text).substr(0, size));
    const std::string message = messageOf<InputError>([&] { SafetensorsFile::read(folder / "w"); });
    EXPECT_THAT(message, StartsWith((folder / "w").string())) << size;
  }
  EXPECT_THAT(
      complaint(header, 7),
      EndsWith(": x.data_offsets: [0, 8]: expected within the 7 bytes that the file holds"));
}

TEST(Safetensors, WhatDoesNotFitIsRefusedWithTheTensorsName) {
  const std::string x = R"("x":{"dtype":"F32","shape":[2],"data_offsets":[0,8]})";
  EXPECT_THAT(complaint("{" + x + "}", 12),
              EndsWith(": the tensors take 8 bytes, the file holds 12"));
  EXPECT_THAT(complaint("{" + x + "," + x + "}", 8), EndsWith(": x: the tensor stands twice"));
  EXPECT_THAT(complaint("{" + x + R"(,"y":{"dtype":"F32","shape":[1],"data_offsets":[4,8]}})", 8),
              EndsWith(": y: data_offsets begin at 4, expected 8: tensors overlap"));
  EXPECT_THAT(
      complaint("{" + x + R"(,"y":{"dtype":"F32","shape":[1],"data_offsets":[12,16]}})", 16),
      EndsWith(": y: data_offsets begin at 12, expected 8: bytes without a tensor"));
  EXPECT_THAT(complaint(R"({"x":{"dtype":"F32","shape":[3],"data_offsets":[0,8]}})", 8),
              EndsWith(": x.data_offsets: 8 bytes, expected 12 for F32 of shape [3]"));
  EXPECT_THAT(complaint(R"({"x":{"dtype":"F8","shape":[8],"data_offsets":[0,8]}})", 8),
              HasSubstr(": x.dtype: expected F64, F32, F16, BF16"));
  EXPECT_THAT(complaint(R"({"x":{"dtype":"F32","shape":[-2],"data_offsets":[0,8]}})", 8),
              EndsWith(": x.shape: [-2]: no such shape"));
  EXPECT_THAT(
      complaint(R"({"x":{"dtype":"F32","shape":[4611686018427387904,4],"data_offsets":[0,0]}})", 0),
      EndsWith("no such shape"));
  EXPECT_THAT(complaint(R"({"x":{"dtype":"F32","shape":[2],"data_offsets":[8,0]}})", 8),
              HasSubstr(": x.data_offsets: [8, 0]: expected within"));
  EXPECT_THAT(complaint(R"({"x":{"dtype":"F32","shape":[2]}})", 8),
              EndsWith(": x.data_offsets: missing"));
  EXPECT_THAT(complaint(R"({"__metadata__":{"a":1}})", 0),
              HasSubstr(": __metadata__.a: expected a string"));
  EXPECT_THAT(complaint("no json", 0), EndsWith("expected a safetensors file"));
  EXPECT_THAT(complaint("[]", 0), HasSubstr("expected an object of tensors"));
}

}  // namespace
}  // namespace hydrabench
