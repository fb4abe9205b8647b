// The vertical axis of a curve: where it begins and ends, and how its ends are written.

const TOUCHING = 1e-8, ROUNDING = 1e-16; // [m] a first touch; what stands for zero on a logarithmic axis

const middleOf = values => [...values].sort((a, b) => a - b)[values.length >> 1];

// A logarithmic axis of whole decades. It begins at a first touch of 10 nm, or below: no solver's curve lies under the axis for half of its steps.
function decades(series) {
  const curves = series.map(values => values.filter(v => v > 0)).filter(values => values.length), all = curves.flat();
  const least = Math.max(ROUNDING, Math.min(TOUCHING, ...curves.map(values => middleOf(values) / 10)));
  const low = Math.floor(Math.log10(Math.max(least, Math.min(...all))) + 1e-9), high = Math.ceil(Math.log10(Math.max(...all, least)) - 1e-9);
  return all.length ? { low, high: Math.max(high, low + 1) } : { low: Math.log10(TOUCHING), high: -3 };
}

// A linear axis; it begins at zero where it nearly does.
function linear(series, from) {
  const all = series.flat().filter(Number.isFinite), high = Math.max(...all);
  if (!all.length) return { low: 0, high: 1 };
  const least = Math.min(...all), low = from ?? (least > 0 && least < 0.05 * high ? 0 : least);
  return high - low < 1e-9 * Math.max(1, Math.abs(high)) ? { low: from ?? low - 0.5, high: high + (from === undefined ? 0.5 : 1) } : { low, high };
}

// series: of each curve its values. @return {low, high}, what `of` gives for a value: 0 at the bottom, 1 at the top, null where a value has no place; and the values at the ends
export function axisOf(series, { logarithmic = false, from } = {}) {
  const { low, high } = logarithmic ? decades(series) : linear(series, from);
  const of = v => {
    if (!Number.isFinite(v) || logarithmic && v <= 0) return null;
    return logarithmic ? Math.max(0, (Math.log10(v) - low) / (high - low)) : (v - low) / (high - low);
  };
  return { low, high, of, ends: logarithmic ? [10 ** low, 10 ** high] : [low, high] };
}
