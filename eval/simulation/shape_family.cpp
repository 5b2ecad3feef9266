// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/shape_family.h"

#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <utility>

#include <fmt/core.h>

#include "eval/simulation/families/family_builder.h"

namespace hydrabench {
namespace {

struct FamilyTable {
  std::vector<ShapeFamily> families;
  std::size_t indoor = 0;  ///< so many of them, in front
};

FamilyTable makeTable() {
  using Families = std::vector<ShapeFamily> (*)();
  FamilyTable table;
  const auto append = [&](std::initializer_list<Families> classes) {
    for (const Families families : classes) {
      for (ShapeFamily& family : families()) table.families.push_back(std::move(family));
    }
  };
  append({chairFamilies, couchFamilies, plantFamilies, binFamilies, computerFamilies,
          furnitureFamilies});
  table.indoor = table.families.size();
  append({hydrantFamilies, carFamilies, benchFamilies, treeFamilies, streetFamilies});
  return table;
}

const FamilyTable& familyTable() {
  static const FamilyTable table = makeTable();
  return table;
}

[[noreturn]] void abortWith(const std::string& message) {
  fmt::print(stderr, "{}\n", message);
  std::abort();
}

}  // namespace

const std::vector<ShapeFamily>& shapeFamilies() { return familyTable().families; }

std::span<const ShapeFamily> indoorFamilies() {
  return std::span(familyTable().families).first(familyTable().indoor);
}

std::span<const ShapeFamily> outdoorFamilies() {
  return std::span(familyTable().families).subspan(familyTable().indoor);
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
