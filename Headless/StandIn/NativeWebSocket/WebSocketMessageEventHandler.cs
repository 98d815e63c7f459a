namespace NativeWebSocket
{
    public delegate void WebSocketMessageEventHandler(byte[] data);
}
