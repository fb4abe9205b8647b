// The search of the book: a field in the sidebar; its index is loaded when a reader first types (docs/tools/book_search.py).
(() => {
  const MOST = 40, AROUND = 70;
  const here = document.currentScript.src.replace(/search\.js.*$/, ""), book = here.replace(/search\/$/, "");
  const box = document.createElement("form");
  box.id = "book-search";
  box.setAttribute("role", "search");
  box.innerHTML = '<div class="row"><input type="search" placeholder="Search the book" aria-label="Search the book" autocomplete="off" spellcheck="false"></div><div class="found" hidden></div>';
  const [row, shown] = box.children, field = row.firstChild;
  let index = null, loading = null, chosen = -1;

  const script = name => new Promise((done, failed) => {
    const element = document.createElement("script");
    Object.assign(element, { src: here + name, onload: done, onerror: () => failed(new Error(name)) });
    document.head.append(element);
  });

  const load = () => loading ??= script("lunr.js").then(() => script("index.js")).then(() => { index = lunr.Index.load(window.BOOK_SEARCH.index); });

  // How well each section fits one word: the word itself, its stem, or what begins with it.
  function fits(word) {
    const found = new Map(index.query(query => {
      query.term(word, { boost: 10 });
      query.term(word, { usePipeline: false, wildcard: lunr.Query.wildcard.TRAILING });
    }).map(result => [Number(result.ref), result.score]));
    return found;
  }

  // Sections with all words, the best first; those with the words side by side stand above the others. Where none has all, those with the most.
  function search(text) {
    const words = text.toLowerCase().split(/[\s-]+/).map(word => word.replace(/^\W+|\W+$/g, "")).filter(Boolean);
    const scores = words.map(fits), sections = window.BOOK_SEARCH.sections, phrase = words.join(" ");
    const count = i => scores.filter(score => score.has(i)).length;
    const candidates = [...new Set(scores.flatMap(score => [...score.keys()]))];
    const most = Math.max(0, ...candidates.map(count));
    const side = i => `${sections[i].heading} ${sections[i].text}`.toLowerCase().replace(/-/g, " ").includes(phrase) ? 1000 : 0;
    return candidates.filter(i => count(i) === most).map(i => [i, side(i) + scores.reduce((sum, score) => sum + (score.get(i) ?? 0), 0)])
      .sort((a, b) => b[1] - a[1] || a[0] - b[0]).slice(0, MOST).map(([i]) => [sections[i], words]);
  }

  function line([section, words]) {
    const link = document.createElement("a"), where = document.createElement("b"), around = document.createElement("span");
    link.href = book + section.place;
    where.textContent = section.heading && section.heading !== section.page ? `${section.heading} · ${section.page}` : section.page;
    const lower = section.text.toLowerCase(), phrase = lower.indexOf(words.join(" "));
    const at = Math.max(0, phrase >= 0 ? phrase : Math.min(...words.map(word => lower.indexOf(word)).filter(place => place >= 0), section.text.length));
    const from = Math.max(0, at - AROUND), piece = section.text.slice(from === 0 ? 0 : section.text.indexOf(" ", from) + 1, at + 2 * AROUND);
    const marks = new RegExp(`(${words.map(word => word.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")).join("|")})`, "i");
    piece.split(marks).forEach((part, i) => {
      const element = i % 2 ? document.createElement("mark") : document.createTextNode(part);
      if (i % 2) element.textContent = part;
      around.append(element);
    });
    link.append(where, around);
    return link;
  }

  async function show() {
    const text = field.value.trim();
    shown.hidden = text.length < 2;
    if (shown.hidden) return;
    try {
      await load();
    } catch (error) {
      shown.textContent = `The index cannot be read: ${error.message}`;
      return;
    }
    if (text !== field.value.trim()) return;
    const lines = search(text).map(line);
    chosen = -1;
    shown.replaceChildren(...(lines.length ? lines : [`Nothing about “${text}”.`]));
  }

  function move(by) {
    const lines = [...shown.querySelectorAll("a")];
    lines[chosen]?.classList.remove("chosen");
    chosen = Math.max(-1, Math.min(lines.length - 1, chosen + by));
    lines[chosen]?.classList.add("chosen");
    lines[chosen]?.scrollIntoView({ block: "nearest" });
  }

  field.addEventListener("input", show);
  field.addEventListener("focus", () => load().catch(() => {}));
  field.addEventListener("keydown", event => {
    if (event.key === "ArrowDown" || event.key === "ArrowUp") { event.preventDefault(); move(event.key === "ArrowDown" ? 1 : -1); }
    if (event.key === "Escape") { field.value = ""; show(); }
  });
  box.addEventListener("submit", event => {
    event.preventDefault();
    (shown.querySelector("a.chosen") ?? shown.querySelector("a"))?.click();
  });
  document.addEventListener("click", event => { if (!box.contains(event.target)) shown.hidden = true; });
  // Doxygen-awesome puts its switch of themes beside Doxygen's own search field. The book has another field, so an empty element
  // stands in for Doxygen's. The theme looks for it as soon as the page is parsed: it has to be there before.
  const place = document.createElement("span");
  place.id = "MSearchBox";
  place.style.setProperty("display", "none", "important");
  row.append(place);
  new MutationObserver((_, observer) => { // once the switch has come, make it a button for the keyboard, too
    const toggle = row.querySelector("doxygen-awesome-dark-mode-toggle");
    if (!toggle) return;
    observer.disconnect();
    toggle.tabIndex = 0;
    toggle.setAttribute("role", "button");
    toggle.setAttribute("aria-label", toggle.title);
    toggle.addEventListener("keydown", event => {
      if (event.key === "Enter" || event.key === " ") { event.preventDefault(); toggle.click(); }
    });
  }).observe(row, { childList: true });
  document.addEventListener("readystatechange", () => {
    if (document.readyState === "interactive") document.getElementById("titlearea")?.append(box);
  });
})();
