using System.Net.WebSockets;
using System.Text;
using SystemState = System.Net.WebSockets.WebSocketState;

namespace NativeWebSocket
{
    /// <summary>
    /// Behaves like the class of the package NativeWebSocket. The constructor stores the current synchronisation context and posts events to it;
    /// without a context, events wait for <see cref="DispatchMessageQueue"/>. The task of <see cref="Connect"/> completes when the connection ends,
    /// and never fails. Text and binary messages are not distinguished, arrive as a whole and have no size limit. A message that is sent while the
    /// socket is not open is lost without an error.
    /// </summary>
    public class WebSocket
    {
        readonly Uri _uri;
        readonly List<string> _subprotocols;
        readonly Dictionary<string, string> _headers;
        readonly EventPump _events = new EventPump();
        readonly SemaphoreSlim _sending = new SemaphoreSlim(1);
        ClientWebSocket _client;
        CancellationTokenSource _cancel;

        public WebSocket(string url, Dictionary<string, string> headers = null) : this(url, new List<string>(), headers) { }

        public WebSocket(string url, string subprotocol, Dictionary<string, string> headers = null)
            : this(url, new List<string> { subprotocol }, headers) { }

        public WebSocket(string url, List<string> subprotocols, Dictionary<string, string> headers = null)
        {
            _uri = new Uri(url);
            if (_uri.Scheme != "ws" && _uri.Scheme != "wss") throw new ArgumentException("unsupported scheme " + _uri.Scheme, nameof(url));
            _subprotocols = subprotocols ?? new List<string>();
            _headers = headers ?? new Dictionary<string, string>();
        }

        public event WebSocketOpenEventHandler OnOpen;
        public event WebSocketMessageEventHandler OnMessage;
        public event WebSocketErrorEventHandler OnError;
        public event WebSocketCloseEventHandler OnClose;

        public WebSocketState State
        {
            get
            {
                switch (_client?.State)
                {
                    case SystemState.Connecting: return WebSocketState.Connecting;
                    case SystemState.Open: return WebSocketState.Open;
                    case SystemState.CloseSent:
                    case SystemState.CloseReceived: return WebSocketState.Closing;
                    default: return WebSocketState.Closed;
                }
            }
        }

        public async Task Connect()
        {
            _cancel = new CancellationTokenSource();
            _client = new ClientWebSocket();
            try
            {
                foreach (var header in _headers) _client.Options.SetRequestHeader(header.Key, header.Value);
                foreach (var subprotocol in _subprotocols) _client.Options.AddSubProtocol(subprotocol);
                await _client.ConnectAsync(_uri, _cancel.Token).ConfigureAwait(false);
                _events.Raise(() => OnOpen?.Invoke());
                await Receive().ConfigureAwait(false);
            }
            catch (Exception failure)
            {
                _events.Raise(() => OnError?.Invoke(failure.Message));
                _events.Raise(() => OnClose?.Invoke(WebSocketCloseCode.Abnormal));
            }
            finally
            {
                _cancel.Cancel();
                _client.Dispose();
            }
        }

        /// <summary>Receives until the connection ends. Reports a failure as an abnormal closure instead of throwing an exception.</summary>
        public async Task Receive()
        {
            var code = WebSocketCloseCode.Abnormal;
            try
            {
                byte[] message;
                while ((message = await NextAsync().ConfigureAwait(false)) != null)
                {
                    var data = message;
                    _events.Raise(() => OnMessage?.Invoke(data));
                }
                var status = (int)(_client.CloseStatus ?? WebSocketCloseStatus.Empty);
                await Close().ConfigureAwait(false);
                code = Enum.IsDefined(typeof(WebSocketCloseCode), status) ? (WebSocketCloseCode)status : WebSocketCloseCode.Undefined;
            }
            catch (Exception)
            {
                _cancel.Cancel();
            }
            _events.Raise(() => OnClose?.Invoke(code));
        }

        public void DispatchMessageQueue() => _events.Dispatch();

        public void CancelConnection() => _cancel?.Cancel();

        public Task Send(byte[] data) => SendAsync(data, WebSocketMessageType.Binary);

        public Task SendText(string message) => SendAsync(Encoding.UTF8.GetBytes(message), WebSocketMessageType.Text);

        public async Task Close(WebSocketCloseCode code = WebSocketCloseCode.Normal, string reason = null)
        {
            if (State == WebSocketState.Open)
                await _client.CloseAsync((WebSocketCloseStatus)(int)code, reason ?? "", CancellationToken.None).ConfigureAwait(false);
        }

        // Returns the next message; null if the other side has closed the connection.
        async Task<byte[]> NextAsync()
        {
            var chunk = new ArraySegment<byte>(new byte[65536]);
            using (var message = new MemoryStream())
            {
                while (true)
                {
                    var piece = await _client.ReceiveAsync(chunk, _cancel.Token).ConfigureAwait(false);
                    if (piece.MessageType == WebSocketMessageType.Close) return null;
                    message.Write(chunk.Array, 0, piece.Count);
                    if (piece.EndOfMessage) return message.ToArray();
                }
            }
        }

        async Task SendAsync(byte[] bytes, WebSocketMessageType type)
        {
            if (bytes.Length == 0 || State != WebSocketState.Open) return;
            await _sending.WaitAsync(_cancel.Token).ConfigureAwait(false);
            try
            {
                await _client.SendAsync(new ArraySegment<byte>(bytes), type, true, _cancel.Token).ConfigureAwait(false);
            }
            finally
            {
                _sending.Release();
            }
        }
    }
}
