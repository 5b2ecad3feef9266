// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/io/jpeg_codec.h"

#include <csetjmp>
#include <cstdio>  // jpeglib.h needs FILE and size_t
#include <cstdlib>

#include <jpeglib.h>
// After jpeglib.h, which it depends on.
#include <jerror.h>

#include <fmt/format.h>

#include "core/types/error.h"

namespace hydrabench {
namespace {

struct ErrorHandler {
  jpeg_error_mgr base;  // first: libjpeg hands out a pointer to it
  std::jmp_buf target;
  char text[JMSG_LENGTH_MAX];
};

[[noreturn]] void onError(j_common_ptr state) {
  auto* handler = reinterpret_cast<ErrorHandler*>(state->err);
  handler->base.format_message(state, handler->text);
  std::longjmp(handler->target, 1);
}

void onMessage(j_common_ptr state, int level) {
  // libjpeg fills what is missing from a truncated file with grey and merely warns; here that is a
  // fault.
  const int code = state->err->msg_code;
  if (level < 0 && (code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER)) onError(state);
}

// longjmp skips destructors: the functions below hold plain values only.

bool readHeader(jpeg_decompress_struct* jpeg, ErrorHandler* handler, std::string_view bytes) {
  if (setjmp(handler->target)) return false;
  jpeg_create_decompress(jpeg);
  jpeg_mem_src(jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(jpeg, TRUE);
  jpeg->out_color_space = JCS_RGB;
  jpeg_start_decompress(jpeg);
  return true;
}

bool readRows(jpeg_decompress_struct* jpeg, ErrorHandler* handler, unsigned char* pixels,
              std::size_t row_bytes) {
  if (setjmp(handler->target)) return false;
  while (jpeg->output_scanline < jpeg->output_height) {
    JSAMPROW row = pixels + jpeg->output_scanline * row_bytes;
    jpeg_read_scanlines(jpeg, &row, 1);
  }
  jpeg_finish_decompress(jpeg);
  return true;
}

bool writeRows(jpeg_compress_struct* jpeg, ErrorHandler* handler, const unsigned char* pixels,
               std::size_t row_bytes, int quality, unsigned char** bytes, unsigned long* size) {
  if (setjmp(handler->target)) return false;
  jpeg_mem_dest(jpeg, bytes, size);
  jpeg_set_defaults(jpeg);
  jpeg_set_quality(jpeg, quality, TRUE);
  jpeg->optimize_coding = TRUE;
  jpeg_start_compress(jpeg, TRUE);
  while (jpeg->next_scanline < jpeg->image_height) {
    // libjpeg reads the rows only; its type says otherwise.
    JSAMPROW row = const_cast<unsigned char*>(pixels) + jpeg->next_scanline * row_bytes;
    jpeg_write_scanlines(jpeg, &row, 1);
  }
  jpeg_finish_compress(jpeg);
  return true;
}

struct Decoder {
  Decoder() {
    jpeg.err = jpeg_std_error(&handler.base);
    handler.base.error_exit = onError;
    handler.base.emit_message = onMessage;
  }
  ~Decoder() { jpeg_destroy_decompress(&jpeg); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  jpeg_decompress_struct jpeg{};
  ErrorHandler handler{};
};

struct Encoder {
  explicit Encoder(const Image<Rgb>& image) {
    jpeg.err = jpeg_std_error(&handler.base);
    handler.base.error_exit = onError;
    jpeg_create_compress(&jpeg);
    jpeg.image_width = static_cast<JDIMENSION>(image.width());
    jpeg.image_height = static_cast<JDIMENSION>(image.height());
    jpeg.input_components = 3;
    jpeg.in_color_space = JCS_RGB;
  }
  ~Encoder() {
    jpeg_destroy_compress(&jpeg);
    std::free(bytes);
  }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  jpeg_compress_struct jpeg{};
  ErrorHandler handler{};
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
};

}  // namespace

bool isJpeg(std::string_view bytes) { return bytes.starts_with("\xff\xd8\xff"); }

Image<Rgb> decodeJpeg(std::string_view bytes, const std::string& name) {
  Decoder decoder;
  const auto fail = [&] {
    throw InputError(fmt::format("{}: broken or truncated JPEG: {}", name, decoder.handler.text));
  };
  if (!readHeader(&decoder.jpeg, &decoder.handler, bytes)) fail();
  Image<Rgb> image(static_cast<int>(decoder.jpeg.output_width),
                   static_cast<int>(decoder.jpeg.output_height));
  if (!readRows(&decoder.jpeg, &decoder.handler, reinterpret_cast<unsigned char*>(image.data()),
                static_cast<std::size_t>(image.width()) * sizeof(Rgb))) {
    fail();
  }
  return image;
}

std::string encodeJpeg(const Image<Rgb>& image, int quality) {
  static_assert(sizeof(Rgb) == 3);
  Encoder encoder(image);
  if (!writeRows(&encoder.jpeg, &encoder.handler,
                 reinterpret_cast<const unsigned char*>(image.data()),
                 static_cast<std::size_t>(image.width()) * sizeof(Rgb), quality, &encoder.bytes,
                 &encoder.size)) {
    throw OutputError(fmt::format("JPEG: {}", encoder.handler.text));
  }
  return {reinterpret_cast<const char*>(encoder.bytes), encoder.size};
}

}  // namespace hydrabench
