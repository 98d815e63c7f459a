using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using NativeWebSocket;
using Nowpose.Messages;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>A ws:// link, or a wss:// link with a certificate that the device's own store trusts, over the NativeWebSocket package.</summary>
    /// <remarks>
    /// Messages are stamped when that package reads them, not at the next frame. The package delivers whole messages, so some of
    /// the protocol's limits are not enforced: fragments are not counted, and a message must be complete before it is
    /// rejected for its length (one that never ends is detected as silence). A binary message is treated as text and is
    /// rejected only if it is not valid. The package sends no pings at the protocol's interval; the client calls the gateway's time
    /// service instead. This link cannot check a pin.
    /// </remarks>
    sealed class NativeWebSocketLink : IWebSocketLink
    {
        static readonly TimeSpan CloseTimeout = TimeSpan.FromSeconds(1);

        readonly ConnectionSettings _settings;
        readonly IHeadsetClock _clock;
        readonly ArrivedMessages _arrived = new ArrivedMessages();
        readonly TaskCompletionSource<bool> _opening = new TaskCompletionSource<bool>(TaskCreationOptions.RunContinuationsAsynchronously);
        volatile WebSocket _socket;
        volatile string _error = ConnectionMessages.Lost;
        volatile int _isDisposed;

        /// <exception cref="ArgumentException">The settings contain a pin.</exception>
        public NativeWebSocketLink(ConnectionSettings settings, IHeadsetClock clock)
        {
            if (settings.Security == TransportSecurity.Pinned)
                throw new ArgumentException(ConnectionMessages.NoPinCheck(nameof(PinnedWebSocketLink)), nameof(settings));
            _settings = settings;
            _clock = clock;
        }

        public async Task OpenAsync(CancellationToken cancel)
        {
            cancel.ThrowIfCancellationRequested();
            _socket = NewSocket();
            // Completes with the connection and never fails, because failures are raised as events.
            _ = _socket.Connect();
            // A disposal before the connection was started had nothing to cancel.
            if (_isDisposed != 0) _socket.CancelConnection();
            using (cancel.Register(Cancel)) await _opening.Task.ConfigureAwait(false);

            void Cancel()
            {
                _opening.TrySetCanceled(cancel);
                _socket.CancelConnection();
            }
        }

        public async Task SendAsync(string text, CancellationToken cancel)
        {
            // The package would drop the text silently.
            if (_socket.State != WebSocketState.Open) throw new IOException(_error);
            await _socket.SendText(text).OrCancelled(cancel).ConfigureAwait(false);
        }

        public async Task ReceiveAsync(Action<ReceivedText> take, CancellationToken cancel)
        {
            while (await _arrived.NextAsync(cancel).ConfigureAwait(false) is { } received)
            {
                take(received);
                cancel.ThrowIfCancellationRequested();
            }
        }

        /// <summary>Closes the connection in an orderly way, in the background and within a second.</summary>
        public void Dispose()
        {
            // First, because an opening that detects the disposal cancels, which would report another end.
            _arrived.End(null);
            if (Interlocked.Exchange(ref _isDisposed, 1) != 0) return;
            if (_socket != null) Task.Run(CloseAsync);
        }

        WebSocket NewSocket()
        {
            var headers = new Dictionary<string, string>();
            if (_settings.Token != null) headers.Add("Authorization", "Bearer " + _settings.Token);
            var socket = Make(_settings.WebSocketUri.ToString(), headers);
            socket.OnOpen += () => _opening.TrySetResult(true);
            socket.OnMessage += Arrive;
            socket.OnError += message => _error = message;
            socket.OnClose += End;
            return socket;
        }

        static WebSocket Make(string url, Dictionary<string, string> headers)
        {
            var before = SynchronizationContext.Current;
            SynchronizationContext.SetSynchronizationContext(new AtOnce());
            try
            {
                return new WebSocket(url, headers);
            }
            finally
            {
                SynchronizationContext.SetSynchronizationContext(before);
            }
        }

        void Arrive(byte[] data)
        {
            var arrival = _clock.Now;
            _arrived.Add(data.Length > ProtocolLimits.DescriptionBytes
                ? ReceivedText.Drop(DropReason.TooLarge, arrival)
                : ReceivedText.Message(data, arrival));
        }

        void End(WebSocketCloseCode code)
        {
            _opening.TrySetException(GatewayRefusalException.OfHandshake(_error));
            _arrived.End(code == WebSocketCloseCode.Abnormal ? new IOException(_error) : null);
        }

        async Task CloseAsync()
        {
            using (var timeout = new CancellationTokenSource(CloseTimeout))
            {
                try
                {
                    await _socket.Close().OrCancelled(timeout.Token).ConfigureAwait(false);
                }
                catch (Exception)
                {
                    // The connection is closed in any case.
                }
            }
            _socket.CancelConnection();
        }
    }
}
