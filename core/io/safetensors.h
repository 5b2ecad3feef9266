// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hydrabench {

/// Numbers a tensor file can hold.
enum class TensorType { kF64, kF32, kF16, kBf16, kI64, kI32, kU8, kBool };

std::string_view nameOf(TensorType type);  ///< as in the file: "F32", "BF16", ...
std::size_t bytesPerNumber(TensorType type);
std::string shapeText(std::span<const std::int64_t> shape);  ///< "[384, 3, 14, 14]"

/// Numbers in row order, little-endian. Does not own its bytes.
struct StoredTensor {
  TensorType type = TensorType::kF32;
  std::vector<std::int64_t> shape;  ///< empty: one number
  std::span<const std::byte> bytes;
};

/// A file in the safetensors layout (Hugging Face, safetensors 0.x): u64 length of a JSON header,
/// the header {name: {dtype, shape, data_offsets}, __metadata__}, then the numbers.
class SafetensorsFile {
 public:
  /// Throws InputError in one line (file, tensor, value, expected) for whatever does not fit: a
  /// file cut short or too long, bytes that overlap or belong to no tensor, a size that is not that
  /// of the shape, an unknown type, a name that stands twice.
  static SafetensorsFile read(const std::filesystem::path& path);

  const std::map<std::string, StoredTensor>& tensors() const { return tensors_; }
  const std::map<std::string, std::string>& metadata() const { return metadata_; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::unique_ptr<const std::string> content_;
  std::map<std::string, StoredTensor> tensors_;
  std::map<std::string, std::string> metadata_;
};

/// The same input gives the same bytes. Throws OutputError.
void writeSafetensors(const std::filesystem::path& path,
                      const std::map<std::string, StoredTensor>& tensors,
                      const std::map<std::string, std::string>& metadata = {});

}  // namespace hydrabench
