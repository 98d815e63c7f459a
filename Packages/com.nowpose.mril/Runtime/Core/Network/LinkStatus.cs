using System;

namespace Nowpose.Network
{
    /// <summary>Where a connection stands, and why. Immutable.</summary>
    public sealed class LinkStatus
    {
        public static readonly LinkStatus Idle = new LinkStatus(LinkState.Idle, "not connected");
        public static readonly LinkStatus Connecting = new LinkStatus(LinkState.Connecting, "connecting");
        public static readonly LinkStatus Connected = new LinkStatus(LinkState.Connected, "connected");

        LinkStatus(LinkState state, string detail, bool isTokenRefused = false)
        {
            State = state;
            Detail = detail;
            IsTokenRefused = isTokenRefused;
        }

        public LinkState State { get; }

        /// <summary>One line for the user: while waiting, what went wrong.</summary>
        public string Detail { get; }

        /// <summary>Whether it waits because the gateway does not accept the headset's token, or because there is none.</summary>
        public bool IsTokenRefused { get; }

        public static LinkStatus Waiting(string reason) => new LinkStatus(LinkState.Waiting, reason);

        /// <param name="what">Which connection.</param>
        /// <param name="failure">Tasks that were waited for wrap it, as Mono's TLS streams do.</param>
        internal static LinkStatus Waiting(string what, Exception failure)
        {
            var cause = failure is AggregateException ? failure.GetBaseException() : failure;
            return new LinkStatus(LinkState.Waiting, what + ": " + cause.Message, cause is GatewayRefusalException { IsOfToken: true });
        }

        public override string ToString() => State + ": " + Detail;
    }
}
