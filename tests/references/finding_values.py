"""Write finding_values.json: value, verdict and details of every finding, from the run.json of each scene in
a folder.

Usage: python tests/references/finding_values.py FOLDER, where FOLDER/<scene>/run.json are runs of
shipped scenes."""

import json
import sys
from pathlib import Path


def main(folder: str):
    """Read every run.json in the subfolders and write the values next to this script."""
    values = {}
    for path in sorted(Path(folder).glob("*/run.json")):
        findings = json.loads(path.read_text("utf-8"))["findings"]
        values[path.parent.name] = {
            finding["key"]: {
                name: finding[name] for name in ("value", "verdict", "details")
            }
            for finding in findings
        }
    text = json.dumps(values, indent=1, sort_keys=True)
    Path(__file__).with_suffix(".json").write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1])
