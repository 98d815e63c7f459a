using System;
using System.Threading;
using System.Threading.Tasks;

namespace Nowpose.Network
{
    /// <summary>One WebSocket connection to the gateway, whatever implements it. Opened once, then used from one sender and one receiver.</summary>
    public interface IWebSocketLink : IDisposable
    {
        /// <exception cref="GatewayRefusalException">Certificate, token or protocol refused; says which.</exception>
        Task OpenAsync(CancellationToken cancel);

        Task SendAsync(string text, CancellationToken cancel);

        /// <summary>The next message, stamped where it arrives.</summary>
        Task<ReceivedText> ReceiveAsync(CancellationToken cancel);
    }
}
