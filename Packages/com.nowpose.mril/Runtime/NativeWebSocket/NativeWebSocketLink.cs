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
    /// <summary>
    /// WebSocket connection over the NativeWebSocket package: ws://, or wss:// with a certificate that the device's certificate store trusts.
    /// </summary>
    /// <remarks>
    /// Messages are stamped when the package reads them, not in the next frame. The package delivers whole messages, so this class cannot
    /// enforce all limits of the protocol: it does not count fragments, and it rejects a long message only after the whole message has arrived
    /// (a message that never ends is detected by the timeout for silence). A binary message is treated as text and rejected only if its text
    /// is invalid. The package does not send pings at the protocol's interval; the client calls the gateway's time service instead. This class
    /// cannot check a certificate pin.
    /// </remarks>
    sealed class NativeWebSocketLink : IWebSocketLink
    {
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
                throw new ArgumentException(ConnectionMessages.NoPinCheck(nameof(SystemWebSocketLink)), nameof(settings));
            _settings = settings;
            _clock = clock;
        }

        public async Task OpenAsync(CancellationToken cancel)
        {
            cancel.ThrowIfCancellationRequested();
            _socket = NewSocket();
            // The task completes when the connection ends. It never fails: the package raises failures as events.
            _ = _socket.Connect();
            // Dispose may have run before the socket existed, so it could not cancel the connection.
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
            // If the socket is not open, the package drops the message without an error.
            if (_socket.State != WebSocketState.Open) throw new IOException(_error);
            await _socket.SendText(text).OrCancelled(cancel).ConfigureAwait(false);
        }

        public async Task<string> ReceiveAsync(Action<ReceivedText> take, CancellationToken cancel)
        {
            while (await _arrived.NextAsync(cancel).ConfigureAwait(false) is { } received)
            {
                take(received);
                cancel.ThrowIfCancellationRequested();
            }
            // The package reports the code of the close, but not its reason.
            return null;
        }

        /// <summary>Closes the connection in the background: with a close handshake of at most one second, then by cancellation.</summary>
        public void Dispose()
        {
            // Ends the queue first. OpenAsync cancels the connection when it detects the disposal, and would otherwise end the queue with an error.
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
            SynchronizationContext.SetSynchronizationContext(new ImmediateContext());
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
            using (var timeout = new CancellationTokenSource(ProtocolLimits.CloseTimeout))
            {
                try
                {
                    await _socket.Close().OrCancelled(timeout.Token).ConfigureAwait(false);
                }
                catch (Exception)
                {
                    // The connection is cancelled below in any case.
                }
            }
            _socket.CancelConnection();
        }
    }
}
