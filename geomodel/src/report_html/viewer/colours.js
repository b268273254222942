// SPDX-License-Identifier: MIT
// Colours of units, surfaces and numbers.
const rgb = text => [1, 3, 5].map(i => parseInt(text.slice(i, i + 2), 16));
const rgbOf = text => (text.match(/[\d.]+/g) || [255, 255, 255]).slice(0, 3).map(Number);
const colourOf = new Map(model.regions.concat(model.surfaces, model.curves).map(x => [x.id, rgb(x.colour)]));
const notKnown = 255, unknownColour = [150, 150, 150];
/** Even to the eye from dark to light (after viridis of matplotlib). */
const evenSteps = ["#440154", "#46327e", "#365c8d", "#277f8e", "#1fa187", "#4ac16d", "#a0da39", "#fde725"].map(rgb), angleSteps = model.angle_colours.map(rgb);

/** The number that colours are by; null: units. */
const quantity = () => model.quantities[Number(control("colours").value)] || null;
const stepsOf = q => q === model.quantities[0] ? angleSteps : evenSteps;
/** Angles have plain steps, as in `geomesh picture`; all else is blended. */
function mixed(steps, share) {
  if (steps === angleSteps) return steps[Math.min(steps.length - 1, Math.floor(share * steps.length))];
  const at = share * (steps.length - 1), i = Math.min(steps.length - 2, Math.floor(at));
  return steps[i].map((x, k) => Math.round(x + (steps[i + 1][k] - x) * (at - i)));
}
const scales = new Map();
function scaleOf(q) {
  if (!scales.has(q)) scales.set(q, Array.from({length: 256}, (_, i) => i === notKnown ? unknownColour : mixed(stepsOf(q), i / 254)));
  return scales.get(q);
}
const valueOf = (q, step) => step === notKnown || step === undefined ? NaN : q.low + (q.high - q.low) * step / 254;
