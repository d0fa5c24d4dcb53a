"""Reads folders that 'palpate export' makes, in every format, as an adversary does: all tables, names and sizes.

Answers and votes are left out: what people say about conditions may tell them apart.
"""
import csv
import datetime
import json
import re
import sqlite3
from collections import Counter, defaultdict

from adversary import Case

ANSWERS = {"response", "response_keyed", "response_label"}
# What is asked for: it says which rows belong together.
CODES = {"condition_code"}
# Says what the words of a document mean, the same in each study.
NO_TABLES = {"felt_from"}
# Tables without people: the same in each format that has them.
DICTIONARIES = {"columns"}
TIME = re.compile(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d+)?Z$")


def is_answer(table, column):
    """In the wide table the columns of questions and scores are called INSTRUMENT__QUESTION."""
    return column in ANSWERS or (table == "wide" and "__" in column)


class Truth:
    """What each alternative of a simulated study was, from its database: (participant, step from 1) → (block, condition)"""

    def __init__(self, study):
        connection = sqlite3.connect(f"file:{study}/study.db?mode=ro", uri=True)
        self.steps = {(person(code), step + 1): (block, condition) for code, step, block, condition in connection.execute(
            "SELECT p.code, s.step, s.phase, a.condition FROM step AS s "
            "JOIN allocation AS a ON a.session_id = s.session_id AND a.step = s.step "
            "JOIN session AS n ON n.id = s.session_id JOIN participant AS p ON p.id = n.participant_id "
            "WHERE s.kind IN ('trial', 'questionnaire') AND s.position > 0")}
        self.contact = {(person(code), step + 1): seconds for code, step, seconds in connection.execute(
            "SELECT p.code, x.step, x.contact_s FROM trial AS x JOIN session AS n ON n.id = x.session_id "
            "JOIN participant AS p ON p.id = n.participant_id")}
        self.names = sorted({condition for _, condition in self.steps.values()})
        connection.close()


class ToldTruth:
    """The same of a study whose conditions are sealed, from an export that is not blinded."""

    def __init__(self, folder):
        tables = tables_of(folder)
        rows = [row for name in ("trials", "responses") for row in tables[name] if row["condition"]]
        self.steps = {(row["participant_id"], int(row["step_num"])): (row["block"], row["condition"]) for row in rows}
        self.answers = [(condition, row["response"]) for row in tables["responses"] if (condition := row["condition"])]
        self.names = sorted({condition for _, condition in self.steps.values()})


def person(text):
    """A participant, named alike in tables and in names of files: 'SIM001'."""
    return (text or "").removeprefix("sub-").replace("-", "")


def tables_of(folder):
    """{name: rows as dictionaries of texts}, in the order of the files; a row of BIDS says whose it is."""
    tables = defaultdict(list)
    for path in sorted(folder.rglob("*")):
        if path.stem in DICTIONARIES:
            continue
        if path.suffix == ".csv":
            name = path.stem.partition("_description-")[2].removesuffix("_data") or path.stem
            with path.open(encoding="utf-8", newline="") as file:
                tables[name] += csv.DictReader(file)
        elif path.suffix == ".tsv":
            whose = re.search(r"sub-([A-Za-z0-9]+)", path.stem)
            name = path.stem.rpartition("_acq-")[2].removesuffix("_beh").rpartition("_")[2]
            with path.open(encoding="utf-8", newline="") as file:
                for row in csv.DictReader(file, delimiter="\t", quoting=csv.QUOTE_NONE):
                    tables[name].append({**({"participant_id": whose[1]} if whose else {}), **row})
        elif path.name == "study.json":
            for name, rows in json.loads(path.read_text(encoding="utf-8")).items():
                if isinstance(rows, list) and name not in NO_TABLES:
                    tables[name] += [{column: as_text(value) for column, value in row.items()} for row in rows]
    for rows in tables.values():
        for row in rows:
            if "participant_id" in row:
                row["participant_id"] = person(row["participant_id"])
    return dict(tables)


def as_text(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    return "" if value is None else str(value)


def sizes_of(folder):
    """{participant: {kind of file: bytes}} of files that are named after a person."""
    sizes = defaultdict(dict)
    for path in sorted(folder.rglob("*")):
        whose = re.search(r"sub-([A-Za-z0-9]+)", path.name)
        if whose and path.is_file():
            sizes[whose[1]][path.name.replace(whose[0], "")] = path.stat().st_size
    return sizes


def number_in(text):
    """A number, or a time as seconds; None for words and for nothing."""
    if TIME.match(text or ""):
        return datetime.datetime.fromisoformat(text.replace("Z", "+00:00")).timestamp()
    try:
        return float(text)
    except (TypeError, ValueError):
        return None


def with_numbered_people(tables):
    """The same with rows in the order of their words, and people numbered by what is told of them."""
    told = defaultdict(list)
    for name in sorted(tables):
        for row in tables[name]:
            if "participant_id" in row:
                told[row["participant_id"]].append((name, *(row[column] or "" for column in row if column != "participant_id")))
    ranks = {person: f"{rank:04}" for rank, (_, person) in
             enumerate(sorted((sorted(rows), person) for person, rows in told.items()))}
    return {name: sorted(({**row, "participant_id": ranks[row["participant_id"]]} if "participant_id" in row else row
                          for row in rows), key=lambda row: [row[column] or "" for column in row])
            for name, rows in tables.items()}


class Artefact:
    """The cases of one exported folder."""

    def __init__(self, tables, sizes, truth, codes=None):
        """@p codes: of a public folder, whose ids and rows are drawn: {code: condition}. Its order says nothing."""
        self.truth = truth
        self.has_order = codes is None
        self.cases = {}
        self.blocks_of_people = defaultdict(list)
        if codes is None:
            codes = self.codes(tables)
        else:
            tables = with_numbered_people(tables)
        self.codes_by_condition = {condition: code for code, condition in codes.items()}
        for row in tables["responses"]:
            key = (row["participant_id"], row["block"], row["condition_code"])
            if row["condition_code"] in codes and key not in self.cases:
                self.cases[key] = Case(key[0], key[1], codes[key[2]])
        for name, rows in tables.items():
            self.read(name, rows)
        for whose, files in sizes.items():
            for name, size in files.items():
                self.add_for_person(whose, f"size of {name}", float(size))

    def codes(self, tables):
        """What each code stands for. The adversary is judged by it, and does not see it."""
        known = {}
        for row in tables["responses"]:
            step = self.truth.steps.get((row["participant_id"], int(row.get("step_num") or 0)))
            if step and row["condition_code"] not in ("", "n/a"):
                known[row["condition_code"]] = step[1]
        return known

    @staticmethod
    def codes_by_answers(tables, answers):
        """The same for a folder with other codes and people, by what was answered. @p answers: (condition, response)"""
        seen = defaultdict(Counter)
        for row in tables["responses"]:
            if row["condition_code"] not in ("", "n/a"):
                seen[row["condition_code"]][row["response"]] += 1
        said = defaultdict(Counter)
        for condition, response in answers:
            said[condition][response] += 1
        return {code: condition for code in seen for condition in said if seen[code] == said[condition]}

    def case_of(self, row):
        code = row.get("condition_code")
        if code in (None, "", "n/a"):
            block, condition = self.truth.steps.get((row["participant_id"], int(number_in(row.get("step_num")) or 0)), (None, None))
            code = self.codes_by_condition.get(condition)
        else:
            block = row["block"]
        return self.cases.get((row["participant_id"], block, code))

    def read(self, table, rows):
        last = {}  # of each participant and column: the last number
        rows_of = defaultdict(list)
        for index, row in enumerate(rows):
            whose = row.get("participant_id")
            if not whose:
                continue
            case = self.case_of(row)
            numbers = {column: number_in(text) for column, text in row.items()
                       if not is_answer(table, column) and column not in CODES | {"participant_id"}}
            rows_of[id(case) if case else whose].append((case, whose, index, row, numbers))
            for column, value in numbers.items():
                if value is None:
                    continue
                before = last.get((whose, column))
                if self.has_order and case and before is not None and before[0] is not case:
                    case.features.setdefault(f"{table}.{column} since the row before", value - before[1])
                last[whose, column] = (case, value)
        for group in rows_of.values():
            self.summarise(table, group)

    def summarise(self, table, group):
        case, whose = group[0][:2]

        def add(name, value):
            if case:
                case.features[f"{table}: {name}"] = value
            else:
                self.add_for_person(whose, f"{table}: {name}", value)

        add("rows", float(len(group)))
        if self.has_order:
            add("where its rows are", float(group[0][2]))
        for column in group[0][4]:
            values = [numbers[column] for *_, numbers in group if numbers.get(column) is not None]
            if values:
                add(f"mean of {column}", sum(values) / len(values))
                add(f"span of {column}", max(values) - min(values))
            texts = sorted({row[column] or "" for *_, row, _ in group})
            if len(texts) <= 3:
                add(f"words in {column}", "|".join(texts))
            add(f"letters in {column}", float(sum(len(row[column] or "") for *_, row, _ in group)))

    def add_for_person(self, whose, name, value):
        """What is said of a person may tell the order: it is a feature at each position."""
        if not self.has_order:
            return
        if not self.blocks_of_people:
            for case in self.cases.values():
                self.blocks_of_people[case.whose].append((case.block, case))
        places = defaultdict(int)
        for block, case in self.blocks_of_people.get(whose, []):
            places[block] += 1  # cases were met in the order of the rows, which is that of the session
            case.features[f"{name} at {block} {places[block]}"] = value
