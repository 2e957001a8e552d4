// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/report/plot/svg_plot.hpp"
#include "mahlwerk/results/outcome.hpp"

// Plots of what the sensors of a case show. Each requires its sensor.
namespace mahlwerk::report {

Plot power_meter_plot(const results::Outcome& outcome);  ///< the motor's power over time
Plot torque_plot(const results::Outcome& outcome);  ///< the same for the torque; mills with a shaft
Plot microphone_plot(const results::Outcome& outcome);     ///< hits per second above an energy
Plot accelerometer_plot(const results::Outcome& outcome);  ///< acceleration over a short time
Plot thermocouple_plot(const results::Outcome& outcome);   ///< reading and true temperature

}  // namespace mahlwerk::report
