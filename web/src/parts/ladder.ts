// Long computations run in stages, each complete, so that results are visible early and remain if the computation is stopped.

/** Numbers up to the last one, each `factor` times the one before it, from `first` on. */
export function ladder(last: number, first: number, factor = 2): number[] {
  const steps: number[] = [];
  for (let step = last; step > first; step = Math.ceil(step / factor)) steps.unshift(step);
  return steps.length === 0 ? [last] : steps[0] === first ? steps : [Math.min(first, last), ...steps];
}
