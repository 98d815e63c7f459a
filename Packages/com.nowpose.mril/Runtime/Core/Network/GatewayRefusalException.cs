using System;
using System.IO;

namespace Nowpose.Network
{
    /// <summary>The connection failed for a reason that a user can act on: a certificate, a token, a protocol. The message is one line.</summary>
    public sealed class GatewayRefusalException : IOException
    {
        public GatewayRefusalException(string message) : base(message) { }
        public GatewayRefusalException(string message, Exception innerException) : base(message, innerException) { }
    }
}
