// A file that came from the kernel, handed to the reader.
export function download({ name }, [data]) {
  const type = { svg: "image/svg+xml", png: "image/png", gif: "image/gif" }[name.split(".").pop()];
  const url = URL.createObjectURL(new Blob([data], { type }));
  element("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}
