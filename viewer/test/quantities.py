# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Checks of a replay whose data hold spins, densities and hits, and of one without them."""

import synthetic
from pictures import changed

dataset = "document.querySelector('#replay').dataset"


def check_quantities_and_hits(checks):
    """Colours of what the data hold, marks of hits, and what is known of a picked ball."""
    browser = checks.browser
    offered = ("[...document.querySelectorAll('#replay [aria-label=Colour] button')]"
               ".map(b => b.dataset.key)")
    checks.open("vial_of_version_1", synthetic.vial())
    found = browser.ask(offered), checks.state("hits")
    checks.say("without_spins_and_hits_they_are_not_offered", found, (["speed", "species"], "none"),
               found == (["speed", "species"], "none"))
    checks.open("hits", synthetic.with_hits(synthetic.planetary(), 0.013))
    found = browser.ask(offered)
    checks.say("spin_and_energy_are_offered", found, ["speed", "spin", "energy", "species"],
               found == ["speed", "spin", "energy", "species"])
    checks.scrub(11)
    pictures = {}
    for key in ("speed", "spin", "energy"):
        checks.press_view(key)
        pictures[key] = checks.picture(key)
    part = min(changed(pictures["speed"], pictures[key]) for key in ("spin", "energy"))
    checks.say("they_have_colours_of_their_own", f"{part:.2%} changed", "above 0.2%", part > 0.002)
    checks.say("reduced_motion_hides_hits", checks.state("hits"), "off", checks.state("hits") == "off")
    browser.ask("document.querySelector('#replay .scene').focus()")
    browser.key("h")
    browser.wait_for(f"+{dataset}.hits > 1", 10)
    part = changed(pictures["energy"], checks.picture("marks"))
    marks = checks.state("hits")
    checks.say("the_hits_of_the_last_frames_are_marked", f"{marks} marks, {part:.2%} changed",
               "some, above 0.1%", marks.isdigit() and int(marks) > 1 and part > 0.001)
    checks.quiet()
