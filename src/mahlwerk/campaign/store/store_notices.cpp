// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Notices of a campaign's runs.
#include "mahlwerk/campaign/store/store.hpp"

namespace mahlwerk::campaign {

/// Replaces the notices of an earlier attempt.
void Store::keep_notices(std::string_view hash, const Notices& notices) {
  database_.prepare("DELETE FROM notices WHERE hash = ?").bind(1, hash).run();
  if (!notice_) notice_.emplace(database_.prepare("INSERT INTO notices VALUES(?, ?, ?, ?, ?)"));
  for (std::size_t i = 0; i < notices.size(); ++i)
    notice_->bind(1, hash)
        .bind(2, static_cast<std::int64_t>(i))
        .bind(3, notices[i].code)
        .bind(4, name_of(notices[i].severity))
        .bind(5, notices[i].text)
        .run();
}

results::NoticeCounts Store::notices() const {
  const std::lock_guard lock(mutex_);
  Statement asked = database_.prepare(
      "SELECT n.code, n.severity, n.text, p.point FROM points p JOIN notices n ON n.hash = p.hash "
      "ORDER BY p.point, n.position");
  results::NoticeCounts counts;
  Notices of_point;
  std::int64_t point = 0;
  const auto end_point = [&] {
    results::count(counts, of_point);
    of_point.clear();
  };
  while (asked.step()) {
    if (asked.integer(3) != point) end_point();
    point = asked.integer(3);
    of_point.push_back({asked.text(0), severity_of(asked.text(1)), asked.text(2)});
  }
  end_point();
  results::sort(counts);
  return counts;
}

}  // namespace mahlwerk::campaign
