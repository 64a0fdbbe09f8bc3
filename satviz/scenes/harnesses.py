"""The smallest program around a collision function in another language, for `satviz check --command`."""

from typing import NamedTuple


class Harness(NamedTuple):
    """A harness: it reads pairs of polygons, a line of JSON each, calls `collide`, and writes one answer a line.

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
#include <sstream>
#include <string>
#include <vector>
struct Point { double x, y; };
using Polygon = std::vector<Point>;
bool collide(const Polygon &a, const Polygon &b);

Polygon points(std::string text) {
  for (char &c : text)
    if (!std::isdigit(c) && c != '-' && c != '.' && c != 'e' && c != '+') c = ' ';
  std::istringstream numbers(text);
  Polygon found;
  for (Point p; numbers >> p.x >> p.y;) found.push_back(p);
  return found;
}

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    auto middle = line.find("\"b\"");
    bool hit = collide(points(line.substr(4, middle - 4)), points(line.substr(middle + 3)));
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

fn points(text: &str) -> Vec<(f64, f64)> {
    let text = text.replace(|c: char| !c.is_ascii_digit() && !"-+.eE".contains(c), " ");
    let numbers: Vec<f64> = text.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    numbers.chunks(2).map(|pair| (pair[0], pair[1])).collect()
}

fn main() {
    for line in std::io::stdin().lock().lines().map(Result::unwrap) {
        let middle = line.find("\"b\"").unwrap();
        println!("{}", collide(&points(&line[4..middle]), &points(&line[middle + 3..])));
        std::io::stdout().flush().unwrap();
    }
}
""",
    ),
)
