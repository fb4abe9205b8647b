// From a program's run to what a student reads: as exercises/judge.py and exercises/student.py do, and in their words.
const seconds = 20, most_output = 1 << 20, most_failures = 3, most_errors = 3;
const not_implemented = "not implemented yet: ", threw = "threw an exception";
const too_long = `Stopped after ${seconds} s: a loop does not end, or takes far too many rounds.`, too_much = "Stopped: it prints far too much.";
const left = "The program ended before its check did. Does it call exit()?";

/** Runs a program to its end, or to a limit. @return what it wrote, by descriptor, and how it {ended} */
export function run(program, runner) {
    return new Promise(resolve => {
        const worker = new Worker(runner, { type: "module" }), written = { 1: "", 2: "", 3: "" };
        const end = how => {
            clearTimeout(clock);
            worker.terminate();
            resolve({ out: written[1], err: written[2], report: written[3], ...how });
        };
        const clock = setTimeout(() => end({ ended: "time" }), 1000 * seconds);
        worker.onmessage = ({ data }) => {
            if (data.ended)
                end(data);
            else if ((written[data.descriptor] += data.text).length > most_output)
                end({ ended: "output" });
        };
        worker.onerror = error => end({ ended: "trap" });
        worker.postMessage(program);
    });
}

/** What came of an answer: state, message, cases, failures {name, given, message} and what it said. */
export function outcome(done, expected) {
    const started = [...done.report.matchAll(/<TestCase name="([^"]*)"/g)].map(found => unescaped(found[1]));
    const checking = started.length ? ` It was checking: ${started.at(-1)}` : "", cases = cases_in(done.report);
    const result = (state, message, failures = []) => ({ state, message, cases: cases?.length ?? 0, failures, said: done.out });
    if (done.ended === "time" || done.ended === "output")
        return result(done.ended === "time" ? "too_long" : "too_much", (done.ended === "time" ? too_long : too_much) + checking);
    if (done.ended === "trap")
        return result("crashed", crash_of(done) + checking);
    if (!cases)
        return result("crashed", left);
    if (cases.length !== expected)
        return result("crashed", `No verdict: of the ${expected} properties it reports ${cases.length}, or its report is not the judge's. Does it add tests, or meddle with the check?`);
    const failures = cases.flatMap(failures_of), unwritten = failures.filter(failure => failure.message.startsWith(not_implemented));
    if (failures.length && unwritten.length === failures.length && new Set(failures.map(failure => failure.name)).size === cases.length)
        return result("untouched", "", failures);
    return result(failures.length || done.code ? "failed" : "passed", "", failures);
}

function unescaped(text) {
    return new DOMParser().parseFromString(text, "text/html").documentElement.textContent;
}

/** The cases of a report; null where it was never finished. */
function cases_in(report) {
    const parsed = new DOMParser().parseFromString(report, "text/xml");
    return parsed.querySelector("parsererror") ? null : [...parsed.querySelectorAll("TestCase")].filter(one => one.getAttribute("skipped") !== "true");
}

function crash_of({ err }) {
    const found = /Assertion failed: (.*) \(([^()]*): [^()]*: (\d+)\)/.exec(err);
    return found ? `The program crashed: at ${found[2].split("/").at(-1)}:${found[3]} this should hold: ${found[1]}.`
        : "The program crashed: often an index or a pointer out of range, or a function that calls itself without end.";
}

const text_of = element => (element?.firstChild?.nodeValue ?? "").trim();
const children = (element, name) => [...element.children].filter(child => child.tagName === name);

/** A case's expectations that do not hold, and its exceptions. */
function failures_of(one) {
    const name = one.getAttribute("name"), found = [];
    for (const expression of one.querySelectorAll("Expression[success=false]")) {
        const infos = children(expression, "Info").map(text_of), original = text_of(children(expression, "Original")[0]);
        if (original === "right") { // from expect: its message is the last of the infos
            found.push({ name, given: infos.slice(-2, -1), message: infos.at(-1) });
        } else {
            const thrown = children(expression, "Exception")[0];
            const got = thrown ? `threw ${text_of(thrown)}` : `got ${text_of(children(expression, "Expanded")[0])}`;
            found.push({ name, given: infos.slice(-1), message: `expected ${original}, ${got}` });
        }
    }
    for (const message of one.querySelectorAll("Message"))
        if (["ERROR", "FATAL ERROR"].includes(message.getAttribute("type")))
            found.push({ name, given: [], message: text_of(children(message, "Text")[0]) });
    for (const exception of [...children(one, "Exception"), ...children(one, "SubCase").flatMap(part => children(part, "Exception"))]) {
        const text = text_of(exception).replace(/^"+|"+$/g, "");
        found.push({ name, given: [], message: text.startsWith(not_implemented) ? text : `${threw}: ${text}` });
    }
    return found;
}

// ------------------------------------------------------------------------------------------------- what a student is told
const failed_cases = outcome => [...new Set(outcome.failures.map(failure => failure.name))];
const to_explain = outcome => new Set(outcome.failures.filter(({ message }) => !message.startsWith(threw) && !message.startsWith(not_implemented)).map(({ name }) => name));
const wrong_numbers = outcome => new Set(outcome.failures.map(({ name, message }) => JSON.stringify([name, message])));
const within = (part, whole) => part.every(one => whole.has(one));
const indented = (text, by) => text.replace(/^(?=.)/gm, by);

/** The verdict, without its diagnosis. */
export function told(exercise, outcome) {
    const head = `${exercise.number} ${exercise.title}: `;
    if (outcome.state === "passed")
        return `${head}right. All ${outcome.cases} properties hold.\n${indented(outcome.said.trimEnd(), "   ")}` + (exercise.rebuilt
            ? `\n\nIn the course's folder, ./course check ${exercise.number} also runs the chapter's own tests and a scene with your code.` : "");
    if (outcome.state === "untouched")
        return head + "not implemented yet.";
    if (outcome.state === "does_not_compile")
        return `${head}does not compile yet.\n\n${outcome.message}`;
    if (outcome.state !== "failed")
        return head + outcome.message;
    const failed = failed_cases(outcome), first = failed.slice(0, most_failures).map(name => outcome.failures.find(failure => failure.name === name));
    const others = failed.length > most_failures ? ["  nor do these hold:", ...failed.slice(most_failures).map(name => `    ${name}`)] : [];
    return [`${head}${outcome.cases - failed.length} of ${outcome.cases} properties hold.`,
        ...first.map(failure => [`  does not hold: ${failure.name}`, ...failure.given.map(line => indented(line, "    with ")), indented(failure.message, "    ")].join("\n")),
        ...others.length ? [others.join("\n")] : []].join("\n\n");
}

/** The known mistakes whose wrong numbers this answer has.
 *  @param judged  gives the outcome of a known mistake, or nothing where nobody waits any more */
export async function diagnosis(exercise, outcome, judged) {
    const cases = to_explain(outcome), mine = wrong_numbers(outcome), found = [];
    for (const mutant of exercise.mutants.filter(mutant => within(mutant.fails, cases))) {
        const its = await judged(mutant);
        if (!its)
            return "";
        const theirs = [...wrong_numbers(its)], same = theirs.filter(one => mine.has(one)).length;
        if (2 * same > theirs.length)
            found.push({ same, mutant });
    }
    const most = Math.max(0, ...found.map(({ same }) => same));
    if (found.length) {
        const apart = outcome.failures.some(({ message }) => /\d\.\d{2}|\d{3}|\de[-+]\d/.test(message.split(", got ").slice(1).join(", got ")));
        return found.filter(({ same }) => same === most).map(({ mutant }) => (apart ? "Perhaps: " : "This has many possible reasons. One of them: ") + mutant.diagnosis).join("\n\n");
    }
    return "";
}

/** The first errors of the compiler, each at its line of the answer. */
export function compiler_errors(says, exercise, text) {
    const lines = text.split("\n"), errors = [];
    for (const [, file, line, column, kind, message] of says.matchAll(/^([^:\n]+):(\d+):(\d+): (?:fatal )?(error|note): (.*)$/gm)) {
        const place = file === "answer.cpp" ? [Number(line), Number(column)] : null;
        if (kind === "error")
            errors.push({ place, file, line, message: message.replace(/\s*\[-W\S+\]/, "") });
        else if (errors.length && !errors.at(-1).place)
            errors.at(-1).place = place; // what led into a header
    }
    const shown = errors.map(({ place, file, line, message }) => place
        ? `${exercise.file}:${place[0]}: ${message}\n    ${lines[place[0] - 1] ?? ""}\n    ${" ".repeat(Math.max(0, place[1] - 1))}^` : `${file.replace("/usr/course/", "")}:${line}: ${message}`);
    if (shown.length > most_errors)
        shown.splice(most_errors, shown.length, `... and ${shown.length - most_errors} more, which often go away with the first.`);
    return shown.join("\n") || says.slice(-3000);
}

/** What the linker missed, by name. */
export function linker_errors(says) {
    const missed = [...says.matchAll(/undefined symbol: (.+)/g)].map(found => `Your file should define ${found[1]}; its name, its arguments or its namespace differ.`);
    return [...new Set(missed)].slice(0, most_errors).join("\n") || says.slice(-2000);
}
