// Renders the formulas that Sphinx leaves as \(...\) and \[...\].
document.addEventListener("DOMContentLoaded", () => {
  document.querySelectorAll(".math").forEach((place) => {
    const source = place.textContent.trim().replace(/^\\[([]|\\[)\]]$/g, "");
    katex.render(source, place, { displayMode: place.tagName === "DIV", output: "mathml", throwOnError: false });
  });
});
