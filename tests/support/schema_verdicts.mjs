// The schema that ships for editors (through ajv) and the reader that speaks to people must give
// the same verdict on the structure of a file. Compared on three folders of small files and on
// every shipped file with one thing changed.
//
//   node schema_verdicts.mjs <node_modules> <program that says what the reader says> <library>
//     <name of the schema> <folder of the tests> <scratch>
//
// The folder of the tests holds data/good, data/bad, data/semantic, and unseen_by_schema.mjs, which
// says what no schema sees.
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";

const [nodeModules, verdictProgram, library, schemaName, tests, scratch] = process.argv.slice(2);
const kSkipped = 77;
const { unseen, strayKeys } = await import(pathToFileURL(path.join(tests, "unseen_by_schema.mjs")));
const kManyProblems = /^there are more problems$/; // whatever they are, the first were told

const failures = [];
const fail = (sentence) => failures.push(sentence);

function loadAjv() {
  try {
    return createRequire(path.join(path.resolve(nodeModules), "any.js"))("ajv/dist/2020").default;
  } catch {
    console.log(
      `Skipped: there is no ajv in ${nodeModules}; run ./setup --check or set PALPATE_AJV`,
    );
    process.exit(kSkipped);
  }
}

function readerVerdicts(files) {
  const verdicts = new Map();
  for (let i = 0; i < files.length; i += 200) {
    const lines = execFileSync(verdictProgram, files.slice(i, i + 200), {
      encoding: "utf8",
      maxBuffer: 1 << 28,
    });
    for (const line of lines.trim().split("\n")) {
      const verdict = JSON.parse(line);
      verdicts.set(verdict.file, verdict);
    }
  }
  return verdicts;
}

const filesIn = (folder) =>
  fs.readdirSync(folder).filter((name) => name.endsWith(".json")).sort().map((name) => path.join(folder, name));
const parsed = (file) => JSON.parse(fs.readFileSync(file, "utf8").replace(/^\uFEFF/, ""));
const errorsOf = (verdict) => verdict.problems.filter((problem) => problem.severity === "error");
const isUnseen = (problem) => [...unseen, kManyProblems].some((pattern) => pattern.test(problem.what));
const inWords = (problems) => problems.map((problem) => `\n    ${problem.path}: ${problem.what}`).join("");

// --- the three folders -----------------------------------------------------------------------

function compareFolder(folder, schemaAccepts, readerAccepts) {
  const files = filesIn(folder);
  const verdicts = readerVerdicts(files);
  for (const file of files) {
    const verdict = verdicts.get(file);
    if (validate(parsed(file)) !== schemaAccepts) {
      fail(`${file}: the schema ${schemaAccepts ? "refuses" : "accepts"} it ${JSON.stringify(validate.errors)}`);
    }
    if (verdict.accepted !== readerAccepts) {
      fail(`${file}: the reader ${readerAccepts ? "refuses" : "accepts"} it${inWords(verdict.problems)}`);
    }
  }
  return [...verdicts.values()];
}

function checkWhatIsUnseen(verdicts) {
  for (const verdict of verdicts) {
    for (const problem of errorsOf(verdict).filter((p) => !isUnseen(p))) {
      fail(`${verdict.file}: a schema should see this too: ${problem.path}: ${problem.what}`);
    }
  }
  const said = verdicts.flatMap(errorsOf).map((problem) => problem.what);
  for (const pattern of unseen.filter((p) => !said.some((what) => p.test(what)))) {
    fail(`no file of the folder semantic shows ${pattern}`);
  }
}

// --- one thing changed -----------------------------------------------------------------------

const kinds = (value) => (value === null ? "null" : Array.isArray(value) ? "list" : typeof value);
const kOthers = ["a text", "", 5, 1.5, -1e12, true, null, [], {}, ["a"], { en: 5 }, { de: "nur Deutsch" }];

function* changesOf(value) {
  for (const other of kOthers) {
    if (JSON.stringify(other) !== JSON.stringify(value)) yield [`becomes ${JSON.stringify(other)}`, other];
  }
  if (typeof value === "string") yield ["is misspelt", value + " x"];
  if (typeof value === "number") {
    yield ["is one less", value - 1];
    yield ["is far too large", 1e15];
    yield ["is zero", 0];
  }
  if (kinds(value) === "list") {
    yield ["loses its first", value.slice(1)];
    yield ["keeps only its first", value.slice(0, 1)];
    if (value.length > 0) yield ["has its first twice", [value[0], ...value]];
    if (value.length > 0) yield ["has far too many", Array(1001).fill(value[0])];
  }
}

function* changesOfKeys(object) {
  for (const key of Object.keys(object)) {
    const without = { ...object };
    delete without[key];
    yield [`${key} is dropped`, without];
    const misspelt = Object.fromEntries(Object.entries(object).map(([k, v]) => [k === key ? `${k}x` : k, v]));
    yield [`${key} is misspelt`, misspelt];
    const mistaken = { ...without, [key.toUpperCase()]: object[key] };
    yield [`${key} is shouted`, mistaken];
  }
  for (const key of ["colour", ...strayKeys]) {
    if (!(key in object)) yield [`${key} is added`, { ...object, [key]: 1 }];
  }
}

/// Every place of a value with the shape of the place: what was changed at "items[3].text" need not
/// be changed again at "items[4].text", unless the item is of another type.
function* placesOf(value, at = [], shape = "$") {
  const kind = kinds(value);
  if (kind !== "object") yield [at, shape, value];
  if (kind === "object") {
    const sort = [value.type, value.model].find((word) => typeof word === "string");
    const own = sort ? `${shape}<${sort}>` : shape;
    yield [at, own, value];
    for (const key of Object.keys(value)) yield* placesOf(value[key], [...at, key], `${own}.${key}`);
  } else if (kind === "list") {
    for (let i = 0; i < value.length; ++i) yield* placesOf(value[i], [...at, i], `${shape}[]`);
  }
}

function changedAt(value, at, changed) {
  if (at.length === 0) return changed;
  const copy = Array.isArray(value) ? [...value] : { ...value };
  copy[at[0]] = changedAt(value[at[0]], at.slice(1), changed);
  return copy;
}

const seenAnywhere = new Set();

/// Plain values of one shape are changed in one file only, and so are lists and objects that say the
/// same.
function* mutationsOf(content) {
  const seenHere = new Set();
  for (const [at, shape, value] of placesOf(content)) {
    const isPlain = !["object", "list"].includes(kinds(value));
    const everywhere = isPlain ? shape : `${shape} ${JSON.stringify(value)}`;
    if (seenHere.has(shape) || seenAnywhere.has(everywhere)) continue;
    seenHere.add(shape);
    seenAnywhere.add(everywhere);
    const changes = [...changesOf(value), ...(kinds(value) === "object" ? changesOfKeys(value) : [])];
    for (const [how, changed] of changes) yield [`${at.join(".")} ${how}`, changedAt(content, at, changed)];
  }
}

/// Every change with PALPATE_LONG, otherwise every twentieth: the changes of a key come in threes.
const kStride = process.env.PALPATE_LONG ? 1 : 20;

function compareMutations(file) {
  const folder = path.join(scratch, path.basename(file, ".json"));
  fs.mkdirSync(folder, { recursive: true });
  const tried = [...mutationsOf(parsed(file))].filter((_, i) => i % kStride === 0);
  const cases = tried.map(([how, content], i) => {
    const place = path.join(folder, `${i}.json`);
    fs.writeFileSync(place, JSON.stringify(content));
    return { how: `${path.basename(file)}: ${how}`, place, content };
  });
  const verdicts = readerVerdicts(cases.map(({ place }) => place));
  const count = { accepted: 0, refused: 0, unseen: 0 };
  for (const { how, place, content } of cases) {
    const errors = errorsOf(verdicts.get(place));
    const isSound = validate(content);
    if (!isSound && errors.length === 0) fail(`${how}: only the schema refuses it ${JSON.stringify(validate.errors)}`);
    const seen = errors.filter((problem) => !isUnseen(problem));
    if (isSound && seen.length > 0) fail(`${how}: only the reader refuses it${inWords(seen)}`);
    ++count[!isSound ? "refused" : errors.length > 0 ? "unseen" : "accepted"];
  }
  return count;
}

// ---------------------------------------------------------------------------------------------

const Ajv = loadAjv();
const schema = path.join(library, schemaName);
const validate = new Ajv({ allErrors: true, strict: true, strictRequired: false }).compile(parsed(schema));
fs.rmSync(scratch, { recursive: true, force: true });

const data = path.join(tests, "data");
const shipped = filesIn(library).filter((file) => file !== schema);
compareFolder(path.join(data, "good"), true, true);
compareFolder(path.join(data, "bad"), false, false);
checkWhatIsUnseen(compareFolder(path.join(data, "semantic"), true, false));
for (const verdict of readerVerdicts(shipped).values()) {
  if (!verdict.accepted) fail(`${verdict.file}: refused${inWords(verdict.problems)}`);
}
const total = { accepted: 0, refused: 0, unseen: 0 };
for (const file of [...shipped, ...filesIn(path.join(data, "good"))]) {
  if (!validate(parsed(file))) fail(`${file}: the schema refuses it ${JSON.stringify(validate.errors)}`);
  for (const [kind, count] of Object.entries(compareMutations(file))) total[kind] += count;
}
fs.rmSync(scratch, { recursive: true, force: true });

console.log(
  `changed files: ${total.refused} refused by both, ${total.accepted} accepted by both, ` +
    `${total.unseen} refused by the reader for what no schema sees`,
);
if (total.refused < 300) fail("too few changes were tried");
for (const sentence of failures.slice(0, 40)) console.log(sentence);
if (failures.length > 0) console.log(`${failures.length} disagreements`);
process.exit(failures.length > 0 ? 1 : 0);
