#include "grader/testing/features.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace muelle::grader {

namespace {

using Kind = ArgumentItem::Kind;

double lengthOf(const std::vector<double>& numbers) {
  double length = 0;
  for (const double number : numbers) length = std::hypot(length, number);
  return length;
}

class Features {
 public:
  explicit Features(const std::vector<ArgumentItem>& items) {
    for (const ArgumentItem& item : items) take(item);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      for (std::size_t j = i + 1; j < points_.size(); ++j) addPair(points_[i], points_[j]);
    }
    if (values_.size() > mostFeatures) values_.resize(mostFeatures);
  }

  std::vector<FeatureValue> take() { return std::move(values_); }

 private:
  struct Point {
    Leaf leaf;
    std::vector<double> at;
  };

  void add(const char* kind, std::vector<Leaf> of, double value) { values_.push_back({{kind, std::move(of)}, value}); }

  void take(const ArgumentItem& item) {
    switch (item.kind) {
      case Kind::Number:
        points_.push_back({item.leaf, item.numbers});
        return add("value", {item.leaf}, item.numbers.front());
      case Kind::Whole:
        return add("value", {item.leaf}, item.numbers.front());
      case Kind::Vector:
        return takeVector(item);
      case Kind::Stack:
        return;
      case Kind::List:
        return add("count", {item.leaf}, item.numbers.front());
      case Kind::Field:
        if (item.numbers.empty()) return;
        add("least", {item.leaf}, *std::ranges::min_element(item.numbers));
        add("most", {item.leaf}, *std::ranges::max_element(item.numbers));
    }
  }

  void takeVector(const ArgumentItem& item) {
    if (item.numbers.size() <= mostComponents) {
      add("length", {item.leaf}, lengthOf(item.numbers));
      points_.push_back({item.leaf, item.numbers});
      return;
    }
    for (std::size_t i = 0; i + 2 < item.numbers.size(); i += 3) {
      points_.push_back({{item.leaf.argument, item.leaf.field, static_cast<int>(i)},
                         {item.numbers[i], item.numbers[i + 1], item.numbers[i + 2]}});
    }
  }

  void addPair(const Point& a, const Point& b) {
    if (a.at.size() != b.at.size()) return;
    std::vector<double> apart = a.at;
    for (std::size_t i = 0; i < apart.size(); ++i) apart[i] -= b.at[i];
    add("distance", {a.leaf, b.leaf}, lengthOf(apart));
    if (apart.size() == 1) add("difference", {a.leaf, b.leaf}, apart.front());
  }

  std::vector<FeatureValue> values_;
  std::vector<Point> points_;
};

}  // namespace

std::vector<FeatureValue> featuresOf(const std::vector<ArgumentItem>& items) { return Features(items).take(); }

}  // namespace muelle::grader
