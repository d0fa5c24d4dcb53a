"""An adversary: learns in one study what conditions look like, and guesses those of another study.

What it sees is a list of cases. A case is one alternative of one participant in one block, with features: numbers and
words by name. The classifier is naive Bayes: normal laws for numbers, frequencies for words, over the features that
tell most of the conditions of the first study. Within a participant's block each condition comes once, so that the
guesses for a block are the most likely assignment of all its conditions. A permutation test says whether more guesses
are right than by chance: within each block of the second study, conditions are exchanged. Both studies have other seeds:
in one study orders are balanced, and those of half of the participants would tell those of the other half.
"""
import itertools
import math
import random
from collections import Counter, defaultdict

KEPT_FEATURES = 8
LEAST_CASES = 20  # a feature that fewer cases have says nothing
PERMUTATIONS = 999


class Case:
    """@p whose, @p block: who felt it, and where; @p truth: what it was, which features must not say."""

    def __init__(self, whose, block, truth):
        self.whose = whose
        self.block = block
        self.truth = truth
        self.features = {}


def centred(cases):
    """Adds each number less the mean of its participant's block: people differ, and that hides what conditions do."""
    blocks = defaultdict(list)
    for case in cases:
        blocks[case.whose, case.block].append(case)
    for block in blocks.values():
        numbers = defaultdict(list)
        for case in block:
            for name, value in case.features.items():
                if isinstance(value, float):
                    numbers[name].append((case, value))
        for name, values in numbers.items():
            mean = sum(value for _, value in values) / len(values)
            for case, value in values:
                case.features[f"{name} in the block"] = value - mean
    return list(blocks.values())


class Normal:
    """Numbers of a feature, with a mean and a variance for each condition."""

    def __init__(self, values, truths):
        groups = defaultdict(list)
        for value, truth in zip(values, truths):
            groups[truth].append(value)
        mean = sum(values) / len(values)
        total = sum((value - mean) ** 2 for value in values)
        means = {truth: sum(group) / len(group) for truth, group in groups.items()}
        within = sum((value - means[truth]) ** 2 for truth, group in groups.items() for value in group)
        # What is the same within each condition tells the most; a floor keeps that finite.
        floor = 1e-12 * total + 1e-300
        freedom = max(len(values) - len(groups), 1)
        self.telling = 0.0 if total <= 0.0 else ((total - within) / max(len(groups) - 1, 1)) / (within / freedom + floor)
        self.laws = {truth: (means[truth],
                             max(sum((v - means[truth]) ** 2 for v in group) / len(group), within / freedom * 0.1 + floor))
                     for truth, group in groups.items()}

    def log_likelihood(self, value, truth):
        if truth not in self.laws:
            return 0.0
        mean, variance = self.laws[truth]
        return -0.5 * math.log(variance) - 0.5 * (value - mean) ** 2 / variance


class Words:
    """Words of a feature, with a frequency for each condition."""

    def __init__(self, values, truths):
        self.counts = Counter(zip(values, truths))
        self.of = Counter(truths)
        self.words = Counter(values)
        squares = sum((count - expected) ** 2 / expected
                      for word in self.words for truth in self.of
                      for count, expected in [(self.counts[word, truth], self.words[word] * self.of[truth] / len(values))])
        freedom = (len(self.words) - 1) * (len(self.of) - 1)
        self.telling = squares / freedom if freedom > 0 else 0.0

    def log_likelihood(self, value, truth):
        return math.log((self.counts[value, truth] + 1.0) / (self.of[truth] + len(self.words) + 1.0))


def learnt(cases):
    """The features that tell most, each with its laws."""
    by_name = defaultdict(lambda: ([], []))
    for case in cases:
        for name, value in case.features.items():
            values, truths = by_name[name]
            values.append(value)
            truths.append(case.truth)
    laws = {name: (Normal if isinstance(values[0], float) else Words)(values, truths)
            for name, (values, truths) in by_name.items() if len(values) >= LEAST_CASES}
    best = sorted(laws, key=lambda name: (-laws[name].telling, name))[:KEPT_FEATURES]
    return {name: laws[name] for name in best if laws[name].telling > 0.0}


def guesses(block, laws):
    """The most likely assignment of the block's conditions to its cases."""
    truths = sorted(case.truth for case in block)
    scores = [{truth: sum(law.log_likelihood(case.features[name], truth)
                          for name, law in laws.items() if name in case.features)
               for truth in truths} for case in block]
    return max(sorted(set(itertools.permutations(truths))),
               key=lambda order: sum(score[truth] for score, truth in zip(scores, order)))


def by_chance(sizes, right):
    """The probability that so many of all guesses or more are right, where blocks of these sizes are guessed by chance."""
    law = {0: 1.0}
    for size in sizes:
        orders = list(itertools.permutations(range(size)))
        of_block = Counter(sum(place == at for at, place in enumerate(order)) for order in orders)
        law = {count: sum(law.get(count - more, 0.0) * ways / len(orders) for more, ways in of_block.items())
               for count in range(max(law) + size + 1)}
    return sum(share for count, share in law.items() if count >= right)


def attack(known, others, seed, is_exact=False):
    """@p known, @p others: the cases of two studies. @p is_exact: p is computed, not drawn: it can be as small as it is.
    @return  (p, share of right guesses, share by chance, the most telling features)"""
    draw = random.Random(seed)
    centred(known)
    laws = learnt(known)
    others = centred(others)
    for block in others:
        draw.shuffle(block)  # what is as likely as something else must not be guessed by where it stands
    answers = [guesses(block, laws) for block in others]
    truths = [[case.truth for case in block] for block in others]

    def right(of):
        return sum(guess == truth for answer, block in zip(answers, of) for guess, truth in zip(answer, block))

    total = sum(len(block) for block in truths)
    if not laws:  # nothing tells conditions of the first study apart: no guess is better than another
        return 1.0, len(truths) / total, len(truths) / total, []
    found = right(truths)
    if is_exact:
        sizes = [len(block) for block in truths]
        return by_chance(sizes, found), found / total, len(sizes) / total, list(laws)
    as_good = 0
    chance = 0
    for _ in range(PERMUTATIONS):
        exchanged = right([draw.sample(block, len(block)) for block in truths])
        chance += exchanged
        as_good += exchanged >= found
    return (1 + as_good) / (1 + PERMUTATIONS), found / total, chance / PERMUTATIONS / total, list(laws)
