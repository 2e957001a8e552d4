// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/mixing/tables.hpp"

#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::parts::mixing {

using results::Outcome;
using results::Replicate;
using results::Table;

Table series(const Outcome& outcome) {
  Table table{{{"time", "s", "time since counting began"},
               {"lacey_index", "1", "Lacey's mixing index"},
               {"neighbour_mixing_index", "1", "share of neighbours of the other colour"},
               {"segregation_radial", "1", "of the first colour, away from the axis"},
               {"segregation_vertical", "1", "of the first colour, upwards"},
               {"segregation_axial", "1", "of the first colour, along the axis"},
               {"axial_spread", "m2", "mean square way of the balls along the axis"},
               {"packing_fraction", "1", "mean in the bed"},
               {"bed_height", "m", "of all but the highest 2 % of the balls"}},
              {}};
  const auto chosen = results::averaged_replicates(outcome);
  const std::size_t least =
      results::fewest_over(chosen, [](const Replicate& r) { return samples_of(r).size(); });
  for (std::size_t i = 0; i < least; ++i) {
    const auto of = [&](double MixingSample::*member) {
      return results::mean_over(chosen,
                                [&](const Replicate& r) { return samples_of(r)[i].*member; });
    };
    table.rows.push_back({of(&MixingSample::time), of(&MixingSample::lacey),
                          of(&MixingSample::neighbours), of(&MixingSample::radial),
                          of(&MixingSample::vertical), of(&MixingSample::axial),
                          of(&MixingSample::axial_spread), of(&MixingSample::packing),
                          of(&MixingSample::bed_height)});
  }
  return table;
}

Table packing_profile(const Outcome& outcome) {
  Table table{{{"height", "m", "middle of a layer, above the lowest point of the balls"},
               {"packing_fraction", "1", "mean over the points of the layer that are in the bed"},
               {"points", "1", "number of points"}},
              {}};
  for (const Replicate* r : results::averaged_replicates(outcome)) {
    const MixingRecord& record = *r->recorders.find<MixingRecord>();
    for (const PackingAtHeight& one : record.profile()) {
      if (one.sample < record.samples().size() / 2) continue;
      for (std::size_t i = table.rows.size(); i <= one.layer; ++i)
        table.rows.push_back({(static_cast<double>(i) + 0.5) * record.layer_height(), 0, 0});
      table.rows[one.layer][1] += one.sum, table.rows[one.layer][2] += one.points;
    }
  }
  for (auto& row : table.rows) row[1] = results::share(row[1], row[2]);
  std::erase_if(table.rows, [](const auto& row) { return row[2] == 0; });
  return table;
}

}  // namespace mahlwerk::parts::mixing
