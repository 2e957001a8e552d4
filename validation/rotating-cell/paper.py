# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
from mahlwerk.papers import Paper

paper = Paper(title="Bed of a small rotating cell (GranuDrum)",
              source="photographs of a GranuDrum with microcrystalline cellulose: A in "
                     "ACCES-GranuDrum-Calibration (A. L. Nicusan et al., arXiv:2505.02967), B in "
                     "ACCES-CoExSiST, both of the University of Birmingham's Positron Imaging Centre",
              about="A cell of 84 mm by 20 mm, half full, turns at 10 to 60 rpm. Time-averaged "
                    "photographs show the bed; its centre of mass follows from the area below the "
                    "surface, at uniform density. The horizontal distance of this centre from the "
                    "axis is the torque of the charge over its weight: an optical measurement of "
                    "the power. Two lots of cellulose were measured. Their friction is unknown and "
                    "is assumed over a wide range. Our grains are spheres, twice as large as the "
                    "real ones.",
              licence="GPL-3.0 (images); the numbers read from them are facts and stand here",
              quick=False)

speed = paper.campaign("speed")

measured_a = paper.measured(
    "A",
    source="centroids of the averaged photographs gd_nature_10rpm, 30rpm and 45rpm; read by us from "
           "the images (commit e5c6dd0b), half way between the greys of bed and air",
    status="verified",
    error_is="shift of the grey threshold between 70 and 202",
    values=[
        ("10 rpm", "10.00 mm", "0.34 mm"),
        ("30 rpm", "11.41 mm", "0.34 mm"),
        ("45 rpm", "12.07 mm", "0.34 mm")])
measured_b = paper.measured(
    "B",
    source="centroids of the averaged photographs 10rpm_avg, 30rpm_avg and 60rpm_avg; read by us "
           "from the images (commit 4360abf2), between both edges of the drawn outline",
    status="verified",
    error_is="distance between both edges of the outline",
    values=[
        ("10 rpm", "7.65 mm", "0.34 mm"),
        ("30 rpm", "9.28 mm", "0.34 mm"),
        ("60 rpm", "11.31 mm", "0.34 mm")])
measured_a_relative = paper.measured(
    "A, relative",
    source="the same, over the value at 10 rpm; the errors of the threshold cancel",
    status="verified",
    error_is="shift of the grey threshold between 70 and 202",
    values=[
        ("30 rpm", "1.141", "0.006"),
        ("45 rpm", "1.207", "0.009")])
measured_b_relative = paper.measured(
    "B, relative",
    source="the same, over the value at 10 rpm",
    status="verified",
    error_is="distance between both edges of the outline",
    values=[
        ("30 rpm", "1.213", "0.005"),
        ("60 rpm", "1.479", "0.005")])

paper.figure("1a", "lever arm of the charge against the speed, lot A",
             speed.curve("charge_lever_arm", against="mill.speed",
                         band_over=["contact.friction", "contact.rolling_friction"],
                         measured=measured_a))
paper.figure("1b", "lever arm of the charge against the speed, lot B",
             speed.curve("charge_lever_arm", against="mill.speed",
                         band_over=["contact.friction", "contact.rolling_friction"],
                         measured=measured_b))

paper.check("1a", "lever arm of the charge at 10 to 45 rpm, lot A",
            speed.agrees_with(measured_a, "charge_lever_arm", against="mill.speed"))
paper.check("1b", "lever arm of the charge at 10 to 60 rpm, lot B",
            speed.agrees_with(measured_b, "charge_lever_arm", against="mill.speed"))
paper.check("1a", "lever arm over that at 10 rpm: how the torque grows with the speed, lot A",
            speed.agrees_with(measured_a_relative, "charge_lever_arm", against="mill.speed",
                              relative_to="10 rpm"))
paper.check("1b", "lever arm over that at 10 rpm: how the torque grows with the speed, lot B",
            speed.agrees_with(measured_b_relative, "charge_lever_arm", against="mill.speed",
                              relative_to="10 rpm"))
