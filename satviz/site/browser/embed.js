// The first script of the explorer's page: in a frame it has no menu and no title from the first paint on.

{
  const query = new URLSearchParams(location.search);
  if (query.has("embed")) {
    const { classList, dataset } = document.body;
    classList.add("embed");
    for (const part of query.get("show")?.split(",") ?? []) if (part === "tools" || part === "table") classList.add(`shows-${part}`);
    const theme = query.get("theme");
    if (theme === "light" || theme === "dark") dataset.theme = theme;
  }
}
