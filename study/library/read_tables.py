"""Reads the tables of this folder with their types: whole and other numbers, times in UTC, true and
false; closed lists stay words, and levels() has them in the order of columns.csv.

    from read_tables import read_tables; data = read_tables("."); data["responses"][0]
    python3 read_tables.py [folder; without it, its own]      says what is there, and the means by condition code

With the standard library alone; pandas.DataFrame(data["responses"]) makes a data frame."""
import csv
import datetime
import pathlib
import statistics
import sys
from collections import defaultdict

TYPES = {
    "integer": int,
    "number": float,
    "boolean": {"true": True, "false": False}.__getitem__,
    "date_time": lambda text: datetime.datetime.fromisoformat(text.replace("Z", "+00:00")),
    "text": str,
}


def rows_of(folder, name):
    with open(pathlib.Path(folder) / f"{name}.csv", encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def levels(folder="."):
    """The values of closed lists in their order, by (table, column)."""
    known = defaultdict(list)
    for about in rows_of(folder, "columns"):
        if about["value"] != "":
            known[about["table"], about["column"]].append(about["value"])
    return dict(known)


def read_tables(folder="."):
    """A list of rows by table; None is a missing value."""
    types = {(a["table"], a["column"]): TYPES[a["type"]] for a in rows_of(folder, "columns")}
    known = levels(folder)
    data = {}
    for table in dict.fromkeys(table for table, _ in types):
        data[table] = []
        for row in rows_of(folder, table):
            for column, text in row.items():
                if text != "" and text not in known.get((table, column), [text]):
                    raise ValueError(f"{table} {column} holds what is no value of it: {text}")
            data[table].append({c: None if t == "" else types[table, c](t) for c, t in row.items()})
    return data


if __name__ == "__main__":
    data = read_tables(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    for name, rows in data.items():
        print(name, ":", len(rows), "rows,", len(rows[0]) if rows else 0, "columns")
    groups = defaultdict(list)
    for r in data["responses"]:
        if r.get("included", True) and r["item_type"] == "likert" and r["condition_code"]:
            groups[r["instrument"], r["condition_code"]].append(r["response_keyed"])
    for (instrument, code), points in sorted(groups.items()):
        deviation = statistics.stdev(points) if len(points) > 1 else float("nan")
        print(f"{instrument}.{code}: n = {len(points)}, mean = {statistics.mean(points):.6f}, sd = {deviation:.6f}")
