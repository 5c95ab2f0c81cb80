// Put a player as wide as its column below every text or cell with a link to a sound.
for (const link of document.querySelectorAll('a[href$=".flac"]')) {
  const column = link.closest("td, p, li");
  if (column.querySelectorAll('a[href$=".flac"]').length > 1) {
    const label = document.createElement("small");
    label.style = "display: block; margin-top: 0.5em";
    label.textContent = link.textContent;
    column.append(label);
  }
  const player = document.createElement("audio");
  player.controls = true;
  player.preload = "metadata";
  player.src = link.href;
  player.setAttribute("aria-label", link.textContent);
  player.style = "display: block; width: 100%; min-width: 15em; height: 2.5em; margin-top: 0.25em";
  column.append(player);
}
