MathJax.Hub.Config({
  messageStyle: "none",
  showMathMenu: false,
  SVG: { font: "TeX", blacker: 1, matchFontHeight: true, scale: 90 },
  TeX: { Macros: { vec: ["\\boldsymbol{#1}", 1] }, extensions: ["AMSmath.js", "AMSsymbols.js", "boldsymbol.js"] }
});
