namespace NativeWebSocket
{
    public delegate void WebSocketOpenEventHandler();
}
