namespace Nowpose.Network
{
    /// <summary>Where a connection stands, and why. Immutable.</summary>
    public sealed class LinkStatus
    {
        public static readonly LinkStatus Idle = new LinkStatus(LinkState.Idle, "not connected");
        public static readonly LinkStatus Connecting = new LinkStatus(LinkState.Connecting, "connecting");
        public static readonly LinkStatus Connected = new LinkStatus(LinkState.Connected, "connected");

        LinkStatus(LinkState state, string detail)
        {
            State = state;
            Detail = detail;
        }

        public LinkState State { get; }

        /// <summary>One line for the user: while waiting, what went wrong.</summary>
        public string Detail { get; }

        public static LinkStatus Waiting(string reason) => new LinkStatus(LinkState.Waiting, reason);

        public override string ToString() => State + ": " + Detail;
    }
}
