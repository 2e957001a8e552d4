// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/search/outcome_emulator.hpp"
#include "mahlwerk/campaign/store/store.hpp"
#include "mahlwerk/observe/statistics.hpp"

// Surrogate of a campaign: quantities as functions of the swept keys, without further runs
// (docs/campaigns.md, "A surrogate to take away").
namespace mahlwerk::campaign {

/// A swept key with the range of its values in the campaign.
struct SurrogateKey {
  std::string key;                    ///< "mill.speed"
  std::string least = {}, most = {};  ///< ends of the range, as in the campaign: "200 rpm"
  bool logarithmic = false;           ///< whether positions are by the logarithm of the value

  /// 0 at the least value, 1 at the largest. Throws UnitError if `text` is no quantity of the
  /// dimension of the range; std::nullopt if it is outside.
  std::optional<double> position(const std::string& text) const;
};

struct SurrogateQuantity {
  std::string name, unit, about;  ///< as in summary.json
  OutcomeEmulator emulator;
  HoldOut hold_out;
};

/// Mean of a quantity over replicates at a setting, with the 95 % interval of this mean.
observe::IntervalEstimate predict(const SurrogateQuantity& quantity, const DesignPoint& point);

struct CampaignSurrogate {
  static constexpr std::size_t most_settings = 1000;

  std::string title;
  std::string version;       ///< of the program that made it
  std::string digest = {};   ///< of the numbers it was made from, 16 hexadecimal digits
  std::size_t settings = 0;  ///< used
  std::size_t failed = 0;    ///< left out because they failed
  std::vector<std::string> engines = {};  ///< that ran the settings
  std::vector<SurrogateKey> keys = {};
  std::vector<std::string> following = {};  ///< keys whose values follow from the others
  std::vector<SurrogateQuantity> quantities = {};
  results::NoticeCounts notices = {};  ///< of the settings

  /// The point of a setting. Throws InputError, with all faults, if it names other keys, lacks one,
  /// or leaves a range: a surrogate does not extrapolate.
  DesignPoint point(const std::vector<cases::Override>& setting) const;
};

/// The surrogate of the settings of a campaign that have ended, for the named quantities. Throws
/// InputError if there are too few settings, a key has no numbers, or a quantity is unknown.
CampaignSurrogate surrogate_of(const Store& store, const std::string& folder,
                               const std::vector<std::string>& quantities,
                               std::string_view version);

/// The file of a surrogate (docs/formats.md), and the surrogate of a file with the same bits.
std::string surrogate_text(const CampaignSurrogate& surrogate);
/// Throws InputError if `file` cannot be read, is damaged, or is of a newer format.
CampaignSurrogate read_surrogate(const std::filesystem::path& file);

}  // namespace mahlwerk::campaign
