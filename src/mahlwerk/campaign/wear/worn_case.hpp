// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mahlwerk/campaign/wear/worn_state.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/cases/wear.hpp"
#include "mahlwerk/geometry/worn_surface.hpp"
#include "mahlwerk/observe/wear_record.hpp"

namespace mahlwerk::campaign {

/// A case whose shapes and ball sizes follow their wear: which bodies these are, and the case of a
/// stage. Lifters of a drum become a part of it, whose section is their exact outline.
class WornCase {
 public:
  /// A bar with a section, or equal bars about its own axis.
  struct Profile {
    std::size_t part = 0;  ///< of the machine parts
    double rows = 1;       ///< equal bars
    double length = 0;     ///< [m] of a bar inside the jar
    double piece = 0;      ///< [m] length of the pieces of its sides
    double height = 0;     ///< [m] by which it stands out from the shell when new
  };

  /// A body of triangles whose vertices move: a mesh of the jar, or a solid part.
  struct MeshBody {
    std::optional<std::size_t> part;  ///< of the machine parts; none: the jar
    geometry::WornSide side = geometry::WornSide::outside;
  };

  /// Throws InputError where the file of a section cannot be read.
  explicit WornCase(const cases::Case& mill_case);

  const cases::Case& mill_case() const { return case_; }
  const cases::Wear& wear() const { return *case_.parts.find<cases::Wear>(); }
  const WornState& fresh() const { return fresh_; }
  const std::vector<Profile>& profiles() const { return profiles_; }
  const std::vector<MeshBody>& meshes() const { return meshes_; }
  const std::string& name_of(const Profile& one) const {
    return case_.machine_parts[one.part].name;
  }
  /// Ball sets without grains: their indices in the case.
  const std::vector<std::size_t>& sets() const { return sets_; }
  /// [m] Diameter of a fresh ball of each of these sets.
  double fresh_size(std::size_t set) const { return fresh_.charges[set].front().diameter; }
  /// Names of bodies that wear but keep their shape.
  const std::vector<std::string>& kept() const { return kept_; }
  double smoothing() const { return smoothing_; }  ///< [m] (wea.11)

  /// The case of a stage: its shapes, and a ball set for each cohort that has balls.
  cases::Case at(const WornState& state) const;
  /// The set and the cohort of each ball set of at(state), without grains.
  std::vector<std::pair<std::size_t, std::size_t>> cohorts(const WornState& state) const;
  /// The bodies whose wear is recorded by cells, in the order of profiles(), then meshes().
  std::vector<observe::WornBody> bodies(const cases::Case& stage, const WornState& state) const;
  /// Whether the middle of each side of a profile is inside the jar.
  std::vector<bool> exposed(const WornState& state, std::size_t profile) const;
  /// [m] by which a profile stands out from the shell; 0 or less once it is worn away.
  double height(const WornState& state, std::size_t profile) const;
  /// [1] Share of the shell that the profiles do not cover.
  double bare_share(const WornState& state) const;

 private:
  void add_profile(std::size_t part, geometry::Section section);
  void add_mesh(std::optional<std::size_t> part, const geometry::Surface& surface,
                geometry::WornSide side);
  geometry::Section read_section(const cases::MachinePart& part) const;
  double length_in_jar(const cases::MachinePart& part) const;

  cases::Case case_;
  WornState fresh_;
  std::vector<Profile> profiles_;
  std::vector<MeshBody> meshes_;
  std::vector<std::size_t> sets_;
  std::vector<std::string> kept_;
  double smoothing_ = 0;
};

/// The jar of a drum with lifters as a jar without them, and the lifters as a part. Other cases
/// stay. `section` takes the outline of a lifter, if there are such.
cases::Case with_lifters_as_part(cases::Case mill_case, geometry::Section& section);

}  // namespace mahlwerk::campaign
