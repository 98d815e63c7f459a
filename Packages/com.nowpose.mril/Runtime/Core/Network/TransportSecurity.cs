namespace Nowpose.Network
{
    /// <summary>How the connections to the gateway are protected.</summary>
    enum TransportSecurity
    {
        /// <summary>Not at all: loopback, or a network the user trusts and said so.</summary>
        Plain,

        /// <summary>TLS, the certificate trusted by the device's own store.</summary>
        DeviceTrust,

        /// <summary>TLS, the certificate trusted by the pin of its public key and nothing else.</summary>
        Pinned,
    }
}
