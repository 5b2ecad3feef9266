// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/content_hash.h"

#include <algorithm>
#include <openssl/evp.h>
#include <vector>

#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/types/error.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

/// Files at or below `path` in a fixed order, with their names from there.
std::vector<std::pair<std::string, fs::path>> filesBelow(const fs::path& path) {
  std::vector<std::pair<std::string, fs::path>> files;
  if (fs::is_regular_file(path)) {
    files.emplace_back(path.filename().string(), path);
  } else if (fs::is_directory(path)) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path)) {
      if (!entry.is_regular_file()) continue;
      files.emplace_back(entry.path().lexically_relative(path).generic_string(), entry.path());
    }
    std::sort(files.begin(), files.end());
  } else {
    throw InputError(fmt::format("{}: no such file or folder", path.string()));
  }
  return files;
}

}  // namespace

struct ContentHash::Digest {
  EVP_MD_CTX* context = EVP_MD_CTX_new();
  ~Digest() { EVP_MD_CTX_free(context); }
};

ContentHash::ContentHash() : digest_(std::make_unique<Digest>()) {
  EVP_DigestInit_ex(digest_->context, EVP_sha256(), nullptr);
}
ContentHash::~ContentHash() = default;

ContentHash& ContentHash::add(std::string_view field) {
  const std::string size = fmt::format("{}:", field.size());
  EVP_DigestUpdate(digest_->context, size.data(), size.size());
  EVP_DigestUpdate(digest_->context, field.data(), field.size());
  return *this;
}

ContentHash& ContentHash::addContent(const fs::path& path) {
  for (const auto& [name, file] : filesBelow(path)) add(name).add(readFile(file));
  return *this;
}

ContentHash& ContentHash::addStamp(const fs::path& path) {
  for (const auto& [name, file] : filesBelow(path)) {
    const auto changed = fs::last_write_time(file).time_since_epoch().count();
    add(name).add(fmt::format("{} {}", fs::file_size(file), changed));
  }
  return *this;
}

std::string ContentHash::hex() {
  unsigned char bytes[EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  EVP_DigestFinal_ex(digest_->context, bytes, &size);
  std::string text;
  for (unsigned int i = 0; i < size; ++i) text += fmt::format("{:02x}", bytes[i]);
  return text;
}

const std::string& programHash() {
  static const std::string hash = ContentHash().add(readFile("/proc/self/exe")).hex();
  return hash;
}

}  // namespace hydrabench
