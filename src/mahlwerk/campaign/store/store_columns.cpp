// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Columns of a campaign's results: the quantities of all runs, in an order that does not depend on
// the order in which runs end.
#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "mahlwerk/base/fingerprint.hpp"
#include "mahlwerk/campaign/store/store.hpp"

namespace mahlwerk::campaign {
namespace {

using results::Quantity;
using Quantities = std::vector<Quantity>;  // values are missing

auto key_of(const Quantity& q) {
  return std::tie(q.name, q.unit, q.about);
}

bool same_form(const Quantities& one, const Quantities& other) {
  return std::ranges::equal(one, other, {}, key_of, key_of);
}

std::string name_of_form(const Quantities& form) {
  std::string all;
  for (const Quantity& q : form) all += fmt::format("{}\n{}\n{}\n", q.name, q.unit, q.about);
  return hash_text(fingerprint(all));
}

Quantity quantity(const Statement& row, int name) {
  Quantity q;
  q.name = row.text(name);
  q.unit = row.text(name + 1);
  q.about = row.text(name + 2);
  return q;
}

/// Merges lists of quantities, the longest first. A new quantity is inserted after its predecessor
/// in its own list.
Quantities merged(std::vector<Quantities> forms) {
  std::ranges::sort(forms, [](const Quantities& a, const Quantities& b) {
    if (a.size() != b.size()) return a.size() > b.size();
    return std::ranges::lexicographical_compare(a, b, {}, key_of, key_of);
  });
  Quantities all;
  for (const Quantities& form : forms) {
    auto next = all.begin();
    for (const Quantity& q : form) {
      const auto known = std::ranges::find(all, q.name, &Quantity::name);
      next = 1 + (known != all.end() ? known : all.insert(next, q));
    }
  }
  return all;
}

}  // namespace

Quantities Store::known_quantities() const {
  Quantities list;
  Statement asked = database_.prepare("SELECT name, unit, about FROM quantities ORDER BY position");
  while (asked.step()) list.push_back(quantity(asked, 0));
  return list;
}

/// Keeps a list of quantities; true if it is new.
bool Store::keep_form(const Quantities& form) {
  const std::string name = name_of_form(form);
  Statement known = database_.prepare("SELECT 1 FROM main.forms WHERE form = ? LIMIT 1");
  bool there = false;
  known.bind(1, name);
  while (known.step()) there = true;
  if (there) return false;
  Statement add = database_.prepare("INSERT INTO main.forms VALUES(?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < form.size(); ++i)
    add.bind(1, name)
        .bind(2, static_cast<std::int64_t>(i))
        .bind(3, form[i].name)
        .bind(4, form[i].unit)
        .bind(5, form[i].about)
        .run();
  return true;
}

/// Keeps the list of a store that an earlier version made.
void Store::keep_old_form() {
  if (database_.query_text("SELECT count(*) FROM main.forms") != "0") return;
  if (const Quantities old = known_quantities(); !old.empty()) keep_form(old);
}

/// Adds columns for new quantities, and puts all columns in order.
void Store::add_columns(const Quantities& quantities) {
  keep_old_form();
  if (!keep_form(quantities)) return;
  add_unknown(quantities);
  put_in_order();
}

/// The same for the store attached as `other`.
void Store::add_columns_of_other(const Quantities& quantities) {
  const bool has_forms =
      database_.query_text("SELECT count(*) FROM other.sqlite_master WHERE name = 'forms'") !=
          "0" &&
      database_.query_text("SELECT count(*) FROM other.forms") != "0";
  if (!has_forms) return add_columns(quantities);
  keep_old_form();
  database_.run("INSERT OR IGNORE INTO main.forms SELECT * FROM other.forms");
  add_unknown(quantities);
  put_in_order();
}

void Store::add_unknown(const Quantities& quantities) {
  const Quantities known = known_quantities();
  Statement add = database_.prepare(
      "INSERT INTO quantities(name, unit, about, \"column\", ci95_column) VALUES(?, ?, ?, ?, ?)");
  for (const Quantity& q : quantities) {
    if (std::ranges::find(known, q.name, &Quantity::name) != known.end()) continue;
    const auto [column, ci95] = columns_of(q);
    add.bind(1, q.name).bind(2, q.unit).bind(3, q.about).bind(4, column).bind(5, ci95).run();
    database_.run(
        fmt::format("ALTER TABLE summary ADD COLUMN {} REAL; ALTER TABLE summary ADD "
                    "COLUMN {} REAL",
                    quoted_name(column), quoted_name(ci95)));
  }
}

void Store::put_in_order() {
  std::vector<Quantities> forms;
  std::string last;
  Statement asked =
      database_.prepare("SELECT form, name, unit, about FROM main.forms ORDER BY form, position");
  while (asked.step()) {
    if (forms.empty() || asked.text(0) != last) forms.emplace_back();
    last = asked.text(0);
    forms.back().push_back(quantity(asked, 1));
  }
  database_.run("UPDATE main.quantities SET position = -1 - position");
  Statement place =
      database_.prepare("UPDATE main.quantities SET position = ?, about = ? WHERE name = ?");
  std::int64_t position = 0;
  for (const Quantity& q : merged(std::move(forms)))
    place.bind(1, ++position).bind(2, q.about).bind(3, q.name).run();
  make_view();
}

void Store::prepare_summary(const Quantities& quantities) {
  if (summary_ && same_form(summary_form_, quantities)) return;
  summary_.reset();
  add_columns(quantities);
  summary_form_ = quantities;
  std::string columns = "hash", marks = "?";
  for (const Quantity& q : quantities) {
    const auto [column, ci95] = columns_of(q);
    columns += fmt::format(", {}, {}", quoted_name(column), quoted_name(ci95));
    marks += ", ?, ?";
  }
  summary_.emplace(database_.prepare(
      fmt::format("INSERT OR REPLACE INTO summary({}) VALUES({})", columns, marks)));
}

}  // namespace mahlwerk::campaign
