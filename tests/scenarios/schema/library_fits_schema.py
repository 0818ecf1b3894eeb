# SPDX-License-Identifier: MIT
"""library_fits_schema.py PROGRAM LIBRARY: the library's files fit the schema that the program prints, and files
with faults do not. Exits with 77 where no validator is installed."""
import json
import pathlib
import subprocess
import sys

try:
    import jsonschema
    import yaml
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

HEAD = {"schema": 1, "name": "a", "duration": 2}
BAD = [
    {**HEAD, "durration": 2},
    {**HEAD, "duration": 0},
    {**HEAD, "seed": -1},
    {"schema": 1, "name": "a"},
    {**HEAD, "robot": {"pose": [0, 0]}},
    {**HEAD, "robot": {"use": "pioneer"}},
    {**HEAD, "robot": {"drive": [{"follow": {"distance": -1}}]}},
    {**HEAD, "world": [{"cylinder": {"at": [0, 1], "r": 1}}]},
    {**HEAD, "world": [{"id": "a", "cylinder": {"at": [0, 1], "r": 1, "x": 2}}]},
    {**HEAD, "world": [{"id": "a", "walls": [[0, 1]]}]},
    {**HEAD, "sensor": {"noise": {"sigma": 7}}},
    {**HEAD, "sensor": None},
    {"include": None},
]
GOOD = [
    HEAD,
    {**HEAD, "vars": {"R": 0.3}, "world": [{"id": "a", "cylinder": {"at": [0, "$R * 2"], "r": "$R"}}]},
    {"include": "other.yaml", "world": [{"id": "a", "cylinder": {"r": 0.3}}]},
    {"include": "other.yaml", "score": {"circle": None}, "world": [{"id": "a", "label": None}], "robot": None},
    {**HEAD, "name": 2005, "world": [{"id": 7, "label": True, "cylinder": {"at": [0, 1], "r": 1}}]},
    {**HEAD, "robot": {"drive": [{"path": {"line": [[1, 2]]}}, {"follow": {"for": 10}}]}},
]


def main(program, library):
    schema = json.loads(subprocess.run([program, "schema"], check=True, capture_output=True).stdout)
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    faults = []
    files = sorted(pathlib.Path(library).glob("*.yaml"))
    for file in files:
        for error in validator.iter_errors(yaml.safe_load(file.read_text())):
            faults.append(f"{file.name}: {error.json_path}: {error.message}")
    faults += [f"refused: {good}" for good in GOOD if not validator.is_valid(good)]
    faults += [f"accepted: {bad}" for bad in BAD if validator.is_valid(bad)]
    print("\n".join(faults))
    return 1 if faults or not files else 0


sys.exit(main(*sys.argv[1:]))
