// Put a player after every link to a sound.
for (const link of document.querySelectorAll('a[href$=".flac"]')) {
  const player = document.createElement("audio");
  player.controls = true;
  player.preload = "metadata";
  player.src = link.href;
  player.style.display = "block";
  player.style.maxWidth = "100%";
  link.after(player);
}
