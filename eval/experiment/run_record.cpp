// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/run_record.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/io/atomic_file.h"
#include "core/types/error.h"
#include "eval/experiment/provenance.h"

namespace hydrabench {

std::string runRecordJson(const RunRecord& record) {
  const nlohmann::ordered_json json = {
      {"frames", record.frames},
      {"frame_period_s", record.frame_period_s},
      {"made_by", nlohmann::ordered_json::parse(provenanceJson(currentProvenance("")))}};
  return json.dump(1) + "\n";
}

RunRecord readRunRecord(const std::filesystem::path& path) {
  try {
    const auto json = nlohmann::json::parse(readFile(path));
    return {json.at("frames").get<std::size_t>(), json.at("frame_period_s").get<double>()};
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: not the record of a run: {}", path.string(), error.what()));
  }
}

}  // namespace hydrabench
