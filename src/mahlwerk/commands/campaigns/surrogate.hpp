// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/campaign/surrogate/campaign_surrogate.hpp"
#include "mahlwerk/results/files/json_value.hpp"

namespace mahlwerk::commands {

/// What a surrogate knows: what it was made from, keys with ranges, quantities with hold-out
/// errors, warnings of the campaign.
std::string surrogate_words(const campaign::CampaignSurrogate& surrogate);
results::Json surrogate_json(const campaign::CampaignSurrogate& surrogate);

}  // namespace mahlwerk::commands
