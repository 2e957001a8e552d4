// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace mahlwerk::cases {

/// The values of the sections that parts (cases/part.hpp) add to a case, one of each type. A case
/// holds them without knowing their types. Copies share them; a new value replaces the old one.
class PartValues {
 public:
  /// The value of that type; null if the case has no such section.
  template <class Section>
  const Section* find() const {
    for (const auto& one : all_)
      if (const auto* held = dynamic_cast<const Held<Section>*>(one.get())) return &held->value;
    return nullptr;
  }
  template <class Section>
  void set(Section value) {
    std::erase_if(all_, [](const auto& one) {
      return dynamic_cast<const Held<Section>*>(one.get()) != nullptr;
    });
    all_.push_back(std::make_shared<const Held<Section>>(std::move(value)));
  }
  /// Equal values, in any order.
  bool operator==(const PartValues& other) const {
    return all_.size() == other.all_.size() && std::ranges::all_of(all_, [&](const auto& one) {
             return std::ranges::any_of(other.all_,
                                        [&](const auto& its) { return one->equals(*its); });
           });
  }

 private:
  struct Any {
    virtual ~Any() = default;
    virtual bool equals(const Any& other) const = 0;
  };
  template <class Section>
  struct Held final : Any {
    explicit Held(Section of) : value(std::move(of)) {}
    bool equals(const Any& other) const override {
      const auto* same = dynamic_cast<const Held*>(&other);
      return same != nullptr && same->value == value;
    }
    Section value;
  };
  std::vector<std::shared_ptr<const Any>> all_;
};

}  // namespace mahlwerk::cases
