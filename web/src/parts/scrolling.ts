// What is wider than the page scrolls by itself, and is reached by the keyboard as long as it does.

/** Whether an element scrolls is told when its size or that of the page changes. */
const observer = new ResizeObserver((entries) => {
  for (const { target } of entries) {
    const scrolls = target.scrollWidth > target.clientWidth + 1;
    if (scrolls) target.setAttribute("tabindex", "0");
    else target.removeAttribute("tabindex");
  }
});

/** Lets the keyboard reach these elements where they scroll. */
export function scrolling<T extends Element>(...elements: T[]): void {
  for (const element of elements) observer.observe(element);
}
