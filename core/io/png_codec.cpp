// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/io/png_codec.h"

#include <bit>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>
#include <vector>
#include <zlib.h>

#include <fmt/format.h>
#include <png.h>

#include "core/types/error.h"

namespace hydrabench {
namespace {

// libpng leaves a function by longjmp when something is wrong, which skips destructors. So every
// function that calls setjmp below holds plain values only and returns whether it went well; memory
// is owned one level up.

struct Message {
  char text[200] = {};
};

void onError(png_structp png, png_const_charp text) {
  auto* message = static_cast<Message*>(png_get_error_ptr(png));
  std::snprintf(message->text, sizeof(message->text), "%s", text);
  png_longjmp(png, 1);
}
void onWarning(png_structp, png_const_charp) {}  // e.g. a foreign colour profile

// ---- reading

struct Source {
  const char* data = nullptr;
  std::size_t left = 0;
};

void onRead(png_structp png, png_bytep target, std::size_t count) {
  auto* source = static_cast<Source*>(png_get_io_ptr(png));
  if (count > source->left) png_error(png, "the file ends early");
  std::memcpy(target, source->data, count);
  source->data += count;
  source->left -= count;
}

struct Header {
  png_uint_32 width = 0;
  png_uint_32 height = 0;
  int bit_depth = 0;
  int color_type = 0;
};

class PngReader {
 public:
  PngReader(std::string_view bytes, std::string name)
      : name_(std::move(name)), size_(bytes.size()), source_{bytes.data(), bytes.size()} {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &message_, onError, onWarning);
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
    if (!info_) throw std::bad_alloc();
    png_set_read_fn(png_, &source_, onRead);
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  Header header() {
    Header header;
    if (!readHeader(png_, info_, &header)) fail();
    // Deflate shrinks by at most 1032, so that a header cannot make us allocate without bound.
    const double most = 1032.0 * static_cast<double>(size_) * 8;
    const double bits = static_cast<double>(header.width) * header.height * header.bit_depth;
    if (bits > most) {
      throw InputError(
          fmt::format("{}: PNG header claims {} x {} pixels, but the file has {} bytes", name_,
                      header.width, header.height, size_));
    }
    return header;
  }

  void rows(bool to_rgb, std::uint8_t* pixels, std::size_t row_bytes,
            std::vector<png_bytep>& row_pointers) {
    for (std::size_t v = 0; v < row_pointers.size(); ++v) row_pointers[v] = pixels + v * row_bytes;
    if (!readRows(png_, info_, to_rgb, row_bytes, row_pointers.data())) fail();
  }

 private:
  static bool readHeader(png_structp png, png_infop info, Header* header) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_read_info(png, info);
    png_get_IHDR(png, info, &header->width, &header->height, &header->bit_depth,
                 &header->color_type, nullptr, nullptr, nullptr);
    return true;
  }

  static bool readRows(png_structp png, png_infop info, bool to_rgb, std::size_t row_bytes,
                       png_bytepp row_pointers) {
    if (setjmp(png_jmpbuf(png))) return false;
    if (to_rgb) {
      png_set_expand(png);  // palettes and 1, 2, 4 bit to 8 bit
      png_set_scale_16(png);
      png_set_strip_alpha(png);
      png_set_gray_to_rgb(png);
    } else if constexpr (std::endian::native == std::endian::little) {
      png_set_swap(png);  // PNG stores 16 bit big-endian
    }
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    if (png_get_rowbytes(png, info) != row_bytes) png_error(png, "unexpected pixel layout");
    png_read_image(png, row_pointers);
    png_read_end(png, nullptr);
    return true;
  }

  [[noreturn]] void fail() const {
    throw InputError(fmt::format("{}: broken or truncated PNG: {}", name_, message_.text));
  }

  std::string name_;
  std::size_t size_;
  Source source_;
  Message message_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

// ---- writing

void onWrite(png_structp png, png_bytep data, std::size_t count) {
  auto* sink = static_cast<std::string*>(png_get_io_ptr(png));
  bool stored = true;
  try {
    sink->append(reinterpret_cast<const char*>(data), count);
  } catch (const std::bad_alloc&) {
    stored = false;  // leave the handler before longjmp
  }
  if (!stored) png_error(png, "out of memory");
}
void onFlush(png_structp) {}

struct Layout {
  int width;
  int height;
  int bit_depth;
  int color_type;
  int filter;
  std::size_t row_bytes;
};

bool writeAll(png_structp png, png_infop info, const Layout* layout, const std::uint8_t* pixels) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_IHDR(png, info, static_cast<png_uint_32>(layout->width),
               static_cast<png_uint_32>(layout->height), layout->bit_depth, layout->color_type,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  // The fastest level and one fixed filter: adaptive filtering costs more than it saves.
  png_set_compression_level(png, 1);
  png_set_compression_strategy(png, Z_DEFAULT_STRATEGY);
  png_set_compression_buffer_size(png, 1 << 16);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, layout->filter);
  png_write_info(png, info);
  if (layout->bit_depth == 16 && std::endian::native == std::endian::little) png_set_swap(png);
  for (int v = 0; v < layout->height; ++v) {
    png_write_row(png, pixels + static_cast<std::size_t>(v) * layout->row_bytes);
  }
  png_write_end(png, nullptr);
  return true;
}

std::string encode(const Layout& layout, const void* pixels) {
  std::string bytes;
  bytes.reserve(layout.row_bytes * static_cast<std::size_t>(layout.height) / 2 + 1024);
  Message message;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, onError, onWarning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (!info) throw std::bad_alloc();
  png_set_write_fn(png, &bytes, onWrite, onFlush);
  const bool written = writeAll(png, info, &layout, static_cast<const std::uint8_t*>(pixels));
  png_destroy_write_struct(&png, &info);
  if (!written) throw std::runtime_error(fmt::format("PNG encoder: {}", message.text));
  return bytes;
}

template <typename Pixel>
Layout layoutOf(const Image<Pixel>& image, int bit_depth, int color_type, int filter) {
  const auto row_bytes = static_cast<std::size_t>(image.width()) * sizeof(Pixel);
  return {image.width(), image.height(), bit_depth, color_type, filter, row_bytes};
}

}  // namespace

bool isPng(std::string_view bytes) { return bytes.starts_with("\x89PNG\r\n\x1a\n"); }

Image<Rgb> decodeColorPng(std::string_view bytes, const std::string& name) {
  static_assert(sizeof(Rgb) == 3);
  PngReader reader(bytes, name);
  const Header header = reader.header();
  Image<Rgb> image(static_cast<int>(header.width), static_cast<int>(header.height));
  std::vector<png_bytep> row_pointers(header.height);
  reader.rows(true, reinterpret_cast<std::uint8_t*>(image.data()), header.width * sizeof(Rgb),
              row_pointers);
  return image;
}

Image<std::uint16_t> decodeGrayPng(std::string_view bytes, const std::string& name) {
  PngReader reader(bytes, name);
  const Header header = reader.header();
  if (header.color_type != PNG_COLOR_TYPE_GRAY || header.bit_depth < 8) {
    const int channels = header.color_type == PNG_COLOR_TYPE_GRAY         ? 1
                         : header.color_type == PNG_COLOR_TYPE_GRAY_ALPHA ? 2
                         : header.color_type == PNG_COLOR_TYPE_RGB_ALPHA  ? 4
                                                                          : 3;
    throw InputError(fmt::format(
        "{}: PNG has {}{} channel(s) of {} bit, expected one grey channel of 8 or 16 bit", name,
        header.color_type == PNG_COLOR_TYPE_PALETTE ? "a palette of " : "", channels,
        header.bit_depth));
  }
  Image<std::uint16_t> image(static_cast<int>(header.width), static_cast<int>(header.height));
  std::vector<png_bytep> row_pointers(header.height);
  if (header.bit_depth == 16) {
    reader.rows(false, reinterpret_cast<std::uint8_t*>(image.data()),
                header.width * sizeof(std::uint16_t), row_pointers);
  } else {
    Image<std::uint8_t> narrow(image.width(), image.height());
    reader.rows(false, narrow.data(), header.width, row_pointers);
    std::copy(narrow.begin(), narrow.end(), image.begin());
  }
  return image;
}

std::string encodePng(const Image<Rgb>& image) {
  return encode(layoutOf(image, 8, PNG_COLOR_TYPE_RGB, PNG_FILTER_SUB), image.data());
}
std::string encodePng(const Image<std::uint8_t>& image) {
  return encode(layoutOf(image, 8, PNG_COLOR_TYPE_GRAY, PNG_FILTER_NONE), image.data());
}
std::string encodePng(const Image<std::uint16_t>& image) {
  return encode(layoutOf(image, 16, PNG_COLOR_TYPE_GRAY, PNG_FILTER_NONE), image.data());
}

}  // namespace hydrabench
