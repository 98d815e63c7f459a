namespace NativeWebSocket
{
    public delegate void WebSocketErrorEventHandler(string errorMsg);
}
