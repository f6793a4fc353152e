// Long answers come in stages, each of them whole, so that something is there early and stays when the rest is stopped.

/** Numbers up to the last one, each so many times that before it, from `first` on. */
export function ladder(last: number, first: number, factor = 2): number[] {
  const steps: number[] = [];
  for (let step = last; step > first; step = Math.ceil(step / factor)) steps.unshift(step);
  return steps.length === 0 ? [last] : steps[0] === first ? steps : [Math.min(first, last), ...steps];
}
