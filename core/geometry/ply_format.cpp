// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include <fmt/format.h>

#include "core/geometry/mesh_format.h"
#include "core/types/error.h"

// Turk, "The PLY Polygon File Format", 1994. Elements and properties that are not named below are
// read over.
namespace hydrabench {
namespace {

static_assert(std::endian::native == std::endian::little);

enum class Encoding { kAscii, kLittleEndian, kBigEndian };
enum class Type { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

struct Property {
  std::string name;
  Type type = Type::kFloat;
  bool is_list = false;
  Type count_type = Type::kUint8;
};
struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};
struct Header {
  Encoding encoding = Encoding::kAscii;
  std::vector<Element> elements;
};

std::size_t sizeOf(Type type) {
  constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

Type typeNamed(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Type>, 16> kNames = {{
      {"char", Type::kInt8},
      {"uchar", Type::kUint8},
      {"short", Type::kInt16},
      {"ushort", Type::kUint16},
      {"int", Type::kInt32},
      {"uint", Type::kUint32},
      {"float", Type::kFloat},
      {"double", Type::kDouble},
      {"int8", Type::kInt8},
      {"uint8", Type::kUint8},
      {"int16", Type::kInt16},
      {"uint16", Type::kUint16},
      {"int32", Type::kInt32},
      {"uint32", Type::kUint32},
      {"float32", Type::kFloat},
      {"float64", Type::kDouble},
  }};
  for (const auto& [known, type] : kNames) {
    if (known == name) return type;
  }
  throw InputError(
      fmt::format("header names the type '{}', expected a PLY type such as float", name));
}

/// Takes the next word; empty at the end.
std::string_view takeWord(std::string_view& text) {
  constexpr std::string_view kSpace = " \t\r\n\v\f";
  text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(kSpace));
  text.remove_prefix(word.size());
  return word;
}

std::string_view takeLine(std::string_view& text) {
  const std::size_t end = text.find('\n');
  if (end == text.npos) throw InputError("ends within its header, expected 'end_header'");
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end + 1);
  return line;
}

std::uint64_t parseCount(std::string_view word, std::string_view element) {
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
  if (error != std::errc() || end != word.data() + word.size()) {
    throw InputError(
        fmt::format("header states '{}' for element {}, expected a count", word, element));
  }
  return count;
}

Header takeHeader(std::string_view& text) {
  std::string_view magic = takeLine(text);
  if (takeWord(magic) != "ply") throw InputError("does not begin with 'ply'");
  Header header;
  bool has_format = false;
  while (true) {
    const std::string_view line = takeLine(text);
    std::string_view rest = line;
    const std::string_view keyword = takeWord(rest);
    if (keyword == "end_header") break;
    if (keyword == "comment" || keyword == "obj_info" || keyword.empty()) continue;
    if (keyword == "format") {
      const std::string_view name = takeWord(rest);
      if (name == "ascii")
        header.encoding = Encoding::kAscii;
      else if (name == "binary_little_endian")
        header.encoding = Encoding::kLittleEndian;
      else if (name == "binary_big_endian")
        header.encoding = Encoding::kBigEndian;
      else
        throw InputError(
            fmt::format("header names the format '{}', expected ascii or binary_*_endian", name));
      has_format = true;
    } else if (keyword == "element") {
      Element element;
      element.name = takeWord(rest);
      element.count = parseCount(takeWord(rest), element.name);
      header.elements.push_back(std::move(element));
    } else if (keyword == "property" && !header.elements.empty()) {
      Property property;
      std::string_view type = takeWord(rest);
      property.is_list = type == "list";
      if (property.is_list) {
        property.count_type = typeNamed(takeWord(rest));
        type = takeWord(rest);
      }
      property.type = typeNamed(type);
      property.name = takeWord(rest);
      header.elements.back().properties.push_back(std::move(property));
    } else {
      throw InputError(
          fmt::format("header has the line '{}', expected format, element, property or end_header",
                      line.substr(0, 60)));
    }
  }
  if (!has_format) throw InputError("header has no 'format' line");
  return header;
}

/// The numbers behind the header, one after the other.
class Body {
 public:
  Body(std::string_view text, Encoding encoding) : text_(text), encoding_(encoding) {}

  /// Throws unless `count` values of `type` can still follow. Guards every allocation against
  /// counts that are not true.
  void require(std::uint64_t count, std::size_t bytes_each, std::string_view what) const {
    if (bytes_each == 0 || count <= text_.size() / bytes_each) return;
    throw InputError(fmt::format("states {} {}, but the file has room for at most {}", count, what,
                                 text_.size() / bytes_each));
  }
  /// Fewest bytes a value takes: in text a digit and, but for the last one of the file, a space.
  std::size_t smallest(Type type) const { return encoding_ == Encoding::kAscii ? 1 : sizeOf(type); }

  double take(Type type) {
    if (encoding_ == Encoding::kAscii) {
      const double value = takeText();
      return type == Type::kFloat ? static_cast<double>(static_cast<float>(value)) : value;
    }
    switch (type) {
      case Type::kInt8:
        return takeBinary<std::int8_t>();
      case Type::kUint8:
        return takeBinary<std::uint8_t>();
      case Type::kInt16:
        return takeBinary<std::int16_t>();
      case Type::kUint16:
        return takeBinary<std::uint16_t>();
      case Type::kInt32:
        return takeBinary<std::int32_t>();
      case Type::kUint32:
        return takeBinary<std::uint32_t>();
      case Type::kFloat:
        return static_cast<double>(takeBinary<float>());
      case Type::kDouble:
        return takeBinary<double>();
    }
    return 0;
  }

 private:
  double takeText() {
    const std::string_view word = takeWord(text_);
    if (word.empty()) throw InputError("ends early");
    const std::optional<double> value = parseNumber(word);
    if (!value) throw InputError(fmt::format("has '{}', expected a number", word.substr(0, 40)));
    return *value;
  }
  template <typename Value>
  Value takeBinary() {
    if (text_.size() < sizeof(Value)) throw InputError("ends early");
    std::array<char, sizeof(Value)> bytes;
    std::memcpy(bytes.data(), text_.data(), sizeof(Value));
    if (encoding_ == Encoding::kBigEndian) std::reverse(bytes.begin(), bytes.end());
    text_.remove_prefix(sizeof(Value));
    return std::bit_cast<Value>(bytes);
  }

  std::string_view text_;
  Encoding encoding_;
};

/// What a scalar property of a vertex means to us: 0 to 2 a coordinate, 3 to 5 a colour channel, -1
/// nothing.
int slotOf(const Property& property) {
  constexpr std::array<std::string_view, 9> kNames = {
      "x", "y", "z", "red", "green", "blue", "diffuse_red", "diffuse_green", "diffuse_blue"};
  if (property.is_list) return -1;
  const auto found = std::find(kNames.begin(), kNames.end(), property.name);
  if (found == kNames.end()) return -1;
  const auto slot = static_cast<int>(found - kNames.begin());
  return slot < 6 ? slot : slot - 3;
}

std::uint8_t channelOf(double value, Type type) {
  if (!std::isfinite(value)) return 0;
  const bool is_fraction = type == Type::kFloat || type == Type::kDouble;
  return static_cast<std::uint8_t>(
      std::lround(std::clamp(is_fraction ? 255 * value : value, 0.0, 255.0)));
}

/// What rows are read into, kept from one to the next.
struct Row {
  std::vector<double> values;
  std::vector<int> corners;
};

/// Reads the list property of one row.
void takeList(const Property& property, Body& body, std::vector<double>& values) {
  const double count = body.take(property.count_type);
  if (!(count >= 0) || count != std::floor(count) || count > 0x1p52) {
    throw InputError(fmt::format("has a list of {} values", count));
  }
  body.require(static_cast<std::uint64_t>(count), body.smallest(property.type), "list values");
  values.clear();
  for (double i = 0; i < count; ++i) values.push_back(body.take(property.type));
}

void takeVertex(const Element& element, const std::vector<int>& slots, Body& body, Row& row,
                Mesh& mesh, bool has_colors) {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  std::array<std::uint8_t, 3> color = {};
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const Property& property = element.properties[i];
    if (property.is_list) {
      takeList(property, body, row.values);
      continue;
    }
    const double value = body.take(property.type);
    if (slots[i] >= 3)
      color[static_cast<std::size_t>(slots[i] - 3)] = channelOf(value, property.type);
    else if (slots[i] >= 0)
      position[slots[i]] = value;
  }
  mesh.vertices.push_back(position);
  if (has_colors) mesh.colors.push_back({color[0], color[1], color[2]});
}

void takeFace(const Element& element, Body& body, Row& row, Mesh& mesh) {
  std::vector<double>& values = row.values;
  std::vector<int>& corners = row.corners;
  corners.clear();
  for (const Property& property : element.properties) {
    if (!property.is_list) {
      body.take(property.type);
      continue;
    }
    takeList(property, body, values);
    if (property.name != "vertex_indices" && property.name != "vertex_index") continue;
    // Vertices come first in every PLY of practice; if not, readMesh looks at the range in the end.
    const bool has_range = !mesh.vertices.empty();
    const double limit =
        has_range ? static_cast<double>(mesh.vertices.size()) : std::numeric_limits<int>::max();
    for (const double value : values) {
      if (value != std::floor(value) || !(value >= 0 && value < limit)) {
        throw InputError(
            fmt::format("refers to vertex {}, expected 0 to {:.0f}", value, limit - 1));
      }
      corners.push_back(static_cast<int>(value));
    }
  }
  if (corners.size() < 3) {
    throw InputError(fmt::format("has {} corners, expected 3 or more", corners.size()));
  }
  addPolygon(corners, mesh);
}

void takeElement(const Element& element, Body& body, Mesh& mesh) {
  std::size_t row_size = 0;
  std::vector<int> slots;
  for (const Property& property : element.properties) {
    row_size += body.smallest(property.is_list ? property.count_type : property.type);
    slots.push_back(slotOf(property));
  }
  if (element.properties.empty() && element.count > 0) {
    throw InputError(fmt::format("header gives element {} no property", element.name));
  }
  body.require(element.count, row_size, fmt::format("rows of element {}", element.name));
  const bool is_vertex = element.name == "vertex";
  const bool is_face = element.name == "face";
  const auto has = [&](int slot) {
    return std::find(slots.begin(), slots.end(), slot) != slots.end();
  };
  const bool has_colors = has(3) && has(4) && has(5);
  if (is_vertex) {
    if (!has(0) || !has(1) || !has(2)) {
      throw InputError("header gives element vertex no x, y and z");
    }
    if (element.count > static_cast<std::uint64_t>(std::numeric_limits<int>::max())) {
      throw InputError(fmt::format("header states {} vertices, expected at most {}", element.count,
                                   std::numeric_limits<int>::max()));
    }
    mesh.vertices.reserve(element.count);
    if (has_colors) mesh.colors.reserve(element.count);
  } else if (is_face) {
    mesh.faces.reserve(element.count);
  }
  Row row;
  for (std::uint64_t i = 0; i < element.count; ++i) {
    try {
      if (is_vertex) {
        takeVertex(element, slots, body, row, mesh, has_colors);
      } else if (is_face) {
        takeFace(element, body, row, mesh);
      } else {
        for (const Property& property : element.properties) {
          if (property.is_list)
            takeList(property, body, row.values);
          else
            body.take(property.type);
        }
      }
    } catch (const InputError& error) {
      throw InputError(
          fmt::format("element {} row {} of {}: {}", element.name, i, element.count, error.what()));
    }
  }
}

template <typename Value>
void put(Value value, std::string& out) {
  out.append(reinterpret_cast<const char*>(&value), sizeof(Value));
}

}  // namespace

Mesh parsePly(std::string_view content) {
  const Header header = takeHeader(content);
  Body body(content, header.encoding);
  Mesh mesh;
  for (const Element& element : header.elements) takeElement(element, body, mesh);
  return mesh;
}

std::string formatPly(const Mesh& mesh) {
  const bool has_colors = !mesh.colors.empty() && mesh.colors.size() == mesh.vertices.size();
  std::string out = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\n"
      "property float x\nproperty float y\nproperty float z\n{}"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.vertices.size(),
      has_colors ? "property uchar red\nproperty uchar green\nproperty uchar blue\n" : "",
      mesh.faces.size());
  out.reserve(out.size() + 15 * mesh.vertices.size() + 13 * mesh.faces.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    for (const double coordinate : mesh.vertices[i]) put(static_cast<float>(coordinate), out);
    if (!has_colors) continue;
    put(mesh.colors[i].r, out);
    put(mesh.colors[i].g, out);
    put(mesh.colors[i].b, out);
  }
  for (const Eigen::Vector3i& face : mesh.faces) {
    put(std::uint8_t{3}, out);
    for (const int corner : face) put(static_cast<std::int32_t>(corner), out);
  }
  return out;
}

}  // namespace hydrabench
