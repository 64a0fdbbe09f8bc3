"""The smallest program around a collision function in another language, for `satviz check --command`."""

from typing import NamedTuple


class Harness(NamedTuple):
    """A harness: it reads pairs of polygons or circles, a line of JSON each, calls `collide`, and writes an answer.

    `file`: the file that `collide` and `code` are in; `build`: the command that compiles it, "" where none does;
    `run`: the command that `satviz check --command` is given.
    """

    language: str
    file: str
    build: str
    run: str
    code: str


HARNESSES = (
    Harness(
        "JavaScript",
        "mine.js",
        "",
        "node mine.js",
        r"""require("node:readline").createInterface({ input: process.stdin }).on("line", (line) => {
  const { a, b } = JSON.parse(line);
  console.log(JSON.stringify(collide(a, b)));
});
""",
    ),
    Harness(
        "C++",
        "mine.cpp",
        "g++ -std=c++17 -O2 -o mine mine.cpp",
        "./mine",
        r"""#include <cctype>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>
struct Point { double x, y; };
struct Shape {
  std::vector<Point> points;  // the corners, or the center of a circle
  double radius = 0;          // of a circle
};
bool collide(const Shape &a, const Shape &b);

Shape shape(std::string text) {
  char before = ' ';
  for (char &c : text) {
    bool in_number = std::isdigit(c) || c == '-' || c == '.' || c == '+' || (c == 'e' && std::isdigit(before));
    before = c;
    if (!in_number) c = ' ';
  }
  std::istringstream stream(text);
  std::vector<double> numbers{std::istream_iterator<double>(stream), {}};
  Shape found;
  for (std::size_t i = 1; i < numbers.size(); i += 2) found.points.push_back({numbers[i - 1], numbers[i]});
  if (numbers.size() % 2) found.radius = numbers.back();
  return found;
}

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    auto middle = line.find("\"b\"");
    bool hit = collide(shape(line.substr(4, middle - 4)), shape(line.substr(middle + 3)));
    std::cout << (hit ? "true" : "false") << std::endl;  // endl flushes the line
  }
}
""",
    ),
    Harness(
        "Rust",
        "mine.rs",
        "rustc -O -o mine mine.rs",
        "./mine",
        r"""use std::io::{BufRead, Write};

struct Shape {
    points: Vec<(f64, f64)>, // the corners, or the center of a circle
    radius: f64,             // of a circle, else 0
}

fn shape(text: &str) -> Shape {
    let text = text.replace(|c: char| !c.is_ascii_digit() && !"-+.eE".contains(c), " ");
    let numbers: Vec<f64> = text.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    let pairs = numbers.chunks_exact(2);
    let radius = pairs.remainder().first().copied().unwrap_or(0.0);
    Shape { points: pairs.map(|pair| (pair[0], pair[1])).collect(), radius }
}

fn main() {
    for line in std::io::stdin().lock().lines().map(Result::unwrap) {
        let middle = line.find("\"b\"").unwrap();
        println!("{}", collide(&shape(&line[4..middle]), &shape(&line[middle + 3..])));
        std::io::stdout().flush().unwrap();
    }
}
""",
    ),
)
