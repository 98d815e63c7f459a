using System;
using System.Threading;
using System.Threading.Tasks;

namespace Nowpose.Network
{
    /// <summary>One WebSocket connection to the gateway, whatever implements it. Opened once, then used from one sender and one receiver.</summary>
    interface IWebSocketLink : IDisposable
    {
        /// <exception cref="GatewayRefusalException">Certificate, token or protocol refused; says which.</exception>
        Task OpenAsync(CancellationToken cancel);

        Task SendAsync(string text, CancellationToken cancel);

        /// <summary>Hands over the messages, one after the other, each stamped where it arrives. Completes when the connection was closed in order.</summary>
        /// <param name="take">Called on the thread that received. An exception of it ends the connection.</param>
        Task ReceiveAsync(Action<ReceivedText> take, CancellationToken cancel);
    }
}
