// What all live figures share: sliders and choices, a canvas that fits its column, handles to drag, axes, and the page's colours.
// A figure says how it draws; this file says when. Without the compiled chapters, or without WebAssembly, the picture stays.
"use strict";

const Live = (() => {
  const builders = {};
  const INK = { blue: "#3f8fd0", red: "#d9673f", green: "#4aa36b", ochre: "#c9982f", violet: "#9a78c8", grey: "#8a8f98" };

  function colours(element) {
    const style = getComputedStyle(element);
    const of = name => style.getPropertyValue(name).trim();
    return { ...INK, text: of("--page-foreground-color"), soft: of("--page-secondary-foreground-color"), line: of("--separator-color"),
             page: of("--page-background-color") };
  }

  class Figure {
    constructor(element) {
      this.element = element;
      this.values = {};
      this.handles = [];
      this.surfaces = [];
      this.controls = this.append("div", "live-controls");
      this.canvas = this.append("canvas", "live-canvas");
      this.canvas.setAttribute("role", "img");
      this.canvas.setAttribute("aria-label", element.querySelector("img")?.alt ?? "a live figure");
      this.answer = this.append("p", "live-answer");
      this.answer.setAttribute("aria-live", "polite");
      this.aspect = 0.5;       // height over width; on a phone half as much again, unless it says otherwise
      this.listen();
    }

    append(tag, name) {
      const child = document.createElement(tag);
      child.className = name;
      this.element.append(child);
      return child;
    }

    // A number between two ends. `read` turns the slider's place (0 to 1000) into the value, for scales that are not linear.
    slider({ name, label, from, to, value, unit = "", digits = 2, logarithmic = false }) {
      const read = place => logarithmic ? from * (to / from) ** (place / 1000) : from + (to - from) * place / 1000;
      const place = v => Math.round(1000 * (logarithmic ? Math.log(v / from) / Math.log(to / from) : (v - from) / (to - from)));
      const row = this.append("label", "live-control");
      this.controls.append(row);
      const input = Object.assign(document.createElement("input"), { type: "range", min: 0, max: 1000, value: place(value) });
      const shown = document.createElement("output");
      row.append(document.createTextNode(label), input, shown);
      const take = () => {
        this.values[name] = Number(read(Number(input.value)).toFixed(digits)); // what is shown is what is used
        shown.textContent = `${this.values[name].toFixed(digits)} ${unit}`.trim();
      };
      input.addEventListener("input", () => { take(); this.change(name); });
      take();
      return { set: v => { input.value = place(v); take(); } };
    }

    choice({ name, label, options }) {
      const row = this.append("label", "live-control");
      this.controls.append(row);
      const select = document.createElement("select");
      for (const [value, text] of options) select.add(new Option(text, value));
      row.append(document.createTextNode(label), select);
      this.values[name] = options[0][0];
      select.addEventListener("input", () => { this.values[name] = select.value; this.change(name); });
    }

    button(label, press) {
      const button = Object.assign(document.createElement("button"), { type: "button", textContent: label });
      button.addEventListener("click", press);
      this.controls.append(button);
      return button;
    }

    // A point that can be dragged: where() gives its place on the canvas, drag(x, y) takes a new one.
    handle(where, drag) { this.handles.push({ where, drag }); }

    // A part of the canvas that is dragged where no handle is: inside(x, y), and drag(dx, dy) in pixels.
    surface(inside, drag) {
      this.surfaces.push({ inside, drag });
      this.canvas.style.touchAction = "pan-y"; // a finger that goes up or down scrolls the page, one that goes sideways drags
      this.canvas.dataset.preventSwipe = "";   // and does not turn a slide over
    }

    listen() {
      let held = null, pulled = null, last = null; // the handle, the surface, and where the pointer was
      const place = event => { // on the canvas, which a slide shows larger or smaller
        const box = this.canvas.getBoundingClientRect(), larger = box.width / this.canvas.clientWidth;
        return [(event.clientX - box.left) / larger, (event.clientY - box.top) / larger];
      };
      const near = (x, y) => this.handles.find(({ where }) => Math.hypot(where()[0] - x, where()[1] - y) < 22);
      this.canvas.addEventListener("pointerdown", event => {
        last = place(event);
        held = near(...last);
        pulled = held ? null : this.surfaces.find(({ inside }) => inside(...last));
        if (held || pulled) this.canvas.setPointerCapture(event.pointerId);
        if (held) event.preventDefault();
      });
      this.canvas.addEventListener("pointermove", event => {
        const at = place(event);
        if (held) { held.drag(...at); this.change("drag"); }
        if (pulled) { pulled.drag(at[0] - last[0], at[1] - last[1]); last = at; }
        this.canvas.style.cursor = near(...at) ? "grab" : this.surfaces.some(({ inside }) => inside(...at)) ? "move" : "default";
      });
      for (const end of ["pointerup", "pointercancel"]) this.canvas.addEventListener(end, () => { held = pulled = null; });
      this.canvas.addEventListener("touchstart", event => {
        const touch = event.touches[0];
        if (near(...place(touch))) event.preventDefault();
      }, { passive: false });
    }

    change(name) { this.changed?.(name); this.redraw(); }

    redraw() {
      if (this.waiting) return;
      this.waiting = true;
      requestAnimationFrame(() => { this.waiting = false; this.paint(); });
    }

    paint() {
      const width = this.element.clientWidth;
      if (!width) return; // not shown; when it is, its size changes, and it is painted
      const height = Math.round(width * (width < 500 ? this.onPhone ?? 1.5 * this.aspect : this.aspect));
      const scale = window.devicePixelRatio || 1;
      Object.assign(this.canvas, { width: width * scale, height: height * scale });
      this.canvas.style.height = `${height}px`;
      const g = this.canvas.getContext("2d");
      g.scale(scale, scale);
      g.font = `${width < 500 ? 11 : 13}px ${getComputedStyle(this.element).fontFamily}`;
      g.lineJoin = g.lineCap = "round";
      const text = this.draw(g, width, height, colours(this.element), this.values);
      this.answer.textContent = text;
      this.element.dataset.answer = text;
    }

    // Calls step(seconds since the last frame) from start() to stop(), or until the figure is out of view.
    animate(step) {
      let last = null, running = false;
      const frame = now => {
        if (!running) return;
        step(Math.min(0.05, last === null ? 0 : (now - last) / 1000));
        last = now;
        this.paint();
        requestAnimationFrame(frame);
      };
      const start = () => { if (!running) { running = true; last = null; requestAnimationFrame(frame); } };
      const stop = () => { running = false; };
      new IntersectionObserver(entries => { if (!entries[0].isIntersecting) stop(); }).observe(this.canvas);
      return { start, stop };
    }
  }

  // ------------------------------------------------------------------------------------------------------- drawing
  // Axes around a box; returns the functions from numbers to places.
  function axes(g, c, box, { x, y, xlabel = "", ylabel = "", xticks = 5, yticks = 5 }) {
    const [left, top, width, height] = box;
    const at = { x: v => left + width * (v - x[0]) / (x[1] - x[0]), y: v => top + height * (1 - (v - y[0]) / (y[1] - y[0])) };
    g.strokeStyle = c.line; g.fillStyle = c.soft; g.lineWidth = 1;
    g.strokeRect(left, top, width, height);
    g.textAlign = "center"; g.textBaseline = "top";
    for (const v of ticks(x, xticks)) { line(g, c.line, 1, [[at.x(v), top], [at.x(v), top + height]]); g.fillText(short(v), at.x(v), top + height + 4); }
    g.textAlign = "right"; g.textBaseline = "middle";
    for (const v of ticks(y, yticks)) { line(g, c.line, 1, [[left, at.y(v)], [left + width, at.y(v)]]); g.fillText(short(v), left - 5, at.y(v)); }
    g.textAlign = "center"; g.textBaseline = "top";
    g.fillText(xlabel, left + width / 2, top + height + 19);
    g.textAlign = "left"; g.textBaseline = "bottom";
    g.fillText(ylabel, left, top - 3);
    return at;
  }

  function ticks([from, to], count) {
    const rough = (to - from) / count, power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 5, 10].map(m => m * power).find(s => s >= rough);
    const found = [];
    for (let v = Math.ceil(from / step - 1e-9) * step; v <= to + 1e-9 * step; v += step) found.push(v);
    return found;
  }

  const short = v => String(Number(v.toPrecision(3)));

  function line(g, colour, width, points, dash = []) {
    g.strokeStyle = colour; g.lineWidth = width; g.setLineDash(dash);
    g.beginPath();
    points.forEach(([x, y], i) => i ? g.lineTo(x, y) : g.moveTo(x, y));
    g.stroke();
    g.setLineDash([]);
  }

  function area(g, colour, points) {
    g.fillStyle = colour;
    g.beginPath();
    points.forEach(([x, y], i) => i ? g.lineTo(x, y) : g.moveTo(x, y));
    g.closePath();
    g.fill();
  }

  function dot(g, colour, [x, y], radius = 4, hollow = false) {
    g.beginPath();
    g.arc(x, y, radius, 0, 2 * Math.PI);
    g.fillStyle = g.strokeStyle = colour;
    g.lineWidth = 2;
    hollow ? g.stroke() : g.fill();
  }

  function arrow(g, colour, [x0, y0], [x1, y1], width = 2.5) {
    const length = Math.hypot(x1 - x0, y1 - y0);
    if (length < 2) return;
    const u = (x1 - x0) / length, v = (y1 - y0) / length, head = Math.min(10, length / 2);
    line(g, colour, width, [[x0, y0], [x1 - head * u, y1 - head * v]]);
    area(g, colour, [[x1, y1], [x1 - head * u - head * 0.5 * v, y1 - head * v + head * 0.5 * u], [x1 - head * u + head * 0.5 * v, y1 - head * v - head * 0.5 * u]]);
  }

  function label(g, colour, text, [x, y], align = "left") {
    g.fillStyle = colour; g.textAlign = align; g.textBaseline = "middle";
    g.fillText(text, x, y);
  }

  // ------------------------------------------------------------------------------------------------------- starting
  async function start() {
    const places = [...document.querySelectorAll("[data-live]")];
    if (!places.length || typeof enduring_live !== "function") return;
    const chapters = await enduring_live();
    for (const element of places) {
      const build = builders[element.dataset.live] ?? builders[element.dataset.figure];
      if (!build) continue;
      element.dataset.figure ||= element.dataset.live;
      const figure = new Figure(element);
      build(figure, chapters);
      figure.paint();
      element.classList.add("is-live");
      element.dataset.live = "ready";
      new ResizeObserver(() => figure.redraw()).observe(element);
      new MutationObserver(() => figure.redraw()).observe(document.documentElement, { attributes: true, attributeFilter: ["class"] });
    }
  }

  return { add: (name, build) => { builders[name] = build; }, start, axes, line, area, dot, arrow, label };
})();

window.addEventListener("load", () => { Live.start(); });
