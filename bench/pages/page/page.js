"use strict";
// Tables are sorted by a click on a column's name; rows without a value come last either way.
for (const table of document.querySelectorAll("table.sortable")) {
  const heads = [...table.querySelectorAll("th")];
  heads.forEach((head, column) => head.addEventListener("click", () => {
    const down = head.getAttribute("aria-sort") === "ascending";
    heads.forEach((other) => other.removeAttribute("aria-sort"));
    head.setAttribute("aria-sort", down ? "descending" : "ascending");
    const key = (row) => {
      const cell = row.cells[column];
      const exact = cell.dataset.value;
      const text = exact === undefined ? cell.textContent.trim() : exact;
      const number = text === "" ? NaN : Number.parseFloat(text);
      return { text, number, missing: text === "" || (exact !== undefined && Number.isNaN(number)) };
    };
    const body = table.tBodies[0];
    const rows = [...body.rows].map((row) => ({ row, key: key(row) }));
    const numeric = rows.every(({ key }) => key.missing || !Number.isNaN(key.number));
    rows.sort((a, b) => {
      if (a.key.missing || b.key.missing) return a.key.missing - b.key.missing;
      const order = numeric ? a.key.number - b.key.number : a.key.text.localeCompare(b.key.text, "en");
      return down ? -order : order;
    });
    body.append(...rows.map(({ row }) => row));
  }));
}
