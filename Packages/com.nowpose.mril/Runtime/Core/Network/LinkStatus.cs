using System;

namespace Nowpose.Network
{
    /// <summary>State of a connection.</summary>
    public enum LinkState
    {
        /// <summary>No connection is requested.</summary>
        Idle,

        Connecting,

        /// <summary>The connection is open, and the other side has responded.</summary>
        Connected,

        /// <summary>The connection failed or was lost; it is retried automatically.</summary>
        Waiting,
    }

    /// <summary>State of a connection with its reason. Immutable.</summary>
    public sealed class LinkStatus
    {
        public static readonly LinkStatus Idle = new LinkStatus(LinkState.Idle, "not connected");
        public static readonly LinkStatus Connecting = new LinkStatus(LinkState.Connecting, "connecting");
        public static readonly LinkStatus Connected = new LinkStatus(LinkState.Connected, "connected");

        LinkStatus(LinkState state, string detail, bool isTokenRefused = false, string warning = null) =>
            (State, Detail, IsTokenRefused, Warning) = (state, detail, isTokenRefused, warning);

        public LinkState State { get; }

        /// <summary>One line for the user; while waiting, the reason for the failure.</summary>
        public string Detail { get; }

        /// <summary>Whether the connection waits because the gateway rejects the headset's token, or the headset has no token.</summary>
        public bool IsTokenRefused { get; }

        /// <summary>
        /// Error that the gateway has reported over the open connection, in one line, for example that another headset uses this headset's name;
        /// null if there is none.
        /// </summary>
        public string Warning { get; }

        internal static LinkStatus ConnectedWith(string warning) => new LinkStatus(LinkState.Connected, "connected; " + warning, warning: warning);

        public static LinkStatus Waiting(string reason) => new LinkStatus(LinkState.Waiting, reason);

        /// <param name="what">Name of the connection.</param>
        /// <param name="failure">The failure. An AggregateException, which tasks and Mono's TLS streams throw, is unwrapped.</param>
        internal static LinkStatus Waiting(string what, Exception failure)
        {
            var cause = failure is AggregateException ? failure.GetBaseException() : failure;
            return new LinkStatus(LinkState.Waiting, what + ": " + cause.Message, cause is GatewayRefusalException { IsOfToken: true });
        }

        public override string ToString() => State + ": " + Detail;
    }
}
