# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""What an RO-Crate must be, by the specification, version 1.1 (https://w3id.org/ro/crate/1.1): root-data-entity,
data-entities, provenance, appendix/jsonld."""
import json
import re
from pathlib import Path
from urllib.parse import unquote

# Of the context of RO-Crate 1.1 (CC0), the terms that a crate of Mahlwerk may use.
TYPES = {"CreativeWork", "Dataset", "File", "PropertyValue", "CreateAction", "SoftwareApplication", "Person",
         "ScholarlyArticle", "Comment"}
TERMS = {"about", "conformsTo", "name", "description", "datePublished", "license", "hasPart", "author",
         "variableMeasured", "citation", "mentions", "comment", "text", "propertyID", "value", "minValue",
         "maxValue", "unitCode", "unitText", "measurementTechnique", "instrument", "agent", "object", "result",
         "actionStatus", "error", "version", "encodingFormat", "contentSize"}
# Atoms of UCUM that occur, with their prefixes.
ATOM = r"(?:\{rev\}|Cel|%|\[in_i\]|[munkMG]?(?:m|g|s|Hz|J|W|Pa|N|K|L|mol)|min|h|deg|rad|1)-?\d*"
UCUM = re.compile(rf"/?{ATOM}(?:[./]{ATOM})*")


class Invalid(Exception):
    pass


def need(truth, what):
    if not truth:
        raise Invalid(what)


def listed(value):
    return value if isinstance(value, list) else [value]


def references(entity):
    """Ids that an entity refers to. Entities must not be nested: a reference has "@id" alone."""
    for name, value in entity.items():
        if name.startswith("@"):
            continue
        for one in listed(value):
            if isinstance(one, dict):
                need(set(one) == {"@id"}, f"{entity['@id']}: {name} holds an entity that is not in the graph")
                yield one["@id"]


def is_address(text):
    return re.match(r"https?://[^\s<>\"]+$", text) is not None


def check_graph(crate):
    """Flattened and compacted JSON-LD of known terms; every reference leads somewhere."""
    need(crate.get("@context") == "https://w3id.org/ro/crate/1.1/context", "the context is not that of RO-Crate 1.1")
    need(set(crate) == {"@context", "@graph"}, "there is more than context and graph")
    need(isinstance(crate["@graph"], list), "the graph is no list")
    entities = {}
    for one in crate["@graph"]:
        need(isinstance(one.get("@id"), str) and one["@id"], "an entity has no @id")
        need(one["@id"] not in entities, f"{one['@id']} stands twice")
        need(not re.search(r"[\s\"<>\\^`{|}]|%(?![0-9A-F]{2})|\.\./", one["@id"]), f"{one['@id']} is no valid URI")
        need("@type" in one and set(listed(one["@type"])) <= TYPES, f"{one['@id']}: unknown type {one.get('@type')}")
        unknown = {name for name in one if not name.startswith("@")} - TERMS
        need(not unknown, f"{one['@id']}: {unknown} are not in the context")
        for name, value in one.items():
            need(value is not None and value != [], f"{one['@id']}: {name} is empty")
            need(not isinstance(value, list) or len(value) > 1, f"{one['@id']}: {name} is a list of one")
        entities[one["@id"]] = one
    for one in crate["@graph"]:
        for target in references(one):
            outside = is_address(target) and listed(one["@type"]) != ["Dataset"]
            need(target in entities or outside, f"{one['@id']} refers to {target}, which is not there")
    return entities


def root_of(entities):
    """By the algorithm of the specification, "Finding the Root Data Entity"."""
    described = entities.get("ro-crate-metadata.json")
    need(described is not None, "there is no descriptor of the file of metadata")
    need(described["@type"] == "CreativeWork", "the descriptor is no CreativeWork")
    need(described.get("conformsTo") == {"@id": "https://w3id.org/ro/crate/1.1"}, "the version is not stated")
    need("about" in described, "the descriptor has no `about`")
    root = entities[described["about"]["@id"]]
    need(root["@id"] == "./" and "Dataset" in listed(root["@type"]), "the root is no Dataset with the id ./")
    for name in ("name", "description", "datePublished", "license"):
        need(name in root, f"the root has no {name}")
    need(re.match(r"\d{4}-\d{2}-\d{2}", str(root["datePublished"])), "datePublished is not given to the day")
    for one in listed(root["license"]):
        if isinstance(one, dict):
            need({"name", "description"} <= set(entities[one["@id"]]), "the license has no name or description")
    return root


def check_files(entities, root, folder):
    """Data entities are linked from the root, and are there."""
    parts = {one["@id"] for one in listed(root["hasPart"])}
    data = {key for key, one in entities.items()
            if "File" in listed(one["@type"]) or ("Dataset" in listed(one["@type"]) and key != "./")}
    need(data == parts, f"hasPart and the data entities differ: {data ^ parts}")
    for key in parts:
        place = Path(folder, unquote(key))
        if key.endswith("/"):
            need(place.is_dir(), f"{key} is no folder")
            continue
        need(place.is_file(), f"{key} is no file")
        need(entities[key]["contentSize"] == str(place.stat().st_size), f"{key} has another size")
        need("/" in entities[key]["encodingFormat"], f"{key} has no format")


def check_values(entities):
    for key, one in entities.items():
        if one["@type"] != "PropertyValue":
            continue
        need({"name", "value", "propertyID"} <= set(one), f"{key} has no name or value")
        if isinstance(one["value"], (int, float)) and not isinstance(one["value"], bool):
            need("unitText" in one, f"{key} has no unit")
        if "unitCode" in one:
            code = one["unitCode"]
            need(code.startswith("UCUM:") and UCUM.fullmatch(code[5:]), f"{key}: {code} is no code of UCUM")
        if "minValue" in one:
            need(one["minValue"] <= one["value"] <= one["maxValue"], f"{key} lies outside its interval")
            need("95 %" in one["measurementTechnique"], f"{key} does not say what the interval is")


def check_action(entities, root):
    """Provenance: software with a version made the results from the inputs."""
    action = entities[root["mentions"]["@id"]]
    need(action["@type"] == "CreateAction" and "name" in action, "there is no named action")
    software = entities[action["instrument"]["@id"]]
    need(software["@type"] == "SoftwareApplication" and "version" in software, "the software has no version")
    for name in ("object", "result"):
        need(all(one["@id"] in entities for one in listed(action[name])), f"{name} of the action is not there")
    status = action["actionStatus"]["@id"].rsplit("/", 1)[1]
    need(status in ("CompletedActionStatus", "FailedActionStatus"), f"unknown status {status}")
    need((status == "FailedActionStatus") == ("error" in action), "status and error do not agree")


def checked(folder, crate=None):
    """The entities of a valid crate by id, and its root. Raises Invalid."""
    if crate is None:
        crate = json.loads(Path(folder, "ro-crate-metadata.json").read_text(encoding="utf-8"))
    entities = check_graph(crate)
    root = root_of(entities)
    check_files(entities, root, folder)
    check_values(entities)
    check_action(entities, root)
    return entities, root
