# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The cases whose quantities test_quantities.py computes a second time, and their runs with all records."""
import functools

import numpy as np

import mahlwerk

BALLS = {"count": 6, "diameter": "8 mm", "density": "7850 kg/m3", "youngs_modulus": "1 GPa"}
POWDER = {"mass": "2 g", "size": "40 um", "density": "4000 kg/m3"}
JAR = {"kind": "cylinder", "diameter": "40 mm", "height": "40 mm", "youngs_modulus": "1 GPa"}
THERMAL = {"density": "7850 kg/m3", "conductivity": "30 W/m/K", "heat_capacity": "460 J/kg/K"}
SHAKEN = {"kind": "vibration", "frequency": "20 Hz", "amplitude": "8 mm"}

CASES = {
    # Balls that fly: no sustained contact takes energy that no record has.
    "flying": {"mill": {**SHAKEN, "jars_carried": 2}, "jar": JAR, "balls": [BALLS], "powder": POWDER,
               "contact": {"restitution": 0.6, "friction": 0.3},
               "run": {"engine": "event", "time": "1 s", "settle": "0.2 s"},
               "milling": {"time": "2 h", "dose": "5 kJ/g"}, "heat": {},
               "wear": {"model": "finnie", "coefficient": 2e-4},
               "kinetics": {"model": "by-impact", "mass_per_hit": "2 ug", "scheme": "sequential",
                            "processed_share": 0.5, "second_share": 0.25, "molar_mass": "60 g/mol",
                            "time": "2 h", "property": "hardness", "initial": 1, "final": 3},
               "power_meter": {"interval": "0.1 s", "idle_power": "7 W", "efficiency": 0.5},
               "microphone": {"threshold": "0.2 mJ", "definition_time": "2 ms"}},
    # No friction: the normal impulses alone do the work of the jar.
    "frictionless": {"mill": {**SHAKEN, "jars_carried": 3}, "jar": JAR, "balls": [BALLS],
                     "contact": {"restitution": 0.6, "friction": 0},
                     "run": {"engine": "event", "time": "1 s", "settle": "0.2 s"},
                     "power_meter": {"interval": "0.05 s", "idle_power": "5 W", "efficiency": 0.8}},
    # Without weight: what the jar does and collisions lose is all that changes the kinetic energy.
    "weightless": {"gravity": "0 m/s2", "mill": SHAKEN, "jar": JAR, "balls": [BALLS],
                   "contact": {"restitution": 0.9, "friction": 0.3}, "observe": {"final_state": True},
                   "run": {"engine": "event", "time": "0.5 s", "settle": "0.2 s"}},
    # Two sets, one with balls of two sizes; three replicates.
    "mixed": {"mill": SHAKEN, "jar": {**JAR, "hardness": 600, "density": "7000 kg/m3"},
              "balls": [{**BALLS, "count": 4},
                        {"count": 5, "distribution": "uniform", "smallest": "6 mm", "largest": "10 mm", "classes": 2,
                         "density": "7850 kg/m3", "youngs_modulus": "1 GPa", "hardness": 400}],
              "contact": {"restitution": 0.6, "friction": 0.3}, "observe": {"final_state": True},
              "wear": {"model": "archard", "coefficient": 1e-3},
              "run": {"engine": "soft", "time": "0.4 s", "settle": "0.2 s", "replicates": 3}},
    # Contacts that last, one ball.
    "soft": {"mill": SHAKEN, "jar": JAR, "balls": [{**BALLS, "count": 1}],
             "contact": {"restitution": 0.6, "friction": 0.3, "rolling_friction": 0.05},
             "run": {"engine": "soft", "time": "1 s", "settle": "0.2 s"}},
    # Little friction: balls slip from the first to the last moment of an impact.
    "slippery": {"mill": SHAKEN, "jar": JAR, "balls": [{**BALLS, "count": 2}],
                 "contact": {"restitution": 0.6, "friction": 0.002, "rolling_friction": 0},
                 "run": {"engine": "soft", "time": "1 s", "settle": "0.2 s"}},
    # A bed with a layer that flows down.
    "drum": {"mill": {"kind": "tumbling", "speed": "30 %"}, "jar": {**JAR, "diameter": "100 mm"},
             "balls": [{**BALLS, "count": 120}], "powder": POWDER,
             "contact": {"restitution": 0.3, "friction": 0.7},
             "run": {"engine": "soft", "time": "0.5 s", "settle": "0.5 s", "replicates": 1}},
    # A slice of a ball mill with lifters.
    "slice": {"mill": {"kind": "tumbling", "speed": "20 rpm"},
              "jar": {"kind": "periodic-lifter-cylinder", "diameter": "2.4 m", "length": "0.6 m", "lifters": 12,
                      "lifter_height": "0.1 m", "lifter_width": "0.2 m", "mill_length": "3.6 m",
                      "youngs_modulus": "20 MPa"},
              "balls": [{**BALLS, "count": 120, "diameter": "0.2 m", "youngs_modulus": "20 MPa"}],
              "contact": {"restitution": 0.5, "friction": 0.5},
              "run": {"engine": "soft", "time": "0.5 s", "settle": "0.5 s"}},
    "blades": {"mill": {"kind": "still"}, "jar": {**JAR, "diameter": "60 mm", "hardness": 600}, "powder": POWDER,
               "balls": [{**BALLS, "count": 40, "hardness": 600}, {**BALLS, "count": 40, "hardness": 600}],
               "contact": {"restitution": 0.5, "friction": 0.4}, "mixing": {"colour": "across", "interval": "10 ms"},
               "parts": [{"name": "paddle", "kind": "blade", "length": "40 mm", "height": "20 mm", "thickness": "4 mm",
                          "position": ["0 mm", "0 mm", "-8 mm"], "motion": "turning", "speed": "300 rpm",
                          "hardness": 600}],
               "wear": {"model": "archard"},
               "run": {"engine": "soft", "time": "0.2 s", "settle": "0.1 s", "replicates": 1}},
    # A slice, thinner than the spheres of the packing fraction, of a drum that slips under its bed.
    "packed": {"mill": {"kind": "tumbling", "speed": "1 rpm"}, "observe": {"final_state": True},
               "jar": {"kind": "periodic-cylinder", "diameter": "96 mm", "length": "19.2 mm", "youngs_modulus": "1 GPa"},
               "balls": [{**BALLS, "count": 200}], "contact": {"restitution": 0.5, "friction": 0},
               "mixing": {"colour": "height", "interval": "10 ms"},
               "run": {"engine": "soft", "time": "0.1 s", "settle": "0.5 s", "replicates": 1}},
    # Balls that rain through the jar and enter again above.
    "hopper": {"mill": {"kind": "still"}, "jar": JAR,
               "balls": [{**BALLS, "count": 40, "diameter": "3 mm", "youngs_modulus": "20 MPa"}],
               "contact": {"restitution": 0.5, "friction": 0.1},
               "flow": {"outlet": ["0 mm", "0 mm", "-12 mm"], "feed": "recirculate", "interval": "1 ms",
                        "inlet": ["0 mm", "0 mm", "10 mm"], "inlet_size": ["20 mm", "20 mm", "10 mm"]},
               "run": {"engine": "soft", "time": "0.6 s", "settle": "0.1 s", "replicates": 1}},
    # Grains that break, down to particles that are not simulated.
    "breaking": {"mill": {"kind": "vibration", "frequency": "40 Hz", "amplitude": "8 mm"},
                 "jar": {**JAR, "diameter": "24 mm", "height": "24 mm"},
                 "balls": [{**BALLS, "count": 3}],
                 "powder": {"mass": "0.5 g", "size": "1.5 mm", "density": "2650 kg/m3", "as": "grains",
                            "youngs_modulus": "1 GPa"},
                 "contact": {"restitution": 0.5, "friction": 0.4},
                 "breakage": {"model": "vogel-peukert", "f_mat": "20 kg/J/m", "x_w_min": "1e-4 J m/kg"},
                 "fragments": {"model": "austin", "share": 0.4, "gamma": 0.8, "beta": 3},
                 "bed_breakage": {"smallest": "0.7 mm", "interval": "5 ms"},
                 "run": {"engine": "soft", "time": "0.05 s", "settle": "0.02 s", "replicates": 1}},
    # Powder that damps the bounce, by the hits of a run.
    "damped": {"mill": SHAKEN, "jar": JAR, "balls": [BALLS], "powder": POWDER,
               "contact": {"restitution": 0.6, "friction": 0.3},
               "capture": {"model": "fixed", "mass": "1e-4 ug"},
               "powder_feedback": {"absorbed_energy": "1 GJ/kg", "accuracy": 0.01},
               "run": {"engine": "event", "time": "0.5 s", "settle": "0.1 s", "replicates": 1}},
    "driven": {"mill": {"kind": "tumbling", "speed": "90 rpm"}, "jar": {**JAR, "diameter": "60 mm"},
               "drive": {"inertia": "2e-4 kg m2", "torque": "0.05 N m"}, "balls": [{**BALLS, "count": 40}],
               "contact": {"restitution": 0.5, "friction": 0.4},
               "run": {"engine": "soft", "time": "0.3 s", "settle": "0.1 s", "replicates": 1}},
    "planetary": {"mill": {"kind": "planetary", "orbit_radius": "70 mm", "speed": "300 rpm", "ratio": -2,
                           "jars_carried": 2},
                  "jar": JAR, "balls": [BALLS], "contact": {"restitution": 0.5, "friction": 0.4},
                  "run": {"engine": "soft", "time": "0.2 s", "settle": "0.1 s"}, "power_meter": {"interval": "20 ms"}},
    "stirred": {"mill": {"kind": "still", "jars_carried": 2}, "power_meter": {"interval": "5 ms"},
                "jar": {"kind": "attritor", "diameter": "100 mm", "height": "120 mm", "shaft_diameter": "20 mm",
                        "shaft_clearance": "10 mm", "arms": 4, "arm_diameter": "8 mm", "arm_span": "80 mm",
                        "arm_clearance": "20 mm", "arm_spacing": "20 mm", "rotor_speed": "300 rpm",
                        "youngs_modulus": "10 MPa"},
                "balls": [{**BALLS, "count": 40, "youngs_modulus": "10 MPa"}],
                "contact": {"restitution": 0.5, "friction": 0.3},
                "run": {"engine": "soft", "time": "0.05 s", "settle": "0.05 s"}},
    # One ball that moves through space freely, with a spin.
    "free": {"gravity": "0 m/s2", "mill": {**SHAKEN, "amplitude": "0 mm"}, "jar": JAR,
             "balls": [{**BALLS, "count": None, "positions": [["1 mm", "2 mm", "3 mm"]],
                        "velocities": [["0.003 m/s", "0 m/s", "0.004 m/s"]],
                        "spins": [["2 rad/s", "3 rad/s", "6 rad/s"]]}],
             "contact": {"restitution": 0.6, "friction": 0.3},
             "run": {"engine": "event", "time": "0.1 s", "settle": "0 s"}},
    # One elastic, head-on impact of a ball on the bottom.
    "impact": {"gravity": "0 m/s2", "mill": {"kind": "still"}, "jar": JAR,
               "balls": [{**BALLS, "count": None, "positions": [["0 mm", "0 mm", "-15 mm"]],
                          "velocities": [["0 m/s", "0 m/s", "-0.5 m/s"]]}],
               "contact": {"law": "hertz-mindlin", "restitution": 1, "friction": 0},
               "run": {"engine": "soft", "time": "20 ms", "settle": "0 s", "step_error": "0.2 %"}},
    # So long a milling that the temperatures are steady; powder whose grains all collisions catch alike.
    "warm": {"mill": SHAKEN, "jar": {**JAR, **THERMAL}, "balls": [{**BALLS, **THERMAL}], "powder": POWDER,
             "contact": {"restitution": 0.6, "friction": 0.3},
             "run": {"engine": "soft", "time": "0.3 s", "settle": "0.1 s"},
             "milling": {"time": "10 h"},
             "heat": {"cooling": "15 W/m2/K", "ball_exchange": "50 W/m2/K",
                      "share_in_balls": 0.4, "ambient": "20 degC"},
             "thermocouple": {"place": "balls", "lag": "0 s"},
             "power_meter": {"interval": "0.02 s"},
             "accelerometer": {"mass": "0.4 kg", "sample_rate": "10 kHz", "bandwidth": "1 kHz",
                               "duration": "0.15 s"},
             "capture": {"model": "fixed", "mass": "3 ug", "energy": "lost", "energy_share": 0.5},
             "breakage": {"model": "vogel-peukert", "f_mat": "0.1 kg/J/m", "x_w_min": "0.1 J m/kg"},
             "fragments": {"model": "halves"},
             "grinding": {"smallest": "4 um"},
             "kinetics": {"model": "ignition", "ignition_dose": "1 kJ/g", "dose": "dissipated"}},
    # Milling with pauses.
    "cycled": {"mill": SHAKEN, "jar": {**JAR, **THERMAL, "wall": "3 mm"}, "balls": [{**BALLS, **THERMAL, "count": 1}],
               "powder": POWDER, "contact": {"restitution": 0.6, "friction": 0.3},
               "run": {"engine": "event", "time": "1 s", "settle": "0.2 s"},
               "heat": {"milling": "10 min", "pause": "5 min", "cycles": 3, "cooling": "15 W/m2/K",
                        "ball_exchange": "50 W/m2/K", "share_in_balls": 0.4, "ambient": "20 degC"},
               "thermocouple": {"place": "gas", "lag": "60 s"},
               "kinetics": {"model": "thermal", "frequency_factor": "1e7 1/s", "activation_energy": "60 kJ/mol"}},
    # A reaction whose attempts are the hits above the threshold.
    "reacting": {"mill": SHAKEN, "jar": JAR, "balls": [BALLS], "powder": POWDER,
                 "contact": {"restitution": 0.6, "friction": 0.3},
                 "run": {"engine": "event", "time": "0.5 s", "settle": "0.2 s"},
                 "kinetics": {"model": "thermal", "attempts": "by-impact", "factor_per_impact": 100,
                              "activation_energy": "60 kJ/mol", "temperature": "350 K", "time": "1 h"}},
    # Hits that capture less than a grain, and others that capture many; one replicate.
    "ground": {"mill": SHAKEN, "jar": JAR, "balls": [BALLS], "powder": {**POWDER, "size": "0.3 mm"},
               "contact": {"restitution": 0.6, "friction": 0.3},
               "run": {"engine": "event", "time": "2 s", "settle": "0.2 s", "replicates": 1},
               "capture": {"model": "trapped-volume", "thickness": "50 um", "packing": 0.6, "energy_share": 0.8},
               "breakage": {"model": "vogel-peukert", "f_mat": "0.1 kg/J/m", "x_w_min": "0.01 J m/kg"},
               "fragments": {"model": "halves"},
               "grinding": {"time": "20 min", "smallest": "20 um", "method": "both"},
               "kinetics": {"law": "avrami", "dose": "captured", "dose_constant": "10 kJ/kg", "exponent": 1.5,
                            "onset": "2 kJ/kg", "molar_mass": "60 g/mol"}},
    # A jar of one face; two sets.
    "sphere": {"mill": SHAKEN, "jar": {"kind": "sphere", "diameter": "40 mm", "youngs_modulus": "1 GPa"},
               "balls": [{**BALLS, "count": 2}, {**BALLS, "count": 2, "diameter": "6 mm"}], "wear": {},
               "contact": {"restitution": 0.6, "friction": 0.3},
               "run": {"engine": "event", "time": "0.3 s", "settle": "0.2 s"}},
    # Powder of many sizes, which also welds.
    "spread": {"mill": SHAKEN, "jar": JAR, "balls": [BALLS],
               "powder": {"mass": "2 g", "distribution": "lognormal", "size": "40 um", "spread": 1.5,
                          "density": "4000 kg/m3"},
               "contact": {"restitution": 0.6, "friction": 0.3},
               "run": {"engine": "event", "time": "0.1 s", "settle": "0.2 s", "replicates": 1},
               "capture": {"model": "fixed", "mass": "3 ug"},
               "breakage": {"model": "vogel-peukert", "f_mat": "0.1 kg/J/m", "x_w_min": "0.1 J m/kg"},
               "fragments": {"model": "halves"},
               "grinding": {"time": "1 min", "smallest": "4 um", "classes_per_octave": 3, "welding": 0.1}},
    # Powder that coats balls and a jar with flat walls; nothing becomes of what is captured.
    "coated": {"mill": SHAKEN, "jar": {"kind": "box", "width": "40 mm", "depth": "50 mm", "height": "60 mm",
                                       "youngs_modulus": "1 GPa"},
               "balls": [BALLS], "powder": POWDER, "contact": {"restitution": 0.6, "friction": 0.3},
               "run": {"engine": "event", "time": "0.5 s", "settle": "0.2 s"},
               "capture": {"model": "surface-layer", "surface_density": "0.1 kg/m2", "energy": "contact-point"}},
    "grains": {"mill": {"kind": "still"}, "jar": JAR, "balls": [{**BALLS, "count": 1}],
               "powder": {"as": "grains", "mass": "0.1 g", "size": "0.5 mm", "grain_size": "2 mm",
                          "density": "4000 kg/m3", "youngs_modulus": "10 MPa"},
               "contact": {"restitution": 0.6, "friction": 0.3},
               "run": {"engine": "soft", "time": "10 ms", "settle": "0 s"}},
    "wet": {"mill": SHAKEN, "jar": JAR, "balls": [{**BALLS, "count": 2}],
            "liquid": {"kind": "film", "film": "10 um", "viscosity": "100 mPa s"},
            "contact": {"restitution": 0.6, "friction": 0.3},
            "run": {"engine": "soft", "time": "0.3 s", "settle": "0.1 s"}},
}


class Run:
    """A result with its records: one array per replicate."""

    def __init__(self, name):
        case = {"title": name, "seed": 7, **CASES[name]}
        case["run"] = {"replicates": 2, **case["run"]}
        case["balls"] = [{key: value for key, value in one.items() if value is not None} for one in case["balls"]]
        self.result = mahlwerk.Case(case).run(collisions=True)
        self.hits = [self.result.collisions(i + 1) for i in range(case["run"]["replicates"])]
        self.time = self["simulated_time"]
        self.begin = float(case["run"]["settle"].split()[0])  # [s] of counting
        self.balls = sum(one.get("count", 1) for one in case["balls"])

    def mean(self, of):
        """The mean over replicates of a function of the records."""
        return float(np.mean([of(hits) for hits in self.hits]))

    def __getitem__(self, name):
        return self.result[name].value

    def by_replicate(self, name):
        table = self.result.table("replicates")  # its columns have the unit behind the name
        return table[min((c for c in table.dtype.names if f"{c}_".startswith(f"{name}_")), key=len)]

    def mean_from(self, of, *names):
        """The mean over replicates of a function of other quantities."""
        return float(np.mean([of(*values) for values in zip(*map(self.by_replicate, names))]))


@functools.cache
def run_of(name):
    return Run(name)
