// Content that is wider than the page scrolls separately, and can be reached by the keyboard while it does.

/** The observer of sizes, from which follows which elements scroll. */
const observer = new ResizeObserver((entries) => {
  for (const { target } of entries) {
    const scrolls = target.scrollWidth > target.clientWidth + 1;
    if (scrolls) target.setAttribute("tabindex", "0");
    else target.removeAttribute("tabindex");
  }
});

/** Lets the keyboard reach these elements while they scroll. */
export function scrolling<T extends Element>(...elements: T[]): void {
  for (const element of elements) observer.observe(element);
}
