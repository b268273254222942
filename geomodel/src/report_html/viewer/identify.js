// SPDX-License-Identifier: MIT
// What was clicked: its name and measures, and what can be done with it.
const card = find(".card");
const tell = text => { find(".says").textContent = text; };
function element(kind, text, more) {
  const e = Object.assign(document.createElement(kind), more);
  if (text !== undefined) e.textContent = text;
  return e;
}
function facts(list) {
  const dl = element("dl");
  for (const [name, text] of list) if (text !== "") dl.append(element("dt", name), element("dd", text));
  return dl;
}
function placeWords(p) {
  return [0, 1, 2].map(k => plainly(p[k] + model.middle[k], model.size[k])).join(", ") + " " + model.unit;
}
function showOnly(id) {
  state.regions.clear(); state.regions.add(id); state.opacity.delete(id);
  refreshList(); build();
  tell("Only " + regionOf.get(id).name + " is shown.");
}
function showAll() {
  model.regions.forEach(r => state.regions.add(r.id));
  state.opacity.clear(); refreshList(); build();
  tell("All units are shown.");
}
function opacitySlider(id) {
  const label = element("label", "Opacity "), slider = element("input", undefined, {type: "range", min: 0, max: 1, step: 0.05});
  slider.value = opacityOf(id);
  slider.oninput = () => { Number(slider.value) < 1 ? state.opacity.set(id, Number(slider.value)) : state.opacity.delete(id); build(); };
  label.append(slider);
  return label;
}
function button(text, action) { return element("button", text, {type: "button", onclick: action}); }
function regionCard(r, hit) {
  const q = quantity(), all = model.regions.reduce((sum, x) => sum + x.volume, 0), inside = r.inside.filter(name => name !== r.name).join(", ");
  card.append(element("h3", r.name), facts([["volume", volumeWords(r.volume) + " (" + measure(Math.round(1000 * r.volume / all) / 10) + " %)"], ["tetrahedra", r.tetrahedra.toLocaleString("en")], ["lies in", inside],
    ["place", hit ? placeWords(hit.at) : ""], [q ? q.name : "", hit && Number.isFinite(hit.value) ? measure(hit.value) + " " + q.unit : ""]]), opacitySlider(r.id));
  const row = element("div", undefined, {className: "set"});
  row.append(button("Only this", () => showOnly(r.id)), button("Hide", () => { state.regions.delete(r.id); refreshList(); build(); }), button("Show all", showAll));
  card.append(row);
}
/** A region or surface by its id; null: nothing. */
function choose(id, hit) {
  state.chosen = id;
  card.replaceChildren();
  const r = regionOf.get(id), s = surfaceOf.get(id);
  if (r) regionCard(r, hit);
  if (s) card.append(element("h3", s.name), facts([["kind", s.kind], ["area", measure(s.area) + " " + model.unit + "2"], ["place", hit ? placeWords(hit.at) : ""]]));
  if (r || s) tell((r || s).name + (hit ? " at " + placeWords(hit.at) : "") + ".");
  refreshList(); build();
}
