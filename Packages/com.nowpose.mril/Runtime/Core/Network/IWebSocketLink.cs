using System;
using System.Threading;
using System.Threading.Tasks;

namespace Nowpose.Network
{
    /// <summary>One WebSocket connection to the gateway. Opened once, then used by one sender and one receiver.</summary>
    interface IWebSocketLink : IDisposable
    {
        /// <exception cref="GatewayRefusalException">The certificate, token or protocol was rejected, as stated in the message.</exception>
        Task OpenAsync(CancellationToken cancel);

        Task SendAsync(string text, CancellationToken cancel);

        /// <summary>Passes each received message with its arrival time to a callback, in order. Completes after an orderly close.</summary>
        /// <param name="take">Callback on the receiving thread. Its exceptions end the connection.</param>
        /// <returns>The server's reason for the close; null or empty if the link does not know it.</returns>
        Task<string> ReceiveAsync(Action<ReceivedText> take, CancellationToken cancel);
    }

    /// <summary>Creates the WebSocket link for the connection settings.</summary>
    static class WebSocketLinks
    {
        public static IWebSocketLink Create(ConnectionSettings settings, IHeadsetClock clock) => new SystemWebSocketLink(settings, clock);
    }
}
