// Put a player after every link to a sound.
for (const link of document.querySelectorAll('a[href$=".flac"]')) {
  const player = document.createElement("audio");
  player.controls = true;
  player.preload = "metadata";
  player.src = link.href;
  player.style = "height: 2em; width: 15em; max-width: 100%; margin: 0 0.5em; vertical-align: middle";
  link.after(player);
}
