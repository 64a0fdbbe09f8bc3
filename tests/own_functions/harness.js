require("node:readline").createInterface({ input: process.stdin }).on("line", (line) => {
  const { a, b } = JSON.parse(line);
  console.log(JSON.stringify(collide(a, b)));
});
