// Reads {"a": [[x, y], ...], "b": [[x, y], ...]} line by line: the numbers before and after "b".
#include <cmath>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>
struct Point { double x, y; };
using Polygon = std::vector<Point>;

Polygon points(std::string text) {
  for (char &c : text)
    if (!std::isdigit(c) && c != '-' && c != '.' && c != 'e' && c != '+') c = ' ';
  std::istringstream numbers(text);
  Polygon found;
  for (Point p; numbers >> p.x >> p.y;) found.push_back(p);
  return found;
}

std::string answer(const Polygon &a, const Polygon &b);

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    auto middle = line.find("\"b\"");
    std::cout << answer(points(line.substr(4, middle - 4)), points(line.substr(middle + 3))) << std::endl;
  }
}
