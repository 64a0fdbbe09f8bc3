// The programs with a mistake of chapter 8, in JavaScript: each function is named as in the chapter.  The page
// "Is yours right?" gives a program with all that it uses.

export function normals(shape) {
  return shape.map(([x0, y0], i) => {
    const [x1, y1] = shape[(i + 1) % shape.length];
    return [y1 - y0, x0 - x1];
  });
}

export function span(shape, n) {
  const onAxis = shape.map(([x, y]) => x * n[0] + y * n[1]);
  return [Math.min(...onAxis), Math.max(...onAxis)];
}

export function middle(shape) {
  const mean = (k) => shape.reduce((sum, p) => sum + p[k], 0) / shape.length;
  return [mean(0), mean(1)];
}

export function unitNormals(shape) {
  return normals(shape).map(([x, y]) => [x / Math.hypot(x, y), y / Math.hypot(x, y)]);
}

export function someNormals(shape) {
  const found = [];
  for (let i = 0; i + 1 < shape.length; i++) {
    const [x0, y0] = shape[i], [x1, y1] = shape[i + 1];
    found.push([y1 - y0, x0 - x1]);
  }
  return found;
}

export function collide_1(a, b) {
  for (const n of [...someNormals(a), ...someNormals(b)]) {
    const [a0, a1] = span(a, n), [b0, b1] = span(b, n);
    if (a1 < b0 || b1 < a0) return false;
  }
  return true;
}

export function collide_2(a, b) {
  for (const n of [...normals(a), ...normals(b)]) {
    const [a0, a1] = span(a, n), [b0, b1] = span(b, n);
    if (a0 <= b1 && b0 <= a1) return true;
  }
  return false;
}

export function collide_3(a, b) {
  const [ax, ay] = middle(a), [bx, by] = middle(b);
  if (Math.hypot(bx - ax, by - ay) > 5) return false; // too far away
  for (const n of [...normals(a), ...normals(b)]) {
    const [a0, a1] = span(a, n), [b0, b1] = span(b, n);
    if (a1 < b0 || b1 < a0) return false;
  }
  return true;
}

export function way_out(a, b) {
  let best = Infinity, move = null;
  for (const n of [...normals(a), ...normals(b)]) {
    const [a0, a1] = span(a, n), [b0, b1] = span(b, n);
    if (a1 <= b0 || b1 <= a0) return null;
    const forward = a1 - b0, back = b1 - a0;
    const [depth, sign] = forward < back ? [forward, 1] : [back, -1];
    if (depth < best) {
      best = depth;
      move = [sign * depth * n[0], sign * depth * n[1]];
    }
  }
  return move;
}

export function away_from_middle(a, b) {
  let best = Infinity, move = null;
  const [ax, ay] = middle(a), [bx, by] = middle(b);
  for (const n of [...unitNormals(a), ...unitNormals(b)]) {
    const [a0, a1] = span(a, n), [b0, b1] = span(b, n);
    if (a1 <= b0 || b1 <= a0) return null;
    const depth = Math.min(a1 - b0, b1 - a0);
    const sign = (bx - ax) * n[0] + (by - ay) * n[1] > 0 ? 1 : -1;
    if (depth < best) {
      best = depth;
      move = [sign * depth * n[0], sign * depth * n[1]];
    }
  }
  return move;
}
