// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/shape_family.h"

#include <cstdio>
#include <cstdlib>
#include <utility>

#include <fmt/core.h>

#include "eval/simulation/families/family_builder.h"

namespace hydrabench {
namespace {

std::vector<ShapeFamily> allFamilies() {
  std::vector<ShapeFamily> all;
  for (std::vector<ShapeFamily> (*const families)() :
       {chairFamilies, couchFamilies, plantFamilies, binFamilies, computerFamilies,
        furnitureFamilies}) {
    for (ShapeFamily& family : families()) all.push_back(std::move(family));
  }
  return all;
}

[[noreturn]] void abortWith(const std::string& message) {
  fmt::print(stderr, "{}\n", message);
  std::abort();
}

}  // namespace

const std::vector<ShapeFamily>& shapeFamilies() {
  static const std::vector<ShapeFamily> families = allFamilies();
  return families;
}

const ShapeFamily& shapeFamily(const std::string& name) {
  for (const ShapeFamily& family : shapeFamilies()) {
    if (family.name == name) return family;
  }
  abortWith(fmt::format("no shape family is called \"{}\"", name));
}

std::uint64_t instanceSeed(InstanceSplit split, std::uint64_t index) {
  if (index > kMaxInstanceIndex) {
    abortWith(fmt::format("instance index {} exceeds {}", index, kMaxInstanceIndex));
  }
  return (static_cast<std::uint64_t>(split) << 62) | index;
}

}  // namespace hydrabench
