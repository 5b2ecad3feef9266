// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/html/view_cuts.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/io/jpeg_codec.h"
#include "core/io/png_codec.h"
#include "core/parallel/parallel_for.h"
#include "eval/view/rejection_picture.h"

namespace hydrabench {
namespace {

constexpr int kJpegQuality = 78;
constexpr int kBitStep = 16;  // four bits fill the range of a grey pixel: any decoder keeps them

/// Two rows of a table that differ in the verdict alone have the same picture.
bool sameView(const CandidateView& a, const CandidateView& b) {
  return a.candidate->mask_u == b.candidate->mask_u && a.candidate->mask_v == b.candidate->mask_v &&
         a.config->mask == b.config->mask && a.config->points == b.config->points &&
         a.candidate->mask == b.candidate->mask &&
         a.candidate->mesh.vertices == b.candidate->mesh.vertices;
}

ViewCut cutOf(const CandidateView& view, const Image<Rgb>& color, int size_px) {
  MaskCut cut = maskCut(*view.candidate, color, *view.config, size_px);
  for (std::uint8_t& parts : cut.parts) parts = static_cast<std::uint8_t>(kBitStep * parts);
  return {encodeJpeg(cut.color, kJpegQuality), encodePng(cut.parts)};
}

}  // namespace

std::vector<ViewCut> viewCuts(const Dataset& dataset, const std::vector<CandidateView>& views,
                              int size_px) {
  std::map<std::int64_t, std::vector<std::size_t>> of_stamp;
  for (std::size_t i = 0; i < views.size(); ++i) {
    of_stamp[views[i].candidate->view_stamp_ns].push_back(i);
  }
  const std::vector<std::pair<std::int64_t, std::vector<std::size_t>>> frames(of_stamp.begin(),
                                                                              of_stamp.end());
  const ColorAt color_at = colorAt(dataset);
  std::vector<ViewCut> cuts(views.size());
  parallelFor(frames.size(), [&](std::size_t f) {
    const auto& [stamp_ns, members] = frames[f];
    const Image<Rgb> color = color_at(stamp_ns);
    for (std::size_t m = 0; m < members.size(); ++m) {
      const auto twin = std::find_if(
          members.begin(), members.begin() + static_cast<std::ptrdiff_t>(m),
          [&](std::size_t other) { return sameView(views[other], views[members[m]]); });
      const bool is_new = twin == members.begin() + static_cast<std::ptrdiff_t>(m);
      cuts[members[m]] = is_new ? cutOf(views[members[m]], color, size_px) : cuts[*twin];
    }
  });
  return cuts;
}

}  // namespace hydrabench
