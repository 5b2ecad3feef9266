// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/io/safetensors.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstring>
#include <limits>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "core/io/atomic_file.h"
#include "core/io/json_field.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

using Json = nlohmann::json;

static_assert(std::endian::native == std::endian::little, "the numbers are copied as they stand");

constexpr std::size_t kLengthBytes = 8;
constexpr const char* kMetadata = "__metadata__";

struct TypeEntry {
  TensorType type;
  std::string_view name;
  std::size_t bytes;
};
constexpr std::array kTypes = {
    TypeEntry{TensorType::kF64, "F64", 8}, TypeEntry{TensorType::kF32, "F32", 4},
    TypeEntry{TensorType::kF16, "F16", 2}, TypeEntry{TensorType::kBf16, "BF16", 2},
    TypeEntry{TensorType::kI64, "I64", 8}, TypeEntry{TensorType::kI32, "I32", 4},
    TypeEntry{TensorType::kU8, "U8", 1},   TypeEntry{TensorType::kBool, "BOOL", 1},
};

const TypeEntry& entryOf(TensorType type) {
  const auto it = std::ranges::find(kTypes, type, &TypeEntry::type);
  assert(it != kTypes.end());
  return *it;
}

/// Bytes of a tensor; nullopt where the shape is negative or the product overflows.
std::optional<std::uint64_t> byteCount(TensorType type, std::span<const std::int64_t> shape) {
  std::uint64_t count = bytesPerNumber(type);
  for (const std::int64_t extent : shape) {
    if (extent < 0) return std::nullopt;
    if (__builtin_mul_overflow(count, static_cast<std::uint64_t>(extent), &count)) {
      return std::nullopt;
    }
  }
  return count;
}

/// The header as JSON. A plain parse would keep the last of two equal names.
Json parseHeader(const std::string& file, std::string_view text) {
  std::set<std::string> names;
  std::string duplicate;
  const Json::parser_callback_t watch = [&](int depth, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::key && depth == 1 &&
        !names.insert(parsed.get<std::string>()).second) {
      duplicate = parsed.get<std::string>();
    }
    return true;
  };
  Json header;
  try {
    header = Json::parse(text, watch);
  } catch (const Json::exception&) {
    throw InputError(fmt::format("{}: the header is not JSON: expected a safetensors file", file));
  }
  if (!duplicate.empty()) {
    throw InputError(fmt::format("{}: {}: the tensor stands twice", file, duplicate));
  }
  return header;
}

StoredTensor readTensor(const JsonField& field, std::string_view data, std::uint64_t& begin) {
  StoredTensor tensor;
  const std::string dtype = field.at("dtype").text();
  const auto type = std::ranges::find(kTypes, dtype, &TypeEntry::name);
  if (type == kTypes.end()) field.at("dtype").fail("F64, F32, F16, BF16, I64, I32, U8 or BOOL");
  tensor.type = type->type;
  const JsonField shape = field.at("shape");
  for (std::size_t i = 0; i < shape.size(); ++i) tensor.shape.push_back(shape.item(i).integer());
  const auto expected = byteCount(tensor.type, tensor.shape);
  if (!expected) shape.complain(shapeText(tensor.shape) + ": no such shape");

  const JsonField offsets = field.at("data_offsets");
  if (offsets.size() != 2) offsets.fail("two offsets");
  begin = offsets.item(0).unsignedInteger();
  const std::uint64_t end = offsets.item(1).unsignedInteger();
  if (begin > end || end > data.size()) {
    offsets.complain(fmt::format("[{}, {}]: expected within the {} bytes that the file holds",
                                 begin, end, data.size()));
  }
  if (end - begin != *expected) {
    offsets.complain(fmt::format("{} bytes, expected {} for {} of shape {}", end - begin, *expected,
                                 dtype, shapeText(tensor.shape)));
  }
  tensor.bytes = std::as_bytes(std::span(data.data() + begin, end - begin));
  return tensor;
}

}  // namespace

std::string_view nameOf(TensorType type) { return entryOf(type).name; }

std::size_t bytesPerNumber(TensorType type) { return entryOf(type).bytes; }

std::string shapeText(std::span<const std::int64_t> shape) {
  return fmt::format("[{}]", fmt::join(shape, ", "));
}

SafetensorsFile SafetensorsFile::read(const std::filesystem::path& path) {
  SafetensorsFile file;
  file.path_ = path;
  file.content_ = std::make_unique<const std::string>(readFile(path));
  const std::string_view content = *file.content_;
  const std::string name = path.string();

  std::uint64_t length = 0;
  if (content.size() >= kLengthBytes) std::memcpy(&length, content.data(), kLengthBytes);
  if (content.size() < kLengthBytes || length > content.size() - kLengthBytes) {
    throw InputError(fmt::format(
        "{}: the header takes {} bytes, the file has {}: truncated, or no safetensors file", name,
        length, content.size()));
  }
  const Json header = parseHeader(name, content.substr(kLengthBytes, length));
  if (!header.is_object()) JsonField(header, name).fail("an object of tensors");
  const std::string_view data = content.substr(kLengthBytes + length);

  std::vector<std::pair<std::uint64_t, const std::string*>> order;  // where each tensor begins
  for (const auto& [key, value] : header.items()) {
    const JsonField field(value, fmt::format("{}: {}", name, key));
    if (key == kMetadata) {
      if (!value.is_object()) field.fail("an object of texts");
      for (const auto& [entry, text] : value.items()) {
        file.metadata_[entry] = field.at(entry.c_str()).text();
      }
      continue;
    }
    std::uint64_t begin = 0;
    const auto it = file.tensors_.emplace(key, readTensor(field, data, begin)).first;
    order.emplace_back(begin, &it->first);
  }

  // Every byte belongs to one tensor. Empty tensors come before the one that begins with them.
  std::ranges::sort(order, [&](const auto& a, const auto& b) {
    const std::size_t size_a = file.tensors_.at(*a.second).bytes.size();
    const std::size_t size_b = file.tensors_.at(*b.second).bytes.size();
    return std::tie(a.first, size_a, *a.second) < std::tie(b.first, size_b, *b.second);
  });
  std::uint64_t end = 0;
  for (const auto& [begin, tensor] : order) {
    if (begin != end) {
      throw InputError(fmt::format("{}: {}: data_offsets begin at {}, expected {}: {}", name,
                                   *tensor, begin, end,
                                   begin < end ? "tensors overlap" : "bytes without a tensor"));
    }
    end = begin + file.tensors_.at(*tensor).bytes.size();
  }
  if (end != data.size()) {
    throw InputError(
        fmt::format("{}: the tensors take {} bytes, the file holds {}", name, end, data.size()));
  }
  return file;
}

void writeSafetensors(const std::filesystem::path& path,
                      const std::map<std::string, StoredTensor>& tensors,
                      const std::map<std::string, std::string>& metadata) {
  nlohmann::ordered_json header = nlohmann::ordered_json::object();
  if (!metadata.empty()) header[kMetadata] = metadata;
  std::uint64_t offset = 0;
  for (const auto& [name, tensor] : tensors) {
    assert(byteCount(tensor.type, tensor.shape) == tensor.bytes.size());
    const std::uint64_t end = offset + tensor.bytes.size();
    header[name] = {
        {"dtype", nameOf(tensor.type)}, {"shape", tensor.shape}, {"data_offsets", {offset, end}}};
    offset = end;
  }
  std::string text = header.dump();
  text.resize((text.size() + 7) / 8 * 8, ' ');  // the numbers begin at a multiple of eight

  const std::uint64_t length = text.size();
  std::string content(kLengthBytes, '\0');
  std::memcpy(content.data(), &length, kLengthBytes);
  content.reserve(kLengthBytes + text.size() + offset);
  content += text;
  for (const auto& [name, tensor] : tensors) {
    content.append(reinterpret_cast<const char*>(tensor.bytes.data()), tensor.bytes.size());
  }
  writeFileAtomic(path, content);
}

}  // namespace hydrabench
