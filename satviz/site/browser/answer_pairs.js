// What a worker does with a reader's JavaScript: it calls the function on each pair that comes, and sends the answer.
// The function stands alone, since its text is put before the reader's JavaScript.

/**
 * @param {string} file The name of the reader's script.
 * @param {number} linesBefore The lines of ours before the reader's first one.
 */
export function answerPairs(file, linesBefore) {
  const maxPrinted = 2000;
  let printed = "";
  const own = /** @type {any} */ (self);
  const post = own.postMessage.bind(own);
  const shape = (/** @type {any} */ data) => (data.polygon ? data.polygon : data);
  const said = (/** @type {any} */ error) => {
    const line = Number(String(error?.stack ?? "").match(`${file}:(\\d+)`)?.[1]) - linesBefore;
    const place = line > 0 ? ` in line ${line}` : "";
    return (error?.name ? `${error.name}${place}: ${error.message}` : String(error)).slice(0, 300);
  };
  const inWords = (/** @type {unknown} */ value) => (typeof value === "string" ? value : (JSON.stringify(value) ?? String(value)));
  own.console.log = own.console.info = (/** @type {unknown[]} */ ...values) => {
    if (printed.length < maxPrinted) printed = `${printed}${values.map(inWords).join(" ")}\n`.slice(0, maxPrinted);
  };
  own.onmessage = (/** @type {any} */ { data }) => {
    /** @type {any} */
    let answer;
    printed = "";
    try {
      const a = shape(data.a);
      const b = shape(data.b);
      const before = JSON.stringify([a, b]);
      const value = own.satvizCollide(a, b);
      answer = { value: value === undefined ? null : value };
      if (typeof value === "number" && !Number.isFinite(value)) answer = { value: String(value) };
      if (JSON.stringify([a, b]) !== before) answer = { ...answer, problem: "wrote", line: "changes its arguments: the caller's shapes are not the same afterwards" };
    } catch (error) {
      answer = { problem: "error", line: `raises ${said(error)}` };
    }
    let text;
    try {
      text = JSON.stringify({ ...answer, printed });
    } catch {
      text = JSON.stringify({ problem: "error", line: "answers with something that is not JSON" });
    }
    post(text);
  };
  Promise.resolve().then(() => post(JSON.stringify({ printed, why: typeof own.satvizCollide === "function" ? "" : "There is no function of two shapes: write function collide(a, b) { ... }" })));
}
