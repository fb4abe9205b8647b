// The editors in a page of exercises. Loaded when the first one is opened.
import { basicSetup } from "codemirror";
import { EditorView, keymap } from "@codemirror/view";
import { indentWithTab } from "@codemirror/commands";
import { indentUnit, syntaxHighlighting } from "@codemirror/language";
import { cpp } from "@codemirror/lang-cpp";
import { classHighlighter } from "@lezer/highlight";
import { compiler_errors, diagnosis, linker_errors, outcome, run, told } from "./judge.js";

const place = name => new URL(name, import.meta.url);
const made = (name, words = {}, ...inside) => {
    const element = Object.assign(document.createElement(name), words);
    element.append(...inside);
    return element;
};

/** Clang in a worker. It is loaded once for all editors of a page. */
class Compiler {
    constructor(offered) {
        this.offered = offered;
        this.waiting = new Map();
        this.tell = () => {};
        this.worker = new Worker(place("compiler.js"), { type: "module" });
        this.worker.onmessage = ({ data }) => this.hear(data);
        this.worker.onerror = error => this.waiting.forEach(({ reject }) => reject(new Error(error.message)));
        this.loaded = this.ask("load", offered);
    }

    hear({ id, answer, error, loaded }) {
        if (loaded !== undefined)
            this.tell(`The compiler is being loaded: ${(loaded / 1e6).toFixed(0)} of ${(this.offered.size / 1e6).toFixed(0)} MB.`);
        else if (error)
            this.waiting.get(id).reject(new Error(error));
        else
            this.waiting.get(id).resolve(answer);
    }

    ask(what, ...words) {
        const id = this.waiting.size;
        this.worker.postMessage({ id, what, words });
        return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
    }
}

let offered, compiler;
const judged = new Map(); // outcomes by exercise and text, as long as the page is open

async function judge(exercise, text) {
    const key = `${exercise.number} ${text}`;
    if (!judged.has(key)) {
        const { program, compiler: says, linker } = await compiler.ask("build", exercise, text);
        judged.set(key, program ? outcome(await run(program, place("runner.js")), exercise.properties)
            : { state: "does_not_compile", message: says === undefined ? linker_errors(linker) : compiler_errors(says, exercise, text), cases: 0, failures: [], said: "" });
    }
    return judged.get(key);
}

class Editor {
    constructor(exercise) {
        this.exercise = exercise;
        this.turn = 0; // of its checks
        this.key = `enduring contacts ${exercise.number}`;
        this.state = made("span", { className: "editor-state" });
        this.state.setAttribute("role", "status");
        this.verdict = made("pre", { className: "editor-verdict", hidden: true });
        this.button = made("button", { type: "button", textContent: "Check", title: "Ctrl-Enter", onclick: () => this.check() });
        this.view = new EditorView({
            doc: localStorage.getItem(this.key) ?? exercise.stub,
            extensions: [keymap.of([{ key: "Mod-Enter", run: () => (this.check(), true) }, indentWithTab]), basicSetup, cpp(), syntaxHighlighting(classHighlighter), indentUnit.of("    "),
                EditorView.contentAttributes.of({ "aria-label": `Your file of exercise ${exercise.number}` }),
                EditorView.updateListener.of(update => update.docChanged && localStorage.setItem(this.key, this.text))],
        });
        const again = made("button", { type: "button", textContent: "Start again", onclick: () => confirm("Take the empty file, and forget what you wrote?") && this.write(exercise.stub) });
        const save = made("button", { type: "button", textContent: "Save as a file", onclick: () => this.save() });
        this.box = made("div", { className: "editor" }, this.view.dom, made("div", { className: "editor-bar" }, this.button, again, save, this.state), this.verdict);
    }

    get text() { return this.view.state.doc.toString(); }

    write(text) {
        this.view.dispatch({ changes: { from: 0, to: this.view.state.doc.length, insert: text } });
    }

    save() {
        const link = made("a", { href: URL.createObjectURL(new Blob([this.text])), download: this.exercise.file.split("/").at(-1) });
        link.click();
        URL.revokeObjectURL(link.href);
    }

    tell(text) { this.state.textContent = text; }

    /** Loads what a check needs, while the student still writes. */
    async prepare() {
        compiler.tell = text => this.tell(text);
        await compiler.loaded;
        this.tell("The check is being compiled, once.");
        await compiler.ask("prepare", this.exercise);
        this.tell("Ready.");
    }

    show(text, state) {
        this.verdict.hidden = false;
        this.verdict.textContent = text;
        this.verdict.dataset.state = state;
    }

    /** The verdict of what stands in the editor; then its diagnosis, if no other check begins before that is found. */
    async check() {
        const turn = ++this.turn;
        this.button.disabled = true;
        try {
            await this.prepared;
            this.tell("Compiling.");
            const begun = performance.now(), found = await judge(this.exercise, this.text), verdict = told(this.exercise, found);
            this.show(verdict, found.state);
            this.tell(`${((performance.now() - begun) / 1000).toFixed(1)} s.`);
            if (found.state === "failed") {
                this.button.disabled = false;
                this.tell("Compared with known mistakes.");
                const reason = await diagnosis(this.exercise, found, mutant => turn === this.turn ? judge(this.exercise, mutant.text) : null);
                if (turn === this.turn) {
                    found.diagnosis = reason;
                    this.show(reason ? `${verdict}\n\n${reason}` : verdict, found.state);
                    this.tell("");
                }
            }
            return found;
        } catch (error) {
            this.show(`The page could not compile here. ./course check ${this.exercise.number} does the same in the course's folder.\n\n${error.message}`, "broken");
            return { state: "broken", message: error.message };
        } finally {
            this.button.disabled = false;
        }
    }
}

/** Opens an exercise's editor in the place of its button. */
export async function open(number, button) {
    offered ??= await new Response((await fetch(place("exercises.json.gz"))).body.pipeThrough(new DecompressionStream("gzip"))).json();
    compiler ??= new Compiler(offered);
    const editor = new Editor(offered.exercises.find(exercise => exercise.number === number));
    button.replaceWith(editor.box);
    editor.prepared = editor.prepare();
    editor.prepared.catch(error => editor.tell(error.message.split("\n")[0]));
    return editor;
}
