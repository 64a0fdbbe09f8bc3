// What a worker does with a reader's JavaScript: it calls the function on each pair that comes, and sends the answer.
// The function stands alone, since its text is put before the reader's JavaScript.

/**
 * @param {(text: string) => void} post To the page; the reader's code must not have it.
 * @param {string} file The name of the reader's script.
 * @param {number} linesBefore The lines of ours before the reader's first one.
 */
/**
 * @param {(text: string) => void} post To the page; the reader's code must not have it.
 * @param {string} file The name of the reader's script.
 * @param {number} linesBefore The lines of ours before the reader's first one.
 */
export function answerPairs(post, file, linesBefore) {
  const maxPrinted = 2000;
  let printed = "";
  const own = /** @type {any} */ (self);
  const shape = (/** @type {any} */ data) => (data.polygon ? data.polygon : data);
  const tag = (/** @type {unknown} */ value) => Object.prototype.toString.call(value).slice("[object ".length, -1);
  const inWords = (/** @type {unknown} */ value) => {
    try {
      return typeof value === "string" ? value : (JSON.stringify(value) ?? String(value));
    } catch {
      return typeof value === "bigint" ? `${value}n` : tag(value); // cyclic, or of no JSON
    }
  };
  const said = (/** @type {any} */ error) => {
    const line = Number(String(error?.stack ?? "").match(`${file}:(\\d+)`)?.[1]) - linesBefore;
    const place = line > 0 ? ` in line ${line}` : "";
    return (error?.name ? `${error.name}${place}: ${error.message}` : String(error)).slice(0, 300);
  };
  /**
   * An answer as the check reads it: plain values, and as {text} what is none.
   * @param {any} value
   * @param {number} depth
   * @returns {unknown}
   */
  const plain = (value, depth) => {
    if (value === null || typeof value === "boolean" || typeof value === "string" || (typeof value === "number" && Number.isFinite(value))) return value;
    if (Array.isArray(value)) return value.length < 20 && depth ? value.map((each) => plain(each, depth - 1)) : { text: "a long or deep list" };
    if (typeof value !== "object") return { text: typeof value === "function" ? "a function" : typeof value === "number" ? String(value) : inWords(value) };
    const keys = ["x", "y", "hit", "mtv", "push", "move"].filter((key) => key in value);
    if (keys.length && depth) return Object.fromEntries(keys.map((key) => [key, plain(value[key], depth - 1)]));
    return { text: tag(value) === "Object" ? `{${Object.keys(value).slice(0, 9).join(", ")}}` : `a value of type ${tag(value)}` };
  };
  // The reader's code may have replaced what is used here; the last text uses nothing.
  const reply = (/** @type {() => object} */ found) => {
    let text = '{"problem":"error","line":"answers with something that cannot be sent"}';
    try {
      const made = JSON.stringify({ ...found(), printed });
      if (typeof made === "string") text = made;
    } catch {}
    post(text);
  };
  own.console.log = own.console.info = own.console.warn = own.console.error = own.console.debug = (/** @type {unknown[]} */ ...values) => {
    if (printed.length < maxPrinted) printed = `${printed}${values.map(inWords).join(" ")}\n`.slice(0, maxPrinted);
  };
  const ask = (/** @type {any} */ data) => {
    try {
      const [a, b] = [shape(data.a), shape(data.b)];
      const before = JSON.stringify([a, b]);
      const returned = own.satvizCollide(a, b);
      const value = returned === undefined ? null : plain(returned, 3);
      if (inWords([a, b]) === before) return { value };
      return { value, problem: "wrote", line: "changes its arguments: the caller's shapes are not the same afterwards" };
    } catch (error) {
      return { problem: "error", line: `raises ${said(error)}` };
    }
  };
  own.onmessage = (/** @type {any} */ { data }) => {
    printed = "";
    reply(() => ask(data));
  };
  const why = "There is no function of two shapes: write function collide(a, b) { ... }";
  Promise.resolve().then(() => reply(() => ({ why: typeof own.satvizCollide === "function" ? "" : why })));
}
