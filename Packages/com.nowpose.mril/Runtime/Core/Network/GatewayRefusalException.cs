using System;
using System.IO;

namespace Nowpose.Network
{
    /// <summary>The connection failed for a reason that a user can act on: a certificate, a token, a protocol. The message is one line.</summary>
    sealed class GatewayRefusalException : IOException
    {
        public GatewayRefusalException(string message) : base(message) { }
        public GatewayRefusalException(string message, Exception innerException) : base(message, innerException) { }

        /// <summary>Whether it was the headset's token that the gateway did not accept, or that it has none.</summary>
        public bool IsOfToken { get; private set; }

        /// <summary>Of what a gateway answered the WebSocket request with.</summary>
        internal static GatewayRefusalException OfStatus(int status, Exception innerException = null) =>
            new GatewayRefusalException(WebSocketUpgrade.RefusalOf(status), innerException) { IsOfToken = status == 401 };

        internal static GatewayRefusalException OfToken(string message) => new GatewayRefusalException(message) { IsOfToken = true };

        /// <summary>Of a WebSocket that was not opened, in the words of .NET's client, which tells the status code in them only.</summary>
        internal static GatewayRefusalException OfHandshake(string message, Exception innerException = null)
        {
            // Between quotation marks: a port may be 40111 as well.
            foreach (var status in new[] { 401, 403 })
                if (message.Contains("'" + status + "'")) return OfStatus(status, innerException);
            return new GatewayRefusalException(message, innerException);
        }
    }
}
