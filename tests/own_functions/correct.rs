use std::io::{BufRead, Write};

type Polygon = Vec<(f64, f64)>;

fn points(text: &str) -> Polygon {
    let number = |c: char| c.is_ascii_digit() || "-+.eE".contains(c);
    let text: String = text.chars().map(|c| if number(c) { c } else { ' ' }).collect();
    let numbers: Vec<f64> = text.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    numbers.chunks(2).map(|pair| (pair[0], pair[1])).collect()
}

fn collide(a: &Polygon, b: &Polygon) -> bool {
    for poly in [a, b] {
        for i in 0..poly.len() {
            let (p, q) = (poly[i], poly[(i + 1) % poly.len()]);
            let n = (q.1 - p.1, p.0 - q.0);
            let range = |shape: &Polygon| {
                let on = shape.iter().map(|r| r.0 * n.0 + r.1 * n.1);
                on.fold((f64::MAX, f64::MIN), |(lo, hi), at| (lo.min(at), hi.max(at)))
            };
            let ((lo, hi), (low, high)) = (range(a), range(b));
            if hi < low || high < lo {
                return false;
            }
        }
    }
    true
}

fn main() {
    let mut out = std::io::stdout();
    for line in std::io::stdin().lock().lines() {
        let line = line.unwrap();
        let middle = line.find("\"b\"").unwrap();
        writeln!(out, "{}", collide(&points(&line[4..middle]), &points(&line[middle + 3..]))).unwrap();
        out.flush().unwrap();
    }
}
