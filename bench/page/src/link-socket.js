// The session runs on this machine, behind the server that sent this page.
function openLink({ onOpen, onText, onPicture, onClose }) {
  let socket;
  const connect = () => {
    socket = new WebSocket(`ws://${location.host}/live`);
    socket.binaryType = "blob";
    socket.onopen = () => onOpen();
    socket.onmessage = event => typeof event.data === "string" ? onText(event.data) : onPicture(event.data);
    socket.onclose = () => { onClose(); setTimeout(connect, 700); };
  };
  // Whoever is called is defined by then.
  setTimeout(connect);
  return {
    send(text) { if (socket?.readyState === WebSocket.OPEN) socket.send(text); },
    async ask(path) {
      const answer = await fetch("/" + path);
      if (!answer.ok) throw new Error(await answer.text());
      return answer.blob();
    },
  };
}
