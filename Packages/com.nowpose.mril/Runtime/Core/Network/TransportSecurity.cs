namespace Nowpose.Network
{
    /// <summary>Security of the connections to the gateway.</summary>
    enum TransportSecurity
    {
        /// <summary>No encryption: loopback, or a network that the user declared as trusted.</summary>
        Plain,

        /// <summary>TLS with a certificate that the device's own store trusts.</summary>
        DeviceTrust,

        /// <summary>TLS with a certificate that matches the pin of its public key; no other is trusted.</summary>
        Pinned,
    }
}
