// SPDX-License-Identifier: MIT
// The list of what can be shown.
const list = find(".list"), refreshers = [];
function refreshList() { for (const refresh of refreshers) refresh(); }
/** A heading that folds, and a line for each item. */
function group(text, items, shown, only = false, isFolded = false) {
  if (!items.length) return;
  const box = element("details", undefined, {open: !isFolded});
  box.append(element("summary", text));
  for (const item of items) {
    const row = element("div", undefined, {className: "item"}), label = element("label"), check = element("input", undefined, {type: "checkbox"}), swatch = element("i");
    swatch.style.background = item.colour;
    check.onchange = () => { if (check.checked) shown.add(item.id); else shown.delete(item.id); build(); };
    refreshers.push(() => { check.checked = shown.has(item.id); row.classList.toggle("chosen", state.chosen === item.id); });
    label.append(check, swatch, item.name); row.append(label);
    if (only) row.append(element("button", "only", {type: "button", className: "only", onclick: () => { showOnly(item.id); choose(item.id); }, ariaLabel: "only " + item.name}));
    box.append(row);
  }
  if (only) box.append(button("Show all units", showAll));
  list.append(box);
}
/** Wells first; lines in which sides of the box meet would only hide what matters. */
function fillList() {
  group("Units", model.regions, state.regions, model.regions.length > 1);
  group("Surfaces", model.surfaces, state.surfaces);
  const isBox = new Set(model.surfaces.filter(s => s.kind === "box").map(s => s.name));
  const lines = model.curves.filter(c => !c.name.split("*").every(name => isBox.has(name)));
  group("Wells and curves", lines.filter(c => c.kind === "well").concat(lines.filter(c => c.kind !== "well")), state.curves, false, !lines.some(c => c.kind === "well"));
  group("Elements", model.worst.length ? [{id: 0, name: model.worst.length + " worst elements", colour: "#dc0078"}] : [], state.worst);
  refreshList();
}
