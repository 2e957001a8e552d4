# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Words by which users search for a page and which its text does not have.

They become the keywords of the page, which Sphinx puts into the index of the search. A search finds a page
that has all of its words. tests/docs/site_test.py tries the searches below.
"""

WORDS = {
    "howto/settings": "transfer scale convert recipe BPR ratio optimum optimal dose energy gram MM400 number",
    "howto/product": "abrasion debris iron steel impurity worn contamination temperature heating thermal psd distribution "
                     "sieve mechanochemistry yield",
    "howto/results": "cutoff count Excel spreadsheet plot graph picture image VTK animation video figure energy",
    "howto/notebook": "cite citation methods section paragraph bibliography reference",
    "howto/trust": "uncertainty error bar accuracy precision validation confidence standard deviation",
    "howto/mixer": "MM200 MM400 MM500 Retsch SPEX mechanochemistry",
    "howto/planetary": "Pulverisette P5 P6 P7 PM100 PM400 Fritsch Retsch",
    "howto/drum": "rotary tumbling cascading cataracting centrifuging critical",
    "howto/mill-power": "kilowatt draw SAG AG semi-autogenous lifter liner motor energy consumption",
    "howto/wear": "abrasion lifetime liner life replacement",
    "howto/bond": "F80 P80 comminution kWh grindability BWI top size",
    "howto/flow": "overflow grate discharge throughput continuous classifier closed circuit RTD",
    "howto/computing": "HPC parallel MPI Slurm cluster GPU CUDA speed slow",
    "howto/machine": "custom slurry wet LAG liquid-assisted",
    "install": "Windows macOS Mac Ubuntu Docker conda download setup",
}
# Searches and the pages that they must find.
SEARCHES = {
    "abrasion": "howto/product", "iron contamination": "howto/product", "wear debris": "howto/product",
    "jar temperature": "howto/product", "transfer recipe": "howto/settings", "BPR": "howto/settings",
    "methods section": "howto/notebook", "error bar": "howto/trust", "MM400": "howto/mixer", "Excel": "howto/results",
    "F80": "howto/bond", "overflow": "howto/flow", "closed circuit": "howto/flow", "Windows": "install",
    "mechanochemistry": "howto/mixer", "power draw": "howto/mill-power", "liner life": "howto/wear", "MPI": "howto/computing",
}


def front_matter(name: str) -> str:
    """The head of the page of this name that gives its keywords to Sphinx; empty without such words."""
    words = ", ".join(WORDS.get(name, "").split())
    return f'---\nmyst:\n  html_meta:\n    keywords: "{words}"\n---\n' if words else ""
