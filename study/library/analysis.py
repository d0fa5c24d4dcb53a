"""Computes the numbers of the statistics and votes tables again, from the responses.

    python3 analysis.py [folder of the export; without it, the one that this script is in]

It needs Python 3.8 or later with NumPy and SciPy, and no pandas. To get them:

    Debian, Ubuntu    sudo apt install python3-scipy      (brings NumPy; then call /usr/bin/python3)
    elsewhere         python3 -m pip install scipy        (brings NumPy)

For each kind of number it prints the largest distance from an exported one, relative to it. The last
line is the verdict; the exit status is 0 if all agree to 1e-9, 1 if not, 2 if SciPy or a table is
missing. Mixed models are not computed here, nor Shapiro-Wilk tests,
which SciPy computes to six digits, nor omega, Friedman's permutations, means of scores and what was
felt. The scores that a family compares are taken from the wide table; the codebook says how they are computed."""
import csv
import itertools
import math
import pathlib
import re
import sys
from collections import defaultdict

try:
    import numpy
    from scipy import integrate, special, stats
except ImportError as missing:
    print(f"""analysis.py needs NumPy and SciPy, and this Python ({sys.executable}) lacks one: {missing}.
Get them with 'sudo apt install python3-scipy' (Debian, Ubuntu; then call /usr/bin/python3) or with
'{sys.executable} -m pip install scipy'. To read the tables alone needs neither: every CSV file is plain text.""", file=sys.stderr)
    sys.exit(2)

def own_folder():
    """The folder of this script, wherever it is started from."""
    own = pathlib.Path(__file__).resolve().parent
    # Psych-DS has scripts in a folder of their own, beside that of the tables.
    return own.parent if own.name == "analysis" and not list(own.glob("*.csv")) else own


folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else own_folder()


def table_of(name):
    paths = sorted(p for p in folder.rglob("*.csv") if p.name == f"{name}.csv" or p.name.endswith(f"-{name}_data.csv"))
    if not paths:
        print(f"analysis.py: the table '{name}' is not in {folder}. It needs the folder of an unblinded export "
              "as it was written:\n  python3 analysis.py FOLDER", file=sys.stderr)
        sys.exit(2)
    with open(paths[0], encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


everything = [r for r in table_of("responses") if r["included"] == "true"]
responses = [r for r in everything if r["condition_code"]]
asked = {(i["instrument"], i["item_id"]): i for i in table_of("items")}
statistics = table_of("statistics")
# Only exports as CSV have the wide table; in others, families that compare a score are left out.
wide = table_of("wide") if list(folder.rglob("wide.csv")) else []
if not wide:
    statistics = [r for r in statistics if not (r["family_id"] and r["score"])]
worst = {}
ALLOWED = 1e-9


def check(row, column, value):
    if row[column] == "":
        return
    expected = float(row[column])
    distance = abs(value - expected) / max(abs(expected), 1e-3)
    name = f"{row['method']} {column}"
    worst[name] = max(math.inf if math.isnan(distance) else distance, worst.get(name, 0.0))


# A family may compare some of the conditions that its questionnaire was answered about.
conditions_of = defaultdict(set)
for each in statistics:
    conditions_of[each["run_mode"], each["family_id"]] |= {each["group1"], each["group2"]}


def answers_to(row, cohort):
    blocks = row["blocks"].split(" ")
    items = [row["score"]] if row["score"] else row["items"].split(" ")
    return [
        r if r["response_keyed"] else {**r, "response_keyed": keyed(r)}
        for r in (scored(row) if row["score"] else responses)
        if r["run_mode"] == row["run_mode"] and r["cohort"] == cohort
        and r["instrument"] == row["instrument"] and r["block"] in blocks and r["item_id"] in items
        and r["condition_code"] in conditions_of[row["run_mode"], row["family_id"]]
    ]


def keyed(r):
    """The number of a slider and the like, reversed as points are: by the ends of its range."""
    item, given = asked[r["instrument"], r["item_id"]], float(r["response"])
    return float(item["lowest"]) + float(item["highest"]) - given if item["key"] == "-1" else given


def scored(row):
    """A family's score as the answer to one item."""
    column = re.sub("[^A-Za-z0-9]", "_", f"{row['instrument']}__score_{row['score']}")
    return [
        {**r, "instrument": row["instrument"], "item_id": row["score"], "response_keyed": r[column]}
        for r in wide if r[column] != ""
    ]


def scores(row, group):
    return [float(r["response_keyed"]) for r in answers_to(row, row["cohort"]) if r["condition_code"] == group]


def means(row, group, cohort=None):
    of = defaultdict(list)
    for r in answers_to(row, cohort or row["cohort"]):
        if r["condition_code"] == group:
            of[r["participant_id"]].append(float(r["response_keyed"]))
    return {person: sum(points) / len(points) for person, points in sorted(of.items())}


def differences(row):
    first, second = means(row, row["group1"]), means(row, row["group2"])
    both = [person for person in first if person in second]
    x, y = [first[p] for p in both], [second[p] for p in both]
    return x, y, [round(a - b, 12) for a, b in zip(x, y)]


def quantile(q, df):
    t = stats.t.ppf(q, df)  # eight digits; Newton's steps give the rest
    for _ in range(3):
        t += (stats.t.sf(t, df) - (1 - q)) / stats.t.pdf(t, df)
    return t


def interval(row, suffix, center, error, df, level):
    half = quantile(0.5 + level / 2, df) * error
    check(row, f"conf_low{suffix}", center - half)
    check(row, f"conf_high{suffix}", center + half)


def welch(row):
    x, y = scores(row, row["group1"]), scores(row, row["group2"])
    for which, values in (("1", x), ("2", y)):
        check(row, "n" + which, len(values))
        check(row, "mean" + which, numpy.mean(values))
        check(row, "sd" + which, numpy.std(values, ddof=1))
    a, b = numpy.var(x, ddof=1) / len(x), numpy.var(y, ddof=1) / len(y)
    error = math.sqrt(a + b)
    df = (a + b) ** 2 / (a ** 2 / (len(x) - 1) + b ** 2 / (len(y) - 1))
    test = stats.ttest_ind(x, y, equal_var=False)
    check(row, "estimate", numpy.mean(x) - numpy.mean(y))
    check(row, "se", error)
    check(row, "statistic", test.statistic)
    check(row, "df", df)
    interval(row, "", numpy.mean(x) - numpy.mean(y), error, df, float(row["conf_level"]))
    interval(row, "_adj", numpy.mean(x) - numpy.mean(y), error, df, 1 - float(row["alpha_per_test"]))
    return test.pvalue


def paired_t(row):
    x, y, d = differences(row)
    df = len(d) - 1
    check(row, "n1", len(d))
    check(row, "mean1", numpy.mean(x))
    check(row, "mean2", numpy.mean(y))
    test = stats.ttest_1samp(d, 0.0)
    error = stats.sem(d)
    check(row, "estimate", numpy.mean(d))
    check(row, "se", error)
    check(row, "statistic", test.statistic)
    check(row, "df", df)
    interval(row, "", numpy.mean(d), error, df, float(row["conf_level"]))
    interval(row, "_adj", numpy.mean(d), error, df, 1 - float(row["alpha_per_test"]))
    j = math.exp(special.gammaln(df / 2) - special.gammaln((df - 1) / 2)) / math.sqrt(df / 2)
    check(row, "effect", j * numpy.mean(d) / numpy.std(d, ddof=1))
    return test.pvalue


def signs(n):
    return numpy.array(list(itertools.product((-1, 1), repeat=n)))


MOST_SIGNS = 18  # 2^18 choices; beyond, nothing is computed again


def sign_flip(row):
    d = numpy.array(differences(row)[2])
    if len(d) > MOST_SIGNS:
        return None
    return numpy.mean(numpy.abs(signs(len(d)) @ d) >= abs(d.sum()) - 1e-9)


def two_sided(all_values, value):
    return min(1.0, 2 * min(numpy.mean(all_values <= value + 1e-9), numpy.mean(all_values >= value - 1e-9)))


def signed_rank(row):
    d = numpy.array([x for x in differences(row)[2] if abs(x) > 1e-9])
    ranks = stats.rankdata(numpy.round(numpy.abs(d), 9))
    v = ranks[d > 0].sum()
    check(row, "statistic", v)
    check(row, "effect", (2 * v - ranks.sum()) / ranks.sum())
    every = differences(row)[2]
    check(row, "estimate", numpy.median([(a + b) / 2 for i, a in enumerate(every) for b in every[i:]]))
    if len(d) > MOST_SIGNS:
        return None
    return two_sided((signs(len(d)) > 0) @ ranks, v)


def tost(row):
    d = differences(row)[2]
    error, df, bound = stats.sem(d), len(d) - 1, float(row["equivalence_bound"])
    check(row, "n1", len(d))
    check(row, "estimate", numpy.mean(d))
    check(row, "se", error)
    check(row, "df", df)
    return max(stats.t.sf((numpy.mean(d) + bound) / error, df), stats.t.cdf((numpy.mean(d) - bound) / error, df))


def bayes_factor(row):
    d = differences(row)[2]
    n, df = len(d), len(d) - 1
    square = (numpy.mean(d) / stats.sem(d)) ** 2

    def of(u):  # Rouder et al. 2009, with g = e^u and the scale sqrt(2) / 2
        g = math.exp(u)
        spread = 1 + n * g / 2
        return (spread ** -0.5 * (1 + square / (spread * df)) ** (-(df + 1) / 2)
                * (2 * math.pi) ** -0.5 * g ** -0.5 * math.exp(-1 / (2 * g)))

    parts = [integrate.quad(of, a, a + 5, epsabs=0, epsrel=1e-12)[0] for a in range(-6, 60, 5)]
    check(row, "n1", n)
    check(row, "effect", sum(parts) / (1 + square / df) ** (-(df + 1) / 2))
    return None


def friedman(row):
    columns = [means(row, group) for group in row["groups"].split(" ")]
    people = [p for p in columns[0] if all(p in column for column in columns)]
    check(row, "n1", len(people))
    if len(columns) < 3:
        return None  # SciPy wants three
    test = stats.friedmanchisquare(*[[round(column[p], 12) for p in people] for column in columns])
    check(row, "statistic", test.statistic)
    check(row, "df", len(columns) - 1)
    return test.pvalue


def mann_whitney(row):
    x = [round(m, 12) for m in means(row, row["group1"]).values()]
    y = [round(m, 12) for m in means(row, row["group1"], row["cohort2"]).values()]
    ranks = stats.rankdata(x + y)
    n = len(x)
    u = ranks[:n].sum() - n * (n + 1) / 2
    check(row, "n1", n)
    check(row, "n2", len(y))
    check(row, "statistic", u)
    check(row, "effect", numpy.mean(numpy.sign(numpy.subtract.outer(x, y))))
    if math.comb(len(ranks), n) > 200000:
        return None
    every = numpy.array([sum(chosen) for chosen in itertools.combinations(ranks, n)])
    return two_sided(every - n * (n + 1) / 2, u)


def brunner_munzel(row):
    x = [round(m, 12) for m in means(row, row["group1"]).values()]
    y = [round(m, 12) for m in means(row, row["group1"], row["cohort2"]).values()]
    test = stats.brunnermunzel(x, y)
    check(row, "n1", len(x))
    check(row, "n2", len(y))
    check(row, "statistic", test.statistic)
    return test.pvalue


def table_of_means(row):
    columns = [means(row, group) for group in row["groups"].split(" ")]
    people = [p for p in columns[0] if all(p in column for column in columns)]
    return numpy.array([[column[p] for column in columns] for p in people])


def rm_anova(row):
    cells = table_of_means(row)
    n, k = cells.shape
    grand = cells.mean()
    between = n * ((cells.mean(axis=0) - grand) ** 2).sum()
    rest = cells - cells.mean(axis=0) - cells.mean(axis=1, keepdims=True) + grand
    error = (rest ** 2).sum()
    f = between / (k - 1) / (error / ((k - 1) * (n - 1)))
    check(row, "n1", n)
    check(row, "statistic", f)
    check(row, "df", k - 1)
    check(row, "df2", (k - 1) * (n - 1))
    check(row, "effect", between / (between + error))
    centred = numpy.eye(k) - 1 / k
    spread = centred @ numpy.cov(cells, rowvar=False) @ centred
    epsilon = numpy.trace(spread) ** 2 / ((k - 1) * (spread ** 2).sum())
    check(row, "epsilon", epsilon)
    check(row, "p_epsilon", stats.f.sf(f, epsilon * (k - 1), epsilon * (k - 1) * (n - 1)))
    return stats.f.sf(f, k - 1, (k - 1) * (n - 1))


def order_slope(row):
    answers = answers_to(row, row["cohort"])
    of_method = defaultdict(list)
    for r in answers:
        of_method[r["condition_code"]].append(float(r["response_keyed"]))
    own = defaultdict(lambda: defaultdict(list))
    for r in answers:
        rest = float(r["response_keyed"]) - numpy.mean(of_method[r["condition_code"]])
        own[r["participant_id"]][int(r["position"])].append(rest)
    slopes = []
    for person, positions in own.items():
        if len(positions) > 1:
            x = numpy.array(sorted(positions), dtype=float)
            y = numpy.array([numpy.mean(positions[p]) for p in sorted(positions)])
            slopes.append((x - x.mean()) @ (y - y.mean()) / ((x - x.mean()) ** 2).sum())
    test = stats.ttest_1samp(slopes, 0.0)
    check(row, "n1", len(slopes))
    check(row, "estimate", numpy.mean(slopes))
    check(row, "se", stats.sem(slopes))
    check(row, "statistic", test.statistic)
    check(row, "df", len(slopes) - 1)
    interval(row, "", numpy.mean(slopes), stats.sem(slopes), len(slopes) - 1, float(row["conf_level"]))
    return test.pvalue


def cronbach_alpha(row):
    of = defaultdict(lambda: defaultdict(list))
    for r in answers_to(row, row["cohort"]):
        if r["condition_code"] == row["group1"]:
            of[r["participant_id"]][r["item_id"]].append(float(r["response_keyed"]))
    items = sorted({item for answered in of.values() for item in answered})
    rows = [[numpy.mean(a[item]) for item in items] for a in of.values() if len(a) == len(items)]
    cells = numpy.array(rows)
    n, k = cells.shape
    alpha = k / (k - 1) * (1 - cells.var(axis=0, ddof=1).sum() / cells.sum(axis=1).var(ddof=1))
    check(row, "n1", n)
    check(row, "effect", alpha)
    return None


def brown_forsythe(row):
    groups = [list(means(row, group).values()) for group in row["groups"].split(" ")]
    n, k = sum(map(len, groups)), len(groups)
    test = stats.levene(*[numpy.round(g, 12) for g in groups], center="median")
    check(row, "statistic", test.statistic)
    check(row, "df", k - 1)
    check(row, "df2", n - k)
    return test.pvalue


def adjusted(p, method):
    m = len(p)
    order = sorted(range(m), key=lambda i: p[i])
    up = [p[i] for i in order]
    harmonic = sum(1 / i for i in range(1, m + 1))
    steps = {
        "none": lambda: up,
        "bonferroni": lambda: [m * q for q in up],
        "holm": lambda: list(itertools.accumulate(((m - i) * q for i, q in enumerate(up)), max)),
        "holm-sidak": lambda: list(itertools.accumulate((1 - (1 - q) ** (m - i) for i, q in enumerate(up)), max)),
        "hochberg": lambda: list(itertools.accumulate(((m - i) * q for i, q in reversed(list(enumerate(up)))), min))[::-1],
        "bh": lambda: list(itertools.accumulate((m * q / (i + 1) for i, q in reversed(list(enumerate(up)))), min))[::-1],
        "by": lambda: list(itertools.accumulate((harmonic * m * q / (i + 1) for i, q in reversed(list(enumerate(up)))), min))[::-1],
    }
    if method not in steps:
        return None
    result = [0.0] * m
    for i, value in zip(order, steps[method]()):
        result[i] = min(1.0, value)
    return result


tests = {
    f.__name__: f
    for f in (
        welch, paired_t, sign_flip, signed_rank, friedman, mann_whitney,
        brunner_munzel, rm_anova, order_slope, cronbach_alpha, brown_forsythe, tost, bayes_factor,
    )
}
families = defaultdict(list)
for row in statistics:
    if row["method"] not in tests or row["p"] + row["effect"] == "":
        continue
    p = tests[row["method"]](row)
    if p is None:
        continue
    check(row, "p", p)
    families[row["run_mode"], row["cohort"], row["family_id"], row["method"]].append((row, p))
for members in families.values():
    if any(row["p_adj"] == "" for row, _ in members):
        continue
    again = adjusted([p for _, p in members], members[0][0]["p_adj_method"])
    for (row, _), p in zip(members, again or []):
        check(row, "p_adj", p)
# How often each rendering was preferred. Who said "2" meant what they had felt as Alternative 2.
felt_as = {
    (t["participant_id"], t["session_num"], t["block"], t["alternative"]): t["condition_code"]
    for t in table_of("trials")
}


def cast(row):
    items = row["item_id"].split(" ")
    return [
        felt_as.get((r["participant_id"], r["session_num"], row["block"], r["response"]))
        for r in everything
        if r["run_mode"] == row["run_mode"] and r["cohort"] == row["cohort"]
        and r["block"] == row["preference"] and r["item_id"] in items
        and row.get("site", "") in ("", r.get("site"))  # of several sites there are also the votes of each
    ]


def outcomes(n, k):
    """All ways in which n votes may fall on k renderings."""
    if k == 1:
        return [(n,)]
    return [(v, *rest) for v in range(n + 1) for rest in outcomes(n - v, k - 1)]


def equal_shares(counts):
    n, k = sum(counts), len(counts)
    if math.comb(n + k - 1, k - 1) > 200000:
        return None
    def ways(votes):  # in whole numbers, so that ties are ties
        return math.factorial(n) // math.prod(math.factorial(v) for v in votes)
    return sum(w for w in map(ways, outcomes(n, k)) if w <= ways(counts)) / k ** n


def most_votes(rows):
    given = cast(rows[0])
    counts = [given.count(row["condition_code"]) for row in rows]
    n, k = sum(counts), len(counts)
    p = equal_shares(counts) if n else None
    for row, v in zip(rows, counts):
        row["method"] = "votes"
        check(row, "votes", v)
        check(row, "votes_total", n)
        if n == 0:
            continue
        level = float(row["conf_level"])
        z = stats.norm.ppf(0.5 + level / 2)
        half = z * math.sqrt(v / n * (1 - v / n) / n + z * z / (4 * n * n))
        middle, whole = v / n + z * z / (2 * n), 1 + z * z / n
        check(row, "share", v / n)
        check(row, "share_low", (middle - half) / whole)
        check(row, "share_high", (middle + half) / whole)
        check(row, "share_low_exact", special.betaincinv(v, n - v + 1, 0.5 - level / 2) if v else 0.0)
        check(row, "share_high_exact", special.betaincinv(v + 1, n - v, 0.5 + level / 2) if v < n else 1.0)
        chi2 = sum((c - n / k) ** 2 / (n / k) for c in counts)
        check(row, "chi2", chi2)
        check(row, "chi2_df", k - 1)
        check(row, "p_chi2", stats.chi2.sf(chi2, k - 1))
        if p is not None:
            check(row, "p_exact", p)


votes = defaultdict(list)
for row in table_of("votes"):
    votes[row["run_mode"], row["cohort"], row.get("site"), row["preference"]].append(row)
for rows in votes.values():
    most_votes(rows)

for name in sorted(worst):
    print(f"{name:28s} {worst[name]:.1e}")
off = [name for name in sorted(worst) if worst[name] > ALLOWED]
if not worst:
    print("NOTHING was computed again: the tables have no number that this script knows")
elif off:
    print(f"DIFFER: {len(off)} of {len(worst)} kinds of numbers by more than {ALLOWED:.0e}: {', '.join(off)}")
else:
    print(f"AGREE: all {len(worst)} kinds of numbers to {ALLOWED:.0e}")
sys.exit(1 if off or not worst else 0)
