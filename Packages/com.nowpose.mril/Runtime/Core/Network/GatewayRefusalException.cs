using System;
using System.IO;

namespace Nowpose.Network
{
    /// <summary>A connection failure that a user can resolve: certificate, token or protocol. The message is one line.</summary>
    sealed class GatewayRefusalException : IOException
    {
        public GatewayRefusalException(string message) : base(message) { }
        public GatewayRefusalException(string message, Exception innerException) : base(message, innerException) { }

        /// <summary>Whether the gateway rejected the headset's token, or the headset has no token.</summary>
        public bool IsOfToken { get; private set; }

        /// <summary>Creates an exception from the HTTP status code of the response to the WebSocket upgrade request.</summary>
        internal static GatewayRefusalException OfStatus(int status) =>
            new GatewayRefusalException(WebSocketUpgrade.RefusalOf(status)) { IsOfToken = status == 401 };

        internal static GatewayRefusalException OfToken(string message) => new GatewayRefusalException(message) { IsOfToken = true };

        /// <summary>Creates an exception from a failed handshake of a client that reports the status code only in its message, as .NET's client does.</summary>
        internal static GatewayRefusalException OfHandshake(string message)
        {
            // Searches for the code in quotation marks, because a port number such as 40111 also contains it.
            foreach (var status in new[] { 401, 403, 503 })
                if (message.Contains("'" + status + "'")) return OfStatus(status);
            return new GatewayRefusalException(message);
        }
    }
}
