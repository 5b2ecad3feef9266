// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
// The command as a user runs it: HYDRABENCH_COMMAND is the program just built.
#include <cstdlib>
#include <filesystem>
#include <string>
#include <sys/wait.h>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

class Command : public ::testing::Test {
 protected:
  Outcome run(const std::string& arguments) {
    const std::string line =
        fmt::format("cd '{}' && HYDRABENCH_STORE='{}' '{}' {} >'{}' 2>'{}'", HYDRABENCH_SOURCE_DIR,
                    path("store"), HYDRABENCH_COMMAND, arguments, (folder_ / "out.txt").string(),
                    (folder_ / "err.txt").string());
    const int status = std::system(line.c_str());
    return {WEXITSTATUS(status), readText(folder_ / "out.txt"), readText(folder_ / "err.txt")};
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// One tidy line on standard error and exit code 2.
  void expectFault(const std::string& arguments, const std::string& text) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(text));
    EXPECT_THAT(outcome.err, ::testing::StartsWith("hydrabench: "));
  }

  TemporaryFolder folder_;
  /// The quick world, small enough for a test.
  const std::string kWorld = "configs/datasets/office_quick.yaml";
  const std::string kSmall =
      "--set camera.width_px=180 --set camera.height_px=120 --set camera.fx_px=104 "
      "--set camera.fy_px=104 --set camera.cx_px=90 --set camera.cy_px=60";
  /// The same for commands that know several parts.
  std::string small() const {
    std::string text = kSmall;
    for (std::size_t at = 0; (at = text.find("camera.", at)) != std::string::npos; at += 15) {
      text.insert(at, "dataset.");
    }
    return " " + text + " ";
  }
};

TEST_F(Command, TeachesWithoutArguments) {
  const Outcome outcome = run("");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.out, HasSubstr("First steps:"));
}

TEST_F(Command, HelpsForEverySubcommand) {
  for (const std::string name : {"doctor", "selftest", "view", "export", "run", "map", "evaluate",
                                 "report", "sweep", "status", "work", "compare", "estimate",
                                 "stream", "train", "templates", "defaults", "version"}) {
    const Outcome outcome = run(name + " --help");
    EXPECT_EQ(outcome.exit_code, 0) << name;
    EXPECT_THAT(outcome.out, HasSubstr("Usage: hydrabench " + name)) << name;
  }
}

TEST_F(Command, RunsAnExperimentToATable) {
  const Outcome outcome =
      run("run configs/experiments/table1_quick.yaml --out " + path("result") + small() +
          "--set max_frames=100 --set evaluation.bootstrap_resamples=20 "
          "--set evaluation.samples=500 --set 'datasets.0.seeds=[1,2]'");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("tau_d = 0.5 m, one_to_one"));
  EXPECT_THAT(outcome.out, HasSubstr("x real time"));
  for (const std::string file :
       {"scores.csv", "objects.csv", "timing.csv", "table.md", "table.tex", "provenance.json",
        "config.yaml", "notes.txt", "predictions/office_quick/2/khronos/scene_graph.json"}) {
    EXPECT_NE(readText(folder_ / "result" / file), "") << file;
  }
  const std::string scores = readText(folder_ / "result/scores.csv");
  for (const std::string method : {"hydra", "khronos", "template_cad", "hydra_plus_plus"}) {
    const std::string found =
        "office_quick,pooled," + method + ",all_micro,tau_m,0.5,exists,found_truths,";
    EXPECT_THAT(scores, HasSubstr(found));
    EXPECT_THAT(scores, Not(HasSubstr(found + "0,"))) << method << " found nothing";
  }
  EXPECT_THAT(run("report " + path("result") + " --format md").out, HasSubstr("Template CAD: "));
  EXPECT_THAT(readText(folder_ / "result/kappa.md"), HasSubstr("| Khronos |"));
  EXPECT_THAT(readText(folder_ / "result/plots/kappa_office_quick_exists.gp"), HasSubstr("Hydra"));
  EXPECT_THAT(run("report " + path("result") + " --variants --class chair").out,
              HasSubstr("| Template CAD "));
}

TEST_F(Command, DecidesTheCandidatesOfARunAnew) {
  const std::string method =
      (std::filesystem::path(HYDRABENCH_SOURCE_DIR) / "configs/methods/oracle_shape.yaml").string();
  const Outcome mapped =
      run("run configs/experiments/table1_quick.yaml --out " + path("result") + small() +
          "--set max_frames=100 --set evaluation.bootstrap_resamples=0 "
          "--set evaluation.samples=500 --set 'methods=[{config: " +
          method + "}]'");
  ASSERT_EQ(mapped.exit_code, 0) << mapped.err;
  const std::string sweep = "sweep configs/sweeps/tau_o.yaml --out " + path("swept") + small() +
                            "--set experiment=../experiments/table1_quick.yaml "
                            "--set max_frames=100 --set evaluation.bootstrap_resamples=0 "
                            "--set evaluation.samples=500 --set 'methods=[{config: " +
                            method + "}]'";
  const Outcome swept = run(sweep + " --set method=oracle_shape");
  ASSERT_EQ(swept.exit_code, 0) << swept.err;
  EXPECT_THAT(swept.err, Not(HasSubstr("runs,"))) << "mapped again";
  EXPECT_THAT(swept.out, HasSubstr("| 0.5 m | one_to_one |"));
  EXPECT_THAT(readText(folder_ / "swept/tau_o_office_quick.csv"), HasSubstr("tau_o,tau_o_end"));
  const Outcome viewed = run("view " + path("result") +
                             " --rejections --heatmaps --objects 1 --out " + path("figures"));
  EXPECT_EQ(viewed.exit_code, 0) << viewed.err;
  EXPECT_THAT(viewed.out, HasSubstr("errors_office_quick_1.png"));
  expectFault(sweep, "method: no 'hydra_plus_plus' in the experiment");
}

TEST_F(Command, MapsForEvaluate) {
  const Outcome mapped =
      run("map " + kWorld + " --method configs/methods/khronos.yaml --frames 80" + " --out " +
          path("mine") + small());
  ASSERT_EQ(mapped.exit_code, 0) << mapped.err;
  EXPECT_THAT(mapped.out, Not(::testing::StartsWith("0 objects")));
  EXPECT_THAT(readText(folder_ / "mine/timing.csv"), HasSubstr("khronos,frame,"));
  const Outcome scored =
      run("evaluate " + path("mine") + " --dataset " + kWorld + " --out " + path("scored"));
  EXPECT_EQ(scored.exit_code, 0) << scored.err;
  EXPECT_THAT(scored.out, HasSubstr("Khronos"));
}

TEST_F(Command, TrainsStopsAndGoesOn) {
  writeText(folder_ / "toy.yaml",
            "worlds: {world: quick, frames: 30, sdf_points: 200, image_width_px: 180}\n"
            "network: {dim: 16, depth: 1, heads: 2, decoder_layers: 2, decoder_width: 16}\n"
            "decoder: {worlds: 1, steps: 4, shapes_per_step: 4, points_per_shape: 16}\n"
            "joint: {worlds: 1, window_worlds: 1, steps: 4, batch: 2, sdf_points: 8}\n"
            "validation_worlds: 1\nprecision: fp32\n");
  const std::string train = "train " + path("toy.yaml") + " --out " + path("toy");
  const Outcome stopped = run(train + " --minutes 0.000001");
  EXPECT_EQ(stopped.exit_code, 0) << stopped.err;
  EXPECT_THAT(stopped.out, HasSubstr("the same command goes on from here"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "toy/model"));

  const Outcome finished = run(train);
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, HasSubstr("finished: wrote " + path("toy/model")));
  EXPECT_THAT(finished.err, HasSubstr("network 4/4"));
  EXPECT_THAT(readText(folder_ / "toy/loss.csv"), HasSubstr("\nnetwork,4,8,"));
  EXPECT_THAT(readText(folder_ / "toy/config.yaml"), HasSubstr("decoder_width: 16"));
  EXPECT_THAT(readText(folder_ / "toy/model/manifest.yaml"), HasSubstr("preset: small"));
  const std::string weights = readText(folder_ / "toy/model/weights.safetensors");
  EXPECT_GT(weights.size(), 100000u);

  EXPECT_EQ(run(train).exit_code, 0);  // nothing left to do
  EXPECT_TRUE(readText(folder_ / "toy/model/weights.safetensors") == weights);
  expectFault(train + " --set joint.steps=5", "belongs to a training with other settings");
  expectFault(train + " --set joint.stepps=5", "did you mean joint.steps?");
}

TEST_F(Command, EstimatesShapesFromSingleViews) {
  writeText(folder_ / "study.yaml",
            fmt::format("datasets: [{{config: {}/{}}}]\n"
                        "estimators: [{{name: truth, type: oracle}}]\n"
                        "views: {{frame_step: 20, min_pixels: 60}}\n"
                        "evaluation: {{samples: 300, bootstrap_resamples: 20}}\n",
                        HYDRABENCH_SOURCE_DIR, kWorld));
  const std::string estimate = "estimate " + path("study.yaml") + small() +
                               "--set dataset.office.chairs=3 --set dataset.office.plants=1 --set "
                               "dataset.office.computers=0 --out " +
                               path("views");
  const Outcome outcome = run(estimate);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("chamfer_l1 [cm]"));
  EXPECT_THAT(outcome.out, HasSubstr("truth"));
  EXPECT_THAT(readText(folder_ / "views/views.csv"), HasSubstr("office_quick,1,truth,"));
  EXPECT_THAT(readText(folder_ / "views/summary.csv"), HasSubstr("\noffice_quick,truth,all,"));
  EXPECT_THAT(readText(folder_ / "views/config.yaml"), HasSubstr("frame_step: 20"));
  expectFault(estimate, path("views"));
  expectFault(estimate + " --set views.min_pixls=3", "did you mean views.min_pixels?");
}

TEST_F(Command, SaysWhatIsWrongWithAnExperiment) {
  const std::string quick = "run configs/experiments/table1_quick.yaml --out " + path("x");
  expectFault("run nowhere.yaml --out " + path("x"), "nowhere.yaml");
  expectFault(quick + " --set methods.hidra.a=1", "did you mean 'hydra'?");
  expectFault(quick + " --set dataset.masks.min_pixel=3", "did you mean masks.min_pixels?");
  expectFault(quick + " --set methods.hydra.type=hidra",
              "table1_quick.yaml: methods.0: type: 'hidra' is unknown, expected one of: hydra");
  expectFault(quick + " --set methods.hydra.max_range_m=far",
              "table1_quick.yaml: methods.0: max_range_m: expected a finite number");
  expectFault(quick + " --set methods.hydra=1", "expected methods.NAME.KEY=VALUE");
  expectFault(quick + " --set dataset.", "--set dataset.: expected dataset.KEY=VALUE");
  expectFault(
      "run configs/experiments/redkitchen.yaml --data /nowhere --set datasets.0.seeds=[1] " +
          std::string("--out ") + path("x"),
      "redkitchen");
  expectFault(
      "map " + kWorld + " --method configs/methods/hydra.yaml --frames -1 --out " + path("x"),
      "--frames");
  expectFault("run configs/experiments/apc.yaml --data /nowhere --out " + path("x"),
              "no such folder: /nowhere");
  expectFault(
      "map " + kWorld + " --method configs/methods/hydra.yaml --out " + path("x") + " --set a=1",
      "expected a key that starts with 'dataset.' or 'method.'");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "x"));
}

TEST_F(Command, TheExamplesOfTheHelpAreKeysThatExist) {
  const std::string quick = "run configs/experiments/table1_quick.yaml --set max_frames=1 --out ";
  EXPECT_EQ(run(quick + path("a") + small() + "--set methods.hydra.objects.cluster_tolerance_m=0.2")
                .exit_code,
            0);
  EXPECT_THAT(run("run --help").out, HasSubstr("methods.hydra.objects.cluster_tolerance_m=0.2"));
  EXPECT_EQ(run("map " + kWorld + " --method configs/methods/hydra.yaml --frames 1 --out " +
                path("b") + small() + "--set method.window.tsdf.voxel_size_m=0.05")
                .exit_code,
            0);
  EXPECT_THAT(run("map --help").out, HasSubstr("method.window.tsdf.voxel_size_m=0.05"));
}

TEST_F(Command, KeepsWhatFinishedWhenAMethodFails) {
  // A world without instance images: template CAD cannot work, Hydra can.
  ASSERT_EQ(run(fmt::format("export {} {} --frames 12 --out {}", kWorld, kSmall, path("world")))
                .exit_code,
            0);
  std::filesystem::remove_all(folder_ / "world/instances");
  const std::string line = "run configs/experiments/table1_quick.yaml --out " + path("kept") +
                           " --set datasets.0.config=" + path("world/dataset.yaml") +
                           " --set evaluation.bootstrap_resamples=20";
  const Outcome outcome = run(line);
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("failed: office_quick, seed 1: template_cad: "));
  EXPECT_THAT(outcome.out, HasSubstr("Template CAD: 1 of 1 worlds of office_quick failed"));
  EXPECT_THAT(readText(folder_ / "kept/failures.txt"), HasSubstr("template_cad: "));
  EXPECT_THAT(readText(folder_ / "kept/scores.csv"), HasSubstr(",hydra,"));

  // A result is not given up for one in which nothing worked.
  std::filesystem::remove_all(folder_ / "world/depth");
  EXPECT_EQ(run(line + " --replace").exit_code, 2);
  EXPECT_THAT(readText(folder_ / "kept/scores.csv"), HasSubstr(",hydra,"));
}

TEST_F(Command, AMissingTemplateIsFoundBeforeAnythingIsMapped) {
  expectFault("map " + kWorld + " --method configs/methods/template_cad.yaml --out " + path("x") +
                  " --set method.templates.0.mesh=nowhere.ply",
              "nowhere.ply");
}

TEST_F(Command, PrintsItsVersion) {
  for (const std::string arguments : {"version", "--version"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.out, ::testing::StartsWith("hydrabench 0.1.0 ("));
  }
}

TEST_F(Command, AuditsThePapersTable) {
  const Outcome outcome = run("audit configs/tables/hydra_plus_plus_table1.csv");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("ground-truth objects: 88"));
  EXPECT_THAT(outcome.out, HasSubstr("many-to-one: in 9 of 10 rows"));
  EXPECT_EQ(run("audit configs/tables/hydra_plus_plus_table1.csv --max-objects 50").exit_code, 1);
  expectFault("audit README.md", "expected columns method, P, R and F1");
  expectFault("audit absent.tex", "absent.tex");
}

TEST_F(Command, PrintsTheDefaultsThatAreWrittenDown) {
  EXPECT_EQ(run("defaults").out,
            readText(std::filesystem::path(HYDRABENCH_SOURCE_DIR) / "configs/default.yaml"))
      << "make the file anew: hydrabench defaults > configs/default.yaml";
}

TEST_F(Command, ReplacesResultsOnly) {
  writeText(folder_ / "mine/thesis.tex", "years of work");
  expectFault(fmt::format("selftest {} --out {} --replace", kWorld, path("mine")), "not replaced");
  EXPECT_EQ(readText(folder_ / "mine/thesis.tex"), "years of work");
}

TEST_F(Command, IsHealthyHere) {
  const Outcome outcome = run("doctor");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr("all that is needed works"));
}

TEST_F(Command, SuggestsTheSubcommandThatWasMeant) {
  expectFault("exprot", "did you mean 'export'?");
}

TEST_F(Command, SuggestsTheOptionThatWasMeant) {
  expectFault("report x --fromat md", "did you mean '--format'?");
}

TEST_F(Command, SuggestsTheConfigKeyThatWasMeant) {
  expectFault(fmt::format("export {} --out {} --set sede=3", kWorld, path("w")),
              "did you mean seed?");
}

/// Three chairs known by their boxes, in the place and unit that is given.
std::string threeChairs(double metre, double x_m) {
  std::string nodes;
  for (int i = 0; i < 3; ++i) {
    nodes += fmt::format(
        R"({}{{"id": {}, "layer": 2, "partition": 0, "attributes": {{"type": "KhronosObjectAttributes",
        "position": [{}, {}, {}], "name": "chair_{}", "semantic_label": 5, "bounding_box": {{"type": "AABB",
        "dimensions": [{}, {}, {}], "world_P_center": [{}, {}, {}],
        "world_R_center": {{"w": 1, "x": 0, "y": 0, "z": 0}}}}}}}})",
        i == 0 ? "" : ",", 5692549928996306944 + i, metre * x_m, metre * i, metre / 2, i,
        0.5 * metre, 0.5 * metre, metre, metre * x_m, metre * i, metre / 2);
  }
  return fmt::format(
      R"({{"SPARK_DSG_header": {{"project_name": "main", "version": {{"major": 1, "minor": 1, "patch": 3}}}},
      "layer_names": {{"OBJECTS": {{"layer": 2, "partition": 0}}}}, "nodes": [{}], "edges": []}})",
      nodes);
}

TEST_F(Command, TellsMillimetresBeforeItScoresThem) {
  writeText(folder_ / "mine/scene_graph.json", threeChairs(1000, 2));
  const std::string evaluate =
      fmt::format("evaluate {} --dataset {} --out {} --set evaluation.samples=100", path("mine"),
                  kWorld, path("result"));
  expectFault(evaluate, "mine: unit, axes and origin: positions and meshes in millimetres");
  expectFault(evaluate, "(--as-is scores it as it stands)");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "result"));

  const Outcome checked = run(fmt::format("selftest {} --check {}", kWorld, path("mine")));
  EXPECT_EQ(checked.exit_code, 1);
  EXPECT_THAT(checked.out, HasSubstr("  FAIL  unit, axes and origin (positions and meshes in"));
  EXPECT_THAT(checked.out, HasSubstr("check FAILED for 1 of 1 predictions"));

  const Outcome scored = run(evaluate + " --as-is");
  EXPECT_EQ(scored.exit_code, 0) << scored.err;
  EXPECT_THAT(scored.err, HasSubstr("in millimetres"));
  EXPECT_THAT(readText(folder_ / "result/scores.csv"), HasSubstr("exists,found_truths,0,"));
}

TEST_F(Command, ChecksEveryPredictionAndAccusesOnlyTheBroken) {
  writeText(folder_ / "poor/scene_graph.json", threeChairs(1, 90));
  std::string broken = threeChairs(1, 2);
  broken.replace(broken.find("[2, 1, 0.5]"), 11, "[2, NaN, 0.5]");
  writeText(folder_ / "broken/scene_graph.json", broken);
  const Outcome poor = run(fmt::format("selftest {} --check {}", kWorld, path("poor")));
  EXPECT_EQ(poor.exit_code, 0) << poor.out << poor.err;
  EXPECT_THAT(poor.out, HasSubstr("check passed"));
  const Outcome both =
      run(fmt::format("selftest {} --check {} {}", kWorld, path("broken"), path("poor")));
  EXPECT_EQ(both.exit_code, 1);
  EXPECT_THAT(both.out, HasSubstr("FAIL  readable ("));
  EXPECT_THAT(both.out, HasSubstr("(O1): attributes.position[1]: expected a number, found"));
  EXPECT_THAT(both.out, HasSubstr("check FAILED for 1 of 2 predictions"));
}

TEST_F(Command, RefusesMisspeltOptionsOfTheChecks) {
  expectFault("selftest " + kWorld + " --shufles 3", "did you mean '--shuffles'?");
  expectFault("selftest " + kWorld + " --shuffles 0", "--shuffles");
  expectFault("selftest " + kWorld + " --shuffles 3 --check x", "--check");
  expectFault("selftest " + kWorld + " --chek x", "did you mean '--check'?");
  expectFault("evaluate x --dataset " + kWorld + " --out y --as-iss", "did you mean '--as-is'?");
}

TEST_F(Command, NamesAMissingDataset) { expectFault("selftest nowhere.yaml", "nowhere.yaml"); }

TEST_F(Command, WantsPrefixedOverridesWhereThereAreTwoConfigs) {
  expectFault("selftest " + kWorld + " --set samples=10",
              "expected a key that starts with 'dataset.' or 'evaluation.'");
}

TEST_F(Command, RefusesToOverwriteAnExport) {
  const std::string arguments =
      fmt::format("export {} {} --frames 1 --out {}", kWorld, kSmall, path("world"));
  EXPECT_EQ(run(arguments).exit_code, 0);
  expectFault(arguments, "world");
  EXPECT_EQ(run(arguments + " --replace").exit_code, 0);
}

TEST_F(Command, GoesFromWorldToTable) {
  const Outcome exported =
      run(fmt::format("export {} {} --frames 2 --out {}", kWorld, kSmall, path("world")));
  ASSERT_EQ(exported.exit_code, 0) << exported.err;

  const Outcome tested = run(
      fmt::format("selftest {}/dataset.yaml --out {} --prediction {} --set evaluation.samples=1000 "
                  "--set evaluation.bootstrap_resamples=50",
                  path("world"), path("result"), path("perfect")));
  ASSERT_EQ(tested.exit_code, 0) << tested.out << tested.err;
  EXPECT_THAT(tested.out, HasSubstr("selftest passed"));
  EXPECT_THAT(tested.out, Not(HasSubstr("FAIL")));

  for (const std::string name : {"scores.csv", "objects.csv", "kappa.csv", "table.md", "table.tex",
                                 "table.csv", "table.json", "config.yaml", "provenance.json"}) {
    EXPECT_FALSE(readText(folder_ / ("result/" + name)).empty()) << name;
  }
  EXPECT_THAT(readText(folder_ / "result/scores.csv"),
              ::testing::StartsWith(
                  "dataset,seed,method,class,threshold_kind,threshold,matching,metric,value,unit,"
                  "ci95_low,ci95_high,n\n"));
  EXPECT_THAT(run("report " + path("result")).out, HasSubstr("Ground truth"));
  EXPECT_THAT(run("report " + path("result") + " --format tex").out, HasSubstr("\\toprule"));
  EXPECT_THAT(run("report " + path("result") + " --class chair").out, HasSubstr("chair"));
  const Outcome evaluated = run(
      fmt::format("evaluate {} --dataset {}/dataset.yaml --out {} --set evaluation.samples=1000",
                  path("perfect"), path("world"), path("again")));
  EXPECT_EQ(evaluated.exit_code, 0) << evaluated.err;
  EXPECT_THAT(readText(folder_ / "again/table.csv"),
              HasSubstr("0.5,one_to_one,ground_truth,1,1,1,1,1,1,1,1,1,"));
  EXPECT_EQ(run(fmt::format("view {} --out {}", path("perfect"), path("again"))).exit_code, 0);
  EXPECT_FALSE(readText(folder_ / "again/prediction.png").empty());
  expectFault("report " + path("result") + " --class sofa", "no scores of class 'sofa'");
}

TEST_F(Command, ExportsTheSameBytesForOneAndTwoThreads) {
  for (const std::string threads : {"1", "2"}) {
    ASSERT_EQ(run(fmt::format("export {} {} --frames 4 --out {} --threads {}", kWorld, kSmall,
                              path("w" + threads), threads))
                  .exit_code,
              0);
  }
  EXPECT_EQ(std::system(fmt::format("diff -r '{}' '{}'", path("w1"), path("w2")).c_str()), 0);
}

TEST_F(Command, EvaluatesAHandWrittenPrediction) {
  ASSERT_EQ(
      run(fmt::format("export {} {} --frames 1 --out {}", kWorld, kSmall, path("world"))).exit_code,
      0);
  writeText(
      folder_ / "mine/scene_graph.json",
      R"({"SPARK_DSG_header": {"project_name": "main", "version": {"major": 1, "minor": 1, "patch": 3}},
                "directed": false, "multigraph": false, "layer_keys": [{"layer": 2, "partition": 0}],
                "layer_names": {"OBJECTS": {"layer": 2, "partition": 0}}, "metadata": {}, "nodes": [], "edges": []})");
  const Outcome outcome = run(fmt::format("evaluate {} --dataset {}/dataset.yaml --out {}",
                                          path("mine"), path("world"), path("result")));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("n/a"));  // the precision of nothing
  EXPECT_THAT(outcome.out, HasSubstr("mine"));
}

TEST_F(Command, NamesTheBrokenFieldOfAPrediction) {
  writeText(folder_ / "mine/scene_graph.json", R"({"nodes": []})");
  expectFault(fmt::format("evaluate {} --dataset {} --out {}", path("mine"), kWorld, path("r")),
              "SPARK_DSG_header");
}

TEST_F(Command, RendersPictures) {
  const Outcome outcome =
      run(fmt::format("view {} {} --frames 1 --out {}", kWorld, kSmall, path("view")));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("overview.png"));
  EXPECT_THAT(outcome.out, HasSubstr("masks_"));
  expectFault("view --out " + path("view"), "nothing to show");
}

}  // namespace
}  // namespace hydrabench
