// Markup in results, rebuilt piece by piece from a list of allowed elements and attributes: nothing else reaches the page.

const HTML = "a abbr article br caption code dd details div dl dt em figure figcaption h1 h2 h3 h4 hr li ol p pre section span strong sub summary sup table tbody td th thead tr ul";
const MATH = "math maction menclose mfrac mi mn mo mover mpadded mphantom mroot mrow ms mspace msqrt mstyle msub msubsup msup mtable mtd mtext mtr munder munderover";
const SVG = "svg g path rect circle line polyline polygon text tspan title desc";
const ELEMENTS = new Set(`${HTML} ${MATH} ${SVG}`.split(" "));

const ATTRIBUTES = new Set(
  ("class id scope colspan rowspan open display mathvariant stretchy form lspace rspace largeop symmetric minsize maxsize width height depth " +
    "columnalign rowspacing columnspacing displaystyle scriptlevel accent accentunder linethickness notation " +
    "viewBox role d x y dy x1 x2 y1 y2 cx cy r points fill stroke stroke-width stroke-linejoin stroke-linecap stroke-dasharray stroke-opacity fill-opacity opacity " +
    "font-size font-family font-style font-weight text-anchor dominant-baseline transform").split(" "),
);

/** The nodes of a piece of HTML or MathML that are on the list; others are left out with all their content. */
export function fromHtml(source: string): Node[] {
  return rebuilt(new DOMParser().parseFromString(withoutStyle(source), "text/html").body);
}

/** A picture, with its own style sheet as text. */
export function fromSvg(source: string): { svg: SVGSVGElement; style: string } | undefined {
  const read = new DOMParser().parseFromString(withoutStyle(source), "image/svg+xml");
  const [svg] = read.documentElement.localName === "svg" ? rebuiltNode(read.documentElement) : [];
  if (!(svg instanceof SVGSVGElement)) return undefined;
  return { svg, style: styleOf(source) };
}

/** The first style sheet of a picture, as text. */
export function styleOf(source: string): string {
  return STYLE.exec(source)?.[1] ?? "";
}

const STYLE = /<style[^>]*>([^]*?)<\/style>/;

// A style sheet is checked against the policy of the page when it is parsed, even if it is never shown.
function withoutStyle(source: string): string {
  return source.replaceAll(new RegExp(STYLE, "g"), "");
}

function rebuilt(parent: Node): Node[] {
  return Array.from(parent.childNodes).flatMap(rebuiltNode);
}

function rebuiltNode(node: Node): Node[] {
  if (node instanceof Text) return [document.createTextNode(node.data)];
  if (!(node instanceof Element)) return [];
  // The page has its own `main`.
  if (node.localName === "main") return rebuilt(node);
  if (!ELEMENTS.has(node.localName)) return [];
  const made = document.createElementNS(node.namespaceURI, node.localName);
  for (const { name, value } of Array.from(node.attributes)) {
    // A link leads only to an element of the same page.
    if (ATTRIBUTES.has(name) || (name === "href" && value.startsWith("#"))) made.setAttribute(name, value);
  }
  made.append(...rebuilt(node));
  return [made];
}
