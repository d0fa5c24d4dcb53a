#include "study/bench/bench_peer_scripts.h"

namespace study::app {

const char* const kTableInR = R"script(
args <- commandArgs(trailingOnly = TRUE)
needed <- if (args[1] == "csv") "data.table" else c("data.table", "RSQLite")
there <- vapply(needed, requireNamespace, logical(1), quietly = TRUE)
if (!all(there)) {
  cat("absent", paste(needed[!there], collapse = " and "), "\n")
  quit(status = 0)
}
suppressPackageStartupMessages(library(data.table))
cat("version R", as.character(getRversion()), "data.table", as.character(packageVersion("data.table")), "\n")

query <- "SELECT s.cohort AS cohort, q.condition AS method, q.item AS statement, x.point AS answer
  FROM answer AS x INDEXED BY answers_to_be_counted
  JOIN question AS q ON q.id = x.question JOIN session AS s ON s.id = x.session_id
  WHERE x.point IS NOT NULL AND q.kind = 'questionnaire' AND s.run_mode = 'simulated'
  AND s.state = 'completed'"

read <- function() {
  if (args[1] == "csv") {
    return(fread(args[2], select = c("cohort", "method", "key", "answer")))
  }
  connection <- DBI::dbConnect(RSQLite::SQLite(), args[2], flags = RSQLite::SQLITE_RO)
  on.exit(DBI::dbDisconnect(connection))
  d <- setDT(DBI::dbGetQuery(connection, query))
  keys <- fread(args[3], colClasses = list(character = "item"))
  d[, key := keys$key[match(statement, keys$item)]]
  d
}

welch <- function(a, b) {
  e1 <- a$v / a$n
  e2 <- b$v / b$n
  t <- (a$m - b$m) / sqrt(e1 + e2)
  df <- (e1 + e2)^2 / (e1^2 / (a$n - 1) + e2^2 / (b$n - 1))
  c(a$m, b$m, a$v, b$v, t, 2 * pt(-abs(t), df))
}

table_of <- function(d) {
  d[, score := fifelse(key < 0L, 6L - answer, answer)]
  groups <- d[, .(n = .N, m = mean(score), v = var(score)), by = .(cohort, method)]
  rows <- list()
  for (who in unique(groups$cohort)) {
    of <- groups[cohort == who]
    pairs <- combn(of$method, 2)
    for (i in seq_len(ncol(pairs))) {
      a <- of[method == pairs[1, i]]
      b <- of[method == pairs[2, i]]
      rows[[length(rows) + 1]] <- list(names = c(who, pairs[, i]), numbers = welch(a, b))
    }
  }
  rows
}

for (i in seq_len(as.integer(args[4]))) {
  began <- proc.time()[["elapsed"]]
  rows <- table_of(read())
  cat("seconds", proc.time()[["elapsed"]] - began, "\n")
  invisible(gc())
}
for (row in rows) cat("row", row$names, sprintf("%.17g", row$numbers), "\n")
)script";

const char* const kTableInPython = R"script(
import itertools
import math
import sys
import time

kind, path, keys, times = sys.argv[1], sys.argv[2], sys.argv[3], int(sys.argv[4])
try:
    import pandas
except ImportError:
    print("absent pandas")
    sys.exit(0)
try:
    from scipy import special
except ImportError:
    special = None
print("version Python", sys.version.split()[0], "pandas", pandas.__version__)

QUERY = """SELECT s.cohort AS cohort, q.condition AS method, q.item AS statement,
  x.point AS answer FROM answer AS x INDEXED BY answers_to_be_counted
  JOIN question AS q ON q.id = x.question JOIN session AS s ON s.id = x.session_id
  WHERE x.point IS NOT NULL AND q.kind = 'questionnaire' AND s.run_mode = 'simulated'
  AND s.state = 'completed'"""


def read():
    if kind == "csv":
        return pandas.read_csv(path, usecols=["cohort", "method", "key", "answer"])
    import sqlite3

    connection = sqlite3.connect("file:" + path + "?mode=ro", uri=True)
    data = pandas.read_sql_query(QUERY, connection)
    connection.close()
    known = pandas.read_csv(keys, dtype={"item": str}).set_index("item")["key"]
    data["key"] = data["statement"].map(known)
    return data


def welch(a, b):
    (n1, m1, v1), (n2, m2, v2) = a, b
    e1, e2 = v1 / n1, v2 / n2
    t = (m1 - m2) / math.sqrt(e1 + e2)
    df = (e1 + e2) ** 2 / (e1**2 / (n1 - 1) + e2**2 / (n2 - 1))
    p = 2 * special.stdtr(df, -abs(t)) if special else math.nan
    return (m1, m2, v1, v2, t, p)


def table_of(data):
    score = data["answer"].where(data["key"] > 0, 6 - data["answer"])
    groups = score.groupby([data["cohort"], data["method"]], sort=False)
    groups = groups.agg(["count", "mean", "var"])
    rows = []
    for who in groups.index.unique(level=0):
        of = groups.loc[who]
        for first, second in itertools.combinations(of.index, 2):
            numbers = welch(tuple(of.loc[first]), tuple(of.loc[second]))
            rows.append((who, first, second, *numbers))
    return rows


for _ in range(times):
    began = time.perf_counter()
    rows = table_of(read())
    print("seconds", time.perf_counter() - began, flush=True)
for row in rows:
    print("row", *row[:3], *(f"{number:.17g}" for number in row[3:]))
)script";

}  // namespace study::app
