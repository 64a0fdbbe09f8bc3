// Circles without a square root, and with the comparison the wrong way round.
class Ball {
  constructor({ circle: [x, y], radius }) {
    Object.assign(this, { x, y, r: radius });
  }
  touches(other) {
    const dx = this.x - other.x, dy = this.y - other.y, reach = this.r + other.r;
    return reach * reach <= dx * dx + dy * dy;
  }
}
function collide(a, b) {
  return new Ball(a).touches(new Ball(b));
}
