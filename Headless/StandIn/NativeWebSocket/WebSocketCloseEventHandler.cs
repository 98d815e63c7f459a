namespace NativeWebSocket
{
    public delegate void WebSocketCloseEventHandler(WebSocketCloseCode closeCode);
}
