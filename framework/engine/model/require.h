#pragma once
#include "engine/model/model.h"

#include <span>
#include <string>

namespace muelle::engine {

/// \file
/// What validate() asks of numbers. Each throws std::invalid_argument, "ITEM: WHAT is ...", with what is expected.

/// \param item names the place: "spring 3"
[[noreturn]] void reject(const std::string& item, const std::string& fault);

void requireFinite(const std::string& item, const char* what, double value);
void requireFinite(const std::string& item, const char* what, const Vec3& value);
void requireNotNegative(const std::string& item, const char* what, double value);
/// Not negative, and no denormal number: its square root would lose its digits.
void requireStiffness(const std::string& item, const char* what, double value);
/// Of length 1, to 1e-9.
void requireUnit(const std::string& item, const char* what, const Vec3& value);
/// Indices of nodes that exist.
void requireNodes(const Model& model, const std::string& item, std::span<const int> nodes);
void requireDifferent(const std::string& item, std::span<const int> nodes);
/// An index into Model::parts, or partOfItsKind.
void requirePart(const Model& model, const std::string& item, int part);

/// Not 0, and below the smallest normal number.
bool isDenormal(double value);

}  // namespace muelle::engine
