using System;
using System.Net;
using Nowpose.Messages;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>Source of the control time.</summary>
    public enum ControlClockSource
    {
        /// <summary>The gateway's clock sync, over a separate TCP connection.</summary>
        ClockSync,

        /// <summary>The service /rosapi/get_time of a rosbridge server, without a gateway. Uses the WebSocket of the joint positions.</summary>
        RosTime,
    }

    /// <summary>Security of the connections to the gateway.</summary>
    enum TransportSecurity
    {
        /// <summary>No encryption: loopback, or a network that the user declared as trusted.</summary>
        Plain,

        /// <summary>TLS with a certificate that the device's certificate store trusts.</summary>
        DeviceTrust,

        /// <summary>TLS with a certificate that matches the pin of its public key; no other key is trusted.</summary>
        Pinned,
    }

    /// <summary>Address of the gateway and the transport to it. Immutable; checked in the constructor.</summary>
    public sealed class ConnectionSettings
    {
        /// <param name="host">Name or address of the gateway.</param>
        /// <param name="syncPort">TCP port of the clock sync.</param>
        /// <param name="webSocketPort">Port of the WebSocket that carries the joint positions.</param>
        /// <param name="pin">The gateway's public key. If given, connections use wss and TLS, and trust only this key.</param>
        /// <param name="deviceTrust">Whether to use wss and TLS with the device's certificate store; ignored if there is a pin.</param>
        /// <param name="token">
        /// Token that authenticates this headset to the gateway; null if it has none. It is sent only over TLS or loopback.
        /// </param>
        /// <param name="insecureLan">Whether plain connections beyond loopback are allowed; the status then shows a warning.</param>
        /// <param name="headsetName">Name of this headset in its diagnostics.</param>
        /// <param name="publishesDisplayed">Whether the displayed joints are published to the gateway, for external observers.</param>
        /// <param name="clockSource">Source of the control time; with ROS time the sync port is not used.</param>
        /// <exception cref="InputException">A value is out of range, or the connection would be unencrypted without permission.</exception>
        public ConnectionSettings(
            string host, int syncPort = ProtocolLimits.SyncPort, int webSocketPort = ProtocolLimits.WebSocketPort,
            CertificatePin pin = null, bool deviceTrust = false, string token = null, bool insecureLan = false,
            string headsetName = "headset", bool publishesDisplayed = true, ControlClockSource clockSource = ControlClockSource.ClockSync)
        {
            if (Uri.CheckHostName(host) == UriHostNameType.Unknown)
                throw new InputException(ConnectionMessages.NotAHost(host));
            Host = host;
            SyncPort = SettingRange.RequireCount(syncPort, 1, IPEndPoint.MaxPort, "sync port");
            WebSocketPort = SettingRange.RequireCount(webSocketPort, 1, IPEndPoint.MaxPort, "WebSocket port");
            Pin = pin;
            Security = pin != null ? TransportSecurity.Pinned : deviceTrust ? TransportSecurity.DeviceTrust : TransportSecurity.Plain;
            Token = RequireToken(token);
            HeadsetName = RequireName(headsetName);
            PublishesDisplayed = publishesDisplayed;
            ClockSource = RequireSource(clockSource);
            if (Security == TransportSecurity.Plain && !IsLoopback) RequirePlainIsWanted(insecureLan);
        }

        public string Host { get; }
        public int SyncPort { get; }
        public int WebSocketPort { get; }
        internal TransportSecurity Security { get; }

        /// <summary>The gateway's public key; null if the certificate is not pinned.</summary>
        public CertificatePin Pin { get; }

        /// <summary>The headset's token; null if it has none. Never shown or logged.</summary>
        public string Token { get; }

        public string HeadsetName { get; }
        public ControlClockSource ClockSource { get; }

        /// <summary>Whether the displayed joints are published, up to 20 times a second.</summary>
        public bool PublishesDisplayed { get; }

        /// <summary>Whether the gateway runs on this machine.</summary>
        public bool IsLoopback => IsLoopbackHost(Host);

        /// <summary>Address of the WebSocket that carries the joint positions: ws:// or wss://.</summary>
        public Uri WebSocketUri =>
            new UriBuilder(Security == TransportSecurity.Plain ? "ws" : "wss", Host, WebSocketPort).Uri;

        internal static bool IsLoopbackHost(string host) =>
            host == "localhost" || (IPAddress.TryParse(host, out var address) && IPAddress.IsLoopback(address));

        void RequirePlainIsWanted(bool insecureLan)
        {
            if (Token != null)
                throw new InputException(ConnectionMessages.TokenUnencrypted(Host));
            if (!insecureLan)
                throw new InputException(ConnectionMessages.PlainNotAllowed(Host));
        }

        static string RequireName(string name)
        {
            if (string.IsNullOrWhiteSpace(name) || name.Length > ProtocolLimits.NameLength)
                throw new InputException(ConnectionMessages.HeadsetName(name?.Length ?? 0, ProtocolLimits.NameLength));
            return name;
        }

        static ControlClockSource RequireSource(ControlClockSource source)
        {
            if (source != ControlClockSource.ClockSync && source != ControlClockSource.RosTime)
                throw new InputException(ConnectionMessages.UnknownClockSource((int)source));
            return source;
        }

        static string RequireToken(string token)
        {
            if (token == null) return null;
            SyncToken.RequireLength(token);
            foreach (var c in token)
                if (c <= ' ' || c > '~')
                    throw new InputException(ConnectionMessages.TokenCharacter);
            return token;
        }
    }
}
