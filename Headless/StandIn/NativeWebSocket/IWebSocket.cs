using System.Threading.Tasks;

namespace NativeWebSocket
{
    public interface IWebSocket
    {
        event WebSocketOpenEventHandler OnOpen;
        event WebSocketMessageEventHandler OnMessage;
        event WebSocketErrorEventHandler OnError;
        event WebSocketCloseEventHandler OnClose;

        WebSocketState State { get; }

        Task Connect();
        Task Close(WebSocketCloseCode code = WebSocketCloseCode.Normal, string reason = null);
        Task Send(byte[] data);
        Task SendText(string message);
    }
}
