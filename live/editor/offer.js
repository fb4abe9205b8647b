// Offers an editor to each exercise of a served page. From a file, workers and their compiler cannot be loaded: there the page stays as it is.
if (location.protocol.startsWith("http"))
    for (const number of document.currentScript.dataset.exercises.split(" ")) {
        const button = document.createElement("button");
        Object.assign(button, { type: "button", className: "editor-open", textContent: "Write it here",
            title: `An editor, and a compiler that runs in this page (${document.currentScript.dataset.size} MB)` });
        button.dataset.exercise = number;
        button.onclick = async () => {
            button.disabled = true;
            window.editors = { ...window.editors, [number]: await (await import("./page.js")).open(number, button) };
        };
        let at = document.getElementById(`exercise_${number.replace(".", "_")}`)?.closest("h1, h2, h3");
        while (at && !at.textContent.startsWith("Your file is"))
            at = at.nextElementSibling;
        at?.after(button);
    }
