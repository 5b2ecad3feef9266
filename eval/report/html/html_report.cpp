// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/html/html_report.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/io/atomic_file.h"
#include "core/types/error.h"
#include "eval/claims/claim_report.h"
#include "eval/experiment/provenance.h"
#include "eval/experiment/result_worlds.h"
#include "eval/report/html/csv_json.h"
#include "eval/report/html/object_table.h"
#include "eval/report/html/page.h"
#include "eval/report/html/score_data.h"
#include "eval/report/html/sweep_data.h"
#include "eval/report/html/world_scene.h"
#include "eval/report/result_folder.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

/// Finest first.
const std::vector<SceneDetail> kDetails = {
    {800, 60000, 240}, {500, 30000, 200}, {300, 12000, 160}, {150, 4000, 0}};

std::string text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The page, piece by piece.
class Writer {
 public:
  Writer(fs::path result, const HtmlReportOptions& options)
      : result_(std::move(result)), options_(options), assets_(webAssets()) {}

  HtmlReport write() {
    if (!fs::exists(result_ / kResultMarker) && !fs::exists(result_ / "scores.csv")) {
      throw InputError(fmt::format("{}: no result folder, expected scores.csv or {} in there",
                                   result_.string(), kResultMarker));
    }
    addScores();
    addClaims();
    const ObjectTable objects = readObjectTable(result_ / "objects.csv");
    add("objects", objectsJson(objects));
    addWorlds(objects);
    add("timing", csvJson(result_ / "timing.csv"));
    add("methods", methodsJson(methods_));
    addSetup();
    const std::string name = fs::weakly_canonical(result_).filename().string();
    return {assemblePage(assets_, name + " – hydrabench", data_), remarks_};
  }

 private:
  void add(const std::string& id, std::string json) {
    bytes_ += json.size();
    data_.push_back({id, PageData::Kind::kJson, std::move(json)});
  }

  void meet(const std::string& method) {
    if (std::find(methods_.begin(), methods_.end(), method) == methods_.end()) {
      methods_.push_back(method);
    }
  }

  void addScores() {
    const std::string sweep = sweepJson(result_);
    const fs::path scores = result_ / "scores.csv";
    std::string tables = "[]";
    if (sweep == "null" && fs::exists(scores)) {
      const std::vector<ScoreRow> rows = readScoresCsv(scores);
      for (const ScoreRow& row : rows) meet(row.method);
      tables = tablesJson(rows, readNotes(result_));
    }
    add("sweep", sweep);
    add("tables", std::move(tables));
    add("significance", csvJson(result_ / "significance.csv"));
    add("strata", csvJson(result_ / "strata.csv"));
    add("kappa", kappaJson(result_));
  }

  /// Nothing where no claim is about what was run here; sweeps are no evidence.
  void addClaims() {
    std::vector<JudgedClaim> judged;
    if (!options_.claims.empty() && !methods_.empty()) {
      std::vector<Evidence> evidence = readEvidence({result_});
      // There is only this one, and a page that is handed on does not tell where it lay.
      for (Evidence& of_dataset : evidence) of_dataset.result.clear();
      judged = judge(readClaims(options_.claims), evidence);
    }
    const bool any = std::any_of(judged.begin(), judged.end(), [](const JudgedClaim& claim) {
      return claim.verdict != ClaimVerdict::kNotRun;
    });
    add("claims", any ? claimsJson(judged) : "null");
  }

  void addWorlds(const ObjectTable& objects) {
    Json worlds = Json::array();
    std::string missing;
    std::map<std::string, double> periods;
    if (!fs::is_directory(result_ / "predictions")) {
      missing =
          "This folder holds no predictions, so there is no scene to look at: 'hydrabench run' "
          "keeps them, 'evaluate' and 'sweep' do not.";
    } else {
      worlds = packWorlds(resultWorlds(result_), objects, periods);
      if (worlds.empty()) missing = "No world could be shown; see the remarks under Setup.";
    }
    Json json = {{"worlds", std::move(worlds)}, {"missing", missing}, {"frame_period_s", periods}};
    add("scene", text(json));
  }

  Json packWorlds(const std::vector<ResultWorld>& worlds, const ObjectTable& objects,
                  std::map<std::string, double>& periods) {
    Json packed = Json::array();
    std::size_t level = 0;
    const std::size_t steps = 2 * worlds.size();
    for (std::size_t w = 0; w < worlds.size(); ++w) {
      const auto step = [&](std::size_t done) {
        if (options_.on_step) options_.on_step(2 * w + done, steps);
      };
      try {
        const WorldScene scene(worlds[w], worldOf(objects, worlds[w]));
        for (const fs::path& path : worlds[w].predictions) meet(path.filename().string());
        periods[worlds[w].dataset] = scene.framePeriod();
        step(1);
        const auto fitting =
            fittingPack(scene, worlds.size() - w, fmt::format("world-{}", w), level);
        if (fitting) {
          for (const PageData& blob : fitting->blobs) {
            bytes_ += blob.text.size();
            data_.push_back(blob);
          }
          bytes_ += fitting->json.size();
          packed.push_back(Json::parse(fitting->json));
        } else {
          remarks_.push_back(
              fmt::format("{}: left out of the scene to keep the file below {:g} MB; "
                          "--max-mb raises that",
                          worlds[w].label(), options_.max_mb));
        }
      } catch (const InputError& error) {
        remarks_.push_back(fmt::format("{}: not shown: {}", worlds[w].label(), error.what()));
      }
      step(2);
    }
    if (level > 0) {
      remarks_.push_back(fmt::format(
          "scenes were coarsened to keep the file below {:g} MB: shapes of about {} faces, scene "
          "meshes of {}, best views {}; --max-mb raises that",
          options_.max_mb, kDetails[level].object_faces, kDetails[level].scene_faces,
          kDetails[level].picture_px > 0 ? fmt::format("{} pixels", kDetails[level].picture_px)
                                         : "left out"));
    }
    return packed;
  }

  /// The finest that leaves the worlds to come their share, from the level of the worlds before on.
  std::optional<WorldScene::Packed> fittingPack(const WorldScene& scene, std::size_t worlds_left,
                                                const std::string& prefix, std::size_t& level) {
    const double fixed = static_cast<double>(bytes_ + assets_.script.size() + kReserve);
    const double share = (options_.max_mb * 1e6 - fixed) / static_cast<double>(worlds_left);
    for (std::size_t l = level; l < kDetails.size(); ++l) {
      WorldScene::Packed packed = scene.pack(prefix, kDetails[l]);
      if (static_cast<double>(packed.bytes()) > share) continue;
      level = l;
      return packed;
    }
    return std::nullopt;
  }

  static const ObjectWorld* worldOf(const ObjectTable& objects, const ResultWorld& world) {
    for (const ObjectWorld& known : objects.worlds) {
      if (known.dataset == world.dataset && known.seed == world.seed) return &known;
    }
    return nullptr;
  }

  void addSetup() {
    Json json;
    json["name"] = fs::weakly_canonical(result_).filename().string();
    const fs::path marker = result_ / kResultMarker;
    json["provenance"] =
        fs::exists(marker) ? Json::parse(readFile(marker), nullptr, false) : Json();
    if (json["provenance"].is_discarded()) {
      throw InputError(fmt::format("{}: no JSON", marker.string()));
    }
    const fs::path config = result_ / "config.yaml";
    json["config"] = fs::exists(config) ? readFile(config) : "";
    const fs::path failures = result_ / "failures.txt";
    json["failures"] = fs::exists(failures) ? readFile(failures) : "";
    json["notes"] = readNotes(result_);
    json["remarks"] = remarks_;
    json["report_by"] = versionLine(currentProvenance(""));
    json["licenses"] = assets_.licenses;
    add("setup", text(json));
  }

  static constexpr std::size_t kReserve = 500'000;  ///< for what is added after the scenes

  fs::path result_;
  const HtmlReportOptions& options_;
  WebAssets assets_;
  std::vector<PageData> data_;
  std::size_t bytes_ = 0;  ///< of data_
  std::vector<std::string> methods_;
  std::vector<std::string> remarks_;
};

}  // namespace

HtmlReport htmlReport(const fs::path& result, const HtmlReportOptions& options) {
  return Writer(result, options).write();
}

}  // namespace hydrabench
