// What a worker does with a reader's JavaScript: it calls the function on each pair that comes, and sends the answer.
// The function stands alone, since its text is put before the reader's JavaScript.

export function answerPairs() {
  const own = /** @type {any} */ (self);
  const post = own.postMessage.bind(own);
  const shape = (/** @type {any} */ data) => (data.polygon ? data.polygon : data);
  const said = (/** @type {any} */ error) => (error?.name ? `${error.name}: ${error.message}` : String(error)).slice(0, 300);
  own.onmessage = (/** @type {any} */ { data }) => {
    /** @type {any} */
    let answer;
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
      text = JSON.stringify(answer);
    } catch {
      text = JSON.stringify({ problem: "error", line: "answers with something that is not JSON" });
    }
    post(text);
  };
  Promise.resolve().then(() => post(JSON.stringify({ why: typeof own.satvizCollide === "function" ? "" : "There is no function of two shapes: write function collide(a, b) { ... }" })));
}
