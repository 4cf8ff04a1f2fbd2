// The table of the class: sorted by a click on a heading, and filtered by what is typed. Without this script all of it is still there.
(() => {
  const table = document.querySelector('table.overview');
  if (!table) return;
  const body = table.tBodies[0];
  const rows = [...body.rows];
  const order = new Intl.Collator(undefined, { numeric: true, sensitivity: 'base' });
  const value = (row, column) => row.cells[column].dataset.value ?? row.cells[column].textContent;
  [...table.tHead.rows[0].cells].forEach((heading, column) => {
    const button = document.createElement('button');
    button.append(...heading.childNodes);
    heading.append(button);
    button.addEventListener('click', () => {
      // Points begin with the fewest: these are to be looked at.
      const down = heading.getAttribute('aria-sort') === 'ascending';
      for (const other of table.tHead.rows[0].cells) other.removeAttribute('aria-sort');
      heading.setAttribute('aria-sort', down ? 'descending' : 'ascending');
      const sorted = [...rows].sort((one, other) => order.compare(value(one, column), value(other, column)));
      body.append(...(down ? sorted.reverse() : sorted));
    });
  });
  const filter = document.createElement('input');
  const count = document.createElement('span');
  filter.type = 'search';
  filter.placeholder = 'Show rows with …';
  filter.setAttribute('aria-label', 'Show only rows that contain this text');
  filter.addEventListener('input', () => {
    const wanted = filter.value.trim().toLowerCase();
    let shown = 0;
    for (const row of rows) {
      row.hidden = !row.textContent.toLowerCase().includes(wanted);
      shown += !row.hidden;
    }
    count.textContent = wanted ? `${shown} of ${rows.length}` : '';
  });
  const bar = document.createElement('p');
  bar.className = 'filter';
  bar.append(filter, ' ', count);
  table.parentElement.before(bar);
})();
