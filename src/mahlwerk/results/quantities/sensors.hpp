// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/table.hpp"

// What the sensors of a case show (docs/theory/sensors.md). Records over time are those of the
// first averaged replicate, as a sensor sees one run; quantities are means over replicates.
namespace mahlwerk::results {

/// Quantities of the sensors that the case has.
Measures sensor_measures();

// Tables without rows if the case has no such sensor.
Table power_readings(const Outcome& outcome);         ///< power_meter.csv: a row per reading
Table heard_hits(const Outcome& outcome);             ///< microphone.csv: a row per bin of energy
Table acceleration(const Outcome& outcome);           ///< accelerometer.csv: a row per sample
Table thermocouple_readings(const Outcome& outcome);  ///< thermocouple.csv: over milling and pauses

/// Warnings about sensors that the run cannot imitate well.
Notices sensor_warnings(const Outcome& outcome);

}  // namespace mahlwerk::results
